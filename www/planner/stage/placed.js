/**
 * Bodies and cars: orientation marks, wheels, goal regions, the handle that turns them, and motions that are arcs.
 * Loaded with the first of them.
 */
import { obstaclePath, wrap } from "planarium/draw";
import { handleAhead } from "../../draw/placed-handles.js";

/** @import { Hover, Shown } from "./lane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @import { Configuration, Part, ScenarioDocument } from "../../domain/types.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { View } from "planarium/draw" */
/** @import { Workspace } from "./workspace-pane.js" */
/** @typedef {number[] | Float64Array} Motion   speed, steering angle, seconds */
/** @typedef {Extract<ScenarioDocument["robot"], { type: "rigid_body" | "car" }>} PlacedRobot */

/** Size of a wheel, in parts of the wheelbase. */
const WHEEL = { length: 0.3, width: 0.1 };
/** Distance of the handle from the body, CSS pixels. */
const HANDLE = 14;
/** Most outlines of a swept area. */
const OUTLINES = 160;

export class Placed {
  /** @param {PlacedRobot} robot */
  constructor(robot) {
    this.robot = robot;
    const { vertices } = robot.shape;
    /** How far the shape extends in front of its origin, metres. */
    this.front = Math.max(...vertices.map(([x]) => x));
    /**
     * Where the front axle is drawn, metres before the rear one: at the wheelbase, or within a body that ends before
     * it. There the wheels turn by less, so that they roll without slipping along the same arcs.
     */
    this.axle =
      robot.type === "car"
        ? Math.min(robot.wheelbase, this.front > 0 ? this.front / (1 + WHEEL.length / 2) : Infinity)
        : 0;
    this.front = Math.max(this.front, this.axle * (1 + WHEEL.length / 2));
    this.half = Math.max(...vertices.map(([, y]) => Math.abs(y)));
    this.reach = Math.max(...vertices.map(([x, y]) => Math.hypot(x, y)));
    /** The last swept area. @type {{ edge: number, run: RunLog, parts: Part[][] } | null} */
    this.swept = null;
  }

  // Drawing.

  /**
   * An arrow for the orientation of a body; axles and wheels of a car.
   * @param {CanvasRenderingContext2D} context
   * @param {View} view
   * @param {ArrayLike<number>} pose
   * @param {number} steering  radians
   * @param {string} colour
   * @param {string} [outline]  of what extends beyond the body
   */
  drawMarks(context, view, pose, steering, colour, outline = colour) {
    const { robot } = this;
    context.save();
    context.translate(view.x(pose[0]), view.y(pose[1]));
    context.rotate(-pose[2]);
    context.strokeStyle = context.fillStyle = colour;
    const scale = view.scaleX;
    if (robot.type === "rigid_body") {
      const tip = Math.max(0.55 * this.front, 0.3 * this.reach) * scale;
      context.lineWidth = 1.3;
      context.lineJoin = "round";
      context.beginPath();
      context.moveTo(0, 0);
      context.lineTo(tip, 0);
      context.moveTo(tip - 4, -3.2);
      context.lineTo(tip, 0);
      context.lineTo(tip - 4, 3.2);
      context.stroke();
      context.beginPath();
      context.arc(0, 0, 2.2, 0, 2 * Math.PI);
      context.fill();
    } else {
      const base = this.axle * scale;
      const turned = Math.atan((this.axle / robot.wheelbase) * Math.tan(steering));
      const track = Math.max(0.62 * this.half * scale, 2);
      context.lineWidth = 1.2;
      context.strokeStyle = outline;
      context.globalAlpha = outline === colour ? 0.7 : 1;
      context.beginPath();
      context.moveTo(0, 0);
      context.lineTo(base, 0);
      for (const axle of [0, base]) {
        context.moveTo(axle, -track);
        context.lineTo(axle, track);
      }
      context.stroke();
      context.globalAlpha = 1;
      for (const [x, turn] of [
        [0, 0],
        [base, turned],
      ]) {
        for (const y of [-track, track]) {
          context.save();
          context.translate(x, y);
          context.rotate(-turn);
          const [long, wide] = [Math.max(WHEEL.length * base, 4), Math.max(WHEEL.width * base, 1.8)];
          context.fillRect(-long / 2, -wide / 2, long, wide);
          if (outline !== colour) context.strokeRect(-long / 2, -wide / 2, long, wide);
          context.restore();
        }
      }
    }
    context.restore();
  }

