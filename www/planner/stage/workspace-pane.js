/** The workspace: obstacles, the robot, and the positions of its end effector at every vertex and along every edge. */
import { View, drawRobot, motionCurves } from "planarium/draw";
import { drawBase, drawGround } from "../../draw/ground.js";
import { drawInformed } from "./informed.js";
import { drawMarked } from "./marked.js";
import { Pane } from "./pane.js";
import { drawGhost, drawMargin, drawTarget } from "../../draw/shapes.js";
import { drawTouched, drawTouching } from "../../draw/touching.js";

/** @import { Hover, Lane } from "./lane.js" */
/** @import { PathPlayback } from "./path-playback.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { Brush } from "../../draw/touching.js" */
/** @import { Check, Configuration, Part, ScenarioDocument } from "../../domain/types.js" */

export class Workspace extends Pane {
  /** @param {Lane} lane @param {number} width @param {number} height @override */
  makeView(lane, width, height) {
    return new View(lane.shown.window ?? lane.scenario.extent(), width, height);
  }

  /** @param {Float64Array} rows @override */
  pixels(rows) {
    return this.place(/** @type {Lane} */ (this.lane).scenario.endEffectors(rows));
  }

  /** @param {Float64Array} ends @param {boolean[]} [circles] @override */
  lines(ends, circles) {
    const { points, firsts } = motionCurves(/** @type {Lane} */ (this.lane).scenario, ends, circles);
    return { points: this.place(points), firsts };
  }

  /** Converts points of the plane to pixels, in place. @param {Float64Array} points */
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
    const { robot } = shown.document;
    drawGround(context, view, shown.document, palette, shown.world?.map);
    const { start, goal, goals, scenario } = shown;
    const thin = "radius" in robot && (robot.radius ?? 0) * view.scaleX < 1.6;
    const width = thin ? 2 : 1.5;
    if (goal) shown.placed?.drawRegion(context, view, goal, shown, palette.goal);
    for (const [pose, colour, fill, dash] of /** @type {[Configuration | null, string, number, number[]][]} */ ([
      ...goals.map((pose) => [pose, palette.goal, 0.14 / goals.length, [5, 4]]),
      [start, palette.start, 0.16, []],
    ])) {
      if (!pose) continue;
      const parts = scenario.footprint(pose);
      drawMargin(context, view, parts, robot.margin, colour);
      drawGhost(context, view, parts, {
        colour,
        fill,
        stroke: dash.length > 0 && goals.length > 1 ? 0.5 : 0.95,
        dash,
        width,
      });
      shown.placed?.drawMarks(context, view, pose, 0, colour);
    }
    if (robot.type === "arm") drawBase(context, view, robot.base, palette);
    drawMarked(this, context, lane);
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @param {Palette} palette @override */
  drawEnds(context, lane, palette) {
    super.drawEnds(context, lane, palette);
    const { target } = lane.shown;
    if (target && this.view)
      drawTarget(context, this.view.x(target.point[0]), this.view.y(target.point[1]), target.orientation, palette);
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @param {Palette} palette @override */
  drawInformed(context, lane, palette) {
    if (this.view) drawInformed(context, this.view, lane, palette.path);
  }

  /** @param {CanvasRenderingContext2D} context @param {PathPlayback} playback @param {Palette} palette @override */
  drawPath(context, playback, palette) {
    for (const { part, parts, colour } of this.strobe(playback)?.seen ?? []) {
      if (this.view)
        drawGhost(context, this.view, parts, { colour, fill: 0.05, stroke: 0.55, dash: [], width: 0.7 + 1.5 * part });
    }
    if (this.view && playback.flaw && playback.drawn >= playback.flaw.at) {
      const style = { colour: palette.collision, fill: 0.3, stroke: 1, dash: [], width: 2 };
      drawGhost(context, this.view, playback.scenario.footprint(playback.flaw.pose), style);
    }
    super.drawPath(context, playback, palette);
  }

  /** @param {CanvasRenderingContext2D} context @param {Lane} lane @override */
  drawRobot(context, lane) {
    const { view, palette } = this;
    const { pose } = lane;
    if (!view || !palette || !pose) return;
    const { scenario, document, hand, check } = lane.shown;
    const parts = scenario.footprint(pose);
    this.drawTouching(context, lane, parts, hand && check ? check.touching : [], () =>
      drawRobot(context, view, parts, palette, document.robot.margin),
    );
    lane.shown.placed?.drawMarks(context, view, pose, lane.steering, palette.robotEdge, palette.robot);
    const { playback } = lane;
    if (!lane.shown.hand) playback?.timed?.drawHeading(playback.at, context, view, parts[0], palette.robotEdge);
  }

  /**
   * The robot at the configuration under the pointer, in thin lines.
   * @param {CanvasRenderingContext2D} context
   * @param {Hover} hover
   * @param {Palette} palette @override
   */
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

  /**
   * Draws a robot and the obstacles that it touches.
   * @param {CanvasRenderingContext2D} context
   * @param {Lane} lane
   * @param {Part[]} parts
   * @param {Check["touching"]} touching
   * @param {() => void} draw  the robot
   */
  drawTouching(context, { shown }, parts, touching, draw) {
    const { scenario, document } = shown;
    const brush = this.brush(context);
    if (brush) drawTouching(brush, { scenario, world: document.world, parts, touching }, draw);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {ScenarioDocument} document
   * @param {number | "bounds"} obstacle
   */
  drawTouched(context, { world }, obstacle) {
    const brush = this.brush(context);
    if (brush) drawTouched(brush, world, obstacle);
  }

  /** @param {CanvasRenderingContext2D} context @returns {Brush | null} */
  brush(context) {
    const { view, palette, bold, hatchOnPart: onPart, hatchOnObstacle: onObstacle } = this;
    return view && palette && { context, view, palette, bold, onPart, onObstacle };
  }
}
