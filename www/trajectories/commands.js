/** The commands of this page, which its worker runs: the experiment, with the time of each trajectory. */
import { rowsOf } from "../domain/coordinates.js";
import { withOptions } from "../domain/option-names.js";
import { Trajectories, particlePoints } from "planarium/full";

/** @import { TrajectoryOptions } from "planarium/full" */

/** Milliseconds of a call, at most. */
const LONGEST = 24;
/** Radians of a turn between two points of a line, and pieces of a line at most. */
const BEND = 0.13;
const MOST_PIECES = 800;

/** @type {Trajectories | null} */
let trajectories = null;
/** @type {TrajectoryOptions["model"]} */
let model = "arc";
/** Milliseconds spent since the last trajectory was accepted. */
let spent = 0;

export const commands = {
  /** @param {TrajectoryOptions} options @throws {Error} they are refused */
  begin(options) {
    const begun = withOptions(options, (named) => new Trajectories(named));
    trajectories?.free();
    trajectories = begun;
    model = options.model ?? "arc";
    spent = 0;
    return begun.result();
  },

  /** Makes at most this number of tries, fewer where they take long. @param {number} count */
  advance(count) {
    if (!trajectories) throw new Error("No experiment has begun.");
    const { acceptedCount, refusedCount } = trajectories;
    const { milliseconds, done } = makeTries(trajectories, count);
    /** Rows of x, y, theta, v, w, duration. */
    const accepted = trajectories.acceptedSince(acceptedCount);
    /** The last one, if any: the same, the number of the one it crosses, and where. */
    const rejected = trajectories.refusedSince(Math.max(refusedCount, trajectories.refusedCount - 1));
    /** Points of each accepted one at equal times, then of the rejected one. */
    const lines = [...rowsOf(accepted, 6), ...rowsOf(rejected.slice(0, 6), 6)].map(lineOf);
    const tries = trajectories.tries();
    const result = trajectories.result();
    const isLastRejected = result.iterations > tries.reduce((sum, one) => sum + one, 0);
    return { done, accepted, rejected, milliseconds, tries: tries.slice(acceptedCount), lines, result, isLastRejected };
  },
};

/** @typedef {typeof commands} Commands */
/** The outcome of some tries. @typedef {ReturnType<Commands["advance"]>} Progress */

export function reset() {
  trajectories = null;
}

/**
 * Tries one by one, with the milliseconds for each accepted one and the tries rejected before it.
 * @param {Trajectories} all
 * @param {number} count
 */
function makeTries(all, count) {
  const end = performance.now() + LONGEST;
  const milliseconds = [];
  let done = 0;
  let last = performance.now();
  while (done < count && all.status === "running" && last <= end) {
    const { acceptedCount } = all;
    all.step(1);
    done++;
    const now = performance.now();
    spent += now - last;
    last = now;
    if (all.acceptedCount === acceptedCount) continue;
    milliseconds.push(spent);
    spent = 0;
  }
  return { milliseconds, done };
}

/** Points of a trajectory at equal times. @param {Float64Array} row */
function lineOf([x, y, theta, v, w, duration]) {
  const bend = Math.abs(w) * duration * (model === "spiral" ? 2 : 1);
  const pieces = v * duration === 0 ? 1 : Math.min(MOST_PIECES, Math.max(1, Math.ceil(bend / BEND)));
  const times = Float64Array.from({ length: pieces + 1 }, (_, i) => (duration * i) / pieces);
  return Float32Array.from(particlePoints({ model, x, y, theta, v, w }, times));
}
