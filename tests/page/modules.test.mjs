/** The page's modules that need no browser. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { documentText } from "../../www/formats/document.js";
import { History } from "../../www/planner/editor/history.js";
import { PathPlayback, playbackOf } from "../../www/planner/stage/path-playback.js";
import { touchingSentence } from "../../www/domain/names.js";
import { comparer, once } from "../../www/app/once.js";
import { connect } from "../../www/app/worker-client.js";
import { coalesced, isAbort, latest } from "../../www/app/work.js";
import { Rows } from "../../www/planner/run-log/rows.js";
import { EVENT, PAST, SIDE } from "../../www/planner/run-log/columns.js";
import { endsOf, load } from "./library.mjs";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { Glow } from "../../www/planner/stage/glow.js";
import { hitsOf } from "../../www/planner/stage/growth.js";
import { handleAhead } from "../../www/draw/placed-handles.js";
import { folded, unrolled } from "../../www/draw/trace.js";
import { Scenario } from "planarium";
import { View, motionCurves } from "planarium/draw";
import { ending, going } from "../../www/planner/story.js";
import { nameAll } from "../../www/planner/race/names.js";
import { leaders, letters } from "../../www/planner/race/standings.js";
import { thinned } from "../../www/planner/run-log/curve.js";
import { compete } from "../../www/planner/worker/compete.js";
import { LocalRun, ended, runOf } from "./runs.mjs";

/** The lines that show one motion. @param {number[]} ends @param {boolean[]} circles @param {boolean[]} [short] */
function linesOf(ends, circles, short = circles) {
  /** @type {number[][]} */
  const lines = [];
  unrolled(ends, 0, circles, short, (...line) => lines.push(line.map((v) => Math.round(v * 1000) / 1000)));
  return lines;
}

test("an edge within the square is one line; one across a border is drawn on both sides; one across a corner on all four", () => {
  const circles = [true, true];
  assert.deepEqual(linesOf([0, 0, 1, 1], circles), [[0, 0, 1, 1]]);
  assert.deepEqual(linesOf([3, 0, -3, 0.5], circles), [
    [3, 0, 3.283, 0.5],
    [-3.283, 0, -3, 0.5],
  ]);
  assert.deepEqual(linesOf([0, -3, 0.5, 3], circles), [
    [0, -3, 0.5, -3.283],
    [0, 3.283, 0.5, 3],
  ]);
  const corner = linesOf([3, 3, -3, -3], circles);
  assert.equal(corner.length, 4);
  assert.deepEqual(corner[3], [-3.283, -3.283, -3, -3]);
  assert.deepEqual(linesOf([3, 0, -3, 0.5], [false, false]), [[3, 0, -3, 0.5]], "a joint with limits does not wrap");
});

test("a motion of the naive metric goes the long way, and is drawn on the square wherever its angles lie", () => {
  const long = linesOf([0.1, 1, 6.2, 1], [true, true], [false, false]);
  assert.deepEqual(long, [
    [0.1, 1, 6.2, 1],
    [-6.183, 1, -0.083, 1],
  ]);
  assert.deepEqual(linesOf([4, 1, 5, 1], [true, true], [false, false]), [[-2.283, 1, -1.283, 1]]);
  assert.deepEqual(
    [folded(4), folded(-1), folded(Math.PI)].map((v) => Math.round(v * 1000) / 1000),
    [-2.283, -1, 3.142],
  );
  const { points, firsts } = motionCurves(load("stones"), Float64Array.from([0.1, 0, 6.2, 0]), [false, false]);
  const left = points
    .filter((_, i) => i % 2 === 0)
    .slice(0, firsts[1])
    .reduce((least, x) => Math.min(least, x));
  assert.ok(left < -0.5, "the end-effector goes all the way round");
});

