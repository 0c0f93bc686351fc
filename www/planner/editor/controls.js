/**
 * The editor's controls: tools, undo and redo, the coordinates of the selection, and keys. The editor is on while its
 * fold is open. Where the panel is below the stage, the tools are above the stage.
 */
import { Editor } from "./editor.js";
import { byId, make, reveal, write } from "../../app/dom.js";
import { json, save } from "../../app/files.js";
import { button, press } from "../../widgets/elements.js";
import { Field } from "../../widgets/field.js";

/** @import { App } from "../../app/app.js" */
/** @import { Session } from "./editor.js" */
/** @import { EditTool, ScenarioDocument, Settings } from "../../domain/types.js" */
/** @typedef {{ scene?: string, options?: Settings, document?: object, pace?: number }} Scene   a part of the page's state */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {Session} session
 * @property {boolean} calm   with reduced motion
 * @property {Scene} record
 * @property {{ name: string, document: ScenarioDocument } | null} facts
 * @property {{ pace?: number } | null} entry   the built-in scene
 * @property {(patch: Scene) => void} change
 * @property {(action: () => void) => void} act
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: { isEditing: boolean }) => void) => void} onState
 */
/** @typedef {(editor: Editor, event?: KeyboardEvent) => unknown} Command */

/** @type {[EditTool, string][]} */
const TOOLS = [
  ["select", "Select"],
  ["disc", "Disc"],
  ["rectangle", "Rectangle"],
  ["polygon", "Polygon"],
];

/** @type {Record<string, Command>} */
const COMMANDS = {
  previous: (editor) => editor.pick(-1),
  next: (editor) => editor.pick(1),
  insert: (editor) => editor.insert(),
  remove: (editor) => editor.remove(),
  duplicate: (editor) => editor.duplicate(),
  undo: (editor) => editor.go(-1),
  redo: (editor) => editor.go(1),
};

