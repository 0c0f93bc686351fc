/** `planarium/draw`: what it draws, with a context that records it. */
import assert from "node:assert/strict";
import { copyFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { Scenario, eventKinds } from "planarium";
import {
  View,
  blendedPath,
  defaultColours,
  difference,
  drawEdges,
  drawPath,
  drawRobot,
  drawWorld,
  motionCurves,
  wrap,
} from "planarium/draw";
import { root } from "../../scripts/run.mjs";
import { recordingContext } from "./canvas.mjs";
import { emptyFolder } from "./packed.mjs";

/** @import { ScenarioDocument } from "planarium" */
/** @import { Drawn } from "./canvas.mjs" */

const NO_MARGIN = { left: 0, right: 0, top: 0, bottom: 0 };

/** @type {ScenarioDocument} */
const WALL = {
  format: "planarium-scenario-1",
  name: "wall",
  world: {
    bounds: { min: [0, 0], max: [10, 10] },
    obstacles: [
      {
        type: "polygon",
        vertices: [
          [4, 0],
          [5, 0],
          [5, 8],
          [4, 8],
        ],
      },
      { type: "disc", center: [7.5, 6], radius: 1.2 },
    ],
  },
  robot: { type: "disc", radius: 0.3 },
  queries: [{ name: "across", start: [2, 2], goal: [8, 2] }],
};

/** The points of the recorded paths, from each `moveTo` on. @param {Drawn[]} drawn @returns {number[][][]} */
function linesOf(drawn) {
  /** @type {number[][][]} */
  const lines = [];
  for (const { path } of drawn) {
    for (const { call, numbers } of path) {
      if (call === "moveTo") lines.push([]);
      lines.at(-1)?.push(numbers);
    }
  }
  return lines;
}

/** @param {readonly number[][]} found @param {readonly number[][]} expected */
function assertNear(found, expected) {
  assert.equal(found.length, expected.length);
  found.forEach(([x, y], i) =>
    assert.ok(Math.hypot(x - expected[i][0], y - expected[i][1]) < 1e-6, `${[x, y]} at ${i}, not ${expected[i]}`),
  );
}

test("it needs no other file, so that importing it loads no core", async () => {
  const alone = join(emptyFolder(), "draw.mjs");
  copyFileSync(join(root, "dist", "package", "draw.js"), alone);
  assert.deepEqual((await import(pathToFileURL(alone).href)).defaultColours, defaultColours);
});

test("a view fits a box to a canvas, y up, and back", () => {
  const view = new View({ min: [-1, 0], max: [1, 1] }, 400, 400, NO_MARGIN);
  assert.deepEqual(
    [view.scaleX, view.scaleY, view.place([0, 0.5]), view.place([-1, 0])],
    [200, 200, [200, 200], [0, 300]],
  );
  assert.deepEqual(view.toPlane(0, 300), [-1, 0]);
  const stretched = new View({ min: [-1, 0], max: [1, 1] }, 400, 400, NO_MARGIN, true);
  assert.deepEqual(
    [stretched.place([-1, 0]), stretched.place([1, 1])],
    [
      [0, 400],
      [400, 0],
    ],
  );
  assert.deepEqual(new View({ min: [0, 0], max: [1, 1] }, 128, 128).place([0, 0]), [14, 114]);
});

test("a world is its bounds and its obstacles; colours that are left out have their default", () => {
  const scenario = Scenario.parse(WALL);
  const { context, drawn } = recordingContext();
  drawWorld(context, new View(scenario.extent(), 100, 100, NO_MARGIN), scenario.document(), {
    obstacle: "silver",
    obstacleEdge: undefined,
  });
  assert.deepEqual(
    drawn.map(({ call, style }) => [call, style]),
    [
      ["strokeRect", defaultColours.obstacleEdge],
      ["fill", "silver"],
      ["stroke", defaultColours.obstacleEdge],
      ["fill", "silver"],
      ["stroke", defaultColours.obstacleEdge],
    ],
  );
  assert.deepEqual(drawn[0].numbers, [0, 0, 100, 100]);
  assert.deepEqual(
    drawn[1].path.map(({ numbers }) => numbers),
    [[40, 100], [50, 100], [50, 20], [40, 20], []],
  );
  assert.deepEqual(drawn[3].path, [{ call: "arc", numbers: [75, 40, 12, 0, 2 * Math.PI] }]);
});

test("a robot is its parts; links thinner than 1.6 units are lines over a wider one in the colour of the background", () => {
  const disc = recordingContext();
  drawRobot(
    disc.context,
    new View({ min: [0, 0], max: [10, 10] }, 200, 200, NO_MARGIN),
    Scenario.parse(WALL).footprint([2, 3]),
    { robot: "teal" },
  );
  assert.deepEqual(
    disc.drawn.map(({ call, style }) => [call, style]),
    [
      ["fill", "teal"],
      ["stroke", defaultColours.robotEdge],
    ],
  );
  assert.deepEqual(disc.drawn[0].path, [{ call: "arc", numbers: [40, 140, 6, 0, 2 * Math.PI] }]);
  assert.equal(disc.context.lineJoin, "miter", "styles are restored");

  const arm = Scenario.parse({
    ...WALL,
    world: { obstacles: [] },
    robot: { type: "arm", base: [0, 0], links: [1, 1] },
    queries: [],
  });
  const { context, drawn } = recordingContext();
  drawRobot(context, new View({ min: [-2, -2], max: [2, 2] }, 400, 400, NO_MARGIN), arm.footprint([0, Math.PI / 2]));
  assert.deepEqual(
    drawn.filter(({ call }) => call === "stroke").map(({ style, width }) => [style, width]),
    [7, 7, 3.4, 3.4].map((width) => [width === 7 ? defaultColours.stage : defaultColours.robot, width]),
  );
  assertNear(linesOf(drawn.slice(0, 2)).flat(), [
    [200, 200],
    [300, 200],
    [300, 200],
    [300, 100],
  ]);
  assert.equal(drawn.filter(({ call }) => call === "fill").length, 4, "both ends of each link");
});

test("edges are drawn once each, from the first new one on: straight for a disc, curved for an arm", () => {
  for (const [scenario, isArm] of /** @type {[Scenario, boolean][]} */ ([
    [Scenario.parse(WALL), false],
    [Scenario.generate("forest", { links: 3, seed: 4 }), true],
  ])) {
    const planner = scenario.planner({ algorithm: "rrt", seed: 3 });
    const view = new View(scenario.extent(), 500, 500);
    const { context, drawn } = recordingContext();
    let cursor = 0;
    do {
      planner.step(20);
      cursor = drawEdges(context, view, scenario, planner, cursor, { growth: "red" });
      assert.equal(cursor, planner.edgeCount);
    } while (planner.status === "running");
    const lines = linesOf(drawn);
    assert.equal(lines.length, planner.edgeCount);
    assert.ok(drawn.every(({ style }) => style === "red"));
    const tips = scenario.endEffectors(planner.verticesSince(0));
    const edges = planner.edgesSince(0);
    lines.forEach((line, e) =>
      assertNear(
        [line[0], line[line.length - 1]],
        [...edges.subarray(2 * e, 2 * e + 2)].map((vertex) => view.place(tips.subarray(2 * vertex))),
      ),
    );
    assert.equal(
      lines.some((line) => line.length > 2),
      isArm,
    );
  }
});

test("of a tree that is rewired only the present edges are drawn", () => {
  const scenario = Scenario.generate("discs", { robot: "disc", seed: 1 });
  const planner = scenario.planner({ algorithm: "rrt-star", improveIterations: 300, seed: 1 });
  while (planner.step(1000) === "running");
  const events = planner.eventsSince(0);
  const rewired = Array.from(
    { length: events.length / planner.eventWidth },
    (_, i) => events[i * planner.eventWidth],
  ).filter((kind) => eventKinds[kind] === "rewired").length;
  assert.ok(rewired > 20, `${rewired}`);
  const { context, drawn } = recordingContext();
  assert.equal(drawEdges(context, new View(scenario.extent(), 500, 500), scenario, planner), planner.edgeCount);
  assert.equal(linesOf(drawn).length, planner.edgeCount - rewired);
});

test("edges of a car follow their traces, and its path follows its motions", () => {
  const scenario = Scenario.generate("gap", { robot: "car", seed: 1 });
  const planner = scenario.planner({ seed: 1 });
  while (planner.step(1000) === "running");
  const view = new View(scenario.extent(), 500, 500);
  const edges = recordingContext();
  assert.equal(drawEdges(edges.context, view, scenario, planner), planner.edgeCount);
  const traces = planner.tracesSince(0);
  const rows = Array.from({ length: traces.length / 4 }, (_, i) => traces.subarray(4 * i, 4 * i + 4));
  const expected = rows.flatMap((row, i) =>
    rows[i + 1]?.[0] === row[0] ? [view.place(row.subarray(1)), view.place(rows[i + 1].subarray(1))] : [],
  );
  assert.ok(expected.length > planner.edgeCount);
  assertNear(linesOf(edges.drawn).flat(), expected);

  const path = recordingContext();
  const result = planner.result();
  drawPath(path.context, view, scenario, result);
  assert.deepEqual(
    path.drawn.map(({ style }) => style),
    [defaultColours.path],
  );
  const points = linesOf(path.drawn).flat();
  assertNear(
    [points[0], points[points.length - 1]],
    [result.path[0], result.path[result.path.length - 1]].map((q) => view.place(q)),
  );
  for (const q of result.path)
    assert.ok(
      points.some(([x, y]) => Math.hypot(x - view.x(q[0]), y - view.y(q[1])) < 1e-6),
      `${q}`,
    );
  const longest = points
    .slice(1)
    .reduce((most, [x, y], i) => Math.max(most, Math.hypot(x - points[i][0], y - points[i][1])), 0);
  assert.ok(longest < 10, `a jump of ${longest}`);
});

test("a path with blends is drawn round its corners, which are free and across which angles go the short way", () => {
  const scenario = Scenario.parse(WALL);
  const planner = scenario.planner({ seed: 2, blend: 0.5 });
  while (planner.step(1000) === "running");
  const result = planner.result();
  const { path, blends = [] } = result;
  const rounded = blends.filter(([before]) => before > 0).length;
  assert.ok(rounded > 0 && blends.length === path.length - 2);
  const rows = blendedPath(scenario, result);
  assert.equal(rows.length, path.length + 16 * rounded);
  assert.ok(rows.every((q) => scenario.check(q).free));
  const length = rows.slice(1).reduce((sum, q, i) => sum + scenario.distance(rows[i], q), 0);
  assert.ok(
    Math.abs(length - (result.blended_length ?? NaN)) < 1e-3 * length && length < result.length,
    `${length}, ${result.blended_length}`,
  );
  const view = new View(scenario.extent(), 500, 500);
  const { context, drawn } = recordingContext();
  drawPath(context, view, scenario, result);
  assertNear(
    linesOf(drawn).flat(),
    rows.slice(1).flatMap((q, i) => [view.place(rows[i]), view.place(q)]),
  );

  const arm = Scenario.generate("forest", { links: 1 });
  const across = blendedPath(arm, { path: [[3], [-3], [2.9]], blends: [[0.5, 0.25]] });
  assert.deepEqual([across.length, across[0], across[18]], [19, [3], [2.9]]);
  for (const [[from], [to]] of across.slice(1).map((q, i) => [across[i], q]))
    assert.ok(Math.abs(wrap(to - from)) < 0.3 && Math.abs(to) <= Math.PI);
});

test("without a path nothing is drawn", () => {
  const { context, drawn } = recordingContext();
  drawPath(context, new View({ min: [0, 0], max: [1, 1] }, 100, 100), Scenario.parse(WALL), { path: [] });
  assert.deepEqual(linesOf(drawn), []);
});

test("a curve of an arm goes the short way round, unless the options say otherwise, in pieces of at most 0.14 rad", () => {
  const arm = Scenario.parse({
    ...WALL,
    world: { obstacles: [] },
    robot: { type: "arm", base: [0, 0], links: [1] },
    queries: [],
  });
  const short = motionCurves(arm, Float64Array.of(3, -3));
  assert.deepEqual([...short.firsts], [0, 1 + Math.ceil((2 * Math.PI - 6) / 0.14)]);
  assert.ok(
    short.points.every((value, i) => i % 2 === 1 || value < -0.98),
    "past pi",
  );
  assert.equal(motionCurves(arm, Float64Array.of(3, -3), [false]).firsts[1], 1 + Math.ceil(6 / 0.14));
  assert.deepEqual([wrap(Math.PI), wrap(-Math.PI)], [Math.PI, Math.PI]);
  const differences = [difference(3, -3, false), difference(3, -3, true), difference(-3, 3, true)];
  assert.deepEqual(differences, [-6, 2 * Math.PI - 6, 6 - 2 * Math.PI]);
});
