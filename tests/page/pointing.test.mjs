/**
 * What the worker tells of a run's log: who waits for the search, who hangs from whom, which vertex a pointer is at.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { NEAR, VertexIndex } from "../../www/planner/stage/vertex-index.js";
import { Snapshots } from "../../www/draw/snapshots.js";
import { drawInformed } from "../../www/planner/stage/informed.js";
import { EVENT, PAST } from "../../www/planner/run-log/columns.js";
import { runOf } from "./runs.mjs";
import { seeded } from "./seeded.mjs";

/**
 * Who waits, computed the slow way: from the whole log up to the iteration.
 * @param {import("./runs.mjs").LocalRun} run
 * @param {number[]} roots
 */
function waitingOf(run, roots) {
  const { past } = run;
  const reached = new Set(roots);
  const expanded = new Set();
  for (let i = 0; i < past[PAST.events]; i++) {
    const [kind, , vertex] = run.events.row(i);
    if (kind !== EVENT.expanded) continue;
    expanded.add(vertex);
    for (let e = 0; e < past[PAST.edges]; e++) {
      const [a, b] = run.edges.row(e);
      if (a === vertex) reached.add(b);
      if (b === vertex) reached.add(a);
    }
  }
  return [...reached].filter((vertex) => !expanded.has(vertex)).sort((a, b) => a - b);
}

for (const search of ["a-star", "dijkstra", "breadth-first", "bidirectional"]) {
  test(`the frontier of ${search} is what is reached and not expanded, forth and back`, () => {
    const { run } = runOf("stones", "prm", { samples: 160, k: 7, seed: 3, search });
    const searching = [];
    for (run.shown = 0; run.shown < run.made; run.shown++) if (run.phase === "searching") searching.push(run.shown);
    assert.ok(searching.length > 10);
    const [first, last] = [searching[0], searching[searching.length - 1]];
    for (const shown of [first, first + 1, last, first + 5, Math.round((first + last) / 2), last, first]) {
      run.shown = shown;
      run.frontier.follow();
      /** @type {number[]} */
      const waiting = [];
      run.frontier.each((vertex) => waiting.push(vertex));
      assert.deepEqual(waiting, waitingOf(run, search === "bidirectional" ? [0, 1] : [0]), `iteration ${shown}`);
      assert.equal(run.frontier.count, waiting.length);
    }
    run.shown = first - 1;
    run.frontier.follow();
    assert.equal(run.frontier.count, 0, "nobody waits before the search");
    run.shown = run.made;
    run.frontier.follow();
    assert.equal(run.frontier.count, 0, "nor after it");
    run.free();
  });
}

test("in a tree the cost from the root is the length of the way down the parents, in the metric of the run", () => {
  for (const metric of ["sum", "euclidean"]) {
    const { run } = runOf("firs", "rrt", { step: 0.3, seed: 4, metric, max_iterations: 20_000 });
    run.shown = run.made;
    assert.equal(run.status, "solved");
    run.adjacency.follow();
    const cost = run.adjacency.cost(1, run.edges.count);
    assert.ok(Math.abs(cost - run.result.length) < 1e-9, `${cost} and ${run.result.length}`);
    let [way, vertex] = [0, 1];
    for (
      let parent = run.adjacency.parent(1, run.edges.count);
      parent >= 0;
      parent = run.adjacency.parent(vertex, run.edges.count)
    ) {
      way += run.adjacency.distance(parent, vertex);
      vertex = parent;
    }
    assert.equal(vertex, 0);
    assert.ok(Math.abs(way - cost) < 1e-9);
    assert.equal(run.adjacency.parent(1, run.edges.count - 1), -1, "before its edge is there it has no parent");
    run.free();
  }
});

test("in a tree that is rewired an edge is there until another one leads to its end", () => {
  const { run } = runOf("firs", "rrt-star", { step: 0.3, seed: 4, near: "k-nearest", improve_iterations: 300 });
  run.shown = run.made;
  run.adjacency.follow();
  const { data, count } = run.edges;
  assert.ok(run.countOf(EVENT.rewired) > 20);
  assert.ok(Math.abs(run.adjacency.cost(1, count) - run.result.length) < 1e-9);
  for (const edges of [count, Math.floor(count / 2), Math.floor(count / 3)]) {
    /** @type {Map<number, number>} */
    const last = new Map();
    for (let e = 0; e < edges; e++) last.set(data[2 * e + 1], e);
    for (let e = 0; e < edges; e++) {
      assert.equal(run.isEdgeThere(e, { edges, events: run.events.count }), last.get(data[2 * e + 1]) === e);
      assert.equal(run.adjacency.edgeTo(data[2 * e + 1], edges), last.get(data[2 * e + 1]));
    }
  }
  run.free();
});

