//! The types of arguments and of results that TypeScript has no class or record for, each by its name there.

use crate::problem;
use wasm_bindgen::prelude::*;

/// Declares types that are plain values in JavaScript.
macro_rules! plain {
    ($($Name:ident = $type:literal),* $(,)?) => {
        #[wasm_bindgen]
        extern "C" { $(
            #[wasm_bindgen(typescript_type = $type)]
            #[derive(Clone)]
            pub type $Name;
        )* }
    };
}

plain! {
    JsNumber = "number",
    JsText = "string",
    GeneratorName = "GeneratorId",
    ScenarioInput = "string | ScenarioDocument | Scenario",
    JsConfiguration = "Configuration",
    JsPoint = "readonly [number, number] | Float64Array",
    Rows = "Float64Array | readonly number[]",
    Configurations = "Float64Array | readonly number[] | readonly Configuration[]",
    RoadmapFile = "string | Uint8Array",
    PlannerOptions = "PlannerOptions",
    ProblemInput = "ProblemDescription",
    ResumeOptions = "ResumeOptions",
    GenerateOptions = "GenerateOptions",
    CertifyOptions = "CertifyOptions",
    NeighboursOptions = "NeighboursOptions",
    SampleOptions = "SampleOptions",
    OptimumOptions = "OptimumOptions",
    ShortestPathsOptions = "ShortestPathsOptions",
    RolloutOptions = "RolloutOptions",
    JsWay = "\"short\" | \"sign-of-difference\"",
    CspaceOptions = "CspaceOptions",
    QueryOptions = "QueryOptions",
    JsKey = "DriveKey",
    KeyPresses = "readonly KeyPress[]",
    RobotType = "Robot[\"type\"]",
    JsDocument = "ScenarioDocument",
    TwoRanges = "[Point, Point]",
    JsPair = "Point",
    Booleans = "boolean[]",
    JsBox = "Box",
    JsVerdictOrNull = "CertificateVerdict | null",
    JsShortestOrNull = "Shortest | null",
    JsCountOrNull = "number | null",
}

#[cfg(feature = "full")]
plain! {
    ResultInput = "string | ResultDocument",
    TimingLimits = "TimingLimits",
    RowOptions = "RowOptions",
    TimeOptions = "TimeOptions",
    TrajectoryInput = "string | TrajectoryDocument | Trajectory",
    JsTrajectoryDocument = "TrajectoryDocument",
    JudgeOptions = "JudgeOptions",
    JsPathJudgement = "PathJudgement",
    JsRouteGraphOptions = "RouteGraphOptions",
    ReachOptions = "ReachOptions",
    TrajectoryOptions = "TrajectoryOptions",
    ParticleOptions = "ParticleMotion",
    JsVerdict = "ReachVerdict",
    FleetInput = "string | FleetDocument",
    FleetGeneratorName = "FleetGeneratorId",
    GenerateFleetOptions = "GenerateFleetOptions",
    FleetOptions = "FleetOptions",
    JsFleetDocument = "FleetDocument",
    JsFleetResult = "FleetResult",
    JsFleetConflicts = "FleetConflict[]",
    NavigationInput = "string | NavigationDocument",
    NavigationGeneratorName = "NavigationGeneratorId",
    GenerateNavigationOptions = "GenerateNavigationOptions",
    PolicyInput = "string | PolicyDocument",
    TrainingOptions = "TrainingOptions",
    PolicyPlannerOptions = "PolicyPlannerOptions",
    ExecutionOptions = "ExecutionOptions",
    ComparisonOptions = "NavigationComparisonOptions",
    JsNavigationDocument = "NavigationDocument",
    JsNavigationQueries = "NavigationQueryDocument[]",
    JsPolicyDocument = "PolicyDocument",
    JsEdgeRollouts = "EdgeRollouts[]",
    JsDemonstrations = "Demonstration[]",
    JsExecutions = "ComparedExecution[]",
    JsMethodSummaries = "MethodSummary[]",
    ExperimentInput = "string | ExperimentDocument",
    Measures = "Measure[]",
    Sample = "Float64Array | readonly number[]",
    JsTrialRow = "TrialRow",
    JsTrialRows = "readonly TrialRow[]",
    JsSummary = "ExperimentSummary",
}

/// The status of a run. Only the planner of a `Problem` can have `failed`: a function of the problem has thrown.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum Status {
    Running = "running",
    Solved = "solved",
    Exhausted = "exhausted",
    Failed = "failed",
}

impl From<problem::Status> for Status {
    fn from(status: problem::Status) -> Self {
        Self::from_str(status.as_str()).expect("the same words")
    }
}

