/**
 * The configuration space of an arm or a body: a square of two of its coordinates. With two coordinates the obstacles
 * are the configurations in collision; with more, those of a slice. A motion that leaves the square on one side enters
 * on the other.
 */
import { View } from "planarium/draw";
import { coordinatesOf } from "../../domain/coordinates.js";
import { drawAxes, marginOf } from "../../draw/angles.js";
import { addLine, cross, drawDot, setStroke } from "../../draw/marks.js";
import { drawMarked } from "./marked.js";
import { Pane } from "./pane.js";
import { folded, unrolled } from "../../draw/trace.js";

/** @import { Lane, Shown } from "./lane.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { Painting } from "../worker/obstacles.js" */
/** @import { Coordinate, Scenario } from "../../domain/types.js" */
/**
 * @typedef {(painting: Painting) => Promise<ImageBitmap | null>} Painter   paints obstacles in the worker; null after
 *   an error
 */

/**
 * Cells a side of the picture of obstacles: `rough` at first and while the world is edited, then one for a number of device
 * pixels.
 */
const CELLS = { rough: 64, least: 256, most: 512, pixels: 2 };
/** Cells a side of a slice: each is a configuration to check. */
const SLICE = { rough: 24, fine: 96 };

export class CSpace extends Pane {
  constructor() {
    super();
    /** The coordinates across and up. @type {[number, number]} */
    this.axes = [0, 1];
    /** Their names, units and ranges. @type {Coordinate[]} */
    this.named = [];
    /** Whether they wrap around. @type {boolean[]} */
    this.circles = [];
    /** Paints obstacles. @type {Painter | null} */
    this.painter = null;
    /**
     * The picture of the obstacles, and its cells a side.
     * @type {{ key: string, name: string, side: number, image: ImageBitmap | null } | null}
     */
    this.cells = null;
    /**
     * The picture to be painted, and its resolutions from rough to fine.
     * @type {{ key: string, sides: number[] } | null}
     */
    this.wanted = null;
    this.isPainting = false;
    /** The world shown, and how many there have been. */
    this.world = { document: /** @type {object | null} */ (null), count: 0 };
  }

  /** @param {Scenario} scenario @override */
  isPlaneOf({ robot, dimension }) {
    return robot !== "disc" && dimension === 2;
  }

  /** @param {Lane} lane @override */
  fits({ scenario }) {
    return scenario.robot !== "disc" && scenario.dimension >= 2;
  }

  /** @param {Lane} lane @param {number} width @param {number} height @override */
  makeView(lane, width, height) {
    const n = lane.scenario.dimension;
    const [a, b] = lane.shown.view.axes;
    this.axes = a < n && b < n && a !== b ? [a, b] : [0, 1];
    this.named = this.axes.map((axis) => coordinatesOf(lane.shown)[axis]);
    const [x, y] = this.named;
    // Two coordinates in metres have the same scale.
    return new View(
      { min: [x.low, y.low], max: [x.high, y.high] },
      width,
      height,
      marginOf(this.bold),
      x.unit !== "m" || y.unit !== "m",
    );
  }

  /** @param {Lane} lane @override */
  survey({ scenario, shown }) {
    const circles = scenario.circles();
    this.circles = this.axes.map((axis) => circles[axis]);
    const { document } = shown;
    if (this.world.document !== document.world) this.world = { document: document.world, count: this.world.count + 1 };
    // Pictures of the previous scenario are dropped.
    if (this.cells?.name !== document.name || scenario.dimension > 2 !== this.cells.key.includes(" "))
      this.cells = null;
  }

  /**
   * Requests a picture of the obstacles: all of two coordinates; of more, a slice through the current configuration if
   * the view shows it. @override
   */
  refine() {
    const { view, painter, lane } = this;
    if (!view || !painter || !lane) return;
    const { shown } = lane;
    const { dimension } = lane.scenario;
    const pose = dimension > 2 && shown.view.slice ? (lane.pose ?? shown.start) : null;
    this.wanted = dimension > 2 && !pose ? null : this.picture(shown, pose);
    if (!this.wanted) {
      this.cells = null;
      return;
    }
    if (this.isRefined || this.isPainting) return;
    const { key, sides } = this.wanted;
    const side = this.cells?.key === key ? sides[sides.length - 1] : sides[0];
    const { width, height } = this.frame();
    const ratio = shown.rough ? 1 : this.ratio;
    this.isPainting = true;
    const { name } = shown.document;
    void painter({
      document: shown.document,
      side,
      slice: pose && { pose: Array.from(pose), axes: this.axes, box: view.box },
      width: Math.round(width * ratio),
      height: Math.round(height * ratio),
      palette: /** @type {Palette} */ (this.palette),
    })
      .then((image) => {
        // After an error it is not requested again.
        if (this.view && this.lane?.shown.document.name === name)
          this.cells = { key, name, side: image ? side : Infinity, image };
      })
      .finally(() => {
        this.isPainting = false;
      });
  }

