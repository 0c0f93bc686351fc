/** Rigid bodies and cars through the package: plans, motions between waypoints, cursors, presets, and what is refused. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, planners } from "planarium";
import { arm, body, car, fails, finish, options as asOptions, scenes } from "./scenes.mjs";

/** @import { Configuration, Motion, Planner, PlannerOptions, ScenarioDocument } from "planarium" */

/** A square with a block in its middle, for a car that need not reverse. @type {ScenarioDocument} */
const square = {
  ...car,
  name: "square",
  world: {
    bounds: { min: [0, 0], max: [3, 3] },
    obstacles: [{ type: "polygon", vertices: [[1, 1], [2, 1], [2, 1.4], [1.4, 1.4], [1.4, 2], [1, 2]] }, { type: "disc", center: [2.2, 2.2], radius: 0.2 }],
  },
  queries: [{ name: "across", start: [0.5, 0.5, 0], goal: [2.5, 2.6, 1.5], goal_tolerance: { translation: 0.1, rotation: 0.5 } }],
};

/** The planners of placements. */
const PLACING = ["prm", "prm-star", "lazy-prm", "lazy-prm-star", "visibility-prm", "rrt", "rrt-connect"];

/** What plans for a car: by controls, and along curves. @type {(PlannerOptions & { steering?: string, samples?: number })[]} */
const DRIVING = [
  { algorithm: "rrt-control" },
  { algorithm: "sst" },
  ...PLACING.map((algorithm) => asOptions({ algorithm, steering: "reeds-shepp", samples: /^prm/.test(algorithm) ? 300 : undefined })),
  ...PLACING.filter((algorithm) => algorithm !== "visibility-prm")
    .map((algorithm) => asOptions({ algorithm, steering: "dubins", samples: /^prm/.test(algorithm) ? 300 : undefined })),
];

const named = (/** @type {{ algorithm?: string, steering?: string }} */ { algorithm, steering }) => `${algorithm}${steering ? ` along ${steering} curves` : ""}`;

/** The placement after a motion: the closed form of x' = v cos theta, y' = v sin theta, theta' = v tan(phi) / L. */
const driven = (/** @type {Configuration} */ [x, y, theta], /** @type {Motion} */ { control: [v, phi], duration }, wheelbase = 0.2) => {
  const half = (v * Math.tan(phi) * duration) / wheelbase / 2;
  const chord = v * duration * (Math.abs(half) < 1e-9 ? 1 : Math.sin(half) / half);
  return [x + chord * Math.cos(theta + half), y + chord * Math.sin(theta + half), theta + 2 * half];
};

/** The same by Euler's steps of a hundredth of a second. */
const stepped = (/** @type {Configuration} */ [x, y, theta], /** @type {Motion} */ { control: [v, phi], duration }, wheelbase = 0.2) => {
  for (let step = Math.round(duration * 100); step > 0; step -= 1) {
    [x, y, theta] = [x + 0.01 * v * Math.cos(theta), y + 0.01 * v * Math.sin(theta), theta + (0.01 * v * Math.tan(phi)) / wheelbase];
  }
  return [x, y, theta];
};

/** Where motions lead, look by look. */
const dense = (/** @type {Configuration} */ from, /** @type {Motion[]} */ motions) => motions.flatMap(({ control, duration }) => {
  const looks = Array.from({ length: 401 }, (_, i) => driven(from, { control, duration: (duration * i) / 400 }));
  from = looks[400];
  return looks;
});

/** How far apart two placements are: the way, and the turn. */
const gap = (/** @type {Configuration} */ a, /** @type {Configuration} */ b) => {
  const turn = a[2] - b[2];
  return [Math.hypot(a[0] - b[0], a[1] - b[1]), Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn)))];
};

const same = (/** @type {Configuration} */ a, /** @type {Configuration} */ b, about = "") => {
  const [way, turn] = gap(a, b);
  assert.ok(way < 1e-9 && turn < 1e-9, `${a} is not ${b} ${about}`);
};

