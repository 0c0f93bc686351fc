/**
 * Where an informed planner looks: the configurations through which a path may be shorter than the best one. Of a disc
 * that is the inside of an ellipse with the foci start and goal, whose axis is as long as the path.
 */
import { setStroke } from "../../draw/marks.js";
import { PAST } from "../run-log/columns.js";

/** @import { View } from "planarium/draw" */
/** @import { Lane } from "./lane.js" */

/** The planners that draw their samples there. */
const INFORMED = new Set(["informed-rrt-star", "bit-star", "aorrtc"]);

/** Whether a lane shows an ellipse. @param {Lane} lane */
export function isInformed({ run, scenario }) {
  return run !== null && scenario.robot === "disc" && INFORMED.has(run.algorithm) && run.past[PAST.length] < Infinity;
}

/**
 * The ellipse of the iteration shown.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Lane} lane
 * @param {string} colour
 */
export function drawInformed(context, view, lane, colour) {
  const { run } = lane;
  const { start, goal } = lane.shown;
  if (!run || !start || !goal || !isInformed(lane)) return;
  const [dx, dy] = [goal[0] - start[0], goal[1] - start[1]];
  const cost = run.past[PAST.length];
  // The path may be the straight line, or shorter than it by rounding.
  const across = Math.sqrt(Math.max(0, cost * cost - dx * dx - dy * dy));
  context.save();
  setStroke(context, colour, 1.3, [1.5, 3.5]);
  context.globalAlpha = 0.85;
  context.lineCap = "round";
  context.beginPath();
  const [x, y] = [start[0] + dx / 2, start[1] + dy / 2];
  context.ellipse(
    view.x(x),
    view.y(y),
    (cost / 2) * view.scaleX,
    (across / 2) * view.scaleX,
    Math.atan2(-dy, dx),
    0,
    2 * Math.PI,
  );
  context.stroke();
  context.restore();
}
