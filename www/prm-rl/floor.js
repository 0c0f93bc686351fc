/**
 * The floor of the part "Plan": the roadmap and the path on the ground; on top start and goal, what is driven, and the
 * robot with its rays.
 */
import { View } from "planarium/draw";
import { NO_VIEW } from "../draw/figure.js";
import { drawGround } from "../draw/ground.js";
import { addLine, drawHandle, setStroke } from "../draw/marks.js";
import { handleAhead } from "../draw/placed-handles.js";
import { drawGoal, drawLabel, drawStart } from "../draw/shapes.js";
import { distanceToSegment } from "../draw/trace.js";
import { drawOutcome, drawRobotAt, drawTrace } from "./marks.js";
import { poseAt, swingAt } from "./session.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { Palette } from "../app/palette.js" */
/** @import { NavigationSession } from "./session.js" */

/** The handle that turns the robot is so far in front of it, CSS pixels. */
const AHEAD = 30;

export class Floor {
  /** @param {NavigationSession} session */
  constructor(session) {
    this.session = session;
    this.view = NO_VIEW;
  }

  get layers() {
    const { part, run, document } = this.session;
    const { edges, refused, vertices } = run;
    // A roadmap of many edges is fainter.
    const isMany = edges.length > 2000;
    return {
      ground: { key: document, draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      roadmap: {
        key: [run, part, isMany],
        logs:
          part === "compare"
            ? []
            : [
                { count: edges.length / 2, append: this.drawEdges.bind(this, edges, false, isMany) },
                { count: refused.length / 2, append: this.drawEdges.bind(this, refused, true, isMany) },
                { count: vertices.length / 2, append: this.drawVertices.bind(this) },
              ],
      },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** Whether the robot is shown on its way: its start cannot be turned then. */
  get isDriven() {
    return this.session.run.drives.length > 0 && this.session.time > 0;
  }

  /**
   * The places of goal, turning handle and start on the canvas.
   * @returns {[name: "start" | "turn" | "goal", x: number, y: number][]}
   */
  get handles() {
    const {
      view,
      session: { start, goal },
    } = this;
    /** @type {["turn", number, number]} */
    const turn = ["turn", ...handleAhead(view, start, AHEAD)];
    return [
      ["start", ...view.place(start)],
      ["goal", ...view.place(goal)],
      ...(this.isDriven || this.session.hasLoad ? [] : [turn]),
    ];
  }

  /** The step of the path at a place, or null. @param {number} x @param {number} y @param {number} near */
  edgeAt(x, y, near) {
    const {
      view,
      session: {
        run: { path, rollouts },
      },
    } = this;
    if (!rollouts) return null;
    const distances = path.slice(1).map((q, i) => distanceToSegment(x, y, view.place(path[i]), view.place(q)));
    const least = Math.min(...distances);
    return least <= near ? distances.indexOf(least) : null;
  }

  /** @param {Brush} brush */
  drawGround({ context, palette, width, height }) {
    const { document } = this.session;
    if (!document?.world.bounds) return;
    this.view = new View(document.world.bounds, width, height);
    drawGround(context, this.view, /** @type {any} */ (document), palette);
  }

  /**
   * Edges of the roadmap.
   * @param {number[]} ends  pairs of vertices
   * @param {boolean} isRefused
   * @param {boolean} isMany
   * @param {Brush} brush
   * @param {number} from
   * @param {number} to
   */
  drawEdges(ends, isRefused, isMany, { context, palette }, from, to) {
    const {
      view,
      session: {
        run: { vertices },
      },
    } = this;
    context.globalAlpha = isMany ? 0.35 : 0.75;
    if (isRefused) setStroke(context, palette.rejected, 0.8, [3, 4]);
    else setStroke(context, palette.growth, isMany ? 0.8 : 1.3);
    context.beginPath();
    for (let i = 2 * from; i < 2 * to; i += 2) {
      const [a, b] = [2 * ends[i], 2 * ends[i + 1]];
      addLine(context, view.x(vertices[a]), view.y(vertices[a + 1]), view.x(vertices[b]), view.y(vertices[b + 1]));
    }
    context.stroke();
  }

  /** @param {Brush} brush @param {number} from @param {number} to */
  drawVertices({ context, palette }, from, to) {
    const {
      view,
      session: {
        run: { vertices },
      },
    } = this;
    context.globalAlpha = 0.6;
    context.fillStyle = palette.growth;
    for (let i = 2 * from; i < 2 * to; i += 2)
      context.fillRect(view.x(vertices[i]) - 1, view.y(vertices[i + 1]) - 1, 2, 2);
  }

  /** @param {Brush} brush */
  drawTop({ context, palette, bold }) {
    const { session, view } = this;
    const { task, document, run, start, goal, refusal, time, selected, edge } = session;
    if (!task || !document) return;
    if (session.part === "compare") return this.drawQueries(context, palette);
    this.drawPath(context, palette, bold);
    const timeStep = document.robot.time_step ?? 0.2;
    const rows = time / timeStep + 1;
    run.drives.forEach((drive, i) => {
      if (i !== selected) drawTrace(context, view, drive, palette, { rows, width: 1.4 * bold, alpha: 0.55 });
    });
    const shown = run.drives[selected];
    if (shown) drawTrace(context, view, shown, palette, { rows, width: 2.6 * bold, alpha: 1 });
    drawGoal(context, ...view.place(goal), palette);
    drawStart(context, ...view.place(start), palette);
    // Failures are marked on top of the robot.
    const drawEnds = (/** @type {boolean} */ isReached) => {
      for (const drive of run.drives)
        if (time >= drive.time && isReached === (drive.outcome === "reached"))
          drawOutcome(context, view, drive, palette);
    };
    drawEnds(true);
    const { isDriven } = this;
    /** @type {Parameters<typeof drawRobotAt>[4]} */
    const state =
      isDriven && shown
        ? { pose: poseAt(shown, time, timeStep), swing: swingAt(shown, time, timeStep), hasRays: true }
        : {
            pose: [start[0], start[1], session.hasLoad ? Math.atan2(goal[1] - start[1], goal[0] - start[0]) : start[2]],
            swing: [0, 0],
            hasRays: true,
          };
    drawRobotAt(context, view, task, document.robot, state, palette);
    drawEnds(false);
    for (const [handle, x, y] of this.handles) if (handle === "turn") drawHandle(context, x, y, palette.start, palette);
    if (refusal) {
      const [x, y] = view.place(refusal.end === "start" ? start : goal);
      drawLabel(context, "in collision", x, y - 9 - 13 * bold, palette.collision, palette, bold);
    }
    if (edge !== null && run.rollouts?.[edge] && run.path[edge + 1]) {
      const [a, b] = [run.path[edge], run.path[edge + 1]].map((q) => view.place(q));
      const { of, forward, backward } = run.rollouts[edge];
      const [x, y] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
      const half = 122 * bold;
      drawLabel(
        context,
        `rollouts: ${forward} of ${of} there, ${backward} of ${of} back`,
        Math.min(view.width - half, Math.max(half, x)),
        y < 40 * bold ? y + 7 + 13 * bold : y - 5 - 13 * bold,
        palette.ink,
        palette,
        bold,
      );
    }
  }

  /**
   * The queries of the comparison, from start to goal.
   * @param {CanvasRenderingContext2D} context
   * @param {Palette} palette
   */
  drawQueries(context, palette) {
    const {
      view,
      session: {
        comparison: { queries, executions, status },
      },
    } = this;
    const current = status === "over" ? -1 : (executions.at(-1)?.query ?? -1);
    queries.forEach(({ start, goal }, i) => {
      context.globalAlpha = i === current ? 1 : 0.4;
      setStroke(context, palette.growth, i === current ? 2.4 : 1, [4, 4]);
      context.beginPath();
      addLine(context, ...view.place(start), ...view.place(goal));
      context.stroke();
    });
    context.globalAlpha = 1;
    context.setLineDash([]);
    for (const { start, goal } of queries) {
      drawStart(context, ...view.place(start), palette);
      drawGoal(context, ...view.place(goal), palette);
    }
  }

  /**
   * The path: a learned one has the colour of what is not proven.
   * @param {CanvasRenderingContext2D} context
   * @param {Palette} palette
   * @param {number} bold  scale of strong lines
   */
  drawPath(context, palette, bold) {
    const {
      view,
      session: {
        run: { path },
        way,
        edge,
      },
    } = this;
    if (path.length < 2) return;
    if (way === "policy") {
      // It is no plan: only where the goal lies.
      setStroke(context, palette.quiet, 1, [2, 5]);
      context.beginPath();
      addLine(context, ...view.place(path[0]), ...view.place(path[1]));
      context.stroke();
      context.setLineDash([]);
      return;
    }
    const isProven = way !== "prm-rl";
    const colour = isProven ? palette.path : palette.unproven;
    context.save();
    context.lineCap = context.lineJoin = "round";
    if (edge !== null && path[edge + 1]) {
      setStroke(context, palette.halo, 10);
      context.globalAlpha = 0.6;
      context.beginPath();
      addLine(context, ...view.place(path[edge]), ...view.place(path[edge + 1]));
      context.stroke();
      context.globalAlpha = 1;
    }
    setStroke(context, palette.stage, 5.5 * bold, []);
    const trace = () => {
      context.beginPath();
      for (const q of path) context.lineTo(...view.place(q));
      context.stroke();
    };
    trace();
    setStroke(context, colour, 3 * bold, isProven ? [] : [9, 5]);
    trace();
    context.setLineDash([]);
    context.fillStyle = colour;
    for (const q of path.slice(1, -1)) {
      context.beginPath();
      context.arc(...view.place(q), 3.6, 0, 2 * Math.PI);
      context.fill();
    }
    context.restore();
  }
}
