/**
 * What the package does, member by member: its tables, scenarios, configurations and motions. Its runs are in
 * runs.test.mjs.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { inspect } from "node:util";
import init, { Scenario, generators, initSync, planners, randomSeed, solve, version } from "planarium";
import { Scenario as Full } from "planarium/full";
import { arm, disc, fails } from "./scenes.mjs";

const close = (/** @type {number} */ a, /** @type {number} */ b) =>
  assert.ok(Math.abs(a - b) < 1e-12, `${a} is not ${b}`);

test("in Node the package is ready on import; init and initSync change nothing", async () => {
  const scenario = Scenario.parse(arm);
  await init();
  await Promise.all([init(), init("nowhere")]);
  initSync(new Uint8Array(0));
  assert.equal(scenario.name, "two-joints");
  assert.match(version, /^\d+\.\d+\.\d+(-dev)?$/);
});

test("planners() lists every planner with complete parameters", () => {
  const list = planners();
  assert.ok(new Set(list.map(({ id }) => id)).size === list.length && list.length >= 7);
  for (const { title, summary, guarantee, grows, driven, parameters } of list) {
    assert.ok(title.length > 0 && summary.length > 0 && guarantee.length > 0);
    assert.ok(["roadmap", "tree", "trees"].includes(grows) && typeof driven === "boolean");
    assert.ok(parameters.some(({ name }) => name === "max_iterations"));
    for (const parameter of parameters) {
      assert.match(parameter.name, /^[a-z][a-z_]*$/);
      assert.equal(
        parameter.option,
        parameter.name.replace(/_(.)/g, (_, letter) => letter.toUpperCase()),
      );
      assert.ok(parameter.title.length > 0 && parameter.meaning.length > 0, parameter.name);
      assert.ok(["integer", "number", "boolean", "choice"].includes(parameter.kind), parameter.kind);
      assert.equal(typeof parameter.unit, "string");
      assert.equal(parameter.kind === "choice", Array.isArray(parameter.choices));
      for (const bound of [parameter.min, parameter.max]) assert.ok(bound === null || Number.isFinite(bound));
      assert.ok(
        parameter.default !== undefined &&
          (parameter.default !== null || typeof parameter.default_meaning === "string"),
        parameter.name,
      );
    }
  }
});

test("generators() lists every generator with its options, which it takes", () => {
  const list = generators();
  assert.deepEqual(
    list.map(({ id }) => id),
    ["forest", "clutter", "discs", "maze", "gap", "bug-trap"],
  );
  for (const { id, title, summary, options } of list) {
    assert.ok(title.length > 0 && summary.length > 0);
    const defaults = options
      .filter(({ name }) => (name !== "links" || id === "forest") && !["draws", "sliding"].includes(name))
      .map((option) => [option.name, option.default ?? undefined]);
    assert.ok(Scenario.generate(id, Object.fromEntries(defaults)).title);
  }
});

test("randomSeed() gives integers below 2^53, not the same ones", () => {
  const seeds = new Set(Array.from({ length: 50 }, randomSeed));
  for (const seed of seeds) assert.ok(Number.isSafeInteger(seed) && seed >= 0);
  assert.equal(seeds.size, 50);
});

test("a scenario says what it is", () => {
  const one = Scenario.parse(arm);
  assert.deepEqual([one.name, one.robot, one.dimension], ["two-joints", "arm", 2]);
  const other = Scenario.parse(JSON.stringify(disc));
  assert.deepEqual(
    [other.name, other.title, other.robot, other.dimension],
    ["round-the-wall", "Round the wall", "disc", 2],
  );
  assert.deepEqual(other.circles(), [false, false]);
  assert.deepEqual(one.circles(), [true, true]);
  assert.deepEqual(other.extent(), disc.world.bounds);
});

test("text, object and scenario lead to the same document, which can be read again", () => {
  for (const scene of [arm, disc]) {
    const document = Scenario.parse(scene).document();
    assert.deepEqual(Scenario.parse(JSON.stringify(scene)).document(), document);
    assert.deepEqual(Scenario.parse(document).document(), document);
    assert.deepEqual(JSON.parse(JSON.stringify(Scenario.parse(scene))), document);
    assert.deepEqual(Scenario.parse(Scenario.parse(scene)).document(), document);
    assert.deepEqual(document.queries, scene.queries);
  }
});

