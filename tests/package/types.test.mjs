/** The declarations: a strict program that uses every name compiles, and nothing in them is `any`. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { root } from "../../scripts/run.mjs";
import { addFiles, install } from "./packed.mjs";

const consumer = `
import init, {
  initSync, planners, generators, phases, eventKinds, historyColumns, randomSeed, neighbourIndexes, solve, version, Drive, Neighbours, PlanariumError, Planner, Scenario,
  type Approximate, type Box, type Check, type Clearance, type Configuration, type CspaceOptions, type DriveKey, type DriveState, type EventKind, type GenerateOptions, type Growth, type PlannerId, type QueryCheck, type ResumeOptions, type GeneratorInfo, type IndexInfo, type NeighboursFound, type NeighboursOptions, type SampleOptions, type InitInput, type InitSyncInput, type KeyPress, type Motion, type Obstacle, type Obstructed,
  type OptionInfo, type ParameterInfo, type Part, type Phase, type PlannerInfo, type PlannerOptions, type Point, type PresetInfo, type PseudocodeLine,
  type PseudocodeMark, type Query, type ResultDocument, type Robot, type Rollout, type ScenarioDocument, type Shape, type Stats, type Status, type Touching, type Weights, type World,
} from "planarium";
import { Problem, type ByClearance, type BySamples, type CoordinateDescription, type ProblemDescription, type SpaceDescription } from "planarium";
import { Scenario as Full, Trajectories, particlePoints, type JudgeOptions, type PathJudgement, type PathVerification, type TimingLimits, type Trajectory, type TrajectoryDocument, type TrajectoryState, type TrajectoryVerification, trajectoryOptions, type ParticleModel, type ParticleMotion, type TrajectoriesResult, type TrajectoryOptions } from "planarium/full";
import { PlannerPool, type PoolOptions, type ProgressOptions, type RemotePlanner, type RunOptions, type Signal, type WorkerGrowth } from "planarium/worker";

type IsAny<T> = 0 extends 1 & T ? true : false;
/** Members that are any, take any or give any back. */
type AnyMembers<C> = { [K in keyof C]-?: IsAny<C[K]> extends true ? K
  : C[K] extends (...args: infer A) => infer R ? IsAny<R> extends true ? K : true extends { [I in keyof A]: IsAny<A[I]> }[number] ? K : never
  : never }[keyof C];
type None<T extends never> = T;
/** Those of several types that have such a member. */
type Loose<T extends unknown[]> = { [I in keyof T]: [AnyMembers<T[I]>] extends [never] ? never : I }[number];
export type Proof = None<Loose<[
  Problem, ProblemDescription, ByClearance, BySamples, CoordinateDescription, SpaceDescription, Drive, DriveState, Rollout, Planner, Scenario, PlanariumError, Stats, ResultDocument, Motion, PresetInfo, Approximate, Weights, Shape,
  Extract<Robot, { type: "car" }>, Extract<Robot, { type: "rigid_body" }>, PlannerInfo, ParameterInfo, ScenarioDocument, World,
  Query, QueryCheck, Growth, Neighbours, NeighboursFound, NeighboursOptions, SampleOptions, IndexInfo, GeneratorInfo, OptionInfo,
  PlannerOptions, GenerateOptions, Trajectories, TrajectoriesResult, TrajectoryOptions, ParticleMotion, PresetInfo["settings"], PlannerPool, PoolOptions, ProgressOptions, RemotePlanner, RunOptions, Signal, WorkerGrowth, {
    init: typeof init, initSync: typeof initSync, planners: typeof planners, input: InitInput | InitSyncInput,
    q: Configuration, phase: (typeof phases)[number], control: Motion["control"][0], vertices: Shape["vertices"],
  },
]>>;
// @ts-expect-error: the proof can fail
export type Disproof = None<Loose<[Stats, { loose(value: any): void }]>>;

