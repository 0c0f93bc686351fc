/** Charts of experiments and what is said of them, without a browser. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { ceilingOf, tasksOf } from "../../www/experiments/ceiling.js";
import { captionOf } from "../../www/experiments/chart-view.js";
import { LOG } from "../../www/experiments/charts/parts.js";
import { bySettings } from "../../www/experiments/charts/summaries.js";
import { CHARTS, chartOf, completed, remarkOf } from "../../www/experiments/charts.js";
import { commonTrials } from "../../www/experiments/common.js";
import { comparisons } from "../../www/experiments/comparisons.js";
import { subjectOf } from "../../www/experiments/words.js";
import { Rows } from "../../www/experiments/rows.js";
import { small } from "./experiments.mjs";

/** @import { ExperimentDocument } from "planarium/full" */

test("what is put across is not up any more: another factor is", () => {
  const factors = ["planner.k", "world", "planner"].map((column) => ({
    column,
    title: column,
    unit: "",
    values: [1, 2],
    isNumeric: column === "planner.k",
  }));
  const shown = (/** @type {string} */ axis, /** @type {string} */ second, all = factors) => {
    const { kind, axis: across, second: up } = completed({ chart: "heat", axis, second }, all, [], ["solved"]);
    return [kind.id, across?.column, up?.column];
  };
  assert.deepEqual(shown("world", "planner"), ["heat", "world", "planner"]);
  assert.deepEqual(shown("world", "world"), ["heat", "world", "planner.k"]);
  assert.deepEqual(shown("planner.k", "planner.k"), ["heat", "planner.k", "world"]);
  assert.deepEqual(shown("world", "world", [factors[1]]), ["success", "world", undefined]);
});

test("settings without a path are no baseline; three sentences are enough for any number of settings", () => {
  const rows = new Rows(["planner", "seed", "status", "length"], 12);
  // Two settings without paths, and two with them.
  for (let trial = 0; trial < 12; trial++)
    rows.set(
      trial,
      ["abcd"[Math.floor(trial / 3)], trial % 3, trial < 6 ? "failed" : "solved", trial < 6 ? null : trial],
      [0, 0],
    );
  const factor = { column: "planner", title: "planner", unit: "", values: [..."abcd"], isNumeric: false };
  const lengths = comparisons(rows, [factor], "length");
  assert.deepEqual([lengths.baseline, lengths.other], ["c", "d"]);
  assert.match(lengths.sentences[0], /smallest for c, 7 \(n = 3\), and largest for d, 10 \(n = 3\)/);
  assert.match(lengths.sentences[1], /^The path length of d is smaller than that of c in 0 of 3 pairs/);
  assert.equal(comparisons(rows, [factor], "length", { baseline: "d" }).baseline, "d");
  assert.equal(
    comparisons(rows, [factor], "length", { other: "a" }).sentences[1],
    "No pair has a value of both a and c.",
  );
  const solved = comparisons(rows, [factor], "solved", { baseline: "b", other: "d" }).sentences;
  assert.match(solved[1], /^d alone finds a path in 3 of 3 pairs, b alone in 0: no difference is shown/);
  assert.match(solved[2], /^None of the 3 other settings differs significantly from b\.$/);
  const { which, pairs, left } = commonTrials(rows, [factor]);
  assert.deepEqual([[...which], pairs, left], [[0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1], 3, ["a", "b"]]);
});

test("what Wilcoxon's test shows has the direction of the ranks, not that of most pairs; settings without pairs are left out", () => {
  const rows = new Rows(["planner", "seed", "status", "length"], 160);
  /** @param {string} planner @param {number} seed */
  const lengthOf = (planner, seed) =>
    planner === "b" ? 1 : planner === "a" && seed < 21 ? 1 - 0.001 * (seed + 1) : 2 + seed;
  for (let trial = 0; trial < 160; trial++) {
    const [planner, seed] = ["abcd"[Math.floor(trial / 40)], trial % 40];
    const isSolved = planner !== "d";
    rows.set(trial, [planner, seed, isSolved ? "solved" : "failed", isSolved ? lengthOf(planner, seed) : null], [0, 0]);
  }
  const factor = { column: "planner", title: "planner", unit: "", values: [..."abcd"], isNumeric: false };
  const { sentences } = comparisons(rows, [factor], "length", { baseline: "b", other: "a" });
  assert.match(
    sentences[1],
    /^The path length of a is smaller than that of b in 21 of 40 pairs that both solved, larger in 19: significantly larger, by the sizes of the differences, at 5 %/,
  );
  assert.equal(
    sentences[2],
    "Of the 2 other settings that have pairs, these differ significantly from b: larger: a, c.",
  );
});