test("numbers in objects arrive exactly", () => {
  const start = [0.1 + 0.2, 1 / 3];
  const document = Scenario.parse({ ...arm, queries: [{ name: "q", start, goal: [Math.PI / 7, 5e-324] }] }).document();
  assert.deepEqual(document.queries[0].start, start);
  assert.deepEqual(document.queries[0].goal, [Math.PI / 7, 5e-324]);
});

test("check names every pair that touches", () => {
  const scenario = Scenario.parse(arm);
  assert.deepEqual(scenario.check([0, 0]), { free: true, touching: [] });
  const { free, touching } = scenario.check(new Float64Array([0.5, 0]));
  assert.equal(free, false);
  assert.deepEqual(touching, [{ part: 1, obstacle: 0 }]);
  assert.deepEqual(Scenario.parse(disc).check([0.1, 5]).touching, [{ part: 0, obstacle: "bounds" }]);
  assert.equal(scenario.clearance([0.5, 0]), null);
  const near = /** @type {import("planarium").Clearance} */ (scenario.clearance([0, 0]));
  const [[ax, ay], [bx, by]] = near.points;
  assert.ok(near.distance > 0 && Math.abs(Math.hypot(bx - ax, by - ay) - near.distance) < 1e-12, JSON.stringify(near));
});

test("footprint and endEffector place the parts", () => {
  const scenario = Scenario.parse(arm);
  const [first, second] = scenario.footprint([Math.PI / 2, 0]);
  assert.ok(first.type === "capsule" && second.type === "capsule");
  assert.equal(first.radius, 0.05);
  close(first.b[0], 0);
  close(first.b[1], 1);
  close(second.b[1], 1.8);
  const tip = scenario.endEffector([Math.PI / 2, 0]);
  close(tip[0], second.b[0]);
  close(tip[1], second.b[1]);
  assert.deepEqual(Scenario.parse(disc).footprint([1, 2]), [{ type: "disc", center: [1, 2], radius: 0.4 }]);
  assert.deepEqual(Scenario.parse(disc).endEffector([1, 2]), [1, 2]);
});

test("endEffectors equals endEffector row by row, also for more rows than go over at once", () => {
  const scenario = Scenario.parse(arm);
  const rows = Float64Array.from({ length: 2 * 40_000 }, (_, i) => ((i * 7919) % 6283) / 1000 - Math.PI);
  const tips = scenario.endEffectors(rows);
  assert.equal(tips.length, rows.length);
  for (const row of [0, 1, 16_383, 16_384, 32_768, 39_999]) {
    assert.deepEqual(
      [...tips.subarray(2 * row, 2 * row + 2)],
      scenario.endEffector(rows.subarray(2 * row, 2 * row + 2)),
      `row ${row}`,
    );
  }
  assert.equal(scenario.endEffectors([]).length, 0);
});

test("interpolate and distance give numbers, and the way is a word", () => {
  const scenario = Scenario.parse(arm);
  close(scenario.distance([1, 0], [5, 0]), 2.2831853071795862);
  assert.deepEqual(scenario.interpolate([3, 0], [-3, 0], 0.5, "short"), scenario.interpolate([3, 0], [-3, 0], 0.5));
  close(scenario.interpolate([-3, 0], [3, 0], 1, "sign-of-difference")[0], 2 * Math.PI - 9);
  fails(() => scenario.interpolate([0, 0], [1, 1], 0.5, /** @type {any} */ ("long")), "out-of-range", "/way");
});

test("firstHit is null where the motion is proven, else where the first refused stretch begins", () => {
  const scenario = Scenario.parse(disc);
  assert.equal(scenario.firstHit([2, 2], [2, 8]), null);
  const hit = scenario.firstHit([2, 2], [8, 2]);
  assert.ok(hit !== null && hit > 0.4 && hit <= 2.5 / 6, String(hit));
});

