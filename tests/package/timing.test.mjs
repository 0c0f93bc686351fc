/** Timing of paths, and the judge of paths of any origin, through the package: what they take, give and refuse. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { PlanariumError, readPath, readWorld, writePath } from "planarium/import";
import { Scenario, solve } from "planarium/full";
import { fails, finish, scenes } from "./scenes.mjs";

/** @typedef {import("planarium/full").TimingLimits} TimingLimits */

/** Limits for each type of robot. @type {Record<string, TimingLimits>} */
const LIMITS = {
  arm: { speed: 1, acceleration: [2, 3] },
  disc: { speed: 1, acceleration: 2 },
  rigid_body: { speed: 1, acceleration: 2, turnRate: 1, turnAcceleration: 3 },
  car: { speed: 0.4, acceleration: 1, lateralAcceleration: 0.5 },
};

/** A scene with a solved path and its trajectory. @param {keyof typeof scenes} robot */
function timed(robot) {
  const scenario = Scenario.parse(scenes[robot]);
  const options = robot === "car" ? { maxIterations: 20_000 } : { shortcut: 50, blend: 0.5 };
  const planner = finish(/** @type {any} */ (scenario.planner({ seed: 2, ...options })));
  const result = planner.result();
  planner.free();
  assert.equal(result.status, "solved");
  return { scenario, result, trajectory: scenario.time(result, LIMITS[robot]) };
}

for (const robot of /** @type {(keyof typeof scenes)[]} */ (Object.keys(scenes)))
  test(`a path of a ${robot} is timed from rest to rest, verified, and read back`, () => {
    const { scenario, result, trajectory } = timed(robot);
    const { duration, dimension } = trajectory;
    assert.ok(duration > 0 && dimension === scenario.dimension);
    const [first, last] = [trajectory.state(-1), trajectory.state(duration + 1)];
    assert.deepEqual([first.time, last.time], [0, duration]);
    assert.deepEqual([...first.configuration], result.path[0]);
    for (const { velocity } of [first, last]) assert.ok(velocity.every((rate) => rate === 0));
    assert.ok([first.configuration, first.velocity, first.acceleration].every((one) => one instanceof Float64Array));
    // The speed is that of the point that represents a configuration.
    const point = (/** @type {number} */ t) => scenario.endEffector([...trajectory.state(t).configuration]);
    for (let t = duration / 40; t < duration; t += duration / 20) {
      const [[x, y], [u, v]] = [point(t - 1e-6), point(t + 1e-6)];
      assert.ok(Math.abs(Math.hypot(u - x, v - y) / 2e-6 - trajectory.speed(t)) < 1e-4, `at ${t}`);
    }
    const rows = trajectory.sample(duration / 7.5);
    const width = 1 + 3 * dimension;
    assert.equal(rows.length, 9 * width, "eight states a step apart, and the end");
    for (let i = 0; i < 9; i += 1) {
      const [t, ...numbers] = rows.subarray(i * width, (i + 1) * width);
      assert.equal(t, i === 8 ? duration : i * (duration / 7.5));
      const { configuration, velocity, acceleration } = trajectory.state(t);
      assert.deepEqual(numbers, [...configuration, ...velocity, ...acceleration]);
    }
    const document = trajectory.toJSON();
    assert.equal(document.duration, duration);
    const stops = document.pieces.filter(({ knots }) => knots[0][1] === 0).length;
    assert.equal(trajectory.restCount, stops - 1);
    const again = scenario.trajectory(JSON.stringify(trajectory));
    // As text: JSON has no -0.
    assert.equal(JSON.stringify(again), JSON.stringify(document));
    assert.equal(JSON.stringify(again.state(duration / 3)), JSON.stringify(trajectory.state(duration / 3)));
    for (const given of [trajectory, document, JSON.stringify(document)]) {
      const { valid, why, path, trajectory: found } = scenario.verifyTrajectory(result, given);
      assert.deepEqual([valid, why, path.valid, found?.duration], [true, null, true, duration]);
      assert.ok((found?.looks ?? 0) > 10 && (found?.speed ?? 2) <= 1 + 1e-9 && (found?.acceleration ?? 2) <= 1 + 1e-9);
      assert.ok(Math.max(found?.speed ?? 0, found?.acceleration ?? 0) > 0.99, "it is as fast as the limits allow");
    }
    // A trajectory outlives its scenario.
    scenario.free();
    assert.ok(again.speed(duration / 3) >= 0);
    again.free();
    for (const use of [() => again.state(0), () => again.duration, () => again.toJSON(), () => again.sample(1)])
      fails(use, "freed");
    again.free();
  });

