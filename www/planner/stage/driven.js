/** The drawing of driving: the trace of the car, what stopped it, the rollout of a control, Euler's steps beside it. */
import { obstacleName } from "../../domain/names.js";
import { box, coreOf, middleOf } from "../../domain/obstacles.js";
import { tracePen } from "../../draw/pen.js";
import { drawGhost, drawHit, drawLabel } from "../../draw/shapes.js";
import { Workspace } from "./workspace-pane.js";

/** @import { Lane } from "./lane.js" */
/** @import { Pane } from "./pane.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { View } from "planarium/draw" */
/** @import { Obstacle, Part, Point, ScenarioDocument } from "../../domain/types.js" */

/** Ghosts of a rollout. */
const GHOSTS = 9;

/** Beneath the robot. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
export function drawTrace(pane, context, { shown: { driven, scenario } }) {
  if (!driven) return;
  const palette = /** @type {Palette} */ (pane.palette);
  const { trace, rollout, beside } = driven;
  context.save();
  pane.clip(context);
  context.lineJoin = context.lineCap = "round";
  line(pane, context, trace, palette.stage, 5, []);
  line(pane, context, trace, palette.robot, 2, []);
  if (rollout) {
    line(pane, context, rollout.poses, palette.stage, 5, []);
    line(pane, context, rollout.poses, palette.newest, 2, beside ? [] : [6, 5]);
    const rows = rollout.poses.length / 3;
    const view = /** @type {View} */ (pane.view);
    const style = { colour: palette.newest, fill: 0.06, stroke: 0.7, dash: [], width: 1.2 };
    for (let i = 1; pane instanceof Workspace && i <= GHOSTS; i++) {
      const row = Math.round((i * (rows - 1)) / GHOSTS);
      drawGhost(context, view, scenario.footprint(rollout.poses.subarray(3 * row, 3 * row + 3)), style);
    }
  }
  if (beside) {
    line(pane, context, beside.poses, palette.stage, 5, []);
    line(pane, context, beside.poses, palette.unproven, 2, [6, 5]);
    const end = beside.poses.subarray(-3);
    const style = { colour: palette.unproven, fill: 0.06, stroke: 0.9, dash: [6, 5], width: 1.2 };
    if (pane instanceof Workspace) drawGhost(context, /** @type {View} */ (pane.view), scenario.footprint(end), style);
  }
  context.restore();
}

/** Above the robot. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
export function drawDrive(pane, context, { shown: { driven, document, scenario } }) {
  if (!driven) return;
  const palette = /** @type {Palette} */ (pane.palette);
  const { blocked, rollout, trace, beside } = driven;
  if (beside) {
    // Away from the arc's end.
    const [[x, y], [fromX, fromY]] = [beside.poses, rollout?.poses ?? trace].map((rows) => pane.pixels(rows.slice(-3)));
    const far = Math.hypot(x - fromX, y - fromY);
    const [across, up] = far > 1 ? [(x - fromX) / far, (y - fromY) / far] : [0, -1];
    drawLabel(
      context,
      `Euler, ${beside.dt} s`,
      x + 68 * pane.bold * across,
      y + 26 * pane.bold * up,
      palette.unproven,
      palette,
      pane.bold,
    );
  }
  for (const [what, rows] of /** @type {[typeof blocked, Float64Array][]} */ ([
    [blocked, trace],
    [rollout?.blocked ?? null, rollout?.poses ?? trace],
  ])) {
    if (what === null) continue;
    const pose = rows.slice(rows.length - 3);
    const [x, y] = pane.pixels(pose);
    if (!(pane instanceof Workspace) || what === "near") {
      drawHit(context, x, y, palette);
      continue;
    }
    pane.drawTouched(context, document, what);
    const at = nearest(
      scenario.footprint(pose)[0],
      what === "bounds" ? boxOf(document.world.bounds) : document.world.obstacles[what],
    );
    const [hx, hy] = pane.place(Float64Array.from(at));
    drawHit(context, hx, hy, palette);
    if (what === "bounds") continue;
    const [ox, oy] = middleOf(document.world.obstacles[what]);
    const view = /** @type {View} */ (pane.view);
    const clear = Math.abs(view.y(oy) - hy) < 26 ? hy + (hy > 60 ? -26 : 26) : view.y(oy);
    drawLabel(context, obstacleName(what), view.x(ox), clear, palette.collision, palette, pane.bold);
  }
}

/**
 * Where the outlines of a car and of a thing come nearest to each other, on the thing.
 * @param {Part} part
 * @param {Obstacle} thing
 * @returns {[number, number]}
 */
function nearest(part, thing) {
  const { segments, radius } = coreOf(thing);
  let least = Infinity;
  /** @type {[number, number]} */
  let best = [NaN, NaN];
  /** @param {Point} on  the core of the thing @param {Point} at  the car */
  const offer = (on, at) => {
    const [dx, dy] = [at[0] - on[0], at[1] - on[1]];
    const distance = Math.hypot(dx, dy);
    if (distance >= least) return;
    least = distance;
    const share = radius / (distance || 1);
    best = [on[0] + share * dx, on[1] + share * dy];
  };
  for (const [corner, next] of coreOf(part).segments)
    for (const [a, b] of segments) {
      offer(onSegment(corner, a, b), corner);
      for (const end of [a, b]) offer(end, onSegment(end, corner, next));
    }
  return best;
}

/**
 * The point of a segment nearest to another.
 * @param {Point} point
 * @param {Point} a
 * @param {Point} b
 * @returns {Point}
 */
function onSegment([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return [ax + t * dx, ay + t * dy];
}

/** @param {ScenarioDocument["world"]["bounds"]} bounds */
function boxOf(bounds) {
  const { min, max } = bounds ?? { min: [0, 0], max: [0, 0] };
  return box(min[0], min[1], max[0] - min[0], max[1] - min[1]);
}

/**
 * Poses as a line of the pane.
 * @param {Pane} pane
 * @param {CanvasRenderingContext2D} context
 * @param {Float64Array} rows
 * @param {string} colour
 * @param {number} width
 * @param {number[]} dash
 */
function line(pane, context, rows, colour, width, dash) {
  if (rows.length < 6) return;
  // A pixel or so between two places is fine enough: of long traces only some are drawn.
  const count = rows.length / 3;
  const each = Math.max(1, Math.floor(count / 3000));
  /** @type {number[]} */
  const ends = [];
  for (let i = 0; i + 1 < count; i += each) {
    const to = Math.min(count - 1, i + each);
    ends.push(...rows.subarray(3 * i, 3 * i + 3), ...rows.subarray(3 * to, 3 * to + 3));
  }
  const { points, firsts } = pane.lines(Float64Array.from(ends));
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  tracePen(context, points, 0, firsts[firsts.length - 1]);
  context.stroke();
  context.setLineDash([]);
}
