/** A single particle: its circular arc, and the spiral of the other model. */
import { particlePoints } from "planarium/full";
import { View } from "planarium/draw";
import { make } from "../app/dom.js";
import { Figure } from "../draw/figure.js";
import { disc, ring, setStroke } from "../draw/marks.js";
import { num, tuple } from "../widgets/format.js";
import { Slider } from "../widgets/slider.js";
import { FIRST } from "./state.js";

/** @import { App } from "../app/app.js" */
/** @import { Brush } from "../draw/figure.js" */
/** @import { Movement } from "./state.js" */

const PIECES = 240;
/** Seconds between two marks, and marks at most. */
const MARK = 0.1;
const MOST_MARKS = 40;
const MARGIN = { left: 16, right: 16, top: 16, bottom: 16 };

export class Particle {
  /** @param {App} app @param {HTMLElement} host */
  constructor(app, host) {
    /** @type {Movement} */
    this.movement = [...FIRST];
    this.words = make("p", { className: "hint", id: "one-words" });
    this.sliders = [
      { name: "one-v", title: "Speed", unit: "m/s", min: 0, max: 2 },
      { name: "one-w", title: "Turn rate", unit: "rad/s", min: -2 * Math.PI, max: 2 * Math.PI },
      { name: "one-duration", title: "Duration", unit: "s", min: 0.1, max: 10 },
    ].map(
      (info, i) =>
        new Slider(info, this.movement[i], (value) => {
          this.movement[i] = value;
          this.update();
        }),
    );
    const stage = make("div", { className: "stage single one" });
    host.append(stage, ...this.sliders.map(({ element }) => element), this.words);
    this.arc = this.spiral = /** @type {Float64Array} */ (new Float64Array(0));
    this.figure = new Figure(
      app,
      stage,
      { id: "one", kind: "workspace", caption: "One particle", note: "arc and spiral" },
      this,
    );
    this.update();
  }

  /** @param {Movement} movement @throws {Error} it is out of range */
  set(movement) {
    if (this.sliders.some(({ info: { min, max } }, i) => movement[i] < min || movement[i] > max))
      throw new Error("The single particle of this link is out of range.");
    this.movement = [...movement];
    this.sliders.forEach((slider, i) => slider.show(movement[i]));
    this.update();
  }

  update() {
    const duration = this.movement[2];
    Object.assign(this, curvesOf(this.movement));
    const [arc, spiral] = [this.arc, this.spiral].map((points) => points.slice(-2));
    const apart = Math.hypot(arc[0] - spiral[0], arc[1] - spiral[1]);
    this.words.textContent = `After ${num(duration)} s the arc ends at ${tuple(arc, 3)} and the spiral at ${tuple(spiral, 3)}, ${num(apart, 3)} m apart. The spiral is the point v\u00b7t in direction w\u00b7t, as if the particle had always had its present heading.`;
    this.figure.describe(`One particle: ${this.words.textContent}`);
    this.figure.element.dataset.apart = String(apart);
    this.figure.redraw();
  }

  get layers() {
    return { curves: { draw: (/** @type {Brush} */ brush) => this.draw(brush) } };
  }

  /** @param {Brush} brush */
  draw({ context, palette, width, height }) {
    const { arc, spiral, movement } = this;
    const [xs, ys] = [0, 1].map((axis) => [...arc, ...spiral].filter((_, i) => i % 2 === axis));
    const [left, bottom] = [Math.min(...xs), Math.min(...ys)];
    const view = new View(
      { min: [left, bottom], max: [Math.max(...xs), Math.max(...ys, bottom + 1e-3)] },
      width,
      height,
      MARGIN,
      false,
    );
    const at = (/** @type {Float64Array} */ points, /** @type {number} */ i) => view.place(points.subarray(2 * i));
    const marks = Math.min(MOST_MARKS, Math.floor(movement[2] / MARK));
    context.lineJoin = "round";
    for (const [points, colour, line, dash] of /** @type {const} */ ([
      [spiral, palette.growth, 1.8, [6, 4]],
      [arc, palette.path, 3, []],
    ])) {
      context.fillStyle = colour;
      setStroke(context, colour, line, [...dash]);
      context.beginPath();
      for (let i = 0; i <= PIECES; i++) context.lineTo(...at(points, i));
      context.stroke();
      for (let i = 1; i <= marks; i++) disc(context, ...at(points, Math.round((PIECES * i) / marks)), 2.4);
    }
    setStroke(context, palette.start, 2);
    ring(context, ...at(arc, 0), 5);
  }
}

/** The points of both curves at equal times. @param {Movement} movement */
export function curvesOf([v, w, duration]) {
  const times = Array.from({ length: PIECES + 1 }, (_, i) => (duration * i) / PIECES);
  return {
    arc: particlePoints({ model: "arc", v, w }, times),
    spiral: particlePoints({ model: "spiral", v, w }, times),
  };
}