test("every chart has a button, fits a measure and says what its marks mean", () => {
  assert.equal(new Set(CHARTS.map(({ id }) => id)).size, CHARTS.length);
  const rows = new Rows(["planner", "planner.k", "seed", "status", "length", "iterations", "clearance_evaluations"], 8);
  for (let trial = 0; trial < 8; trial++)
    rows.set(
      trial,
      ["ab"[trial % 2], trial >> 2, (trial >> 1) % 2, trial === 5 ? "failed" : "solved", trial, 1, 2],
      [0, 0],
    );
  const of = (/** @type {string} */ column, /** @type {any[]} */ values, /** @type {boolean} */ isNumeric) => ({
    column,
    title: column,
    unit: "",
    values,
    isNumeric,
  });
  const factors = [of("planner", ["a", "b"], false), of("planner.k", [0, 1], true)];
  for (const { id, fits, title } of CHARTS) {
    assert.ok(["solved", "length"].some(fits) && title, id);
    const chart = chartOf(rows, factors, { chart: id }, ["length"], "m", { most: 75 });
    assert.deepEqual([chart.kind.id, chart.rows().length > 0, chart.counted.length > 0], [id, true, true]);
    assert.match(remarkOf(chart), /^[A-Z].* n = \d+ (?:each|to \d+)\./, id);
    assert.equal(chart.ceiling, ["success", "line", "ecdf"].includes(id) ? 75 : null, id);
    const captionWhile = (/** @type {number} */ uncertified) =>
      captionOf(chart, { document: small, caption: "", ceiling: null, rows, uncertified });
    const subject =
      "PRM (samples 40), RRT-Connect (max iterations 60); Two links among stones, made (count 20); 8 trials.";
    assert.equal(captionWhile(0), `${subject} ${remarkOf(chart)}`, id);
    const isOfPaths = chart.measure === "solved" || chart.kind.isOfAll === true;
    assert.equal(captionWhile(2).endsWith("still being examined."), isOfPaths, id);
    // Worlds across or in series have ceilings of their own.
    const worlds = [...factors, of("world", ["u", "v"], false)];
    assert.equal(chartOf(rows, worlds, { chart: id }, ["length"], "m", { most: 75 }).ceiling, null, id);
  }
});

test("where one trial in some is a dot, the chart says so", () => {
  const seed = { column: "seed", title: "seed", unit: "", values: [0], isNumeric: true };
  const remarkOver = (/** @type {number} */ count) => {
    const rows = new Rows(["seed", "status", "length", "iterations"], count);
    for (let trial = 0; trial < count; trial++) rows.set(trial, [0, "solved", trial, 1], [0, 0]);
    const chart = chartOf(rows, [seed], { chart: "box", measure: "length" }, ["length"], "m");
    return { dots: chart.points.length, remark: remarkOf(chart) };
  };
  const few = remarkOver(2000);
  assert.equal(few.dots, 2000);
  assert.match(few.remark, /value\. Each dot is a trial\./);
  const many = remarkOver(4001);
  assert.equal(many.dots, 1334);
  assert.match(many.remark, /value\. Each dot is a trial; one in 3 is drawn\./);
});

test("a caption says what was run, and how many trials these are", () => {
  assert.match(
    subjectOf({ document: small, rows: new Rows([], 48) }),
    /; 48 trials \(3 settings x 2 worlds x 8 seeds\)\.$/,
  );
});