test("traced curves end where the core says, and follow its interpolation", () => {
  const scenario = load("thicket");
  const [start, goal] = endsOf(scenario.document().queries[0]);
  const { points, firsts } = motionCurves(scenario, Float64Array.from([...start, ...goal, ...goal, ...start]));
  assert.deepEqual([...points.slice(0, 2)], [...scenario.endEffector(start)]);
  const last = firsts[1] - 1;
  for (let i = 0; i <= last; i++) {
    const [x, y] = scenario.endEffector(scenario.interpolate(start, goal, i / last));
    assert.ok(Math.hypot(points[2 * i] - x, points[2 * i + 1] - y) < 1e-9, `point ${i}`);
  }
  assert.equal(firsts[2], 2 * firsts[1]);
});

test("a handle lies ahead, and within the canvas at any border", () => {
  const view = new View({ min: [0, 0], max: [10, 10] }, 300, 200);
  const [x, y] = view.place([5, 5]);
  assert.deepEqual(handleAhead(view, [5, 5, 0], 30), [x + 30, y]);
  for (const [px, py] of [
    [0, 0],
    [10, 0],
    [5, 10],
    [0, 10],
    [10, 10],
  ])
    for (let theta = -3; theta < 3.2; theta += 0.25) {
      const [fromX, fromY] = view.place([px, py]);
      const [hx, hy] = handleAhead(view, [px, py, theta], 400);
      assert.ok(hx > 7.9 && hx < 292.1 && hy > 7.9 && hy < 192.1, `${[px, py, theta]}: ${[hx, hy]}`);
      assert.ok(Math.hypot(hx - fromX, hy - fromY) > 5, "apart from the place itself");
      assert.ok(Math.abs(Math.atan2(fromY - hy, hx - fromX) - theta) < 1e-9, "in the direction");
    }
});

test("rows grow and keep what they hold", () => {
  const rows = new Rows((n) => new Uint32Array(n), 2);
  for (let i = 0; i < 3000; i++) rows.add([i, i + 1]);
  rows.add(Uint32Array.from({ length: 20_000 }, (_, i) => i));
  assert.equal(rows.count, 13_000);
  assert.deepEqual([...rows.row(2999)], [2999, 3000]);
  assert.deepEqual([...rows.slice(3000, 3002)], [0, 1, 2, 3]);
});

/** Plans up to an iteration and shows it. @param {LocalRun} run @param {number} iteration */
function toward(run, iteration) {
  const there = run.advance(-1, iteration);
  run.shown = run.made;
  return there;
}

test("a run fetched in slices holds what the planner holds, and every tree vertex hangs from a root", () => {
  for (const { id, algorithm, settings } of SCENES) {
    const scenario = load(id);
    const run = new LocalRun(scenario, algorithm, settings);
    while (!run.ended) toward(run, run.made + 7);
    assert.deepEqual(run.vertices.slice(0, run.vertices.count), run.stepper.planner.verticesSince(0));
    assert.deepEqual(run.edges.slice(0, run.edges.count), run.stepper.planner.edgesSince(0));
    const sides = new Set(run.sides.slice(0, run.sides.count));
    const roots = { roadmap: [SIDE.none], tree: [SIDE.start], trees: [SIDE.start, SIDE.goal] };
    assert.deepEqual(sides, new Set(roots[run.kind]), id);
    if (algorithm === "prm") assert.ok(run.events.count > 0);
    run.free();
    scenario.free();
  }
});

test("the goal of a lone tree hangs from the start once it is reached, and from nothing before", () => {
  const { run } = runOf("firs", "rrt", { seed: 7, max_iterations: 300 });
  assert.equal(run.status, "exhausted");
  assert.equal(run.sides.data[1], SIDE.none);
  const { run: reached } = runOf("firs", "rrt", { step: 0.35, seed: 7 });
  assert.equal(reached.status, "solved");
  assert.deepEqual(new Set(reached.sides.slice(0, reached.sides.count)), new Set([SIDE.start]));
});

test("guards differ from links", () => {
  const { run } = runOf("stones", "visibility-prm", {});
  assert.ok(run.countOf(EVENT.guard) >= 2 && run.countOf(EVENT.guard) < run.vertices.count);
});

