/** The guided lessons: every step plays, and what it says is so. */
import assert from "node:assert/strict";
import { namesOfDocuments } from "../../www/domain/option-names.js";
import { test } from "node:test";
import { planners } from "planarium";
import { LESSONS, beginningOf, stageAt } from "../../www/planner/lessons/script.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { isFree, open, pieces, ran, sceneOf, touchedBy } from "./library.mjs";

/** @import { Scenario } from "planarium" */
/** @typedef {ReturnType<typeof ran> & { scenario: Scenario }} Played */

/** @param {string} id */
const lessonOf = (id) => LESSONS.find((lesson) => lesson.id === id) ?? assert.fail(id);

/**
 * The run of a lesson's step, up to where it rests.
 * @param {string} id
 * @param {number} at  from 1, as people count
 * @returns {Played}
 */
function shown(id, at) {
  const lesson = lessonOf(id);
  const { scene, algorithm, settings } = stageAt(lesson, at - 1);
  const scenario = open(sceneOf(scene));
  return { scenario, ...ran(scenario, algorithm, settings, lesson.steps[at - 1].iteration) };
}

/** How many pieces a map has. @param {Played} run */
const count = (run) => new Set(pieces(run)).size;

/** Whether start and goal are in one piece. @param {Played} run */
const isConnected = (run) => new Set(pieces(run).slice(0, 2)).size === 1;

test("eight lessons of up to five short steps, each of which plays; numbers of iterations in a text equal its run's", () => {
  assert.equal(LESSONS.length, 8);
  assert.equal(new Set(LESSONS.map(({ id }) => id)).size, 8);
  for (const lesson of LESSONS) {
    assert.ok(
      lesson.title.length > 0 && lesson.title.length <= 30 && lesson.steps.length >= 3 && lesson.steps.length <= 5,
      lesson.id,
    );
    assert.ok(lesson.steps[0].scene, lesson.id);
    lesson.steps.forEach(({ text, question, choices, answer, scene, iteration }, i) => {
      assert.ok(/[?]$/.test(question) && question.length <= 110, `${question.length}: ${question}`);
      assert.ok(
        choices.length >= 2 && choices.length <= 4 && new Set(choices).size === choices.length && choices[answer],
        question,
      );
      assert.notEqual(question, text);
      assert.ok(text.length > 0 && text.length <= 160, `${lesson.id} ${i + 1}: ${text.length}`);
      assert.ok((text.match(/[.:?!](?= |$)/g) ?? []).length <= 3 && /[.]$/.test(text), text);
      assert.ok(scene === undefined || SCENES.some(({ id }) => id === scene), scene);
      const run = shown(lesson.id, i + 1);
      assert.equal(run.iterations, iteration ?? run.iterations);
      assert.ok(iteration !== undefined || run.status !== "running");
      assert.ok(
        iteration !== undefined || run.iterations / sceneOf(stageAt(lesson, i).scene).pace <= 30,
        `${lesson.id} ${i + 1} takes too long`,
      );
      const [, more, told] = /(more than )?\b([\d,]+) iterations/.exec(text) ?? [];
      const number = Number(told?.replace(",", ""));
      if (told) assert.ok(more ? run.iterations > number : run.iterations === number, text);
    });
  }
});

test("a step asks where the step before rests, if the run is the same, else at its beginning", () => {
  const pull = lessonOf("pull");
  assert.deepEqual(
    pull.steps.map((_, i) => beginningOf(pull, i)),
    [0, 40, 120, 0, 0],
  );
});

test("at iteration 200 some samples are rejected and the others are vertices, with no edge yet", () => {
  const run = shown("sampling", 2);
  const rejected = run.events.filter(([kind]) => kind === 0).length;
  assert.ok(rejected > 50 && run.vertices.length > 50 && run.edges.length === 0, `${rejected} ${run.vertices.length}`);
  assert.equal(rejected + run.vertices.length - 2, 200);
});

test("40 samples leave start and goal apart, 260 connect them", () => {
  const few = shown("sampling", 3);
  assert.equal(few.status, "exhausted");
  assert.ok(count(few) > 1 && !isConnected(few));
  assert.equal(shown("sampling", 4).status, "solved");
});

test("Halton samples have fewer clumps and smaller holes", () => {
  const even = evenness(shown("sampling", 5));
  const chance = evenness(shown("sampling", 4));
  assert.ok(even.clumps < 0.8 * chance.clumps, `${even.clumps} ${chance.clumps}`);
  assert.ok(even.hole < 0.95 * chance.hole, `${even.hole} ${chance.hole}`);
});