test("a result is verified by other code, stored or at hand", () => {
  const scenario = Full.parse(disc);
  const result = solve(disc, { seed: 1 });
  const verdict = scenario.verify(result);
  assert.deepEqual([verdict.valid, verdict.why, verdict.movedStart], [true, null, false]);
  assert.equal(verdict.waypoints, result.path.length);
  assert.ok(verdict.clearance !== null && verdict.clearance > 0 && Number(verdict.looks) > 0);
  assert.deepEqual(scenario.verify(JSON.stringify(result)), verdict);
  const through = scenario.verify({ ...result, path: [result.path[0], [8, 2], result.path[result.path.length - 1]] });
  assert.deepEqual([through.valid, through.waypoints, through.clearance], [false, null, null]);
  assert.match(String(through.why), /edge|waypoint/);
  fails(() => scenario.verify({ ...result, scenario: "another" }), "invalid-result", "/scenario");
  fails(() => scenario.verify({ ...result, path: /** @type {any} */ ("short") }), "wrong-type", "/path");
  fails(() => scenario.verify("{"), "invalid-json");
  fails(() => scenario.verify(/** @type {any} */ (3)), "wrong-type");
});

test("cspace agrees with check at the centre of every cell", () => {
  const scenario = Scenario.parse(arm);
  const [width, height] = [24, 16];
  const cells = scenario.cspace({ width, height });
  const [[low1, high1], [low2, high2]] = scenario.cspaceRange();
  assert.deepEqual([low1, high1, low2, high2], [-Math.PI, Math.PI, -Math.PI, Math.PI]);
  assert.equal(cells.length, width * height);
  for (let row = 0; row < height; row += 1) {
    for (let column = 0; column < width; column += 1) {
      const q = [low1 + ((column + 0.5) / width) * (high1 - low1), low2 + ((row + 0.5) / height) * (high2 - low2)];
      assert.equal(cells[row * width + column] === 0, scenario.check(q).free, String(q));
    }
  }
  assert.ok(cells.includes(1) && cells.includes(0));
});

test("checkQuery tells of a blocked start or goal before planning", () => {
  const blocked = {
    ...arm,
    queries: [
      { ...arm.queries[0], start: [0.5, 0] },
      { name: "free", start: [0, 0], goal: [2, 0.5] },
      { name: "tip", start: [0, 0], target: { point: /** @type {[number, number]} */ ([1, 1]) } },
    ],
  };
  const scenario = Scenario.parse(blocked);
  assert.deepEqual(scenario.checkQuery(), {
    query: "over",
    free: false,
    start: scenario.check([0.5, 0]),
    goal: { free: true, touching: [] },
  });
  assert.deepEqual(scenario.checkQuery("free"), {
    query: "free",
    free: true,
    start: { free: true, touching: [] },
    goal: { free: true, touching: [] },
  });
  assert.deepEqual([scenario.checkQuery("tip").goal, scenario.checkQuery("tip").free], [null, true]);
  assert.throws(() => scenario.checkQuery("none"), { code: "unknown-query", pointer: "/query" });
  assert.throws(() => scenario.planner(), { code: "start-in-collision" });
});

