/** The door of a room, which is loaded with the first world. */
import { once } from "../app/once.js";
import { loadStyle } from "../app/site.js";

/** @import { App } from "../app/app.js" */
/** @import { Content } from "../app/read-files.js" */
/** @import { OpenedWorld } from "./door.js" */

/**
 * @param {App} app
 * @param {(world: OpenedWorld) => Promise<unknown>} onUse   throws what the room refuses
 * @returns {(files: Content[]) => Promise<void>}   opens files, or adds them to those in the panel
 */
export function roomDoor(app, onUse) {
  const door = once(async () => {
    const [{ Door }] = await Promise.all([import("./door.js"), loadStyle()]);
    return new Door(app, onUse);
  });
  return async (files) => (await door()).take(files);
}