test("each iteration leaves a row of counts: what it showed can be shown again", () => {
  const { run } = runOf("stones", "prm", { samples: 60, k: 5, seed: 3 });
  const fresh = new LocalRun(load("stones"), "prm", { samples: 60, k: 5, seed: 3 });
  for (let i = 0; i <= run.made; i++) {
    run.shown = i;
    assert.equal(toward(fresh, i), true);
    assert.deepEqual(run.past, fresh.past, `iteration ${i}`);
    assert.deepEqual([run.phase, run.status], [fresh.phase, fresh.status]);
    assert.deepEqual([fresh.vertices.count, fresh.edges.count, fresh.events.count], [...run.past.slice(0, 3)]);
  }
  const { data, width } = run.history;
  for (const evaluations of [0, 1, 37, 1000, Infinity]) {
    const i = run.iterationAt(PAST.clearanceEvaluations, evaluations);
    assert.ok(data[i * width + PAST.clearanceEvaluations] <= evaluations);
    assert.ok(i === run.made || data[(i + 1) * width + PAST.clearanceEvaluations] > evaluations);
  }
});

test("a sampled path is followed to where it collides; a proven one has no such place, nor has one that only looks unproven", () => {
  const sampled = runOf("stones", "prm", { samples: 260, k: 9, edge_check: "sampled", edge_samples: 1 });
  const playback = playbackOf(sampled.scenario, sampled.run);
  assert.ok(playback?.flaw && !playback.isProven);
  const { at, pose, check } = playback.flaw;
  assert.equal(sampled.scenario.check(pose).free, false);
  assert.ok(sampled.scenario.distance(playback.configuration(at), pose) < 1e-9);
  for (let part = 0; part < at - 0.002; part += 0.001)
    assert.ok(sampled.scenario.check(playback.configuration(part)).free, `${part}`);
  assert.equal(
    ending(sampled.run, playback),
    `Path found, but not verified: ${touchingSentence(sampled.scenario, check).replaceAll("touches", "hits")} on the way. To fix it, set “Collision checking” to proven.`,
  );
  const careful = runOf("stones", "prm", { samples: 260, k: 9, edge_check: "sampled", edge_samples: 400 });
  const free = playbackOf(careful.scenario, careful.run);
  assert.ok(free && free.flaw === null && !free.isProven);
  assert.match(ending(careful.run, free), /not proven. A check afterwards found no collision.$/);
  const proven = runOf("stones", "prm", { samples: 260, k: 9 });
  assert.ok(playbackOf(proven.scenario, proven.run)?.isProven);
  assert.match(ending(proven.run, playbackOf(proven.scenario, proven.run)), /proven to be collision-free/);
});

test("a tree that gave up shows its nearest miss; others have none to show", () => {
  const { scenario, run } = runOf("firs", "rrt", { step: 0.35, seed: 7, max_iterations: 300 });
  const playback = playbackOf(scenario, run);
  assert.ok(playback?.isMiss && playback.isProven);
  const [start, goal] = endsOf(scenario.document().queries[0]);
  assert.ok(scenario.distance(playback.configuration(0), start) < 1e-12);
  const short = scenario.distance(playback.configuration(1), goal);
  assert.ok(short > 0.1);
  assert.equal(
    ending(run, playback),
    `Gave up after 300 iterations without a path (max_iterations). The closest approach, dashed, ends ${short.toFixed(2)} rad from the goal.`,
  );
  for (const algorithm of ["prm", "rrt-connect"]) {
    const other = runOf("firs", algorithm, { max_iterations: 3 });
    assert.equal(playbackOf(other.scenario, other.run), null);
    assert.match(
      ending(other.run, null),
      algorithm === "prm"
        ? /after 3 iterations without a path \(max_iterations\), before the roadmap was searched/
        : /two trees never met/,
    );
  }
});

test("the length in the sentence is the run's, in its metric", () => {
  const { scenario, run } = runOf("stones", "prm", { samples: 260, k: 9, metric: "euclidean" });
  const { length } = run.result;
  const playback = playbackOf(scenario, run);
  assert.ok(playback && Math.abs(playback.length - length) > 0.1, "the playback is measured otherwise");
  assert.ok(ending(run, playback).includes(`${length.toFixed(2)} rad`));
});

