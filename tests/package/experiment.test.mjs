/** Experiments and statistics through the package: the rows equal the native tests'. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Experiment, ecdf, mean, movingAverage, paired, quartiles, share } from "planarium/full";
import { fails } from "./scenes.mjs";

/** @import { ExperimentDocument, TrialRow } from "planarium/full" */

/** @type {{ experiment: ExperimentDocument, outcome: { rows: string[], summary: string } }[]} */
const golden = JSON.parse(readFileSync(new URL("../golden-experiment.json", import.meta.url), "utf8"));

/** @type {ExperimentDocument} */
const small = {
  format: "planarium-experiment-1",
  worlds: [{ generate: "discs", set: { count: 5 }, seeds: [1, 2] }],
  planners: [{ algorithm: "rrt", vary: { goal_bias: [0.05, 0.2] } }],
  seeds: { from: 3, count: 4 },
};

/** The row of a trial. @param {Experiment} experiment @param {number} number @param {number} slice */
function rowOf(experiment, number, slice) {
  const trial = experiment.trial(number);
  while (slice > 0 ? trial.step(slice) : trial.stepFor(1));
  const row = trial.row();
  assert.deepEqual(Object.keys(row).sort(), experiment.columns.toSorted());
  assert.ok(
    trial.buildSeconds + trial.searchSeconds >= 0 && trial.iterations === row.iterations && trial.status === row.status,
  );
  trial.free();
  return row;
}

test("rows and summaries are the committed ones, however a trial is stepped", () => {
  for (const { experiment: document, outcome } of golden) {
    for (const slice of [0, 16, 1e9]) {
      const experiment = Experiment.parse(slice ? document : JSON.stringify(document));
      const { columns, trialCount } = experiment;
      assert.equal(trialCount, outcome.rows.length);
      const rows = outcome.rows.map((_, number) => rowOf(experiment, number, slice));
      // As lines of CSV without quotes.
      assert.deepEqual(
        rows.map((row) => columns.map((column) => row[column] ?? "").join(",")),
        outcome.rows,
      );
      assert.deepEqual(experiment.summary(rows.toReversed()), JSON.parse(outcome.summary), "in any order");
      experiment.free();
    }
  }
});

test("a summary has the rows that it was given, and times if they have some", () => {
  const experiment = Experiment.parse({ ...small, measures: ["build_seconds", "rejected_samples"] });
  assert.deepEqual(experiment.summary([]), {
    experiment: experiment.fingerprint,
    trials: 16,
    rows: 0,
    groups: [],
    comparisons: [],
  });
  /** @type {TrialRow} */
  const row = { ...rowOf(experiment, 0, 1e9), build_seconds: 0.25 };
  assert.equal(row.status, "solved");
  const {
    rows,
    groups: [{ solved, measures }, ...others],
  } = experiment.summary([row]);
  assert.deepEqual([rows, others.length, solved.n, solved.missing], [1, 0, 1, 7]);
  assert.equal(measures.build_seconds?.mean.mean, 0.25);
  /** @param {object} change */
  const given = (change) => () => experiment.summary([row, /** @type {TrialRow} */ ({ ...row, ...change })]);
  assert.deepEqual(experiment.summary([row, { ...row }]), experiment.summary([row]), "the same row counts once");
  fails(given({ status: "exhausted" }), "duplicate-name", "/rows/1/trial");
  fails(given({ build_seconds: 0.5 }), "duplicate-name", "/rows/1/trial");
  fails(given({ experiment: "0" }), "other-experiment", "/rows/1/experiment");
  fails(given({ trial: 16 }), "out-of-range", "/rows/1/trial");
  fails(given({ trial: "first" }), "out-of-range", "/rows/1/trial");
  fails(() => experiment.summary(/** @type {any} */ ([3])), "wrong-type", "/rows/0");
  fails(() => experiment.summary(/** @type {any} */ ("rows")), "wrong-type", "/rows");
});

test("an experiment says what it is", () => {
  const experiment = Experiment.parse({ ...small, title: "Bias", measures: ["visited"] });
  assert.deepEqual([experiment.title, experiment.trialCount, experiment.measures], ["Bias", 16, ["visited"]]);
  assert.deepEqual(experiment.columns.slice(0, 8), [
    "experiment",
    "trial",
    "world",
    "world_seed",
    "query",
    "planner",
    "planner.goal_bias",
    "seed",
  ]);
  assert.equal(Experiment.parse(small).fingerprint, experiment.fingerprint);
  assert.deepEqual(Experiment.parse(small).measures, ["length", "iterations", "clearance_evaluations"]);
});

test("wrong documents and trials are errors with code and pointer", () => {
  const bad = /** @type {(change: object) => () => unknown} */ (
    (change) => () => Experiment.parse(/** @type {any} */ ({ ...small, ...change }))
  );
  fails(bad({ seeds: { from: 0, count: NaN } }), "not-finite", "/seeds/count");
  fails(() => Experiment.parse(/** @type {any} */ (3)), "wrong-type", "");
  const experiment = Experiment.parse(small);
  fails(() => experiment.trial(16), "out-of-range", "/number");
  fails(() => experiment.trial(-1), "out-of-range", "/number");
  const trial = experiment.trial(0);
  fails(() => trial.row(), "unsupported", "");
  fails(() => new /** @type {any} */ (Experiment)(), "illegal-constructor", "");
  experiment.free();
  assert.equal(trial.step(1e9), false, "a trial outlives its experiment");
  assert.equal(trial.row().trial, 0);
});

test("statistics are records, and count what is missing", () => {
  const sample = [3, NaN, 1, 2, NaN];
  assert.deepEqual(quartiles(sample), { n: 3, missing: 2, values: [1, 1.5, 2, 2.5, 3] });
  assert.deepEqual(ecdf(Float64Array.from(sample)), { n: 3, missing: 2, values: [1, 2, 3], shares: [0.2, 0.4, 0.6] });
  const { share: solved, low, high } = share([1, 0, 1, 1]);
  assert.ok(solved === 0.75 && low !== null && Math.abs(low - 0.30064184258) < 1e-9 && high !== null && high < 1);
  assert.deepEqual(share([]), { n: 0, missing: 0, count: 0, share: null, low: null, high: null });
  const { mean: middle, needed } = mean(sample);
  assert.ok(middle === 2 && needed !== null && needed > 300);
  assert.deepEqual(Array.from(movingAverage([1, 2, 3, 4], 2)), [NaN, 1.5, 2.5, 3.5]);
  const { n, smaller, words } = paired([1, 2, 3, NaN], [2, 3, 4, 1], "A", "B", "length");
  assert.deepEqual([n, smaller], [3, 3]);
  assert.match(words, /^The length of A is smaller than that of B in 3 of 3 pairs/);
  fails(() => paired([1], [1, 2], "A", "B", "length"), "wrong-dimension", "/b");
  fails(() => quartiles(/** @type {any} */ (["1"])), "wrong-type", "/sample/0");
});
