/**
 * A pane draws one picture of the run on three layers: the ground, once a layout; the growth, which is only added to as
 * vertices and edges arrive; the top, light enough to be redrawn each frame. Workspace and configuration space differ in
 * their ground and in how a configuration and a motion become pixels.
 */
import { SIDE, EVENT } from "../run.js";
import { Glow } from "./glow.js";
import { hatch } from "./hatch.js";
import { Layer } from "./layer.js";
import { strokeLine, tracePen } from "./pen.js";
import { drawGoal, drawHit, drawStart } from "./shapes.js";

/** @import { Picture } from "./picture.js" */
/** @import { Palette } from "./palette.js" */
/** @import { View } from "./view.js" */
/** @import { Journey } from "../animate.js" */
/** @import { Run } from "../run.js" */
/** @typedef {{ points: Float64Array, firsts: Uint32Array }} Lines  line i: pixels x, y in turn, points firsts[i] up to firsts[i + 1]; NaN lifts the pen */

/** Edges inked before the clock is looked at again. */
const BATCH = 48;
/** Vertices dotted before the clock is looked at again. */
const DOTS = 256;

export class Pane {
  /** @param {HTMLElement} figure  with a `.sheet` inside */
  constructor(figure) {
    this.figure = figure;
    this.sheet = /** @type {HTMLElement} */ (figure.querySelector(".sheet"));
    this.ground = new Layer(this.sheet, "ground");
    this.growth = new Layer(this.sheet, "growth");
    this.top = new Layer(this.sheet, "top");
    this.top.canvas.removeAttribute("aria-hidden");
    this.top.canvas.setAttribute("role", "img");
    this.glow = new Glow();
    /** @type {Picture | null} */
    this.picture = null;
    /** @type {Palette | null} */
    this.palette = null;
    /** @type {View | null} */
    this.view = null;
    /** How fine dots and lines are: 1 on a middling sheet, less on a small one. */
    this.fineness = 1;
    /** @type {CanvasPattern | null} */
    this.hatchOnPart = null;
    /** @type {CanvasPattern | null} */
    this.hatchOnObstacle = null;
    this.drawn = { vertices: 0, edges: 0, expanded: 0, guards: 0 };
    /** What was born before these counts does not glow (it is being redrawn). */
    this.old = { vertices: 0, edges: 0 };
    /** @type {{ journey: Journey, lines: Lines } | null} */
    this.pathLines = null;
  }

  // What a kind of pane must say of itself.

  /** @param {Picture} _picture @param {number} _width @param {number} _height @returns {View} */
  makeView(_picture, _width, _height) { throw new Error("a pane must make its view"); }
  /** @param {CanvasRenderingContext2D} _context @param {Picture} _picture */
  drawGround(_context, _picture) {}
  /** Configurations to pixels. @param {Float64Array} _rows @returns {Float64Array} */
  pixels(_rows) { throw new Error("a pane must place configurations"); }
  /** Motions to lines in pixels. @param {Float64Array} _ends  rows of from, to @param {boolean[]} [_circles]  coordinates whose motions go the short way round @returns {Lines} */
  lines(_ends, _circles) { throw new Error("a pane must trace motions"); }
  /** The robot, above everything else. @param {CanvasRenderingContext2D} _context @param {Picture} _picture */
  drawRobot(_context, _picture) {}

  /** Fits the layers to the sheet and draws all anew. @param {Picture} picture @param {Palette} palette @param {number} ratio */
  layout(picture, palette, ratio) {
    this.picture = picture;
    this.palette = palette;
    const { width, height } = this.sheet.getBoundingClientRect();
    if (width < 1 || height < 1) return;
    for (const layer of [this.ground, this.growth, this.top]) layer.fit(width, height, ratio);
    this.view = this.makeView(picture, width, height);
    this.fineness = Math.min(1.5, Math.max(0.72, Math.min(width, height) / 460));
    this.hatchOnPart = hatch(this.top.context, palette.stage, ratio);
    this.hatchOnObstacle = hatch(this.top.context, palette.collision, ratio);
    this.pathLines = null;
    this.glow.clear();
    this.prepare(picture);
    this.drawGround(this.ground.context, picture);
    this.drawn = { vertices: 0, edges: 0, expanded: 0, guards: 0 };
    this.old = { vertices: picture.run?.vertices.count ?? 0, edges: picture.run?.edges.count ?? 0 };
  }

  /** Called after each fit, before anything is drawn. @param {Picture} _picture */
  prepare(_picture) {}

  /** A new run on the same ground. */
  restart() {
    this.growth.clear();
    this.glow.clear();
    this.pathLines = null;
    this.drawn = { vertices: 0, edges: 0, expanded: 0, guards: 0 };
    this.old = { vertices: 0, edges: 0 };
  }

  /** Has everything grown so far been inked? */
  get caughtUp() {
    const run = this.picture?.run;
    if (!run || !this.view) return true;
    const { drawn } = this;
    return drawn.vertices >= run.vertices.count && drawn.edges >= run.edges.count && drawn.expanded >= run.expanded.count && drawn.guards >= run.guards.count;
  }