test("a trajectory or a path that is wrong is a verdict with its reason", () => {
  const { scenario, result, trajectory } = timed("disc");
  const document = trajectory.toJSON();
  const faster = { ...document, limits: { ...document.limits, speed: 0.9 } };
  const verdict = scenario.verifyTrajectory(result, /** @type {any} */ (faster));
  assert.deepEqual([verdict.valid, verdict.path.valid, verdict.trajectory], [false, true, null]);
  assert.match(String(verdict.why), /^the trajectory: .*limit/);
  const through = {
    ...result,
    path: [result.path[0], /** @type {number[]} */ (result.path.at(-1))],
    blends: undefined,
  };
  const blocked = scenario.verifyTrajectory(through, document);
  assert.deepEqual([blocked.valid, blocked.path.valid, blocked.trajectory], [false, false, null]);
  fails(() => scenario.time(through, LIMITS.disc), "invalid-result", "/result/path", /not valid/);
  const unchecked = scenario.time(through, LIMITS.disc, { verify: false });
  assert.ok(Math.abs(unchecked.duration - 6.5) < 1e-9, "6 m at 1 m/s, half a second more for speeding up and down");
  assert.equal(scenario.verifyTrajectory(result, unchecked).valid, false, "it leads along another path");
});

test("what timing refuses, by code and place", () => {
  const { scenario, result, trajectory } = timed("disc");
  const document = trajectory.toJSON();
  const arm = timed("arm");
  const body = timed("rigid_body");
  const car = timed("car");
  /** @type {any} */ const any = scenario;
  /** @type {any} */ const anyTrajectory = trajectory;
  /** @type {[() => unknown, string, string, RegExp?][]} */
  const cases = [
    [() => any.time(), "wrong-type", "/result", /undefined/],
    [() => any.time(result), "wrong-type", "/limits", /^limits must be an object/],
    [() => any.time(result, 7), "wrong-type", "/limits"],
    [() => any.time(result, [1, 2]), "wrong-type", "/limits"],
    [() => any.time(result, {}), "missing-field", "/limits/speed"],
    [() => any.time(result, { speed: 1 }), "missing-field", "/limits/acceleration"],
    [() => any.time(result, { speed: "1", acceleration: 1 }), "wrong-type", "/limits/speed"],
    [() => any.time(result, { speed: [1, "1"], acceleration: 1 }), "wrong-type", "/limits/speed/1"],
    [() => any.time(result, { speed: 0, acceleration: 1 }), "out-of-range", "/limits/speed"],
    [() => any.time(result, { speed: 1, acceleration: NaN }), "not-finite", "/limits/acceleration"],
    [() => any.time(result, { speed: [1, 0], acceleration: 1 }), "out-of-range", "/limits/speed/1"],
    [() => any.time(result, { speed: [1, 1, 1], acceleration: 1 }), "wrong-dimension", "/limits/speed"],
    [() => any.time(result, { speed: 1, acceleration: 1, jerk: 1 }), "unknown-field", "/limits/jerk", /turnRate/],
    [() => any.time(result, { speed: 1, acceleration: 1, turn_rate: 1 }), "unknown-parameter", "/limits/turn_rate"],
    [
      () => any.time(result, { speed: 1, acceleration: 1, turnRate: 1 }),
      "unsupported",
      "/limits/turnRate",
      /does not turn/,
    ],
    [() => any.time(result, LIMITS.disc, { verified: 1 }), "unknown-field", "/verified"],
    [() => any.time(result, LIMITS.disc, { verify: 1 }), "wrong-type", "/verify"],
    [() => any.time({ ...result, scenario: "x" }, LIMITS.disc), "invalid-result", "/result/scenario"],
    [() => any.time({ ...result, status: "exhausted" }, LIMITS.disc), "invalid-result", "/result/path", /exhausted/],
    [
      () => any.time({ ...result, status: "exhausted" }, LIMITS.disc, { verify: false }),
      "invalid-result",
      "/result/status",
    ],
    [() => any.time({ ...result, path: 7 }, LIMITS.disc), "wrong-type", "/result/path"],
    [() => any.time("{", LIMITS.disc), "invalid-json", "/result"],
    [() => body.scenario.time(body.result, LIMITS.disc), "missing-field", "/limits/turnRate", /"turnRate"/],
    [() => arm.scenario.time(arm.result, LIMITS.car), "unsupported", "/limits/lateralAcceleration"],
    [() => car.scenario.time(car.result, { speed: [1, 1, 1], acceleration: 1 }), "unsupported", "/limits"],
    [() => any.trajectory(), "wrong-type", ""],
    [() => any.trajectory("{}"), "missing-field", "/format"],
    [() => any.trajectory({ ...document, format: "planarium-result-1" }), "unknown-format", "/format"],
    [() => any.trajectory({ ...document, scenario: "x" }), "invalid-result", "/scenario"],
    [() => any.trajectory({ ...document, query: "x" }), "unknown-query", "/query"],
    [() => any.trajectory({ ...document, duration: 1 }), "invalid-result", "/duration"],
    [() => any.trajectory({ ...document, start: [0] }), "wrong-dimension", "/start"],
    [() => any.trajectory({ ...document, pieces: [{ type: "spline" }] }), "unknown-type", "/pieces/0/type"],
    [() => any.trajectory({ ...document, pieces: [] }), "invalid-result", "/duration"],
    [() => any.verifyTrajectory(result), "wrong-type", "/trajectory"],
    [() => any.verifyTrajectory(result, { ...document, scenario: "x" }), "invalid-result", "/trajectory/scenario"],
    [() => any.verifyTrajectory({ ...result, scenario: "x" }, document), "invalid-result", "/result/scenario"],
    [() => anyTrajectory.state(), "wrong-type", "/t"],
    [() => anyTrajectory.state(NaN), "not-finite", "/t"],
    [() => anyTrajectory.speed("1"), "wrong-type", "/t"],
    [() => anyTrajectory.sample(0), "out-of-range", "/dt"],
    [() => anyTrajectory.sample(-1), "out-of-range", "/dt"],
    [() => anyTrajectory.sample(Infinity), "not-finite", "/dt"],
    [() => anyTrajectory.sample(trajectory.duration / 2e6), "out-of-range", "/dt"],
    [() => new /** @type {any} */ (anyTrajectory.constructor)(), "illegal-constructor", ""],
  ];
  for (const [work, code, pointer, message] of cases) fails(work, code, pointer, message);
  assert.ok(trajectory.sample(trajectory.duration / 1.4e6).length <= 10_000_000, "the largest sample fits");
  trajectory.free();
  fails(() => scenario.verifyTrajectory(result, trajectory), "invalid-json", "/trajectory", /freed/);
});

