/** The panel of the robot: its type, its numbers, and its shape. */
import { make, write } from "../../app/dom.js";
import { jointsOf } from "../../domain/coordinates.js";
import { button, row, select } from "../../widgets/elements.js";
import { capital } from "../../widgets/format.js";
import { editField } from "./edit-field.js";
import { best } from "./offers.js";
import { entriesOf, withJointType } from "./robot-fields.js";
import { TYPES, boxed, shapedOf, withType } from "./robots.js";
import { ShapeFigure } from "./shape-figure.js";
import { sentence } from "./words.js";

/** @import { Field } from "../../widgets/field.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { Editor } from "./editor.js" */
/** @import { Robot, Shaped } from "./robots.js" */
/** @typedef {(action: (editor: Editor) => void) => void} Act */

export class RobotPanel {
  /** @param {Editor} editor @param {Act} act */
  constructor(editor, act) {
    this.editor = editor;
    this.act = act;
    this.type = select("robot-type", "Type of the robot", TYPES);
    this.type.addEventListener("change", () => this.retype(/** @type {Robot["type"]} */ (this.type.value)));
    this.text = make("p", { className: "hint", id: "robot-text", hidden: true });
    this.reason = make("p", { className: "reason", id: "robot-reason", hidden: true });
    this.fields = make("div", { id: "robot-fields" });
    this.figure = new ShapeFigure(editor, act);
    this.box = button("robot-box", "Rectangle", () =>
      this.change((robot) => ({ ...robot, shape: boxed(robot.shape) })),
    );
    this.shape = fold("Shape", this.figure.element);
    this.figure.buttons.append(this.box);
    this.element = make(
      "details",
      { id: "robot-fold" },
      make("summary", {}, "Robot"),
      row("Type", this.type),
      this.text,
      this.reason,
      this.fields,
      this.shape,
    );
    /** What the fields are for. */
    this.key = "";
    /** @type {Field[]} */
    this.inputs = [];
    /** The numbers last written into the fields. @type {(number | null)[]} */
    this.shown = [];
    /** The fields whose numbers were refused. @type {Set<number>} */
    this.refused = new Set();
    /** The robot that is shown. @type {Robot | null} */
    this.robot = null;
    this.element.addEventListener("toggle", () => this.show());
  }

  /** Shows the robot, if it is another one and the panel is open. */
  show() {
    const { robot } = this.editor.document;
    // What a closed panel has may be of an earlier robot: nothing can be typed there before it is shown again.
    this.fields.hidden = !this.element.open;
    if (!this.element.open || robot === this.robot) return;
    this.robot = robot;
    this.type.value = robot.type;
    const entries = entriesOf(robot, this.editor.unit);
    const key = entries.map(({ name }) => name).join();
    if (key !== this.key) this.build(entries);
    else
      entries.forEach(({ value }, i) => {
        // Text being typed stays until the number itself changes.
        const isPast = this.refused.has(i) && document.activeElement !== this.inputs[i].control;
        if (value !== this.shown[i] || isPast) this.inputs[i].set(value ?? "");
      });
    this.key = key;
    this.shown = entries.map(({ value }) => value);
    this.refused.clear();
    const shaped = shapedOf(robot);
    this.shape.hidden = !shaped;
    if (shaped) this.figure.show(shaped);
  }

  /** @param {ReturnType<typeof entriesOf>} entries */
  build(entries) {
    const groups = new Map(entries.map(({ group }) => [group, make("div", {})]));
    this.inputs = entries.map((entry, i) => {
      const { value, group, empty, set: _, ...info } = entry;
      const absent = empty === null ? {} : { default: null, default_meaning: empty };
      const field = editField({ ...info, ...absent }, value, () => this.enter(i));
      groups.get(group)?.append(field.element);
      return field;
    });
    const open = Array.from(this.fields.querySelectorAll("details"), (fold) => fold.open);
    const { activeElement } = document;
    const focused = this.fields.contains(activeElement) ? activeElement?.id : undefined;
    this.fields.replaceChildren(
      ...Array.from(groups, ([group, element]) => {
        const [, link] = /^Link (\d+)$/.exec(group) ?? [];
        if (link) element.prepend(this.jointRow(Number(link) - 1));
        return group === capital(group) ? fold(group, element) : element;
      }),
    );
    for (const [i, fold] of this.fields.querySelectorAll("details").entries()) fold.open = open[i] ?? false;
    if (focused) document.getElementById(focused)?.focus();
  }

  /** Whether a link turns or slides. @param {number} i */
  jointRow(i) {
    const robot = /** @type {Extract<Robot, { type: "arm" }>} */ (this.editor.document.robot);
    const kind = select(
      `edit-joint-${i + 1}-type`,
      `Link ${i + 1} turns or slides`,
      [
        ["revolute", "turns"],
        ["prismatic", "slides"],
      ],
      jointsOf(robot)[i].type,
    );
    kind.addEventListener("change", () =>
      this.act((editor) => {
        const { document, text } = withJointType(editor.shown, i, kind.value === "prismatic");
        this.finish(editor.change(document), text);
      }),
    );
    return row("Joint", kind);
  }

  /** Applies a typed number. @param {number} index */
  enter(index) {
    const field = this.inputs[index];
    const { value } = field;
    this.act((editor) => {
      const entry = entriesOf(editor.document.robot, editor.unit)[index];
      const { document, text } = entry.set(editor.shown, value === undefined ? null : Number(value));
      const isDone = editor.change(document);
      this.finish(isDone, text);
      this.refused.delete(index);
      if (isDone) {
        for (const i of this.refused) this.inputs[i].set(this.shown[i] ?? "");
        this.refused.clear();
      } else {
        field.refuse(sentence(editor.refusal?.message ?? ""));
        this.refused.add(index);
      }
    });
  }

  /** Changes the shape. @param {(robot: Shaped) => Shaped} set */
  change(set) {
    this.act((editor) => {
      const { document } = editor;
      const shaped = shapedOf(document.robot);
      if (shaped) this.finish(editor.change({ ...document, robot: set(shaped) }), "");
    });
  }

  /** Makes it a robot of another type. @param {Robot["type"]} type */
  retype(type) {
    this.act((editor) => {
      const { documents, text } = withType(editor.shown, type, editor.size, editor.unit);
      this.finish(editor.change(best(editor, documents)), text);
      this.type.value = editor.document.robot.type;
    });
  }

  /** Says what was done, or why nothing. @param {boolean} isDone @param {string} text */
  finish(isDone, text) {
    const { editor } = this;
    const reason = isDone ? "" : editor.reason;
    write(this.text, isDone ? text : "");
    this.text.hidden = this.text.textContent === "";
    write(this.reason, reason);
    this.reason.hidden = reason === "";
    if (isDone) editor.announcement = `${capital(robotText(editor.document))}. ${text}`.trim();
  }
}

/** @param {string} title @param {HTMLElement} content */
function fold(title, content) {
  return make("details", {}, make("summary", {}, title), content);
}

/** The robot, in words. @param {ScenarioDocument} document */
function robotText({ robot }) {
  const name = TYPES.find(([type]) => type === robot.type)?.[1].toLowerCase();
  return `the robot is ${name === "arm" ? "an" : "a"} ${name}`;
}
