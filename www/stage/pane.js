/**
 * A pane draws one picture of a lane on its layers. Workspace and configuration space differ in their ground and in how a
 * configuration and a motion become pixels.
 */
import { SIDE } from "../worker/run.js";
import { Glow } from "./glow.js";
import { Growth, countsOf } from "./growth.js";
import { hatch } from "./hatch.js";
import { LAYERS, Layer } from "./layer.js";
import { tracePen } from "./pen.js";
import { drawGoal, drawHit, drawStart } from "./shapes.js";

/** @import { Lane } from "../worker/lane.js" */
/** @import { Journey } from "../worker/journey.js" */
/** @import { LayerName } from "./layer.js" */
/** @import { Palette } from "./palette.js" */
/** @import { View } from "./view.js" */
/** @typedef {{ points: Float64Array, firsts: Uint32Array }} Lines  line i: pixels x, y in turn, points firsts[i] up to firsts[i + 1]; NaN lifts the pen */

export class Pane {
  /** @param {Record<LayerName, OffscreenCanvas>} canvases */
  constructor(canvases) {
    this.layers = /** @type {Record<LayerName, Layer>} */ (Object.fromEntries(LAYERS.map((name) => [name, new Layer(canvases[name])])));
    this.growth = new Growth(this);
    this.glow = new Glow();
    /** @type {Lane | null} */
    this.lane = null;
    /** @type {Palette | null} */
    this.palette = null;
    /** @type {View | null} */
    this.view = null;
    /** Of the sheet, CSS pixels. */
    this.width = 0;
    this.height = 0;
    /** How fine dots and lines are: 1 on a middling sheet, less on a small one. */
    this.fineness = 1;
    /** @type {CanvasPattern | null} */
    this.hatchOnPart = null;
    /** @type {CanvasPattern | null} */
    this.hatchOnObstacle = null;
    /** @type {{ journey: Journey, lines: Lines } | null} */
    this.pathLines = null;
  }

  // What a kind of pane must say of itself.

  /** Can it show this? @param {Lane} _lane */
  fits(_lane) { return true; }
  /** @param {Lane} _lane @param {number} _width @param {number} _height @returns {View} */
  makeView(_lane, _width, _height) { throw new Error("a pane must make its view"); }
  /** Called after each fit, before anything is drawn. @param {Lane} _lane */
  prepare(_lane) {}
  /** @param {CanvasRenderingContext2D} _context @param {Lane} _lane */
  drawGround(_context, _lane) {}
  /** Configurations to pixels. @param {Float64Array} _rows @returns {Float64Array} */
  pixels(_rows) { throw new Error("a pane must place configurations"); }
  /** Motions to lines in pixels. @param {Float64Array} _ends  rows of from, to @param {boolean[]} [_circles]  coordinates whose motions go the short way round @returns {Lines} */
  lines(_ends, _circles) { throw new Error("a pane must trace motions"); }
  /** Called before anything is drawn of another scenario. @param {Lane} _lane */
  survey(_lane) {}
  /** What the editor draws. @param {CanvasRenderingContext2D} _context @param {Lane} _lane */
  drawOverlay(_context, _lane) {}
  /** The robot, above everything else. @param {CanvasRenderingContext2D} _context @param {Lane} _lane */
  drawRobot(_context, _lane) {}
  /** Keeps what crosses the border of the picture inside. @param {CanvasRenderingContext2D} _context */
  clip(_context) {}

  /** Fits the layers to the sheet and draws all anew. @param {Lane} lane @param {Palette} palette @param {number} ratio */
  layout(lane, palette, ratio) {
    this.lane = lane;
    this.palette = palette;
    const { width, height, layers } = this;
    this.view = null;
    if (width < 1 || height < 1 || !this.fits(lane)) return;
    for (const name of LAYERS) layers[name].fit(width, height, ratio);
    this.view = this.makeView(lane, width, height);
    this.fineness = Math.min(1.5, Math.max(0.72, Math.min(width, height) / 460));
    this.hatchOnPart = hatch(layers.top.context, palette.stage, ratio);
    this.hatchOnObstacle = hatch(layers.top.context, palette.collision, ratio);
    this.pathLines = null;
    this.glow.clear();
    this.survey(lane);
    this.prepare(lane);
    this.drawGround(layers.ground.context, lane);
    this.growth.restart(countsOf(lane.run));
  }

  /** The world changes beneath the reader's hand: another ground, on the same view. @param {Lane} lane */
  refresh(lane) {
    this.lane = lane;
    this.layers.ground.clear();
    this.survey(lane);
    this.drawGround(this.layers.ground.context, lane);
    this.restart();
  }

  /** A new run on the same ground. */
  restart() {
    this.glow.clear();
    this.pathLines = null;
    this.growth.restart();
  }

  /** Has everything that is shown been inked? */
  get caughtUp() { return !this.view || this.growth.caughtUp; }

  /** @param {number} now @param {number} until */
  grow(now, until) {
    if (this.view && this.palette) this.growth.ink(now, until);
  }

  /** @param {number} side */
  sideColour(side) {
    const palette = /** @type {Palette} */ (this.palette);
    if (side === SIDE.start) return palette.start;
    return side === SIDE.goal ? palette.goal : palette.growth;
  }

  /** Redraws the top: glow, path, marks, robot. @param {number} now */
  drawTop(now) {
    const { lane, palette, view } = this;
    if (!lane || !palette || !view) return;
    const { context } = this.layers.top;
    this.layers.top.clear();
    context.save();
    this.clip(context);
    this.glow.draw(context, palette, now);
    if (lane.journey) this.drawPath(context, lane.journey, palette);
    context.restore();
    this.drawEnds(context, lane, palette);
    this.drawRobot(context, lane);
    this.drawOverlay(context, lane);
  }

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

  /** Start and goal. @param {CanvasRenderingContext2D} context @param {Lane} lane @param {Palette} palette */
  drawEnds(context, { shown: { start, goal } }, palette) {
    if (start) {
      const [x, y] = this.pixels(Float64Array.from(start));
      drawStart(context, x, y, palette);
    }
    if (goal) {
      const [x, y] = this.pixels(Float64Array.from(goal));
      drawGoal(context, x, y, palette);
    }
  }
}
