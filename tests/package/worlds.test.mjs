/** The worlds of the gallery: each is a valid scenario of a few kilobytes, and its queries are what their names say. */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { Scenario } from "planarium";
import { finish } from "./scenes.mjs";

const folder = new URL("../../www/gallery/worlds/", import.meta.url);
const names = readdirSync(folder).map((file) => file.replace(/\.json$/, ""));
/** @param {string} name */
const text = (name) => readFileSync(new URL(`${name}.json`, folder), "utf8");

/**
 * What the reports say of their worlds: the joints or the kind of the robot, and the number of obstacles where it is
 * known.
 */
const FACTS = Object.entries({
  "two-triangles-4r": [4, 2],
  "one-way-4r": [4],
  "two-boxes-3r": [3, 2],
  "disc-4r": [4, 1],
  "one-box-2r": [2, 1],
  "arm2-class": [2, 3],
  "arm2-environment-1": [2],
  "arm2-environment-2": [2],
  "arm2-environment-3": [2],
  "arm2-environment-4": [2],
  "arm2-environment-5": [2],
  "rigid-1": ["rigid_body", 5],
  "rigid-2": ["rigid_body", 3],
  "rigid-3": ["rigid_body", 7],
  "car-1": ["car", 5],
  "car-2": ["car", 3],
  "car-3": ["car", 7],
  "maze-easy": ["car"],
  "maze-medium": ["car"],
  "maze-hard": ["car"],
});

/** The most bytes of a world, and of all. */
const [LARGEST, ALL] = [5_000, 35_000];

test("every world is small and named as its file, with a title", () => {
  let bytes = 0;
  for (const name of names) {
    const { length } = text(name);
    assert.ok(length <= LARGEST, `${name}: ${length}`);
    bytes += length;
    const scenario = Scenario.parse(text(name));
    const document = scenario.document();
    assert.equal(document.name, name);
    assert.ok(document.title && document.title.length <= 40, name);
    scenario.free();
  }
  assert.ok(bytes <= ALL, `${bytes}`);
});

test("a query starts or ends in collision if and only if its name says so, and the first needs more than a straight motion", () => {
  let refused = 0;
  for (const name of names) {
    const scenario = Scenario.parse(text(name));
    for (const [index, { name: query, start, goal }] of scenario.document().queries.entries()) {
      assert.ok(goal);
      const [said, both] = [/ \((start|goal|start and goal) in collision\)$/.exec(query)?.[1] ?? "", " and "];
      const found = [scenario.check(start).free ? "" : "start", scenario.check(goal).free ? "" : "goal"]
        .filter(Boolean)
        .join(both);
      assert.equal(found, said, `${name}: ${query}`);
      if (found) refused++;
      if (index === 0) assert.notEqual(scenario.firstHit(start, goal), null, `${name}: ${query}`);
    }
    scenario.free();
  }
  assert.ok(refused >= 8, `${refused}`);
});

test("the worlds have the robots and the numbers of obstacles of the reports", () => {
  for (const [name, [robot, obstacles]] of FACTS) {
    const scenario = Scenario.parse(text(name));
    const document = scenario.document();
    assert.equal(
      typeof robot === "number" ? document.robot.type === "arm" && document.robot.links.length : document.robot.type,
      robot,
      name,
    );
    if (obstacles) assert.equal(document.world.obstacles.length, obstacles, name);
    if (name.startsWith("arm2"))
      assert.deepEqual(document.robot, { type: "arm", base: [1, 1], links: [0.4, 0.25], radius: 0.05 }, name);
    if (!name.startsWith("maze") && document.world.bounds)
      assert.deepEqual(document.world.bounds, { min: [0, 0], max: [2, 2] }, name);
    scenario.free();
  }
});

test("of the five pairs each environment has its own first, and it is free; of the class's world only the third is", () => {
  for (const number of [1, 2, 3, 4, 5])
    assert.equal(JSON.parse(text(`arm2-environment-${number}`)).queries[0].name, `pair-${number}`);
  const pairs = JSON.parse(text("arm2-class"))
    .queries.slice(1)
    .map((/** @type {{ name: string }} */ query) => query.name);
  assert.deepEqual(
    pairs.map((/** @type {string} */ name) => name.includes("collision")),
    [true, true, false, true, true],
  );
});

test("where there is one way round, the first joint turns clockwise, though counter-clockwise is shorter", () => {
  const scenario = Scenario.parse(text("one-way-4r"));
  for (const { name, start, goal } of scenario.document().queries) {
    const planner = finish(scenario.planner({ algorithm: "prm", samples: 1000, k: 9, seed: 0, query: name }));
    const { path, status } = planner.result();
    assert.equal(status, "solved", name);
    const turn = (/** @type {number} */ from, /** @type {number} */ to) => {
      const by = (to - from) % (2 * Math.PI);
      return by > Math.PI ? by - 2 * Math.PI : by < -Math.PI ? by + 2 * Math.PI : by;
    };
    const turned = path.slice(1).reduce((sum, to, index) => sum + turn(path[index][0], to[0]), 0);
    assert.ok(goal && turn(start[0], goal[0]) > 0, name);
    assert.ok(turned < -Math.PI, `${name}: ${turned}`);
    planner.free();
  }
  scenario.free();
});
