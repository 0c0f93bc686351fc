/** Memory: copies outlive growth, and freed handles give everything back. */
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { Problem, Scenario } from "planarium";
import { root } from "../../scripts/run.mjs";
import { arm, car, finish, options as asOptions } from "./scenes.mjs";

/** The memory of the instance that the package runs on. */
const { initSync } = await import(pathToFileURL(join(root, "dist", "package", "planarium_glue.js")).href);
/** @type {WebAssembly.Memory} */
const memory = initSync().memory;
const pages = () => memory.buffer.byteLength / 65536;

test("arrays handed out stay valid after the memory has grown", () => {
  const scenario = Scenario.parse(arm);
  const planner = finish(scenario.planner({ algorithm: "prm", samples: 200 }));
  const kept = [
    planner.verticesSince(0),
    planner.edgesSince(0),
    planner.eventsSince(0),
    planner.path(),
    scenario.cspace({ width: 16, height: 16 }),
  ];
  const copies = kept.map((array) => array.slice());
  const before = pages();
  const many = [];
  while (pages() === before && many.length < 200)
    many.push(finish(scenario.planner({ algorithm: "prm", samples: 2000, seed: many.length })));
  assert.ok(pages() > before, "the memory must grow for this to mean anything");
  finish(scenario.planner({ algorithm: "prm", samples: 300, seed: 99 }));
  kept.forEach((array, i) => {
    assert.ok(array.length > 0);
    assert.notEqual(array.buffer, memory.buffer);
    assert.deepEqual(array, copies[i]);
  });
  for (const other of many) other.free();
});

/**
 * Repeats what makes and frees: once it has been done a few times, the memory stays as large as it is.
 * @param {number} times
 * @param {(seed: number) => void} cycle
 */
function keepsItsSize(times, cycle) {
  for (let i = 0; i < times / 20; i += 1) cycle(i);
  const before = pages();
  for (let i = 0; i < times; i += 1) cycle(i);
  assert.equal(pages(), before);
}

test("10,000 cycles of making, stepping and freeing grow the memory by nothing", () => {
  keepsItsSize(10_000, (seed) => {
    const scenario = Scenario.parse(arm);
    const planner = scenario.planner({ seed: seed % 10 });
    planner.step(20);
    planner.verticesSince(0);
    planner.result();
    planner.free();
    scenario.free();
  });
});

test("nor do cars that are driven, by a planner, along curves or by hand", () => {
  keepsItsSize(2_000, (seed) => {
    const scenario = Scenario.parse(car);
    for (const options of [{ algorithm: "sst" }, { algorithm: "rrt", steering: "reeds-shepp" }]) {
      const planner = scenario.planner(asOptions({ ...options, seed: seed % 10 }));
      planner.step(20);
      planner.motionsSince(0);
      planner.tracesSince(0);
      planner.result();
      planner.free();
    }
    const drive = scenario.drive();
    drive.press("faster");
    drive.tick(20);
    drive.free();
    scenario.free();
  });
});

test("nor do custom robots, whose functions throw", () => {
  keepsItsSize(2_000, (seed) => {
    let calls = 0;
    const problem = new Problem({
      space: { coordinates: [{ kind: "circle" }] },
      start: [0],
      goal: [1],
      clearance(_, clearances) {
        clearances.fill(0.01);
        if ((calls += 1) > 3) throw seed;
      },
    });
    const planner = problem.planner({ algorithm: "rrt-star", seed: seed % 10 });
    assert.throws(() => planner.step(1000));
    planner.free();
    problem.free();
  });
});

test("nor do indexes of configurations", () => {
  const scenario = Scenario.parse(arm);
  const rows = scenario.sampleConfigurations(300, { seed: 1 });
  keepsItsSize(500, () => {
    for (const index of /** @type {const} */ (["linear", "kd-tree", "kd-tree-unwrapped", "forest"])) {
      const held = scenario.neighbours({ index });
      held.add(rows);
      held.nearest([1, 2], 20);
      held.within([1, 2], 0.5);
      assert.throws(() => held.add([[0, NaN]]));
      held.free();
    }
  });
});

test("errors leak nothing either", () => {
  const scenario = Scenario.parse(arm);
  keepsItsSize(5_000, () => {
    assert.throws(() => Scenario.parse('{"format": "planarium-scenario-1", "nonsense": []}'));
    assert.throws(() => scenario.planner(asOptions({ algorithm: "magic" })));
  });
});
