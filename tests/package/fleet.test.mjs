/** Fleets from JavaScript: documents, planners by steps, the verifier, and what is refused. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Fleet, FleetPlanner, fleetGenerators, fleetPlanners } from "planarium/full";
import { fails } from "./scenes.mjs";

/** @type {import("planarium/full").FleetDocument} */
const pair = {
  format: "planarium-fleet-1",
  name: "pair",
  world: { bounds: { min: [0, 0], max: [10, 4] }, obstacles: [] },
  robots: [
    { name: "a", robot: { type: "disc", radius: 0.5 }, start: [1, 2], goal: [9, 2] },
    { name: "b", robot: { type: "disc", radius: 0.5 }, speed: 2, start: [9, 3.2], goal: [1, 0.8] },
  ],
};

test("a document is read, refused with its place, and written again", () => {
  const fleet = Fleet.parse(pair);
  assert.deepEqual([fleet.name, fleet.title, fleet.robotCount], ["pair", "pair", 2]);
  assert.deepEqual(Fleet.parse(JSON.stringify(fleet)).toJSON(), fleet.toJSON());
  fails(() => fleet.footprint(2, [0, 0, 0]), "out-of-range", "/robot");
  assert.throws(() => new /** @type {any} */ (Fleet)(), { code: "illegal-constructor" });
  fleet.free();
  assert.throws(() => fleet.name, { code: "freed" });
});

test("robots that would meet on the straight way are planned around each other, in any slices", () => {
  const fleet = Fleet.parse(pair);
  const [conflict] = fleet.straightConflicts();
  assert.deepEqual(conflict.robots, [0, 1]);
  assert.ok(conflict.from > 2 && conflict.from < 3, `${conflict.from}`);
  const whole = fleet.planner({ seed: 3 });
  assert.ok(whole instanceof FleetPlanner);
  assert.equal(whole.step(1e9), "solved");
  const sliced = fleet.planner({ seed: 3 });
  while (sliced.step(7) === "running");
  assert.equal(sliced.fingerprint, whole.fingerprint);
  assert.deepEqual(sliced.result(), whole.result());
  assert.deepEqual(fleet.verify(whole.result()), {
    valid: true,
    conflicts: [],
    faults: [],
    claims: [],
    looks: fleet.verify(whole.result()).looks,
  });
  const rows = whole.trajectory(1);
  assert.deepEqual([...rows.slice(0, 4)], [0, 9, 3.2, 0]);
  assert.deepEqual([...rows.slice(-3)], [1, 0.8, 0]);
  assert.deepEqual([...whole.posesAt(0)], [1, 2, 0, 9, 3.2, 0]);
  assert.equal(whole.makespan, Math.max(rows.at(-4) ?? NaN, whole.trajectory(0).at(-4) ?? NaN));
  assert.deepEqual([whole.roadmapCount, whole.roadmapOf(1), whole.planned, [...whole.order()]], [1, 0, 2, [0, 1]]);
  const vertices = whole.verticesSince(0, 0).length / 3;
  assert.equal(vertices, whole.result().stats.vertices);
  assert.ok(whole.edgesSince(0, 0).every((vertex) => vertex < vertices));
  fails(() => whole.verticesSince(1, 0), "out-of-range", "/roadmap");
  fails(() => whole.edgesSince(0, 1e9), "out-of-range", "/row");
  const plan = whole.result();
  plan.robots[0].times = plan.robots[0].times.map((time) => time / 2);
  assert.equal(fleet.verify(plan).valid, false);
});

test("planners and generators are listed with their options", () => {
  assert.deepEqual(
    fleetPlanners().map(({ id }) => id),
    ["pbs", "prioritized", "composite"],
  );
  for (const { id, options } of fleetGenerators()) {
    assert.ok(options.every(({ name }) => name !== "seed"));
    assert.ok(Fleet.generate(id, { radius: 0.25 }).robotCount > 0, id);
  }
});
