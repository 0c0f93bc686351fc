/** Entries of the planner's page: each planner is run to the iteration of the entry, or to its end. */
import { planned } from "../../domain/page-defaults.js";
import { Scenario } from "planarium";
import { View, drawPath, drawRobot, motionCurves } from "planarium/draw";
import { rowsOf } from "../../domain/coordinates.js";
import { keysOf } from "../../domain/key-text.js";
import { withOptions } from "../../domain/option-names.js";
import { playbackOfResult } from "../../domain/path-playback.js";
import { drawBase, drawGround } from "../../draw/ground.js";
import { setStroke } from "../../draw/marks.js";
import { drawGhost, drawGoal, drawLabel, drawStart } from "../../draw/shapes.js";
import { drawTouching } from "../../draw/touching.js";
import { folded, unrolled } from "../../draw/trace.js";
import { encodeLink } from "../../planner/link/codec.js";
import { letter } from "../../planner/race/standings.js";
import { SCENES } from "../../planner/scenes/scenes.js";
import { Placed } from "../../planner/stage/placed.js";
import { drawDots, drawSquare, thinned } from "./sheet.js";

/** @import { GeneratorId, Planner } from "planarium" */
/** @import { PathPlayback } from "../../domain/path-playback.js" */
/** @import { Configuration, Plan, Query, ResultDocument, ScenarioDocument, Settings } from "../../domain/types.js" */
/** @import { Brush } from "../../draw/figure.js" */
/** @import { Entry } from "../format.js" */
/** @import { Documents, Opened } from "./open.js" */

/**
 * Most edges drawn as curves of an arm and as lines of another robot, by all planners, and edges and vertices in
 * configuration space.
 */
const MOST = { curves: 320, lines: 900, edges: 320, vertices: 500 };
/** Configurations along the path, by default. */
const POSES = 8;

/**
 * A run up to an iteration; `planner` is null where the start or the goal is in collision.
 * @typedef {{ scenario: Scenario, document: ScenarioDocument, query: Query, placed: Placed | null, settings: Settings,
 *   planner: Planner | null, result: ResultDocument | null }} Run
 */

/** @typedef {Extract<Entry, { page: "planner" }>} PlannerEntry */

/** @param {PlannerEntry} entry @param {Documents} documents @returns {Promise<Opened>} */
export async function openPlanner({ state, world }, documents) {
  const document = world ? { ...documents.world(world) } : undefined;
  const scenario = document
    ? Scenario.parse(/** @type {ScenarioDocument} */ (/** @type {unknown} */ (document)))
    : scenarioOf(state, documents);
  const runs = state.lanes.map((plan) => run(scenario, /** @type {Plan} */ (plan), state.query, state.iteration));
  const iteration =
    runs.length === 1
      ? (runs[0].planner?.iterations ?? 0)
      : Math.max(...runs.map(({ result }) => result?.stats.clearance_evaluations ?? 0));
  const address = `plan.html#${await encodeLink({ version: 1, view: {}, ...state, document, iteration })}`;
  const isFlat = runs.length === 1 && scenario.robot === "arm" && scenario.dimension === 2;
  const workspaces = runs.map((one, i) => (/** @type {Brush} */ brush) => {
    drawWorkspace(
      brush,
      one,
      Math.ceil((scenario.robot === "arm" ? MOST.curves : MOST.lines) / runs.length),
      state.view?.poses ?? POSES,
    );
    drawDriven(brush, one, state);
    if (runs.length > 1) drawLabel(brush.context, letter(i), 16, 16, brush.palette.ink, brush.palette);
  });
  return {
    address,
    panes: [...workspaces, ...(isFlat ? [(/** @type {Brush} */ brush) => drawSpace(brush, runs[0])] : [])],
  };
}

/**
 * A generated or a built-in scenario.
 * @param {PlannerEntry["state"]} state
 * @param {Documents} documents
 * @returns {Scenario}
 */
function scenarioOf({ scene = "", options = {} }, documents) {
  const made = /^make-(.+)$/.exec(scene)?.[1];
  if (made) return Scenario.generate(/** @type {GeneratorId} */ (made), options);
  const built = SCENES.find(({ id }) => id === scene);
  if (!built) throw new Error(`There is no scene "${scene}".`);
  return built.generate
    ? Scenario.generate(built.generate.kind, { ...built.generate.options, ...options })
    : Scenario.parse(documents.scene(scene));
}

/**
 * Runs a planner of an entry.
 * @param {Scenario} scenario
 * @param {Plan} plan
 * @param {string | undefined} query
 * @param {number} [iteration]  the end where absent
 * @returns {Run}
 */