test("sentences name all that share an end, tell values apart, and do not add metres to radians", () => {
  const settings = ["a", "b", "c"];
  const worlds = ["u", "v"];
  const rows = new Rows(["planner", "world", "seed", "status", "length", "cost", "motion_checks"], 24);
  for (let trial = 0; trial < 24; trial++) {
    const [planner, world, seed] = [trial % 3, Math.floor(trial / 3) % 2, Math.floor(trial / 6)];
    // The lengths of a and b differ by rounding alone; those of u are five times as long as those of v.
    const length = (world === 0 ? 5 : 1) * (planner === 2 ? 1.2 : 1.1) + (planner === 1 ? 1e-15 : 0);
    const solved = planner < 2 || seed < 3;
    rows.set(
      trial,
      [settings[planner], worlds[world], seed, solved ? "solved" : "failed", length, null, 1700 + 2 * planner],
      [0, 0],
    );
  }
  const of = (/** @type {string} */ column, /** @type {string[]} */ values) => ({
    column,
    title: column,
    unit: "",
    values,
    isNumeric: false,
  });
  const factors = [of("planner", settings), of("world", worlds)];
  const metres = new Map(worlds.map((world) => [world, "m"]));
  const said = (/** @type {string} */ measure, view = {}) => comparisons(rows, factors, measure, view).sentences;
  const [extremes, pair, , byWorld] = said("length", { units: metres, other: "b" });
  assert.match(
    extremes,
    /^The median of path length is smallest for a and b, 3\.3 m \(n = 8\), and largest for c, 3\.6 m \(n = 6\)/,
  );
  assert.match(pair, /smaller than that of a in 0 of 8 pairs that both solved, larger in 0, equal in 8/);
  assert.equal(
    byWorld,
    "Median of path length in each world, smallest first: u: a 5.5 m (n = 4), b 5.5 m (n = 4), c 6 m (n = 3); v: a 1.1 m (n = 4), b 1.1 m (n = 4), c 1.2 m (n = 3).",
  );
  const mixed = said("length", { units: new Map([...metres, ["v", "rad"]]) });
  assert.equal(mixed.length, 2);
  assert.match(mixed[0], /different units/);
  assert.match(mixed[1], /in each world, smallest first: u: a 5\.5 m \(n = 4\), .* c 1\.2 rad \(n = 3\)\.$/);
  assert.deepEqual(said("cost"), ["No trial has a value of path cost."]);
  assert.match(said("motion_checks")[0], /smallest for a, 1,700 \(n = 8\), and largest for c, 1,704 \(n = 6\)/);
  assert.match(said("solved")[0], /largest for a and b, 100 % of 8, and smallest for c, 75 % of 8\./);
  // What has no value is neither equal to the others nor the worst of them.
  const few = new Rows(["planner", "world", "seed", "status", "length"], 4);
  for (let trial = 0; trial < 4; trial++)
    few.set(trial, ["ab"[trial % 2], "u", trial >> 1, trial % 2 ? "failed" : "solved", trial % 2 ? null : 5], [0, 0]);
  const two = [of("planner", ["a", "b"])];
  assert.equal(
    comparisons(few, two, "length", {}).sentences[0],
    "The median of path length is 5 (n = 2), for a; the others have none.",
  );
  assert.deepEqual(comparisons(few, two, "length", { which: new Uint8Array(4) }).sentences, [
    "No world and seed was solved by all settings.",
  ]);
  // The worlds of pairs are those in which both have a value.
  const three = new Rows(["planner", "world", "seed", "status", "length"], 12);
  for (let trial = 0; trial < 12; trial++) {
    const [planner, world] = ["ab"[trial % 2], "uvw"[(trial >> 1) % 3]];
    const isSolved = planner === "a" || world !== "w";
    three.set(
      trial,
      [planner, world, Math.floor(trial / 6), isSolved ? "solved" : "failed", isSolved ? trial : null],
      [0, 0],
    );
  }
  assert.match(
    comparisons(three, [of("planner", ["a", "b"]), of("world", ["u", "v", "w"])], "length", { units: metres })
      .sentences[1],
    /of 4 pairs that both solved.*it takes the pairs, of 2 worlds, as independent/,
  );
  // One setting that solves nothing, in two worlds.
  const none = new Rows(["planner", "world", "seed", "status", "length"], 2);
  for (let trial = 0; trial < 2; trial++) none.set(trial, ["a", worlds[trial], 0, "failed", null], [0, 0]);
  assert.equal(comparisons(none, [of("world", worlds)], "length").sentences[0], "No setting found a path.");
});

