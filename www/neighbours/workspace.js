/** The robot in its world: the list, faint unless there are few, the neighbours by rank, and the target. */
import { drawRobot, partPath } from "planarium/draw";
import { dotsImage } from "../draw/dots.js";
import { NO_VIEW } from "../draw/figure.js";
import { drawWorkspace } from "../draw/ground.js";
import { addLine, disc, drawHandle, drawReference, ring, setStroke } from "../draw/marks.js";
import { placedHandles } from "../draw/placed-handles.js";
import { drawLabels } from "../draw/labels.js";
import { drawGhost } from "../draw/shapes.js";
import { FEW } from "./session.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { NeighbourSession } from "./session.js" */

/** Neighbours that are numbered, at most. */
const RANKED = 12;
/** Neighbours drawn as robots; others are dots. */
const MOST = 60;

export class Workspace {
  /** @param {NeighbourSession} session */
  constructor(session) {
    this.session = session;
    this.view = NO_VIEW;
  }

  /**
   * The handles of the target, CSS pixels: the ends of the links of an arm; otherwise the middle, and the front of a
   * body.
   * @returns {[x: number, y: number][]}
   */
  get handles() {
    const {
      view,
      session: { scenario, q, isArm, isPlaced },
    } = this;
    const parts = scenario.footprint(q);
    if (isArm) return parts.map((part) => view.place(part.type === "capsule" ? part.b : [0, 0]));
    return isPlaced ? placedHandles(view, parts, q) : [view.place(q)];
  }

  get layers() {
    const { list, document } = this.session;
    return {
      ground: { key: [list, document], draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** @param {Brush} brush */
  drawGround(brush) {
    const { document, scenario, footprints } = this.session;
    const { tips } = this.session.list;
    const { context, palette, width, height, ratio } = brush;
    const view = (this.view = drawWorkspace(brush, scenario, document));
    if (footprints.length <= FEW) return this.drawFew(brush);
    context.save();
    setStroke(context, palette.growth, 1);
    context.lineJoin = "round";
    context.globalAlpha = footprints.length > 100 ? 0.12 : 0.25;
    for (const parts of footprints) {
      context.beginPath();
      for (const part of parts) {
        if (part.type === "capsule") addLine(context, ...view.place(part.a), ...view.place(part.b));
        else if (part.type === "polygon") partPath(context, view, part);
      }
      context.stroke();
    }
    context.restore();
    const places = tips.map((value, i) => (i % 2 === 0 ? view.x(value) : view.y(value)));
    context.drawImage(
      dotsImage(places, { width, height, ratio, colour: palette.growth, size: 2.2 }),
      0,
      0,
      width,
      height,
    );
  }

  /** Each robot with its outline and its reference point, of an arm the tip. @param {Brush} brush */
  drawFew({ context, palette }) {
    const { view } = this;
    const { footprints } = this.session;
    const { tips } = this.session.list;
    for (const parts of footprints)
      drawGhost(context, view, parts, { colour: palette.growth, fill: 0.16, stroke: 0.9, dash: [], width: 1.6 });
    for (let i = 0; i < tips.length; i += 2) drawReference(context, ...view.place(tips.subarray(i)), palette);
  }

  /** @param {Brush} brush */
  drawTop({ context, palette, width, height, bold }) {
    const { session, view } = this;
    if (!session.isAsking) return;
    const { scenario, missed, q } = session;
    const { tips } = session.list;
    const { indices } = session.found;
    const { robot } = session.document;
    const isDot = robot.type === "disc" && robot.radius === 0;
    const colourOf = (/** @type {number} */ i) => (session.exact.has(i) ? palette.start : palette.rejected);
    const tipOf = (/** @type {number} */ i) => view.place(tips.subarray(2 * i));
    const footprintOf = (/** @type {number} */ i) => scenario.footprint(session.row(i));
    // The nearest is drawn last, on top.
    const ranked = [...indices.entries()].reverse();
    setStroke(context, palette.rejected, 1.6);
    for (const i of missed) {
      if (missed.length > MOST || isDot) ring(context, ...tipOf(i), 4.4);
      else
        drawGhost(context, view, footprintOf(i), {
          colour: palette.rejected,
          fill: 0,
          stroke: 0.9,
          dash: [4, 4],
          width: 1.4,
        });
    }
    for (const [rank, i] of ranked) {
      const near = 1 - rank / Math.max(1, indices.length - 1);
      context.fillStyle = colourOf(i);
      if (rank >= MOST || isDot) disc(context, ...tipOf(i), 3.6);
      else
        drawGhost(context, view, footprintOf(i), {
          colour: colourOf(i),
          fill: 0.05 + 0.08 * near,
          stroke: 0.55 + 0.4 * near,
          dash: [],
          width: 1 + 1.2 * near,
        });
    }
    drawRobot(context, view, scenario.footprint(q), palette);
    const { handles } = this;
    for (const at of handles) drawHandle(context, ...at, palette.robot, palette);
    if (indices.length > RANKED) return;
    const labels = [...indices].map((i, rank) => {
      const [x, y] = tipOf(i);
      return { text: String(rank + 1), x, y, colour: colourOf(i) };
    });
    drawLabels(context, labels, palette, { width, height, bold }, [
      ...handles.map(([x, y]) => /** @type {[number, number, number]} */ ([x, y, 9])),
      ...labels.map(({ x, y }) => /** @type {[number, number, number]} */ ([x, y, 4])),
    ]);
  }
}
