/**
 * A pane draws a lane on its layers. Workspace and configuration space differ in their ground and in how configurations
 * and motions become pixels.
 */
import { SIDE } from "../run-log/columns.js";
import { Glow } from "./glow.js";
import { Growth, countsOf, motionsAlong } from "./growth.js";
import { disc, ring } from "../../draw/marks.js";
import { strokeLine, tracePen } from "../../draw/pen.js";
import { VertexIndex } from "./vertex-index.js";
import { drawGoal, drawHit, drawStart } from "../../draw/shapes.js";
import { Strobe } from "./strobe.js";

/** @import { Hover, Lane } from "./lane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @import { PathPlayback } from "./path-playback.js" */
/** @import { Brush } from "../../draw/sheet.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { Look } from "../../app/app.js" */
/** @import { Scenario } from "../../domain/types.js" */
/** @import { View } from "planarium/draw" */
/**
 * @typedef {{ points: Float64Array, firsts: Uint32Array }} Lines  line i: pixels x, y in turn, points firsts[i] up to
 *   firsts[i + 1]; NaN lifts the pen
 */

/** What draws Voronoi regions. @type {typeof import("./regions.js").Regions | undefined} */
let Regions;

/** Loads what draws Voronoi regions, for the first view that shows them. */
export async function loadRegions() {
  ({ Regions } = await import("./regions.js"));
}

export class Pane {
  constructor() {
    this.growth = new Growth(this);
    /** The Voronoi regions of a tree, once they are drawn. @type {import("./regions.js").Regions | null} */
    this.regions = null;
    this.glow = new Glow();
    /** @type {Lane | null} */
    this.lane = null;
    /** @type {Palette | null} */
    this.palette = null;
    /** @type {View | null} */
    this.view = null;
    /** Size, CSS pixels. */
    this.width = 0;
    this.height = 0;
    /** Device pixels a CSS pixel. */
    this.ratio = 1;
    /** The time of the frame, milliseconds. */
    this.now = 0;
    /** Scale of dots and lines: 1 on a pane of medium size, less on a small one. */
    this.fineness = 1;
    /** Scale of strong lines, for projectors. */
    this.bold = 1;
    /** @type {CanvasPattern | null} */
    this.hatchOnPart = null;
    /** @type {CanvasPattern | null} */
    this.hatchOnObstacle = null;
    /** @type {{ playback: PathPlayback, lines: Lines } | null} */
    this.pathLines = null;
    /** Thin lines by their configurations. @type {Map<Float64Array, Lines>} */
    this.thinLines = new Map();
    /** @type {Strobe | null} */
    this.flashes = null;
    /** @type {VertexIndex | null} */
    this.found = null;
  }

  // To be overridden by each kind of pane.

  /** Whether it can show a lane. @param {Lane} _lane */
  fits(_lane) {
    return true;
  }
  /** @param {Lane} _lane @param {number} _width @param {number} _height @returns {View} */
  makeView(_lane, _width, _height) {
    throw new Error("a pane must make its view");
  }
  /** @param {CanvasRenderingContext2D} _context @param {Lane} _lane */
  drawGround(_context, _lane) {}
  /** Configurations to pixels. @param {Float64Array} _rows @returns {Float64Array} */
  pixels(_rows) {
    throw new Error("a pane must place configurations");
  }
  /**
   * Motions to lines in pixels.
   * @param {Float64Array} _ends  rows of from, to
   * @param {boolean[]} [_circles]  coordinates whose motions take the shorter way round
   * @returns {Lines}
   */
  lines(_ends, _circles) {
    throw new Error("a pane must trace motions");
  }
  /** Prepares for another scenario. @param {Lane} _lane */
  survey(_lane) {}
  /** The robot, above everything else. @param {CanvasRenderingContext2D} _context @param {Lane} _lane */
  drawRobot(_context, _lane) {}
  /** Requests what the ground still lacks. */
  refine() {}
  /** Whether the ground is complete. */
  get isRefined() {
    return true;
  }
  /** Clips to the border of the picture. @param {CanvasRenderingContext2D} _context */
  clip(_context) {}

  /** What the ground shows. @returns {unknown[]} */
  get groundKey() {
    return [this.lane];
  }