test("the judge says where a path of any origin first touches what, and how near it comes", () => {
  const disc = Scenario.parse(scenes.disc);
  const through = disc.judge([
    [2, 2],
    [2, 4],
    [8, 4],
  ]);
  assert.deepEqual([through.valid, through.free, through.waypoints, through.clearance], [false, false, 3, null]);
  const { edge, fraction, with: what, part, point, configuration } = through.contact ?? assert.fail();
  assert.deepEqual([edge, what, part], [1, { obstacle: 0 }, 0]);
  // It touches where its centre is its radius before the wall.
  assert.ok(Math.abs(configuration[0] - 4.5) < 1e-6 && Math.abs(fraction - 2.5 / 6) < 1e-6);
  assert.ok(Math.abs((point?.[0] ?? 0) - 4.9) < 1e-6 && Math.abs((point?.[1] ?? 0) - 4) < 1e-6);
  const free = disc.judge(Float64Array.of(2, 2, 2, 9, 8, 9, 8, 2));
  assert.deepEqual([free.valid, free.free, free.contact, free.turns], [true, true, null, undefined]);
  const { distance, at_least: least, obstacle } = free.clearance ?? assert.fail();
  assert.ok(Math.abs(distance - 0.6) < 1e-3 && least <= 0.6 && least > 0.598 && obstacle === 0);
  assert.deepEqual(disc.judge([2, 2]).waypoints, 1);
  assert.deepEqual(
    disc.judge([
      [2, 2],
      [2, 11],
    ]).contact?.with,
    "bounds",
  );

  const limited = /** @type {any} */ ({
    ...scenes.arm.robot,
    joint_limits: [
      [-1, 1],
      [-1, 1],
    ],
  });
  const arm = Scenario.parse({ ...scenes.arm, world: { obstacles: [] }, robot: limited, queries: [] });
  const { with: limit, fraction: at } =
    arm.judge([
      [0, 0],
      [0, 2],
    ]).contact ?? assert.fail();
  assert.deepEqual(limit, { "joint-limit": 1 });
  assert.ok(Math.abs(at - 0.5) < 1e-6);

  const car = Scenario.parse(scenes.car);
  const driven = [0.5, 0.5, 0, 0.7, 0.5, 0, 0.7, 0.6, 0];
  const { valid, free: isFree, turns } = car.judge(driven);
  assert.deepEqual([valid, isFree, turns?.count, turns?.first[0].edge], [false, true, 1, 1]);
  assert.equal(turns?.first[0].fault, "sideways");
  const arc = [0.5, 0.5, 0, 0.6, 0.51, 0.2];
  assert.equal(car.judge(arc, { arcs: true, driveTolerance: 0.1 }).valid, true);

  // A path that the planner has found is free, for every robot.
  for (const robot of /** @type {const} */ (["arm", "rigid_body"])) {
    const { scenario, result } = timed(robot);
    assert.equal(scenario.judge(result.path).free, true, robot);
  }
});

