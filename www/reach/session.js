/** The state of the page: the robot, the mode, the configurations A and B, and the target. */
import { Robot } from "./robot.js";
import { Motion } from "./motion.js";
import { SCENES } from "./scenes.js";

/** @import { App } from "../app/app.js" */
/** @import { Check, Point, Query, ScenarioDocument } from "../domain/types.js" */
/** @import { IkRun } from "./ik-run.js" */
/** @import { Direction } from "./motion.js" */
/** @import { SceneEntry } from "./scenes.js" */
/** @typedef {"hand" | "between" | "solve"} Mode   dragging, the motion from A to B, inverse kinematics */

/**
 * The outcome of moving the tip to a point: the nearest point, its distance in metres, and whether another
 * configuration would come nearer.
 * @typedef {{ wanted: Point, point: Point, distance: number, reached: boolean, isStuck: boolean }} TipGoal
 */

/**
 * A turn or a slide that was taken back: the coordinate, the angle in radians or the way in metres, and the collisions
 * at its end.
 * @typedef {{ i: number, angle: number, check: Check }} Refusal
 */

/** The part of its reach by which another configuration must come nearer for the arm to be stuck. */
const STUCK = 1e-3;

export class ReachSession {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    const [entry] = SCENES;
    this.robot = new Robot(entry.document, entry.q);
    /** The scene, unless it is a file. @type {SceneEntry | null} */
    this.entry = entry;
    /** @type {Mode} */
    this.mode = "hand";
    this.a = Float64Array.from(entry.a);
    this.b = Float64Array.from(entry.b);
    /** The way round of each coordinate from A to B. @type {Direction[]} */
    this.directions = [];
    /** The part of the motion that is done, 0 to 1. */
    this.progress = 0;
    /** The orientation of the last link, radians; null: any. @type {number | null} */
    this.orientation = null;
    this.target = entry.target;
    /** @type {TipGoal | null} */
    this.tipGoal = null;
    /** Whether a turn by a key is taken back if it collides, and the last one that was. */
    this.takesBack = false;
    /** @type {Refusal | null} */
    this.refusal = null;
    /** The run of inverse kinematics, in that mode. @type {IkRun | null} */
    this.run = null;
    /** The index of the solution that the arm shows, or -1. */
    this.chosen = -1;
    /** The motion, and what it was computed for. @type {{ key: string, robot: Robot, motion: Motion } | null} */
    this.computed = null;
  }

  /** @param {SceneEntry} entry @throws {Error} the core refuses it */
  openScene(entry) {
    this.open(entry.document, entry);
  }

  /**
   * Opens a scenario.
   * @param {ScenarioDocument | string} document
   * @param {SceneEntry | null} [entry]  null: it is the user's
   * @throws {Error} the core refuses it
   */
  open(document, entry = null) {
    const robot = new Robot(document, []);
    const { q, a, b, target, orientation } = { ...configurationsOf(robot), ...entry };
    robot.moveTo(q);
    if (!robot.isArm && this.mode === "solve") this.mode = "hand";
    this.replace(robot, {
      entry,
      a: robot.fitted(a),
      b: robot.fitted(b),
      target,
      orientation,
      directions: robot.coordinates.map(() => "short"),
      progress: 0,
    });
    if (this.mode === "between") this.setProgress(0);
  }

  /**
   * Changes the arm within the same world.
   * @param {ScenarioDocument} document
   * @throws {Error} the core refuses it, and nothing changes
   */
  changeArm(document) {
    const { a, b, directions } = this;
    const robot = new Robot({ ...document, queries: [] }, this.robot.q);
    this.replace(robot, {
      a: robot.fitted(a),
      b: robot.fitted(b),
      directions: robot.coordinates.map((_, i) => directions[i] ?? "short"),
    });
  }

  /** @param {Robot} robot @param {Partial<ReachSession>} changes */
  replace(robot, changes) {
    this.robot.free();
    Object.assign(this, { ...changes, robot, tipGoal: null, refusal: null });
    if (robot.dimension < 3) this.orientation = null;
    this.app.changed();
  }

  /** @param {ArrayLike<number>} q @param {TipGoal | null} [tipGoal] */
  moveTo(q, tipGoal = null) {
    this.robot.moveTo(q);
    Object.assign(this, { tipGoal, refusal: null });
    this.app.changed();
  }

  /** @param {number} i @param {number} value */
  setCoordinate(i, value) {
    this.moveTo(this.robot.q.with(i, value));
  }

  /**
   * Moves a joint or a body; a motion that collides, also on its way, is taken back if that is wanted.
   * @param {number} i  the coordinate
   * @param {number} angle  radians, or metres
   */
  turn(i, angle) {
    const { robot, takesBack } = this;
    const q = robot.fitted(robot.q.with(i, robot.q[i] + angle));
    const collides = () => (robot.check.free ? robot.scenario.firstHit(robot.q, q) !== null : !robot.isFree(q));
    if (!takesBack || !collides()) return this.moveTo(q);
    this.refusal = { i, angle, check: robot.scenario.check(q) };
    this.app.changed();
  }

  /** Moves the tip to a point, or as near as it gets. @param {Point} wanted */
  moveTip(wanted) {
    const { robot } = this;
    const orientation = this.orientation ?? undefined;
    const { configuration, point, distance, reached } = robot.scenario.follow(robot.q, wanted, orientation);
    // With a link that slides only the arm's own way there is known.
    const nearest = reached || robot.slides ? null : robot.scenario.nearestReachable(wanted, orientation);
    const isStuck = nearest !== null && nearest.distance < distance - STUCK * robot.reach;
    this.moveTo(configuration, {
      wanted,
      reached,
      isStuck,
      ...(nearest && !isStuck ? { point: nearest.point, distance: nearest.distance } : { point, distance }),
    });
  }

  /** @param {Mode} mode */
  setMode(mode) {
    Object.assign(this, { mode, tipGoal: null, refusal: null });
    if (mode === "between") this.setProgress(0);
    this.app.changed();
  }

  /** The motion from A to B. @returns {Motion} */
  get motion() {
    const { robot, a, b, directions, computed } = this;
    const key = [...a, ...b, ...directions].join();
    if (computed?.key === key && computed.robot === robot) return computed.motion;
    const motion = new Motion(robot, a, b, directions);
    this.computed = { key, robot, motion };
    return motion;
  }

  /** @param {number} progress */
  setProgress(progress) {
    this.progress = Math.min(1, Math.max(0, progress));
    this.moveTo(this.motion.at(this.progress));
  }

  /** The query to reach the target from a configuration. @param {ArrayLike<number>} start @returns {Query} */
  targetQuery(start) {
    const { target: point, orientation } = this;
    return {
      name: "reach",
      start: Array.from(start),
      target: { point, ...(orientation === null ? {} : { orientation }) },
    };
  }

  /** The robot and its world with the query A to B, and for an arm that of the target. @returns {ScenarioDocument} */
  document() {
    const { robot, a, b } = this;
    return {
      ...robot.document,
      queries: [{ name: "a-to-b", start: [...a], goal: [...b] }, ...(robot.isArm ? [this.targetQuery(robot.q)] : [])],
    };
  }
}

/** The configurations of the first query; without it others are chosen. @param {Robot} robot */
function configurationsOf(robot) {
  const { isArm, coordinates, scenario } = robot;
  const { queries } = robot.document;
  const middle = coordinates.map(({ low, high }) => (low + high) / 2);
  const [{ start: q = middle, goal, target: wanted }] = /** @type {[Partial<Query>]} */ ([...queries, {}]);
  /** @type {Point} */
  const free = isArm ? [robot.base[0] + 0.6 * robot.reach, robot.base[1] + 0.2 * robot.reach] : [0, 0];
  const target = wanted?.point ?? (goal ? scenario.endEffector(goal) : free);
  const orientation = wanted?.orientation ?? null;
  const near = () =>
    (robot.slides
      ? scenario.follow(robot.fitted(q), target, orientation)
      : scenario.nearestReachable(target, orientation)
    ).configuration;
  const b = goal ?? (isArm ? near() : middle);
  return { q, a: q, b, target, orientation };
}