/// Why a planner has ended without a path, or with one before it had done what its options ask for; `explanation` says it in
/// words.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum Reason {
    IterationLimit = "iteration-limit",
    WorkLimit = "work-limit",
    EvaluationLimit = "evaluation-limit",
    VertexLimit = "vertex-limit",
    GraphFull = "graph-full",
    NotConnected = "not-connected",
    NothingToExtend = "nothing-to-extend",
    SearchFailed = "search-failed",
}

impl From<problem::Reason> for Reason {
    fn from(reason: problem::Reason) -> Self {
        Self::from_str(reason.as_str()).expect("the same words")
    }
}

/// The phase of a planner. `prm`, `prm-star` and `lazy-prm`: sampling, connecting, searching; `lazy-prm-star`: sampling,
/// searching; `visibility-prm`: guarding, searching; `fmt-star` and `bit-star`: sampling, growing; all other trees: growing; a
/// roadmap that is resumed: connecting, searching. Then improving, if that is requested (planners with `improve_iterations` by
/// growing on), and done.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum Phase {
    Sampling = "sampling",
    Connecting = "connecting",
    Guarding = "guarding",
    Searching = "searching",
    Growing = "growing",
    Improving = "improving",
    Done = "done",
}

impl From<problem::Phase> for Phase {
    fn from(phase: problem::Phase) -> Self {
        Self::from_str(phase.as_str()).expect("the same words")
    }
}

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A point of the plane: x, y, in metres. */
export type Point = [number, number];

/** A configuration: one number per degree of freedom (the joints of an arm; x and y of a disc; x, y and theta of a body or a car). */
export type Configuration = readonly number[] | Float64Array;

/** The format of a stored roadmap: JSON or bytes, which `scenario.resume` reads, or GraphML for other programs. */
export type RoadmapFormat = "json" | "binary" | "graphml";

/**
 * How a drive ends: at its goal, before an arc that is not proven free, before a load swings too far, or when the time is over.
 */
export type DriveOutcome = "reached" | "collision" | "swing" | "timeout";

/** A way to drive far: the policy alone, straight edges tracked by a simple controller, or PRM-RL. */
export type NavigationMethod = "policy" | "straight" | "straight-margin" | "straight-policy" | "straight-margin-policy" | "prm-rl";

/** The shape of a differential drive about the middle of its axle; x is forward. */
export type FootprintDocument = { type: "disc"; /** In metres. */ radius: number } | { type: "polygon"; /** The corners, in metres. */ vertices: Point[] };

/** Options of `navigation.execute`. */
export interface ExecutionOptions {
  /** The policy that drives; without it a controller turns towards the next position and drives there. */
  policy?: string | PolicyDocument;
  /** The name of the query whose start is the robot's; the first by default. */
  query?: string;
  /** A whole number from 0 (default) to 2^53 - 1. */
  seed?: number;
  /** The number of the trial, 0 by default: each has noise of its own. */
  trial?: number;
}

/** What stops a car: the index of an obstacle, the bounds, or `"near"` if it would only come too near to something to be proven free. */
export type Obstructed = number | "bounds" | "near";

/** The motion of a particle: on a circular arc, or on the spiral v t (cos(theta + w t), sin(theta + w t)) about its start. */
export type ParticleModel = "arc" | "spiral";

/** A coordinate: an angle that wraps, a number between two limits, or one without, for which samples are drawn between two numbers. */
export type CoordinateDescription = {
  /** An angle in (-pi, pi]; differences are those of the short way round. */
  kind: "circle";
  /** By what differences are multiplied in the metric, 1e-6 to 1e6; 1 by default. */
  weight?: number;
} | {
  /** Between limits; or without, in which case start, goals and motions may lie outside the range. */
  kind: "interval" | "line";
  /** The lower limit, at least -1e6. */
  low: number;
  /** The upper limit, at most 1e6. */
  high: number;
  /** By what differences are multiplied in the metric, 1e-6 to 1e6; 1 by default. */
  weight?: number;
};

/** A space as a product of coordinates. */
export interface SpaceDescription {
  /** The coordinates, 1 to 8. */
  coordinates: readonly CoordinateDescription[];
  /** How the weighted differences combine: by their sum, the root of the sum of their squares (default), or that without wrap-around. */
  metric?: "sum" | "euclidean" | "naive";
}

/** What is free, by clearance: edges are proven. */
export interface ByClearance {
  /**
   * Writes, for each configuration, a lower bound on its distance to collision: 0 or less in collision, `Infinity` where nothing is near.
   * @param rows  configurations, one after the other; valid during the call only
   * @param clearances  where to write; its length is the number of configurations
   */
  clearance(rows: Float64Array, clearances: Float64Array): void;
  /**
   * How far any point of the robot moves at most, per unit of each coordinate, 0 to 1e6: then clearances are distances in the workspace.
   * Without it they are distances in the metric of the space.
   */
  reach?: readonly number[];
}