test("what the judge refuses, by code and place", () => {
  /** @type {any} */ const disc = Scenario.parse(scenes.disc);
  /** @type {[() => unknown, string, string, RegExp?][]} */
  const cases = [
    [() => disc.judge(), "wrong-type", "/path"],
    [() => disc.judge("path.csv"), "wrong-type", "/path"],
    [() => disc.judge([]), "out-of-range", "/path", /no waypoint/],
    [() => disc.judge([1, 2, 3]), "wrong-dimension", "/path"],
    [() => disc.judge([[1, 2], [3]]), "wrong-dimension", "/path/1"],
    [
      () =>
        disc.judge([
          [1, 2],
          ["3", 4],
        ]),
      "wrong-type",
      "/path/1/0",
    ],
    [() => disc.judge([1, 2, 3, NaN]), "not-finite", "/path/1/1"],
    [() => disc.judge([[1, 2]], { arcs: true }), "unsupported", "/arcs"],
    [() => disc.judge([[1, 2]], { arcs: 1 }), "wrong-type", "/arcs"],
    [() => disc.judge([[1, 2]], { driveTolerance: -1 }), "out-of-range", "/driveTolerance"],
    [() => disc.judge([[1, 2]], { drive_tolerance: 1 }), "unknown-parameter", "/drive_tolerance", /driveTolerance/],
    [() => disc.judge([[1, 2]], { tolerance: 1 }), "unknown-field", "/tolerance"],
    [() => disc.judge(new Float64Array(2 * 2_000_001)), "too-large", "/path", /2000001/],
    [() => disc.judge(Array.from({ length: 2_000_001 }, () => [1, 2])), "too-large", "/path", /2000001/],
  ];
  for (const [work, code, pointer, message] of cases) fails(work, code, pointer, message);
  disc.free();
  fails(() => disc.judge([[1, 2]]), "freed");
});

/** A file of a path. @param {string} text @param {string} [name] */
const fileOf = (text, name = "path.csv") => ({ name, bytes: new TextEncoder().encode(text) });