export async function inWorkers(signal: Signal, bytes: ArrayBuffer, scenario: Scenario): Promise<string> {
  const made: PoolOptions = { workers: 2, core: bytes };
  using pool = new PlannerPool(made);
  const told: RunOptions & ProgressOptions = { signal, budget: 4, onProgress: ({ iterations }: WorkerGrowth) => void iterations };
  const { path }: ResultDocument = await pool.plan(scenario, { algorithm: "prm", k: 5 }, told);
  let last: ResultDocument | null = null;
  for await (const { vertices, result } of pool.growth(scenario.document())) if (vertices.length > 100) last = result;
  for await (const { edges } of scenario.planner()) if (edges.length > 100) break;
  // @ts-expect-error: an option of another planner
  void pool.plan(scenario, { algorithm: "rrt", samples: 10 });
  using planner: RemotePlanner = await pool.planner(scenario, { algorithm: "prm", k: 5 }, { signal });
  await planner.record();
  const { history, motions, status }: WorkerGrowth = await planner.step(100, { budget: 4 });
  const rows: Float64Array = await planner.historySince(history.length / planner.historyWidth);
  const asked: ResultDocument = await planner.query([0, 0], rows);
  // @ts-expect-error: a pool makes it
  new RemotePlanner();
  pool.terminate();
  return JSON.stringify([path, last, motions, status, asked, (await planner.stats()).vertices]);
}

export function manyTrajectories(): string {
  const model: ParticleModel = trajectoryOptions().length > 0 ? "arc" : "spiral";
  const wanted: TrajectoryOptions = { model, seed: 1, count: 5, index: "none" };
  const trajectories: Trajectories = new Trajectories(wanted);
  const now: Status = trajectories.step(5);
  const rows: Float64Array = trajectories.acceptedSince(0);
  const tries: Uint32Array = trajectories.tries();
  const came: TrajectoriesResult = trajectories.result();
  const motion: ParticleMotion = { v: 1, w: 0 };
  // @ts-expect-error: not a model
  new Trajectories({ model: "line" });
  trajectories[Symbol.dispose]();
  return JSON.stringify([now, rows, tries, came, particlePoints(motion, [0, 1]), new Trajectories().fingerprint]);
}

export function robotOfMyOwn(): string {
  const coordinates: CoordinateDescription[] = [{ kind: "circle", weight: 2 }, { kind: "line", low: 0, high: 1 }];
  const space: SpaceDescription = { coordinates, metric: "sum" };
  const byClearance: ProblemDescription = { space, start: [0, 0], goal: [1, 1], reach: [1, 1], clearance(rows, clearances) { clearances[0] = rows[0] ?? 0; } };
  const bySamples: ProblemDescription = { space, start: [0, 0], goals: [[1, 1]], resolution: 0.1, isFree(rows, free) { free.fill(rows.length); } };
  // @ts-expect-error: nothing tells what is free
  new Problem({ space, start: [0, 0], goal: [1, 1] });
  // @ts-expect-error: a circle has no limits
  new Problem({ ...bySamples, space: { coordinates: [{ kind: "circle", low: 0 }] } });
  const problem: Problem = new Problem(byClearance);
  const planner: Planner = problem.planner({ algorithm: "rrt-star", seed: 1 });
  const status: Status = planner.step(1);
  const failed: Status = "failed";
  problem.free();
  return JSON.stringify([problem.dimension, status, failed, solve(new Problem(bySamples)).edge_check]);
}

