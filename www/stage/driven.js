/** What a drive adds to the picture: where the car has been, what stopped it, where a control would lead. */
import { obstacleName } from "../worker/names.js";
import { tracePen } from "./pen.js";
import { drawGhost, drawHit, drawLabel, obstacleMiddle } from "./shapes.js";
import { Workspace } from "./workspace.js";

/** @import { Lane } from "../worker/lane.js" */
/** @import { Pane } from "./pane.js" */
/** @import { Palette } from "./palette.js" */
/** @import { View } from "./view.js" */

/** Ghosts of a rollout, about. */
const GHOSTS = 9;

/** Beneath the robot. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
export function drawTrace(pane, context, { shown: { driven, scenario } }) {
  if (!driven) return;
  const palette = /** @type {Palette} */ (pane.palette);
  const { trace, rollout } = driven;
  context.save();
  context.lineJoin = context.lineCap = "round";
  line(pane, context, trace, palette.stage, 5, []);
  line(pane, context, trace, palette.robot, 2, []);
  if (rollout) {
    line(pane, context, rollout.poses, palette.stage, 5, []);
    line(pane, context, rollout.poses, palette.newest, 2, [6, 5]);
    const rows = rollout.poses.length / 3;
    const view = /** @type {View} */ (pane.view);
    const style = { colour: palette.newest, fill: 0.06, stroke: 0.7, dash: [], width: 1.2 };
    for (let i = 1; pane instanceof Workspace && i <= GHOSTS; i++) {
      const row = Math.round((i * (rows - 1)) / GHOSTS);
      drawGhost(context, view, scenario.footprint(rollout.poses.subarray(3 * row, 3 * row + 3)), style);
    }
  }
  context.restore();
}

/** Above the robot. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
export function drawDrive(pane, context, { shown: { driven, document } }) {
  if (!driven) return;
  const palette = /** @type {Palette} */ (pane.palette);
  const { blocked, rollout, trace } = driven;
  for (const [what, rows] of /** @type {[typeof blocked, Float64Array][]} */ ([[blocked, trace], [rollout?.blocked ?? null, rollout?.poses ?? trace]])) {
    if (what === null) continue;
    const [x, y] = pane.pixels(rows.slice(rows.length - 3));
    drawHit(context, x, y, palette);
    if (!(pane instanceof Workspace) || what === "near") continue;
    pane.drawTouched(context, document, what);
    if (what === "bounds") continue;
    const [ox, oy] = obstacleMiddle(document.world.obstacles[what]);
    const view = /** @type {View} */ (pane.view);
    drawLabel(context, obstacleName(what), view.x(ox), view.y(oy), palette.collision, palette);
  }
}

/** Poses as a line of the pane. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Float64Array} rows @param {string} colour @param {number} width @param {number[]} dash */
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