function run(scenario, { algorithm, settings = {} }, query, iteration = Infinity) {
  const document = scenario.document();
  const { robot, queries } = document;
  const asked = queries.find(({ name }) => name === query) ?? queries[0];
  const placed = robot.type === "rigid_body" || robot.type === "car" ? new Placed(robot) : null;
  const shown = { scenario, document, query: asked, placed, settings };
  const isRefused = [asked.start, asked.goal].some((end) => end && !scenario.check(end).free);
  if (isRefused) return { ...shown, planner: null, result: null };
  const planner = withOptions({ ...planned(algorithm, settings), algorithm, query: asked.name }, (options) =>
    scenario.planner(options),
  );
  while (planner.status === "running" && planner.iterations < iteration)
    planner.step(Math.min(1000, iteration - planner.iterations));
  return { ...shown, planner, result: planner.result() };
}

/** @param {Brush} brush @param {Run} run @param {number} most  edges @param {number} poses */
function drawWorkspace(brush, run, most, poses) {
  const { context, palette, width, height } = brush;
  const {
    scenario,
    document,
    query: { name, start, goal },
    placed,
    planner,
  } = run;
  const view = new View(scenario.extent(), width, height);
  drawGround(context, view, document, palette);
  if (document.robot.type === "arm") drawBase(context, view, document.robot.base, palette);
  if (planner) {
    const { points, firsts } = motionCurves(scenario, Float64Array.from(thinned(edgesOf(planner), most).flat(2)));
    setGrowth(brush);
    for (let m = 0; m + 1 < firsts.length; m++) {
      const at = 2 * firsts[m];
      // A piece that begins where the last one ended goes on with its line.
      const goesOn = m > 0 && points[at] === points[at - 2] && points[at + 1] === points[at - 1];
      for (let i = firsts[m]; i < firsts[m + 1]; i++) {
        if (i > firsts[m]) context.lineTo(...view.place(points.subarray(2 * i)));
        else if (!goesOn) context.moveTo(...view.place(points.subarray(2 * i)));
      }
    }
    context.stroke();
    context.globalAlpha = 1;
  }
  if (goal && placed)
    placed.drawRegion(context, view, goal, /** @type {any} */ ({ document, query: name }), palette.goal);
  for (const [pose, colour, dash] of /** @type {[Configuration | undefined, string, number[]][]} */ ([
    [goal, palette.goal, [5, 4]],
    [start, palette.start, []],
  ])) {
    if (!pose) continue;
    drawGhost(context, view, scenario.footprint(pose), { colour, fill: 0.16, stroke: 0.95, dash, width: 1.6 });
    placed?.drawMarks(context, view, pose, 0, colour);
  }
  if (!planner) {
    const hit = [start, goal].find((end) => end && !scenario.check(end).free);
    if (!hit) return;
    const parts = scenario.footprint(hit);
    const shown = { scenario, world: document.world, parts, touching: scenario.check(hit).touching };
    drawTouching(
      { context, view, palette, onPart: brush.hatch(palette.stage), onObstacle: brush.hatch(palette.collision) },
      shown,
      () => drawRobot(context, view, parts, palette),
    );
    return;
  }
  const { playback, colour, path } = pathOf(run, palette);
  if (playback) {
    for (let i = 1; i <= poses; i++) {
      const part = i / (poses + 1);
      drawGhost(context, view, scenario.footprint(playback.configuration(part)), {
        colour: `color-mix(in oklab, ${palette.goal} ${Math.round(100 * part)}%, ${palette.start})`,
        fill: 0.05,
        stroke: 0.55,
        dash: [],
        width: 0.7 + 1.5 * part,
      });
    }
    if (playback.flaw)
      drawGhost(context, view, scenario.footprint(playback.flaw.pose), {
        colour: palette.collision,
        fill: 0.3,
        stroke: 1,
        dash: [],
        width: 2,
      });
    context.setLineDash(playback.isMiss ? [6, 5] : []);
    drawPath(context, view, scenario, path, { path: colour });
    context.setLineDash([]);
  }
  if (start) drawStart(context, ...view.place(scenario.endEffector(start)), palette);
  if (goal) drawGoal(context, ...view.place(scenario.endEffector(goal)), palette);
}

/**
 * What a car has been driven, and the motion of one control from there.
 * @param {Brush} brush
 * @param {Run} run
 * @param {PlannerEntry["state"]} state
 */
