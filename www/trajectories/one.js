/** One particle, for a look at its motion: the circular arc, and beside it the spiral that the other rule gives. */
import { make } from "../app/dom.js";
import { Sheet } from "../room/sheet.js";
import { Slider } from "../room/slider.js";

/** @import { Room } from "../room/room.js" */
/** @import { Brush } from "../room/sheet.js" */

/** @typedef {[number, number, number]} Motion   speed, turn rate, duration */

const PIECES = 240;
/** Seconds between two marks. */
const MARK = 0.1;
/** Marks at most. */
const MOST_MARKS = 40;
/** Room about the picture, pixels. */
const MARGIN = 16;

/** @type {Motion} */
export const ONE = [1, Math.PI / 4, 4];

export class One {
  /** @param {Room} room @param {Pick<typeof import("planarium"), "particlePoints">} library @param {HTMLElement} host @param {() => void} onChange */
  constructor(room, library, host, onChange) {
    this.library = library;
    /** @type {Motion} */
    this.motion = [...ONE];
    this.words = make("p", { className: "hint", id: "one-words" });
    this.sliders = [
      { name: "one-v", title: "Speed", unit: "m/s", min: 0, max: 2 },
      { name: "one-w", title: "Turn rate", unit: "rad/s", min: -2 * Math.PI, max: 2 * Math.PI },
      { name: "one-duration", title: "Duration", unit: "s", min: 0.1, max: 10 },
    ].map((info, i) => new Slider(info, this.motion[i], (value) => {
      this.motion[i] = value;
      this.show();
      onChange();
    }));
    const stage = make("div", { className: "stage single one" });
    host.append(stage, ...this.sliders.map(({ element }) => element), this.words);
    this.sheet = new Sheet(room, stage, { id: "one", kind: "workspace", caption: "One particle", note: "arc and spiral" }, this);
    /** Points of both motions. */
    this.arc = /** @type {Float64Array} */ (new Float64Array(0));
    this.spiral = /** @type {Float64Array} */ (new Float64Array(0));
    this.show();
  }

  /** @param {Motion} motion */
  put(motion) {
    this.motion = [...motion];
    this.sliders.forEach((slider, i) => slider.show(motion[i]));
    this.show();
  }

  show() {
    const [v, w, duration] = this.motion;
    const times = Array.from({ length: PIECES + 1 }, (_, i) => (duration * i) / PIECES);
    this.arc = this.library.particlePoints({ model: "arc", v, w }, times);
    this.spiral = this.library.particlePoints({ model: "spiral", v, w }, times);
    const [arc, spiral] = [this.arc, this.spiral].map((points) => points.slice(-2));
    const apart = Math.hypot(arc[0] - spiral[0], arc[1] - spiral[1]);
    const end = (/** @type {Float64Array} */ [x, y]) => `(${x.toFixed(3)}, ${y.toFixed(3)})`;
    this.words.textContent = `After ${duration.toFixed(2)} s the arc ends at ${end(arc)}, the spiral at ${end(spiral)}: ${apart.toFixed(3)} m apart. The spiral goes v t in direction w t, as if it had always looked where it looks now.`;
    this.sheet.describe(`One particle: ${this.words.textContent}`);
    this.sheet.figure.dataset.apart = String(apart);
    this.sheet.redraw();
  }

  /** @param {Brush} brush */
  ground({ context, palette, width, height }) {
    let [left, low, right, high] = [0, 0, 0, 0];
    for (const points of [this.arc, this.spiral]) {
      for (let i = 0; i < points.length; i += 2) {
        [left, right] = [Math.min(left, points[i]), Math.max(right, points[i])];
        [low, high] = [Math.min(low, points[i + 1]), Math.max(high, points[i + 1])];
      }
    }
    const scale = Math.min((width - 2 * MARGIN) / Math.max(right - left, 1e-3), (height - 2 * MARGIN) / Math.max(high - low, 1e-3));
    const at = (/** @type {Float64Array} */ points, /** @type {number} */ i) => /** @type {[number, number]} */ (
      [width / 2 + (points[2 * i] - (left + right) / 2) * scale, height / 2 - (points[2 * i + 1] - (low + high) / 2) * scale]);
    context.lineCap = "round";
    context.lineJoin = "round";
    const marks = Math.min(MOST_MARKS, Math.floor(this.motion[2] / MARK));
    for (const [points, colour, line, dash] of /** @type {const} */ ([[this.spiral, palette.growth, 1.8, [6, 4]], [this.arc, palette.path, 3, []]])) {
      context.strokeStyle = colour;
      context.lineWidth = line;
      context.setLineDash([...dash]);
      context.beginPath();
      context.moveTo(...at(points, 0));
      for (let i = 1; i <= PIECES; i++) context.lineTo(...at(points, i));
      context.stroke();
      context.setLineDash([]);
      context.fillStyle = colour;
      context.beginPath();
      for (let i = 1; i <= marks; i++) {
        const [x, y] = at(points, Math.round((PIECES * i) / marks));
        context.moveTo(x + 2.4, y);
        context.arc(x, y, 2.4, 0, 2 * Math.PI);
      }
      context.fill();
    }
    const [x, y] = at(this.arc, 0);
    context.strokeStyle = palette.start;
    context.lineWidth = 2;
    context.beginPath();
    context.arc(x, y, 5, 0, 2 * Math.PI);
    context.stroke();
  }

  top() {}
}
