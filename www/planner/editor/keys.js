/** Keys of the editor on the stage, and the commands that buttons share with them. */
import { cutOrFill, duplicate, enter, insert, nudge, remove } from "./commands.js";

/** @import { Editor } from "./editor.js" */
/** @typedef {(editor: Editor, event?: KeyboardEvent) => unknown} Command */

/** @satisfies {Record<string, Command>} */
export const COMMANDS = {
  previous: (/** @type {Editor} */ editor) => editor.pick(-1),
  next: (/** @type {Editor} */ editor) => editor.pick(1),
  insert,
  remove,
  duplicate,
  hole: cutOrFill,
  undo: (/** @type {Editor} */ editor) => editor.go(-1),
  redo: (/** @type {Editor} */ editor) => editor.go(1),
};

/** Moves the selection, with Shift ten times as far. @param {number} dx @param {number} dy @returns {Command} */
const arrow = (dx, dy) => (editor, event) => {
  const factor = event?.shiftKey ? 10 : 1;
  nudge(editor, factor * dx, factor * dy, event?.repeat ?? false);
};

/** @type {Partial<Record<string, Command>>} */
const KEYS = {
  "[": (editor) => editor.select(-1),
  "]": (editor) => editor.select(1),
  PageUp: COMMANDS.previous,
  PageDown: COMMANDS.next,
  Delete: COMMANDS.remove,
  Backspace: COMMANDS.remove,
  Insert: COMMANDS.insert,
  d: COMMANDS.duplicate,
  h: COMMANDS.hole,
  Enter: enter,
  Escape: (editor) => editor.cancel(),
  ArrowLeft: arrow(-1, 0),
  ArrowRight: arrow(1, 0),
  ArrowUp: arrow(0, 1),
  ArrowDown: arrow(0, -1),
  "Control+z": COMMANDS.undo,
  "Control+Shift+z": COMMANDS.redo,
  "Control+y": COMMANDS.redo,
  "Control+Shift+y": COMMANDS.redo,
};

/** What the keys do, in words. */
export const HELP =
  "On the stage: [ and ] select an object; Page Up and Page Down select a vertex, an edge of the bounds, a joint or the tip of an arm; arrows move it (with Shift ten times as far); " +
  "Insert adds a vertex; Delete deletes; D duplicates; H cuts a polygon out of the one around it, or fills the selected hole; Enter places the shape, closes the polygon or ends the wall; Escape cancels; " +
  "Ctrl+Z undoes; Ctrl+Shift+Z redoes. Dragging with Shift snaps to a grid and to multiples of 15 degrees.";

/** The command of a key, if it has one. @param {KeyboardEvent} event */
export function commandOf({ key, altKey, ctrlKey, metaKey, shiftKey, target }) {
  if (altKey || (key === "Enter" && target instanceof HTMLButtonElement)) return undefined;
  const name = key.length === 1 ? key.toLowerCase() : key;
  return KEYS[ctrlKey || metaKey ? `Control+${shiftKey ? "Shift+" : ""}${name}` : name];
}