  /**
   * A key of all that the picture depends on, and its resolutions.
   * @param {Shown} shown
   * @param {ArrayLike<number> | null} pose
   */
  picture({ rough }, pose) {
    const { width, height } = this.frame();
    const { ratio, palette, axes } = this;
    const look = `${this.world.count},${width},${height},${ratio},${palette?.obstacle},${palette?.obstacleEdge}`;
    if (pose)
      return {
        key: `${look} ${Array.from(pose, (value, j) => (axes.includes(j) ? `axis ${axes.indexOf(j)}` : value)).join()}`,
        sides: rough ? [SLICE.rough] : [SLICE.rough, SLICE.fine],
      };
    const fine = Math.round(Math.min(CELLS.most, Math.max(CELLS.least, (width * ratio) / CELLS.pixels)));
    return { key: look, sides: rough ? [CELLS.rough] : [CELLS.rough, fine] };
  }

  /** Whether the picture of the obstacles is current and at full resolution. @override */
  get isRefined() {
    const { painter, wanted, cells } = this;
    return !painter || !wanted || (cells?.key === wanted.key && cells.side >= Math.max(...wanted.sides));
  }

  /** @override */
  get groundKey() {
    return [this.lane, this.cells];
  }

  /** @param {CanvasRenderingContext2D} context @override */
  clip(context) {
    const { x, y, width, height } = this.frame();
    context.beginPath();
    context.rect(x, y, width, height);
    context.clip();
  }

  /** The square in CSS pixels. */
  frame() {
    const view = /** @type {View} */ (this.view);
    const { min, max } = view.box;
    return {
      x: view.x(min[0]),
      y: view.y(max[1]),
      width: (max[0] - min[0]) * view.scaleX,
      height: (max[1] - min[1]) * view.scaleY,
    };
  }

  /** @param {Float64Array} rows @override */
  pixels(rows) {
    const view = /** @type {View} */ (this.view);
    const n = /** @type {Lane} */ (this.lane).scenario.dimension;
    const points = new Float64Array((rows.length / n) * 2);
    const [across, up] = this.axes;
    const [wrapsX, wrapsY] = this.circles;
    for (let i = 0; n * i < rows.length; i++) {
      const x = rows[n * i + across];
      const y = rows[n * i + up];
      points[2 * i] = view.x(wrapsX ? folded(x) : x);
      points[2 * i + 1] = view.y(wrapsY ? folded(y) : y);
    }
    return points;
  }

  /** @param {Float64Array} ends @param {boolean[]} [circles] @override */
  lines(ends, circles) {
    const view = /** @type {View} */ (this.view);
    const n = /** @type {Lane} */ (this.lane).scenario.dimension;
    const { axes } = this;
    const short = circles ? axes.map((axis) => circles[axis]) : this.circles;
    /** @type {number[]} */
    const points = [];
    const firsts = new Uint32Array(ends.length / (2 * n) + 1);
    for (let m = 0; 2 * n * m < ends.length; m++) {
      const at = 2 * n * m;
      const pair = [ends[at + axes[0]], ends[at + axes[1]], ends[at + n + axes[0]], ends[at + n + axes[1]]];
      let copies = 0;
      unrolled(pair, 0, this.circles, short, (x0, y0, x1, y1) => {
        if (copies++ > 0) points.push(NaN, NaN);
        points.push(view.x(x0), view.y(y0), view.x(x1), view.y(y1));
      });
      firsts[m + 1] = points.length / 2;
    }
    return { points: Float64Array.from(points), firsts };
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @override */
  drawGround(context, lane) {
    const { palette, view, cells } = this;
    if (!palette || !view) return;
    const { x, y, width, height } = this.frame();
    if (cells?.image) context.drawImage(cells.image, x, y, width, height);
    context.strokeStyle = palette.obstacleEdge;
    context.lineWidth = 1;
    context.strokeRect(x, y, width, height);
    context.fillStyle = palette.quiet;
    drawAxes(context, view, { x, y, width, height }, this.named, this.bold);
    drawMarked(this, context, lane);
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @override */
  drawRobot(context, lane) {
    const { palette, view } = this;
    const { pose } = lane;
    if (!palette || !view || !pose) return;
    const { hand, check } = lane.shown;
    const isHit = hand !== null && check !== null && !check.free;
    const colour = isHit ? palette.collision : palette.robot;
    const [px, py] = this.pixels(pose);
    const { x, y, width, height } = this.frame();
    context.save();
    setStroke(context, colour, 1, [2, 4]);
    context.globalAlpha = 0.35;
    context.beginPath();
    addLine(context, px, y, px, y + height);
    addLine(context, x, py, x + width, py);
    context.stroke();
    context.globalAlpha = 1;
    drawDot(context, px, py, colour, palette);
    if (isHit) cross(context, px, py, 2.6);
    context.restore();
  }
}
