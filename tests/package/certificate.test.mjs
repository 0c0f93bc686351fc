/** Subdivisions through the package: what they take, give and refuse. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import { arm, disc, fails } from "./scenes.mjs";

test("a subdivision is stepped to its verdict, and its cells are read by cursors", () => {
  const scenario = Scenario.parse(disc);
  const subdivision = scenario.certify({ clearance: 1.21 });
  scenario.free();
  assert.deepEqual([subdivision.status, subdivision.verdict, subdivision.cellCount], ["running", null, 1]);
  assert.deepEqual(
    [...subdivision.cellsSince(0)],
    [5, 5, 4.6, 4.6, 0],
    "the centre stays within the bounds by the radius",
  );
  assert.equal(subdivision.step(1), "running");
  assert.equal(subdivision.cellCount, 5);
  assert.equal(subdivision.certificate().verdict, "unknown");
  while (subdivision.step(7) === "running");
  assert.deepEqual([subdivision.status, subdivision.verdict], ["solved", "infeasible"]);
  const rows = subdivision.cellsSince(0);
  assert.equal(rows.length, 5 * subdivision.cellCount);
  assert.deepEqual(subdivision.cellsSince(5), rows.slice(25));
  const { clearance, clearance_at_most: most, cells, wall, channel } = subdivision.certificate();
  assert.deepEqual([clearance, most, cells, channel], [1.21, 1.21, subdivision.cellCount, []]);
  assert.ok(
    wall.length > 0 && wall.every(({ cell, part, obstacle }) => cell.length === 3 && part === 0 && obstacle === 0),
  );
  assert.ok((subdivision.greatestClearance() ?? Infinity) <= 1.21);
  subdivision.free();
  // A disc that touches the bounds keeps 1.2 away from the wall.
  assert.equal(verdict(disc, { clearance: 1.15 }), "connected");
  assert.equal(verdict(arm, { query: "over", cells: 5000 }), "connected");
  assert.equal(verdict(arm, { cells: 1 }), "unknown");
});

test("what a subdivision refuses", () => {
  const scenario = Scenario.parse(disc);
  fails(() => scenario.certify(/** @type {any} */ ({ depth: 3 })), "unknown-field", "/depth");
  const subdivision = scenario.certify();
  fails(() => subdivision.cellsSince(2), "out-of-range", "/row");
  fails(() => subdivision.step(-1), "out-of-range", "/n");
  subdivision.free();
  fails(() => subdivision.certificate(), "freed");
});

/** @param {import("planarium").ScenarioDocument} document @param {import("planarium").CertifyOptions} options */
function verdict(document, options) {
  const scenario = Scenario.parse(document);
  const subdivision = scenario.certify(options);
  while (subdivision.step(1000) === "running");
  const found = subdivision.verdict;
  subdivision.free();
  scenario.free();
  return found;
}
