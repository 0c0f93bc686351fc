/**
 * Draws the log of a run on the layers of a pane, up to the iteration that is shown. Forward it adds what is new; after
 * a jump it starts from the nearest snapshot. Each layer is drawn in the order of the log, one mark at a time, so that
 * the picture of an iteration is the same to the pixel however it was reached.
 */
import { errorInfo } from "../../app/error-info.js";
import { difference } from "planarium/draw";
import { EVENT, PAST } from "../run-log/columns.js";
import { cross, disc, ring, setStroke } from "../../draw/marks.js";
import { strokeLine } from "../../draw/pen.js";

/** @import { Brush } from "../../draw/sheet.js" */
/** @import { Pane } from "./pane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */

/** Rows drawn between two readings of the clock. */
const BATCH = { edges: 16, vertices: 64, events: 64 };

/** Number of the newest events that flash. */
const FLASHES = 128;

const KINDS = /** @type {const} */ (["edges", "vertices", "events"]);

/** @typedef {{ vertices: number, edges: number, events: number }} Counts */

export class Growth {
  /** @param {Pane} pane */
  constructor(pane) {
    this.pane = pane;
    /** How many times it started from empty layers. */
    this.starts = 0;
    /** The rows, and how many of them are gone, in the frame before. */
    this.seen = countsOf(null);
    this.wereGone = 0;
    /** Rows below these counts do not glow: they are redrawn. */
    this.old = countsOf(null);
  }

  /** Starts from empty layers. @param {Counts} old  rows that do not glow */
  restart(old = countsOf(null)) {
    this.starts++;
    this.seen = this.old = old;
    this.wereGone = this.gone;
  }

  get run() {
    return (this.pane.view && this.pane.lane?.run) ?? null;
  }

  /** Rows to be drawn. @returns {Counts} */
  get target() {
    return countsOf(this.run);
  }

  /** How many vertices are removed, and edges replaced, in what is to be drawn. */
  get gone() {
    const { run, target } = this;
    return run ? run.countOf(EVENT.removed, target.events) + run.countOf(EVENT.rewired, target.events) : 0;
  }

  /** The logs as layers of the pane. */
  get layers() {
    const { run, starts: key, target, gone: revision } = this;
    /** @param {keyof Counts} kind @param {(run: RunLog, brush: Brush, from: number, to: number) => void} draw */
    const log = (kind, draw) => ({
      key,
      jumps: true,
      clip: (/** @type {CanvasRenderingContext2D} */ context) => this.pane.clip(context),
      logs: [
        {
          count: target[kind],
          batch: BATCH[kind],
          append: (/** @type {Brush} */ brush, /** @type {number} */ from, /** @type {number} */ to) =>
            draw.call(this, /** @type {RunLog} */ (run), brush, from, to),
        },
      ],
    });
    return {
      edges: { ...log("edges", this.drawEdges), revision },
      vertices: { ...log("vertices", this.drawVertices), revision },
      marks: log("events", this.drawEvents),
    };
  }

  /** Finds which rows glow, before a frame is drawn: not those that are drawn again. */
  follow() {
    const { target, seen, gone } = this;
    if (KINDS.some((kind) => seen[kind] > target[kind])) {
      this.pane.glow.clear();
      this.old = target;
    }
    if (gone !== this.wereGone) this.old = { ...this.old, edges: seen.edges, vertices: seen.vertices };
    this.seen = target;
    this.wereGone = gone;
  }

  /** @param {RunLog} run @param {Brush} brush @param {number} first @param {number} end */
  drawEdges(run, { context }, first, end) {
    const { pane, gone, target: counts } = this;
    const { points, firsts } = this.linesOf(run, first, end);
    context.lineWidth = (run.isTree ? 1.2 : 0.8) * Math.max(0.85, pane.fineness);
    context.lineCap = "round";
    context.lineJoin = "round";
    context.globalAlpha = run.isTree ? 0.9 : 0.42;
    let side = -1;
    for (let e = first; e < end; e++) {
      if (gone > 0 && !run.isEdgeThere(e, counts)) continue;
      const its = run.sides.data[run.edges.data[2 * e]];
      if (its !== side) context.strokeStyle = pane.sideColour((side = its));
      strokeLine(context, points, firsts[e - first], firsts[e - first + 1]);
    }
    const glowing = Math.max(first, this.old.edges, counts.edges - pane.glow.room("edge"));
    for (let e = glowing; e < end; e++)
      pane.glow.add("edge", pane.now, points.slice(2 * firsts[e - first], 2 * firsts[e - first + 1]));
  }