  /** The ground; edges, vertices and marks in the order of the log; the top, which is redrawn each frame. */
  get layers() {
    const { lane } = this;
    return {
      ground: {
        key: this.groundKey,
        draw: (/** @type {Brush} */ { context }) => {
          if (lane) this.drawGround(context, lane);
        },
      },
      ...this.growth.layers,
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** Lays the pane out for its lane. @param {{ width: number, height: number }} size @param {Look} look */
  layout({ width, height }, { palette, ratio, bold }) {
    const { lane } = this;
    Object.assign(this, { width, height, palette, ratio, bold });
    this.view = null;
    if (!lane || width < 1 || height < 1 || !this.fits(lane)) return;
    this.view = this.makeView(lane, width, height);
    this.fineness = Math.min(1.5, Math.max(0.72, Math.min(width, height) / 460)) * bold;
    this.forget();
    this.survey(lane);
    this.growth.restart(countsOf(lane.run));
  }

  /** Shows another lane with the same view while the world is edited. @param {Lane} lane */
  refresh(lane) {
    this.lane = lane;
    this.survey(lane);
    this.restart();
  }

  /** Before a frame is drawn. @param {number} now */
  follow(now) {
    this.now = now;
    this.growth.follow();
  }

  /** A new run on the same ground. */
  restart() {
    this.forget();
    this.growth.restart();
  }

  /** Drops what was computed for another layout or run. */
  forget() {
    this.glow.clear();
    this.pathLines = this.flashes = this.found = null;
    this.thinLines.clear();
  }

  /** The index of vertices in pixels; null without a run or a view. @returns {VertexIndex | null} */
  get places() {
    const run = this.lane?.run;
    if (!run || !this.view) return null;
    if (this.found?.run !== run) this.found = new VertexIndex(this, run);
    return this.found;
  }

  /** @param {number} side */
  sideColour(side) {
    const palette = /** @type {Palette} */ (this.palette);
    if (side === SIDE.start) return palette.start;
    return side === SIDE.goal ? palette.goal : palette.growth;
  }

  /** Draws the top: glow, path, marks, robot. @param {Brush} brush */
  drawTop({ context, palette, hatch }) {
    const { lane, view, now } = this;
    if (!lane || !view) return;
    this.hatchOnPart = hatch(palette.stage);
    this.hatchOnObstacle = hatch(palette.collision);
    context.save();
    this.clip(context);
    if (lane.shown.view.regions) this.drawRegions(context, lane);
    lane.shown.certifying?.draw(this, context, lane);
    this.drawWaiting(context, lane, palette);
    this.glow.draw(context, palette, now);
    if (lane.run?.pieces && !lane.asked) this.drawPieces(context, lane.run, palette);
    if (lane.still) this.growth.drawLatest(context);
    this.drawInformed(context, lane, palette);
    lane.shown.room?.drawUnder(this, context, lane);
    if (lane.playback) this.drawPath(context, lane.playback, palette);
    else if (lane.run) this.drawBest(context, lane.run, palette);
    if (lane.optimum && lane.shown.view.optimum) this.drawThin(context, lane.optimum.rows, palette.ink, [7, 4]);
    lane.shown.room?.drawOver(this, context, lane);
    context.restore();
    lane.shown.judged?.drawUnder(this, context, lane);
    this.drawEnds(context, lane, palette);
    const { hover } = lane.shown;
    if (hover?.lane === lane) this.drawHover(context, hover, palette);
    lane.shown.driven?.drawUnder(this, context, lane);
    this.drawRobot(context, lane);
    lane.shown.judged?.drawOver(this, context, lane);
    lane.shown.driven?.drawOver(this, context, lane);
    lane.shown.overlay?.draw(this, context, lane);
  }

  /** Whether each point of the pane is one configuration. @param {Scenario} scenario */
  isPlaneOf({ robot }) {
    return robot === "disc";
  }

  /**
   * The Voronoi regions of a tree, where each point of the pane is one configuration.
   * @param {CanvasRenderingContext2D} context
   * @param {Lane} lane
   */
  drawRegions(context, lane) {
    const { view } = this;
    if (!view || !Regions || !this.isPlaneOf(lane.scenario)) return;
    const { min, max } = lane.scenario.robot === "disc" ? lane.scenario.extent() : view.box;
    const image = (this.regions ??= new Regions()).image(lane, { min, max }, lane.scenario.circles());
    if (!image) return;
    context.save();
    context.imageSmoothingEnabled = false;
    context.drawImage(
      image,
      view.x(min[0]),
      view.y(max[1]),
      (max[0] - min[0]) * view.scaleX,
      (max[1] - min[1]) * view.scaleY,
    );
    context.restore();
  }

  /**
   * In a roadmap without a path: the connected components of start and goal.
   * @param {CanvasRenderingContext2D} context
   * @param {RunLog} run
   * @param {Palette} palette
   */
  drawPieces(context, { pieces }, palette) {
    const { places } = this;
    if (!pieces || !places) return;
    places.follow();
    context.save();
    // As faint as the growth beneath what is drawn of the room.
    if (this.lane?.shown.room) context.globalAlpha = 0.2;
    for (const [members, colour] of /** @type {[number[], string][]} */ ([
      [pieces.start, palette.start],
      [pieces.goal, palette.goal],
    ])) {
      context.fillStyle = colour;
      for (const vertex of members)
        disc(context, places.points[2 * vertex], places.points[2 * vertex + 1], 3.2 * this.fineness);
    }
    context.restore();
  }

  /**
   * The vertices in the open list of the search, as small rings.
   * @param {CanvasRenderingContext2D} context
   * @param {Lane} lane
   * @param {Palette} palette
   */
  drawWaiting(context, { run }, palette) {
    const { places } = this;
    if (!run || !places || run.frontier.count === 0) return;
    places.follow();
    const radius = 3.4 * this.fineness;
    context.strokeStyle = palette.ink;
    context.lineWidth = 1.1;
    context.beginPath();
    run.frontier.each((vertex) => {
      const [x, y] = [places.points[2 * vertex], places.points[2 * vertex + 1]];
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    });
    context.stroke();
  }

  /**
   * A ring around the configuration under the pointer.
   * @param {CanvasRenderingContext2D} context
   * @param {Hover} hover
   * @param {Palette} palette
   */
  drawHover(context, { pose, check }, palette) {
    const [x, y] = this.pixels(pose);
    for (const [width, colour] of /** @type {[number, string][]} */ ([
      [4.6, palette.stage],
      [1.8, check.free ? palette.ink : palette.collision],
    ])) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      ring(context, x, y, 9);
    }
  }

  /** Configurations along the path, if the view shows them. @param {PathPlayback} playback @returns {Strobe | null} */
  strobe(playback) {
    const { strobe, poses } = /** @type {Lane} */ (this.lane).shown.view;
    if (!strobe) return null;
    if (this.flashes?.playback !== playback || this.flashes.count !== poses)
      this.flashes = new Strobe(this, playback, poses);
    return this.flashes;
  }

  /**
   * Where shorter paths may be, if the pane shows that.
   * @param {CanvasRenderingContext2D} _context
   * @param {Lane} _lane
   * @param {Palette} _palette
   */
  drawInformed(_context, _lane, _palette) {}

  /** The best path so far. @param {CanvasRenderingContext2D} context @param {RunLog} run @param {Palette} palette */
  drawBest(context, run, palette) {
    context.lineCap = "round";
    context.lineWidth = 3.4 * this.bold;
    context.strokeStyle = run.isProven ? palette.path : palette.unproven;
    for (const edge of run.bestEdges) {
      const { points, firsts } = this.growth.linesOf(run, edge, edge + 1);
      strokeLine(context, points, 0, firsts[1]);
    }
  }

  /**
   * A thin line along configurations: the path before shortcutting, or dashed the shortest one.
   * @param {CanvasRenderingContext2D} context
   * @param {Float64Array} rows
   * @param {string} colour
   * @param {number[]} [dash]
   */
  drawThin(context, rows, colour, dash = []) {
    const { dimension } = /** @type {Lane} */ (this.lane).scenario;
    const lines = this.thinLines.get(rows) ?? this.lines(motionsAlong(rows, dimension));
    this.thinLines.set(rows, lines);
    context.save();
    context.lineWidth = 1.5;
    context.lineJoin = "round";
    context.setLineDash(dash);
    context.strokeStyle = colour;
    context.beginPath();
    tracePen(context, lines.points, 0, lines.firsts[lines.firsts.length - 1]);
    context.stroke();
    context.restore();
  }

  /** @param {CanvasRenderingContext2D} context @param {PathPlayback} playback @param {Palette} palette */
  drawPath(context, playback, palette) {
    const { scenario } = playback;
    const { rows, parts } = playback.samples;
    if (this.pathLines?.playback !== playback)
      this.pathLines = { playback, lines: this.lines(motionsAlong(rows, scenario.dimension)) };
    if (playback.raw && /** @type {Lane} */ (this.lane).shown.view.raw)
      this.drawThin(context, playback.raw, palette.path);
    const { lines } = this.pathLines;
    let pieces = 0;
    while (pieces + 1 < parts.length && parts[pieces + 1] <= playback.drawn) pieces++;
    context.save();
    context.lineCap = "round";
    context.lineJoin = "round";
    // A path that is not proven is hollow, and dashed if it misses the goal: colour is not the only sign.
    const colour = this.pathColour(playback);
    /** @type {[number, string, number][]} */
    const strokes = [
      [8 * this.bold, palette.stage, 0.75],
      [(playback.isProven ? 3.4 : 5) * this.bold, colour, 1],
    ];
    if (!playback.isProven) strokes.push([1.8, palette.stage, 1]);
    if (playback.isMiss) context.setLineDash([9, 8]);
    for (const [width, stroke, alpha] of strokes) {
      context.lineWidth = width;
      context.strokeStyle = stroke;
      context.globalAlpha = alpha;
      context.beginPath();
      tracePen(context, lines.points, 0, lines.firsts[pieces]);
      context.stroke();
    }
    context.restore();
    this.strobe(playback)?.draw(context, palette.stage);
    if (playback.flaw && playback.drawn >= playback.flaw.at) {
      const [x, y] = this.pixels(playback.flaw.pose);
      drawHit(context, x, y, palette);
    }
  }

  /** @param {PathPlayback} playback */
  pathColour(playback) {
    const palette = /** @type {Palette} */ (this.palette);
    return playback.isProven ? palette.path : palette.unproven;
  }

  /** Start and goal. @param {CanvasRenderingContext2D} context @param {Lane} lane @param {Palette} palette */
  drawEnds(context, { shown: { start, goals } }, palette) {
    if (start) {
      const [x, y] = this.pixels(Float64Array.from(start));
      drawStart(context, x, y, palette);
    }
    for (const goal of goals) {
      const [x, y] = this.pixels(Float64Array.from(goal));
      drawGoal(context, x, y, palette);
    }
  }
}
