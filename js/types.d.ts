/**
 * The documents and records of the package. Lengths are in metres, angles in radians, counter-clockwise, y points up.
 */

/** Where a run stands: it goes on, it has found a path, or its budget of iterations is spent. */
export type Status = "running" | "solved" | "exhausted";

/**
 * What a planner is at. `prm` and `prm-star`: sampling, connecting, searching; `visibility-prm`: guarding, searching; `rrt`,
 * `rrt-connect`, `rrt-control` and `sst`: growing; a roadmap gone on with: connecting, searching. Then improving, where that is
 * asked for (`sst` by growing on), and done.
 */
export type Phase = "sampling" | "connecting" | "guarding" | "searching" | "growing" | "improving" | "done";

/** A point of the plane: x, y. */
export type Point = [number, number];

/** A configuration: one number per degree of freedom (the joints of an arm; x and y of a disc; x, y and theta of a body or a car). */
export type Configuration = readonly number[] | Float64Array;

/** A box along the axes. */
export interface Box {
  /** Lower left corner. */
  min: Point;
  /** Upper right corner. */
  max: Point;
}

/**
 * One moving part of a robot, in the world: a link with round ends (radius 0 is a segment), a disc (radius 0 is a point), or a
 * body (corners counter-clockwise).
 */
export type Part =
  | { type: "capsule"; a: Point; b: Point; radius: number }
  | { type: "disc"; center: Point; radius: number }
  | { type: "polygon"; vertices: Point[] };

/** One pair that touches. */
export interface Touching {
  /** Index of the part in `footprint`. */
  part: number;
  /** Index of the obstacle in the document, or the bounds of the world. */
  obstacle: number | "bounds";
}

/** Whether a configuration is free, and what touches where it is not. */
export interface Check {
  /** Nothing touches. */
  free: boolean;
  /** Every pair that touches. */
  touching: Touching[];
}

/** The part of a robot and the obstacle that are nearest to each other. */
export interface Clearance {
  /** The distance between them, metres. */
  distance: number;
  /** Index of the part in `footprint`. */
  part: number;
  /** Index of the obstacle in the document. */
  obstacle: number;
  /** The nearest point of the part, and that of the obstacle. */
  points: [Point, Point];
}

/** A filled obstacle; touching it is collision. */
export type Obstacle =
  | { type: "polygon"; vertices: Point[] }
  | { type: "disc"; center: Point; radius: number };

/** What the robot moves in. */
export interface World {
  /** The robot stays inside, and may touch them. Optional only for an arm. */
  bounds?: Box;
  /** May be empty. */
  obstacles: Obstacle[];
}

/** The shape of a body in its own frame. */
export type Shape = { type: "polygon"; vertices: Point[] };

/** What a metre and a radian count in the distance of two placements; both greater than 0. */
export interface Weights {
  /** Of translation; 0.7 where no metric is given. */
  translation: number;
  /** Of rotation; 0.3 where no metric is given. */
  rotation: number;
}

/** What moves: a planar arm of 1 to 8 links, a disc (radius 0 is a point), a rigid body, or a car. */
export type Robot =
  | {
      type: "arm";
      /** Where the first joint is. */
      base: Point;
      /** Lengths of the links. */
      links: number[];
      /** Half the thickness of the links; 0 where absent. */
      radius?: number;
      /** One interval per joint; without them each joint is a circle. */
      joint_limits?: Point[];
    }
  | { type: "disc"; radius: number }
  | {
      type: "rigid_body";
      /** Any simple polygon about the point (x, y) that a configuration places. */
      shape: Shape;
      metric?: Weights;
    }
  | {
      type: "car";
      /** About the middle of the rear axle; x is forward. */
      shape: Shape;
      /** Metres between the axles. */
      wheelbase: number;
      /** Least and greatest speed, metres a second. */
      speed: Point;
      /** Least and greatest steering angle, radians; to the left where positive. */
      steering: Point;
      /** Seconds; 0.01 where absent. */
      integration_step?: number;
      metric?: Weights;
    };

/** A place for the end effector of an arm. */
export interface Target {
  /** Where the tip is to be. */
  point: Point;
  /** The angle of the last link in the world, in radians; any where it is absent. */
  orientation?: number;
}