export async function program(bytes: ArrayBuffer): Promise<string> {
  await init();
  await init("https://example.org/planarium_bg.wasm");
  await init({ module_or_path: bytes });
  initSync({ module: bytes });
  const input: InitInput = new Uint8Array(bytes);
  await init(input);

  const document: ScenarioDocument = {
    format: "planarium-scenario-1", name: "n", world: { obstacles: [{ type: "disc", center: [0, 1], radius: 1 }] },
    robot: { type: "arm", base: [0, 0], links: [1, 1] }, queries: [{ name: "q", start: [0, 0], goal: [1, 1] }],
  };
  const scenario: Scenario = Scenario.parse(document);
  const generated: Scenario = Scenario.generate("forest", { seed: randomSeed(), links: 3 });
  const q: Configuration = [0, 0];
  const { free, touching }: Check = scenario.check(q);
  const closest: Clearance | null = scenario.clearance(q);
  const names: (number | "bounds")[] = touching.map((pair: Touching) => pair.obstacle);
  const parts: Part[] = scenario.footprint(new Float64Array(2));
  const radii: number[] = parts.map((part) => part.type === "polygon" ? part.vertices[0]?.[0] ?? 0 : (part.type === "capsule" ? part.a[0] : part.center[0]) + part.radius);
  const box: Box = scenario.extent();
  const tip: Point = scenario.endEffector(q);
  const tips: Float64Array = scenario.endEffectors(new Float64Array(4));
  const half: Float64Array = scenario.interpolate(q, [1, 1], 0.5, "sign-of-difference");
  const hit: number | null = scenario.firstHit(q, half);
  const { valid, why, clearance }: PathVerification = Full.parse(document).verify(solve(scenario));
  const limits: TimingLimits = { speed: [1, 2], acceleration: 2 };
  const timing: Trajectory = Full.parse(document).time(solve(scenario), limits, { verify: false });
  const timed: TrajectoryDocument = timing.toJSON();
  const { velocity }: TrajectoryState = timing.state(timing.duration / 2);
  const followed: TrajectoryVerification = Full.parse(document).verifyTrajectory(solve(scenario), timing);
  const looseness: JudgeOptions = { arcs: false, driveTolerance: 0.1 };
  const judged: PathJudgement = Full.parse(document).judge([[0, 0], [1, 1]], looseness);
  const rates: number = (velocity[0] ?? 0) + timing.speed(0) + timing.sample(1).length + timed.duration + (followed.trajectory?.looks ?? 0) + (judged.contact?.edge ?? 0);
  // @ts-expect-error: not a limit
  Full.parse(document).time(solve(scenario), { speed: 1, acceleration: 2, jerk: 3 });
  const shape: Shape = { type: "polygon", vertices: [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]] };
  const metric: Weights = { translation: 0.7, rotation: 0.3 };
  const bounds: Box = { min: [0, 0], max: [2, 2] };
  const body: ScenarioDocument = { ...document, world: { bounds, obstacles: [] }, robot: { type: "rigid_body", shape, metric } };
  const car: ScenarioDocument = {
    ...body, robot: { type: "car", shape, wheelbase: 0.2, speed: [-0.5, 0.5], steering: [-0.5, 0.5], integration_step: 0.01 },
    queries: [{ name: "q", start: [1, 1, 0], goal: [1.5, 1, 0], goal_tolerance: { translation: 0.1, rotation: 0.5 } }],
  };
  const drive: Drive = scenario.drive(q);
  const wanted: NeighboursOptions = { index: "forest", metric: "naive", trees: 4, leaf: 16, candidates: 100, seed: 3 };
  const index: Neighbours = scenario.neighbours(wanted);
  const drawn: SampleOptions = { seed: 1, free: true };
  index.add(scenario.sampleConfigurations(10, drawn));
  index.add([[0, 0], [1, 1]]);
  const found: NeighboursFound = index.nearest(q, 3);
  const near: number[] = [...index.within(q, 1).distances, ...found.distances, ...found.indices, found.visited, index.size];
  index[Symbol.dispose]();
  const indexes: IndexInfo[] = neighbourIndexes();
  // @ts-expect-error: not an index
  scenario.neighbours({ index: "ball-tree" });
  const key: DriveKey = "faster";
  drive.press(key);
  const { blocked }: DriveState = drive.tick(1);
  const stopped: Obstructed | null = blocked;
  const record: KeyPress[] = drive.record();
  const driven: DriveState = drive.replay(record, 1);
  const rolled: Rollout = scenario.rollout(q, 0.1, 0, 1, { integration: "euler", dt: 0.1 });
  const size: CspaceOptions = { width: 8, height: 8 };
  const cells: Uint8Array = scenario.cspace(size);
  const [[low]] = scenario.cspaceRange();
  const circles: boolean[] = scenario.circles();
  const kind: "arm" | "disc" | "rigid_body" | "car" = scenario.robot;
  const moved: Motion[] = Scenario.parse(car).planner({ steering: "dubins", algorithm: "rrt", goalBias: 0.1 }).result().motions ?? [];
  const speeds: number[] = moved.map(({ control: [v, phi], duration }) => v + phi + duration);
  const miss: Approximate | undefined = Scenario.parse(body).planner().result().approximate;
  const far: number | undefined = miss?.goal_distance ?? miss?.motions?.[0]?.duration;
  const presets: PresetInfo[] = planners().flatMap((one) => one.presets);
  const settled: Planner[] = presets.map(({ settings }) => scenario.planner({ algorithm: "prm", ...settings } as PlannerOptions));
  const fit: boolean = planners().every((one) => one.robots.includes(kind) && one.parameters.every((row) => row.robots.includes(kind)));
  const again: ScenarioDocument = scenario.toJSON();
  const obstacle: Obstacle | undefined = scenario.document().world.obstacles[0];
  const robot: Robot = again.robot;

  const info: PlannerInfo[] = planners();
  const lines: PseudocodeLine[] = info[0]?.pseudocode ?? [];
  const marks: PseudocodeMark[] = lines.flatMap((line) => line.lit_by);
  const ids: PlannerId[] = info.map(({ id }) => id);
  const options: PlannerOptions = { algorithm: "prm", query: "q", seed: 1, metric: "euclidean", k: 5, samples: 50, maxIterations: 500, events: false };
  const going: ResumeOptions = { query: "q", shortcut: 10 };
  const looked: QueryCheck = scenario.checkQuery("q");
  const kinds: GeneratorInfo[] = generators();
  const choices: (string[] | null)[] = kinds.flatMap(({ options: all }) => all.map((option: OptionInfo) => option.choices));
  const planner: Planner = scenario.planner(options);
  planner.record();
  const history: Float64Array = planner.historySince(0).subarray(0, planner.historyWidth);
  const reached: Phase | undefined = phases[history[historyColumns.indexOf("phase")] ?? 0];
  const happened: EventKind | undefined = eventKinds[planner.eventsSince(0)[0] ?? 0];
  const solved: ResultDocument = solve(document, { algorithm: "rrt", extend: "half" });
  for await (const growth of planner.growth({ budget: 4 })) if (growth.vertices.length > 100) break;
  const raw: Float64Array = planner.rawPath();
  const hits: Float64Array = planner.firstHits([0, 0, 1, 1]);
  let status: Status = planner.step(10);
  status = planner.stepFor(8);
  const phase: Phase = planner.phase;
  const counts: number = planner.vertexCount + planner.edgeCount + planner.eventCount + planner.iterations + planner.dimension + planner.eventWidth;
  const vertices: Float64Array = planner.verticesSince(0);
  const edges: Uint32Array = planner.edgesSince(0);
  const events: Float64Array = planner.eventsSince(0);
  const motions: Float64Array = planner.motionsSince(0);
  const traces: Float64Array = planner.tracesSince(0);
  const path: Float64Array = planner.path();
  const stats: Stats = planner.stats();
  const result: ResultDocument = planner.result();
  const text: string = planner.roadmap("json");
  const kept: Uint8Array = planner.roadmap("binary");
  const resumed: Planner = scenario.resume(kept, going);
  scenario.resume(text).free();
  resumed.free();
  planner[Symbol.dispose]();
  generated.free();
  try {
    Scenario.parse("{");
  } catch (error) {
    if (error instanceof PlanariumError) return error.code + error.pointer + error.message;
  }
  // @ts-expect-error: only the package makes handles
  new Planner();
  // @ts-expect-error: not a kind
  Scenario.generate("jungle");
  // @ts-expect-error: no such planner
  scenario.planner({ algorithm: "prn" });
  // @ts-expect-error: an option of another planner
  scenario.planner({ algorithm: "rrt", samples: 10 });
  // @ts-expect-error: options are in camelCase
  scenario.planner({ algorithm: "rrt", goal_bias: 0.1 });
  // @ts-expect-error: a typing error in an option
  scenario.planner({ goalBais: 0.1 });
  // @ts-expect-error: not a document
  Scenario.parse({ format: "planarium-scenario-1" });
  // @ts-expect-error: no such method
  scenario.reach({ target: [0, 1], method: "magic" });
  // @ts-expect-error: a roadmap is not resumed by a tree
  scenario.resume(text, { algorithm: "rrt" });
  // @ts-expect-error: not a format
  planner.roadmap("png");
  // @ts-expect-error: a count is a number
  planner.step("10");
  // @ts-expect-error: not a key
  drive.press("jump");
  // @ts-expect-error: a car has a wheelbase
  Scenario.parse({ ...car, robot: { type: "car", shape } } satisfies ScenarioDocument);
  return JSON.stringify([ids, looked, happened, solved, free, near, indexes, names, stopped, driven, rolled, radii, box, tip, tips, hit, cells, low, circles, kind, obstacle, robot, status, phase, counts, vertices, edges,
    events, motions, traces, path, stats, result, speeds, far, settled.length, fit, marks, choices, reached, raw, hits, near, closest, version, scenario.name, scenario.title, scenario.distance(q, half), planner.fingerprint()]);
}
`;

/** `planarium/draw` draws on a canvas, so that it needs the types of one. */
const drawer = `
import { Scenario, type ResultDocument } from "planarium";
import { PlannerPool, type ProblemModule } from "planarium/worker";
import {
  View, blendedPath, defaultColours, difference, drawEdges, drawObstacles, drawPath, drawRobot, drawWorld, isThin, motionCurves, obstaclePath, partPath, wrap,
  type Colours, type Context, type Curves,
} from "planarium/draw";

