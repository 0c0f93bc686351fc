/** Entries of the planner's page: each planner is run to the iteration of the entry, or to its end. */
import { VIEW, planned } from "../../domain/page-defaults.js";
import { Scenario } from "planarium";
import { rowsOf } from "../../domain/coordinates.js";
import { keysOf } from "../../domain/key-text.js";
import { withOptions } from "../../domain/option-names.js";
import { playbackOfResult } from "../../planner/stage/path-playback.js";
import { contoursOf, fillContours } from "../../draw/contours.js";
import { setStroke } from "../../draw/marks.js";
import { tracePen } from "../../draw/pen.js";
import { drawLabel } from "../../draw/shapes.js";
import { drawWhole } from "../../draw/sheet.js";
import { encodeLink } from "../../planner/link/codec.js";
import { letter } from "../../planner/race/standings.js";
import { SCENES } from "../../planner/scenes/scenes.js";
import { CSpace } from "../../planner/stage/cspace-pane.js";
import { drawDrive, drawTrace } from "../../planner/stage/driven.js";
import { Placed } from "../../planner/stage/placed.js";
import { Workspace } from "../../planner/stage/workspace-pane.js";
import { CELLS, drawDots, thinned } from "./sheet.js";

/** @import { GeneratorId, Planner } from "planarium" */
/** @import { PathPlayback } from "../../planner/stage/path-playback.js" */
/** @import { Lane, Shown } from "../../planner/stage/lane.js" */
/** @import { Pane } from "../../planner/stage/pane.js" */
/** @import { Plan, Query, ResultDocument, ScenarioDocument, Settings } from "../../domain/types.js" */
/** @import { Brush } from "../../draw/figure.js" */
/** @import { Entry } from "../format.js" */
/** @import { Documents, Opened } from "./open.js" */

/**
 * Most edges drawn as curves of an arm and as lines of another robot, by all planners, and edges and vertices in
 * configuration space.
 */
const MOST = { curves: 320, lines: 900, edges: 320, vertices: 500 };

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
  const most = Math.ceil((scenario.robot === "arm" ? MOST.curves : MOST.lines) / runs.length);
  const workspaces = runs.map((one, i) => {
    const draw = drawingOf(new Workspace(), one, state, most);
    return (/** @type {Brush} */ brush) => {
      draw(brush);
      if (runs.length > 1) drawLabel(brush.context, letter(i), 16, 16, brush.palette.ink, brush.palette, brush.bold);
    };
  });
  const [{ planner }] = runs;
  // A tree of which edges are missing is hard to read.
  const isTree = planner !== null && planner.edgeCount < planner.vertexCount;
  const squares = isFlat ? [drawingOf(new CSpace(), runs[0], state, isTree ? MOST.lines : MOST.edges)] : [];
  return { address, panes: [...workspaces, ...squares] };
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

/**
 * What the stage shows of a run, but for its growth.
 * @param {Run} run
 * @param {PlannerEntry["state"]} state
 * @returns {Shown}
 */
function shownOf({ scenario, document, query, placed, planner }, { view, drive, roll, euler }) {
  const { start = null, goal = null, target = null } = query;
  const goals = goal ? [goal] : [];
  const hit = planner ? null : [start, goal].find((end) => end && !scenario.check(end).free);
  const driven = drive || roll ? drivenOf(scenario, drive, drive?.start ?? start ?? [], roll, euler) : null;
  return /** @type {Shown} */ ({
    ...{ scenario, document, query: query.name, start, goal, goals, target, placed, marked: null, rough: false },
    ...{ hover: null, overlay: null, certifying: null, judged: null, room: null },
    driven: driven && { ...driven, drawUnder: drawTrace, drawOver: drawDrive },
    hand: hit ?? driven?.trace.subarray(-3) ?? null,
    check: hit ? scenario.check(hit) : { free: true, touching: [] },
    view: { ...VIEW, axes: [0, 1], strobe: true, ...(view?.poses ? { poses: view.poses } : {}) },
  });
}

