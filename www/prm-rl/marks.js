/**
 * What both figures draw: the trace of a drive with the mark of its end, and the rays of the sensor. Outcomes differ by
 * colour, dash and mark.
 */
import { partPath } from "planarium/draw";
import { addCross, disc, drawLine, ring, setStroke, strokeWithHalo } from "../draw/marks.js";

/** @import { DriveOutcome, Execution, Navigation, NavigationDocument } from "planarium/full" */
/** @import { View } from "planarium/draw" */
/** @import { Palette } from "../app/palette.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** How each outcome is drawn. @type {Record<DriveOutcome, { colour: keyof Palette, dash: number[] }>} */
const STYLES = {
  reached: { colour: "goal", dash: [] },
  collision: { colour: "collision", dash: [7, 4] },
  swing: { colour: "unproven", dash: [1.5, 4] },
  timeout: { colour: "rejected", dash: [2, 4] },
};

/**
 * The trace of a drive up to a time.
 * @param {Context} context @param {View} view @param {Execution} drive @param {Palette} palette
 * @param {{ rows: number, width: number, alpha: number }} style  `rows`: of the trace, that are drawn
 */
export function drawTrace(context, view, { trace, swing, outcome }, palette, { rows, width, alpha }) {
  const { colour, dash } = STYLES[outcome];
  const count = trace.length / 3;
  const last = Math.min(count, Math.max(1, Math.ceil(rows)));
  context.save();
  context.globalAlpha = alpha;
  context.lineJoin = context.lineCap = "round";
  setStroke(context, palette[colour], width, dash);
  context.beginPath();
  for (let i = 0; i < last; i++) context.lineTo(view.x(trace[3 * i]), view.y(trace[3 * i + 1]));
  context.stroke();
  if (swing.length > 0 && width > 2) {
    // The way of the load.
    setStroke(context, palette.unproven, 1.1, []);
    context.beginPath();
    for (let i = 0; i < last; i++)
      context.lineTo(view.x(trace[3 * i] + swing[2 * i]), view.y(trace[3 * i + 1] + swing[2 * i + 1]));
    context.stroke();
  }
  context.restore();
}

/**
 * The mark at the end of a drive: a dot, a cross, a pendulum, or a clock.
 * @param {Context} context
 * @param {View} view
 * @param {Execution} drive
 * @param {Palette} palette
 */
export function drawOutcome(context, view, { trace, outcome }, palette) {
  const [x, y] = view.place(trace.slice(-3));
  const colour = palette[STYLES[outcome].colour];
  context.save();
  context.setLineDash([]);
  if (outcome === "collision") {
    strokeWithHalo(context, [5, 2.4], colour, palette, () => addCross(context, x, y, 4.4));
  } else if (outcome === "swing") {
    strokeWithHalo(context, [4, 2], colour, palette, () => {
      context.moveTo(x - 3, y - 5);
      context.lineTo(x + 3, y + 3);
    });
    context.fillStyle = colour;
    disc(context, x + 3.6, y + 3.8, 3);
  } else if (outcome === "timeout") {
    context.fillStyle = palette.stage;
    disc(context, x, y, 5.6);
    setStroke(context, colour, 2);
    ring(context, x, y, 4.6);
    drawLine(context, x, y, x, y - 3);
    drawLine(context, x, y, x + 2.2, y);
  } else {
    context.fillStyle = palette.stage;
    disc(context, x, y, 4.6);
    context.fillStyle = colour;
    disc(context, x, y, 3.4);
  }
  context.restore();
}

/**
 * The robot at a pose with a line ahead, and the rays of its sensor: to what they meet, which has a dot, or as far as
 * they reach. A carrier has its load on a rope, within a ring at the limit of swing.
 * @param {Context} context @param {View} view @param {Navigation} task @param {NavigationDocument["robot"]} robot
 * @param {{ pose: [x: number, y: number, theta: number], swing: [x: number, y: number], hasRays: boolean }} state
 * @param {Palette} palette
 */
export function drawRobotAt(context, view, task, robot, { pose, swing, hasRays }, palette) {
  const [x, y, theta] = pose;
  const [px, py] = view.place(pose);
  context.save();
  context.setLineDash([]);
  if (hasRays && robot.sensor) {
    const { rays, field_of_view: width, range } = robot.sensor;
    task.sense(pose).forEach((distance, i) => {
      const angle = theta + width * (i / (rays - 1) - 0.5);
      const [ex, ey] = view.place([x + distance * Math.cos(angle), y + distance * Math.sin(angle)]);
      setStroke(context, palette.newest, 1);
      context.globalAlpha = distance < range ? 0.75 : 0.35;
      drawLine(context, px, py, ex, ey);
      context.globalAlpha = 1;
      context.fillStyle = palette.newest;
      if (distance < range - 1e-9) disc(context, ex, ey, 2.2);
    });
  }
  const part = task.footprint(pose);
  partPath(context, view, part);
  context.fillStyle = palette.robot;
  context.fill();
  setStroke(context, palette.robotEdge, 1.4);
  context.stroke();
  const reach = part.type === "disc" ? part.radius * view.scaleX : 6;
  if (robot.type === "cargo") drawLoad(context, view, robot, pose, swing, palette);
  else drawLine(context, px, py, px + 0.85 * reach * Math.cos(theta), py - 0.85 * reach * Math.sin(theta));
  context.restore();
}

/**
 * The load of a carrier, its rope, and the limit of swing.
 * @param {Context} context @param {View} view @param {Extract<NavigationDocument["robot"], { type: "cargo" }>} robot
 * @param {number[]} carrier @param {number[]} swing @param {Palette} palette
 */
function drawLoad(context, view, { load_radius: radius, swing_limit: limit }, [x, y], [dx, dy], palette) {
  const [px, py] = view.place([x, y]);
  const [lx, ly] = view.place([x + dx, y + dy]);
  setStroke(context, palette.unproven, 1, [3, 3]);
  ring(context, px, py, limit * view.scaleX);
  context.setLineDash([]);
  context.fillStyle = palette.unproven;
  context.globalAlpha = 0.8;
  disc(context, lx, ly, radius * view.scaleX);
  context.globalAlpha = 1;
  setStroke(context, palette.ink, 1.6);
  drawLine(context, px, py, lx, ly);
  context.fillStyle = palette.ink;
  disc(context, px, py, 2.2);
}