export function inWorker(abort: AbortController): PlannerPool {
  const pool = new PlannerPool({ worker: () => new Worker("worker.js", { type: "module" }), core: new URL("https://example.org/planarium_bg.wasm") });
  void pool.plan("{}", {}, { signal: abort.signal, onProgress: async ({ status }) => status });
  const problem: ProblemModule = { module: new URL("https://example.org/robot.js"), export: "robot", arguments: [1, [2]] };
  void pool.plan(problem, { algorithm: "prm" });
  void pool.growth({ module: "https://example.org/robot.js" });
  // @ts-expect-error: a problem has functions
  void pool.plan({ module: "https://example.org/robot.js", exprot: "robot" });
  return pool;
}

export function draw(context: CanvasRenderingContext2D, canvas: OffscreenCanvas, scenario: Scenario): number {
  const view: View = new View(scenario.extent(), canvas.width, canvas.height, { left: 0, right: 0, top: 0, bottom: 0 }, true);
  const off: Context | null = canvas.getContext("2d");
  const colours: Partial<Colours> = { path: defaultColours.growth };
  const planner = scenario.planner();
  const result: ResultDocument = planner.result();
  if (off) drawWorld(off, view, scenario.document());
  drawObstacles(context, view, scenario.document().world.obstacles, colours);
  const parts = scenario.footprint(planner.path());
  drawRobot(context, view, parts);
  for (const obstacle of scenario.document().world.obstacles) obstaclePath(context, view, obstacle);
  for (const part of parts) if (!isThin(view, part)) partPath(context, view, part);
  drawPath(context, view, scenario, result, colours);
  const [before, after]: [number, number] = result.blends?.[0] ?? [0, 0];
  const round: number[][] = blendedPath(scenario, { path: result.path, blends: [[before, after]] });
  const { points, firsts }: Curves = motionCurves(scenario, new Float64Array(4), [true, false]);
  const [x, y]: [number, number] = view.toPlane(...view.place(points));
  // @ts-expect-error: not a colour
  drawRobot(context, view, parts, { robto: "red" });
  return drawEdges(context, view, scenario, planner, firsts[0], colours) + round.length + wrap(x) + difference(x, y, true);
}
`;

/** `planarium/import`, with and without the types of a page. */
const reader = `
import { solve, PlanariumError as Same } from "planarium";
import init, { initSync, readWorld, PlanariumError, type World, type WorldFile, type WorldGrid, type WorldOptions, type WorldReport, type WorldRobot } from "planarium/import";

