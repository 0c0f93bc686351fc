/**
 * Plays a path: first the line is drawn, then the robot moves to the goal and back again and again, with pauses, at
 * constant speed in the metric of the path. Corners that have blends are rounded. On a path that is timed the robot
 * moves as it is timed, to the goal and from the start again.
 */
import { blendedPath } from "planarium/draw";
import { rowsOf, sizeOf, turnsAlong } from "../../domain/coordinates.js";
import { firstIndex } from "../../domain/search.js";

/** @import { View } from "planarium/draw" */
/** @import { Placed } from "./placed.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @import { Check, Part, ResultDocument, Scenario } from "../../domain/types.js" */
/** @typedef {{ placed: Placed, motions: number[][] }} Course   speed, steering angle and seconds between waypoints */
/**
 * @typedef {object} Timed   when the robot is where on a path
 * @property {number} period   seconds from the start to the goal; in a race those of the slowest robot
 * @property {number} pace     seconds of the robot in one that passes
 * @property {(part: number) => Float64Array} pose   at a part of the period, 0 to 1
 * @property {(part: number) => number} steering     of a car, radians
 * @property {(part: number, context: CanvasRenderingContext2D, view: View, shape: Part, colour: string) => void} drawHeading
 *   of a disc that has one
 */
/**
 * @typedef {{ at: number, pose: Float64Array, check: Check }} Flaw   the first collision: 0 to 1 along the path, the
 *   configuration and its check
 */

/** Seconds in which the line is drawn. */
const DRAWING = 1.4;
/** Seconds of the pause at either end. */
const REST = 0.9;
/** Shortest and longest time for the path, seconds. */
const DRIVE = { least: 1.6, most: 9 };
/** Checks along a segment that is not proven collision-free. */
const LOOKS = 400;

export class PathPlayback {
  /**
   * @param {Scenario} scenario
   * @param {Float64Array} path  rows of `dimension`, at least one
   * @param {{ isProven?: boolean, isMiss?: boolean, raw?: Float64Array | null, course?: Course | null }}
   *   [kind]  whether motions are proven
   *   collision-free; whether the path ends short of the goal; the path before shortcutting; the motions between
   *   waypoints, unless straight
   */
  constructor(scenario, path, { isProven = true, isMiss = false, raw = null, course = null } = {}) {
    this.scenario = scenario;
    this.isProven = isProven;
    this.isMiss = isMiss;
    this.raw = raw;
    this.course = course;
    this.waypoints = rowsOf(path, scenario.dimension);
    /** Distance from the start to each waypoint. */
    this.reached = [0];
    for (let i = 1; i < this.waypoints.length; i++) {
      this.reached.push(
        this.reached[i - 1] +
          (course
            ? course.placed.lengthOf(course.motions[i - 1])
            : scenario.distance(this.waypoints[i - 1], this.waypoints[i])),
      );
    }
    this.length = this.reached[this.reached.length - 1];
    /**
     * How far each joint of an arm turns from the start to the end of the path, radians, counter-clockwise above 0, or
     * slides, metres.
     */
    this.turns = scenario.robot === "arm" ? turnsAlong(this.waypoints, scenario.circles()) : null;
    const speed = scenario.robot === "arm" ? 1.5 : sizeOf(scenario) / 4;
    this.duration = Math.min(DRIVE.most, Math.max(DRIVE.least, this.length / speed));
    /** The part of the line that is drawn, 0 to 1. */
    this.drawn = 0;
    /** The robot's position, 0 at the start, 1 at the goal. */
    this.at = 0;
    this.heading = 1;
    this.resting = 0;
    /** @type {Timed | null} */
    this.timed = null;
    this.samples = this.sample(Math.min(900, Math.max(120, Math.ceil(this.length / (speed / 40)))));
    /** The first collision of a path that is not proven. @type {Flaw | null} */
    this.flaw = isProven ? null : this.firstFlaw();
  }

  /**
   * The first collision. A motion that is not proven need not collide: it may only pass too near.
   * @returns {Flaw | null}
   */
  firstFlaw() {
    for (const at of this.looks()) {
      const pose = this.configuration(at);
      const check = this.scenario.check(pose);
      if (!check.free) return { at, pose, check };
    }
    return null;
  }

  /**
   * Where to look for a collision, 0 to 1: all along arcs, and along straight motions from the end of their proven
   * part.
   */
  looks() {
    const { scenario, waypoints, reached, length, course } = this;
    if (course) return parts(waypoints.length * 20);
    return waypoints.slice(1).flatMap((to, i) => {
      const hit = scenario.firstHit(waypoints[i], to);
      if (hit === null) return [];
      return parts(LOOKS).map(
        (part) => (reached[i] + (hit + (1 - hit) * part) * (reached[i + 1] - reached[i])) / length,
      );
    });
  }