test("each phase has its sentence; the scene's sentence appears for its planner only", () => {
  const scene = { algorithm: "prm", isProven: true, sentence: "The scene's own." };
  const sentences = new Set();
  for (const [algorithm, settings] of /** @type {[string, import("../../www/domain/types.js").Settings][]} */ ([
    ["prm-star", { samples: 60, shortcut: 5 }],
    ["visibility-prm", {}],
    ["rrt", { step: 0.5 }],
    ["rrt-connect", { step: 0.5 }],
  ])) {
    const run = new LocalRun(load("stones"), algorithm, settings);
    while (run.status === "running") {
      sentences.add(going(run, scene));
      toward(run, run.made + 1);
    }
  }
  assert.equal(sentences.size, 10, [...sentences].join("\n"));
  assert.ok(!sentences.has(scene.sentence));
  /** @param {import("../../www/domain/types.js").Settings} settings */
  const connecting = (settings) => {
    const run = new LocalRun(load("stones"), "prm", { samples: 30, ...settings });
    assert.match(
      going(run, scene),
      /^Looking for a path from start to goal\. Each dot/,
      "what is looked for comes first",
    );
    while (run.phase === "sampling") toward(run, run.made + 1);
    return run;
  };
  assert.equal(going(connecting({}), scene), scene.sentence);
  assert.doesNotMatch(
    going(connecting({ edge_check: "sampled" }), {
      algorithm: "prm",
      isProven: true,
      sentence: "Each line is proven.",
    }),
    /proven/,
  );
});

test("a sample that was free but of no use flashes fainter than one in collision", () => {
  /** @type {number[]} */
  const inked = [];
  const context = /** @type {any} */ ({
    globalAlpha: 1,
    stroke() {
      inked.push(this.globalAlpha);
    },
  });
  for (const name of ["save", "restore", "setLineDash", "beginPath", "moveTo", "lineTo"]) context[name] = () => {};
  const glow = new Glow();
  glow.add("rejected", 0, Float64Array.from([1, 2]));
  glow.add("discarded", 0, Float64Array.from([3, 4]));
  glow.draw(context, /** @type {any} */ ({}), 10);
  assert.equal(inked.length, 2);
  assert.ok(inked[0] > 0.2 && inked[0] < inked[1] / 2);
});

test("advance makes exactly as many iterations as it is asked for, and stops at the clock", () => {
  const run = new LocalRun(load("stones"), "prm", { samples: 400 });
  assert.equal(toward(run, 137), true);
  assert.equal(run.made, 137);
  assert.equal(run.advance(-1, Infinity, performance.now() - 1), false);
  assert.equal(run.made, 137);
});

test("a playback runs from start to goal at constant speed, rests, and comes back", () => {
  const scenario = load("stones");
  const planner = scenario.planner({ algorithm: "rrt-connect", seed: 1 });
  while (planner.step(100) === "running");
  const playback = new PathPlayback(scenario, planner.path());
  const [start, goal] = endsOf(scenario.document().queries[0]);
  assert.ok(Math.abs(playback.length - planner.result().length) < 1e-9);
  assert.ok(scenario.distance(playback.configuration(0), start) < 1e-12);
  assert.ok(scenario.distance(playback.configuration(1), goal) < 1e-12);
  const steps = 200;
  for (let i = 0; i < steps; i++) {
    const moved = scenario.distance(playback.configuration(i / steps), playback.configuration((i + 1) / steps));
    assert.ok(moved <= playback.length / steps + 1e-9, "no jump");
    assert.ok(scenario.check(playback.configuration(i / steps)).free, "the drawn robot is where the proof is");
  }
  for (let i = 0; i < 100 && playback.drawn < 1; i++) playback.advance(0.1);
  assert.ok(playback.at === 0, "it waits until the line is drawn");
  /** @type {number[]} */
  const ends = [];
  for (let t = 0; t < 2 * playback.duration + 3; t += 0.02) {
    playback.advance(0.02);
    if (Number.isInteger(playback.at) && ends.at(-1) !== playback.at) ends.push(playback.at);
  }
  assert.deepEqual(ends, [1, 0]);
});