test("a logarithmic axis has numbers without prefixes, and its caption says where values of 0 are", () => {
  const { tickFormat } = LOG;
  assert.deepEqual([0.1, 0.30000000000000004, 5.5, 1000].map(tickFormat), ["0.1", "0.3", "5.5", "1,000"]);
  const rows = new Rows(["planner", "seed", "status", "length", "iterations"], 4);
  for (let trial = 0; trial < 4; trial++) rows.set(trial, ["a", trial, "solved", trial, 1], [0, 0]);
  const shown = (/** @type {boolean} */ isLog) =>
    remarkOf(chartOf(rows, [], { chart: "box", measure: "length", isLog }, ["length"], "m"));
  assert.match(shown(true), / Values of 0 lie on the edge of the logarithmic axis\./);
  assert.doesNotMatch(shown(false), /Values of 0/);
});

test("one more chart is one object in the table", () => {
  const rows = new Rows(["planner", "seed", "status", "length", "iterations"], 4);
  for (let trial = 0; trial < 4; trial++) rows.set(trial, ["ab"[trial % 2], trial >> 1, "solved", 1 + trial], [0, 0]);
  const factor = { column: "planner", title: "planner", unit: "", values: ["a", "b"], isNumeric: false };
  /** @type {import("../../www/experiments/charts.js").Chart} */
  const range = {
    id: "range",
    title: "Range",
    fits: (measure) => measure === "length",
    controls: ["measure", "axis"],
    swatch: "none",
    data: (query) => bySettings(query),
    marks: (plot, { summaries }) => ({
      marks: [plot.ruleX(summaries, { x: "x", y1: "low", y2: "high" })],
      options: {},
    }),
    remark: () => "Lines: from the shortest to the longest path.",
  };
  CHARTS.push(range);
  try {
    const chart = chartOf(rows, [factor], { chart: "range" }, ["length"], "m", null);
    assert.deepEqual([chart.kind, chart.measure, chart.summaries.length], [range, "length", 2]);
    assert.match(remarkOf(chart), /^Lines: from the shortest .* n = 2 each\./);
  } finally {
    CHARTS.pop();
  }
});

test("the ceiling counts worlds with a proven path, certified ones and unknown ones", () => {
  const document = /** @type {ExperimentDocument} */ ({
    format: "planarium-experiment-1",
    worlds: [{ generate: "discs", seeds: { from: 0, count: 4 } }],
    planners: [{ algorithm: "prm" }, { algorithm: "prm", name: "leaps", set: { edge_check: "none" } }],
    seeds: [0],
  });
  const rows = new Rows(["world", "world_seed", "query", "planner", "seed", "status", "length"], 8);
  // World 0 is solved with proof, world 1 without; the others are not.
  for (let trial = 0; trial < 8; trial++) {
    const planner = ["prm", "leaps"][trial % 2];
    const isSolved = trial === 0 || trial === 3;
    rows.set(
      trial,
      ["discs", trial >> 1, "q", planner, 0, isSolved ? "solved" : "failed", isSolved ? 1 : null],
      [0, 0],
    );
  }
  const tasks = tasksOf(rows, document);
  assert.deepEqual(
    tasks.map(({ hasPath }) => hasPath),
    [true, false, false, false],
  );
  const { most, words } = ceilingOf(
    tasks,
    new Map([
      [tasks[1].key, "infeasible"],
      [tasks[2].key, "connected"],
    ]),
  );
  assert.equal(most, 75);
  assert.equal(
    words,
    "Of 4 worlds 2 have a path, 1 is proven to have none and 1 may have one or not: no planner can solve more than 75 % of these trials.",
  );
  assert.match(ceilingOf(tasks, new Map([[tasks[1].key, "unsupported"]])).words, /certificates are for discs and arms/);
});
