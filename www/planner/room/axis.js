/** Metres along a path: of the tip of an arm, the centre of a disc, the reference point of a body or a car. */
import { firstIndex } from "../../domain/search.js";

/** @import { Scenario } from "../../domain/types.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */

/** Times of a path that is timed at which a place is sought. */
const TIMES = 600;

export class ClearanceAxis {
  /** @param {Scenario} scenario @param {PathPlayback} playback */
  constructor(scenario, playback) {
    this.scenario = scenario;
    this.playback = playback;
    const { rows, parts } = playback.samples;
    this.rows = rows;
    this.parts = parts;
    this.metres = metresOf(scenario.endEffectors(rows));
    this.length = this.metres[this.metres.length - 1];
  }

  /** Metres to each of some points. @param {number[][]} points */
  static ofPoints(points) {
    return metresOf(points.flat());
  }

  /** Metres to a row, and a fraction towards the next one. @param {number} index */
  at(index) {
    return between(this.metres, index);
  }

  /** @param {Float64Array} values   of each row @returns {[number, number][]} */
  points(values) {
    return this.metres.map((x, i) => [x, values[i]]);
  }

  /** Metres to where the robot is. */
  now() {
    const { playback, parts } = this;
    if (playback.timed) return this.at(this.nearestRow(playback.pose));
    return this.at(indexIn(parts, playback.at));
  }

  /** The part of the playback at which the robot is there. @param {number} metres */
  part(metres) {
    const index = indexIn(this.metres, metres);
    const { timed } = this.playback;
    if (!timed) return between(this.parts, index);
    const pose = this.row(Math.round(index));
    const times = Array.from({ length: TIMES + 1 }, (_, i) => i / TIMES);
    return leastOf(times, (part) => this.scenario.distance(timed.pose(part), pose));
  }

  /** @param {number} i */
  row(i) {
    const { dimension } = this.scenario;
    return this.rows.subarray(i * dimension, (i + 1) * dimension);
  }

  /** @param {Float64Array} pose */
  nearestRow(pose) {
    const all = Array.from(this.parts, (_, i) => i);
    return leastOf(all, (i) => this.scenario.distance(pose, this.row(i)));
  }
}

/** Metres to each of some points, x and y in turn. @param {ArrayLike<number>} points @returns {number[]} */
function metresOf(points) {
  const metres = [0];
  for (let i = 2; i < points.length; i += 2)
    metres.push(metres[metres.length - 1] + Math.hypot(points[i] - points[i - 2], points[i + 1] - points[i - 1]));
  return metres;
}

/**
 * Where a value is among values that do not fall: an index, and a fraction towards the next one.
 * @param {ArrayLike<number>} values
 * @param {number} value
 */
function indexIn(values, value) {
  const i = firstIndex(1, values.length - 1, (one) => values[one] > value) - 1;
  const step = values[i + 1] - values[i];
  return Math.max(0, Math.min(values.length - 1, i + (step > 0 ? (value - values[i]) / step : 0)));
}

/** The value at an index and a fraction. @param {ArrayLike<number>} values @param {number} index */
function between(values, index) {
  const i = Math.min(values.length - 1, Math.floor(index));
  const next = values[Math.min(values.length - 1, i + 1)];
  return values[i] + (index - i) * (next - values[i]);
}

/** The one with the least value. @param {number[]} all @param {(one: number) => number} of */
function leastOf(all, of) {
  let [best, least] = [all[0], of(all[0])];
  for (const one of all.slice(1)) {
    const value = of(one);
    if (value < least) [best, least] = [one, value];
  }
  return best;
}