/** A motion that is asked for: to a goal, or to a target. */
export interface Query {
  /** Unique in its scenario. */
  name: string;
  /** Configuration to start from. */
  start: number[];
  /** Configuration to reach; absent where there is a target. */
  goal?: number[];
  /** Where the end effector of an arm is to be, in place of a goal: any configuration that reaches it will do. */
  target?: Target;
  /** How near to the goal is near enough, of bodies and cars: metres and radians, both. */
  goal_tolerance?: { translation: number; rotation: number };
}

/**
 * A scenario as a document, in the format `planarium-scenario-1`; its JSON Schema is `planarium/scenario.schema.json`.
 * `document()` gives it with `title` and `radius` filled in.
 */
export interface ScenarioDocument {
  /** Names the format and its version. */
  format: "planarium-scenario-1";
  /** Short name. */
  name: string;
  /** Title for people. */
  title?: string;
  /** Obstacles and bounds. */
  world: World;
  /** What moves. */
  robot: Robot;
  /** May be empty. */
  queries: Query[];
}

/** A planner, as a page would offer it. */
export interface PlannerInfo {
  /** What `algorithm` takes. */
  id: string;
  /** Title for people. */
  title: string;
  /** What it does, in a sentence or two. */
  summary: string;
  /** What is known about its results, in a sentence. */
  guarantee: string;
  /** What it grows: a roadmap, a tree from the start, or one from the start and one from each goal. */
  grows: "roadmap" | "tree" | "trees";
  /** Whether its edges are drives by controls, so that the goal is a region. */
  driven: boolean;
  /** How it works, line by line. */
  pseudocode: PseudocodeLine[];
  /** The types of robots that it plans for. */
  robots: Robot["type"][];
  /** Settings with a name; may be empty. */
  presets: PresetInfo[];
  /** What can be set. */
  parameters: ParameterInfo[];
}

/** Settings of a planner that belong together. */
export interface PresetInfo {
  /** Unique in its planner. */
  id: string;
  /** Title for people. */
  title: string;
  /** Parameters by name, as options take them: `scenario.planner({ algorithm, ...settings })`. Others keep their defaults. */
  settings: Record<string, number | string | boolean>;
}

/** One line of pseudo-code. It is lit by an iteration that has one of its marks; each iteration lights at least one line. */
export interface PseudocodeLine {
  /** The line, of 46 characters at most. */
  text: string;
  /** How deep it stands, from 0. */
  indent: number;
  /** What lights it; nothing lights a line that only frames others. */
  lit_by: PseudocodeMark[];
}

/**
 * What an iteration did: the phase it began in; `vertex` and `edge` where it added some; the kinds of its events (`eventsSince`), from
 * 0 on: `rejected`, `refused`, `expanded`, `solved`, `discarded`, `guard`, `removed`; and `done` where the run has ended with it.
 */
export type PseudocodeMark = Phase | "vertex" | "edge" | "rejected" | "refused" | "expanded" | "solved" | "discarded" | "guard" | "removed";

/** One parameter of a planner. */
export interface ParameterInfo {
  /** Key in the options. */
  name: string;
  /** Title for people. */
  title: string;
  /** What values it takes. */
  kind: "integer" | "number" | "boolean" | "choice";
  /** Unit, or an empty string. */
  unit: string;
  /** Least value of a number; null where there is none. */
  min: number | null;
  /** Greatest value of a number; null where there is none. */
  max: number | null;
  /** Value where it is not set; null where that depends on the scenario. */
  default: number | boolean | string | null;
  /** What the default depends on, in words, where `default` does not say it. */
  default_meaning?: string | null;
  /** What a choice may be. */
  choices: string[] | null;
  /** What it does. */
  meaning: string;
  /** The types of robots that it is for; for others it says nothing. */
  robots: Robot["type"][];
}

/** An index of configurations, as a page would offer it. */
export interface IndexInfo {
  /** What `scenario.neighbours` takes as `index`. */
  id: "linear" | "kd-tree" | "forest";
  /** Title for people. */
  title: string;
  /** What it does, in a sentence. */
  summary: string;
  /** Whether it always finds the nearest. */
  exact: boolean;
  /** Its parameters. */
  parameters: ParameterInfo[];
}