  /**
   * The goal region: a circle of positions, and the range of orientations.
   * @param {CanvasRenderingContext2D} context
   * @param {View} view
   * @param {Configuration} goal
   * @param {Shown} shown
   * @param {string} colour
   */
  drawRegion(context, view, goal, { document, query }, colour) {
    const tolerance = document.queries.find(({ name }) => name === query)?.goal_tolerance;
    if (!tolerance) return;
    const [x, y] = [view.x(goal[0]), view.y(goal[1])];
    const { translation = 0, rotation = 0 } = tolerance;
    const radius = translation * view.scaleX;
    const turn = Math.min(rotation, Math.PI);
    const arm = Math.max(radius, 1.25 * this.reach * view.scaleX);
    context.save();
    context.strokeStyle = context.fillStyle = colour;
    context.globalAlpha = 0.1;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
    context.globalAlpha = 0.55;
    context.lineWidth = 1;
    context.setLineDash([2, 3]);
    context.stroke();
    if (turn < Math.PI) {
      context.beginPath();
      context.moveTo(x + radius * Math.cos(goal[2] - turn), y - radius * Math.sin(goal[2] - turn));
      context.lineTo(x + arm * Math.cos(goal[2] - turn), y - arm * Math.sin(goal[2] - turn));
      context.arc(x, y, arm, -(goal[2] - turn), -(goal[2] + turn), true);
      context.lineTo(x + radius * Math.cos(goal[2] + turn), y - radius * Math.sin(goal[2] + turn));
      context.stroke();
    }
    context.restore();
  }

