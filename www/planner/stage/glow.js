/**
 * The glow of the last half second: new vertices and edges glow and fade, rejected ones flash. Only the newest few are
 * stored, so the cost of a frame is bounded.
 */

import { cross, disc, setStroke } from "../../draw/marks.js";
import { strokeLine } from "../../draw/pen.js";

/** @import { Palette } from "../../app/palette.js" */

/** Milliseconds until a glow has faded. */
const LIFE = 520;
const MOST = { vertex: 140, edge: 70, rejected: 40, discarded: 40, refused: 30 };

/** @typedef {keyof typeof MOST} GlowKind */
/** @typedef {{ kind: GlowKind, born: number, points: Float64Array }} Spark   `points` in CSS pixels, x and y in turn */

export class Glow {
  constructor() {
    /** @type {Record<GlowKind, Spark[]>} */
    this.sparks = { vertex: [], edge: [], rejected: [], discarded: [], refused: [] };
    this.enabled = true;
  }

  /** Sparks of a kind that may be added at once. @param {GlowKind} kind */
  room(kind) {
    return this.enabled ? MOST[kind] : 0;
  }

  /** @param {GlowKind} kind @param {number} born @param {Float64Array} points */
  add(kind, born, points) {
    const list = this.sparks[kind];
    list.push({ kind, born, points });
    if (list.length > MOST[kind]) list.splice(0, list.length - MOST[kind]);
  }

  clear() {
    for (const list of Object.values(this.sparks)) list.length = 0;
  }

  /** Whether anything still glows. */
  get alive() {
    return Object.values(this.sparks).some((list) => list.length > 0);
  }

  /** @param {CanvasRenderingContext2D} context @param {Palette} palette @param {number} now */
  draw(context, palette, now) {
    for (const list of Object.values(this.sparks)) {
      while (list.length > 0 && now - list[0].born > LIFE) list.shift();
    }
    context.save();
    context.lineCap = "round";
    context.lineJoin = "round";
    for (const spark of this.sparks.edge) {
      const left = remaining(spark, now);
      context.globalAlpha = 0.32 * left;
      setStroke(context, palette.halo, 1 + 3.5 * left);
      strokeLine(context, spark.points, 0, spark.points.length / 2);
      context.globalAlpha = 0.8 * left;
      setStroke(context, palette.newest, 1);
      strokeLine(context, spark.points, 0, spark.points.length / 2);
    }
    setStroke(context, palette.rejected, 1, [3, 4]);
    for (const spark of this.sparks.refused) {
      context.globalAlpha = 0.6 * remaining(spark, now);
      strokeLine(context, spark.points, 0, spark.points.length / 2);
    }
    setStroke(context, palette.rejected, 1.4);
    for (const spark of [...this.sparks.discarded, ...this.sparks.rejected]) {
      const [x, y] = spark.points;
      context.globalAlpha = (spark.kind === "rejected" ? 0.9 : 0.4) * remaining(spark, now);
      cross(context, x, y, 3);
    }
    for (const spark of this.sparks.vertex) {
      const left = remaining(spark, now);
      const [x, y] = spark.points;
      context.fillStyle = palette.halo;
      context.globalAlpha = 0.28 * left;
      disc(context, x, y, 3 + 9 * left);
      context.globalAlpha = 0.4 * left;
      disc(context, x, y, 2 + 4 * left);
      context.fillStyle = palette.newest;
      context.globalAlpha = left;
      disc(context, x, y, 1.4 + 1.6 * left);
    }
    context.restore();
  }
}

/** From 1 at birth to 0 when faded. @param {Spark} spark @param {number} now */
function remaining(spark, now) {
  const age = Math.min(1, Math.max(0, (now - spark.born) / LIFE));
  return (1 - age) * (1 - age);
}
