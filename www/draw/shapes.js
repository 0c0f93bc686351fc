/** Paths of obstacles, robot parts and marks in CSS pixels, and how they are inked. */

/** @import { View } from "./view.js" */
/** @import { Obstacle, Part } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** A part thinner than this on the screen is drawn as a line, CSS pixels. */
const THIN = 1.6;

/** @param {Context} context @param {View} view @param {Obstacle} obstacle */
export function obstaclePath(context, view, obstacle) {
  context.beginPath();
  if (obstacle.type === "disc") {
    context.arc(view.x(obstacle.center[0]), view.y(obstacle.center[1]), obstacle.radius * view.scaleX, 0, 2 * Math.PI);
  } else {
    for (const [x, y] of obstacle.vertices) context.lineTo(view.x(x), view.y(y));
    context.closePath();
  }
}

/** @param {Context} context @param {View} view @param {Obstacle[]} obstacles @param {Palette} palette */
export function drawObstacles(context, view, obstacles, palette) {
  context.fillStyle = palette.obstacle;
  context.strokeStyle = palette["obstacle-edge"];
  context.lineWidth = 1;
  context.lineJoin = "round";
  for (const obstacle of obstacles) {
    obstaclePath(context, view, obstacle);
    context.fill();
    context.stroke();
  }
}