/** Options of `scenario.neighbours`. */
export interface NeighboursOptions {
  /** What kind of index; `kd-tree` where absent. */
  index?: IndexInfo["id"];
  /** How an arm's joint distances are put together; `sum` where absent. */
  metric?: "sum" | "euclidean" | "naive";
  /** Of a forest: how many trees, 1 to 64; 8 where absent. */
  trees?: number;
  /** Of a forest: how many configurations fill a leaf, 8 to 1024; 32 where absent. */
  leaf?: number;
  /** Of a forest: how many configurations a question looks at, at least; 400 where absent. */
  candidates?: number;
  /** Of a forest: integer from 0 to 2^53 - 1; 0 where absent. The same seed draws the same planes. */
  seed?: number;
}

/** What an index has found, nearest first; ties go to the lower number. */
export interface NeighboursFound {
  /** The numbers of the configurations, in the order in which they were added, from 0. */
  indices: Uint32Array;
  /** Their distances in the metric, true ones of a forest too. */
  distances: Float64Array;
  /** Of how many configurations the distance was computed. The shape of a kd-tree, and so this number, may differ between platforms. */
  visited: number;
}

/** Options of `scenario.sampleConfigurations`. */
export interface SampleOptions {
  /** Integer from 0 to 2^53 - 1; 0 where absent. */
  seed?: number;
  /** Whether only free configurations are kept; false where absent. */
  free?: boolean;
}

/** A generator, as a page would offer it. */
export interface GeneratorInfo {
  /** What `Scenario.generate` takes. */
  id: GeneratorId;
  /** Title for people. */
  title: string;
  /** What it makes, in a sentence. */
  summary: string;
  /** What can be set, besides `seed`. */
  options: OptionInfo[];
}

/** One option of a generator. */
export type OptionInfo = ParameterInfo;

/** All there is to choose from. @internal */
export interface Catalogue {
  planners: PlannerInfo[];
  generators: GeneratorInfo[];
  reach_methods: ReachMethodInfo[];
  indexes: IndexInfo[];
  trajectories: ParameterInfo[];
}

/** How to plan: the common options, and the planner's own parameters by name (see `planners()`). */
export interface PlannerOptions {
  /** Id of the planner; where absent `rrt-control` for a car, `rrt-connect` for all others. */
  algorithm?: string;
  /** Name of the query; the first where absent. */
  query?: string;
  /** Integer from 0 to 2^53 - 1; 0 where absent. The same seed gives the same run, bit for bit. */
  seed?: number;
  /** How an arm's joint distances are put together; `sum` where absent. */
  metric?: "sum" | "euclidean" | "naive";
  /** Budget of iterations; 100,000 where absent. */
  max_iterations?: number;
  /** Any other parameter of the planner. */
  [parameter: string]: number | string | boolean | undefined;
}

/** How a roadmap is kept: JSON or bytes, which `scenario.resume` reads, or GraphML for other programs. */
export type RoadmapFormat = "json" | "binary" | "graphml";

/** Options of `planner.query`. */
export interface QueryOptions {
  /** Whether start and goal stay in the roadmap, with their edges, as its last two vertices; false where absent. */
  keep?: boolean;
}

/** What `Scenario.generate` makes. */
export type GeneratorId = "forest" | "clutter" | "discs" | "maze" | "gap" | "bug-trap";

/** Options of `Scenario.generate`; lengths in metres. Which kind takes which, it says there. */
export interface GenerateOptions {
  /** Integer from 0 to 2^53 - 1; 0 where absent. */
  seed?: number;
  /** What moves in `clutter`, `discs` and `gap`; `disc` where absent. A body or a car is a rectangle of 0.2 m by 0.1 m. */
  robot?: Robot["type"];
  /** Links of the arm: 1 to 8, in a `gap` 2 to 8. */
  links?: number;
  /** Radius of the disc, or half the width of the arm's links: 0 to 0.1; 0.03 where absent. */
  radius?: number;
  /** Obstacles: up to 60 in `clutter`, up to 200 `discs`. */
  count?: number;
  /** Radius of the smallest obstacle. */
  smallest?: number;
  /** Radius of the largest obstacle. */
  largest?: number;
  /** Obstacles are farther than this from each other and from start and goal: 0 to 0.2. */
  gap?: number;
  /** Whether `discs` may overlap; `apart` where absent. */
  placement?: "apart" | "overlapping";
  /** Size of a `maze`, and how many of its walls are opened; `easy` where absent. */
  difficulty?: "easy" | "medium" | "hard";
  /** Thickness of the walls of a `maze` (0.005 to 0.1) or of a `gap` (0.005 to 0.5). */
  thickness?: number;
  /** Width of a `gap`: 0 to 1; 0.2 where absent. */
  width?: number;
  /** Width of the mouth of a `bug-trap`: 0.01 to 0.4; 0.12 where absent. */
  mouth?: number;
  /** Where the disc of a `bug-trap` starts; `inside` where absent. */
  start?: "inside" | "outside";
  /** Where the mouth of a `bug-trap` looks: anywhere, or along an axis; `any` where absent. */
  turn?: "any" | "quarter";
  /** Any other option of the generator. */
  [option: string]: number | string | boolean | undefined;
}

