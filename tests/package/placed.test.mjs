/** Rigid bodies and cars through the package: motions between waypoints, cursors, roadmaps, presets, documents. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, planners } from "planarium";
import { body, car, fails, finish, options as asOptions, scenes } from "./scenes.mjs";

/** @import { Configuration, Motion, ScenarioDocument } from "planarium" */

/** A square with a block in its middle, for a car that need not reverse. @type {ScenarioDocument} */
const square = {
  ...car,
  name: "square",
  world: {
    bounds: { min: [0, 0], max: [3, 3] },
    obstacles: [
      {
        type: "polygon",
        vertices: [
          [1, 1],
          [2, 1],
          [2, 1.4],
          [1.4, 1.4],
          [1.4, 2],
          [1, 2],
        ],
      },
      { type: "disc", center: [2.2, 2.2], radius: 0.2 },
    ],
  },
  queries: [
    {
      name: "across",
      start: [0.5, 0.5, 0],
      goal: [2.5, 2.6, 1.5],
      goal_tolerance: { translation: 0.1, rotation: 0.5 },
    },
  ],
};

/** Rows of `width` numbers. @param {ArrayLike<number>} flat @param {number} width */
function rows(flat, width) {
  assert.equal(flat.length % width, 0);
  return Array.from({ length: flat.length / width }, (_, i) =>
    Array.from({ length: width }, (_, k) => flat[i * width + k]),
  );
}

/** The placement after a motion: the closed form of x' = v cos theta, y' = v sin theta, theta' = v tan(phi) / L. */
const driven = (
  /** @type {Configuration} */ [x, y, theta],
  /** @type {Motion} */ { control: [v, phi], duration },
  wheelbase = 0.2,
) => {
  const half = (v * Math.tan(phi) * duration) / wheelbase / 2;
  const chord = v * duration * (Math.abs(half) < 1e-9 ? 1 : Math.sin(half) / half);
  return [x + chord * Math.cos(theta + half), y + chord * Math.sin(theta + half), theta + 2 * half];
};

const same = (/** @type {Configuration} */ a, /** @type {Configuration} */ b, about = "") => {
  const turn = a[2] - b[2];
  assert.ok(Math.hypot(a[0] - b[0], a[1] - b[1], Math.sin(turn / 2)) < 1e-9, `${a} is not ${b} ${about}`);
};

for (const options of [{ algorithm: "rrt-control" }, { algorithm: "prm", steering: "reeds-shepp", samples: 200 }]) {
  test(`${options.algorithm}: motions lead a car from waypoint to waypoint, and cursors give the motions of every edge once`, () => {
    const scenario = Scenario.parse(square);
    const planner = scenario.planner(asOptions({ ...options, seed: 1 }));
    /** @type {number[]} */ const motions = [];
    /** @type {number[]} */ const traces = [];
    for (let done = false, seen = 0; !done; seen = planner.edgeCount) {
      done = planner.step(37) !== "running";
      motions.push(...planner.motionsSince(seen));
      traces.push(...planner.tracesSince(seen));
    }
    const { edgeCount } = planner;
    assert.deepEqual([[...planner.motionsSince(0)], [...planner.tracesSince(0)]], [motions, traces]);
    assert.deepEqual([planner.motionsSince(edgeCount).length, planner.tracesSince(edgeCount).length], [0, 0]);
    const vertices = rows(planner.verticesSince(0), 3);
    const ends = rows(planner.edgesSince(0), 2);
    const numbers = (/** @type {number[][]} */ list) => [...new Set(list.map(([edge]) => edge))];
    assert.deepEqual([numbers(rows(motions, 4)), numbers(rows(traces, 4))], [[...ends.keys()], [...ends.keys()]]);
    ends.forEach(([from, to], edge) => {
      const own = rows(motions, 4).filter(([number]) => number === edge);
      const end = own.reduce(
        (pose, [, v, phi, duration]) => driven(pose, { control: [v, phi], duration }),
        vertices[from],
      );
      same(end, vertices[to], `(edge ${edge})`);
    });
    const { status, path, motions: led = [] } = planner.result();
    assert.deepEqual([status, path.length, path.flat()], ["solved", led.length + 1, [...planner.path()]]);
    led.forEach((motion, i) => same(driven(path[i], motion), path[i + 1], `(motion ${i})`));
  });
}

test("Euler's steps are named in the result", () => {
  const { integration, status } = finish(
    Scenario.parse(car).planner({ algorithm: "rrt-control", integration: "euler", seed: 1 }),
  ).result();
  assert.deepEqual([status, integration], ["solved", "euler"]);
});