test("console.log shows what an object is, also once it is freed", () => {
  const scenario = Scenario.parse(disc);
  assert.equal(
    inspect(scenario, { breakLength: Infinity }),
    "Scenario { dimension: 2, name: 'round-the-wall', robot: 'disc', title: 'Round the wall' }",
  );
  const planner = scenario.planner();
  assert.match(inspect(planner), /^Planner \{[^]*iterations: 0,[^]*status: 'running',[^]*vertexCount: 2/);
  planner.free();
  assert.match(inspect(planner), /^Planner \(freed\)$/);
});

test("how much room there is: the widest disc, the safest path, a route graph", () => {
  const scenario = Full.parse(disc);
  const widest = scenario.widest();
  const { radius, limit, bottleneck, between, slack } = widest;
  assert.ok(radius !== null && bottleneck !== null && slack > 0 && slack < 1e-11);
  const [[x, y], [u, v]] = bottleneck;
  const gap = Math.hypot(u - x, v - y);
  assert.ok(Math.abs(gap - (limit === "gap" ? 2 : 1) * radius) < 1e-12);
  assert.ok(between.length > 0 && between.every((one) => one === "bounds" || Number.isInteger(one)));
  const { length, clearance, path, ...others } = scenario.safest("across");
  assert.deepEqual(others, scenario.widest("across"));
  assert.ok(clearance !== null && clearance <= radius && radius - clearance < 1e-11);
  const shortest = scenario.optimum({ query: "across" }).length;
  assert.ok(length !== null && shortest !== null && length > shortest);
  assert.deepEqual(
    [path[0], path.at(-1)],
    [
      [2, 2],
      [8, 2],
    ],
  );
  const graph = scenario.routeGraph({ samples: 200, detour: 1.4, longestLeg: 3, seed: 5 });
  assert.deepEqual([graph.detour, graph.longestLeg, graph.seed, graph.parts], [1.4, 3, 5, 1]);
  assert.ok(graph.largestDetour <= 1.4 + 1e-9 && graph.covered > 0.9 && /^[\da-f]{16}$/.test(graph.fingerprint));
  for (const { nodes, length: metres } of graph.edges) {
    const [a, b] = nodes.map((node) => graph.nodes[node]);
    assert.ok(Math.abs(Math.hypot(a[0] - b[0], a[1] - b[1]) - metres) < 1e-12);
    assert.equal(scenario.firstHit(a, b), null);
  }
  assert.deepEqual(scenario.routeGraph({ samples: 200, detour: 1.4, longestLeg: 3, seed: 5 }), graph);
  assert.throws(() => scenario.widest("nowhere"), { code: "unknown-query" });
  assert.throws(() => scenario.safest(/** @type {any} */ (3)), { code: "wrong-type" });
  assert.throws(() => scenario.routeGraph({ detour: 0.5 }), { code: "out-of-range", pointer: "/detour" });
  assert.throws(() => scenario.routeGraph({ longestLeg: 0 }), { code: "out-of-range", pointer: "/longestLeg" });
  const other = Full.parse(arm);
  for (const call of [() => other.widest(), () => other.safest(), () => other.routeGraph()])
    assert.throws(call, { code: "unsupported" });
});

test("optimum returns a record: exact, or a reference", () => {
  const scenario = Scenario.parse(disc);
  const { length, path, slack, ...others } = scenario.optimum({ query: "across" });
  assert.ok(slack !== null && slack > 0 && slack < 1e-11 && length !== null && length > 12);
  assert.deepEqual(
    [path[0], path.at(-1)],
    [
      [2, 2],
      [8, 2],
    ],
  );
  assert.deepEqual(others, {
    scenario: scenario.name,
    query: "across",
    method: "tangent-graph",
    exact: true,
    resolution: null,
    length_measure: "metres",
  });
  // To the bit what the command line prints.
  const rings = Scenario.parse(readFileSync(new URL("../../www/scenes/rings.json", import.meta.url), "utf8"));
  assert.equal(rings.optimum().length, 13.543068005532522);
  // A prepared world has the same answers.
  const many = scenario.shortestPaths({ manyQueries: true });
  assert.deepEqual(many.query([2, 2], [8, 2]), { length, path });
  assert.ok(Number(many.tangents) > 0);
  many.free();
  fails(() => Reflect.apply(scenario.shortestPaths, scenario, [{ manyQueries: 1 }]), "wrong-type", "/manyQueries");
  fails(() => Reflect.apply(scenario.shortestPaths, scenario, [{ many: true }]), "unknown-field", "/many");
  const paths = scenario.shortestPaths();
  assert.equal(paths.tangents, null);
  assert.deepEqual(paths.query([2, 2], new Float64Array([8, 2])), { length, path });
  assert.throws(() => paths.query([2], [8, 2]), { code: "wrong-dimension", pointer: "/start" });
  assert.throws(() => paths.query([2, 2], [8, Infinity]), { code: "not-finite", pointer: "/goal/1" });
  assert.throws(() => paths.query([2, 2], [80, 2]), { code: "goal-in-collision", pointer: "/goal" });
  assert.throws(() => Scenario.parse(arm).shortestPaths(), { code: "unsupported" });
  paths.free();
  const reference = Scenario.parse(arm).optimum({ metric: "euclidean" });
  assert.deepEqual([reference.method, reference.exact], ["grid", false]);
});