/** Size of a picture of the configuration space, in cells. */
export interface CspaceOptions {
  /** Cells along the first joint. */
  width: number;
  /** Cells along the second joint. */
  height: number;
}

/** What a run has counted. */
export interface Stats {
  /** Iterations made. */
  iterations: number;
  /** Vertices in the graph. */
  vertices: number;
  /** Edges in the graph. */
  edges: number;
  /** Configurations tested for collision by themselves. */
  configuration_checks: number;
  /** Motions tested. */
  motion_checks: number;
  /** Questions to the index of neighbours. */
  nearest_queries: number;
  /** Vertices that the search expanded. */
  visited: number;
  /** Distances to obstacles computed for the proofs. */
  clearance_evaluations: number;
  /** Motions refused because their proof had spent its budget of evaluations; 0 as a rule. */
  unproven_motions: number;
  /** Seconds spent building the graph, in this handle's own steps. */
  build_seconds: number;
  /** Seconds spent searching it and shortening the path. */
  search_seconds: number;
}

/** A control of a car that is held for a while. */
export interface Motion {
  /** Speed in metres a second, backward where negative, and angle of the front wheels in radians, to the left where positive. */
  control: [number, number];
  /** Seconds. */
  duration: number;
}

/** The result of a run, the same as the command line prints. */
export interface ResultDocument {
  /** Name of the scenario. */
  scenario: string;
  /** Name of the query. */
  query: string;
  /** Id of the planner. */
  planner: string;
  /** Seed of the run. */
  seed: number;
  /** Where the run stands. */
  status: Status;
  /** Waypoints; empty unless solved. */
  path: number[][];
  /** Of a car, what leads from each waypoint to the next along an exact arc; absent for other robots. */
  motions?: Motion[];
  /** `euler` where motions were computed by Euler's steps, so that the path is a picture and no proof; absent where they are exact. */
  integration?: "euler";
  /** Length of the path in the metric of the run; of a car along its arcs, in the scenario's metric. */
  length: number;
  /** What was counted. */
  stats: Stats;
  /** 16 hexadecimal digits over every vertex, edge and event. */
  fingerprint: string;
  /** `sampled` where edges were only looked at in places, so that the path is not proven; absent where it is. */
  edge_check?: "sampled";
  /** The estimated share of the free space that a visibility roadmap covers; absent for other planners and for roadmaps gone on with. */
  coverage?: number;
  /** How far an RRT came that gave up: the path to its vertex nearest to the goal; absent otherwise. */
  approximate?: Approximate;
}

/** An approximate answer, which does not reach the goal. */
export interface Approximate {
  /** Waypoints from the start on. */
  path: number[][];
  /** Of a car, what leads from each to the next; absent for other robots. */
  motions?: Motion[];
  /** How far from the goal it ends, in the metric of the run. */
  goal_distance: number;
}

/**
 * What a driver does: v grows or falls by 0.1 m/s, the front wheels turn by pi / 12 to the left (phi grows) or to the right, or
 * the controls are kept.
 */
export type DriveKey = "faster" | "slower" | "left" | "right" | "keep";

/** A key that was pressed when so many steps had gone by. */
export interface KeyPress {
  /** Steps since the start. */
  step: number;
  /** Which key. */
  key: DriveKey;
}

/**
 * What stops a car: the index of an obstacle, the bounds, or `"near"` where it would touch nothing and only come nearer to
 * something than can be proven free.
 */
export type Obstructed = number | "bounds" | "near";