/** Rows of so many numbers. @param {ArrayLike<number>} flat @param {number} width */
function rows(flat, width) {
  assert.equal(flat.length % width, 0);
  return Array.from({ length: flat.length / width }, (_, i) => Array.from({ length: width }, (_, k) => flat[i * width + k]));
}

/** Every edge's motions, in their order. @param {Planner} planner */
function motionsByEdge(planner) {
  const edges = Array.from({ length: planner.edgeCount }, () => /** @type {Motion[]} */ ([]));
  for (const [edge, v, phi, duration] of rows(planner.motionsSince(0), 4)) edges[edge].push({ control: [v, phi], duration });
  return edges;
}

for (const algorithm of PLACING) {
  test(`${algorithm} plans for a body: straight from waypoint to waypoint, free all along, the same in any slices`, () => {
    const scenario = Scenario.parse(body);
    const start = () => scenario.planner(asOptions({ algorithm, seed: 4, samples: /^prm/.test(algorithm) ? 500 : undefined, shortcut: 20 }));
    const planner = finish(start());
    const { status, path, length, motions, integration } = planner.result();
    assert.deepEqual([status, motions, integration], ["solved", undefined, undefined]);
    same(path[0], [0.4, 0.4, 0]);
    same(path[path.length - 1], [2, 1.1, 3]);
    let measured = 0;
    for (let i = 1; i < path.length; i += 1) {
      assert.equal(scenario.firstHit(path[i - 1], path[i]), null);
      for (let t = 0; t <= 1; t += 0.02) assert.ok(scenario.check(scenario.interpolate(path[i - 1], path[i], t)).free);
      const [way, turn] = gap(path[i - 1], path[i]);
      measured += 0.7 * way + 0.3 * turn;
    }
    assert.ok(Math.abs(measured - length) < 1e-9 * length);
    assert.deepEqual([planner.motionsSince(0).length, planner.tracesSince(0).length], [0, 0]);
    for (const slice of [1, 7, 64]) assert.equal(finish(start(), slice).fingerprint(), planner.fingerprint(), `slices of ${slice}`);
  });
}

