/**
 * The editor in the panel: tools, undo and redo, the numbers of what is selected, and the keys of the stage. Opening its fold
 * switches it on. Where the panel stands below the stage, the tools go up to it.
 */
import { documentText } from "../../formats/document.js";
import { editorOf } from "./editor.js";
import { Announcer } from "../../app/announcer.js";
import { byId, make, write } from "../../app/dom.js";

/** @import { Page } from "../page.js" */
/** @import { EditOrder, EditState, EditTool, SceneEntry, Source } from "../../domain/types.js" */

/** @type {[EditTool, string][]} */
const TOOLS = [["select", "Select"], ["disc", "Disc"], ["rectangle", "Rectangle"], ["polygon", "Polygon"]];

/** @type {Record<string, EditOrder>} */
const KEYS = {
  "[": ["select", -1], "]": ["select", 1], PageUp: ["pick", -1], PageDown: ["pick", 1],
  Delete: ["remove"], Backspace: ["remove"], Insert: ["insert"], d: ["duplicate"], Enter: ["enter"], Escape: ["cancel"],
};

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class EditorControls {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.fold = byId("editor-fold", HTMLDetailsElement);
    this.host = byId("editor", HTMLElement);
    this.stage = byId("stage", HTMLElement);
    this.announcer = new Announcer();
    this.narrow = matchMedia("(max-width: 63.99rem)");
    /** The scene as it was opened. @type {{ source: Source | null, entry: SceneEntry | null }} */
    this.original = { source: null, entry: null };
    this.adopting = false;
    this.changes = 0;
    this.told = "";
    /** Of which things the fields are. */
    this.shape = "";
    /** @type {HTMLInputElement[]} */
    this.inputs = [];
    /** The numbers in them as they were told, and how far they may go. @type {number[]} */
    this.shown = [];
    /** @type {[number, number][]} */
    this.limits = [];
    this.refused = "";
    this.tools = TOOLS.map(([tool, text]) => this.button(text, ["use", tool]));
    this.undo = this.button("Undo", ["go", -1], "Control+Z");
    this.redo = this.button("Redo", ["go", 1], "Control+Shift+Z");
    this.duplicate = this.button("Duplicate", ["duplicate"], "D");
    this.remove = this.button("Delete", ["remove"], "Delete");
    this.bar = make("div", { className: "tools-bar", id: "edit-tools", role: "toolbar", ariaLabel: "Editing" },
      make("div", { className: "segments" }, ...this.tools), this.undo, this.redo, this.duplicate, this.remove);
    this.title = make("p", { className: "title" });
    this.previous = this.button("Previous", ["pick", -1], "PageUp");
    this.next = this.button("Next", ["pick", 1], "PageDown");
    this.insert = this.button("Add vertex", ["insert"], "Insert");
    this.retarget = this.button("", ["retarget"]);
    this.retarget.id = "edit-retarget";
    this.parts = make("div", { className: "parts" }, this.previous, this.next, this.insert, this.retarget);
    this.fields = make("div", {});
    this.reason = make("p", { className: "reason", id: "edit-reason", hidden: true });
    const save = make("button", { type: "button", id: "edit-save" }, "Save JSON");
    save.addEventListener("click", () => this.save());
    this.revert = this.button("Revert", ["revert"]);
    this.revert.title = "Restores the scene as opened; Undo restores your edits.";
    const keys = make("details", {}, make("summary", {}, "Editing keys"), make("p", { className: "hint" },
      "On the stage: [ and ] select an object; Page Up and Page Down select a vertex, a joint or the tip of an arm; arrows move it (with Shift ten times as far); "
      + "Insert adds a vertex; Delete deletes; D duplicates; Enter places the shape or closes the polygon; Escape cancels; "
      + "Ctrl+Z undoes; Ctrl+Shift+Z redoes. Dragging with Shift snaps to a grid and to multiples of 15 degrees."));
    this.host.append(this.bar, this.title, this.parts, this.fields, this.reason, make("div", { className: "parts" }, save, this.revert), keys);
    this.fold.addEventListener("toggle", () => this.turn());
    this.narrow.addEventListener("change", () => this.place());
    // The robot in the hand wants the pointer for itself.
    byId("your-turn", HTMLButtonElement).addEventListener("click", () => { this.fold.open = false; });
    for (const element of [this.stage, this.bar]) element.addEventListener("keydown", (event) => this.key(event));
    page.onOpen(() => {
      if (!this.adopting) this.original = { source: page.source, entry: page.entry };
    });
    page.onState(({ edit }) => { if (edit) this.show(edit); });
    this.original = { source: page.source, entry: page.entry };
    if (this.fold.open) this.turn();
  }

  /** Opens the editor and goes there. */
  begin() {
    this.fold.open = true;
    this.place();
    (this.narrow.matches ? byId("story", HTMLElement) : this.fold).scrollIntoView({ block: "start", behavior: this.page.calm ? "auto" : "smooth" });
  }

  /** @param {EditOrder} order */
  order(...order) { this.page.act((session) => editorOf(session).obey(order)); }

  /** @param {string} text @param {EditOrder} order @param {string} [key] */
  button(text, order, key) {
    const button = make("button", { type: "button" }, text);
    if (key) button.setAttribute("aria-keyshortcuts", key);
    button.addEventListener("click", () => this.order(...order));
    return button;
  }

  /** The fold was opened or closed. */
  turn() {
    const on = this.fold.open;
    this.order("turn", on);
    this.stage.classList.toggle("editing", on);
    this.place();
  }

  /** The tools go where the hand is. */
  place() {
    if (this.fold.open && this.narrow.matches) this.stage.before(this.bar);
    else this.host.prepend(this.bar);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (!this.fold.open || event.altKey || (event.key === "Enter" && event.target instanceof HTMLButtonElement)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const arrow = ARROWS[key];
    /** @type {EditOrder | undefined} */
    let order = KEYS[key];
    if (event.ctrlKey || event.metaKey) order = key === "z" ? ["go", event.shiftKey ? 1 : -1] : key === "y" ? ["go", 1] : undefined;
    else if (arrow) order = ["nudge", arrow[0] * (event.shiftKey ? 10 : 1), arrow[1] * (event.shiftKey ? 10 : 1), event.repeat];
    if (!order) return;
    event.preventDefault();
    this.order(...order);
  }

  /** @param {EditState} edit */
  show(edit) {
    const { tool, kind, title, parts, said, reason, code, touching, undoable, redoable } = edit;
    Object.assign(this.host.dataset, { tool, kind, title, code, touching, undo: String(undoable), redo: String(redoable), changes: String(edit.changes), busy: String(edit.isBusy) });
    this.stage.dataset.tool = tool;
    this.tools.forEach((button, i) => button.setAttribute("aria-pressed", String(TOOLS[i][0] === tool)));
    this.undo.disabled = undoable === 0;
    this.redo.disabled = redoable === 0;
    this.duplicate.disabled = kind === "" || kind === "end";
    this.remove.disabled = this.duplicate.disabled && !edit.isBusy;
    this.revert.disabled = !edit.isChanged;
    write(this.title, title || "Nothing is selected.");
    this.parts.hidden = parts === 0 && edit.goal === "";
    this.previous.hidden = this.next.hidden = parts === 0;
    this.retarget.hidden = edit.goal === "";
    write(this.retarget, edit.goal === "target" ? "Fix the configuration" : "Allow any configuration");
    this.insert.hidden = kind !== "polygon";
    write(this.reason, reason || touching);
    this.reason.hidden = reason === "" && touching === "";
    this.showFields(edit);
    const telling = reason || (touching ? `${said} ${touching}` : said);
    if (telling !== this.told && !edit.isBusy) {
      this.told = telling;
      this.announcer.say(telling);
    }
    if (edit.changes !== this.changes) {
      this.changes = edit.changes;
      void this.adopt(edit.isChanged);
    }
  }

  /** The numbers of what is selected. @param {EditState} edit */
  showFields({ title, kind, part, fields, reason }) {
    const shape = `${kind} ${title} ${fields.length}`;
    if (shape !== this.shape) {
      this.shape = shape;
      this.fields.replaceChildren();
      this.inputs = fields.map(({ name, unit }, i) => {
        const input = make("input", { type: "number", step: "any", id: `edit-${name.replace(" ", "-")}`, autocomplete: "off", inputMode: "decimal" });
        input.setAttribute("aria-describedby", "edit-reason");
        input.addEventListener("change", () => this.give(i));
        const label = `${kind === "polygon" ? `vertex ${part ?? 0}, ` : ""}${name}`;
        this.fields.append(make("label", { className: "row" }, make("span", { className: "name" }, label, make("span", { className: "unit" }, ` ${unit}`)), input));
        return input;
      });
      this.shown = [];
    }
    const mended = this.refused !== "" && reason === "";
    this.refused = reason;
    fields.forEach(({ value, low, high }, i) => {
      this.limits[i] = [low, high];
      // What is being typed stays, until the number itself is another.
      if (value === this.shown[i] && !mended) return;
      this.shown[i] = value;
      this.inputs[i].value = String(value);
      this.inputs[i].removeAttribute("aria-invalid");
    });
  }

  /** A number was typed. @param {number} index */
  give(index) {
    const input = this.inputs[index];
    const [low, high] = this.limits[index];
    const value = Number(input.value);
    const good = input.value.trim() !== "" && value >= low && value <= high;
    // It is wrong until the core has taken it.
    input.setAttribute("aria-invalid", "true");
    if (good && value !== this.shown[index]) this.order("set", index, value);
    else if (good) input.removeAttribute("aria-invalid");
  }

  /** The scenario on the stage is the reader's own now, or again the one that was opened. @param {boolean} isChanged */
  adopt(isChanged) {
    const { page, original } = this;
    const facts = page.session.facts();
    page.source = isChanged ? { document: facts.document } : original.source;
    page.entry = isChanged ? null : original.entry;
    page.notice.hide();
    this.adopting = true;
    page.show(facts);
    this.adopting = false;
  }

  /** Hands the scenario over as a file. */
  save() {
    const { facts } = this.page;
    if (!facts) return;
    const href = URL.createObjectURL(new Blob([documentText(facts.document)], { type: "application/json" }));
    make("a", { href, download: `${facts.name.replace(/[^\w.-]+/g, "-")}.json` }).click();
    setTimeout(() => URL.revokeObjectURL(href), 60_000);
  }
}
