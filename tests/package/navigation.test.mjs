/**
 * Learned navigation from JavaScript: documents, training, planners whose edges are rollouts, drives, the comparison,
 * and what is refused.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  Navigation,
  NavigationComparison,
  Training,
  comparisonOptions,
  navigationGenerators,
  rolloutOptions,
  trainingOptions,
} from "planarium/full";
import { fails } from "./scenes.mjs";

/** @type {Extract<import("planarium/full").NavigationDocument["robot"], { type: "differential_drive" }>} */
const wheeled = {
  type: "differential_drive",
  shape: { type: "disc", radius: 0.2 },
  speed: [-0.1, 1],
  turn_rate: [-1.5, 1.5],
  sensor: { rays: 4, field_of_view: 2, range: 2 },
};

/** @type {import("planarium/full").NavigationDocument} */
const corridor = {
  format: "planarium-navigation-1",
  name: "corridor",
  world: { bounds: { min: [0, 0], max: [8, 3] }, obstacles: [{ type: "disc", center: [4, 1.5], radius: 0.3 }] },
  robot: wheeled,
  queries: [{ name: "along", start: [1, 1, 0], goal: [7, 1] }],
};
const task = Navigation.parse(corridor);
const SMALL = { pairs: 3, tasks: 5, floors: 3, generations: 4, hidden: 3, seed: 2 };

/** A policy after a few generations. @param {import("planarium/full").TrainingOptions} [options] */
function trained(options = SMALL) {
  const training = task.training(options);
  assert.equal(training.step(1e9), "solved");
  return training.policy();
}

test("a document is read, refused with its place, and written again", () => {
  assert.deepEqual([task.name, task.title], ["corridor", "corridor"]);
  assert.deepEqual(Navigation.parse(JSON.stringify(task)).toJSON(), task.toJSON());
});

test("what is sensed and where the robot is are arrays and records", () => {
  const distances = task.sense([3, 1.5, 0]);
  assert.ok(distances instanceof Float64Array && distances.length === 4);
  assert.deepEqual(task.footprint([1, 1, 0.5]), { type: "disc", center: [1, 1], radius: 0.2 });
  fails(() => task.sense([1, 1]), "wrong-dimension", "/pose");
});

test("a training comes to the same policy in any slices, and shared between workers", () => {
  const whole = task.training(SMALL);
  assert.ok(whole instanceof Training);
  assert.deepEqual([whole.candidates, whole.generations, whole.floorCount, whole.status], [6, 4, 3, "running"]);
  const before = whole.policy();
  assert.equal(whole.step(1e9), "solved");
  const sliced = task.training(SMALL);
  while (sliced.step(5) === "running");
  const [one, other] = [task.training(SMALL), task.training(SMALL)];
  for (let generation = 0; generation < 4; generation++) {
    assert.equal(one.generation, generation);
    const returns = Float64Array.from([...one.returnsOf(0, 2), ...other.returnsOf(2, 6)]);
    assert.equal(one.advance(returns), generation < 3 ? "running" : "solved");
    other.advance(returns);
  }
  for (const training of [sliced, one, other]) {
    assert.equal(training.fingerprint, whole.fingerprint);
    assert.deepEqual(training.policy(), whole.policy());
    assert.deepEqual(training.historySince(0), whole.historySince(0));
  }
  assert.equal(whole.iterations, 24);
  assert.notDeepEqual(whole.policy().weights, before.weights);
  assert.notEqual(task.training({ ...SMALL, seed: 3 }).policy().weights[0], before.weights[0]);
  const shown = whole.demonstrations(5);
  assert.equal(shown.length, 5);
  for (const { floor, goal, outcome, time, trace } of shown) {
    assert.ok(["reached", "collision", "timeout"].includes(outcome));
    assert.ok(Math.abs(time - 0.2 * (trace.length / 3 - 1)) < 1e-9);
    const { min, max } = whole.floor(floor).world.bounds ?? assert.fail();
    assert.ok(goal.every((value, i) => value > min[i] && value < max[i]));
  }
  fails(() => whole.floor(3), "out-of-range", "/number");
  fails(() => whole.returnsOf(0, 7), "out-of-range", "/end");
  fails(() => whole.returnsOf(3, 2), "out-of-range", "/first");
  fails(() => task.training(SMALL).advance(new Float64Array(10)), "out-of-range", "/returns");
});

test("a planner rolls edges out, tells how many rollouts succeed, and its path is driven", () => {
  const policy = trained({ ...SMALL, generations: 30, pairs: 8, tasks: 12 });
  const options = { samples: 60, k: 10, seed: 4, rollouts: 6, leastShare: 0.3 };
  const planner = task.planner(policy, options);
  assert.equal(planner.step(1e9), "solved");
  const sliced = task.planner(JSON.stringify(policy), options);
  while (sliced.step(3) === "running");
  assert.deepEqual([sliced.fingerprint, sliced.path()], [planner.fingerprint, planner.path()]);
  const path = planner.path();
  const result = planner.result();
  assert.deepEqual([result.edge_check, result.planner], ["rollouts", "lazy-prm"]);
  const rollouts = task.edgeRollouts(policy, path, options);
  assert.equal(rollouts.length, result.path.length - 1);
  for (const { of, forward, backward } of rollouts)
    assert.ok(of === 6 && forward >= 2 && backward >= 2 && forward <= 6 && backward <= 6);
  const drives = Array.from({ length: 10 }, (_, trial) => task.execute(path, { policy, trial }));
  assert.deepEqual(drives[3], task.execute(path, { policy: JSON.stringify(policy), trial: 3 }));
  assert.notDeepEqual(drives[0].trace, drives[1].trace);
  for (const { outcome, trace } of drives) {
    assert.deepEqual([...trace.slice(0, 3)], [1, 1, 0]);
    const [x, y] = trace.slice(-3);
    assert.equal(outcome === "reached", Math.hypot(x - 7, y - 1) <= 0.3);
  }
  fails(() => task.execute([], { policy }), "out-of-range", "/path");
  assert.equal(task.execute(path.slice(0, 2), { policy }).outcome, "reached");
  fails(() => task.execute([1, 1, 7], { policy }), "wrong-dimension", "/path");
});