for (const options of DRIVING) {
  const isSteered = options.steering !== undefined;

  test(`${named(options)}: motions lead a car from waypoint to waypoint, free all along`, () => {
    const scenario = Scenario.parse(square);
    const planner = finish(scenario.planner({ ...options, seed: 1 }));
    const { status, path, motions = [], length, integration, edge_check } = planner.result();
    assert.deepEqual([status, integration, edge_check], ["solved", undefined, undefined]);
    assert.equal(path.length, motions.length + 1);
    assert.deepEqual(path.flat(), [...planner.path()]);
    same(path[0], [0.5, 0.5, 0]);
    const [way, turn] = gap(path[path.length - 1], [2.5, 2.6, 1.5]);
    assert.ok(isSteered ? way < 1e-9 && turn < 1e-9 : way <= 0.1 && turn <= 0.5, `${way} m and ${turn} rad from the goal`);
    let measured = 0;
    for (const [i, motion] of motions.entries()) {
      const { control: [v, phi], duration } = motion;
      assert.ok(Math.abs(v) <= 0.5 && Math.abs(phi) <= Math.PI / 4 && duration > 0, `motion ${i}`);
      if (options.steering === "dubins") assert.ok(v > 0, `motion ${i} goes back`);
      same(driven(path[i], motion), path[i + 1], `(motion ${i})`);
      const { poses, seconds, blocked } = scenario.rollout(path[i], v, phi, duration);
      assert.deepEqual([seconds, blocked], [duration, null], `motion ${i}`);
      same(poses.subarray(-3), path[i + 1], `(rollout of motion ${i})`);
      for (const pose of rows(poses, 3)) assert.ok(scenario.check(pose).free);
      measured += Math.abs(v) * duration;
    }
    assert.ok(Math.abs(measured - length) < 1e-9 * length, `${measured} is not ${length}`);
    const again = finish(scenario.planner({ ...options, seed: 1 }), 7);
    assert.deepEqual([again.fingerprint(), again.path()], [planner.fingerprint(), planner.path()]);
  });

  test(`${named(options)}: cursors of motions and traces give every edge once, from its first vertex to its second`, () => {
    // A lazy roadmap has the edges of its path alone, so it needs one.
    const isLazy = options.algorithm === "lazy-prm";
    const planner = Scenario.parse(square).planner(asOptions({ ...options, seed: 2, samples: options.samples && (isLazy ? 400 : 60), maxIterations: isLazy ? 100_000 : 1500 }));
    /** @type {number[]} */ const motions = [];
    /** @type {number[]} */ const traces = [];
    for (let done = false, seen = 0; !done; seen = planner.edgeCount) {
      done = planner.step(37) !== "running";
      motions.push(...planner.motionsSince(seen));
      traces.push(...planner.tracesSince(seen));
    }
    const { edgeCount, dimension } = planner;
    assert.ok(edgeCount > (isLazy ? 1 : 3));
    assert.deepEqual([...planner.motionsSince(0)], motions);
    assert.deepEqual([...planner.tracesSince(0)], traces);
    assert.deepEqual([planner.motionsSince(edgeCount).length, planner.tracesSince(edgeCount).length], [0, 0]);
    const numbers = rows(motions, 4).map(([edge]) => edge);
    assert.ok(numbers.every((edge, i) => i === 0 || edge >= numbers[i - 1]));
    const vertices = rows(planner.verticesSince(0), dimension);
    const ends = rows(planner.edgesSince(0), 2);
    const seen = Array.from({ length: edgeCount }, () => /** @type {number[][]} */ ([]));
    for (const [edge, ...pose] of rows(traces, 1 + dimension)) seen[edge].push(pose);
    for (const [edge, list] of motionsByEdge(planner).entries()) {
      assert.ok(isSteered ? list.length >= 1 && list.length <= 5 : list.length === 1, `edge ${edge} has ${list.length} motions`);
      const [from, to] = ends[edge].map((vertex) => vertices[vertex]);
      let pose = from;
      for (const motion of list) pose = driven(pose, motion);
      same(pose, to, `(edge ${edge})`);
      const trace = seen[edge];
      assert.ok(trace.length >= 2, `edge ${edge} is traced`);
      assert.deepEqual([trace[0], trace[trace.length - 1]], [from, to]);
      // Close enough to be connected by straight lines, and all of it on the drive.
      const length = list.reduce((sum, { control: [v], duration }) => sum + Math.abs(v) * duration, 0);
      const chords = trace.slice(1).reduce((sum, at, i) => sum + gap(trace[i], at)[0], 0);
      assert.ok(chords <= length + 1e-9 && chords > 0.99 * length - 1e-9, `edge ${edge}: ${chords} of ${length}`);
      const looks = dense(from, list);
      for (const at of trace) assert.ok(looks.some((look) => gap(look, at)[0] < 5e-3), `edge ${edge} is not at ${at}`);
    }
    fails(() => planner.motionsSince(edgeCount + 1), "out-of-range", "/row");
    fails(() => planner.tracesSince(edgeCount + 1), "out-of-range", "/row");
  });
}

test("without a planner's name everything is planned by two trees, but by controls a car that curves do not lead everywhere", () => {
  const left = { ...car, robot: { .../** @type {any} */ (car.robot), steering: [0, 0.7] } };
  assert.equal(Scenario.parse(left).planner().result().planner, "rrt-control");
  assert.equal(Scenario.parse(car).planner().result().planner, "rrt-connect");
  for (const scene of [body, arm]) assert.equal(Scenario.parse(scene).planner().result().planner, "rrt-connect");
});

test("without a word on steering a car follows the curves that its gears allow", () => {
  const steered = (/** @type {[number, number]} */ speed) => {
    const document = structuredClone(car);
    if (document.robot.type === "car") document.robot.speed = speed;
    return (/** @type {PlannerOptions} */ options = {}) => finish(Scenario.parse(document).planner({ algorithm: "rrt-connect", seed: 3, maxIterations: 3000, ...options }));
  };
  assert.equal(steered([-0.5, 0.5])().fingerprint(), steered([-0.5, 0.5])({ steering: "reeds-shepp" }).fingerprint());
  assert.equal(steered([0, 0.5])().fingerprint(), steered([0, 0.5])({ steering: "dubins" }).fingerprint());
  const backwards = (/** @type {Planner} */ planner) => planner.result().motions?.some(({ control: [v] }) => v < 0);
  assert.equal(backwards(steered([0, 0.5])()), false);
});