test("a tree that gives up tells how near it came, and how it got there", () => {
  const scenario = Scenario.parse(car);
  for (const options of [{ algorithm: "rrt-control" }, { algorithm: "rrt", step: 0.1 }]) {
    const { status, path, motions, length, approximate } = finish(
      scenario.planner(asOptions({ ...options, maxIterations: 20, seed: 1 })),
    ).result();
    assert.deepEqual([status, path, motions, length], ["exhausted", [], [], 0]);
    assert.ok(
      approximate?.motions &&
        approximate.path.length === approximate.motions.length + 1 &&
        approximate.goal_distance > 0,
    );
    approximate.motions.forEach((motion, i) => same(driven(approximate.path[i], motion), approximate.path[i + 1]));
  }
});

test("a run that improves its path can be stopped with the path that it has", () => {
  const stopped = Scenario.parse(car).planner({ algorithm: "sst", seed: 3, improveIterations: 4000 });
  while (stopped.phase !== "improving") stopped.step(1);
  assert.deepEqual([stopped.status, stopped.path().length], ["running", 0]);
  assert.equal(stopped.finish(), "solved");
  assert.ok(stopped.path().length > 0);
});

test("a built roadmap of a body, and of a steered car, is queried again; that of a body is resumed", () => {
  const scenario = Scenario.parse(body);
  const bodies = finish(scenario.planner({ algorithm: "prm", samples: 500, seed: 4 }));
  const straight = bodies.query([0.5, 1.2, 1], [1.9, 0.4, -1]);
  assert.deepEqual([straight.status, straight.motions], ["solved", undefined]);
  const resumed = finish(scenario.resume(bodies.roadmap("binary")));
  assert.deepEqual([resumed.status, resumed.path()], ["solved", bodies.path()]);
  const cars = finish(
    Scenario.parse(car).planner({ algorithm: "prm", samples: 400, seed: 1, steering: "reeds-shepp" }),
  );
  const { status, path, motions = [] } = cars.query([0.4, 0.9, 2], [1, 0.3, 3]);
  assert.equal(status, "solved");
  assert.equal(path.length, motions.length + 1);
  motions.forEach((motion, i) => same(driven(path[i], motion), path[i + 1]));
  same(path[path.length - 1], [1, 0.3, 3]);
});

test("a roadmap of a car is kept with its curves, and gone on with", () => {
  const scenario = Scenario.parse(square);
  const planner = finish(scenario.planner({ algorithm: "prm", samples: 300, seed: 1, steering: "dubins" }));
  for (const kept of [planner.roadmap("json"), planner.roadmap("binary")]) {
    const resumed = finish(scenario.resume(kept));
    assert.deepEqual(
      [resumed.status, resumed.path(), resumed.result().motions],
      ["solved", planner.path(), planner.result().motions],
    );
  }
  fails(
    () => scenario.resume(planner.roadmap("binary"), { steering: "reeds-shepp" }),
    "out-of-range",
    "/steering",
    /was built with/,
  );
});

test("planners() says which robots each planner and each parameter is for", () => {
  const types = /** @type {(keyof typeof scenes)[]} */ (Object.keys(scenes));
  for (const { id, robots, parameters } of planners()) {
    assert.deepEqual(robots, ["rrt-control", "sst"].includes(id) ? ["car"] : types, id);
    for (const { name, robots: some } of parameters)
      assert.ok(some.length > 0 && some.every((type) => types.includes(type)), `${id} ${name}`);
  }
});

test("presets are settings of their planner, and start", () => {
  for (const { id, presets, parameters, robots } of planners()) {
    for (const { id: name, settings } of presets) {
      for (const key of Object.keys(settings))
        assert.ok(
          parameters.some((parameter) => parameter.option === key),
          `${id} ${name} ${key}`,
        );
      for (const type of robots)
        assert.equal(
          Scenario.parse(scenes[type]).planner(asOptions({ algorithm: id, ...settings })).iterations,
          0,
          `${id} ${name} ${type}`,
        );
    }
  }
});

test("documents of bodies and cars come back complete", () => {
  const document = Scenario.parse(car).document();
  assert.ok(document.robot.type === "car" && document.robot.integration_step === 0.01);
  assert.deepEqual(document.robot.metric, { translation: 0.7, rotation: 0.3 });
  assert.deepEqual(Scenario.parse(document).document(), document);
  const scenario = Scenario.parse(body);
  assert.deepEqual([scenario.robot, scenario.dimension, scenario.circles()], ["rigid_body", 3, [false, false, true]]);
  const [part] = scenario.footprint([1, 0.8, Math.PI / 2]);
  assert.ok(part.type === "polygon" && part.vertices.length === 6);
  same([...part.vertices[0], 0], [1.06, 0.74, 0]);
  assert.deepEqual(scenario.endEffector([1, 0.8, 2]), [1, 0.8]);
  for (const robot of /** @type {const} */ (["rigid_body", "car"]))
    assert.equal(Scenario.generate("gap", { robot, seed: 1 }).robot, robot);
});