/** Moves the selection, with Shift ten times as far. @param {number} dx @param {number} dy @returns {Command} */
const arrow = (dx, dy) => (editor, event) => {
  const factor = event?.shiftKey ? 10 : 1;
  editor.nudge(factor * dx, factor * dy, event?.repeat ?? false);
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
  Enter: (editor) => editor.enter(),
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

export class EditorControls {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.editor = page.session.editor = new Editor(page.session);
    this.fold = byId("editor-fold", HTMLDetailsElement);
    this.host = byId("editor", HTMLElement);
    this.stage = byId("stage", HTMLElement);
    this.narrow = matchMedia("(max-width: 63.99rem)");
    /** The scene as it was opened. @type {Scene} */
    this.original = {};
    /** Its iterations a second. @type {number | undefined} */
    this.pace = undefined;
    this.changes = 0;
    this.message = "";
    /** The objects that the fields are for. */
    this.shape = "";
    /** @type {Field[]} */
    this.inputs = [];
    /** The coordinates last written into the fields. @type {Editor["fields"]} */
    this.shown = [];
    this.refused = "";
    this.tools = TOOLS.map(([tool, text]) => this.button(text, (editor) => editor.use(tool)));
    this.undo = this.button("Undo", COMMANDS.undo, "Control+Z");
    this.redo = this.button("Redo", COMMANDS.redo, "Control+Shift+Z");
    this.duplicate = this.button("Duplicate", COMMANDS.duplicate, "D");
    this.remove = this.button("Delete", COMMANDS.remove, "Delete");
    this.bar = make(
      "div",
      { className: "tools-bar", id: "edit-tools", role: "toolbar", ariaLabel: "Editing" },
      make("div", { className: "segments" }, ...this.tools),
      this.undo,
      this.redo,
      this.duplicate,
      this.remove,
    );
    this.title = make("p", { className: "title" });
    this.previous = this.button("Previous", COMMANDS.previous, "PageUp");
    this.next = this.button("Next", COMMANDS.next, "PageDown");
    this.insert = this.button("Add vertex", COMMANDS.insert, "Insert");
    this.retarget = this.button("", (editor) => editor.retarget());
    this.retarget.id = "edit-retarget";
    this.parts = make("div", { className: "parts" }, this.previous, this.next, this.insert, this.retarget);
    this.fields = make("div", {});
    this.reason = make("p", { className: "reason", id: "edit-reason", hidden: true });
    const saveButton = button("edit-save", "Save JSON", () => {
      const { facts } = page;
      if (facts) save(json(facts.document), `${facts.name}.json`);
    });
    this.revert = this.button("Revert", (editor) => editor.revert());
    this.revert.title = "Restores the scene as opened; Undo restores your edits.";
    const keys = make(
      "details",
      {},
      make("summary", {}, "Editing keys"),
      make(
        "p",
        { className: "hint" },
        "On the stage: [ and ] select an object; Page Up and Page Down select a vertex, a joint or the tip of an arm; arrows move it (with Shift ten times as far); " +
          "Insert adds a vertex; Delete deletes; D duplicates; Enter places the shape or closes the polygon; Escape cancels; " +
          "Ctrl+Z undoes; Ctrl+Shift+Z redoes. Dragging with Shift snaps to a grid and to multiples of 15 degrees.",
      ),
    );
    this.host.append(
      this.bar,
      this.title,
      this.parts,
      this.fields,
      this.reason,
      make("div", { className: "parts" }, saveButton, this.revert),
      keys,
    );
    this.fold.addEventListener("toggle", () => this.turn());
    this.narrow.addEventListener("change", () => this.place());
    // Posing the robot by hand takes the pointer.
    byId("your-turn", HTMLButtonElement).addEventListener("click", () => {
      this.fold.open = false;
    });
    for (const element of [this.stage, this.bar]) element.addEventListener("keydown", (event) => this.key(event));
    page.onOpen(() => {
      const { scene, options, document, pace } = page.record;
      this.original = { scene, options, document, pace };
      this.pace = page.entry?.pace ?? pace;
    });
    page.onState(({ isEditing }) => {
      if (isEditing) this.show(this.editor);
    });
    if (this.fold.open) this.turn();
  }

  /** Opens the editor and scrolls to it, or closes it. */
  toggle() {
    if (this.fold.open) {
      this.fold.open = false;
      return;
    }
    reveal(this.fold);
    this.place();
    (this.narrow.matches ? byId("story", HTMLElement) : this.fold).scrollIntoView({
      block: "start",
      behavior: this.page.calm ? "auto" : "smooth",
    });
  }

  /** @param {Command} command @param {KeyboardEvent} [event] */
  act(command, event) {
    this.page.act(() => command(this.editor, event));
  }

  /** @param {string} text @param {Command} command @param {string} [key] */
  button(text, command, key) {
    return make("button", { type: "button", ariaKeyShortcuts: key ?? null, onclick: () => this.act(command) }, text);
  }

  /** Switches the editor on or off with its fold. */
  turn() {
    const on = this.fold.open;
    this.act((editor) => editor.turn(on));
    this.stage.classList.toggle("editing", on);
    press(byId("edit", HTMLElement), on);
    this.place();
  }

  /** Moves the tools above the stage or into the panel. */
  place() {
    if (this.fold.open && this.narrow.matches) this.stage.before(this.bar);
    else this.host.prepend(this.bar);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (!this.fold.open || event.altKey || (event.key === "Enter" && event.target instanceof HTMLButtonElement)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const command = KEYS[event.ctrlKey || event.metaKey ? `Control+${event.shiftKey ? "Shift+" : ""}${key}` : key];
    if (!command) return;
    event.preventDefault();
    this.act(command, event);
  }

  /** @param {Editor} editor */
  show(editor) {
    const { tool, kind, title, parts, announcement, reason, touching, goal, changes, refusal } = editor;
    const { undoable, redoable } = editor.history;
    const { isBusy } = editor.hand;
    Object.assign(this.host.dataset, {
      tool,
      kind,
      title,
      code: refusal?.code ?? "",
      touching,
      undo: undoable,
      redo: redoable,
      changes,
      busy: isBusy,
    });
    this.stage.dataset.tool = tool;
    this.tools.forEach((element, i) => press(element, TOOLS[i][0] === tool));
    this.undo.disabled = undoable === 0;
    this.redo.disabled = redoable === 0;
    this.duplicate.disabled = kind === "" || kind === "end";
    this.remove.disabled = this.duplicate.disabled && !isBusy;
    this.revert.disabled = !editor.isChanged;
    write(this.title, title || "Nothing is selected.");
    this.parts.hidden = parts === 0 && goal === "";
    this.previous.hidden = this.next.hidden = parts === 0;
    this.retarget.hidden = goal === "";
    write(this.retarget, goal === "target" ? "Fix the configuration" : "Allow any configuration");
    this.insert.hidden = kind !== "polygon";
    write(this.reason, reason || touching);
    this.reason.hidden = reason === "" && touching === "";
    this.showFields(editor);
    const message = reason || (touching ? `${announcement} ${touching}` : announcement);
    if (message !== this.message && !isBusy) {
      this.message = message;
      this.page.app.announcer.say(message);
    }
    if (changes !== this.changes) {
      this.changes = changes;
      this.adopt(editor.isChanged);
    }
  }

  /** Shows the coordinates of the selection. @param {Editor} editor */
  showFields({ title, kind, part, fields, reason }) {
    const shape = `${kind} ${title} ${fields.length}`;
    if (shape !== this.shape) {
      this.shape = shape;
      this.shown = fields;
      this.inputs = fields.map(
        ({ name, unit, low, high, value }, i) =>
          new Field(
            {
              name: name.replace(" ", "-"),
              title: `${kind === "polygon" ? `vertex ${part ?? 0}, ` : ""}${name}`,
              unit,
              kind: "number",
              min: low,
              max: high,
              default: value,
              choices: null,
              robots: [],
              meaning: "",
            },
            value,
            () => this.enter(i),
            "edit",
            false,
          ),
      );
      for (const { control } of this.inputs)
        control.setAttribute("aria-describedby", `${control.getAttribute("aria-describedby")} edit-reason`);
      this.fields.replaceChildren(...this.inputs.map(({ element }) => element));
    }
    const isResolved = this.refused !== "" && reason === "";
    this.refused = reason;
    fields.forEach(({ value }, i) => {
      // Text being typed stays until the number itself changes.
      if (isResolved || value !== this.shown[i].value) this.inputs[i].set(value);
    });
    this.shown = fields;
  }

  /** Applies a typed number. @param {number} index */
  enter(index) {
    const { value, control } = this.inputs[index];
    this.act((editor) => editor.set(index, Number(value)));
    if (this.editor.refusal) control.ariaInvalid = "true";
  }

  /** Makes the edited scenario the page's, or restores the one that was opened. @param {boolean} isChanged */
  adopt(isChanged) {
    const { page, original, pace } = this;
    const { document } = this.editor;
    page.change(isChanged ? { scene: undefined, options: undefined, document: { ...document }, pace } : original);
    this.original = original;
  }
}