  /** Inks what is new, until the clock passes `until`; at least one batch of each. @param {number} now @param {number} until */
  grow(now, until) {
    const run = this.picture?.run;
    if (!run || !this.view || !this.palette) return;
    do { this.growEdges(run, now); } while (this.drawn.edges < run.edges.count && performance.now() < until);
    do { this.growVertices(run, now); } while (this.drawn.vertices < run.vertices.count && performance.now() < until);
    this.growExpanded(run);
    this.growGuards(run);
    this.flash(run, now);
  }

  /** @param {Run} run @param {number} now */
  growEdges(run, now) {
    const first = this.drawn.edges;
    const end = Math.min(run.edges.count, first + BATCH);
    if (end === first) return;
    const n = run.dimension;
    const ends = new Float64Array((end - first) * 2 * n);
    for (let e = first; e < end; e++) {
      const [from, to] = run.edges.row(e);
      ends.set(run.vertices.row(from), (e - first) * 2 * n);
      ends.set(run.vertices.row(to), (e - first) * 2 * n + n);
    }
    const { points, firsts } = this.lines(ends, run.circles);
    const context = this.growth.context;
    context.lineWidth = (run.isTree ? 1.2 : 0.8) * Math.max(0.85, this.fineness);
    context.lineCap = "round";
    context.lineJoin = "round";
    context.globalAlpha = run.isTree ? 0.9 : 0.42;
    let side = -1;
    for (let e = first; e < end; e++) {
      const its = run.sides.data[run.edges.data[2 * e]];
      if (its !== side) {
        side = its;
        context.strokeStyle = this.sideColour(side);
      }
      strokeLine(context, points, firsts[e - first], firsts[e - first + 1]);
    }
    context.globalAlpha = 1;
    this.drawn.edges = end;
    const glowing = Math.max(first, this.old.edges, run.edges.count - this.glow.room("edge"));
    for (let e = glowing; e < end; e++) {
      this.glow.add("edge", now, points.slice(2 * firsts[e - first], 2 * firsts[e - first + 1]));
    }
  }

  /** @param {Run} run @param {number} now */
  growVertices(run, now) {
    const first = this.drawn.vertices;
    const end = Math.min(run.vertices.count, first + DOTS);
    if (end === first) return;
    const points = this.pixels(run.vertices.slice(first, end));
    this.dots(points, run.isTree ? 1.8 : 1.5, (i) => this.sideColour(run.sides.data[first + i]));
    this.drawn.vertices = end;
    const glowing = Math.max(first, this.old.vertices, run.vertices.count - this.glow.room("vertex"));
    for (let v = glowing; v < end; v++) this.glow.add("vertex", now, points.slice(2 * (v - first), 2 * (v - first) + 2));
  }

  /** Vertices that the search has expanded stand out of the roadmap. @param {Run} run */
  growExpanded(run) {
    const first = this.drawn.expanded;
    const end = Math.min(run.expanded.count, first + DOTS);
    if (end === first) return;
    const ink = this.palette?.ink ?? "";
    this.dots(this.pixels(rowsOf(run, run.expanded.slice(first, end))), 2.1, () => ink);
    this.drawn.expanded = end;
  }

  /** Guards of a visibility roadmap stand in a ring; what links them does not. @param {Run} run */
  growGuards(run) {
    const first = this.drawn.guards;
    const end = Math.min(run.guards.count, first + DOTS);
    if (end === first) return;
    const points = this.pixels(rowsOf(run, run.guards.slice(first, end)));
    const context = this.growth.context;
    context.strokeStyle = this.palette?.growth ?? "";
    context.lineWidth = 1.6 * this.fineness;
    for (let i = 0; i < points.length; i += 2) {
      context.beginPath();
      context.arc(points[i], points[i + 1], 5.5 * this.fineness, 0, 2 * Math.PI);
      context.stroke();
    }
    this.drawn.guards = end;
  }

  /** Samples refused flash as crosses, fainter ones where they were free but of no use, edges refused as broken lines. @param {Run} run @param {number} now */
  flash(run, now) {
    const fresh = run.fresh;
    const n = run.dimension;
    const width = run.planner.eventWidth;
    let crosses = this.glow.room("rejected");
    let faint = this.glow.room("discarded");
    let broken = this.glow.room("refused");
    /** @type {number[]} */
    const samples = [];
    /** @type {number[]} */
    const discarded = [];
    /** @type {number[]} */
    const ends = [];
    for (let i = fresh.length - width; i >= 0 && (crosses > 0 || faint > 0 || broken > 0); i -= width) {
      const configuration = fresh.subarray(i + 4, i + 4 + n);
      if (fresh[i] === EVENT.rejected && crosses-- > 0) samples.push(...configuration);
      else if (fresh[i] === EVENT.discarded && faint-- > 0) discarded.push(...configuration);
      else if (fresh[i] === EVENT.refused && fresh[i + 2] >= 0 && broken-- > 0) ends.push(...run.vertices.row(fresh[i + 2]), ...configuration);
    }
    for (const [kind, rows] of /** @type {["rejected" | "discarded", number[]][]} */ ([["rejected", samples], ["discarded", discarded]])) {
      if (rows.length === 0) continue;
      const points = this.pixels(Float64Array.from(rows));
      for (let i = 0; i < points.length; i += 2) this.glow.add(kind, now, points.slice(i, i + 2));
    }
    if (ends.length > 0) {
      const { points, firsts } = this.lines(Float64Array.from(ends), run.circles);
      for (let i = 0; i + 1 < firsts.length; i++) this.glow.add("refused", now, points.slice(2 * firsts[i], 2 * firsts[i + 1]));
    }
  }