test("a path of another program is read in the coordinates of the scenario, and judged", async () => {
  const scenario = scenes.disc;
  const file = fileOf("t,x [cm],y [cm],cost\n0,200,200,7\n1,200,400,8\n2,800,400,9\n");
  const { waypoints, dimension, report } = await readPath(file, { scenario });
  assert.deepEqual([[...waypoints], dimension], [[2, 2, 2, 4, 8, 4], 2]);
  assert.ok(waypoints instanceof Float64Array);
  assert.deepEqual([report.format, report.waypoints, report.offset], ["table", 3, [0, 0]]);
  assert.deepEqual(report.columns.map(({ meaning, unit }) => [meaning, unit]).slice(1, 3), [
    ["x", "cm"],
    ["y", "cm"],
  ]);
  assert.equal(report.columns[3].meaning, null, "a column that is left out");
  assert.equal(Scenario.parse(scenes.disc).judge(waypoints).contact?.edge, 1);

  // A map in degrees is moved and scaled; the path goes with it.
  const square = (/** @type {number} */ low, /** @type {number} */ high) => [
    [low, low],
    [high, low],
    [high, high],
    [low, high],
    [low, low],
  ];
  const feature = { type: "Feature", properties: {}, geometry: { type: "Polygon", coordinates: [square(10, 10.001)] } };
  const map = JSON.stringify({ type: "FeatureCollection", features: [feature] });
  const world = await readWorld([fileOf(map, "map.geojson")], { coordinates: "degrees" });
  const line = {
    type: "LineString",
    coordinates: [
      [10, 10],
      [10.001, 10.001],
    ],
  };
  const read = await readPath(fileOf(JSON.stringify(line), "line.geojson"), { scenario: world.scenario });
  const corners = /** @type {any} */ (world.scenario.world.obstacles[0]).vertices.flat();
  for (const coordinate of read.waypoints)
    assert.ok(
      corners.some((/** @type {number} */ corner) => Math.abs(corner - coordinate) < 1e-6),
      `${coordinate}`,
    );
  assert.ok(read.waypoints[2] - read.waypoints[0] > 100, "a thousandth of a degree is more than 100 m");

  const body = await readPath(fileOf("1,2,90\n3,4,-45\n"), { scenario: scenes.rigid_body, angles: "degrees" });
  assert.deepEqual([...body.waypoints], [1, 2, Math.PI / 2, 3, 4, -Math.PI / 4]);
  const arm = await readPath(fileOf("[[1, 2], [3, 4]]", "path.json"), { scenario: scenes.arm });
  assert.deepEqual([arm.report.format, [...arm.waypoints]], ["rows", [1, 2, 3, 4]]);
});

test("what the reader of paths refuses, by code and place", async () => {
  const scenario = scenes.disc;
  const file = fileOf("0,0\n1,1\n");
  /** @type {[unknown[], string, string, RegExp?][]} */
  const cases = [
    [[], "wrong-type", "/file"],
    [[[file], { scenario }], "missing-field", "/file/name"],
    [[{ name: "a" }, { scenario }], "missing-field", "/file/bytes"],
    [[{ name: "a", bytes: "0,0" }, { scenario }], "wrong-type", "/file/bytes"],
    [[file], "missing-field", "/scenario"],
    [[file, 7], "wrong-type", ""],
    [[file, { scenario: "disc" }], "wrong-type", "/scenario"],
    [
      [file, { scenario: { ...scenario, robot: { type: "disc", radius: -1 } } }],
      "out-of-range",
      "/scenario/robot/radius",
    ],
    [[file, { scenario: { ...scenario, robot: { type: "tank" } } }], "unknown-type", "/scenario/robot/type"],
    [[file, { scenario, angle: "degrees" }], "unknown-field", "/angle", /nearest is angles$/],
    [[file, { scenario, angles: "turns" }], "out-of-range", "/angles"],
    [[file, { scenario: { ...scenario, frame: { offset: [0] } } }], "wrong-dimension", "/scenario/frame/offset"],
    [[fileOf("0,0,0\n1,x,1\n"), { scenario }], "invalid-file", ""],
    [[fileOf("name,age\n1,2\n"), { scenario }], "wrong-columns", ""],
    [[fileOf(""), { scenario }], "truncated", ""],
    [[fileOf("x,y,theta\n0,0,90\n1,1,180\n"), { scenario: scenes.rigid_body }], "invalid-option", ""],
  ];
  for (const [given, code, pointer, message = /.{11}/] of cases) {
    const work = Reflect.apply(readPath, undefined, given);
    await assert.rejects(work, (error) => {
      assert.ok(error instanceof PlanariumError, String(error));
      assert.deepEqual([error.code, error.pointer], [code, pointer], error.message);
      assert.match(error.message, message);
      return true;
    });
  }
  const { file: name, place } = await readPath(fileOf("0,0\n1,x\n"), { scenario }).then(
    () => assert.fail("nothing was thrown"),
    (/** @type {PlanariumError} */ error) => error,
  );
  assert.deepEqual([name, place], ["path.csv", { line: 2 }]);
});

