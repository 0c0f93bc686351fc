/**
 * The configuration space of an arm of two joints: the list as dots, and straight motions from the target to its
 * neighbours. The naive metric cuts both circles at 0, a kd-tree that does not wrap at pi; their motions never cross
 * that cut, which is drawn.
 */
import { difference, wrap } from "planarium/draw";
import { AngleSquare } from "../draw/angle-square.js";
import { dotsImage } from "../draw/dots.js";
import { disc, drawDot, drawLine, drawReference, ring, setStroke } from "../draw/marks.js";
import { FEW } from "./session.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { NeighbourSession } from "./session.js" */

const TURN = 2 * Math.PI;

export class Square extends AngleSquare {
  /** @param {NeighbourSession} session */
  constructor(session) {
    super();
    this.session = session;
  }

  /** @override */
  get key() {
    return [...super.key, this.session.list];
  }

  /** @param {Brush} brush @override */
  drawGround(brush) {
    const { session } = this;
    const isFew = session.count <= FEW;
    this.drawSquare(brush, session.coordinates, () => (isFew ? null : this.dots(brush)));
    if (!isFew) return;
    const { context, palette } = brush;
    this.repeat(context, (isCopy) => {
      context.globalAlpha = isCopy ? 0.4 : 1;
      for (let i = 0; i < session.count; i++) drawReference(context, ...this.place(session.row(i)), palette);
    });
  }

  /** The list as one image. @param {Brush} brush */
  dots({ ratio, palette }) {
    const { rows } = this.session.list;
    const { x, y, width, height } = this.inner;
    const places = new Float64Array(rows.length);
    for (let i = 0; i < rows.length; i += 2) {
      const [px, py] = this.place([rows[i], rows[i + 1]]);
      places.set([px - x, py - y], i);
    }
    return dotsImage(places, { width, height, ratio, colour: palette.growth, size: 2.4 });
  }

  /** @param {Brush} brush @override */
  drawTop({ context, palette }) {
    const { session, view, inner } = this;
    if (!session.isAsking) return;
    const { missed, cut, q } = session;
    const { indices } = session.found;
    const colourOf = (/** @type {number} */ i) => (session.exact.has(i) ? palette.start : palette.rejected);
    this.repeat(context, () => {
      if (cut !== null) {
        setStroke(context, palette.rejected, 1.4, [7, 5]);
        const [across, up] = this.coordinates;
        if (across.isCircle) drawLine(context, view.x(cut), inner.y, view.x(cut), inner.y + inner.height);
        if (up.isCircle) drawLine(context, inner.x, view.y(cut), inner.x + inner.width, view.y(cut));
      }
      setStroke(context, palette.rejected, 1.2, [3, 4]);
      for (const i of missed) this.drawMotion(context, i, null);
      for (let rank = indices.length - 1; rank >= 0; rank--) {
        setStroke(context, colourOf(indices[rank]), 2 - rank / Math.max(1, indices.length - 1));
        this.drawMotion(context, indices[rank], cut);
      }
      setStroke(context, palette.rejected, 1.6);
      for (const i of missed) ring(context, ...this.place(session.row(i)), 4.6);
      for (const i of indices) {
        context.fillStyle = colourOf(i);
        disc(context, ...this.place(session.row(i)), 3.6);
      }
      drawDot(context, ...this.place(q), palette.robot, palette);
    });
  }

  /**
   * The motion from the target to a configuration.
   * @param {CanvasRenderingContext2D} context
   * @param {number} i
   * @param {number | null} cut
   */
  drawMotion(context, i, cut) {
    const { session } = this;
    const { q } = session;
    const row = session.row(i);
    this.strokeMotion(
      context,
      q,
      this.coordinates.map(({ isCircle }, axis) =>
        cut === null || !isCircle
          ? difference(q[axis], row[axis], isCircle)
          : plain(row[axis], cut) - plain(q[axis], cut),
      ),
    );
  }
}

/** An angle as it is read where the circle is cut at an angle, 0 or pi. @param {number} angle @param {number} cut */
function plain(angle, cut) {
  return cut === 0 ? ((angle % TURN) + TURN) % TURN : wrap(angle);
}