test("Euler's steps are named, and lead where exact arcs do not", () => {
  const scenario = Scenario.parse(car);
  const { path, motions = [], integration, status } = finish(scenario.planner({ algorithm: "rrt-control", integration: "euler", seed: 1 })).result();
  assert.deepEqual([status, integration], ["solved", "euler"]);
  let apart = 0;
  motions.forEach((motion, i) => {
    same(stepped(path[i], motion), path[i + 1], `(motion ${i})`);
    apart = Math.max(apart, gap(driven(path[i], motion), path[i + 1])[0]);
  });
  assert.ok(apart > 1e-4, `${apart} m`);
});

test("a car that starts in its goal region is there: one waypoint, no motion", () => {
  const document = { ...car, queries: [{ ...car.queries[0], goal: [0.55, 0.5, 0.2] }] };
  for (const algorithm of ["rrt-control", "sst"]) {
    const { status, path, motions, length } = finish(Scenario.parse(document).planner(asOptions({ algorithm }))).result();
    assert.deepEqual([status, path, motions, length], ["solved", [[0.5, 0.5, 0]], [], 0]);
  }
});

test("a tree that gives up tells how near it came, and how it got there", () => {
  const scenario = Scenario.parse(car);
  for (const options of [{ algorithm: "rrt-control" }, { algorithm: "sst" }, { algorithm: "rrt", step: 0.1 }]) {
    const { status, path, motions, length, approximate } = finish(scenario.planner(asOptions({ ...options, maxIterations: 20, seed: 1 }))).result();
    assert.deepEqual([status, path, motions, length], ["exhausted", [], [], 0]);
    assert.ok(approximate?.motions && approximate.path.length === approximate.motions.length + 1 && approximate.goal_distance > 0);
    approximate.motions.forEach((motion, i) => same(driven(approximate.path[i], motion), approximate.path[i + 1]));
  }
});

test("sst goes on to shorter paths where it may, tells what leaves the tree, and can be stopped", () => {
  const scenario = Scenario.parse(car);
  const start = () => scenario.planner({ algorithm: "sst", seed: 3, improveIterations: 4000 });
  const planner = start();
  planner.record();
  finish(planner);
  const costs = rows(planner.historySince(0), planner.historyWidth).map((row) => row[7]).filter(Number.isFinite);
  assert.ok(costs.every((cost, i) => i === 0 || cost <= costs[i - 1]) && costs[costs.length - 1] < costs[0], `${costs[0]} to ${costs[costs.length - 1]}`);
  const { length, path, motions = [] } = planner.result();
  assert.ok(Math.abs(length - costs[costs.length - 1]) < 1e-9);
  motions.forEach((motion, i) => same(driven(path[i], motion), path[i + 1]));
  const removed = rows(planner.eventsSince(0), planner.eventWidth).filter(([kind]) => kind === 6).map(([, , vertex]) => vertex);
  assert.ok(removed.length > 10 && new Set(removed).size === removed.length && removed.every((vertex) => vertex > 0 && vertex < planner.vertexCount));
  const kept = rows(planner.verticesSince(0), 3).filter((_, vertex) => !removed.includes(vertex)).map(String);
  for (const waypoint of path) assert.ok(kept.includes(String(waypoint)), `${waypoint} has left the tree`);

  const stopped = start();
  while (stopped.phase !== "improving") stopped.step(1);
  assert.deepEqual([stopped.status, stopped.path().length], ["running", 0]);
  assert.equal(stopped.finish(), "solved");
  assert.ok(stopped.result().length >= length && stopped.path().length > 0);
});