export async function read(bytes: Uint8Array, module: ArrayBuffer): Promise<string> {
  initSync(module);
  await init("https://example.org/import_bg.wasm");
  const files: readonly WorldFile[] = [{ name: "a.map", bytes }];
  const corners = [[0, 0], [1, 0], [0, 1]] as const;
  const robots: WorldRobot[] = [{ type: "point" }, { type: "disc", radius: 1 }, { type: "footprint", corners }, { type: "car", length: 4, width: 2 }];
  const options: WorldOptions = { robot: robots[0] ?? { type: "point" }, start: [0, 0] as const, goal: [1, 1], unknown: "free", threshold: 0.5, scale: 1, min_island: 2, simplify: 0.1 };
  // @ts-expect-error: options have the names of documents
  void readWorld(files, { minIsland: 2 });
  // @ts-expect-error: a file has bytes
  void readWorld([{ name: "a.map", bytes: "type octile" }]);
  // @ts-expect-error: a disc has a radius
  void readWorld(files, { robot: { type: "disc" } });
  try {
    const { scenario, report, grid }: World = await readWorld(files, options);
    const told: WorldReport = report;
    const cells: WorldGrid | undefined = grid;
    const [left]: [number, number] = cells?.origin ?? [0, 0];
    return JSON.stringify([solve(scenario).status, told.format, told.obstacles.polygons, told.grid?.kinds?.[0], told.queries[0]?.blocked, cells?.cells[0], left]);
  } catch (error) {
    if (!(error instanceof PlanariumError) || !(error instanceof Same)) throw error;
    const { file, place, wanted } = error;
    const line: number | undefined = place && "line" in place ? place.line : undefined;
    return [file, line, wanted].join();
  }
}
`;

/** `planarium/shortest`, with the shapes of GeoJSON that others declare. */
const finder = `
import init, { initSync, prepare, shortestPath, PlanariumError, type Geometry, type Obstacles, type ShortestPathFeature } from "planarium/shortest";

