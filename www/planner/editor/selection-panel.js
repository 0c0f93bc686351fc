/** The panel of the selection: its name, its parts, its coordinates as fields, and why a change was refused. */
import { make, write } from "../../app/dom.js";
import { row, toggle } from "../../widgets/elements.js";
import { closeWall, retarget, set } from "./commands.js";
import { editField } from "./edit-field.js";
import { COMMANDS } from "./keys.js";
import { goalOf, holeOf, kindOf } from "./offers.js";
import { partText } from "./parts.js";
import { fieldsOf, titleOf } from "./words.js";

/** @import { Field } from "../../widgets/field.js" */
/** @import { Editor } from "./editor.js" */
/** @import { Command } from "./keys.js" */

export class SelectionPanel {
  /**
   * @param {Editor} editor
   * @param {(command: Command) => void} act
   * @param {(text: string, command: Command, key?: string) => HTMLButtonElement} button
   */
  constructor(editor, act, button) {
    this.editor = editor;
    this.act = act;
    this.title = make("p", { className: "title" });
    this.previous = button("Previous", COMMANDS.previous, "PageUp");
    this.next = button("Next", COMMANDS.next, "PageDown");
    this.insert = button("Add vertex", COMMANDS.insert, "Insert");
    this.retarget = button("", retarget);
    this.retarget.id = "edit-retarget";
    this.hole = button("", COMMANDS.hole, "H");
    this.hole.id = "edit-hole";
    this.parts = make("div", { className: "parts" }, this.previous, this.next, this.insert, this.hole, this.retarget);
    this.fields = make("div", {});
    this.isClosed = toggle("edit-closed", (isOn) => act((editor) => closeWall(editor, isOn)));
    this.closed = row("closed", this.isClosed);
    this.reason = make("p", { className: "reason", id: "edit-reason", hidden: true });
    this.elements = [this.title, this.parts, this.fields, this.closed, this.reason];
    /** The objects that the fields are for. */
    this.shape = "";
    /** @type {Field[]} */
    this.inputs = [];
    /** The coordinates last written into the fields. @type {ReturnType<typeof fieldsOf>} */
    this.shown = [];
    this.refused = "";
  }

  /** @param {string} reason  why the last change was refused, or empty @param {string} touching */
  show(reason, touching) {
    const { editor } = this;
    const { parts, obstacle } = editor;
    const [kind, goal, hole] = [kindOf(editor), goalOf(editor), holeOf(editor)];
    write(this.title, titleOf(editor) || "Nothing is selected.");
    this.parts.hidden = parts === 0 && goal === "";
    this.previous.hidden = this.next.hidden = parts === 0;
    this.retarget.hidden = goal === "";
    write(this.retarget, goal === "target" ? "Fix the configuration" : "Allow any configuration");
    this.insert.hidden = kind !== "polygon" && kind !== "wall";
    write(this.insert, kind === "wall" ? "Add point" : "Add vertex");
    this.hole.hidden = hole === "";
    write(this.hole, hole === "fill" ? "Fill the hole" : "Cut as a hole");
    this.closed.hidden = obstacle?.type !== "wall";
    this.isClosed.checked = obstacle?.type === "wall" && obstacle.closed === true;
    write(this.reason, reason || touching);
    this.reason.hidden = reason === "" && touching === "";
    this.showFields(reason);
  }

  /** Shows the coordinates of the selection. @param {string} reason */
  showFields(reason) {
    const { editor } = this;
    const fields = fieldsOf(editor);
    const shape = `${kindOf(editor)} ${titleOf(editor)} ${fields.length}`;
    if (shape !== this.shape) {
      this.shape = shape;
      this.shown = fields;
      this.build(fields);
    }
    const isResolved = this.refused !== "" && reason === "";
    this.refused = reason;
    fields.forEach(({ value }, i) => {
      // Text being typed stays until the number itself changes.
      if (isResolved || value !== this.shown[i].value) this.inputs[i].set(value);
    });
    this.shown = fields;
  }

  /** Makes a field for each coordinate. @param {ReturnType<typeof fieldsOf>} fields */
  build(fields) {
    const { obstacle, part } = this.editor;
    const place = obstacle && obstacle.type !== "disc" ? `${partText(obstacle, part ?? 0)}, ` : "";
    this.inputs = fields.map(({ name, unit, low, high, value }, i) =>
      editField(
        {
          name: name.replace(" ", "-"),
          title: `${name === "width" ? "" : place}${name}`,
          unit,
          min: low,
          max: high,
        },
        value,
        () => this.enter(i),
      ),
    );
    for (const { control } of this.inputs)
      control.setAttribute("aria-describedby", `${control.getAttribute("aria-describedby")} edit-reason`);
    this.fields.replaceChildren(...this.inputs.map(({ element }) => element));
  }

  /** Applies a typed number. @param {number} index */
  enter(index) {
    const { value, control } = this.inputs[index];
    this.act((editor) => set(editor, index, Number(value)));
    if (this.editor.refusal) control.ariaInvalid = "true";
  }
}
