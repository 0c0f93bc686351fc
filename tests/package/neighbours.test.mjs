/** Nearest neighbours, as the package has them. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, neighbourIndexes } from "planarium";
import { arm, fails } from "./scenes.mjs";

/** @param {object} [options] */
const made = (options) => Scenario.parse(arm).neighbours(options);

test("neighbours come nearest first, ties by number, the short way round", () => {
  for (const index of /** @type {const} */ (["linear", "kd-tree", "forest"])) {
    const held = made({ index });
    assert.equal(held.size, 0);
    assert.deepEqual(held.nearest([0, 0], 3), {
      indices: new Uint32Array(),
      distances: new Float64Array(),
      visited: 0,
    });
    held.add([
      [3, 0],
      [-3, 0.5],
      [0, 0],
    ]);
    held.add(Float64Array.of(-3, 0, 3, 0));
    held.add([]);
    assert.equal(held.size, 5);
    const gap = 2 * Math.PI - 6;
    assert.deepEqual(held.nearest([-3, 0], 4), {
      indices: Uint32Array.of(3, 0, 4, 1),
      distances: Float64Array.of(0, gap, gap, 0.5),
      visited: 5,
    });
    assert.deepEqual(held.nearest([-3 + 2 * Math.PI, 0], 1).indices, Uint32Array.of(3), "any number of turns");
    assert.deepEqual([...held.within([-3, 0], gap).indices], [3, 0, 4]);
    assert.equal(held.nearest([0, 0], 2 ** 53 - 1).indices.length, 5);
    assert.equal(held.nearest([0, 0], 0).indices.length, 0);
  }
  const naive = made({ metric: "naive" });
  naive.add([
    [3, 0],
    [-3, 0.5],
    [0, 0],
    [-3, 0],
    [3, 0],
  ]);
  assert.deepEqual([...naive.nearest([-0.1, 0], 5).indices], [3, 1, 0, 4, 2]);
  const unwrapped = made({ index: "kd-tree-unwrapped" });
  unwrapped.add([
    [3, 0],
    [-3, 0.5],
    [0, 0],
    [-3, 0],
    [3, 0],
  ]);
  assert.deepEqual(unwrapped.nearest([-3, 0], 5), {
    indices: Uint32Array.of(3, 1, 2, 0, 4),
    distances: Float64Array.of(0, 0.5, 3, 6, 6),
    visited: 5,
  });
});

test("samples are the same for a seed; those that must be free are", () => {
  const scenario = Scenario.parse(arm);
  const rows = scenario.sampleConfigurations(200, { seed: 3, free: true });
  assert.equal(rows.length, 400);
  for (let i = 0; i < rows.length; i += 2) assert.ok(scenario.check(rows.subarray(i, i + 2)).free);
  assert.deepEqual(scenario.sampleConfigurations(200, { seed: 3, free: true }), rows);
  assert.notDeepEqual(scenario.sampleConfigurations(200, { seed: 4, free: true }), rows);
  assert.deepEqual(scenario.sampleConfigurations(200), scenario.sampleConfigurations(200, { seed: 0, free: false }));
  assert.equal(scenario.sampleConfigurations(0).length, 0);
  const planner = scenario.planner({ algorithm: "prm", samples: 50, seed: 3 });
  planner.step(10_000);
  const vertices = planner.verticesSince(0).join();
  for (let i = 0; i < 100; i += 2)
    assert.ok(vertices.includes(rows.subarray(i, i + 2).join()), "a planner of that seed draws the same");
  for (const n of [-1, 0.5, 1_000_001]) fails(() => scenario.sampleConfigurations(n), "out-of-range", "/n");
  fails(() => scenario.sampleConfigurations(NaN), "not-finite", "/n");
  fails(() => scenario.sampleConfigurations(1, { seed: -1 }), "out-of-range", "/seed");
  fails(() => scenario.sampleConfigurations(1, { free: /** @type {any} */ (1) }), "wrong-type", "/free");
});

test("the table tells what each index takes", () => {
  assert.deepEqual(
    neighbourIndexes().map(({ id, exact }) => [id, exact]),
    [
      ["linear", true],
      ["kd-tree", true],
      ["kd-tree-unwrapped", false],
      ["forest", false],
    ],
  );
  for (const { id, title, summary, parameters } of neighbourIndexes()) {
    assert.ok(title && summary.endsWith("."), id);
    assert.deepEqual(
      parameters.map(({ name }) => name),
      id === "forest" ? ["metric", "trees", "leaf", "candidates", "seed"] : ["metric"],
    );
    made({
      index: id,
      ...Object.fromEntries(parameters.filter((one) => one.default !== null).map((one) => [one.name, one.default])),
    }).free();
  }
});

test("what is wrong is refused, and leaves the index as it was", () => {
  fails(() => made({ index: 3 }), "wrong-type", "/index");
  fails(() => Scenario.parse(arm).neighbours(/** @type {any} */ ("linear")), "wrong-type");
  const held = made();
  held.add([[0, 0]]);
  fails(() => held.add([0, 0, 0]), "wrong-dimension", "/rows");
  fails(() => held.add([[0, 0], [0]]), "wrong-dimension", "/rows/1");
  fails(
    () =>
      held.add([
        [0, 0],
        [0, NaN],
      ]),
    "not-finite",
    "/rows/1/1",
  );
  fails(() => held.add([0, 0, 0, NaN]), "not-finite", "/rows/1/1");
  fails(
    () =>
      held.add([
        [0, 0],
        [1e7, 0],
      ]),
    "out-of-range",
    "/rows/1/0",
  );
  fails(() => held.add(/** @type {any} */ ([[0, 0], "0"])), "wrong-type", "/rows/1");
  fails(
    () =>
      held.add(
        /** @type {any} */ ([
          [0, 0],
          ["0", 0],
        ]),
      ),
    "wrong-type",
    "/rows/1/0",
  );
  fails(() => held.add(/** @type {any} */ ("rows")), "wrong-type", "/rows");
  fails(
    () =>
      held.add(
        /** @type {any} */ (
          new Proxy([[0, 0]], {
            get() {
              throw new Error("hands off");
            },
          })
        ),
      ),
    "wrong-type",
    "/rows",
  );
  assert.equal(held.size, 1, "none of them was added");
  fails(() => held.nearest([0], 1), "wrong-dimension", "/q");
  fails(() => held.nearest([0, Infinity], 1), "not-finite", "/q/1");
  for (const k of [-1, 0.5, 2 ** 53]) fails(() => held.nearest([0, 0], k), "out-of-range", "/k");
  fails(() => held.nearest([0, 0], /** @type {any} */ ("1")), "wrong-type", "/k");
  fails(() => held.within([0, 0], -1), "out-of-range", "/radius");
  fails(() => held.within([0, 0], Infinity), "not-finite", "/radius");
  const limited = Scenario.parse({
    ...arm,
    queries: [],
    robot: {
      .../** @type {any} */ (arm.robot),
      joint_limits: [
        [-1, 1],
        [-1, 1],
      ],
    },
  }).neighbours();
  fails(
    () =>
      limited.add([
        [0, 0],
        [0, 2],
      ]),
    "out-of-range",
    "/rows/1/1",
  );
  fails(() => limited.nearest([0, 2], 1), "out-of-range", "/q/1");
  const forest = made({ index: "forest", trees: 64 });
  fails(() => forest.add(new Float64Array(2 * 156_251)), "too-large", "/rows");
});
