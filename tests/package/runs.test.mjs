/** What a run gives, and how it is stepped: cursors, history, paths, roadmaps, growth; the same in any slices. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Planner, Scenario, Trajectories, historyColumns, phases, solve } from "planarium/full";
import { arm, disc, finish, options as asOptions } from "./scenes.mjs";

for (const algorithm of ["prm", "rrt-connect"]) {
  test(`${algorithm}: cursors give every row once, in whole rows`, () => {
    const planner = Scenario.parse(arm).planner(asOptions({ algorithm, seed: 3 }));
    /** @type {number[]} */ const vertices = [];
    /** @type {number[]} */ const edges = [];
    /** @type {number[]} */ const events = [];
    for (let done = false; !done;) {
      done = planner.step(37) !== "running";
      vertices.push(...planner.verticesSince(vertices.length / planner.dimension));
      edges.push(...planner.edgesSince(edges.length / 2));
      events.push(...planner.eventsSince(events.length / planner.eventWidth));
      assert.equal(vertices.length, planner.vertexCount * planner.dimension);
      assert.equal(edges.length, planner.edgeCount * 2);
      assert.equal(events.length, planner.eventCount * planner.eventWidth);
    }
    assert.deepEqual(vertices.slice(0, 4), [...planner.verticesSince(0).subarray(0, 4)]);
    assert.deepEqual(vertices.slice(0, 4), [0, 0, 2, 0.5]);
    for (const end of edges) assert.ok(end < planner.vertexCount);
    for (let row = 0; row < planner.eventCount; row += 1) {
      const [kind, iteration] = events.slice(row * planner.eventWidth, row * planner.eventWidth + 2);
      assert.ok([0, 1, 2, 3, 4, 5].includes(kind), `kind ${kind}`);
      assert.ok(iteration >= 0 && iteration <= planner.iterations);
    }
  });

  test(`${algorithm}: result, path and stats agree`, () => {
    const planner = finish(Scenario.parse(arm).planner(asOptions({ algorithm, seed: 8, query: "over" })));
    const result = planner.result();
    assert.deepEqual(
      [result.scenario, result.query, result.planner, result.seed, result.status, result.fingerprint],
      ["two-joints", "over", algorithm, 8, "solved", planner.fingerprint()],
    );
    assert.match(result.fingerprint, /^[0-9a-f]{16}$/);
    assert.deepEqual(result.path.flat(), [...planner.path()]);
    assert.ok(result.length > 0);
    const { vertices, edges, iterations, build_seconds, search_seconds } = planner.stats();
    assert.deepEqual([vertices, edges, iterations], [planner.vertexCount, planner.edgeCount, planner.iterations]);
    assert.deepEqual(planner.stats(), result.stats);
    const seconds = build_seconds + search_seconds;
    // A lazy roadmap is searched while it is built.
    assert.ok(build_seconds >= 0 && search_seconds >= 0 && seconds > 0 && seconds < 60);
    if (algorithm === "prm") assert.ok(search_seconds > 0);
    assert.equal(planner.phase, "done");
  });
}

