/** The scene library: every scene opens, ends as its story says, and keeps what the story promises. */
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { planners } from "planarium";
import { root } from "../../scripts/run.mjs";
import { SCENES, optionsAt } from "../../www/planner/scenes/scenes.js";
import { endsOf, isDriven, isFree, open, pieces, ran, sceneOf } from "./library.mjs";

/**
 * A scene at work as the page opens it.
 * @param {string} id
 * @param {import("../../www/domain/types.js").Settings} [changed]
 * @param {Record<string, number>} [positions]
 * @param {number} [iterations]
 */
function played(id, changed = {}, positions = {}, iterations = Infinity) {
  const entry = sceneOf(id);
  const scenario = open(entry, positions);
  return { scenario, ...ran(scenario, entry.algorithm, { ...entry.settings, ...changed }, iterations) };
}

/** Every position of a slider. @param {import("../../www/domain/types.js").Slider} slider */
function positionsOf({ min, max, step }) {
  return Array.from({ length: Math.round((max - min) / step) + 1 }, (_, i) => Number((min + i * step).toFixed(9)));
}

test("the library has all kinds of scenes, each once", () => {
  assert.ok(SCENES.length >= 14, `${SCENES.length} scenes`);
  assert.equal(new Set(SCENES.map(({ id }) => id)).size, SCENES.length);
  assert.equal(new Set(SCENES.map(({ title }) => title)).size, SCENES.length);
  assert.equal(SCENES[0].id, "stones");
  const kinds = new Set(SCENES.flatMap(({ generate }) => generate?.kind ?? []));
  for (const kind of /** @type {const} */ (["gap", "bug-trap", "maze", "discs"])) assert.ok(kinds.has(kind), kind);
  for (const id of ["open", "pillar", "slot", "firs", "veil", "locked"]) assert.equal(sceneOf(id).id, id);
  const known = new Set(/** @type {string[]} */ (planners().map(({ id }) => id)));
  assert.ok(SCENES.every(({ algorithm }) => known.has(algorithm)));
  assert.ok(Math.max(...SCENES.map((entry) => open(entry).dimension)) >= 5);
});

test("every file in scenes/ belongs to a scene, and has its title", () => {
  const files = readdirSync(join(root, "www", "scenes")).sort();
  assert.deepEqual(
    files,
    SCENES.filter(({ generate }) => !generate)
      .map(({ id }) => `${id}.json`)
      .sort(),
  );
  for (const entry of SCENES.filter(({ generate }) => !generate)) {
    const scenario = open(entry);
    assert.deepEqual([scenario.name, scenario.title], [entry.id, entry.title]);
  }
});

for (const entry of SCENES) {
  test(`${entry.id}: start and goal are free, the settings are its planner's, the story is short`, () => {
    const scenario = open(entry);
    const { queries } = scenario.document();
    assert.ok(queries.length > 0);
    for (const query of queries) for (const pose of endsOf(query)) assert.ok(scenario.check(pose).free);
    const { parameters } = planners().find(({ id }) => id === entry.algorithm) ?? assert.fail(entry.algorithm);
    const known = new Set([...parameters.map(({ name }) => name), "seed", "query"]);
    for (const name of Object.keys(entry.settings)) assert.ok(known.has(name), name);
    assert.ok(Number.isSafeInteger(entry.settings.seed), "a scene has its seed");
    assert.ok(entry.story.length <= 96 && /^[A-Z][^.]*(\. [A-Z][^.]*)?\.$/.test(entry.story), entry.story);
    assert.ok(entry.title.length <= 24, entry.title);
  });

  test(`${entry.id}: it grows for 3 to 25 seconds at its pace, and ends as it should`, () => {
    const { scenario, status, path, iterations, result } = played(entry.id);
    const seconds = iterations / entry.pace;
    assert.ok(seconds >= 3 && seconds <= 25, `${seconds} s`);
    assert.equal(status, entry.id === "locked" ? "exhausted" : "solved");
    if (status !== "solved") return;
    const { start, goal, target, goal_tolerance: near } = scenario.document().queries[0];
    const end = path[path.length - 1];
    assert.ok(scenario.distance(path[0], start) < 1e-9);
    if (target) {
      const [x, y] = scenario.endEffector(end);
      assert.ok(Math.hypot(x - target.point[0], y - target.point[1]) < 1e-8);
    } else if (!goal) assert.fail("a query has a goal or a target");
    else if (near)
      assert.ok(
        Math.hypot(end[0] - goal[0], end[1] - goal[1]) <= (near.translation ?? 0) &&
          Math.abs(turnBetween(end[2], goal[2])) <= (near.rotation ?? 0),
      );
    else assert.ok(scenario.distance(end, goal) < 1e-9);
    assert.equal(scenario.robot === "car" ? isDriven(scenario, result) : isFree(scenario, path), entry.id !== "veil");
  });
}