/** What a form holds, as text. @param {Uint8Array} bytes */
const textOf = (bytes) => new TextDecoder().decode(bytes);

test("a path is written in every form, and read back as it was", async () => {
  // A shift of the map and degrees: the path goes the way back.
  const frame = { offset: [-3, 5], plane: { origin: [13.4, 52.5], scale: [68e3, 111e3], degrees: true } };
  for (const [kind, numbers] of /** @type {const} */ ([
    ["disc", [2, 2, 8, 4]],
    ["rigid_body", [2, 2, 0.5, 8, 4, -1.5]],
  ])) {
    const scenario = /** @type {any} */ ({ ...scenes[kind], frame });
    const path = { configurations: Float64Array.from(numbers) };
    for (const form of /** @type {const} */ (["csv", "json", "npy", "geojson", "nav-path", "nav-waypoints"])) {
      const bytes = await writePath(path, { scenario, form, query: "across" });
      assert.ok(bytes instanceof Uint8Array);
      const { waypoints } = await readPath({ name: `path.${form}`, bytes }, { scenario });
      assert.equal(waypoints.length, numbers.length, form);
      waypoints.forEach((number, i) => assert.ok(Math.abs(number - numbers[i]) < 1e-6, `${form}: ${waypoints}`));
    }
    assert.match(
      textOf(await writePath(path, { scenario, form: "svg" })),
      /<svg [^]*<title>[^,]+<\/title>[^]*<\/svg>\s*$/,
    );
    const poses = textOf(await writePath(path, { scenario, form: "nav-path", frameId: "odom" }));
    assert.match(poses, /frame_id: "?odom"?/);
  }
  const { coordinates } = JSON.parse(
    textOf(
      await writePath(
        { configurations: Float64Array.of(3, -5, 4, -5) },
        { scenario: /** @type {any} */ ({ ...scenes.disc, frame }), form: "geojson" },
      ),
    ),
  ).features[0].geometry;
  assert.deepEqual(coordinates[0], [13.4, 52.5], "the origin of the plane");
});

test("rows of results and trajectories are written with their times and speeds", async () => {
  const scenario = Scenario.parse(scenes.disc);
  const result = solve(scenes.disc, { algorithm: "rrt-connect", seed: 3, shortcut: 50 });
  const path = scenario.pathRows(result);
  assert.deepEqual([...path], result.path.flat());
  const trajectory = scenario.time(result, { speed: 1, acceleration: 2 });
  const corners = trajectory.rows();
  for (const states of [corners, trajectory.sample(0.1)]) {
    const text = textOf(await writePath({ states }, { scenario: scenes.disc, form: "csv" }));
    const [header, ...rows] = text.trim().split("\n");
    assert.equal(header, "t_s,x_m,y_m,vx_m_s,vy_m_s,speed_m_s".split(",").slice(0, header.split(",").length).join(","));
    assert.equal(rows.length, states.length / 7);
    assert.deepEqual(rows.at(-1)?.split(",").slice(0, 3).map(Number), [...states.subarray(-7, -4)]);
  }
  for (let i = 0; i < path.length; i += 2) {
    const isThere = (/** @type {number} */ row) => corners[row + 1] === path[i] && corners[row + 2] === path[i + 1];
    assert.ok(Array.from({ length: corners.length / 7 }, (_, row) => 7 * row).some(isThere), "every corner is a row");
  }
  for (const [call, code, pointer] of /** @type {const} */ ([
    [() => scenario.pathRows(result, { deviation: 0 }), "out-of-range", "/deviation"],
    [() => trajectory.rows({ deviation: NaN }), "not-finite", "/deviation"],
    [() => scenario.pathRows({ ...result, query: "none" }), "unknown-query", "/result/query"],
  ]))
    assert.throws(call, (error) => {
      assert.ok(error instanceof PlanariumError, String(error));
      assert.deepEqual([error.code, error.pointer], [code, pointer], error.message);
      return true;
    });
});