test("a collision says what touches what", () => {
  const scenario = load("stones");
  assert.equal(
    touchingSentence(scenario, {
      free: false,
      touching: [
        { part: 1, obstacle: 3 },
        { part: 0, obstacle: "bounds" },
      ],
    }),
    "link 2 touches obstacle 3, link 1 leaves the bounds",
  );
});

test("what is fetched once is fetched once; those who wait go on in their order; what failed is fetched again", async () => {
  let calls = 0;
  const get = once(async () => {
    await Promise.resolve();
    if (++calls === 1) throw new Error("not yet");
    return calls;
  });
  await assert.rejects(get(), /not yet/);
  /** @type {number[]} */
  const order = [];
  await Promise.all(
    [1, 2, 3].map(async (who) => {
      order.push(who + 10 * (await get()));
    }),
  );
  assert.deepEqual(order, [21, 22, 23]);
  assert.equal(calls, 2);
});

test("values are compared with the previous call, by name", () => {
  const differs = comparer();
  const list = [NaN];
  assert.deepEqual(
    [differs("a", 1, list), differs("a", 1, list), differs("b", 1, list), differs("a", 1, [NaN]), differs("b", 1)],
    [true, false, true, true, true],
  );
});

test("newer work aborts older work, which a worker does not begin; of calls meanwhile one follows", async () => {
  /** @type {{ id: number, command?: string, args?: unknown[], isAborted?: boolean }[]} */
  const sent = [];
  /** @type {(event: { data: object }) => void} */
  let reply = () => {};
  const worker = {
    postMessage: (/** @type {typeof sent[number]} */ message) => sent.push(message),
    addEventListener: (/** @type {string} */ type, /** @type {typeof reply} */ listen) => {
      if (type === "message") reply = listen;
    },
  };
  /** @type {unknown[]} */
  const errors = [];
  const remote = /** @type {import("../../www/app/worker-client.js").Remote<{ double: (count: number) => number }>} */ (
    connect(
      /** @type {Worker} */ (/** @type {unknown} */ (worker)),
      "room",
      /** @type {WebAssembly.Module} */ ({}),
      (error) => errors.push(error.message),
    )
  );
  await new Promise((resolve) => setTimeout(resolve));
  reply({ data: { id: 0, value: null } });
  const double = latest((signal, /** @type {number} */ count) => remote.double(count, signal));
  const older = double(1);
  await new Promise((resolve) => setTimeout(resolve));
  const newer = double(2);
  await assert.rejects(older, isAbort);
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(sent.slice(1), [
    { id: 1, room: "room", command: "double", args: [1] },
    { id: 1, isAborted: true },
    { id: 2, room: "room", command: "double", args: [2] },
  ]);
  // A reply that nobody awaits is dropped; but the loss of the core is reported.
  reply({ data: { id: 1, value: 2 } });
  reply({ data: { id: 1, fault: { message: "lost", code: "internal", pointer: "" } } });
  reply({ data: { id: 2, value: 4 } });
  assert.equal(await newer, 4);
  assert.deepEqual(errors, ["lost"]);
  const given = double(3);
  double.cancel();
  await assert.rejects(given, isAbort);

  let done = 0;
  const work = coalesced(async () => {
    await Promise.resolve();
    done++;
  });
  await Promise.all([work(), work(), work()]);
  assert.equal(done, 2);
  await work();
  assert.equal(done, 3);
});

test("a worker begins its messages in their order, but none that was taken back meanwhile", async () => {
  /** @type {unknown[]} */
  const replies = [];
  /** @type {(event: { data: object }) => void} */
  let receive = () => {};
  Object.assign(globalThis, {
    self: { postMessage: (/** @type {unknown} */ reply) => replies.push(reply) },
    addEventListener: (/** @type {string} */ _type, /** @type {typeof receive} */ listen) => {
      receive = listen;
    },
    ImageBitmap: class {},
    // Its ports do not keep this process alive.
    MessageChannel: class extends MessageChannel {
      constructor() {
        super();
        queueMicrotask(() => /** @type {any} */ (this.port1).unref());
      }
    },
  });
  const { serve } = await import("../../www/app/worker-server.js");
  serve({ room: { commands: { double: (/** @type {number} */ count) => 2 * count } } });
  for (const id of [1, 2, 3]) receive({ data: { id, room: "room", command: "double", args: [id] } });
  receive({ data: { id: 2, isAborted: true } });
  while (replies.length < 2) await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(replies, [
    { id: 1, value: 2 },
    { id: 3, value: 6 },
  ]);
});