test("a built roadmap of a body, and of a steered car, is queried again; that of a body is resumed", () => {
  const scenario = Scenario.parse(body);
  const bodies = finish(scenario.planner({ algorithm: "prm", samples: 500, seed: 4 }));
  const straight = bodies.query([0.5, 1.2, 1], [1.9, 0.4, -1]);
  assert.deepEqual([straight.status, straight.motions], ["solved", undefined]);
  const resumed = finish(scenario.resume(bodies.roadmap("binary")));
  assert.deepEqual([resumed.status, resumed.path()], ["solved", bodies.path()]);
  const cars = finish(Scenario.parse(car).planner({ algorithm: "prm", samples: 400, seed: 1, steering: "reeds-shepp" }));
  const { status, path, motions = [] } = cars.query([0.4, 0.9, 2], [1, 0.3, 3]);
  assert.equal(status, "solved");
  assert.equal(path.length, motions.length + 1);
  motions.forEach((motion, i) => same(driven(path[i], motion), path[i + 1]));
  same(path[path.length - 1], [1, 0.3, 3]);
});

for (const steering of ["dubins", "reeds-shepp"]) {
  test(`a roadmap of a car along ${steering} curves is kept with them, and gone on with; GraphML tells their lengths and directions`, () => {
    const scenario = Scenario.parse(square);
    const planner = finish(scenario.planner(asOptions({ algorithm: "prm", samples: 300, seed: 1, steering })));
    assert.equal(planner.status, "solved");
    for (const kept of [planner.roadmap("json"), planner.roadmap("binary")]) {
      const resumed = finish(scenario.resume(kept));
      assert.deepEqual([resumed.status, resumed.path(), resumed.result().motions], ["solved", planner.path(), planner.result().motions]);
    }
    const other = steering === "dubins" ? "reeds-shepp" : "dubins";
    fails(() => scenario.resume(planner.roadmap("binary"), { steering: other }), "out-of-range", "/steering", /was built with/);
    const { [steering]: curves } = JSON.parse(planner.roadmap("json")).metric;
    assert.ok(Math.abs(curves.radius - 0.2) < 1e-12, `${curves.radius} m`);
    const xml = planner.roadmap("graphml");
    assert.match(xml, steering === "dubins" ? /edgedefault="directed"/ : /edgedefault="undirected"/);
    const weights = Array.from(xml.matchAll(/<data key="weight">(.+?)<\/data>/g), ([, weight]) => Number(weight));
    const lengths = motionsByEdge(planner).map((list) => list.reduce((sum, { control: [v], duration }) => sum + Math.abs(v) * duration, 0));
    assert.equal(weights.length, planner.edgeCount);
    assert.ok(weights.every((weight, i) => Math.abs(weight - lengths[i]) < 1e-12 * (1 + weight)));
  });
}

test("planners() says which robots each planner and each parameter is for; the others are refused by name", () => {
  const types = /** @type {(keyof typeof scenes)[]} */ (Object.keys(scenes));
  for (const { id, robots, parameters } of planners()) {
    assert.deepEqual(robots, ["rrt-control", "sst"].includes(id) ? ["car"] : types, id);
    for (const { name, robots: some } of parameters) assert.ok(some.length > 0 && some.every((type) => types.includes(type)), `${id} ${name}`);
    for (const type of types.filter((one) => !robots.includes(one))) {
      fails(() => Scenario.parse(scenes[type]).planner({ algorithm: id }), "unsupported", "/algorithm", new RegExp(`${id} plans for robots of type car, not ${type}`));
    }
  }
});