for (const entry of SCENES.filter(({ sliders }) => sliders)) {
  const sliders = entry.sliders ?? [];
  test(`${entry.id}: every position makes a scenario whose start and goal are free`, () => {
    assert.ok(entry.generate && sliders.length >= 1 && sliders.length <= 2);
    const check = (/** @type {Record<string, number>} */ positions) => {
      const scenario = open(entry, positions);
      for (const query of scenario.document().queries) {
        assert.ok(
          endsOf(query).every((pose) => scenario.check(pose).free),
          JSON.stringify(positions),
        );
      }
      scenario.free();
    };
    for (const slider of sliders) {
      assert.ok(
        slider.title.length > 0 && slider.title.length <= 24 && slider.step > 0 && slider.min < slider.max,
        slider.option,
      );
      assert.ok(!slider.words || (slider.min === 0 && slider.step === 1 && slider.max === slider.words.length - 1));
      const value = optionsAt(entry)[slider.option];
      const place = slider.words ? slider.words.indexOf(String(value)) : Number(value);
      assert.ok(positionsOf(slider).includes(place), `${slider.option}: ${value} is a position`);
      assert.equal(optionsAt(entry, { [slider.option]: place })[slider.option], value);
      for (const position of positionsOf(slider)) check({ [slider.option]: position });
    }
    // With two, each end of the one all along the other.
    for (const [one, other] of sliders.length === 2 ? [sliders, [...sliders].reverse()] : []) {
      for (const end of [one.min, one.max])
        for (const position of positionsOf(other)) check({ [one.option]: end, [other.option]: position });
    }
  });
}

test("mazes and pebbles are solved wherever their sliders stand", () => {
  for (const seed of [0, 9, 17, 30]) {
    for (const difficulty of [0, 1, 2])
      assert.equal(played("maze", {}, { difficulty, seed }).status, "solved", `maze ${difficulty} ${seed}`);
    for (const count of [0, 60, 110])
      assert.equal(played("pebbles", {}, { count, seed }).status, "solved", `pebbles ${count} ${seed}`);
  }
});

/** From one direction to another, the short way round. @param {number} from @param {number} to */
function turnBetween(from, to) {
  return Math.atan2(Math.sin(to - from), Math.cos(to - from));
}

test("corner: the L does not fit through the gap as it stands, nor with any one heading", () => {
  const scenario = open(sceneOf("corner"));
  for (let theta = -Math.PI; theta < Math.PI; theta += 0.04) {
    // Straight through, at any height: somewhere it touches.
    const passes = Array.from({ length: 160 }, (_, i) => i / 100).some((y) => {
      for (let x = 0.5; x <= 1.9; x += 0.02)
        if (!scenario.check([x, y, theta]).touching.every(({ obstacle }) => obstacle === "bounds")) return false;
      return true;
    });
    assert.equal(passes, false, `${theta}`);
  }
});

test("parking and turn: the car goes forward and backward", () => {
  for (const id of ["parking", "turn"]) {
    const ways = new Set((played(id).result.motions ?? []).map(({ control: [v] }) => Math.sign(v)));
    assert.ok(ways.has(1) && ways.has(-1), id);
  }
});

test("witness: what is worse is taken away again", () => {
  const { events } = played("witness");
  assert.ok(events.filter(([kind]) => kind === 6).length > 50);
});

test("open: the tree reaches for the emptiest places first, then fills in", () => {
  const { scenario, vertices, edges } = played("open");
  const early = vertices.slice(2, 82);
  const [width, height] = [0, 1].map((i) => Math.max(...early.map((q) => q[i])) - Math.min(...early.map((q) => q[i])));
  assert.ok(width > 0.7 * 3.2 && height > 0.7 * 2, `a quarter of the tree spans ${width} by ${height}`);
  const full = (/** @type {number[][]} */ some) =>
    some.filter(([a, b]) => scenario.distance(vertices[a], vertices[b]) > 0.1399).length / some.length;
  assert.ok(
    full(edges.slice(0, 80)) > 0.75 && full(edges.slice(-80)) < 0.3,
    "first steps are long, later ones stop short",
  );
});

