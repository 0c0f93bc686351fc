/**
 * A room's worker: it alone holds the WebAssembly, so that the page never waits for it. It obeys messages `{ id, command, args }`
 * and answers each with `{ id, value }` or `{ id, fault }`.
 */
import * as library from "planarium";
import { faultOf } from "../app/fault.js";

/** @typedef {Record<string, (...args: any[]) => unknown>} Commands */

/** Hands a value over with the memory that it need not keep. @typedef {{ value: unknown, transfer: Transferable[] }} Handed */

const port = /** @type {{ postMessage(message: unknown, transfer?: Transferable[]): void }} */ (/** @type {unknown} */ (self));

/** Marks what is transferred, not copied. */
const HANDED = Symbol("handed");

/** @template T @param {T} value @param {Transferable[]} transfer @returns {T} */
export function handed(value, transfer) { return /** @type {T} */ (/** @type {unknown} */ ({ [HANDED]: true, value, transfer })); }

/**
 * Obeys. The command `start`, which takes the compiled WebAssembly, is there by itself and comes first.
 * @param {Commands} commands
 * @param {() => void} [recover]   the core was lost to a fault of its own and is a fresh one: what was made by it is dead
 */
export function serve(commands, recover = () => {}) {
  const start = async (/** @type {WebAssembly.Module} */ core) => {
    await library.default(core);
    return { version: library.version };
  };
  addEventListener("message", async ({ data: { id, command, args } }) => {
    try {
      const answer = await (command === "start" ? start(args[0]) : commands[command](...args));
      const isHanded = typeof answer === "object" && answer !== null && HANDED in answer;
      const { value, transfer } = isHanded ? /** @type {Handed} */ (/** @type {unknown} */ (answer)) : { value: answer, transfer: [] };
      port.postMessage({ id, value }, transfer);
    } catch (error) {
      const fault = faultOf(error);
      if (fault.code === "internal") {
        await library.default();
        recover();
      }
      port.postMessage({ id, fault });
    }
  });
}
