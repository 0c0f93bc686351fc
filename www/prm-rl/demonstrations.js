/**
 * The figure of the part "Train": small pieces of the floors that the policy is trained on, each with a drive of the
 * policy so far.
 */
import { View } from "planarium/draw";
import { drawGround } from "../draw/ground.js";
import { setStroke } from "../draw/marks.js";
import { drawGoal, drawStart } from "../draw/shapes.js";
import { drawOutcome, drawRobotAt, drawTrace } from "./marks.js";
import { poseAt, swingAt } from "./session.js";

/** @import { Demonstration } from "planarium/full" */
/** @import { Brush } from "../draw/figure.js" */
/** @import { NavigationSession } from "./session.js" */

/** Space between the pieces, CSS pixels, and around start and goal, metres. */
const GAP = 8;
const AROUND = 2.2;
/** Seconds for which all robots stand at their ends before they start again. */
const REST = 2;

export class Demonstrations {
  /** @param {NavigationSession} session */
  constructor(session) {
    this.session = session;
    /** Seconds of the drives; those of others would be shorter or longer. Infinity: their ends. */
    this.time = Infinity;
    this.columns = 4;
    this.side = 1;
    this.left = 0;
    this.topEdge = 0;
  }

  get layers() {
    return {
      ground: { key: [this.session.training.floors], draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** How long the drives are played, with a rest. */
  get round() {
    return Math.max(...this.session.training.demonstrations.map(({ time }) => time), 0) + REST;
  }

  /** The piece at a place, or null. @param {number} x @param {number} y */
  pieceAt(x, y) {
    const { side, columns, left, topEdge } = this;
    const { length } = this.session.training.demonstrations;
    const [column, row] = [Math.floor((x - left) / (side + GAP)), Math.floor((y - topEdge) / (side + GAP))];
    const i = row * columns + column;
    return column >= 0 && column < columns && row >= 0 && i < length ? i : null;
  }

  /** Places squares as large as fit. @param {number} count @param {number} width @param {number} height */
  arrange(count, width, height) {
    let best = { side: 0, columns: 1 };
    for (let columns = 1; columns <= count; columns++) {
      const rows = Math.ceil(count / columns);
      const side = Math.floor(Math.min((width - GAP * (columns - 1)) / columns, (height - GAP * (rows - 1)) / rows));
      if (side > best.side) best = { side, columns };
    }
    const { side, columns } = best;
    const rows = Math.ceil(count / columns);
    Object.assign(this, best, {
      left: (width - columns * (side + GAP) + GAP) / 2,
      topEdge: (height - rows * (side + GAP) + GAP) / 2,
    });
  }

  /** @param {Brush} brush */
  drawGround(brush) {
    const { training } = this.session;
    if (training.demonstrations.length === 0) return;
    this.arrange(training.demonstrations.length, brush.width, brush.height);
    training.demonstrations.forEach((drive, i) =>
      this.within(brush, drive, i, (view) => {
        drawGround(brush.context, view, /** @type {any} */ (training.floors[i]), brush.palette);
      }),
    );
  }

  /** @param {Brush} brush */
  drawTop(brush) {
    const { context, palette, bold } = brush;
    const { training } = this.session;
    training.demonstrations.forEach((drive, i) =>
      this.within(brush, drive, i, (view) => {
        const { robot } = training.floors[i];
        const { time_step: step = 0.2 } = robot;
        drawStart(context, ...view.place([drive.trace[0], drive.trace[1]]), palette);
        drawGoal(context, ...view.place(drive.goal), palette);
        drawTrace(context, view, drive, palette, { rows: this.time / step + 1, width: 2.2 * bold, alpha: 1 });
        const hasEnded = this.time >= drive.time;
        // Failures are marked on top of the robot.
        if (hasEnded && drive.outcome === "reached") drawOutcome(context, view, drive, palette);
        const isSelected = i === training.selected;
        const time = Math.min(this.time, drive.time);
        const state = { pose: poseAt(drive, time, step), swing: swingAt(drive, time, step), hasRays: isSelected };
        if (!hasEnded || isSelected) drawRobotAt(context, view, training.tasks[i], robot, state, palette);
        if (hasEnded && drive.outcome !== "reached") drawOutcome(context, view, drive, palette);
      }),
    );
  }

  /**
   * Draws within a piece.
   * @param {Brush} brush
   * @param {Demonstration} drive
   * @param {number} i
   * @param {(view: View) => void} draw
   */
  within({ context, palette }, { trace, goal }, i, draw) {
    const { side, columns, left, topEdge } = this;
    const { selected } = this.session.training;
    const [x, y] = [left + (i % columns) * (side + GAP), topEdge + Math.floor(i / columns) * (side + GAP)];
    const middle = [(trace[0] + goal[0]) / 2, (trace[1] + goal[1]) / 2];
    const half = Math.max(Math.abs(trace[0] - goal[0]), Math.abs(trace[1] - goal[1])) / 2 + AROUND;
    const view = new View(
      { min: [middle[0] - half, middle[1] - half], max: [middle[0] + half, middle[1] + half] },
      side,
      side,
      { left: 0, right: 0, top: 0, bottom: 0 },
    );
    context.save();
    context.translate(x, y);
    context.beginPath();
    context.rect(0, 0, side, side);
    context.save();
    context.clip();
    draw(view);
    context.restore();
    context.beginPath();
    context.rect(0.5, 0.5, side - 1, side - 1);
    setStroke(context, i === selected ? palette.ink : palette.line, i === selected ? 2 : 1);
    context.stroke();
    context.restore();
  }
}