test("presets are settings of their planner, and start", () => {
  const found = planners().flatMap(({ id, presets, parameters, robots }) => {
    assert.equal(new Set(presets.map((preset) => preset.id)).size, presets.length, id);
    for (const { id: name, title, settings } of presets) {
      assert.ok(/^[a-z0-9]+(-[a-z0-9]+)*$/.test(name) && title.length > 0 && Object.keys(settings).length > 0, `${id} ${name}`);
      for (const key of Object.keys(settings)) assert.ok(parameters.some((parameter) => parameter.option === key), `${id} ${name} ${key}`);
      for (const type of robots) {
        const planner = Scenario.parse(scenes[type]).planner(asOptions({ algorithm: id, ...settings }));
        planner.step(20);
        assert.equal(planner.iterations > 0, true, `${id} ${name} ${type}`);
      }
    }
    return presets.map((preset) => `${id} ${preset.id}`);
  });
  assert.deepEqual(found, [
    "prm thirty-nearest", "prm thirty-nearest-400", "prm thirty-nearest-700", "prm twenty-points", "prm approximate", "prm forest-naive",
    "prm hundred-three-nearest", "prm thousand-three-nearest", "prm unchecked-1000-4", "prm unchecked-2000-4", "prm unchecked-2000-6",
    "prm three-nearest", "prm-star log-n",
    "rrt half-way", "rrt last-free-point", "rrt thousand-vertices", "rrt thousand-last-free", "rrt every-fifth",
    "rrt-control blossom-1", "rrt-control blossom-3", "rrt-control blossom-5", "rrt-control schedule", "rrt-control six-controls",
    "rrt-control thousand-vertices",
  ]);
});

test("what is not for a robot, or beyond a car, is refused where it stands", () => {
  /** @param {Partial<Extract<ScenarioDocument["robot"], { type: "car" }>>} fields */
  const other = (fields) => Scenario.parse(/** @type {ScenarioDocument} */ ({ ...car, robot: { ...car.robot, ...fields } }));
  const [bodies, cars] = [body, car].map((scene) => Scenario.parse(scene));
  for (const algorithm of ["rrt-control", "sst"]) {
    const { goal_tolerance: _, ...query } = car.queries[0];
    const exact = Scenario.parse({ ...car, queries: [car.queries[0], { ...query, name: "exact" }] });
    fails(() => exact.planner(asOptions({ algorithm, query: "exact" })), "missing-field", "/queries/1/goal_tolerance", /needs a goal_tolerance/);
    fails(() => cars.planner(asOptions({ algorithm, steering: "dubins" })), "unknown-parameter", "/steering");
    fails(() => cars.planner(asOptions({ algorithm, durationSteps: 10, shortestSteps: 11 })), "out-of-range", "/shortestSteps", /at most the longest duration, 10/);
    fails(() => cars.planner(asOptions({ algorithm, durationSteps: 0 })), "out-of-range", "/durationSteps");
    fails(() => cars.planner(asOptions({ algorithm, integration: "heun" })), "out-of-range", "/integration", /heun/);
  }
  fails(() => bodies.planner({ steering: "dubins" }), "out-of-range", "/steering", /steering = "dubins" is for robots of type car, not rigid_body/);
  fails(() => cars.planner(asOptions({ algorithm: "rrt", steering: "straight" })), "out-of-range", "/steering", /straight/);
  for (const scenario of [bodies, cars]) fails(() => scenario.planner({ algorithm: "rrt", metric: "euclidean" }), "out-of-range", "/metric", /is for robots of type arm, disc/);
  fails(() => cars.planner({ algorithm: "visibility-prm", steering: "dubins" }), "unsupported", "/steering", /use steering = reeds-shepp/);
  fails(() => other({ speed: [0, 0.5] }).planner({ algorithm: "rrt", steering: "reeds-shepp" }), "unsupported", "/steering", /speed range does not allow/);
  fails(() => other({ speed: [-0.5, 0] }).planner({ algorithm: "rrt", steering: "dubins" }), "unsupported", "/steering");
  fails(() => other({ steering: [0, 0.5] }).planner({ algorithm: "rrt" }), "unsupported", "/steering", /cannot steer both left and right/);
  fails(() => Scenario.parse({ ...body, queries: [{ ...body.queries[0], start: [1.2, 0.3, 0] }] }).planner(), "start-in-collision", "/queries/0/start", /the body touches obstacle 0/);
  fails(() => cars.planner().query([1, 1, 0], [0.5, 1, 0]), "unsupported", "");
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
  for (const robot of /** @type {const} */ (["rigid_body", "car"])) {
    assert.equal(Scenario.generate("gap", { robot, seed: 1 }).robot, robot);
    fails(() => Scenario.generate("clutter", { robot, radius: 0.05 }), "unknown-field", "/radius");
  }
});