test("pillar: the disc is one island, and the tree goes round it", () => {
  const { scenario } = played("pillar");
  const n = 120;
  const cells = scenario.cspace({ width: n, height: n });
  const seen = new Set([cells.indexOf(1)]);
  for (const cell of seen) {
    const [x, y] = [cell % n, Math.floor(cell / n)];
    for (const [dx, dy] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ]) {
      const next = ((y + dy + n) % n) * n + ((x + dx + n) % n);
      if (cells[next] === 1) seen.add(next);
    }
  }
  assert.equal(
    seen.size,
    cells.reduce((sum, cell) => sum + cell, 0),
    "one piece",
  );
  const columns = new Set([...seen].map((cell) => cell % n));
  const rows = new Set([...seen].map((cell) => Math.floor(cell / n)));
  assert.ok(columns.size < n && rows.size < n, "with sea all round");
  const [start, goal] = endsOf(scenario.document().queries[0]);
  assert.notEqual(scenario.firstHit(start, goal), null, "the straight way is blocked");
});

test("slot: the arm folds on the way", () => {
  const { path } = played("slot");
  const bend = path.map((q) => Math.abs(q[1]));
  assert.ok(Math.max(...bend) > 2 * Math.max(bend[0], bend[bend.length - 1]), `${bend}`);
});

test("passage: few samples fall into it, and narrower the map falls in two, though the disc would fit", () => {
  const { scenario, vertices } = played("passage");
  const wall = scenario
    .document()
    .world.obstacles.flatMap((obstacle) => (obstacle.type === "polygon" ? obstacle.vertices.map(([x]) => x) : []));
  const inside = vertices.filter(([x]) => x > Math.min(...wall) && x < Math.max(...wall));
  assert.ok(inside.length >= 1 && inside.length < 0.05 * vertices.length, `${inside.length}`);
  const narrow = played("passage", {}, { width: 0.12 });
  assert.equal(narrow.status, "exhausted");
  const piece = pieces(narrow);
  assert.notEqual(piece[0], piece[1]);
  assert.equal(ran(narrow.scenario, "prm", { samples: 4000, k: 12, seed: 1 }).status, "solved", "there is a way");
});

test("trap: the tree is in the trap for the better part of the run", () => {
  const { vertices, iterations, scenario } = played("trap");
  const [{ start }] = scenario.document().queries;
  const trap = scenario
    .document()
    .world.obstacles.flatMap((obstacle) => (obstacle.type === "polygon" ? obstacle.vertices : []));
  const middle = [0, 1].map((i) => (Math.min(...trap.map((p) => p[i])) + Math.max(...trap.map((p) => p[i]))) / 2);
  const isInside = (/** @type {number[]} */ [x, y]) => Math.hypot(x - middle[0], y - middle[1]) < 0.6;
  assert.ok(isInside(start));
  const half = played("trap", {}, {}, Math.floor(iterations / 2)).vertices.filter((_, i) => i !== 1);
  assert.ok(half.every(isInside) && half.length > 100, `${half.length} vertices in the trap at half time`);
  assert.ok(vertices.some((q, i) => i !== 1 && !isInside(q)));
});

test("pebbles: the path is nearly as short as the straight line", () => {
  const { scenario, result } = played("pebbles");
  const [start, goal] = endsOf(scenario.document().queries[0]);
  assert.ok(result.length < 1.1 * scenario.distance(start, goal), `${result.length}`);
});

test("museum: a dozen poses, one in each room at least, see nearly all", () => {
  const { vertices, result } = played("museum");
  assert.ok(vertices.length <= 13 && (result.coverage ?? 0) > 0.99, `${vertices.length} ${result.coverage}`);
  const room = (/** @type {number[]} */ [x, y]) => (x < 1.05 ? (y < 1 ? 0 : 1) : x < 2.15 ? 2 : y < 0.8 ? 3 : 4);
  assert.equal(new Set(vertices.map(room)).size, 5);
});

test("shelf: the arm draws back out before it enters again", () => {
  const { scenario, path } = played("shelf");
  const mouth = 0.42;
  const tips = path.map((q) => scenario.endEffector(q)[0]);
  assert.ok(tips[0] > mouth && tips[tips.length - 1] > mouth && Math.min(...tips) < mouth);
});

test("tentacle: shortcuts take a good part of the path away", () => {
  const { result } = played("tentacle");
  const wild = played("tentacle", { shortcut: 0 }).result;
  assert.ok(result.length < 0.75 * wild.length, `${result.length} of ${wild.length}`);
});

test("locked: two pieces hold nearly all of the map, start in one and goal in the other, whatever the seed", () => {
  for (let seed = 0; seed < 10; seed++) {
    const run = played("locked", { seed });
    assert.equal(run.status, "exhausted");
    const piece = pieces(run);
    const size = (/** @type {number} */ i) => piece.filter((other) => other === piece[i]).length;
    assert.notEqual(piece[0], piece[1]);
    assert.ok(size(0) + size(1) > 0.9 * piece.length, `${size(0)} and ${size(1)} of ${piece.length}`);
  }
});