test("a recorded run leaves a row for every iteration, whoever steps it, and is the same run", () => {
  const scenario = Scenario.parse(arm);
  const start = () => scenario.planner({ algorithm: "prm", seed: 4, samples: 200, shortcut: 50 });
  const plain = finish(start());
  const planner = start();
  planner.record();
  planner.record();
  const width = planner.historyWidth;
  assert.deepEqual([width, historyColumns.length, planner.historyCount], [8, 8, 0]);
  /** @type {number[][]} */ const rows = [];
  for (let frame = 0; planner.status === "running"; frame += 1) {
    if (frame % 2 === 0) planner.step(13);
    else planner.stepFor(0.1);
    const added = planner.historySince(rows.length);
    for (let i = 0; i < added.length; i += width) rows.push([...added.subarray(i, i + width)]);
    const { vertices, edges, configuration_checks, motion_checks, clearance_evaluations } = planner.stats();
    const [now] = rows.slice(-1);
    assert.deepEqual(Object.fromEntries(historyColumns.slice(0, 7).map((name, i) => [name, now[i]])), {
      vertices,
      edges,
      events: planner.eventCount,
      phase: phases.indexOf(planner.phase),
      configurationChecks: configuration_checks,
      motionChecks: motion_checks,
      clearanceEvaluations: clearance_evaluations,
    });
  }
  assert.equal(rows.length, planner.iterations);
  assert.deepEqual([planner.fingerprint(), planner.iterations], [plain.fingerprint(), plain.iterations]);
  const seen = rows.map((row) => phases[row[3]]).filter((phase, i, all) => phase !== all[i - 1]);
  assert.deepEqual(seen, ["sampling", "connecting", "searching", "improving", "done"]);
  const costs = rows.map((row) => row[7]);
  const first = costs.findIndex(Number.isFinite);
  assert.ok(costs.slice(0, first).every((cost) => cost === Infinity));
  assert.ok(
    costs.slice(first + 1).every((cost, i) => cost <= costs[first + i]) && costs[costs.length - 1] < costs[first],
  );
  assert.ok(Math.abs(costs[costs.length - 1] - planner.result().length) < 1e-12);
  assert.deepEqual(planner.historySince(0), Float64Array.from(rows.flat()), "rows stay");
  assert.deepEqual(
    [planner.historySince(planner.historyCount).length, plain.historyCount, plain.historySince(0).length],
    [0, 0, 0],
  );
  assert.throws(() => plain.record(), {
    name: "PlanariumError",
    code: "unsupported",
    message: /before the first iteration/,
  });
});

test("rawPath is the path as it was found", () => {
  const scenario = Scenario.parse(disc);
  const plain = finish(scenario.planner({ algorithm: "rrt-connect", seed: 2 }));
  assert.deepEqual(plain.rawPath(), plain.path());
  const planner = scenario.planner({ algorithm: "rrt-connect", seed: 2, shortcut: 100 });
  assert.equal(planner.rawPath().length, 0);
  while (planner.phase !== "improving") planner.step(1);
  assert.deepEqual([planner.rawPath(), planner.path().length], [plain.path(), 0]);
  finish(planner);
  assert.deepEqual(planner.rawPath(), plain.path());
  assert.notDeepEqual(planner.path(), plain.path());
});

test("firstHits takes rows of two ends, more of them than go over at once, and is not counted", () => {
  const planner = Scenario.parse(disc).planner();
  assert.equal(planner.firstHits([]).length, 0);
  const many = Float64Array.from({ length: 4 * 20_000 }, (_, i) => (i % 4 === 3 ? 8 : 2));
  many.set([2, 2, 8, 2], 4 * 19_999);
  const stats = planner.stats();
  const hits = planner.firstHits(many);
  assert.ok(hits.slice(0, -1).every((hit) => hit === 1) && Math.abs(hits[19_999] - 2.5 / 6) < 1e-9);
  assert.deepEqual(planner.stats(), stats);
});

test("events are left out if they are not wanted", () => {
  const planner = finish(Scenario.parse(arm).planner({ algorithm: "prm", seed: 3, events: false }));
  assert.deepEqual([planner.eventCount, planner.eventsSince(0).length], [0, 0]);
  assert.throws(() => Scenario.parse(arm).planner(asOptions({ events: 1 })), {
    code: "wrong-type",
    pointer: "/events",
  });
});

test("stepFor(0) makes one iteration, so that a loop always gets on, and leads to the same result", () => {
  const scenario = Scenario.parse(arm);
  const reach = () => scenario.reach({ target: [1, 0.7], seed: 1 });
  for (const start of [() => scenario.planner({ seed: 11 }), reach, () => new Trajectories({ seed: 3, count: 100 })]) {
    const [one, other] = [start(), start()];
    assert.equal(one.stepFor(0), "running");
    assert.equal(one.iterations, 1);
    while (one.stepFor(0.2) === "running");
    other.step(1e6);
    assert.deepEqual([one.status, one.result().fingerprint], ["solved", other.result().fingerprint]);
  }
});

