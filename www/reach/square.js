/**
 * The configuration space of an arm of two joints: its configuration, the motion from A to B, and a run of inverse
 * kinematics.
 */
import { AngleSquare } from "../draw/angle-square.js";
import { cross, disc, drawDot, ring, setStroke } from "../draw/marks.js";
import { drawEndsHere, drawGoal, drawHit, drawStart } from "../draw/shapes.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { IkRun } from "./ik-run.js" */
/** @import { ReachSession } from "./session.js" */

export class Square extends AngleSquare {
  /** @param {ReachSession} session */
  constructor(session) {
    super();
    this.session = session;
  }

  /** @param {Brush} brush @override */
  drawGround(brush) {
    this.drawSquare(brush, this.session.robot.coordinates);
  }

  /** @param {Brush} brush @override */
  drawTop(brush) {
    const { robot, mode, run } = this.session;
    const { context, palette } = brush;
    const isFree = robot.check.free;
    this.repeat(context, (isCopy) => {
      if (mode === "between") this.drawMotion(brush);
      if (run) this.drawRun(brush, run);
      const [x, y] = this.place(robot.q);
      context.globalAlpha = isCopy ? 0.35 : 1;
      drawDot(context, x, y, isFree ? palette.robot : palette.collision, palette);
      if (!isFree) cross(context, x, y, 2.6);
    });
  }

  /** @param {Brush} brush */
  drawMotion({ context, palette, bold }) {
    const { a, b, motion } = this.session;
    const isMiss = motion.missed.length > 0;
    setStroke(context, isMiss ? palette.rejected : palette.path, 3, isMiss ? [7, 5] : []);
    this.strokeMotion(context, a, motion.turns);
    drawStart(context, ...this.place(a), palette);
    drawGoal(context, ...this.place(b), palette);
    if (isMiss) drawEndsHere(context, ...this.place(motion.at(1)), palette, bold);
    if (motion.hit !== null) drawHit(context, ...this.place(motion.at(motion.hit)), palette);
  }

  /** Iterates as dots, solutions as rings. @param {Brush} brush @param {IkRun} run */
  drawRun({ context, palette }, run) {
    context.fillStyle = palette.growth;
    for (const { q, strength } of run.recent(160)) {
      context.globalAlpha = 0.2 + 0.7 * strength;
      disc(context, ...this.place(q), 2.2);
    }
    context.globalAlpha = 1;
    for (const { q, isFree } of run.shown) {
      setStroke(context, isFree ? palette.path : palette.collision, 2.4, isFree ? [] : [2, 3]);
      ring(context, ...this.place(q), 8.5);
    }
    context.setLineDash([]);
  }
}
