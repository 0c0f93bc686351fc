/** The experiment itself, beside the page: it tries trajectories and tells what has come of them, with the time that each took. */
import { Trajectories, particlePoints, trajectoryOptions } from "planarium";
import { withOptions } from "../option-names.js";
import { handed, serve } from "../room/serve.js";

/** @import { TrajectoryOptions } from "planarium" */

/** Milliseconds after which an answer is given, however much was asked for. */
const LONGEST = 24;
/** Radians of a turn between two points of a line. */
const BEND = 0.13;
/** Pieces of a line at most. */
const MOST_PIECES = 800;

/** @type {Trajectories | null} */
let trajectories = null;
/** @type {TrajectoryOptions["model"]} */
let model = "arc";
/** Since when the next one to be accepted is looked for. */
let spent = 0;

/**
 * @typedef {object} News   what a few tries have come to
 * @property {number} done       tries made
 * @property {string} status
 * @property {Float64Array} accepted   rows of x, y, theta, v, w, duration
 * @property {Float64Array} refused    the last one refused, if any: the same, the number of the one it crosses, and where
 * @property {Float64Array} milliseconds   of each accepted one, those refused before it included
 * @property {Uint32Array} tries   for each accepted one
 * @property {Float32Array[]} lines   points of each accepted one at equal times; then of the refused one
 * @property {boolean} isLastRefused   of all tries so far
 * @property {import("planarium").TrajectoriesResult} result
 */

const commands = {
  /** What can be set. */
  table() { return trajectoryOptions(); },

  /** Begins anew. @param {TrajectoryOptions} options @throws {Error} they are refused: code and pointer */
  begin(options) {
    const begun = withOptions(options, (named) => new Trajectories(named));
    trajectories?.free();
    trajectories = begun;
    model = options.model ?? "arc";
    spent = 0;
    return begun.result();
  },

  /** Tries at most so many, fewer where that takes long. @param {number} count @returns {News} */
  advance(count) {
    if (!trajectories) throw new Error("Nothing has begun.");
    const before = { accepted: trajectories.acceptedCount, refused: trajectories.refusedCount };
    const { milliseconds, done } = tried(trajectories, count);
    const accepted = trajectories.acceptedSince(before.accepted);
    const refusedCount = trajectories.refusedCount;
    const refused = trajectories.refusedSince(Math.max(before.refused, refusedCount - 1));
    const tries = trajectories.tries().slice(before.accepted);
    /** @type {Float32Array[]} */
    const lines = [];
    for (let i = 0; i < accepted.length; i += 6) lines.push(lineOf(accepted.subarray(i, i + 6)));
    if (refused.length > 0) lines.push(lineOf(refused.subarray(0, 6)));
    const result = trajectories.result();
    const isLastRefused = tries.length > 0 ? spent > 0 || result.iterations > lastAccepted(trajectories) : refused.length > 0;
    const news = { done, status: result.status, accepted, refused, milliseconds: Float64Array.from(milliseconds), tries, lines, isLastRefused, result };
    return handed(news, lines.map(({ buffer }) => buffer));
  },
};

/** The number of the try by which the last one was accepted. @param {Trajectories} all */
function lastAccepted(all) { return all.tries().reduce((sum, tries) => sum + tries, 0); }

/**
 * Tries, one by one, for the time of each.
 * @param {Trajectories} all @param {number} count
 */
function tried(all, count) {
  const end = performance.now() + LONGEST;
  /** @type {number[]} */
  const milliseconds = [];
  let accepted = all.acceptedCount;
  let done = 0;
  let last = performance.now();
  while (done < count && all.status === "running") {
    all.step(1);
    done++;
    const now = performance.now();
    spent += now - last;
    last = now;
    if (all.acceptedCount > accepted) {
      accepted++;
      milliseconds.push(spent);
      spent = 0;
    }
    if (now > end) break;
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

/** @typedef {typeof commands} Commands */

serve(commands, () => { trajectories = null; });
