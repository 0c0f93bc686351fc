/**
 * The worker's end: it runs messages `{ id, room, command, args }` and replies to each with `{ id, value }` or `{ id,
 * fault }`. A message `{ id, isAborted }` takes back one that it has not begun.
 */
import * as library from "planarium";
import { errorInfo } from "./error-info.js";

/**
 * The commands of a room. Typed arrays and images in a result are transferred; a command returns copies of those that
 * it stores.
 * @typedef {Record<string, (...args: any[]) => unknown>} Commands
 */

const port = /** @type {{ postMessage(message: unknown, transfer?: Transferable[]): void }} */ (
  /** @type {unknown} */ (self)
);

/**
 * @param {Record<string, { commands: Commands, reset?: () => void }>} rooms   `reset` is called after a panic of the
 *   core, which loses everything in it
 */
export function serve(rooms) {
  /** @type {Promise<unknown>} */
  let started = Promise.resolve();
  /** Messages that have not begun. @type {{ id: number, room: string, command: string, args: any[] }[]} */
  let waiting = [];
  // A message begins after those that have come meanwhile were read: one of them may take it back.
  const { port1: begin, port2: next } = new MessageChannel();
  begin.onmessage = () => {
    const message = waiting.shift();
    if (message) void run(message);
  };
  addEventListener("message", ({ data }) => {
    if (data.isAborted) waiting = waiting.filter(({ id }) => id !== data.id);
    else {
      waiting.push(data);
      next.postMessage(null);
    }
  });

  /** @param {typeof waiting[number]} message */
  async function run({ id, room, command, args }) {
    const { commands, reset } = rooms[room];
    try {
      if (command === "start") started = library.default(args[0]);
      await started;
      const value = command === "start" ? null : await commands[command](...args);
      port.postMessage({ id, value }, [...buffersOf(value)]);
    } catch (error) {
      const fault = errorInfo(error);
      if (fault.code === "internal") {
        await library.default();
        reset?.();
      }
      port.postMessage({ id, fault });
    }
  }
}

/**
 * The memory of the typed arrays and pictures in a value.
 * @param {unknown} value
 * @param {Set<Transferable>} [buffers]
 * @returns {Set<Transferable>}
 */
function buffersOf(value, buffers = new Set()) {
  if (value instanceof ImageBitmap) buffers.add(value);
  else if (ArrayBuffer.isView(value)) buffers.add(/** @type {ArrayBuffer} */ (value.buffer));
  else if (typeof value === "object" && value) for (const entry of Object.values(value)) buffersOf(entry, buffers);
  return buffers;
}