  /** @param {Float64Array} points @param {number} radius @param {(index: number) => string} colour */
  dots(points, radius, colour) {
    const context = this.growth.context;
    let current = "";
    for (let i = 0; i < points.length / 2; i++) {
      const wanted = colour(i);
      if (wanted !== current) context.fillStyle = current = wanted;
      context.beginPath();
      context.arc(points[2 * i], points[2 * i + 1], radius * this.fineness, 0, 2 * Math.PI);
      context.fill();
    }
  }

  /** @param {number} side */
  sideColour(side) {
    const palette = /** @type {Palette} */ (this.palette);
    if (side === SIDE.start) return palette.start;
    return side === SIDE.goal ? palette.goal : palette.growth;
  }

  /** Redraws the top: glow, path, marks, robot. @param {number} now */
  drawTop(now) {
    const { picture, palette, view } = this;
    if (!picture || !palette || !view) return;
    const context = this.top.context;
    this.top.clear();
    context.save();
    this.clip(context);
    this.glow.draw(context, palette, now);
    if (picture.journey) this.drawPath(context, picture.journey, palette);
    context.restore();
    this.drawMarks(context, picture, palette);
    this.drawRobot(context, picture);
  }

  /** Keeps what crosses the border of the picture inside. @param {CanvasRenderingContext2D} _context */
  clip(_context) {}

  /** @param {CanvasRenderingContext2D} context @param {Journey} journey @param {Palette} palette */
  drawPath(context, journey, palette) {
    if (this.pathLines?.journey !== journey) {
      const { rows, parts } = journey.samples;
      const n = journey.scenario.dimension;
      const ends = new Float64Array(Math.max(0, parts.length - 1) * 2 * n);
      for (let i = 0; i + 1 < parts.length; i++) ends.set(rows.subarray(i * n, (i + 2) * n), i * 2 * n);
      this.pathLines = { journey, lines: this.lines(ends) };
    }
    const { lines } = this.pathLines;
    const parts = journey.samples.parts;
    let pieces = 0;
    while (pieces + 1 < parts.length && parts[pieces + 1] <= journey.drawn) pieces++;
    context.save();
    context.lineCap = "round";
    context.lineJoin = "round";
    // Without a proof the line is hollow, and broken where it misses the goal: colour is not all that tells.
    const colour = this.pathColour(journey);
    /** @type {[number, string, number][]} */
    const strokes = [[8, palette.stage, 0.75], [journey.isProven ? 3.4 : 5, colour, 1]];
    if (!journey.isProven) strokes.push([1.8, palette.stage, 1]);
    if (journey.isMiss) context.setLineDash([9, 8]);
    for (const [width, stroke, alpha] of strokes) {
      context.lineWidth = width;
      context.strokeStyle = stroke;
      context.globalAlpha = alpha;
      context.beginPath();
      tracePen(context, lines.points, 0, lines.firsts[pieces]);
      context.stroke();
    }
    context.restore();
    if (journey.flaw && journey.drawn >= journey.flaw.at) {
      const [x, y] = this.pixels(journey.flaw.pose);
      drawHit(context, x, y, palette);
    }
  }

  /** @param {Journey} journey */
  pathColour(journey) {
    const palette = /** @type {Palette} */ (this.palette);
    return journey.isProven ? palette.path : palette.unproven;
  }

  /** @param {CanvasRenderingContext2D} context @param {Picture} picture @param {Palette} palette */
  drawMarks(context, picture, palette) {
    if (picture.start) {
      const [x, y] = this.pixels(Float64Array.from(picture.start));
      drawStart(context, x, y, palette);
    }
    if (picture.goal) {
      const [x, y] = this.pixels(Float64Array.from(picture.goal));
      drawGoal(context, x, y, palette);
    }
  }
}

/** The configurations of some vertices, row by row. @param {Run} run @param {Uint32Array} vertices @returns {Float64Array} */
function rowsOf(run, vertices) {
  const rows = new Float64Array(vertices.length * run.dimension);
  vertices.forEach((vertex, i) => rows.set(run.vertices.row(vertex), i * run.dimension));
  return rows;
}
