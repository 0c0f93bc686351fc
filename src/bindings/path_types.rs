//! The types of timing and of the judge of paths, as TypeScript has them.

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * Limits of `scenario.time`: metres, radians and seconds, each from 1e-6 to 1e9. One number for the speed and one for the acceleration
 * hold in the plane in any direction, of a car along its path, and of an arm for each joint; lists have one for each coordinate.
 */
export interface TimingLimits {
  /** The greatest speed. */
  speed: number | readonly number[] | Float64Array;
  /** The greatest acceleration. */
  acceleration: number | readonly number[] | Float64Array;
  /** Of a body, the greatest turn rate; required unless there are lists. So it is of a disc with `differential`. */
  turnRate?: number;
  /** Of the same, the greatest acceleration of the turn; required likewise. */
  turnAcceleration?: number;
  /** Of a car, the greatest acceleration across its path, the square of the speed times the curvature; any by default. */
  lateralAcceleration?: number;
  /**
   * Whether a disc drives straight edges forward and turns on the spot at each corner, as a round robot with two driven wheels does; it
   * moves in any direction by default. The configurations of its trajectory are x, y and the heading.
   */
  differential?: boolean;
}

/** Options of `scenario.time`. */
export interface TimeOptions {
  /** Whether the path is verified first, as `scenario.verify` does; `true` by default. */
  verify?: boolean;
}

/** Options of `scenario.pathRows` and `trajectory.rows`. */
export interface RowOptions {
  /** The most that straight chords between rows are from arcs and blends, in metres and radians, from 1e-9 to 1e6; 0.001 by default. */
  deviation?: number;
}

/** The limits in the document of a trajectory. */
export type TrajectoryLimits =
  | { type: "coordinates"; speed: number[]; acceleration: number[] }
  | { type: "plane"; speed: number; acceleration: number; turn_rate?: number; turn_acceleration?: number }
  | { type: "car"; speed: number; acceleration: number; lateral_acceleration?: number }
  | { type: "differential"; speed: number; acceleration: number; turn_rate: number; turn_acceleration: number };

/**
 * A piece of a path as a function of a fraction u from 0 to 1, and its knots: rows of u, its rate per second, and its second derivative per
 * second squared from there to the next knot.
 */
export type TrajectoryPiece = { knots: [number, number, number][] } & (
  /** from + u rate. */
  | { type: "straight"; from: number[]; rate: number[] }
  /** from + u rate + u^2 bend. */
  | { type: "parabola"; from: number[]; rate: number[]; bend: number[] }
  /** The arc of a car: its length in metres, negative backward, and its turn in radians. */
  | { type: "arc"; from: [number, number, number]; length: number; turn: number }
);

/** The document of a trajectory. */
export interface TrajectoryDocument {
  /** The format of the document. */
  format: "planarium-trajectory-1";
  /** The name of the scenario. */
  scenario: string;
  /** The name of the query. */
  query: string;
  /** The limits that it keeps at every time. */
  limits: TrajectoryLimits;
  /** The duration, in seconds. */
  duration: number;
  /** The configuration at the beginning. */
  start: number[];
  /** The pieces of the path; none if the start is the goal. */
  pieces: TrajectoryPiece[];
}

/** Options of `scenario.judge`. */
export interface JudgeOptions {
  /** Whether a body or a car moves along its own axis on arcs of constant curvature from waypoint to waypoint; `false` by default. */
  arcs?: boolean;
  /** By how much, as a fraction, a turn may exceed what a car can drive, at least 0; 0.01 by default. */
  driveTolerance?: number;
}

/** A place on a path. */
export interface PathPlace {
  /** The motion, by the index of the waypoint that it begins at, from 0. */
  edge: number;
  /** The fraction of the motion, from 0 to 1. */
  fraction: number;
  /** The configuration there, its angles not wrapped. */
  configuration: number[];
}

/**
 * What ends the free part of a path: an obstacle or the limit of a joint, by its index; a coordinate that turns by half a turn, so that its
 * direction is ambiguous; the bounds; or a stretch too near to obstacles for too long to be proven free.
 */
export type PathBlocked = { obstacle: number } | { "joint-limit": number } | { "half-turn": number } | "bounds" | "unproven";

/** Where a path is no longer free. All before it is proven free. */
export interface PathContact extends PathPlace {
  /** What is there. */
  with: PathBlocked;
  /** The part of the robot that touches it: the link of an arm, from 0. */
  part: number;
  /** Where they touch, in metres; null if nothing is touched. */
  point: Point | null;
}

/** The smallest clearance of a path. */
export interface PathClearance extends PathPlace {
  /** The smallest that was found, that at this place, in metres. */
  distance: number;
  /** No clearance of the path is smaller. */
  at_least: number;
  /** The part of the robot: the link of an arm, from 0. */
  part: number;
  /** The obstacle, by its index. */
  obstacle: number;
  /** The point of the obstacle that is nearest to the robot. */
  point: Point;
}

/** A turn between two waypoints that a car cannot drive. */
export interface PathTurn {
  /** The motion, by the index of the waypoint that it begins at, from 0. */
  edge: number;
  /** Why: it would slide sideways, steer more than it can, or drive in a direction in which it has no speed. */
  fault: "sideways" | "too-tight" | "no-speed";
  /** The radius of its arc, in metres: 0 on the spot; null if it is straight. */
  radius: number | null;
  /** The angle between the way and the heading in the middle, in radians from 0 to pi / 2. */
  slip: number;
}

/** The turns of a path that a car cannot drive. */
export interface PathTurns {
  /** How many there are. */
  count: number;
  /** The first of them, at most 100. */
  first: PathTurn[];
  /** The least radius among the turns of all motions, in metres; null of a straight path. */
  least_radius: number | null;
  /** The largest angle between the way and the heading in the middle of a motion, in radians. */
  largest_slip: number;
}

/** What is known of a path of any origin: what the command line prints. */
export interface PathJudgement {
  /** Whether it is free and, of a car, can be driven. */
  valid: boolean;
  /** Whether all of it is proven free, within the bounds and the limits of the joints. */
  free: boolean;
  /** The number of waypoints. */
  waypoints: number;
  /** Where it is no longer free; null if it is free. */
  contact: PathContact | null;
  /** The smallest clearance of a free path; null of others, and without obstacles. */
  clearance: PathClearance | null;
  /** Of a car, the turns that it cannot drive. */
  turns?: PathTurns;
}
"#;
