/** The commands of this page, which each worker of its pool runs: an experiment, and some of its trials. */
import { Experiment, Scenario } from "planarium/full";
import { errorInfo } from "../app/error-info.js";
import { withOptions } from "../domain/option-names.js";

/** @import { CertificateVerdict, ExperimentDocument, Trial } from "planarium/full" */
/** @import { TrialWorld } from "./worlds.js" */
/** @import { Cell } from "./rows.js" */

/** What a certificate says, or that there is none for the robot. @typedef {CertificateVerdict | "unsupported"} Verdict */

/** Cells of a subdivision, at most: about a second. */
const CELLS = 5000;

/** @type {Experiment | null} */
let experiment = null;
/** The trial that runs. @type {Trial | null} */
let trial = null;
/** The next trial, and the one at which the job ends. */
let next = 0;
let end = 0;

export const commands = {
  /**
   * Replaces the experiment.
   * @param {ExperimentDocument} document
   * @throws {Error} with code and pointer: it is refused, and there is none
   */
  open(document) {
    reset();
    experiment = Experiment.parse(document);
    const { trialCount, columns, measures, fingerprint, title } = experiment;
    return { trialCount, columns, measures, fingerprint, title };
  },

  /**
   * Goes on with a job for about some time: trials from the first up to, but not including, the last.
   * @param {[number, number] | null} job  a new one, which replaces the one before, or null @param {number} milliseconds
   * @returns {{ first: number, rows: Cell[][], seconds: Float64Array, isDone: boolean }}  the rows of trials that
   *   ended, from the first of them on; two times of each
   */
  advance(job, milliseconds) {
    if (!experiment) throw new Error("No experiment is open.");
    if (job) {
      freeTrial();
      [next, end] = job;
    }
    const { columns } = experiment;
    const until = performance.now() + milliseconds;
    const first = next;
    const rows = [];
    const seconds = [];
    do {
      trial ??= experiment.trial(next);
      if (trial.stepFor(Math.max(1, until - performance.now()))) break;
      const row = trial.row();
      rows.push(columns.map((column) => row[column]));
      seconds.push(trial.buildSeconds, trial.searchSeconds);
      freeTrial();
      next++;
    } while (next < end && performance.now() < until);
    return { first, rows, seconds: Float64Array.from(seconds), isDone: next >= end };
  },

  /** Whether a query of a world has a path. @param {TrialWorld} world @param {string} query @returns {Verdict} */
  certify(world, query) {
    const scenario =
      "scenario" in world
        ? Scenario.parse(world.scenario)
        : withOptions(world.options, (options) => Scenario.generate(world.generate, options));
    try {
      const subdivision = scenario.certify({ query, cells: CELLS });
      while (subdivision.stepFor(1000) === "running");
      const { verdict } = subdivision;
      subdivision.free();
      return verdict ?? "unknown";
    } catch (error) {
      if (errorInfo(error).code === "unsupported") return "unsupported";
      throw error;
    } finally {
      scenario.free();
    }
  },
};

/** @typedef {typeof commands} Commands */
/** What is known of an experiment. @typedef {ReturnType<Commands["open"]>} Info */

function freeTrial() {
  trial?.free();
  trial = null;
}

export function reset() {
  freeTrial();
  experiment?.free();
  experiment = null;
  next = end = 0;
}