  /**
   * Edges as lines in pixels; curved edges as several segments.
   * @param {RunLog} run
   * @param {number} first
   * @param {number} end
   * @returns {import("./pane.js").Lines}
   */
  linesOf(run, first, end) {
    const n = run.dimension;
    if (run.traces.count === 0) {
      const ends = new Float64Array((end - first) * 2 * n);
      for (let e = first; e < end; e++) {
        const [from, to] = run.edges.row(e);
        ends.set(run.vertices.row(from), (e - first) * 2 * n);
        ends.set(run.vertices.row(to), (e - first) * 2 * n + n);
      }
      return this.pane.lines(ends, run.circles);
    }
    const edges = Array.from({ length: end - first }, (_, i) => motionsAlong(run.along(first + i), n));
    const starts = [0];
    for (const { length } of edges) starts.push(starts[starts.length - 1] + length / (2 * n));
    const ends = new Float64Array(starts[edges.length] * 2 * n);
    edges.forEach((motions, i) => ends.set(motions, starts[i] * 2 * n));
    const { points, firsts } = this.pane.lines(ends, run.circles);
    return { points, firsts: Uint32Array.from(starts, (at) => firsts[at]) };
  }

  /** @param {RunLog} run @param {Brush} brush @param {number} first @param {number} end */
  drawVertices(run, { context }, first, end) {
    const { pane, gone } = this;
    const { vertices, events } = this.target;
    const points = pane.pixels(run.vertices.slice(first, end));
    const radius = (run.isTree ? 1.8 : 1.5) * pane.fineness;
    // The roots have the marks of start and goal, unless a roadmap was asked for another path.
    for (let v = pane.lane?.asked ? first : Math.max(first, run.roots); v < end; v++) {
      if (gone > 0 && !run.isThere(v, events)) continue;
      context.fillStyle = pane.sideColour(run.sides.data[v]);
      disc(context, points[2 * (v - first)], points[2 * (v - first) + 1], radius);
    }
    const glowing = Math.max(first, this.old.vertices, vertices - pane.glow.room("vertex"));
    for (let v = glowing; v < end; v++)
      pane.glow.add("vertex", pane.now, points.slice(2 * (v - first), 2 * (v - first) + 2));
  }

  /**
   * Vertices expanded by the search are dots, guards are rings, rejected samples are crosses, rejected motions are
   * dashed lines up to the collision. Rejected ones flash, and stay if the view shows them.
   * @param {RunLog} run @param {Brush} brush @param {number} first @param {number} end
   */
  drawEvents(run, { context, palette }, first, end) {
    const { pane } = this;
    const { lane, now } = pane;
    if (!lane) return;
    const { data, width } = run.events;
    const keeps = lane.shown.view.refused;
    const points = pane.pixels(this.placesOf(run, first, end));
    const glowing = Math.max(this.old.events, this.target.events - FLASHES);
    const refused = this.refusedLines(run, first, end, keeps ? 0 : pane.glow.enabled ? glowing : end);
    for (let i = first; i < end; i++) {
      const kind = data[i * width];
      const x = points[2 * (i - first)];
      const y = points[2 * (i - first) + 1];
      const glows = i >= glowing && pane.glow.enabled;
      if (kind === EVENT.expanded) {
        // Those belong to the run's own search.
        if (lane.asked) continue;
        context.fillStyle = palette.ink;
        disc(context, x, y, 2.5 * pane.fineness);
      } else if (kind === EVENT.guard) {
        setStroke(context, palette.growth, 1.6 * pane.fineness);
        ring(context, x, y, 5.5 * pane.fineness);
      } else if (kind === EVENT.rejected || kind === EVENT.discarded) {
        if (glows) pane.glow.add(kind === EVENT.rejected ? "rejected" : "discarded", now, Float64Array.of(x, y));
        if (!keeps) continue;
        setStroke(context, palette.rejected, 1.2);
        context.globalAlpha = kind === EVENT.rejected ? 0.75 : 0.35;
        cross(context, x, y, 2.6 * pane.fineness);
        context.globalAlpha = 1;
      } else if (kind === EVENT.refused) {
        const line = refused.get(i);
        if (!line) continue;
        if (glows) pane.glow.add("refused", now, line);
        if (!keeps) continue;
        setStroke(context, palette.rejected, 1, [3, 4]);
        context.globalAlpha = 0.6;
        strokeLine(context, line, 0, line.length / 2);
        context.globalAlpha = 1;
      }
    }
  }

  /** Draws what the shown iteration did, while the run is paused. @param {CanvasRenderingContext2D} context */
  drawLatest(context) {
    const { pane } = this;
    const run = pane.lane?.run;
    const { palette } = pane;
    if (!run || !palette || run.shown === 0) return;
    const before = run.history.row(run.shown - 1);
    const { past } = run;
    const first = { vertices: before[PAST.vertices], edges: before[PAST.edges], events: before[PAST.events] };
    context.save();
    context.lineCap = "round";
    const { points, firsts } = this.linesOf(run, first.edges, past[PAST.edges]);
    setStroke(context, palette.newest, 2.2 * pane.fineness);
    for (let i = 0; i + 1 < firsts.length; i++) strokeLine(context, points, firsts[i], firsts[i + 1]);
    const dots = pane.pixels(run.vertices.slice(first.vertices, past[PAST.vertices]));
    context.fillStyle = palette.newest;
    for (let i = 0; i < dots.length; i += 2) disc(context, dots[i], dots[i + 1], 3.4 * pane.fineness);
    const { data, width } = run.events;
    const places = pane.pixels(this.placesOf(run, first.events, past[PAST.events]));
    const refused = this.refusedLines(run, first.events, past[PAST.events], 0);
    setStroke(context, palette.rejected, 1.6);
    for (let i = first.events; i < past[PAST.events]; i++) {
      const kind = data[i * width];
      if (kind === EVENT.rejected || kind === EVENT.discarded)
        cross(context, places[2 * (i - first.events)], places[2 * (i - first.events) + 1], 3.6 * pane.fineness);
    }
    context.setLineDash([4, 4]);
    for (const line of refused.values()) strokeLine(context, line, 0, line.length / 2);
    context.restore();
  }