/** How a drive stands. */
export interface DriveState {
  /** Where the car is: x, y in metres, theta in radians within (-pi, pi]. */
  pose: [number, number, number];
  /** Speed, metres a second; backward where negative. */
  v: number;
  /** Angle of the front wheels, radians; to the left where positive. */
  phi: number;
  /** Steps that have gone by, driving or standing. */
  steps: number;
  /** The same in seconds. */
  seconds: number;
  /** What stopped the car, until it moves again; null otherwise. */
  blocked: Obstructed | null;
  /** Rows of its trace. */
  traceCount: number;
  /** Keys recorded. */
  keyCount: number;
}

/** Where one control leads. */
export interface Rollout {
  /** Rows of x, y, theta: the start, the pose after each whole step, and at the end. */
  poses: Float64Array;
  /** How long it is proven free: the duration asked for, unless it is blocked. */
  seconds: number;
  /** What blocks it, if anything. */
  blocked: Obstructed | null;
}

/** A method of inverse kinematics, as a page would offer it. */
export interface ReachMethodInfo {
  /** What `method` takes. */
  id: string;
  /** Title for people. */
  title: string;
  /** What it does, in a sentence. */
  summary: string;
  /** What can be set. */
  parameters: ParameterInfo[];
}

/** What the tip of an arm is to reach, and how: the common options, and the method's own parameters by name (see `reachMethods()`). */
export interface ReachOptions {
  /** Where the tip is to be. */
  target: readonly [number, number];
  /** Wanted absolute angle of the last link, in radians, whole turns aside; any where absent. */
  orientation?: number;
  /** Id of the method; `damped-least-squares` where absent. */
  method?: string;
  /** Where to start from; where absent the start of the first query, or all joints at 0 as far as their limits allow. */
  start?: readonly number[];
  /** Integer from 0 to 2^53 - 1, for the starts that are drawn; 0 where absent. */
  seed?: number;
  /** How far the tip may end from the target, metres and radians. */
  tolerance?: number;
  /** Budget of iterations. */
  max_iterations?: number;
  /** How many starts may be drawn. */
  restarts?: number;
  /** How many distinct solutions are looked for; 1 where absent. */
  solutions?: number;
  /** Whether only those count that touch nothing; false where absent. */
  free_only?: boolean;
  /** How far apart, in radians, some joint of two distinct solutions is. */
  separation?: number;
  /** Any other parameter of the method. */
  [parameter: string]: number | string | boolean | readonly number[] | undefined;
}

/** How near an arm can come to a target. */
export interface NearestPoint {
  /** A configuration that comes that near. */
  configuration: Float64Array;
  /** Where the tip then is. */
  point: Point;
  /** How far that is from the target, in metres. */
  distance: number;
  /** How far the last link is from the wanted orientation, in radians: 0 unless the limits allow that orientation nowhere. */
  turn: number;
}

/** An arm that has followed a hand. */
export interface Followed {
  /** The configuration. */
  configuration: Float64Array;
  /** Where the tip is. */
  point: Point;
  /** How far it is from the target, in metres. */
  distance: number;
  /** How far the last link is from the wanted orientation, in radians. */
  turn: number;
  /** Whether it is at the target. */
  reached: boolean;
  /** Yoshikawa's manipulability there, in square metres: 0 where the arm is singular. */
  manipulability: number;
}

/** What has come of a search for joint angles. */
export interface ReachVerdict {
  /**
   * `reached`; `in-collision` where the target is reached in collision only; `out-of-reach` where no configuration reaches it;
   * `running`, or `not-found` once the budget is spent, where one does that has not been found.
   */
  verdict: "reached" | "in-collision" | "out-of-reach" | "running" | "not-found";
  /** Why it is out of reach; null otherwise. */
  reason: "too-far" | "too-near" | "limits" | "orientation" | null;
  /** How near the arm can come to a target out of reach; null otherwise. */
  nearest: { configuration: number[]; point: Point; distance: number; turn: number } | null;
  /** What touches what at the first solution in collision; null where that is not the verdict. */
  touching: Touching[] | null;
}