/** How many vertices have another one close by, and how far a free pose may be from all. @param {Played} run */
function evenness({ scenario, vertices }) {
  const samples = vertices.slice(2);
  const nearest = (/** @type {number[]} */ q, /** @type {number[][]} */ others) =>
    Math.min(...others.map((other) => scenario.distance(q, other)));
  const clumps = samples.filter(
    (q, i) =>
      nearest(
        q,
        samples.filter((_, j) => j !== i),
      ) < 0.1,
  ).length;
  let hole = 0;
  for (let i = 0; i < 30; i++) {
    for (let j = 0; j < 30; j++) {
      const q = [((i + 0.5) / 15 - 1) * Math.PI, ((j + 0.5) / 15 - 1) * Math.PI];
      if (scenario.check(q).free) hole = Math.max(hole, nearest(q, samples));
    }
  }
  return { clumps, hole };
}

test("one neighbour leaves dozens of pieces, four few, and no path either way", () => {
  const [one, four] = [shown("neighbours", 1), shown("neighbours", 2)];
  assert.ok(count(one) >= 36 && count(four) > 1 && count(four) < 12, `${count(one)} ${count(four)}`);
  for (const run of [one, four]) assert.ok(run.status === "exhausted" && !isConnected(run));
});

test("nine find a path; thirty find one hardly shorter for three times the motions", () => {
  const [nine, thirty] = [shown("neighbours", 3), shown("neighbours", 4)];
  assert.deepEqual([nine.status, thirty.status], ["solved", "solved"]);
  assert.ok(thirty.result.length < nine.result.length && thirty.result.length > 0.97 * nine.result.length);
  const ratio = thirty.result.stats.motion_checks / nine.result.stats.motion_checks;
  assert.ok(ratio > 2.8 && ratio < 3.5, `${ratio}`);
});

test("PRM* takes 23, and more where there are more samples", () => {
  const star = shown("neighbours", 5);
  const { settings } = sceneOf("stones");
  assert.deepEqual(star.edges, ran(star.scenario, "prm", { ...settings, k: 23 }).edges);
  assert.notDeepEqual(star.edges, ran(star.scenario, "prm", { ...settings, k: 22 }).edges);
  const more = ran(star.scenario, "prm-star", { samples: 2000, seed: 0 });
  assert.ok(
    more.result.stats.motion_checks / more.vertices.length > star.result.stats.motion_checks / star.vertices.length,
  );
});

test("three and five places miss the wall; twenty see it, but with another seed not every disc; proofs miss nothing", () => {
  /** @type {[at: number, touched: number[]][]} */
  const expected = [
    [1, [0]],
    [2, [0]],
    [3, []],
    [4, [1]],
    [5, []],
  ];
  for (const [at, touched] of expected) {
    const { scenario, status, path } = shown("edges", at);
    assert.equal(status, "solved");
    assert.equal(isFree(scenario, path), touched.length === 0, `step ${at}`);
    assert.deepEqual(touchedBy(scenario, path), touched, `step ${at}`);
    const isBack = path.some((q) => Math.abs(q[0]) > 2.3);
    assert.equal(isBack, at >= 3, `step ${at}: round the back the first link points backwards on the way`);
  }
  const { scene, algorithm, settings } = stageAt(lessonOf("edges"), 0);
  const veil = sceneOf("veil");
  assert.deepEqual(
    { scene, algorithm, settings },
    { scene: "veil", algorithm: veil.algorithm, settings: veil.settings },
    "the scene goes through the wall, too",
  );
  assert.deepEqual(
    open(sceneOf("veil"))
      .document()
      .world.obstacles.map(({ type }) => type),
    ["polygon", "disc", "disc"],
  );
});

test("proven, no seed goes through", () => {
  for (let seed = 0; seed < 60; seed++) {
    const scenario = open(sceneOf("veil"));
    const run = ran(scenario, "prm", { ...sceneOf("veil").settings, edge_check: "proven", seed });
    assert.ok(run.status === "solved" && isFree(scenario, run.path), `${seed}`);
  }
});

/** Vertices within the wall's thickness. @param {Played} run */
const inside = ({ vertices }) => vertices.filter(([x]) => x > 0.85 && x < 1.15).length;

test("this seed finds the passage, another does not, many samples do, and so do Gaussian ones", () => {
  const [first, other, many, gaussian] = [1, 2, 3, 4].map((at) => shown("passage", at));
  assert.deepEqual(
    [first, other, many, gaussian].map(({ status }) => status),
    ["solved", "exhausted", "solved", "solved"],
  );
  assert.ok(inside(first) > 0 && inside(first) < 0.02 * first.vertices.length);
  assert.equal(count(other), 2);
  assert.ok(inside(many) < 0.02 * many.vertices.length);
  assert.equal(gaussian.vertices.length, other.vertices.length);
  assert.ok(inside(gaussian) > inside(other), `${inside(gaussian)} and ${inside(other)} in the passage`);
});

test("two trees need a few dozen iterations", () => {
  const { status, iterations } = shown("passage", 5);
  assert.ok(status === "solved" && iterations > 24 && iterations < 100, `${iterations}`);
});