for (const algorithm of ["informed-rrt-star", "aorrtc"]) {
  test(`the best edges of ${algorithm} are its best path at any iteration, and its ellipse is as long`, () => {
    const { run } = runOf("museum", algorithm, { seed: 1, improve_iterations: 700 });
    const [start, goal] = [0, 1].map((vertex) => Array.from(run.vertices.row(vertex)));
    for (let part = 1; part <= 16; part++) {
      run.shown = Math.floor((run.made * part) / 16);
      const cost = run.past[PAST.length];
      const edges = run.bestEdges;
      assert.equal(edges.length > 0, cost < Infinity);
      assert.ok(edges.every((edge) => run.isEdgeThere(edge)));
      if (cost === Infinity) continue;
      assert.ok(Math.abs(edges.reduce((sum, edge) => sum + run.lengthOf(edge), 0) - cost) < 1e-9);
      /** @type {number[]} */
      const drawn = [];
      const context = {
        save() {},
        restore() {},
        beginPath() {},
        stroke() {},
        setLineDash() {},
        ellipse: (/** @type {number[]} */ ...numbers) => drawn.push(...numbers),
      };
      const view = { x: (/** @type {number} */ x) => 100 * x, y: (/** @type {number} */ y) => -100 * y, scaleX: 100 };
      drawInformed(
        /** @type {never} */ (context),
        /** @type {never} */ (view),
        /** @type {never} */ ({ run, scenario: run.scenario, shown: { start, goal } }),
        "",
      );
      const [x, y, along, across, turn] = drawn;
      for (let angle = 0; angle < 6; angle++) {
        const [a, b] = [along * Math.cos(angle), across * Math.sin(angle)];
        const [px, py] = [x + a * Math.cos(turn) - b * Math.sin(turn), y + a * Math.sin(turn) + b * Math.cos(turn)];
        const way = [start, goal].reduce((sum, [qx, qy]) => sum + Math.hypot(px / 100 - qx, -py / 100 - qy), 0);
        assert.ok(Math.abs(way - cost) < 1e-9, `${way} ${cost}`);
      }
    }
    run.free();
  });
}

test("the nearest of 20,000 vertices is that of the slow way", () => {
  const { next: random } = seeded(7);
  const points = Float64Array.from({ length: 40_000 }, () => 700 * random() - 20);
  const pane = { pixels: (/** @type {Float64Array} */ rows) => rows };
  const run = {
    vertices: {
      count: 20_000,
      slice: (/** @type {number} */ first, /** @type {number} */ end) => points.subarray(2 * first, 2 * end),
    },
  };
  const places = new VertexIndex(/** @type {never} */ (pane), /** @type {never} */ (run));
  places.nearest(0, 0, 1);
  let found = 0;
  for (let i = 0; i < 300; i++) {
    const [x, y, count] = [660 * random(), 660 * random(), i % 3 === 0 ? 60 : 20_000];
    let [best, least] = [-1, NEAR];
    for (let v = 0; v < count; v++) {
      const distance = Math.hypot(points[2 * v] - x, points[2 * v + 1] - y);
      if (distance < least) [best, least] = [v, distance];
    }
    assert.equal(places.nearest(x, y, count), best);
    if (best >= 0) found++;
  }
  assert.ok(found > 200 && found < 300, `${found} found`);
});

test("copies of a layer stay few, and the nearest one before a time is put back", () => {
  /** @type {(object | null)[]} */
  const pasted = [];
  const layer = {
    canvas: { width: 500, height: 500 },
    paste: (/** @type {object | null} */ copy) => pasted.push(copy),
  };
  const before = globalThis.OffscreenCanvas;
  globalThis.OffscreenCanvas = /** @type {never} */ (
    class {
      getContext() {
        return { drawImage() {} };
      }
    }
  );
  try {
    const keeps = new Snapshots(/** @type {never} */ (layer));
    for (let count = 100; count <= 100_000; count += 100) if (keeps.isDue(count)) keeps.copy(count);
    assert.ok(keeps.copies.length >= 4 && keeps.copies.length <= 8, `${keeps.copies.length} copies`);
    const counts = keeps.copies.map(({ count }) => count);
    assert.deepEqual(
      counts,
      counts.toSorted((a, b) => a - b),
    );
    assert.equal(keeps.restore(counts[2] + 1), counts[2]);
    assert.equal(keeps.restore(counts[0] - 1), 0);
    assert.deepEqual(pasted, [keeps.copies[2].canvas, null]);
  } finally {
    globalThis.OffscreenCanvas = before;
  }
});