test("a disc that turns and drives has a heading, which is written", async () => {
  const scenario = Scenario.parse(scenes.disc);
  const result = solve(scenes.disc, { algorithm: "rrt-connect", seed: 3, shortcut: 50 });
  const limits = { speed: 1, acceleration: 2, turnRate: 2, turnAcceleration: 4, differential: true };
  const trajectory = scenario.time(result, limits);
  assert.equal(trajectory.dimension, 3);
  const [[x, y], [u, v]] = result.path;
  assert.ok(Math.abs(trajectory.state(0).configuration[2] - Math.atan2(v - y, u - x)) < 1e-12);
  assert.ok(scenario.verifyTrajectory(result, JSON.stringify(trajectory)).valid);
  assert.equal(scenario.trajectory(trajectory.toJSON()).duration, trajectory.duration);
  const states = trajectory.sample(0.1);
  const options = { scenario: scenes.disc, form: /** @type {const} */ ("csv") };
  const rows = textOf(await writePath({ states, dimension: trajectory.dimension }, options))
    .trim()
    .split("\n");
  assert.equal(rows[0], "t_s,x_m,y_m,theta_rad,vx_m_s,vy_m_s,omega_rad_s");
  assert.equal(rows.length, 1 + states.length / 10);
  assert.deepEqual(rows.at(-1)?.split(",").map(Number), [...states.subarray(-10, -3)]);
  for (const [call, code, pointer] of /** @type {const} */ ([
    [
      () => scenario.time(result, { speed: 1, acceleration: 2, differential: true }),
      "missing-field",
      "/limits/turnRate",
    ],
    [() => scenario.time(result, { ...limits, lateralAcceleration: 1 }), "unsupported", "/limits/lateralAcceleration"],
    [() => scenario.time(result, { ...limits, speed: [1, 1] }), "wrong-dimension", "/limits/speed"],
  ]))
    assert.throws(call, (error) => {
      assert.ok(error instanceof PlanariumError, String(error));
      assert.deepEqual([error.code, error.pointer], [code, pointer], error.message);
      return true;
    });
});

test("what the writer of paths refuses, by code and place", async () => {
  const [disc, arm] = [scenes.disc, scenes.arm];
  const path = { configurations: Float64Array.of(2, 2, 8, 4) };
  const form = "csv";
  /** @type {[unknown[], string, string][]} */
  const cases = [
    [[], "wrong-type", "/path"],
    [[{}, { scenario: disc, form }], "missing-field", "/path"],
    [
      [
        { ...path, states: path.configurations },
        { scenario: disc, form },
      ],
      "unknown-field",
      "/path/states",
    ],
    [[{ configurations: [2, 2] }, { scenario: disc, form }], "wrong-type", "/path/configurations"],
    [[{ configurations: new Float64Array(3) }, { scenario: disc, form }], "wrong-dimension", "/path/configurations"],
    [[{ states: new Float64Array(8) }, { scenario: disc, form }], "wrong-dimension", "/path/states"],
    [[{ configurations: new Float64Array(0) }, { scenario: disc, form }], "truncated", ""],
    [[{ configurations: Float64Array.of(0, NaN) }, { scenario: disc, form }], "invalid-number", ""],
    [
      [
        { ...path, dimension: 4 },
        { scenario: disc, form },
      ],
      "wrong-dimension",
      "/path/dimension",
    ],
    [
      [
        { ...path, dimension: 3 },
        { scenario: arm, form },
      ],
      "wrong-dimension",
      "/path/dimension",
    ],
    [
      [
        { ...path, dimension: 2.5 },
        { scenario: disc, form },
      ],
      "wrong-type",
      "/path/dimension",
    ],
    [[path, { form }], "missing-field", "/scenario"],
    [[path, { scenario: disc }], "missing-field", "/form"],
    [[path, { scenario: disc, form: "gpx" }], "out-of-range", "/form"],
    [[path, { scenario: disc, form, frame: "map" }], "unknown-field", "/frame"],
    [[path, { scenario: disc, form, frameId: "map" }], "invalid-option", ""],
    [[path, { scenario: arm, form: "geojson" }], "invalid-option", ""],
  ];
  for (const [given, code, pointer] of cases)
    await assert.rejects(Reflect.apply(writePath, undefined, given), (error) => {
      assert.ok(error instanceof PlanariumError, String(error));
      assert.deepEqual([error.code, error.pointer], [code, pointer], error.message);
      return true;
    });
});