test("step makes at most n iterations, none at n = 0, and none after the end", () => {
  const planner = Scenario.parse(arm).planner({ algorithm: "prm" });
  for (const [count, made] of [
    [0, 0],
    [100, 100],
    [1, 101],
  ]) {
    assert.equal(planner.step(count), "running");
    assert.equal(planner.iterations, made);
  }
  assert.equal(finish(planner, Number.MAX_SAFE_INTEGER).status, "solved");
  const { iterations } = planner;
  planner.step(10);
  planner.stepFor(1);
  assert.equal(planner.iterations, iterations);
});

test("a budget that runs out ends as exhausted, with an empty path", () => {
  const planner = finish(Scenario.parse(disc).planner({ maxIterations: 3 }));
  assert.equal(planner.status, "exhausted");
  assert.equal(planner.path().length, 0);
  const { path, reason, explanation } = planner.result();
  assert.deepEqual(
    [path, reason, explanation],
    [[], "iteration-limit", "gave up after 3 iterations without a path (max_iterations)"],
  );
  assert.deepEqual([planner.reason, planner.explanation], [reason, explanation]);
  assert.deepEqual(finish(Scenario.parse(disc).planner({})).reason, undefined, "solved");
});

test("stepFor overruns its budget by less than a quarter, whatever an iteration costs", (context) => {
  const planner = Scenario.generate("forest", { seed: 2, links: 4 }).planner({
    algorithm: "prm",
    samples: 3000,
    k: 5,
    maxIterations: 20_000,
  });
  // A clock that runs by iterations made, at a price that changes with the phase.
  const price = (/** @type {string} */ phase) => (phase === "sampling" ? 0.001 : 0.11);
  let clock = 0;
  let seen = 0;
  let phase = planner.phase;
  context.mock.method(performance, "now", () => {
    clock += (planner.iterations - seen) * price(phase);
    seen = planner.iterations;
    phase = planner.phase;
    return clock;
  });
  let frames = 0;
  while (planner.status === "running") {
    const [began, startedIn] = [clock, planner.phase];
    planner.stepFor(8);
    const spent = clock - began;
    frames += 1;
    if (planner.status === "running") assert.ok(spent >= 8, `${spent} ms`);
    // The slice that crosses into a dearer phase may be dearer than any before it.
    const slack = planner.phase === startedIn ? 2 : 64 * 0.11;
    assert.ok(spent <= 8 + slack, `${spent} ms in ${startedIn}`);
  }
  assert.ok(frames > 30, `${frames} frames`);
});

test("planners do not share state", () => {
  const scenario = Scenario.parse(arm);
  const [one, two] = [scenario.planner({ seed: 1 }), scenario.planner({ seed: 1 })];
  for (let i = 0; one.status === "running" || two.status === "running"; i += 1) (i % 3 === 0 ? one : two).step(1);
  assert.equal(one.fingerprint(), two.fingerprint());
  assert.ok(one instanceof Planner);
});

test("a roadmap is kept as text and as bytes, and gone on with: the same path, and the same answers", () => {
  const scenario = Scenario.parse(arm);
  for (const algorithm of ["prm"]) {
    const planner = finish(scenario.planner(asOptions({ algorithm, seed: 3, maxIterations: 20_000 })));
    const [text, bytes] = [planner.roadmap("json"), planner.roadmap("binary")];
    assert.equal(JSON.parse(text).format, "planarium-roadmap-2");
    assert.ok(bytes instanceof Uint8Array && bytes.length < text.length);
    const xml = planner.roadmap("graphml");
    assert.match(xml, /^<\?xml [^]*<graphml [^]*<\/graphml>\n$/);
    const { vertices, edges } = JSON.parse(text);
    const told = (/** @type {RegExp} */ pattern) =>
      Array.from(xml.matchAll(pattern), ([, ...found]) => found.map(Number));
    assert.deepEqual(
      told(/<node id="n\d+"><data key="q0">(.+?)<\/data><data key="q1">(.+?)<\/data><\/node>/g),
      vertices,
    );
    const lines = told(/<edge id="e\d+" source="n(\d+)" target="n(\d+)"><data key="weight">(.+?)<\/data>/g);
    assert.deepEqual(
      lines,
      edges.map((/** @type {[number, number]} */ [a, b]) => [a, b, scenario.distance(vertices[a], vertices[b])]),
    );
    for (const kept of [text, bytes, new Uint8Array(bytes)]) {
      const resumed = finish(scenario.resume(kept, { query: "over", shortcut: 0 }));
      assert.equal(resumed.status, planner.status);
      assert.equal(resumed.result().planner, algorithm);
      assert.deepEqual(resumed.path(), planner.path());
      assert.deepEqual(resumed.verticesSince(0), planner.verticesSince(0));
      assert.deepEqual(resumed.edgesSince(0), planner.edgesSince(0));
      assert.deepEqual(resumed.query([2, 0.5], [-2, 1]).path, planner.query([2, 0.5], [-2, 1]).path);
      assert.equal(resumed.roadmap("json"), text);
    }
  }
});