test("a history of edits goes back and on, forgets what was undone, and keeps two hundred edits", () => {
  const documents = Array.from(
    { length: 260 },
    (_, i) => /** @type {import("../../www/domain/types.js").ScenarioDocument} */ ({ name: String(i) }),
  );
  const edits = new History(documents[0]);
  for (const document of documents.slice(1)) edits.commit(document);
  assert.equal(edits.undoable, 200);
  for (let i = 0; i < 200; i++) assert.ok(edits.go(-1));
  assert.equal(edits.now, documents[59]);
  assert.ok(!edits.go(-1));
  assert.equal(edits.redoable, 200);
  edits.commit(documents[0]);
  assert.equal(edits.redoable, 0);
  assert.ok(!edits.go(1));
  edits.commit(documents[7], true);
  assert.equal(edits.undoable, 1, "what goes on is one edit with what it goes on from");
  assert.equal(edits.now, documents[7]);
});

test("a document is written with its rows of numbers in a line each", () => {
  const text = documentText({
    title: "a, [1,\n 2]",
    vertices: [
      [0, 1],
      [0.5, -1e-7],
    ],
    list: [{ empty: [] }],
    none: {},
  });
  assert.deepEqual(JSON.parse(text), {
    title: "a, [1,\n 2]",
    vertices: [
      [0, 1],
      [0.5, -1e-7],
    ],
    list: [{ empty: [] }],
    none: {},
  });
  assert.match(text, /^ {2}"vertices": \[\[0, 1\], \[0.5, -1e-7\]\],$/m);
});

test("whoever is behind goes next: a frame that is too short leaves all nearly level, however many frames it takes", () => {
  const scenario = load("rings");
  const runs = [
    ["prm", { samples: 900 }],
    ["rrt", { goal_bias: 0 }],
    ["rrt-connect", {}],
    ["prm-star", { samples: 300, edge_check: "sampled" }],
  ].map(
    ([algorithm, given]) => new LocalRun(scenario, String(algorithm), { .../** @type {object} */ (given), seed: 3 }),
  );
  let frames = 0;
  /** The most that an iteration took so far, and how many of each run were looked at. */
  let dearest = 0;
  const seen = runs.map(() => 0);
  while (
    !compete(
      runs.map(({ stepper }) => stepper),
      PAST.clearanceEvaluations,
      Infinity,
      performance.now() + 0.5,
    )
  ) {
    frames++;
    for (const run of runs) run.fetch();
    const going = runs.filter(({ ended }) => !ended).map((run) => run.clock(PAST.clearanceEvaluations));
    for (const [i, { history }] of runs.entries())
      for (; seen[i] < history.count - 1; seen[i]++) {
        const at = seen[i] * history.width + PAST.clearanceEvaluations;
        dearest = Math.max(dearest, history.data[at + history.width] - history.data[at]);
      }
    assert.ok(Math.max(...going) - Math.min(...going) <= 1000 + 64 * dearest, `${going}`);
    assert.ok(frames < 100_000);
  }
  assert.ok(frames > 3, `${frames} frames`);
  assert.ok(runs.every(({ stepper }) => stepper.ended));
});