test("without a policy a controller follows straight edges that are proven free", () => {
  const planner = task.straightPlanner({ samples: 80, k: 10, margin: 0.2 });
  assert.equal(planner.step(1e9), "solved");
  assert.equal(planner.result().edge_check, undefined);
  assert.equal(task.execute(planner.path()).outcome, "reached");
  const still = Navigation.parse({
    ...corridor,
    robot: { ...wheeled, noise: { range: 0, position: 0, heading: 0, speed: 0, turn_rate: 0 } },
  });
  assert.deepEqual(
    still.execute(planner.path(), { trial: 1 }),
    still.execute(planner.path(), { trial: 2 }),
    "without noise all trials are one",
  );
  assert.equal(task.execute([1, 1, 7, 2.2], { trial: 0 }).outcome, "collision", "it drives into what is in its way");
  fails(() => task.straightPlanner({ margin: -1 }), "out-of-range", "/margin");
});

test("a comparison comes to the same counts in any slices, and sums up its executions", () => {
  const policy = trained();
  const options = { queries: 3, trials: 2, samples: 40, leastDistance: 3, rollouts: 3, leastShare: 0.3 };
  const comparison = task.comparison(policy, options);
  assert.ok(comparison instanceof NavigationComparison);
  assert.equal(comparison.count, 36);
  assert.equal(comparison.step(1e9), "solved");
  const sliced = task.comparison(policy, options);
  while (sliced.step(11) === "running");
  assert.deepEqual(sliced.executionsSince(0), comparison.executionsSince(0));
  assert.deepEqual(comparison.executionsSince(34), comparison.executionsSince(0).slice(34));
  assert.equal(comparison.queries().length, 3);
  for (const { method, reached, collisions, planned } of comparison.summary()) {
    const own = comparison.executionsSince(0).filter((one) => one.method === method);
    assert.deepEqual([reached.n, collisions.n, planned.n], [6, 6, 3]);
    assert.equal(reached.share, own.filter(({ outcome }) => outcome === "reached").length / 6);
    assert.ok(Number(reached.low) <= Number(reached.share) && Number(reached.share) <= Number(reached.high));
  }
});

test("generators and options are listed, and what is freed is said to be", () => {
  assert.deepEqual(
    navigationGenerators().map(({ id }) => id),
    ["rooms", "furnished"],
  );
  for (const { id, options } of navigationGenerators()) {
    assert.ok(options.every(({ name }) => name !== "seed"));
    assert.deepEqual(Navigation.generate(id, { seed: 5 }).toJSON(), Navigation.generate(id, { seed: 5 }).toJSON());
  }
  for (const table of [trainingOptions(), rolloutOptions(), comparisonOptions()])
    assert.ok(
      table.every(
        ({ meaning, default: value, default_meaning: otherwise }) => meaning && (value ?? otherwise) !== null,
      ),
    );
  const freed = Navigation.parse(corridor);
  const training = freed.training(SMALL);
  const comparison = freed.comparison(training.policy(), { leastDistance: 3, queries: 1 });
  freed.free();
  assert.throws(() => freed.name, { code: "freed" });
  assert.equal(training.step(1), "running", "what was made of it lives on");
  training.free();
  comparison.free();
  assert.throws(() => training.generation, { code: "freed" });
  assert.throws(() => comparison.summary(), { code: "freed" });
  assert.throws(() => new /** @type {any} */ (Navigation)(), { code: "illegal-constructor" });
});

test("a carrier of cargo is trained, planned for and driven; its swing comes with the trace", async () => {
  const { default: shipped } = await import("planarium/policy-cargo.json", { with: { type: "json" } });
  const policy = /** @type {import("planarium/full").PolicyDocument} */ (shipped);
  const yard = Navigation.generate("rooms", { columns: 2, rows: 1, seed: 1, shape: "cargo" });
  assert.equal(yard.toJSON().robot.type, "cargo");
  const planner = yard.planner(policy, { samples: 120, k: 8, rollouts: 5, seed: 1 });
  assert.equal(planner.step(1e9), "solved");
  const { outcome, trace, swing } = yard.execute(planner.path(), { policy, seed: 1 });
  assert.ok(["reached", "collision", "swing", "timeout"].includes(outcome));
  assert.equal(swing.length / 2, trace.length / 3);
  for (let i = 0; i < swing.length; i += 2) assert.ok(Math.hypot(swing[i], swing[i + 1]) <= 0.3, "within the limit");
  assert.deepEqual(task.execute([1, 1, 7, 1]).swing, [], "a drive has no load");
  const training = yard.training(SMALL);
  training.step(1e9);
  assert.equal(training.policy().robot, "cargo");
  fails(() => task.planner(policy), "unsupported", "/policy/robot");
});