  /** The configuration at a part of the length. @param {number} part  0 to 1 @returns {Float64Array} */
  configuration(part) {
    const last = this.waypoints.length - 1;
    const target = Math.min(1, Math.max(0, part)) * this.length;
    if (last === 0 || target >= this.length) return this.waypoints[last];
    const low = this.stretch(target);
    const stretch = this.reached[low + 1] - this.reached[low];
    const fraction = stretch > 0 ? (target - this.reached[low]) / stretch : 0;
    if (this.course) return this.course.placed.after(this.waypoints[low], this.course.motions[low], fraction);
    return this.scenario.interpolate(this.waypoints[low], this.waypoints[low + 1], fraction);
  }

  /** The waypoint before a distance from the start. @param {number} target */
  stretch(target) {
    return firstIndex(1, this.waypoints.length - 1, (i) => this.reached[i] > target) - 1;
  }

  /** The configuration at the robot's position. */
  get pose() {
    return this.timed ? this.timed.pose(this.at) : this.configuration(this.at);
  }

  /** Seconds that the robot takes to the goal. */
  get seconds() {
    return this.timed ? this.timed.period / this.timed.pace : this.duration;
  }

  /** The steering angle at the robot's position. */
  get steering() {
    if (this.timed) return this.timed.steering(this.at);
    return this.course?.motions[this.stretch(this.at * this.length)]?.[1] ?? 0;
  }

  /** Configurations along the path, for drawing: equally spaced ones and all waypoints. @param {number} count */
  sample(count) {
    const waypoints = this.length > 0 ? this.reached.map((reached) => reached / this.length) : [];
    const all = Float64Array.from([...parts(count), ...waypoints]).sort();
    const n = this.scenario.dimension;
    const rows = new Float64Array(all.length * n);
    all.forEach((part, i) => rows.set(this.configuration(part), i * n));
    return { rows, parts: all };
  }

  /** Advances the robot. @param {number} seconds */
  advance(seconds) {
    if (this.drawn < 1) {
      this.drawn = Math.min(1, this.drawn + seconds / DRAWING);
      return;
    }
    if (this.resting > 0) {
      this.resting -= seconds;
      if (this.timed && this.resting <= 0 && this.at === 1) this.at = 0;
      return;
    }
    this.at += ((this.timed ? 1 : this.heading) * seconds) / this.seconds;
    if (this.at >= 1 || this.at <= 0) {
      this.at = this.at >= 1 ? 1 : 0;
      this.heading = -this.heading;
      this.resting = REST;
    }
  }

  /** Places the robot on the path. @param {number} part */
  seek(part) {
    this.drawn = 1;
    this.resting = 0;
    this.at = Math.min(1, Math.max(0, part));
  }
}

/** Equally spaced parts from 0 to 1. @param {number} count  one less than there are */
function parts(count) {
  return Array.from({ length: count + 1 }, (_, i) => i / count);
}

/**
 * The playback of a run: its path once solved, or of a tree that failed the path to the vertex nearest to the goal.
 * @param {Scenario} scenario
 * @param {RunLog} run
 * @param {Placed | null} [placed]   of a body or a car
 */
export function playbackOf(scenario, run, placed = null) {
  const { isProven } = run;
  if (run.status === "solved") {
    const raw = run.rawLength > (run.result.cost?.value ?? run.result.length) ? run.rawPath : null;
    return new PathPlayback(scenario, rowsAlong(scenario, run.result), {
      isProven,
      raw,
      course: courseOf(run.result, placed),
    });
  }
  const { approximate } = run.result;
  // A tree whose root is nearest to the goal has no path to show.
  if (!approximate || approximate.path.length < 2) return null;
  return new PathPlayback(scenario, rowsAlong(scenario, approximate), {
    isProven,
    isMiss: true,
    course: courseOf(approximate, placed),
  });
}

/**
 * The playback of a further query of a roadmap; null without a path.
 * @param {Scenario} scenario
 * @param {boolean} isProven
 * @param {ResultDocument} result
 * @param {Placed | null} placed   of a body or a car
 */
export function playbackOfResult(scenario, isProven, result, placed) {
  return result.path.length > 0
    ? new PathPlayback(scenario, rowsAlong(scenario, result), { isProven, course: courseOf(result, placed) })
    : null;
}

/** @param {Scenario} scenario @param {Pick<ResultDocument, "path" | "blends">} result */
function rowsAlong(scenario, result) {
  return Float64Array.from(blendedPath(scenario, result).flat());
}

/** @param {Pick<ResultDocument, "motions">} result @param {Placed | null} placed @returns {Course | null} */
function courseOf({ motions }, placed) {
  return placed && motions ? { placed, motions: motions.map(({ control, duration }) => [...control, duration]) } : null;
}