  /**
   * The area that the robot sweeps along an edge.
   * @param {Workspace} pane
   * @param {CanvasRenderingContext2D} context
   * @param {Hover} hover
   * @param {Palette} palette
   */
  drawSwept(pane, context, { lane: { run, scenario }, edge = -1 }, palette) {
    const view = /** @type {View} */ (pane.view);
    if (!run || edge < 0) return;
    if (this.swept?.edge !== edge || this.swept.run !== run) {
      const rows = run.along(edge);
      const n = run.dimension;
      const count = rows.length / n;
      // Poses between two rows are interpolated, as close as the outline needs them.
      const pieces = Math.max(1, Math.floor(OUTLINES / Math.max(1, count - 1)));
      /** @type {Part[][]} */
      const parts = [];
      for (let i = 0; i + 1 < count; i++) {
        const [from, to] = [rows.subarray(i * n, i * n + n), rows.subarray(i * n + n, i * n + 2 * n)];
        for (let p = 0; p < pieces; p++) parts.push(scenario.footprint(scenario.interpolate(from, to, p / pieces)));
      }
      parts.push(scenario.footprint(rows.subarray(rows.length - n)));
      this.swept = { edge, run, parts };
    }
    const { width, height, ratio } = pane;
    const outlines = this.swept.parts;
    /**
     * A picture of all outlines.
     * @param {(ink: CanvasRenderingContext2D, each: (draw: () => void) => void) => void} draw
     */
    const picture = (draw) => {
      const canvas = new OffscreenCanvas(
        Math.max(1, Math.round(width * ratio)),
        Math.max(1, Math.round(height * ratio)),
      );
      const ink = /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (canvas.getContext("2d")));
      ink.setTransform(ratio, 0, 0, ratio, 0, 0);
      ink.strokeStyle = ink.fillStyle = palette.newest;
      ink.lineJoin = "round";
      ink.lineWidth = 3;
      draw(ink, (inked) => {
        for (const [part] of outlines) {
          if (part.type !== "polygon") continue;
          obstaclePath(ink, view, part);
          inked();
        }
      });
      return canvas;
    };
    const inside = picture((ink, each) => each(() => ink.fill()));
    // The outline is what sticks out where all outlines are drawn first and all insides are taken out again.
    const outline = picture((ink, each) => {
      each(() => ink.stroke());
      ink.globalCompositeOperation = "destination-out";
      each(() => ink.fill());
    });
    context.save();
    context.globalAlpha = 0.14;
    context.drawImage(inside, 0, 0, width, height);
    context.globalAlpha = 1;
    context.drawImage(outline, 0, 0, width, height);
    context.restore();
  }

  /**
   * Is a pose in the region of the goal, or as near to it as a hand can put it?
   * @param {ArrayLike<number>} pose
   * @param {ArrayLike<number>} goal
   * @param {Shown} shown
   */
  isNear(pose, goal, { document, query, scenario }) {
    const { min, max } = scenario.extent();
    const near = { translation: 0.015 * Math.max(max[0] - min[0], max[1] - min[1]), rotation: 0.08 };
    const { translation = 0, rotation = 0 } =
      document.queries.find(({ name }) => name === query)?.goal_tolerance ?? near;
    return (
      Math.hypot(pose[0] - goal[0], pose[1] - goal[1]) <= Math.max(translation, near.translation) &&
      Math.abs(wrap(pose[2] - goal[2])) <= Math.max(rotation, near.rotation)
    );
  }

  /**
   * Where its handle for turning is, pixels.
   * @param {ArrayLike<number>} pose
   * @param {View} view
   * @returns {[number, number]}
   */
  handle(pose, view) {
    return handleAhead(view, pose, this.front * view.scaleX + HANDLE);
  }

  /**
   * The handle: a dot on a line before the body.
   * @param {CanvasRenderingContext2D} context
   * @param {View} view
   * @param {ArrayLike<number>} pose
   * @param {string} colour
   * @param {string} ground
   */
  drawHandle(context, view, pose, colour, ground) {
    const [x, y] = this.handle(pose, view);
    context.save();
    context.strokeStyle = colour;
    context.fillStyle = ground;
    context.lineWidth = 1.6;
    context.beginPath();
    context.moveTo(x - HANDLE * Math.cos(pose[2]), y + HANDLE * Math.sin(pose[2]));
    context.lineTo(x, y);
    context.stroke();
    context.beginPath();
    context.arc(x, y, 5, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    context.restore();
  }

  // Motions.

  /**
   * The pose after part of a motion: an exact arc, as in the core.
   * @param {ArrayLike<number>} from
   * @param {Motion} motion
   * @param {number} part  of its time
   * @returns {Float64Array}
   */
  after(from, [v, phi, seconds], part) {
    const length = this.robot.type === "car" ? this.robot.wheelbase : 1;
    const time = seconds * part;
    const turn = ((v * Math.tan(phi)) / length) * time;
    const half = turn / 2;
    const chord = v * time * (half === 0 ? 1 : Math.sin(half) / half);
    return Float64Array.of(
      from[0] + chord * Math.cos(from[2] + half),
      from[1] + chord * Math.sin(from[2] + half),
      wrap(from[2] + turn),
    );
  }

  /** The controls along an edge, in words. @param {Float64Array} motions  rows of speed, steering angle, seconds */
  motionsText(motions) {
    const number = (/** @type {number} */ value, /** @type {number} */ digits) =>
      value.toFixed(digits).replace("-", "\u2212");
    /** @type {string[]} */
    const words = [];
    for (let i = 0; i < motions.length; i += 3) {
      const [v, phi, seconds] = motions.subarray(i, i + 3);
      words.push(`v ${number(v, 2)} m/s, \u03c6 ${number((phi * 180) / Math.PI, 0)}\u00b0 for ${number(seconds, 2)} s`);
    }
    return `${words.length > 1 ? "Controls" : "Control"}: ${words.join("; then ")}.`;
  }

  /** The metres that a motion drives. @param {Motion} motion */
  lengthOf([v, , seconds]) {
    return Math.abs(v * seconds);
  }
}
