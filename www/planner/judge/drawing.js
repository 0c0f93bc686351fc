/**
 * The drawing of a path of another program: solid up to its first contact and dashed after it, its waypoints, the robot
 * where it touches something or has its smallest clearance, and turns that a car cannot drive.
 */
import { obstacleName } from "../../domain/names.js";
import { disc, ring } from "../../draw/marks.js";
import { tracePen } from "../../draw/pen.js";
import { drawGhost, drawHit, drawLabel } from "../../draw/shapes.js";
import { num } from "../../widgets/format.js";
import { Workspace } from "../stage/workspace-pane.js";
import { motionsAlong } from "../stage/growth.js";
import { touchedBy } from "./words.js";

/** @import { Palette } from "../../app/palette.js" */
/** @import { DrawnPath, Judgement } from "../../paths/judging.js" */
/** @import { Lane } from "../stage/lane.js" */
/** @import { Lines, Pane } from "../stage/pane.js" */
/** @import { Trace } from "./trace.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { View } from "planarium/draw" */
/**
 * @typedef {object} Judged
 * @property {DrawnPath} path
 * @property {Judgement} judgement
 * @property {Trace} trace
 * @property {ScenarioDocument} document   the scene in which it was judged
 */
/** @typedef {{ view: View | null, before: Lines, after: Lines, turns: Lines, dots: Float64Array }} Drawn   in pixels of a pane */

/** Waypoints of which each has a dot, at most. */
const DOTS = 300;

/** Draws a path on any pane. */
export class JudgedDrawing {
  /** @param {Judged} judged */
  constructor(judged) {
    this.judged = judged;
    this.dimension = judged.path.rows.length / judged.path.indices.length;
    /** By pane, until it is laid out again. @type {WeakMap<Pane, Drawn>} */
    this.drawn = new WeakMap();
  }

  /** Beneath the robot of the run. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
  drawUnder(pane, context, lane) {
    // Until it is judged in an edited scene, or goes with its robot.
    if (
      lane.shown.document.robot.type !== this.judged.document.robot.type ||
      lane.scenario.dimension !== this.dimension
    )
      return;
    const palette = /** @type {Palette} */ (pane.palette);
    const { before, after, turns, dots } = this.on(pane, lane);
    context.save();
    pane.clip(context);
    context.lineJoin = context.lineCap = "round";
    stroke(context, before, palette.stage, 6 * pane.bold, []);
    stroke(context, after, palette.stage, 6 * pane.bold, []);
    stroke(context, before, palette.ink, 2.4 * pane.bold, []);
    stroke(context, after, palette.ink, 1.6 * pane.bold, [2, 5]);
    stroke(context, turns, palette.rejected, 4 * pane.bold, [1, 6]);
    context.fillStyle = palette.ink;
    for (let i = 0; i < dots.length; i += 2) disc(context, dots[i], dots[i + 1], 2.6 * pane.fineness);
    context.restore();
  }

  /** Above the robot. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
  drawOver(pane, context, lane) {
    // The obstacles of an edited scene may be others.
    if (lane.shown.document !== this.judged.document) return;
    const palette = /** @type {Palette} */ (pane.palette);
    const { contact, clearance } = this.judged.judgement;
    if (contact) this.drawContact(pane, context, lane, contact, palette);
    if (clearance) this.drawClearance(pane, context, lane, clearance, palette);
  }

  /** The lines in pixels of a pane. @param {Pane} pane @param {Lane} lane @returns {Drawn} */
  on(pane, lane) {
    const known = this.drawn.get(pane);
    if (known && known.view === pane.view) return known;
    const { dimension } = lane.scenario;
    const { path, judgement, trace } = this.judged;
    const circles = lane.scenario.circles();
    const linesOf = (/** @type {Float64Array} */ rows) => pane.lines(motionsAlong(rows, dimension), circles);
    const ends = (judgement.turns?.first ?? []).flatMap(({ edge }) => {
      const i = path.indices.findIndex((index) => index > edge);
      return Array.from(path.rows.subarray((i - 1) * dimension, (i + 1) * dimension));
    });
    const drawn = {
      view: pane.view,
      before: linesOf(trace.before),
      after: linesOf(trace.after),
      turns: pane.lines(Float64Array.from(ends), circles),
      dots: path.count <= DOTS ? pane.pixels(path.rows) : new Float64Array(),
    };
    this.drawn.set(pane, drawn);
    return drawn;
  }

  /**
   * The robot at the first contact, what it touches, and where.
   * @param {Pane} pane
   * @param {CanvasRenderingContext2D} context
   * @param {Lane} lane
   * @param {NonNullable<Judgement["contact"]>} contact
   * @param {Palette} palette
   */
  drawContact(pane, context, { scenario, shown }, contact, palette) {
    const pose = Float64Array.from(contact.configuration);
    const obstacle = touchedBy(contact);
    let [x, y] = pane.pixels(pose);
    if (pane instanceof Workspace) {
      const view = /** @type {View} */ (pane.view);
      const style = { colour: palette.collision, fill: 0.16, stroke: 1, dash: [], width: 1.6 };
      drawGhost(context, view, scenario.footprint(pose), style);
      if (obstacle !== null) pane.drawTouched(context, shown.document, obstacle);
      if (contact.point) [x, y] = [view.x(contact.point[0]), view.y(contact.point[1])];
    }
    drawHit(context, x, y, palette);
    const text = obstacle === null ? "" : obstacle === "bounds" ? "bounds" : obstacleName(obstacle);
    drawLabel(context, text, ...besides(pane, text, x, y), palette.collision, palette, pane.bold);
  }

  /**
   * The robot where it is nearest to an obstacle, the nearest point of that and how far away it is.
   * @param {Pane} pane
   * @param {CanvasRenderingContext2D} context
   * @param {Lane} lane
   * @param {NonNullable<Judgement["clearance"]>} clearance
   * @param {Palette} palette
   */
  drawClearance(pane, context, { scenario }, { configuration, point, distance }, palette) {
    const pose = Float64Array.from(configuration);
    let [x, y] = pane.pixels(pose);
    context.save();
    context.strokeStyle = palette.ink;
    context.lineWidth = 1.8;
    if (pane instanceof Workspace) {
      const view = /** @type {View} */ (pane.view);
      const style = { colour: palette.ink, fill: 0.06, stroke: 0.9, dash: [3, 3], width: 1.3 };
      drawGhost(context, view, scenario.footprint(pose), style);
      [x, y] = [view.x(point[0]), view.y(point[1])];
    }
    ring(context, x, y, 5);
    context.restore();
    const text = `${num(distance, 3)} m`;
    drawLabel(context, text, ...besides(pane, text, x, y), palette.ink, palette, pane.bold);
  }
}

/**
 * Where a label is beside a place, within the pane.
 * @param {Pane} pane @param {string} text @param {number} x @param {number} y @returns {[number, number]}
 */
function besides({ width, bold }, text, x, y) {
  const half = 4 * bold * text.length + 6;
  return [Math.min(width - half, Math.max(half, x)), y > 40 * bold ? y - 9 - 13 * bold : y + 9 + 13 * bold];
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Lines} lines
 * @param {string} colour
 * @param {number} width
 * @param {number[]} dash
 */
function stroke(context, { points }, colour, width, dash) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  tracePen(context, points, 0, points.length / 2);
  context.stroke();
}