  /**
   * The configurations of events: their vertex, or the configuration of the event itself.
   * @param {RunLog} run
   * @param {number} first
   * @param {number} end
   */
  placesOf(run, first, end) {
    const n = run.dimension;
    const { data, width } = run.events;
    const rows = new Float64Array((end - first) * n);
    for (let i = first; i < end; i++) {
      const kind = data[i * width];
      const vertex = data[i * width + 2];
      const at =
        kind === EVENT.expanded || kind === EVENT.guard
          ? run.vertices.row(vertex)
          : data.subarray(i * width + 4, i * width + 4 + n);
      rows.set(at, (i - first) * n);
    }
    return rows;
  }

  /**
   * Lines of rejected motions, from their vertex to the collision, by the number of the event.
   * @param {RunLog} run
   * @param {number} first
   * @param {number} end
   * @param {number} least  older events are left out
   */
  refusedLines(run, first, end, least) {
    const n = run.dimension;
    const { data, width } = run.events;
    /** @type {Map<number, Float64Array>} */
    const lines = new Map();
    /** @type {number[]} */
    const which = [];
    for (let i = Math.max(first, least); i < end; i++)
      if (data[i * width] === EVENT.refused && data[i * width + 2] >= 0) which.push(i);
    if (which.length === 0) return lines;
    const ends = new Float64Array(which.length * 2 * n);
    which.forEach((i, k) => {
      const other = data[i * width + 3];
      ends.set(run.vertices.row(data[i * width + 2]), k * 2 * n);
      ends.set(other >= 0 ? run.vertices.row(other) : data.subarray(i * width + 4, i * width + 4 + n), k * 2 * n + n);
    });
    const hits = run.isDriven ? new Float64Array(which.length).fill(1) : hitsOf(run.planner, ends, 2 * n);
    const { points, firsts } = this.pane.lines(shortened(ends, n, hits, run.circles), run.circles);
    which.forEach((i, k) => lines.set(i, points.slice(2 * firsts[k], 2 * firsts[k + 1])));
    return lines;
  }
}

/** The counts of a run at the iteration shown. @param {RunLog | null} run @returns {Counts} */
export function countsOf(run) {
  if (!run) return { vertices: 0, edges: 0, events: 0 };
  const { past } = run;
  return { vertices: past[PAST.vertices], edges: past[PAST.edges], events: past[PAST.events] };
}

/**
 * The part of each motion before its first collision. The end of a curve that was cut short may lie outside the bounds;
 * the core does not ask about such a motion, and all of it is drawn.
 * @param {Pick<RunLog["planner"], "firstHits">} planner
 * @param {Float64Array} ends
 * @param {number} width  numbers of a motion
 * @returns {Float64Array}
 */
export function hitsOf(planner, ends, width) {
  try {
    return planner.firstHits(ends);
  } catch (error) {
    if (errorInfo(error).code !== "out-of-range") throw error;
    const count = ends.length / width;
    if (count === 1) return Float64Array.of(1);
    const half = width * Math.floor(count / 2);
    return Float64Array.of(
      ...hitsOf(planner, ends.subarray(0, half), width),
      ...hitsOf(planner, ends.subarray(half), width),
    );
  }
}

/** The motions from each row to the next, as rows of from, to. @param {Float64Array} rows @param {number} n */
export function motionsAlong(rows, n) {
  const ends = new Float64Array(Math.max(0, 2 * (rows.length - n)));
  for (let at = 0; at + n < rows.length; at += n) ends.set(rows.subarray(at, at + 2 * n), 2 * at);
  return ends;
}

/**
 * Shortens motions to fractions of themselves, in place.
 * @param {Float64Array} ends
 * @param {number} n
 * @param {Float64Array} parts
 * @param {boolean[]} circles
 */
function shortened(ends, n, parts, circles) {
  for (let m = 0; m < parts.length; m++) {
    for (let j = 0; j < n; j++) {
      const from = ends[2 * n * m + j];
      ends[2 * n * m + n + j] = from + difference(from, ends[2 * n * m + n + j], circles[j]) * parts[m];
    }
  }
  return ends;
}
