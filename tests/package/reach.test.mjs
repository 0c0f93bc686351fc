/** Inverse kinematics, as the package has it. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, reachMethods } from "planarium/full";
import { car, fails } from "./scenes.mjs";

/**
 * @param {number[]} links
 * @param {[number, number][]} [limits]
 * @param {import("planarium/full").Obstacle[]} [obstacles]
 */
const armOf = (links, limits, obstacles = []) =>
  Scenario.parse({
    format: "planarium-scenario-1",
    name: "arm",
    world: { obstacles },
    queries: [],
    robot: { type: "arm", base: [0, 0], links, ...(limits ? { joint_limits: limits } : {}) },
  });

/** @param {Scenario} scenario @param {import("planarium/full").ReachOptions} options */
function ended(scenario, options) {
  const run = scenario.reach(options);
  while (run.step(10) === "running");
  return run;
}

test("each method reaches a target, and iterates and solutions come by cursors", () => {
  const scenario = armOf([1, 0.8, 0.5]);
  for (const { id } of reachMethods()) {
    const run = scenario.reach({ target: [1, 0.7], orientation: 0.3, method: id, solutions: 2, seed: 1 });
    /** @type {number[]} */
    const seen = [];
    while (run.step(3) === "running") seen.push(...run.iteratesSince(seen.length / 5));
    seen.push(...run.iteratesSince(seen.length / 5));
    assert.deepEqual(seen, [...run.iteratesSince(0)]);
    assert.equal(seen.length, 5 * run.iterateCount);
    assert.deepEqual(
      [run.status, run.solutionCount, run.solutionsSince(2).length, run.rejectedCount],
      ["solved", 2, 0, 0],
      id,
    );
    const rows = run.solutionsSince(0);
    assert.deepEqual([...run.configuration()], seen.slice(-3));
    assert.equal(run.error, seen.at(-4));
    assert.ok(run.manipulability > 0 && run.restarts >= 1);
    const result = run.result();
    assert.deepEqual(result.solutions.flat(), [...rows]);
    assert.deepEqual(
      [result.method, result.target, result.orientation, result.stats.iterations],
      [id, [1, 0.7], 0.3, run.iterations],
    );
    assert.deepEqual(result.verdict, { verdict: "reached", reason: null, nearest: null, touching: null });
    assert.match(run.fingerprint(), /^[0-9a-f]{16}$/);
    assert.equal(result.fingerprint, run.fingerprint());
  }
});

test("a verdict says why a target is not reached, and what is nearest or touches", () => {
  const far = ended(armOf([1, 0.5]), { target: [3, 0] });
  assert.equal(far.status, "exhausted");
  const { verdict, reason, nearest } = far.verdict();
  assert.deepEqual(
    [verdict, reason, nearest],
    ["out-of-reach", "too-far", { configuration: [0, 0], point: [1.5, 0], distance: 1.5, turn: 0 }],
  );
  const blocked = armOf([1], undefined, [{ type: "disc", center: [0, 1], radius: 0.2 }]);
  const touching = ended(blocked, { target: [0, 1], freeOnly: true }).verdict();
  assert.deepEqual([touching.verdict, touching.touching], ["in-collision", [{ part: 0, obstacle: 0 }]]);
});

test("what an arm that follows does, and what is nearest, are records", () => {
  const scenario = armOf([1, 0.8, 0.5]);
  const { configuration, point, reached, distance, manipulability } = scenario.follow([0.1, 0.2, 0.3], [1.2, 0.9]);
  assert.ok(reached && distance < 1e-9 && manipulability > 0.1);
  assert.deepEqual(scenario.endEffector(configuration), point);
  assert.ok(Math.abs(scenario.nearestReachable([1, 0.2], 2).distance) < 1e-12);
});

test("what is wrong is refused by name", () => {
  const scenario = armOf(
    [1, 1],
    [
      [-1, 1],
      [0, 2],
    ],
  );
  const reach = (/** @type {object} */ options) => () =>
    scenario.reach(/** @type {import("planarium/full").ReachOptions} */ (options));
  fails(reach({}), "missing-field", "/target");
  fails(() => scenario.reach(/** @type {never} */ (undefined)), "missing-field", "/target");
  fails(reach({ target: [1] }), "wrong-dimension", "/target");
  fails(reach({ target: 1 }), "wrong-type", "/target");
  fails(reach({ target: [1, "0"] }), "wrong-type", "/target/1");
  fails(reach({ target: [1, 0], orientation: "up" }), "wrong-type", "/orientation");
  fails(reach({ target: [1, 0], seed: -1 }), "out-of-range", "/seed");
  fails(() => Scenario.parse(car).follow([0.5, 0.5, 0], [1, 0]), "unsupported");
  fails(() => Scenario.parse(car).nearestReachable([1, 0]), "unsupported");
  fails(() => scenario.follow([0], [1, 0]), "wrong-dimension", "/q");
  fails(() => scenario.follow([0, -1], [1, 0]), "out-of-range", "/q/1");
  fails(() => scenario.follow([0, 1], /** @type {never} */ ([1])), "wrong-dimension", "/target");
  fails(() => scenario.nearestReachable([1, Infinity]), "not-finite", "/target/1");
  fails(() => scenario.nearestReachable([1, 0], NaN), "not-finite", "/orientation");
});