test("a roadmap is reopened where an obstacle has moved, and only what is wanted is proven again", () => {
  const scenario = Scenario.parse(arm);
  const planner = finish(scenario.planner({ algorithm: "lazy-prm", seed: 3, samples: 300 }));
  assert.equal(finish(planner.reopen(scenario)).stats().motion_checks, 0, "nothing has moved");
  const document = scenario.document();
  const post = {
    type: /** @type {const} */ ("disc"),
    center: /** @type {[number, number]} */ ([-1.2, -1.2]),
    radius: 0.1,
  };
  const world = { ...document.world, obstacles: [...document.world.obstacles, post] };
  const moved = Scenario.parse({ ...document, world });
  const [one, same] = [moved, JSON.stringify(moved)].map((input) => finish(planner.reopen(input)));
  assert.equal(one.fingerprint(), same.fingerprint(), "the same calls give the same bits");
  assert.equal(one.vertexCount, planner.vertexCount);
  assert.ok(one.stats().motion_checks < planner.stats().motion_checks && one.stats().unchecked_edges);
  for (let i = 0, path = one.path(); i + 4 <= path.length; i += 2)
    assert.equal(moved.firstHit(path.subarray(i, i + 2), path.subarray(i + 2, i + 4)), null);
  assert.throws(() => planner.reopen(disc), { code: "other-scenario", pointer: "/robot" });
  assert.throws(() => scenario.planner({ algorithm: "lazy-prm" }).reopen(scenario), { code: "unsupported" });
  assert.throws(() => planner.reopen("{"), { code: "invalid-json" });
});

test("a roadmap that is damaged, belongs elsewhere or is contradicted is refused", () => {
  const scenario = Scenario.parse(arm);
  const planner = finish(scenario.planner({ algorithm: "prm", samples: 30, k: 5 }));
  const bytes = planner.roadmap("binary");
  const damaged = Uint8Array.from(bytes, (byte, i) => (i === 100 ? byte ^ 1 : byte));
  for (const file of [damaged, bytes.subarray(0, 99), new Uint8Array(0), "", planner.roadmap("graphml")]) {
    assert.throws(() => scenario.resume(file), { code: "invalid-roadmap" });
  }
  assert.throws(() => Scenario.parse(disc).resume(bytes), { code: "other-scenario", pointer: "/fingerprint" });
  assert.throws(() => scenario.resume(/** @type {any} */ ([1, 2])), { code: "wrong-type", pointer: "/roadmap" });
  assert.throws(() => planner.roadmap(/** @type {any} */ ("png")), { code: "out-of-range", pointer: "/format" });
  assert.throws(() => scenario.planner().roadmap("json"), { code: "unsupported" });
});