/** Is a point inside a polygon? @param {[number, number][]} vertices @param {number} x @param {number} y */
export function contains(vertices, x, y) {
  let inside = false;
  vertices.forEach(([ax, ay], i) => {
    const [bx, by] = vertices[(i + 1) % vertices.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

/** The middle of an obstacle's box, in the plane. @param {Obstacle} obstacle @returns {[number, number]} */
export function obstacleMiddle(obstacle) {
  if (obstacle.type === "disc") return [obstacle.center[0], obstacle.center[1]];
  const xs = obstacle.vertices.map((v) => v[0]);
  const ys = obstacle.vertices.map((v) => v[1]);
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}

/** @param {View} view @param {Part} part */
export function isThin(view, part) { return part.type !== "polygon" && part.radius * view.scaleX < THIN; }

/** The outline of a part; of a thin one its middle line. @param {Context} context @param {View} view @param {Part} part */
export function partPath(context, view, part) {
  if (part.type === "polygon") {
    obstaclePath(context, view, part);
    return;
  }
  const radius = part.radius * view.scaleX;
  context.beginPath();
  if (part.type === "disc") {
    context.arc(view.x(part.center[0]), view.y(part.center[1]), Math.max(radius, 4), 0, 2 * Math.PI);
    return;
  }
  const ax = view.x(part.a[0]);
  const ay = view.y(part.a[1]);
  const bx = view.x(part.b[0]);
  const by = view.y(part.b[1]);
  if (isThin(view, part)) {
    context.moveTo(ax, ay);
    context.lineTo(bx, by);
    return;
  }
  const angle = Math.atan2(by - ay, bx - ax);
  context.arc(ax, ay, radius, angle + Math.PI / 2, angle - Math.PI / 2);
  context.arc(bx, by, radius, angle - Math.PI / 2, angle + Math.PI / 2);
  context.closePath();
}

/** A pose as an outline: where the robot starts, where it should go, where it will pass. @param {Context} context @param {View} view @param {Part[]} parts @param {{ colour: string, fill: number, stroke: number, dash: number[], width: number }} style */
export function drawGhost(context, view, parts, style) {
  context.save();
  context.strokeStyle = context.fillStyle = style.colour;
  context.lineWidth = style.width;
  context.lineCap = "round";
  context.setLineDash(style.dash);
  for (const part of parts) {
    partPath(context, view, part);
    if (!isThin(view, part) || part.type === "disc") {
      context.globalAlpha = style.fill;
      context.fill();
    }
    context.globalAlpha = style.stroke;
    context.stroke();
  }
  context.restore();
}

/** The robot itself. Parts in `touching` are left to `drawTouchingParts`. @param {Context} context @param {View} view @param {Part[]} parts @param {Palette} palette */
export function drawRobot(context, view, parts, palette) {
  context.save();
  context.lineCap = "round";
  context.lineJoin = "round";
  const thin = parts.length > 0 && isThin(view, parts[0]) && parts[0].type === "capsule";
  if (thin) {
    for (const [width, colour] of /** @type {[number, string][]} */ ([[7, palette.stage], [3.4, palette.robot]])) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      for (const part of parts) {
        partPath(context, view, part);
        context.stroke();
      }
    }
  } else {
    context.fillStyle = palette.robot;
    context.strokeStyle = palette["robot-edge"];
    context.lineWidth = 1.2;
    for (const part of parts) {
      partPath(context, view, part);
      context.fill();
      context.stroke();
    }
  }
  for (const part of parts) {
    if (part.type !== "capsule") continue;
    const radius = thin ? 3.6 : Math.max(1.6, 0.34 * part.radius * view.scaleX);
    for (const [x, y] of [part.a, part.b]) {
      context.beginPath();
      context.arc(view.x(x), view.y(y), radius, 0, 2 * Math.PI);
      context.fillStyle = thin ? palette.robot : palette["robot-edge"];
      context.fill();
    }
  }
  context.restore();
}

/** Parts that touch something: red and hatched. @param {Context} context @param {View} view @param {Part[]} parts @param {Palette} palette @param {CanvasPattern | null} hatch */
export function drawTouchingParts(context, view, parts, palette, hatch) {
  context.save();
  context.lineCap = "round";
  for (const part of parts) {
    partPath(context, view, part);
    context.strokeStyle = palette.collision;
    if (part.type === "capsule" && isThin(view, part)) {
      context.lineWidth = 5;
      context.stroke();
      context.strokeStyle = palette.stage;
      context.lineWidth = 2;
      context.setLineDash([1, 6]);
      context.stroke();
      context.setLineDash([]);
      continue;
    }
    context.fillStyle = palette.collision;
    context.fill();
    if (hatch) {
      context.fillStyle = hatch;
      context.fill();
    }
    context.lineWidth = 1.6;
    context.stroke();
  }
  context.restore();
}

/** A ring: the start. @param {Context} context @param {number} x @param {number} y @param {Palette} palette */
export function drawStart(context, x, y, palette) {
  context.save();
  context.beginPath();
  context.arc(x, y, 6.5, 0, 2 * Math.PI);
  context.fillStyle = palette.stage;
  context.fill();
  context.strokeStyle = context.fillStyle = palette.start;
  context.lineWidth = 2.4;
  context.stroke();
  context.beginPath();
  context.arc(x, y, 2.3, 0, 2 * Math.PI);
  context.fill();
  context.restore();
}

/** A ringed cross: here a path collides. @param {Context} context @param {number} x @param {number} y @param {Palette} palette */
export function drawHit(context, x, y, palette) {
  context.save();
  context.lineCap = "round";
  for (const [width, colour] of /** @type {[number, string][]} */ ([[6, palette.stage], [2.4, palette.collision]])) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.moveTo(x - 4, y - 4);
    context.lineTo(x + 4, y + 4);
    context.moveTo(x - 4, y + 4);
    context.lineTo(x + 4, y - 4);
    context.stroke();
  }
  context.restore();
}

/** A diamond: the goal. @param {Context} context @param {number} x @param {number} y @param {Palette} palette */
export function drawGoal(context, x, y, palette) {
  context.save();
  diamond(context, x, y, 8.2);
  context.fillStyle = palette.stage;
  context.fill();
  context.strokeStyle = context.fillStyle = palette.goal;
  context.lineWidth = 2.4;
  context.lineJoin = "round";
  context.stroke();
  diamond(context, x, y, 3);
  context.fill();
  context.restore();
}

/** A ring with four strokes: where the end effector is to be, and which way the last link is to point there. @param {Context} context @param {number} x @param {number} y @param {number | undefined} orientation @param {Palette} palette */
export function drawTarget(context, x, y, orientation, palette) {
  context.save();
  context.lineCap = "round";
  for (const [colour, width] of /** @type {[string, number][]} */ ([[palette.stage, 5], [palette.goal, 2]])) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(x, y, 12, 0, 2 * Math.PI);
    for (let i = 0; i < 4; i++) {
      const [dx, dy] = [Math.cos((i * Math.PI) / 2), Math.sin((i * Math.PI) / 2)];
      context.moveTo(x + 9 * dx, y + 9 * dy);
      context.lineTo(x + 17 * dx, y + 17 * dy);
    }
    if (orientation !== undefined) {
      context.moveTo(x, y);
      context.lineTo(x + 32 * Math.cos(orientation), y - 32 * Math.sin(orientation));
    }
    context.stroke();
  }
  context.restore();
}

/** @param {Context} context @param {number} x @param {number} y @param {number} radius */
function diamond(context, x, y, radius) {
  context.beginPath();
  context.moveTo(x, y - radius);
  context.lineTo(x + radius, y);
  context.lineTo(x, y + radius);
  context.lineTo(x - radius, y);
  context.closePath();
}

/** A word on the stage, with a halo so that it reads on anything. @param {Context} context @param {string} text @param {number} x @param {number} y @param {string} colour @param {Palette} palette */
export function drawLabel(context, text, x, y, colour, palette) {
  context.save();
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 4;
  context.strokeStyle = palette.stage;
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
  context.restore();
}