test("at a third of its vertices the tree spans the room; later steps are shorter", () => {
  const run = shown("pull", 3);
  const early = shown("pull", 2).vertices.filter((_, i) => i !== 1);
  assert.ok(early.length < 0.4 * run.vertices.length);
  [3.2, 2].forEach((side, i) => {
    const span = Math.max(...early.map((q) => q[i])) - Math.min(...early.map((q) => q[i]));
    assert.ok(span > 0.8 * side, `${span} of ${side}`);
  });
  const mean = (/** @type {number[][]} */ edges) =>
    edges.reduce((sum, [a, b]) => sum + run.scenario.distance(run.vertices[a], run.vertices[b]), 0) / edges.length;
  assert.ok(mean(run.edges.slice(-80)) < 0.75 * mean(run.edges.slice(0, 80)));
});

test("a vertex beside more empty room is the nearest more often", () => {
  const { scenario, vertices } = shown("pull", 1);
  const tree = vertices.filter((_, i) => i !== 1);
  // The share of the room that is nearest to each vertex, and how far the tree's other vertices are.
  const share = tree.map(() => 0);
  for (let x = 0.07; x < 3.15; x += 0.04) {
    for (let y = 0.07; y < 1.95; y += 0.04) {
      let best = 0;
      let nearest = Infinity;
      tree.forEach((q, i) => {
        const distance = scenario.distance(q, [x, y]);
        if (distance < nearest) [best, nearest] = [i, distance];
      });
      share[best]++;
    }
  }
  const order = tree.map((_, i) => i).sort((a, b) => share[b] - share[a]);
  const total = share.reduce((sum, value) => sum + value, 0);
  const few = Math.round(tree.length / 4);
  assert.ok(
    order.slice(0, few).reduce((sum, i) => sum + share[i], 0) > 0.6 * total,
    "a quarter of the vertices draws most samples",
  );
  const out = (/** @type {number[]} */ [x, y]) => Math.hypot(x - 1.6, y - 1);
  const mean = (/** @type {number[]} */ some) => some.reduce((sum, i) => sum + out(tree[i]), 0) / some.length;
  assert.ok(mean(order.slice(0, few)) > 1.2 * mean(order.slice(few)), "and it is the outer quarter");
});

test("goal bias saves nine vertices in ten in the open, and costs twice the time in a trap", () => {
  const ratio = shown("pull", 4).vertices.length / shown("pull", 3).vertices.length;
  assert.ok(ratio > 0.07 && ratio < 0.14, `${ratio}`);
  const hasty = shown("pull", 5);
  const { scenario } = hasty;
  const calm = ran(scenario, "rrt", { ...sceneOf("trap").settings, goal_bias: 0.05 });
  assert.ok(hasty.status === "solved" && calm.status === "solved");
  assert.ok(hasty.iterations / calm.iterations > 2, `${hasty.iterations} ${calm.iterations}`);
});

test("the numbers of iterations of RRT and two trees are as the steps say", () => {
  const runs = [1, 2, 3, 4, 5].map((at) => shown("trees", at));
  assert.ok(runs.every(({ status }) => status === "solved"));
  const [one, two, deep, both, trap] = runs.map(({ iterations }) => iterations);
  assert.deepEqual([one, two, both], [1608, 146, 172]);
  assert.ok(deep > 12_000 && deep < 12_500, `${deep}`);
  assert.ok(runs[1].result.length < runs[0].result.length);
  const alone = ran(open(sceneOf("trap")), "rrt", sceneOf("trap").settings).iterations;
  assert.ok(alone / trap > 1.8 && alone / trap < 2.2, `${alone} ${trap}`);
});

test("with a reverse gear the car gets round, without it does not, within ten times as much room to try", () => {
  assert.equal(shown("wheels", 1).status, "solved");
  const forward = shown("wheels", 2);
  assert.deepEqual([forward.status, forward.iterations], ["exhausted", 250]);
  for (let seed = 0; seed < 4; seed++) {
    const { status } = ran(open(sceneOf("turn")), "rrt", {
      ...sceneOf("turn").settings,
      steering: "dubins",
      seed,
      max_iterations: 2500,
    });
    assert.equal(status, "exhausted", `seed ${seed}`);
  }
});

test("three controls need the fewest iterations and find the shortest path; the settings are the presets'", () => {
  const [one, three, five] = [3, 4, 5].map((at) => shown("wheels", at));
  assert.deepEqual(
    [one, three, five].map(({ status, iterations }) => [status, iterations]),
    [
      ["solved", 1916],
      ["solved", 354],
      ["solved", 1073],
    ],
  );
  assert.ok(three.result.length < five.result.length && five.result.length < one.result.length);
  const { presets } = planners().find(({ id }) => id === "rrt-control") ?? assert.fail();
  for (const [at, id] of /** @type {[number, string][]} */ ([
    [2, "blossom-1"],
    [3, "blossom-3"],
    [4, "blossom-5"],
  ])) {
    const { settings } = presets.find((preset) => preset.id === id) ?? assert.fail(id);
    assert.deepEqual(stageAt(lessonOf("wheels"), at).settings, { ...namesOfDocuments(settings), seed: 1 });
  }
});