test("growth yields everything once, lets other tasks run in between, and is the same run", async () => {
  const scenario = Scenario.parse(arm);
  const plain = finish(scenario.planner({ algorithm: "prm", seed: 6 }));
  const planner = scenario.planner({ algorithm: "prm", seed: 6 });
  planner.step(5);
  /** @type {number[]} */ const vertices = [];
  /** @type {number[]} */ const edges = [];
  /** @type {number[]} */ const events = [];
  /** @type {string[]} */ const statuses = [];
  let [ticks, isOver] = [0, false];
  const tick = () => {
    ticks += 1;
    if (!isOver) setImmediate(tick);
  };
  setImmediate(tick);
  for await (const growth of planner.growth({ budget: 0.5 })) {
    vertices.push(...growth.vertices);
    edges.push(...growth.edges);
    events.push(...growth.events);
    statuses.push(growth.status);
    assert.equal(growth.iterations, planner.iterations);
  }
  isOver = true;
  assert.deepEqual(
    [vertices, edges, events],
    [[...plain.verticesSince(0)], [...plain.edgesSince(0)], [...plain.eventsSince(0)]],
  );
  assert.equal(planner.fingerprint(), plain.fingerprint());
  assert.deepEqual(
    [statuses[0], statuses.at(-1), statuses.indexOf("solved")],
    ["running", "solved", statuses.length - 1],
  );
  assert.ok(ticks > 1, `${ticks} ticks`);
});

test("growth yields everything once where the loop steps the planner, too", async () => {
  const scenario = Scenario.parse(arm);
  for (const options of /** @type {const} */ ([
    { algorithm: "prm", samples: 400, k: 5 },
    { algorithm: "rrt-connect" },
  ])) {
    const whole = finish(scenario.planner({ ...options, seed: 1 }));
    for (const [before, within] of [
      [0, 1],
      [3, 40],
      [0, 1e6],
    ]) {
      const planner = scenario.planner({ ...options, seed: 1 });
      /** @type {[number[], number[], number[]]} */
      const grown = [[], [], []];
      const stream = planner.growth({ budget: 0 });
      planner.step(before);
      let last = "";
      for await (const { vertices, edges, events, status } of stream) {
        [vertices, edges, events].forEach((rows, i) => grown[i].push(...rows));
        last = status;
        planner.step(within);
      }
      assert.deepEqual(
        grown,
        [[...whole.verticesSince(0)], [...whole.edgesSince(0)], [...whole.eventsSince(0)]],
        `${within}`,
      );
      assert.equal(last, "solved");
    }
  }
});

test("growth ends at break, and the run can be continued; a freed planner has none", async () => {
  const planner = Scenario.parse(arm).planner({ algorithm: "prm", samples: 5000 });
  for await (const { iterations } of planner.growth({ budget: 0 })) if (iterations >= 3) break;
  assert.deepEqual([planner.iterations, planner.status], [3, "running"]);
  for await (const { vertices } of planner.growth()) {
    assert.equal(vertices.length, planner.vertexCount * planner.dimension, "a new loop begins with what there is");
    break;
  }
  for (const [budget, code] of /** @type {const} */ ([
    [NaN, "not-finite"],
    [-1, "out-of-range"],
  ])) {
    assert.throws(() => planner.growth({ budget }), { code, pointer: "/budget" });
  }
  assert.throws(() => planner.growth(/** @type {any} */ ({ buget: 4 })), { code: "unknown-field", pointer: "/buget" });
  assert.throws(() => planner.growth(/** @type {any} */ (4)), { code: "wrong-type" });
  planner.free();
  assert.throws(() => planner.growth(), { code: "freed" });
});

test("solve plans in one call, of a document, a text or a scenario", () => {
  const expected = finish(Scenario.parse(disc).planner({ seed: 4 })).result();
  const scenario = Scenario.parse(disc);
  for (const input of [disc, JSON.stringify(disc), scenario]) {
    const { stats, ...result } = solve(input, { seed: 4 });
    assert.deepEqual(
      { ...result, stats: { ...stats, build_seconds: 0, search_seconds: 0 } },
      { ...expected, stats: { ...expected.stats, build_seconds: 0, search_seconds: 0 } },
    );
  }
  assert.equal(scenario.name, disc.name, "a scenario of the caller is not freed");
  assert.throws(() => solve(disc, { algorithm: "prm", k: -1 }), { code: "out-of-range", pointer: "/k" });
});