interface Other { type: "FeatureCollection"; features: { type: "Feature"; properties: { name: string } | null; geometry: { type: "Polygon"; coordinates: number[][][] } }[] }

export async function find(other: Other, module: ArrayBuffer): Promise<number> {
  initSync(module);
  await init("https://example.org/shortest_bg.wasm");
  const obstacles: Obstacles = other;
  const wall: Geometry = { type: "LineString", coordinates: [[0, 0], [1, 1]] };
  // @ts-expect-error: a line has positions
  const none: Geometry = { type: "LineString", coordinates: [0, 0] };
  // @ts-expect-error: options have names
  void shortestPath([0, 0], [1, 1], { minDistanse: 1 });
  const found: ShortestPathFeature | null = shortestPath([0, 0], { type: "Point", coordinates: [1, 1] }, { obstacles, minDistance: 5, bounds: [0, 0, 1, 1], coordinates: "degrees" });
  const paths = prepare({ type: "GeometryCollection", geometries: [wall, none] }, { coordinates: "metres" });
  try {
    const line: [number, number][] = paths.query([0, 0], [1, 1])?.geometry.coordinates ?? [];
    return line.length + (found?.properties.length ?? 0) + (found?.properties.distortion ?? 0);
  } catch (error) {
    return error instanceof PlanariumError ? error.code.length : 0;
  } finally {
    paths.free();
  }
}
`;

const base = {
  strict: true,
  noEmit: true,
  target: "es2022",
  skipLibCheck: false,
  types: [],
  noUncheckedIndexedAccess: true,
  exactOptionalPropertyTypes: true,
};

/** @type {string} */
let folder;

before(() => {
  folder = install({ "consumer.ts": consumer, "drawer.ts": drawer, "reader.ts": reader, "finder.ts": finder });
});

for (const [name, settings] of Object.entries({
  nodenext: { module: "nodenext" },
  bundler: { module: "esnext", moduleResolution: "bundler" },
  "nodenext without the DOM": { module: "nodenext", lib: ["es2022"] },
})) {
  test(`a strict consumer compiles under ${name}`, () => {
    addFiles(folder, {
      "tsconfig.json": JSON.stringify({
        compilerOptions: { ...base, ...settings },
        files: ["consumer.ts", "reader.ts", "finder.ts", ...("lib" in settings ? [] : ["drawer.ts"])],
      }),
    });
    const { status, stdout } = spawnSync(
      process.execPath,
      [join(root, "node_modules", "typescript", "bin", "tsc"), "-p", folder],
      { encoding: "utf8" },
    );
    assert.equal(status, 0, stdout);
  });
}

test("no declaration says any, and every member is explained", () => {
  const place = join(folder, "node_modules", "planarium", "dist", "package");
  const names = readdirSync(place, { recursive: true, encoding: "utf8" }).filter((file) => file.endsWith(".d.ts"));
  assert.ok(names.includes(join("full", "core.d.ts")));
  for (const name of names) {
    const text = readFileSync(join(place, name), "utf8");
    const code = text.replace(/\/\*[^]*?\*\/|"[^"]*"/g, "");
    assert.doesNotMatch(code, /\bany\b/, name);
    assert.doesNotMatch(text, /\* r#*"/, name);
    const bare = text
      .split("\n")
      .filter(
        (line, i, lines) =>
          /^ {4}(?:static |get )?\[?\w[\w.]*\]?\??[(:]/.test(line) && !lines[i - 1].trimEnd().endsWith("*/"),
      );
    assert.deepEqual(bare, [], `${name} has members without a comment`);
  }
});