/** What is free, by samples: nothing is proven. */
export interface BySamples {
  /**
   * Writes, for each configuration, 1 if it is free and 0 if it is not.
   * @param rows  configurations, one after the other; valid during the call only
   * @param free  where to write; its length is the number of configurations
   */
  isFree(rows: Float64Array, free: Float64Array): void;
  /** The largest distance of neighbouring samples of an edge, in the metric; by default a hundredth of the largest distance in the space. */
  resolution?: number;
}

/** A problem of a custom robot: see `Problem`. */
export type ProblemDescription = {
  /** The configurations. */
  space: SpaceDescription;
  /** The start. */
  start: Configuration;
} & ({
  /** The goal. */
  goal: Configuration;
} | {
  /** Goals, of which one is to be reached. */
  goals: readonly Configuration[];
}) & (ByClearance | BySamples);

/** Options of `planner.query`. */
export interface QueryOptions {
  /** Whether start and goal stay in the roadmap, with their edges, as its last two vertices; `false` by default. */
  keep?: boolean;
}

/** Options of `scenario.sampleConfigurations`. */
export interface SampleOptions {
  /** A whole number from 0 (default) to 2^53 - 1. */
  seed?: number;
  /** Whether only free configurations are returned; `false` by default. */
  free?: boolean;
}

/** Options of `scenario.optimum`. */
export interface OptimumOptions {
  /** The name of the query; the first by default. */
  query?: string;
  /** The metric of an arm; `sum` by default. */
  metric?: "sum" | "euclidean" | "naive";
}

/** Options of `scenario.shortestPaths`. */
export interface ShortestPathsOptions {
  /** Whether all tangents between obstacles are found beforehand; `false` by default. Preparation then takes up to about twelve
   * times as long; the longest queries take a fifth to a thirtieth of the time on large maps, short ones may take longer. A
   * world that is too large and too open stays as it is; then `tangents` of what is prepared is null. */
  manyQueries?: boolean;
}

/** Options of `scenario.certify`. */
export interface CertifyOptions {
  /** The name of the query; the first of the scenario by default. */
  query?: string;
  /** The clearance that paths have to exceed, in metres, at least 0 (default). */
  clearance?: number;
  /** The number of cells after which it ends undecided, 1 to 1,000,000; 50,000 by default. */
  cells?: number;
}

/** Options of `scenario.rollout`. */
export interface RolloutOptions {
  /** Along the exact arc (default), or by Euler's explicit method: places on another circle, off by O(dt). */
  integration?: "exact" | "euler";
  /** The length of a step, in seconds, from 1e-6 to 1e6; `integration_step` of the car by default, 0.01 where it names none. */
  dt?: number;
}

/** The size of a picture of the configuration space, in cells. */
export interface CspaceOptions {
  /** Cells along the first joint, from 1 to 4096. */
  width: number;
  /** Cells along the second joint, from 1 to 4096. */
  height: number;
}

/** Options of `planner.growth`. */
export interface GrowthOptions {
  /** The time of one slice, in milliseconds; 8 by default. */
  budget?: number;
}

/** What a slice of a run has added. */
export interface Growth {
  /** The status after the slice. */
  status: Status;
  /** Iterations made so far. */
  iterations: number;
  /** The new vertices: see `planner.verticesSince`. */
  vertices: Float64Array;
  /** The new edges: see `planner.edgesSince`. */
  edges: Uint32Array;
  /** The new events: see `planner.eventsSince`. */
  events: Float64Array;
}

export interface Planner {
  /**
   * The roadmap of a planner that builds one, as far as it is built; `scenario.resume`, or `problem.resume`, continues with it.
   * @throws {PlanariumError} `unsupported` if the planner builds no roadmap; `out-of-range` for another format
   */
  roadmap(format: "binary"): Uint8Array;
  /** The roadmap as text: JSON for `resume`, GraphML for other programs. */
  roadmap(format: "json" | "graphml"): string;
  /**
   * Steps the run to its end in slices, and yields what each has added. Between slices other tasks run, so that a page stays
   * responsive; `break` stops the run where it is. The loop begins with what has grown before.
   * @throws {PlanariumError} `not-finite`, `out-of-range`, `wrong-type` for the budget; `freed` once the planner is freed
   */
  growth(options?: GrowthOptions): AsyncGenerator<Growth, void, undefined>;
  /** The same as `growth()`, for `for await (const growth of planner)`. */
  [Symbol.asyncIterator](): AsyncGenerator<Growth, void, undefined>;
}
"#;
