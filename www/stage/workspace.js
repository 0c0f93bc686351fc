/** The workspace: the world as it is, the robot in it, and the end-effector's image of every vertex and edge. */
import { obstacleName, partName } from "../worker/names.js";
import { drawMarked } from "./marked.js";
import { Pane } from "./pane.js";
import { contains, drawGhost, drawLabel, drawObstacles, drawRobot, drawTouchingParts, obstacleMiddle, obstaclePath } from "./shapes.js";
import { Tracer } from "./trace.js";
import { View } from "./view.js";

/** @import { Hover, Lane } from "../worker/lane.js" */
/** @import { Journey } from "../worker/journey.js" */
/** @import { LayerName } from "./layer.js" */
/** @import { Palette } from "./palette.js" */
/** @import { Check, Configuration, Obstacle, Part, ScenarioDocument } from "../types.js" */

const MARGIN = { left: 14, right: 14, top: 14, bottom: 14 };

export class Workspace extends Pane {
  /** @param {Record<LayerName, OffscreenCanvas>} canvases */
  constructor(canvases) {
    super(canvases);
    /** @type {Tracer | null} */
    this.tracer = null;
  }

  /** @param {Lane} lane @param {number} width @param {number} height @override */
  makeView(lane, width, height) {
    return new View(lane.scenario.extent(), width, height, MARGIN, false);
  }

  /** @param {Lane} lane @override */
  survey(lane) { this.tracer = new Tracer(lane.scenario); }

  /** @param {Float64Array} rows @override */
  pixels(rows) {
    return this.place(/** @type {Lane} */ (this.lane).scenario.endEffectors(rows));
  }

  /** @param {Float64Array} ends @param {boolean[]} [circles] @override */
  lines(ends, circles) {
    const { points, firsts } = /** @type {Tracer} */ (this.tracer).curves(ends, circles);
    return { points: this.place(points), firsts };
  }

