import type { ScenarioDocument } from "./core.js";

/** A file of a world. */
export interface WorldFile {
  /** The name, which may have folders; other files refer to it. */
  name: string;
  /** The content. */
  bytes: Uint8Array;
}

/** A world that was read. */
export interface World {
  /** The scenario, for `Scenario.parse` or `solve`. */
  scenario: ScenarioDocument;
  /** What was read, dropped, merged, moved and grown. Lengths in metres. */
  report: WorldReport;
  /** Of maps and pictures, the cells as the file has them, whatever the options make of them. */
  grid?: WorldGrid;
}

/** The cells of a map and where they lie, in the coordinates of the scenario. */
export interface WorldGrid {
  /** The columns. */
  width: number;
  /** The rows. */
  height: number;
  /** Metres per cell. */
  resolution: number;
  /** The lower left corner of the first cell. */
  origin: [number, number];
  /** The turn about that corner, in radians, counter-clockwise. */
  yaw: number;
  /** A byte per cell, row by row from the lowest y: 0 is free, 1 occupied, 2 unknown. */
  cells: Uint8Array;
}

/** The robot of a world, in metres and radians. */
export type WorldRobot =
  | { type: "point" }
  | { type: "disc"; radius: number }
  /** A polygon that moves and turns about the origin. */
  | { type: "footprint"; corners: readonly (readonly [number, number])[] }
  /** A rectangular car; `wheelbase` is 0.6 of the length by default, the largest `steering` angle 0.6. */
  | { type: "car"; length: number; width: number; wheelbase?: number; steering?: number };

/** Options of `readPath`. */
export interface PathOptions {
  /** The scenario, as `readWorld` gives it or `scenario.document()`: of its robot is the path, and in the coordinates of its map. */
  scenario: ScenarioDocument;
  /** The unit of angles for which the file names none: radians by default, and refused if they look like degrees. */
  angles?: Angles;
}

/** A path that was read. */
export interface PathRead {
  /** The waypoints in the coordinates of the scenario, rows of `dimension` numbers, in metres and radians: for `scenario.judge`. */
  waypoints: Float64Array;
  /** The number of numbers of a configuration. */
  dimension: number;
  /** What was read and left out. */
  report: PathReport;
}

/**
 * A path to write: rows of numbers one after the other, in metres and radians, in the coordinates of the scenario. The number of numbers of a
 * configuration, `dimension`, is that of the robot by default; of a disc with its heading it is 3, as `trajectory.dimension` has it.
 */
export type PathToWrite =
  /** Rows of a configuration: `scenario.pathRows(result)`, or any path. */
  | { configurations: Float64Array; states?: undefined; dimension?: number }
  /** Rows of the time, the configuration, the velocity and the acceleration: `trajectory.sample(dt)` or `trajectory.rows()`. */
  | { states: Float64Array; configurations?: undefined; dimension?: number };

/** Options of `writePath`. */
export interface PathWriteOptions {
  /** The scenario, as `readWorld` gives it or `scenario.document()`. */
  scenario: ScenarioDocument;
  /** The form. */
  form: PathForm;
  /** The name of the query, which JSON and GeoJSON have; none by default. */
  query?: string;
  /** Of poses of ROS, the name of the frame that they are in; `map` by default. */
  frameId?: string;
}