test("lengths in different metrics are not compared; a tie is one; a path alone is not the shortest", () => {
  assert.deepEqual([[0], [0, 2], [0, 1, 2]].map(letters), ["A", "A and C", "A, B and C"]);
  const one = { isOver: true, found: 10, cost: 5, metric: "sum", isCost: false, collides: false };
  assert.deepEqual(leaders([one, { ...one, cost: 4, metric: "euclidean" }]), {
    first: [0, 1],
    shortest: [],
    isOver: true,
    isAlike: false,
  });
  assert.deepEqual(
    leaders([one, { ...one, found: 9, cost: 6 }, { ...one, isOver: false, found: null, cost: Infinity }]),
    { first: [1], shortest: [0], isOver: false, isAlike: true },
  );
  assert.deepEqual(leaders([one, { ...one, found: null, cost: Infinity }]).shortest, []);
  const collides = { ...one, found: 1, cost: 1, collides: true };
  assert.deepEqual(leaders([collides, one, { ...one, found: 19, cost: 4 }]), {
    first: [1],
    shortest: [2],
    isOver: true,
    isAlike: true,
  });
  assert.deepEqual(
    nameAll(
      [
        { algorithm: "prm", settings: { seed: 0 } },
        { algorithm: "rrt", settings: { seed: 2 } },
      ],
      (id) => id,
    ),
    ["A prm, seed 0", "B rrt, seed 2"],
  );
});

test("a path with blends is played round its corners, and the story tells how many there are", () => {
  const { scenario, run } = runOf("stones", "rrt-connect", { seed: 0, shortcut: 10, blend: 0.5 });
  const playback = playbackOf(scenario, run);
  const { length, blended_length: blended = NaN, blends = [] } = run.result;
  assert.ok(
    playback && blended < length && Math.abs(playback.length - blended) < 1e-3 * length,
    `${playback?.length}, ${blended} of ${length}`,
  );
  const rounded = blends.filter(([before]) => before > 0).length;
  assert.match(
    ending(run, playback),
    new RegExp(`, ${rounded} of ${blends.length} corners rounded: ${blended.toFixed(2)} rad, proven`),
  );
});

test("thinning keeps the first path and the end, rises, and costs no more for a long run", () => {
  const run = ended(new LocalRun(load("stones"), "prm", { samples: 5000, k: 9, seed: 0, shortcut: 200 }));
  for (const column of [-1, PAST.clearanceEvaluations]) {
    const head = run.clock(column);
    const [rows] = thinned([run], column, head);
    const times = Array.from({ length: rows.length / 3 }, (_, i) => rows[3 * i]);
    assert.ok(times.length <= 300 && times.length > 200, `${times.length} points of ${run.made}`);
    assert.ok(
      times.every((at, i) => i === 0 || at > times[i - 1]),
      "times rise",
    );
    assert.deepEqual([times[0], times[times.length - 1]], [0, head]);
    const found = run.foundBy(run.made);
    assert.ok(times.includes(run.clockAt(column, found)), "the first path is there");
    const costs = times.map((_, i) => rows[3 * i + 2]);
    assert.equal(
      costs.filter((cost) => cost < Infinity)[0],
      run.history.row(run.iterationAt(column, run.clockAt(column, found)))[PAST.length],
    );
    assert.equal(costs[costs.length - 1], run.history.row(run.made)[PAST.length]);
  }
});

test("a rejected motion that ends outside the bounds is drawn whole, and the others up to where they hit", () => {
  /** @type {[number, number][]} */
  const vertices = [
    [5, 0],
    [6, 4],
    [5, 4],
  ];
  const scenario = Scenario.parse({
    format: "planarium-scenario-1",
    name: "wall",
    world: {
      bounds: { min: [0, 0], max: [10, 10] },
      obstacles: [{ type: "polygon", vertices }],
    },
    robot: { type: "disc", radius: 0 },
    queries: [{ name: "round", start: [1, 1], goal: [9, 1] }],
  });
  const planner = scenario.planner({ seed: 1 });
  const [inside, outside] = [
    [1, 1, 9, 1],
    [1, 1, 1, 11],
  ];
  const [part] = planner.firstHits(inside);
  assert.ok(part < 1);
  const hits = hitsOf(planner, Float64Array.of(...inside, ...outside, ...inside), 4);
  assert.deepEqual([...hits], [part, 1, part]);
  assert.throws(() => hitsOf(planner, Float64Array.of(1, 1, NaN, 1), 4), { code: "not-finite" });
});