function drawDriven({ context, palette, width, height }, { scenario, query, placed }, { drive, roll, euler }) {
  if (!placed || (!drive && !roll)) return;
  const view = new View(scenario.extent(), width, height);
  const driven = scenario.drive(drive?.start ?? query.start);
  driven.replay(keysOf(drive?.keys ?? ""), drive?.steps ?? 0);
  const from = driven.state.pose;
  /** @type {{ poses: Float64Array, colour: string, dash?: number[] }[]} */
  const lines = [{ poses: driven.traceSince(0), colour: palette.path }];
  if (roll) lines.push({ poses: scenario.rollout(from, ...roll).poses, colour: palette.goal });
  if (roll && euler) {
    const { poses } = scenario.rollout(from, ...roll, { integration: "euler", dt: euler });
    lines.push({ poses, colour: palette.unproven, dash: [6, 5] });
  }
  for (const { poses, colour, dash } of lines) {
    setStroke(context, colour, 3, dash);
    context.lineJoin = "round";
    context.beginPath();
    for (const pose of rowsOf(poses, 3)) context.lineTo(...view.place(pose));
    context.stroke();
    const last = poses.subarray(-3);
    drawGhost(context, view, scenario.footprint(last), { colour, fill: 0.2, stroke: 1, dash: [], width: 1.6 });
    placed.drawMarks(context, view, last, 0, colour);
  }
  driven.free();
}

/** The configuration space of two joints. @param {Brush} brush @param {Run} run */
function drawSpace(brush, run) {
  const { context, palette } = brush;
  const {
    scenario,
    planner,
    query: { start, goal },
  } = run;
  const view = drawSquare(brush, scenario);
  const circles = scenario.circles();
  const place = (/** @type {ArrayLike<number>} */ q) =>
    view.place([0, 1].map((axis) => (circles[axis] ? folded(q[axis]) : q[axis])));
  const line = (/** @type {ArrayLike<number>} */ pair) =>
    unrolled(pair, 0, circles, circles, (x0, y0, x1, y1) => {
      context.moveTo(...view.place([x0, y0]));
      context.lineTo(...view.place([x1, y1]));
    });
  if (planner) {
    setGrowth(brush);
    // A tree of which edges are missing is hard to read.
    const isTree = planner.edgeCount < planner.vertexCount;
    for (const pair of thinned(edgesOf(planner), isTree ? MOST.lines : MOST.edges).flat()) line(pair);
    context.stroke();
    context.globalAlpha = 1;
    drawDots(context, thinned(rowsOf(planner.verticesSince(0), 2), MOST.vertices).map(place), palette.growth, 2.2, 0.8);
    const {
      path: { path },
      colour,
      playback,
    } = pathOf(run, palette);
    setStroke(context, colour, 3.4, playback?.isMiss ? [6, 5] : []);
    context.lineCap = context.lineJoin = "round";
    context.beginPath();
    path.slice(1).forEach((q, i) => line([...path[i], ...q]));
    context.stroke();
    context.setLineDash([]);
  }
  if (start) drawStart(context, ...place(start), palette);
  if (goal) drawGoal(context, ...place(goal), palette);
}

/** Begins a path of edges. @param {Brush} brush */
function setGrowth({ context, palette }) {
  setStroke(context, palette.growth, 0.9);
  context.lineCap = context.lineJoin = "round";
  context.globalAlpha = 0.55;
  context.beginPath();
}

/**
 * The path found, or the one to the vertex nearest to the goal.
 * @param {Run} run
 * @param {Brush["palette"]} palette
 * @returns {{ playback: PathPlayback | null, path: Pick<ResultDocument, "path" | "motions" | "blends">, colour: string
 *   }}
 */
function pathOf({ scenario, placed, settings, result }, palette) {
  const isProven = (settings.edge_check ?? "proven") === "proven" && settings.integration !== "euler";
  const colour = isProven ? palette.path : palette.unproven;
  if (!result) return { playback: null, path: { path: [] }, colour };
  const { status, approximate } = result;
  if (status === "solved")
    return { playback: playbackOfResult(scenario, isProven, result, placed), path: result, colour };
  if (!approximate || approximate.path.length < 2) return { playback: null, path: { path: [] }, colour };
  const playback = playbackOfResult(scenario, isProven, { ...result, ...approximate }, placed);
  if (playback) playback.isMiss = true;
  return { playback, path: approximate, colour };
}

/** The straight pieces of every edge, each by its ends. @param {Planner} planner @returns {number[][][]} */
function edgesOf(planner) {
  const n = planner.dimension;
  const [vertices, edges, traces] = [planner.verticesSince(0), planner.edgesSince(0), planner.tracesSince(0)];
  /** The points of each curved edge. @type {Map<number, number[][]>} */
  const curved = new Map();
  for (const row of rowsOf(traces, n + 1)) curved.set(row[0], [...(curved.get(row[0]) ?? []), [...row.subarray(1)]]);
  return rowsOf(/** @type {any} */ (edges), 2).map(([from, to], i) => {
    const points = curved.get(i) ?? [from, to].map((vertex) => [...vertices.subarray(vertex * n, (vertex + 1) * n)]);
    return points.slice(1).map((point, j) => [...points[j], ...point]);
  });
}