  /** Points of the plane to pixels, in place. @param {Float64Array} points */
  place(points) {
    const view = /** @type {View} */ (this.view);
    for (let i = 0; i < points.length; i += 2) {
      points[i] = view.x(points[i]);
      points[i + 1] = view.y(points[i + 1]);
    }
    return points;
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @override */
  drawGround(context, lane) {
    const { shown } = lane;
    const { view, palette } = this;
    if (!view || !palette) return;
    const { world, robot } = shown.document;
    this.drawScale(context);
    context.lineWidth = 1;
    if (world.bounds) {
      context.strokeStyle = palette["obstacle-edge"];
      context.lineWidth = 1.5;
      const { min, max } = world.bounds;
      context.strokeRect(view.x(min[0]), view.y(max[1]), (max[0] - min[0]) * view.scaleX, (max[1] - min[1]) * view.scaleY);
    } else if (robot.type === "arm") {
      const reach = robot.links.reduce((sum, link) => sum + link, robot.radius ?? 0);
      context.strokeStyle = palette.line;
      context.setLineDash([2, 5]);
      context.beginPath();
      context.arc(view.x(robot.base[0]), view.y(robot.base[1]), reach * view.scaleX, 0, 2 * Math.PI);
      context.stroke();
      context.setLineDash([]);
    }
    drawObstacles(context, view, world.obstacles, palette);
    const { start, goal, scenario } = shown;
    const thin = "radius" in robot && (robot.radius ?? 0) * view.scaleX < 1.6;
    const width = thin ? 2 : 1.5;
    if (goal) shown.placed?.drawRegion(context, view, goal, shown, palette.goal);
    for (const [pose, colour, fill, dash] of /** @type {[Configuration | null, string, number, number[]][]} */ ([[goal, palette.goal, 0.14, [5, 4]], [start, palette.start, 0.16, []]])) {
      if (!pose) continue;
      drawGhost(context, view, scenario.footprint(pose), { colour, fill, stroke: 0.95, dash, width });
      shown.placed?.drawMarks(context, view, pose, 0, colour);
    }
    if (robot.type === "arm") this.drawBase(context, robot.base);
    drawMarked(this, context, lane);
  }

  /** @param {CanvasRenderingContext2D} context @param {ArrayLike<number>} base */
  drawBase(context, base) {
    const { view, palette } = this;
    if (!view || !palette) return;
    context.beginPath();
    context.arc(view.x(base[0]), view.y(base[1]), 4.5, 0, 2 * Math.PI);
    context.fillStyle = palette.ink;
    context.fill();
    context.beginPath();
    context.arc(view.x(base[0]), view.y(base[1]), 8.5, 0, 2 * Math.PI);
    context.strokeStyle = palette.ink;
    context.lineWidth = 1;
    context.stroke();
  }

  /** A grid of faint dots. @param {CanvasRenderingContext2D} context */
  drawScale(context) {
    const { view, palette } = this;
    if (!view || !palette) return;
    const step = view.grid;
    const [left, bottom] = view.toPlane(0, view.height);
    const [right, top] = view.toPlane(view.width, 0);
    context.fillStyle = palette.line;
    for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
      for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
        context.fillRect(view.x(x) - 0.75, view.y(y) - 0.75, 1.5, 1.5);
      }
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {Journey} journey @param {Palette} palette @override */
  drawPath(context, journey, palette) {
    for (const { part, parts, colour } of this.strobe(journey)?.seen ?? []) {
      if (this.view) drawGhost(context, this.view, parts, { colour, fill: 0.05, stroke: 0.55, dash: [], width: 0.7 + 1.5 * part });
    }
    if (this.view && journey.flaw && journey.drawn >= journey.flaw.at) {
      const style = { colour: palette.collision, fill: 0.3, stroke: 1, dash: [], width: 2 };
      drawGhost(context, this.view, journey.scenario.footprint(journey.flaw.pose), style);
    }
    super.drawPath(context, journey, palette);
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @override */
  drawRobot(context, lane) {
    const { view, palette } = this;
    const { pose } = lane;
    if (!view || !palette || !pose) return;
    const { scenario, hand, check } = lane.shown;
    const parts = scenario.footprint(pose);
    this.drawTouching(context, lane, parts, hand && check ? check.touching : [], () => drawRobot(context, view, parts, palette));
    lane.shown.placed?.drawMarks(context, view, pose, lane.steering, palette["robot-edge"], palette.robot);
  }

  /** The robot at what is pointed at, fine. @param {CanvasRenderingContext2D} context @param {Hover} hover @param {Palette} palette @override */
  drawHover(context, hover, palette) {
    const { view } = this;
    if (!view) return;
    const parts = hover.lane.scenario.footprint(hover.pose);
    const style = { colour: palette.ink, fill: 0.06, stroke: 0.85, dash: [], width: 1.3 };
    const { placed } = hover.lane.shown;
    placed?.drawSwept(this, context, hover, palette);
    this.drawTouching(context, hover.lane, parts, hover.check.touching, () => drawGhost(context, view, parts, style));
    placed?.drawMarks(context, view, hover.pose, hover.motions?.[hover.motions.length - 2] ?? 0, palette.ink);
    super.drawHover(context, hover, palette);
  }

  /** A robot, what it touches, and with which parts, by name. @param {CanvasRenderingContext2D} context @param {Lane} lane @param {Part[]} parts @param {Check["touching"]} touching @param {() => void} draw  the robot */
  drawTouching(context, { shown: { scenario, document } }, parts, touching, draw) {
    const { view, palette } = this;
    if (!view || !palette) return;
    for (const { obstacle } of touching) this.drawTouched(context, document, obstacle);
    draw();
    const hit = new Set(touching.map(({ part }) => part));
    drawTouchingParts(context, view, parts.filter((_, i) => hit.has(i)), palette, this.hatchOnPart);
    for (const index of hit) {
      const [x, y] = labelPlace(view, parts[index]);
      drawLabel(context, partName(scenario, index), x, y, palette.collision, palette);
    }
    const named = new Set();
    for (const { part, obstacle } of touching) {
      if (obstacle === "bounds" || named.has(obstacle)) continue;
      named.add(obstacle);
      const [x, y] = obstaclePlace(view, document.world.obstacles[obstacle], parts[part]);
      drawLabel(context, obstacleName(obstacle), x, y, palette.collision, palette);
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {ScenarioDocument} document @param {number | "bounds"} obstacle */
  drawTouched(context, document, obstacle) {
    const { view, palette } = this;
    if (!view || !palette) return;
    context.save();
    context.strokeStyle = palette.collision;
    context.lineWidth = 2;
    const { bounds, obstacles } = document.world;
    if (obstacle === "bounds") {
      if (bounds) {
        context.setLineDash([8, 5]);
        context.lineWidth = 3;
        context.strokeRect(view.x(bounds.min[0]), view.y(bounds.max[1]), (bounds.max[0] - bounds.min[0]) * view.scaleX, (bounds.max[1] - bounds.min[1]) * view.scaleY);
      }
    } else {
      obstaclePath(context, view, obstacles[obstacle]);
      if (this.hatchOnObstacle) {
        context.fillStyle = this.hatchOnObstacle;
        context.globalAlpha = 0.55;
        context.fill();
        context.globalAlpha = 1;
      }
      context.stroke();
    }
    context.restore();
  }
}

/** Where to name an obstacle: in its middle, or where that is not inside of it, below its vertex nearest to the part. @param {View} view @param {Obstacle} obstacle @param {Part} part @returns {[number, number]} */
function obstaclePlace(view, obstacle, part) {
  const [x, y] = obstacleMiddle(obstacle);
  if (obstacle.type === "disc" || contains(obstacle.vertices, x, y)) return [view.x(x), view.y(y)];
  const [px, py] = part.type === "capsule" ? part.b : obstacleMiddle(part);
  const distance = (/** @type {[number, number]} */ vertex) => Math.hypot(vertex[0] - px, vertex[1] - py);
  const nearest = obstacle.vertices.reduce((best, vertex) => (distance(vertex) < distance(best) ? vertex : best));
  return [view.x(nearest[0]), view.y(nearest[1]) + 26];
}

/** Beside the middle of a part, CSS pixels. @param {View} view @param {Part} part @returns {[number, number]} */
function labelPlace(view, part) {
  if (part.type === "polygon") return [view.x(obstacleMiddle(part)[0]), view.y(Math.max(...part.vertices.map(([, y]) => y))) - 14];
  const clear = part.radius * view.scaleX + 16;
  if (part.type === "disc") return [view.x(part.center[0]), view.y(part.center[1]) - clear];
  const dx = view.x(part.b[0]) - view.x(part.a[0]);
  const dy = view.y(part.b[1]) - view.y(part.a[1]);
  const length = Math.hypot(dx, dy);
  const side = dx >= 0 ? 1 : -1;
  return [view.x(part.a[0]) + dx / 2 + (side * dy * clear * 1.5) / length, view.y(part.a[1]) + dy / 2 - (side * dx * clear) / length];
}