/** The result of a search for joint angles, the same as the command line prints. */
export interface ReachResult {
  /** Name of the scenario. */
  scenario: string;
  /** Id of the method. */
  method: string;
  /** Where the tip was to be. */
  target: Point;
  /** The orientation that was wanted, within (-pi, pi]; null for any. */
  orientation: number | null;
  /** Seed of the run. */
  seed: number;
  /** Where the run stands. */
  status: Status;
  /** Distinct configurations that reach the target. */
  solutions: number[][];
  /** Those that do so in collision, where `free_only` is set. */
  rejected: { configuration: number[]; touching: Touching[] }[];
  /** What has come of it. */
  verdict: ReachVerdict;
  /** How large the error of a solution may be: as set, but no finer than rounding allows. */
  tolerance: number;
  /** What was counted. */
  stats: { iterations: number; restarts: number; configuration_checks: number };
  /** 16 hexadecimal digits over every iterate and solution. */
  fingerprint: string;
}

/** How a particle moves: on a circular arc, or on the spiral v t (cos(theta + w t), sin(theta + w t)) about its start. */
export type ParticleModel = "arc" | "spiral";

/** A particle with constant speed and turn rate. */
export interface ParticleMotion {
  /** How it moves; `arc` unless told otherwise. */
  model?: ParticleModel;
  /** Where it starts, metres; 0 unless told otherwise. */
  x?: number;
  /** Where it starts, metres; 0 unless told otherwise. */
  y?: number;
  /** Its first heading, radians; 0 unless told otherwise. */
  theta?: number;
  /** Its speed, metres a second, at least 0; 1 unless told otherwise. */
  v?: number;
  /** Its turn rate, radians a second, counter-clockwise; pi / 4 unless told otherwise. */
  w?: number;
}

/** What `new Trajectories` takes; `trajectoryOptions()` tells ranges and meanings. */
export interface TrajectoryOptions {
  /** An integer from 0 (default) to 2^53 - 1. */
  seed?: number;
  /** How particles move. */
  model?: ParticleModel;
  /** How many are accepted. */
  count?: number;
  /** Half the side of the square of starts, metres. */
  half_side?: number;
  /** First headings lie between minus this and this, radians. */
  spread?: number;
  /** The least speed, metres a second. */
  slowest?: number;
  /** The greatest speed, metres a second. */
  fastest?: number;
  /** The least turn rate, radians a second. */
  least_turn_rate?: number;
  /** The greatest turn rate, radians a second. */
  greatest_turn_rate?: number;
  /** How long every particle moves, seconds. */
  duration?: number;
  /** Whether a grid tells which earlier trajectories may be near; the result is the same. */
  index?: "grid" | "none";
  /** After how many tried the search gives up. */
  max_iterations?: number;
}

/** What has come of many trajectories. */
export interface TrajectoriesResult {
  /** How particles move. */
  model: ParticleModel;
  /** The seed. */
  seed: number;
  /** Where it stands. */
  status: Status;
  /** How many were accepted. */
  accepted: number;
  /** How many were refused. */
  refused: number;
  /** How many were tried. */
  iterations: number;
  /** Pairs of boxes around trajectories that were compared. */
  boxes: number;
  /** Pairs of trajectories that were tested themselves. */
  pairs: number;
  /** Pairs of stretches looked at where closed forms do not serve. */
  stretches: number;
  /** 16 hexadecimal digits over all that was tried. */
  fingerprint: string;
}

/** Something with a URL that can be fetched: a `URL` or a `Request`. */
export type Fetchable = { readonly href: string } | { readonly url: string; readonly method: string };

/** What a `Response` is, as far as it matters here. */
export interface WasmResponse {
  /** Whether the server answered with the file. */
  readonly ok: boolean;
  /** Reads the bytes. */
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** What `init` can load: a URL, a `Request`, a `Response`, the bytes, or a compiled `WebAssembly.Module`. */
export type InitInput = string | Fetchable | WasmResponse | InitSyncInput;

/**
 * What `initSync` can load: the bytes, or a compiled `WebAssembly.Module`, which is written as `object` here so that
 * these types also serve programs without the DOM library.
 */
export type InitSyncInput = ArrayBuffer | ArrayBufferView | object;

/** The object that wasm-bindgen's own loaders ask for; `init` takes it too. */
export interface InitOptions {
  /** What to load. */
  module_or_path: InitInput | Promise<InitInput>;
}

/** The object that wasm-bindgen's own loaders ask for; `initSync` takes it too. */
export interface InitSyncOptions {
  /** What to load. */
  module: InitSyncInput;
}
