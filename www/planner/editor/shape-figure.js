/**
 * The shape of a body or a car in a small figure: its corners are dragged, or moved by arrow keys, and typed. The cross
 * is the origin of its frame, the arrow points forward.
 */
import { make, makeSvg } from "../../app/dom.js";
import { boxOf } from "../../domain/obstacles.js";
import { button } from "../../widgets/elements.js";
import { editField } from "./edit-field.js";
import { middle, withPoint } from "./parts.js";
import { rounded } from "./units.js";
import { sentence } from "./words.js";

/** @import { Point, ScenarioDocument } from "../../domain/types.js" */
/** @import { Editor } from "./editor.js" */
/** @import { Polygon } from "./parts.js" */
/** @import { Shaped } from "./robots.js" */

/** Size of the figure, CSS pixels: the shape has at most the inner one. */
const SIZE = { width: 240, height: 150, inner: 96 };
/** Reach of a pointer, CSS pixels. */
const REACH = 24;

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class ShapeFigure {
  /** @param {Editor} editor @param {(action: (editor: Editor) => void) => void} act */
  constructor(editor, act) {
    this.editor = editor;
    this.act = act;
    this.corner = 0;
    this.isHeld = false;
    /** The numbers last written into the fields. @type {Point} */
    this.shown = [NaN, NaN];
    /** Where the origin is in the figure, and pixels a metre; fixed while a corner is held. */
    this.view = { x: 0, y: 0, scale: 1 };
    this.svg = makeSvg("svg", { class: "shape-figure", id: "shape", viewBox: `0 0 ${SIZE.width} ${SIZE.height}` });
    this.svg.setAttribute("tabindex", "0");
    this.svg.setAttribute("role", "group");
    const [x, y] = ["x", "y"].map((name, i) =>
      editField({ name: `corner-${name}`, title: `Corner ${name}`, unit: "m" }, 0, () => this.enter(i)),
    );
    this.inputs = [x, y];
    this.buttons = make(
      "div",
      { className: "parts" },
      button("corner-previous", "Previous", () => this.pick(-1)),
      button("corner-next", "Next", () => this.pick(1)),
      button("corner-add", "Add corner", () => this.add()),
      button("corner-remove", "Delete", () => this.put(null)),
    );
    this.element = make("div", { className: "shape-editor" }, this.svg, this.buttons, x.element, y.element);
    this.svg.addEventListener("pointerdown", (event) => this.grab(event));
    this.svg.addEventListener("pointermove", (event) => {
      if (this.isHeld) this.put(this.pointAt(event), true);
    });
    for (const type of /** @type {const} */ (["pointerup", "pointercancel"]))
      this.svg.addEventListener(type, () => this.release());
    this.svg.addEventListener("keydown", (event) => this.key(event));
  }

  /** @returns {Shaped} */
  get robot() {
    return /** @type {Shaped} */ (this.editor.document.robot);
  }

  /** The unit of its coordinates: finer than that of the world. */
  get unit() {
    return this.editor.unit / 10;
  }

  /** @param {Shaped} robot */
  show({ shape: { vertices } }) {
    this.corner = Math.min(this.corner, vertices.length - 1);
    if (!this.isHeld) this.fit(vertices);
    const { x, y, scale } = this.view;
    const places = vertices.map(([a, b]) => [x + scale * a, y - scale * b]);
    this.svg.setAttribute("aria-label", `Shape of the robot: corner ${this.corner} of ${vertices.length} is selected`);
    this.svg.replaceChildren(
      makeSvg("polygon", { points: places.join(" ") }),
      makeSvg("path", { d: `M${x - 6} ${y}h42l-6 -4m6 4l-6 4M${x} ${y - 6}v12` }),
      ...places.map(([cx, cy], i) =>
        makeSvg("rect", { x: cx - 4.5, y: cy - 4.5, width: 9, height: 9, class: i === this.corner ? "chosen" : "" }),
      ),
    );
    const place = vertices[this.corner];
    this.inputs.forEach((field, i) => {
      // Text being typed stays until the number itself changes.
      if (place[i] !== this.shown[i]) field.set(place[i]);
    });
    this.shown = place;
  }

  /** The whole shape, with its origin. @param {Point[]} vertices */
  fit(vertices) {
    const [[left, bottom], [right, top]] = boxOf([...vertices, [0, 0]]);
    const scale = Math.min(SIZE.inner / (top - bottom), (2 * SIZE.inner) / (right - left));
    this.view = {
      x: SIZE.width / 2 - (scale * (left + right)) / 2,
      y: SIZE.height / 2 + (scale * (bottom + top)) / 2,
      scale,
    };
  }

  /** The place of a pointer in pixels of the figure. @param {PointerEvent} event @returns {Point} */
  pixelsAt({ clientX, clientY }) {
    const { left, top, width } = this.svg.getBoundingClientRect();
    const ratio = SIZE.width / width;
    return [(clientX - left) * ratio, (clientY - top) * ratio];
  }

  /** @param {PointerEvent} event @returns {Point} */
  pointAt(event) {
    const [px, py] = this.pixelsAt(event);
    const { x, y, scale } = this.view;
    return [rounded((px - x) / scale, this.unit), rounded((y - py) / scale, this.unit)];
  }

  /** Takes hold of the nearest corner. @param {PointerEvent} event */
  grab(event) {
    if (event.button !== 0) return;
    const [px, py] = this.pixelsAt(event);
    const { x, y, scale } = this.view;
    const distances = this.robot.shape.vertices.map(([a, b]) => Math.hypot(x + scale * a - px, y - scale * b - py));
    const least = Math.min(...distances);
    if (least > REACH) return;
    event.preventDefault();
    this.svg.focus();
    this.svg.setPointerCapture(event.pointerId);
    this.corner = distances.indexOf(least);
    this.isHeld = true;
    this.show(this.robot);
  }

  release() {
    if (!this.isHeld) return;
    this.isHeld = false;
    this.act((editor) => editor.end());
    this.show(this.robot);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const arrow = ARROWS[event.key];
    const way = { PageUp: -1, PageDown: 1 }[event.key];
    if (arrow) {
      const step = 10 * this.unit * (event.shiftKey ? 10 : 1);
      const [x, y] = this.robot.shape.vertices[this.corner];
      this.put([rounded(x + arrow[0] * step, this.unit), rounded(y + arrow[1] * step, this.unit)], false, event.repeat);
    } else if (way) this.pick(way);
    else if (event.key === "Insert") this.add();
    else if (event.key === "Delete") this.put(null);
    else return;
    event.preventDefault();
  }

  /** @param {number} way */
  pick(way) {
    const { length } = this.robot.shape.vertices;
    this.corner = (this.corner + way + length) % length;
    this.show(this.robot);
  }

  /** Applies a typed number. @param {number} index */
  enter(index) {
    const [x, y] = this.robot.shape.vertices[this.corner].with(index, Number(this.inputs[index].value));
    this.put([x, y]);
    const { refusal } = this.editor;
    if (!refusal) return;
    this.inputs[index].refuse(sentence(refusal.message));
    this.shown = [NaN, NaN];
  }

  /** Adds a corner after the selected one. */
  add() {
    const { vertices } = this.robot.shape;
    const [x, y] = middle({ points: vertices, isClosed: true, line: 0, at: this.corner });
    const point = /** @type {Point} */ ([rounded(x, this.unit), rounded(y, this.unit)]);
    this.change(withPoint(this.robot.shape, this.corner + 1, point, true));
    if (!this.editor.refusal) this.pick(1);
  }

  /** Moves the selected corner, or deletes it. @param {Point | null} point @param {boolean} [isLive] @param {boolean} [goesOn] */
  put(point, isLive = false, goesOn = false) {
    this.change(withPoint(this.robot.shape, this.corner, point), isLive, goesOn);
  }

  /** @param {import("../../domain/types.js").Obstacle} shape @param {boolean} [isLive] @param {boolean} [goesOn] */
  change(shape, isLive = false, goesOn = false) {
    this.act((editor) => {
      /** @type {ScenarioDocument} */
      const document = { ...editor.document, robot: { ...this.robot, shape: /** @type {Polygon} */ (shape) } };
      if (isLive) editor.attempt(document, true);
      else editor.change(document, goesOn);
    });
  }
}