/**
 * What a car has been driven, and the motion of one control from there.
 * @param {Scenario} scenario
 * @param {PlannerEntry["state"]["drive"]} drive
 * @param {ArrayLike<number>} start
 * @param {PlannerEntry["state"]["roll"]} roll
 * @param {number | undefined} dt  of Euler's steps beside it
 */
function drivenOf(scenario, drive, start, roll, dt) {
  const driven = scenario.drive(Float64Array.from(start));
  driven.replay(keysOf(drive?.keys ?? ""), drive?.steps ?? 0);
  const { pose } = driven.state;
  const rolled = roll && scenario.rollout(pose, ...roll);
  const beside = roll && dt && { ...scenario.rollout(pose, ...roll, { integration: "euler", dt }), dt, apart: null };
  const trace = driven.traceSince(0);
  driven.free();
  return { trace, steering: roll?.[1] ?? 0, blocked: null, rollout: rolled ?? null, beside: beside || null };
}

/**
 * A pane of the stage with a run on it; its growth is thinned, for a small file.
 * @param {Pane} pane
 * @param {Run} run
 * @param {PlannerEntry["state"]} state
 * @param {number} most  edges
 * @returns {(brush: Brush) => void}
 */
function drawingOf(pane, run, state, most) {
  const shown = shownOf(run, state);
  const { scenario, planner } = run;
  return (brush) => {
    const { playback } = pathOf(run);
    if (playback) playback.drawn = 1;
    pane.glow.enabled = false;
    pane.lane = /** @type {Lane} */ (
      /** @type {unknown} */ ({
        scenario,
        shown,
        playback,
        run: null,
        pose: shown.hand,
        steering: shown.driven?.steering ?? 0,
      })
    );
    pane.layout(brush, { ...brush, calm: true });
    const { ground, top } = pane.layers;
    const clip = (/** @type {CanvasRenderingContext2D} */ context) => pane.clip(context);
    const growth = { clip, logs: planner ? [{ count: 1, append: () => drawGrowth(brush, pane, planner, most) }] : [] };
    if (pane instanceof CSpace) {
      const cells = scenario.cspace({ width: CELLS, height: CELLS });
      fillContours(brush.context, contoursOf(cells, CELLS), pane.frame(), brush.palette);
    }
    drawWhole({ layers: { ground, growth, top } }, brush);
  };
}

/** Some edges, as one path, and vertices. @param {Brush} brush @param {Pane} pane @param {Planner} planner @param {number} most */
function drawGrowth({ context, palette }, pane, planner, most) {
  const { points, firsts } = pane.lines(Float64Array.from(thinned(edgesOf(planner), most).flat(2)));
  setStroke(context, palette.growth, 0.9);
  context.lineCap = context.lineJoin = "round";
  context.globalAlpha = 0.55;
  context.beginPath();
  const pieces = Array.from(firsts.subarray(1), (end, m) => [...points.subarray(2 * firsts[m], 2 * end), NaN, NaN]);
  const lines = Float64Array.from(pieces.flat());
  tracePen(context, lines, 0, lines.length / 2);
  context.stroke();
  if (!(pane instanceof CSpace)) return;
  const vertices = thinned(rowsOf(planner.verticesSince(0), planner.dimension), MOST.vertices);
  const places = rowsOf(pane.pixels(Float64Array.from(vertices.flatMap((row) => [...row]))), 2);
  drawDots(
    context,
    places.map(([x, y]) => [x, y]),
    palette.growth,
    2.2,
    0.8,
  );
}

/**
 * The path found, or the one to the vertex nearest to the goal.
 * @param {Run} run
 * @returns {{ playback: PathPlayback | null }}
 */
function pathOf({ scenario, placed, settings, result }) {
  const isProven = (settings.edge_check ?? "proven") === "proven" && settings.integration !== "euler";
  if (!result) return { playback: null };
  const { status, approximate } = result;
  if (status === "solved") return { playback: playbackOfResult(scenario, isProven, result, placed) };
  if (!approximate || approximate.path.length < 2) return { playback: null };
  const playback = playbackOfResult(scenario, isProven, { ...result, ...approximate }, placed);
  if (playback) playback.isMiss = true;
  return { playback };
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
