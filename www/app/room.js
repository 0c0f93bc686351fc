/**
 * A room: a page beside the planner's. It has an app and a worker; files that are opened or dropped, keys, the share
 * link and new seeds are wired here, and the room says what each of them does.
 */
import { randomSeed } from "planarium";
import { App } from "./app.js";
import { byId } from "./dom.js";
import { watchFiles } from "./drop.js";
import { kindOf, namesOf, readFiles } from "./read-files.js";
import { watchEscape } from "./escape.js";
import { watchKeys } from "./keys.js";
import { useLink } from "./link.js";
import { requireFormats } from "./site.js";
import { isAbort, latest } from "./work.js";

/** @import { Link, StateRule } from "./link.js" */
/** @import { Remote } from "./worker-client.js" */
/** @import { Content } from "./read-files.js" */

/**
 * Shows beside its field why a value is refused.
 * @typedef {(pointer: string, reason: string) => boolean} Refusal   whether there is such a field
 */

/**
 * @typedef {object} File
 * @property {string} name
 * @property {Uint8Array<ArrayBuffer>} bytes
 * @property {string} text   the bytes as text
 */

/**
 * What a room does.
 * @typedef {object} Parts
 * @property {() => void} [show]   the state, in a frame after it has changed; writes only what differs
 * @property {() => unknown} rebuild   the objects of the core, which has lost them
 * @property {StateRule} rule   of the state that a link stores
 * @property {Link} link
 * @property {(file: File) => unknown} [openFile]   throws what it refuses
 * @property {(files: Content[]) => Promise<unknown>} [openWorld]   of maps, pictures and drawings
 * @property {(seed: number) => unknown} [reseed]   begins with a new seed
 * @property {Record<string, () => void>} [keys]   on the stage
 */

/** New seeds are below this: short enough to say aloud. */
const SEEDS = 100_000;

class Room {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** Opens a scene, a file or a link; another one that is still loading is given up. */
    this.opening = latest(async (signal, /** @type {(signal: AbortSignal) => unknown} */ act) => await act(signal));
  }

  /**
   * Opens a scene or a file.
   * @param {(signal: AbortSignal) => unknown} act   the signal: another one is opened meanwhile
   * @param {string} [title]   of the error
   */
  open(act, title) {
    this.app.notice.hide();
    return this.app.track(this.opening(act), title);
  }

  /**
   * Does what may be refused: the reason is shown beside its field, or above the figure.
   * @template T
   * @param {() => T | Promise<T>} act
   * @param {Refusal} [onRefused]
   */
  attempt(act, onRefused = () => false) {
    const guarded = async () => {
      try {
        return await act();
      } catch (error) {
        const {
          code,
          pointer = "",
          message,
        } = /** @type {{ code?: string, pointer?: string, message: string }} */ (error);
        if (isAbort(error) || code === "internal" || !onRefused(pointer, message)) throw error;
        return undefined;
      }
    };
    return this.app.track(guarded());
  }
}

/** Where a file is opened that this page does not read. */
function elsewhere() {
  return Object.assign(
    new Error("This page reads documents in JSON. Maps, pictures and drawings are opened on the page Planners."),
    { code: "unknown-file" },
  );
}

/**
 * Opens a room.
 * @template C
 * @param {string} name   its worker runs the commands of this name
 * @param {(room: Room, worker: Remote<C>) => Parts} make
 */
export async function openRoom(name, make) {
  const app = new App();
  watchEscape();
  const room = new Room(app);
  await app.open(name, async (/** @type {Remote<C>} */ worker) => {
    const { show, rebuild, rule, link, openFile, openWorld, reseed, keys } = make(room, worker);
    if (show) app.onShow(show);
    app.rebuild = rebuild;
    if (keys) watchKeys([byId("stage", HTMLElement)], keys);
    if (openFile)
      watchFiles((files) => {
        void room.open(() => openAll(files), `${namesOf(files)} could not be opened.`);
      });

    /** @param {globalThis.File[]} files */
    async function openAll(files) {
      const contents = await readFiles(files);
      if (contents.some((content) => kindOf(content) === "world")) {
        if (!openWorld) throw elsewhere();
        requireFormats();
        await openWorld(contents);
        return;
      }
      for (const { name: file, bytes } of contents)
        await openFile?.({ name: file, bytes, text: new TextDecoder().decode(bytes) });
    }
    if (reseed) {
      const button = byId("new-seed", HTMLButtonElement);
      button.disabled = false;
      button.addEventListener("click", () => reseed(randomSeed() % SEEDS));
    }
    await app.track(useLink(app, rule, link, room.opening));
  });
}
