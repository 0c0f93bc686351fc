/** The state of the planner's page: patches by settings, races, lessons and links, and the order in which parts agree. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, generators, planners } from "planarium";
import { Experiment as Experiments } from "planarium/full";
import { decodeExperiment, encodeExperiment } from "../../www/experiments/link.js";
import { resolved } from "../../www/experiments/worlds.js";
import { withPageDefaults } from "../../www/domain/page-defaults.js";
import { ORDER, reconcile, same } from "../../www/planner/experiment.js";
import { experimentOver } from "../../www/planner/over-seeds.js";
import { LESSONS, stageAt } from "../../www/planner/lessons/script.js";
import { decodeLink, encodeLink } from "../../www/planner/link/codec.js";
import { experimentOf, known } from "../../www/planner/link/experiment.js";
import { Page } from "../../www/planner/page.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { Planners } from "../../www/planner/settings/planners.js";
import { sceneOf, textOf } from "./library.mjs";

/** @import { Experiment } from "../../www/planner/link/codec.js" */
/** @import { Plan, Settings } from "../../www/domain/types.js" */

const table = new Planners(withPageDefaults(planners()));

/** The scenes' files, and a document that is not in projector mode. */
Object.assign(globalThis, {
  document: {
    getElementById: (/** @type {string} */ id) => {
      const scene = /^inline-scenes\/(.+)\.json$/.exec(id)?.[1];
      return scene ? { textContent: textOf(scene) } : null;
    },
    documentElement: { classList: { contains: () => false } },
  },
});

/** A page whose parts write down what they are made to do. */
function makePage() {
  /** @type {string[]} */
  const log = [];
  /** @type {any} */
  const session = {
    shown: null,
    refusal: null,
    opened: 0,
    clock: { now: 0, pace: 0, playing: false, owes: false },
    read: (/** @type {any} */ source) =>
      source.generate
        ? Scenario.generate(source.generate.kind, source.generate.options)
        : Scenario.parse(source.document),
    placedOf: async () => null,
    open(
      /** @type {Scenario} */ scenario,
      /** @type {object} */ document,
      /** @type {null} */ _,
      /** @type {number | undefined} */ pace,
    ) {
      log.push("scenario");
      this.clock.pace = pace ?? this.clock.pace;
      this.shown?.scenario.free();
      this.shown = { scenario, document, query: undefined, hand: null };
      this.opened++;
    },
    plan(/** @type {Plan[]} */ plans, /** @type {boolean} */ play, /** @type {string} */ query) {
      log.push("run");
      Object.assign(this, { plans, play });
      this.shown.query = query;
      this.clock.now = 0;
    },
    setView(/** @type {object} */ view) {
      log.push("view");
      this.view = view;
    },
    facts() {
      const { scenario, document, query } = this.shown;
      const queries = document.queries.map((/** @type {{ name: string }} */ { name }) => name);
      return { robot: scenario.robot, dimension: scenario.dimension, title: scenario.title, queries, query, document };
    },
    timeline: {
      seek(/** @type {number} */ time) {
        log.push("time");
        session.clock.now = time;
      },
    },
    byHand: { hold: (/** @type {Float64Array} */ pose) => log.push(`hand ${pose.length}`) },
    markDirty() {},
    queryTexts: [],
  };
  const notices = /** @type {string[]} */ ([]);
  /** @type {any} */
  const app = {
    reducedMotion: true,
    notice: { hide: () => notices.splice(0), show: (/** @type {string} */ text) => notices.push(text) },
    guard: (/** @type {() => void} */ action) => action(),
    track: (/** @type {Promise<unknown>} */ promise) => promise,
  };
  /** @type {any} */
  const panel = {
    own: "",
    show: () => log.push("settings"),
    offerOwn: (/** @type {string} */ title) => Object.assign(panel, { own: title }),
    selectQuery() {},
    offerQueries() {},
    nameQueries() {},
  };
  const page = new Page(app, session, panel, table);
  page.race = /** @type {any} */ ({ agree: () => log.push("rivals"), picture: "cspace" });
  page.timing = /** @type {any} */ ({ follow: () => log.push("timing") });
  page.arrange = () => void log.push("figures");
  page.onOpen(() => log.push("news"));
  /** What was done since it was last asked. */
  const done = () => log.splice(0).join(" ");
  /** The link's fragment, of the moment that the session shows. */
  const link = () => {
    page.state = /** @type {any} */ ({ clock: session.clock, lanes: [] });
    return encodeLink(experimentOf(page));
  };
  return { page, session, panel, notices, done, link };
}

/** A page with a scene. @param {string} scene */
async function openPage(scene) {
  const made = makePage();
  await made.page.open({ scene });
  made.done();
  return made;
}

/** @param {Plan} lane @param {Settings} more @returns {Plan} */
const withSettings = ({ algorithm, settings }, more) => ({ algorithm, settings: { ...settings, ...more } });

test("parts agree in one order: all of them with a scenario, and later those alone that depend on what differs", async () => {
  const { page, done, session } = makePage();
  await page.open({ scene: "stones", iteration: 12, pose: [0, 1] });
  assert.equal(done(), "scenario settings rivals view run figures news time hand 2 timing");
  assert.deepEqual(
    ORDER.map(([part]) => part),
    ["scenario", "settings", "rivals", "view", "run", "figures", "news", "time", "hand", "timing"],
  );
  page.change({ lanes: [withSettings(page.record.lanes[0], { k: 4 })] });
  assert.equal(done(), "settings rivals run figures");
  assert.equal(session.plans[0].settings.k, 4);
  page.setView({ refused: true });
  assert.equal(done(), "view figures");
  page.change({ timing: { speed: 2 } });
  assert.equal(done(), "timing");
  page.change({ iteration: 40 });
  assert.equal(done(), "time");
  page.change({ iteration: 40 });
  assert.equal(done(), "", "that time is shown");
  page.change({ lanes: [...page.record.lanes], view: { ...page.record.view }, query: page.record.query });
  assert.equal(done(), "", "nothing differs");
  assert.equal(session.opened, 1);
});

test("each part is due for each of its entries, and for no other one", () => {
  /** @type {any} */
  const [before, after] = [{}, {}];
  const entries = [...new Set(ORDER.flatMap(([, names]) => names))];
  for (const entry of entries) {
    /** @type {string[]} */
    const done = [];
    const parts = /** @type {any} */ (Object.fromEntries(ORDER.map(([part]) => [part, () => done.push(part)])));
    reconcile(before, { ...after, [entry]: 1 }, { [entry]: 1 }, parts);
    assert.deepEqual(
      done,
      ORDER.flatMap(([part, names]) => (names.some((name) => name === entry) ? [part] : [])),
      entry,
    );
  }
  assert.ok(same({ a: [1, { b: 2 }], c: undefined }, { a: [1, { b: 2 }] }));
  for (const [a, b] of [
    [{ a: 1 }, { a: 1, b: 0 }],
    [[1], [1, 2]],
    [null, {}],
    [1, "1"],
  ])
    assert.ok(!same(a, b));
});

test("settings: a lane keeps what its planner lacks, and runs with all parameters for the robot", async () => {
  const { page, session } = await openPage("stones");
  assert.deepEqual(page.record.lanes, [{ algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 } }]);
  page.change({ lanes: [{ ...page.record.lanes[0], algorithm: "rrt" }] });
  assert.equal(session.plans[0].settings.k, undefined);
  assert.equal(
    session.plans[0].settings.step,
    table.parametersOf("rrt").find(({ name }) => name === "step")?.default ?? undefined,
  );
  page.change({ lanes: [{ ...page.record.lanes[0], algorithm: "prm-star" }] });
  assert.equal(session.plans[0].settings.samples, 260, "the number of samples was kept");
  assert.equal("k" in session.plans[0].settings, false);
});

test("a patch that no record may have is refused, and a scenario that cannot be read leaves all as it was", async () => {
  const { page, done, session } = await openPage("stones");
  const { record } = page;
  const [lane] = record.lanes;
  for (const patch of [
    { lanes: [] },
    { lanes: [lane, lane, lane, lane, lane] },
    { lanes: [withSettings(lane, { k: NaN })] },
    { view: { lens: "side" } },
    { iteration: -1 },
    { colour: "red" },
  ])
    assert.throws(() => page.change(/** @type {any} */ (patch)), /experiment\./);
  await assert.rejects(page.open({ document: "{" }), { code: "invalid-json" });
  await assert.rejects(page.open({ document: { format: "planarium-scenario-1" } }), { code: "missing-field" });
  assert.equal(page.record, record);
  assert.equal(done(), "");
  assert.equal(session.opened, 1);
});

test("of two scenes that are opened at once the later one is shown", async () => {
  const { page, session } = await openPage("stones");
  const [first, second] = await Promise.all([page.open({ scene: "rings" }), page.open({ scene: "firs" })]);
  assert.deepEqual([first, second], [null, []]);
  assert.deepEqual([page.record.scene, session.opened], ["firs", 2]);
});

test("a query is one of the scene's; another scene begins with its first one, moved sliders keep it", async () => {
  const { page, session, done } = await openPage("stones");
  const { document } = session.shown;
  const [query] = document.queries;
  const two = { ...document, queries: [query, { ...query, name: "again" }] };
  await page.open({ document: two });
  assert.deepEqual([page.query, page.facts?.query, session.shown.query], [query.name, query.name, query.name]);
  done();
  page.change({ query: "again" });
  assert.equal(done(), "run");
  assert.deepEqual([page.query, page.facts?.query, session.shown.query], ["again", "again", "again"]);
  page.change({ query: query.name });
  assert.equal(page.record.query, undefined, "the first query needs no name");
  page.change({ query: "again" });
  await page.open({ document: { ...two, name: "other" }, query: "again" });
  assert.equal(page.query, "again");
  await page.open({ scene: "passage" });
  assert.equal(page.record.query, undefined);
  await page.open({ options: { width: 0.4 } });
  assert.deepEqual([page.record.scene, page.generation?.options.width], ["passage", 0.4]);
});

test("choosing a scene keeps the planner and its options", async () => {
  const { page, panel, session, notices } = await openPage("stones");
  page.change({ lanes: [{ algorithm: "rrt", settings: { step: 0.2, seed: 7 } }] });
  assert.equal(panel.own, "PRM");
  for (const scene of ["trap", "maze", "rings", "corner", "stones"]) {
    await page.open({ scene });
    assert.deepEqual(page.record.lanes, [{ algorithm: "rrt", settings: { step: 0.2, seed: 7 } }], scene);
    assert.deepEqual(notices, [], scene);
    assert.equal(panel.own, table.titleOf(sceneOf(scene).algorithm), `${scene} offers its own planner`);
  }
  await page.open({ scene: "maze" });
  page.useOwn();
  await new Promise((resolve) => setImmediate(resolve));
  assert.deepEqual(page.record.lanes, [{ algorithm: sceneOf("maze").algorithm, settings: sceneOf("maze").settings }]);
  assert.equal(panel.own, "");
  assert.equal(session.plans[0].algorithm, sceneOf("maze").algorithm);
});

test("a planner that does not serve a scene is replaced, and a notice says so; in a race, too", async () => {
  const { page, notices } = await openPage("blossom");
  assert.equal(page.record.lanes[0].algorithm, "rrt-control");
  await page.open({ scene: "maze" });
  assert.deepEqual(notices, ["Kinodynamic RRT needs a car; this scene has a disc: RRT-Connect is used."]);
  assert.deepEqual(page.record.lanes, [{ algorithm: sceneOf("maze").algorithm, settings: sceneOf("maze").settings }]);
  await page.open({
    scene: "blossom",
    lanes: ["rrt-control", "rrt", "sst"].map((algorithm) => ({ algorithm, settings: {} })),
  });
  assert.deepEqual(notices, []);
  await page.open({ scene: "rings" });
  assert.deepEqual(notices, [
    "Kinodynamic RRT needs a car; this scene has a disc: PRM is used as A. SST needs a car, so rival C was removed.",
  ]);
  assert.deepEqual(
    page.record.lanes.map(({ algorithm }) => algorithm),
    [sceneOf("rings").algorithm, "rrt"],
  );
  await page.open({ scene: "stones", lanes: [{ algorithm: "rrt", settings: { blend: 0.1 } }] });
  await page.open({ scene: "blossom" });
  assert.match(notices.join(), /^[A-Z][\w ]+ has no effect on a car\.$/);
  await page.open({ scene: "parking" });
  assert.deepEqual(notices, [], "it is said once");
  const lanes = [{ algorithm: "rrt", settings: { blend: 0.1 } }];
  for (const made of [{ page, notices }, makePage()]) {
    await made.page.open({ scene: "blossom", lanes });
    assert.match(
      made.notices.join(),
      /has no effect on a car\.$/,
      "those of a link are new, on a page's first scene too",
    );
  }
});

test("a planner that is wanted as it is stays, until others or another scene are", async () => {
  const { page, notices } = makePage();
  const lanes = [{ algorithm: "sst", settings: {} }];
  const algorithm = () => page.record.lanes[0].algorithm;
  await page.open({ scene: "stones", lanes }, { isAsGiven: true });
  page.setView({ refused: true });
  page.change({ iteration: 4 });
  assert.deepEqual([algorithm(), notices], ["sst", []]);
  page.change({ lanes: [...lanes] });
  assert.equal(algorithm(), sceneOf("stones").algorithm);
  await page.open({ scene: "stones", lanes }, { isAsGiven: true });
  await page.open({ scene: "maze" });
  assert.equal(algorithm(), sceneOf("maze").algorithm);
});

test("the lanes of a race stay as they are when the scene changes", async () => {
  const { page, notices } = await openPage("stones");
  /** @type {Plan[]} */
  const lanes = [
    { algorithm: "rrt", settings: { step: 0.2, seed: 4 } },
    { algorithm: "prm", settings: { k: 5 } },
    { algorithm: "prm", settings: { k: 5, seed: 9 } },
  ];
  page.change({ lanes });
  for (const { id } of SCENES) {
    await page.open({ scene: id });
    assert.deepEqual(page.record.lanes, lanes, id);
    assert.deepEqual(notices, [], id);
  }
});

test("a rival without a seed has that of A; one comes and goes without another scenario", async () => {
  const { page, session, done } = await openPage("stones");
  const seeds = () => session.plans.map((/** @type {Plan} */ { settings }) => settings.seed);
  const [a] = page.record.lanes;
  page.change({ lanes: [withSettings(a, { seed: 5 }), { algorithm: "rrt", settings: {} }] });
  assert.equal(done(), "settings rivals run figures");
  assert.deepEqual(seeds(), [5, 5]);
  page.change({ lanes: page.record.lanes.with(1, { algorithm: "rrt", settings: { seed: 6 } }) });
  assert.deepEqual(seeds(), [5, 6]);
  assert.deepEqual(page.names, ["A PRM, seed 5", "B RRT, seed 6"]);
  page.change({ lanes: page.record.lanes.toSpliced(0, 1) });
  assert.deepEqual(seeds(), [6]);
  assert.deepEqual(page.names, ["RRT"]);
});

test("each step of each lesson is a patch that the page then has, until something differs", async () => {
  const { page } = await openPage("stones");
  for (const lesson of LESSONS)
    for (const at of lesson.steps.keys()) {
      const { scene, ...lane } = stageAt(lesson, at);
      const patch = { scene, document: undefined, options: undefined, query: undefined, lanes: [lane] };
      await page.open(patch);
      assert.ok(page.has(patch), `${lesson.id}.${at + 1}`);
      page.change({ lanes: [withSettings(lane, { seed: 123_456 })] });
      assert.ok(!page.has(patch), `${lesson.id}.${at + 1} with another seed`);
      page.change({ lanes: [lane] });
      assert.ok(page.has(patch));
      page.change({ lanes: [lane, lane] });
      assert.ok(!page.has(patch), "a race");
      page.change({ lanes: [lane] });
    }
  const generated = { scene: "passage", document: undefined, options: undefined, query: undefined };
  await page.open(generated);
  assert.ok(page.has(generated));
  await page.open({ options: { width: 0.44 } });
  assert.ok(!page.has(generated), "a slider was moved");
});

test("an edited scene is another state without another run, and Undo to the first document is the scene again", async () => {
  const { page, session, done, link } = await openPage("stones");
  const { scene, options, document } = page.record;
  page.change({ scene: undefined, options: undefined, document: { ...session.shown.document }, pace: 130 });
  assert.equal(done(), "settings news");
  assert.deepEqual([page.record.scene, page.entry], [undefined, null]);
  const fresh = makePage();
  await follow(fresh.page, await link());
  assert.equal(fresh.session.clock.pace, sceneOf("stones").pace, "its link has the speed of the scene");
  page.change({ scene, options, document });
  assert.equal(done(), "settings news");
  assert.equal(page.entry?.id, "stones");
});

/** Opens a link on a page. @param {Page} page @param {string} fragment */
async function follow(page, fragment) {
  const { experiment } = await decodeLink(fragment);
  assert.ok(experiment);
  /** @type {string[]} */
  const faults = [];
  const catalogue = { scenes: SCENES, generators: generators(), planners: table };
  faults.push(...((await page.open(known(experiment, catalogue, faults), { play: false })) ?? []));
  return faults;
}

test("a link brings back the state, and has the same link: scenes, sliders, documents, settings, races, views", async () => {
  const { page: fresh, session: there, link: linkThere } = await openPage("firs");
  const { page, session, link } = await openPage("stones");
  /** @param {string} what */
  const check = async (what) => {
    session.clock.now = 11;
    const fragment = await link();
    assert.deepEqual(await follow(fresh, fragment), [], what);
    assert.deepEqual(there.plans, session.plans, what);
    assert.deepEqual(there.view, session.view, what);
    assert.deepEqual(there.shown.document, session.shown.document, what);
    assert.equal(there.shown.query, session.shown.query, what);
    assert.equal(there.clock.now, 11, what);
    assert.equal(await linkThere(), fragment, `${what}: the link of a link is that link`);
    return /** @type {Experiment} */ ((await decodeLink(fragment)).experiment);
  };
  for (const { id, algorithm, settings } of SCENES) {
    await page.open({ scene: id, lanes: [{ algorithm, settings }] });
    const { lanes, document } = await check(id);
    assert.ok(Object.keys(lanes[0].settings).length <= Object.keys(settings).length, "defaults are left out");
    assert.equal(document, undefined);
  }
  await page.open({ scene: "passage" });
  await page.open({ options: { width: 0.44 } });
  assert.deepEqual((await check("slider")).options, { width: 0.44 });
  await page.open({ scene: "make-maze", options: { seed: 12 } });
  assert.equal((await check("made")).scene, "make-maze");
  await page.open({ document: { ...session.shown.document, name: "own" } });
  assert.equal((await check("own")).document?.name, "own");
  await page.open({
    scene: "tentacle",
    lanes: [
      { algorithm: "prm-star", settings: { samples: 90, edge_check: "sampled", sampler: "halton", seed: 2 ** 53 - 1 } },
    ],
    view: { axes: [4, 1], refused: true, poses: 5, raw: true, slice: true },
  });
  assert.deepEqual((await check("settings of every kind")).view, {
    axes: [4, 1],
    refused: true,
    poses: 5,
    raw: true,
    slice: true,
  });
  const [a] = page.record.lanes;
  for (const seed of [undefined, 0, 3]) {
    /** @type {Plan} */
    const rival = { algorithm: "rrt", settings: seed === undefined ? {} : { seed } };
    page.change({ lanes: [withSettings(a, { seed: 3 }), rival] });
    const { lanes, view } = await check(`a race with seed ${seed}`);
    assert.deepEqual([lanes.length, view.lens], [2, "cspace"]);
  }
});

test("what the page does not know in a link is said, and the rest is restored", async () => {
  /** @type {[Partial<Experiment>, RegExp, Record<string, unknown>][]} */
  const cases = [
    [
      { scene: "atlantis", lanes: [{ algorithm: "rrt", settings: { seed: 5 } }] },
      /^There is no scene "atlantis"; the first scene is shown instead\.$/,
      { scene: "stones", algorithm: "rrt", seed: 5 },
    ],
    [
      { lanes: [{ algorithm: "crystal-ball", settings: {} }] },
      /^There is no planner "crystal-ball"\.$/,
      { algorithm: "rrt-connect", seed: 7 },
    ],
    [
      { lanes: [{ algorithm: "prm", settings: { k: -3, samples: 70 } }] },
      /^.*neighbours.*: -3 is below 1\.$/i,
      { algorithm: "prm", samples: 70, k: undefined },
    ],
    [
      { lanes: [{ algorithm: "prm", settings: { k: "ten", wings: 2, samples: 71 } }] },
      /Enter a number\. wings: There is no such option\.$/,
      { samples: 71 },
    ],
    [{ query: "home" }, /^This scene has no query "home"\.$/, { algorithm: "prm" }],
    [{ view: { axes: [0, 9] } }, /^This robot has no coordinates 0 and 9\.$/, {}],
    [{ pose: [1, 2, 3] }, /^The configuration has 3 numbers; one of this robot has 2\.$/, {}],
    [{ drive: { keys: "0w", steps: 9 } }, /^This robot cannot be driven\.$/, {}],
    [
      { lanes: [{ algorithm: "sst", settings: {} }] },
      /^SST needs a car; this scene has an arm: RRT-Connect is used\.$/,
      {},
    ],
    [{ scene: "passage", options: { width: 99, thickness: 0.2 } }, /99 is above/, { scene: "passage" }],
  ];
  for (const [given, sentence, restored] of cases) {
    const { page, session } = await openPage("slot");
    const experiment = /** @type {Experiment} */ ({
      version: 1,
      scene: "firs",
      lanes: [{ algorithm: "prm", settings: {} }],
      iteration: 3,
      view: {},
      ...given,
    });
    assert.match((await follow(page, await encodeLink(experiment))).join(" "), sentence);
    assert.equal(session.clock.now, 3);
    for (const [name, value] of Object.entries({ scene: "firs", ...restored })) {
      const [{ algorithm, settings }] = session.plans;
      assert.equal({ scene: page.record.scene, algorithm, ...settings }[name], value, `${sentence}: ${name}`);
    }
  }
});

test("over 100 seeds: the experiment has the scene, the query and the planners as they run, and the core accepts it", async () => {
  const { page, session } = await openPage("stones");
  const check = async () => {
    const document = experimentOver(page, planners());
    const { state, fault } = await decodeExperiment(await encodeExperiment({ document }));
    assert.equal(fault, "");
    assert.ok(state);
    const whole = await resolved(state.document);
    const experiment = Experiments.parse(/** @type {any} */ (whole));
    assert.equal(experiment.trialCount, 100 * session.plans.length);
    experiment.free();
    return document;
  };
  for (const { id, algorithm, settings } of SCENES) {
    await page.open({ scene: id, lanes: [{ algorithm, settings }] });
    const {
      worlds,
      planners: [{ set }],
      seeds,
    } = await check();
    assert.deepEqual(worlds, [{ scene: id }]);
    assert.deepEqual(seeds, { from: 0, count: 100 });
    const { seed: _, ...others } = settings;
    for (const [name, value] of Object.entries(others)) {
      const usual = planners()
        .find((one) => one.id === algorithm)
        ?.parameters.find((one) => one.name === name)?.default;
      if (value !== usual) assert.equal(/** @type {any} */ (set)[name], value, `${id}: ${name}`);
    }
    // What the page plans with by default is not always the core's default.
    assert.equal(/** @type {any} */ (set).max_iterations, session.plans[0].settings.max_iterations);
  }
  await page.open({ scene: "passage" });
  await page.open({ options: { width: 0.44 } });
  assert.deepEqual((await check()).worlds, [
    {
      name: sceneOf("passage").title,
      generate: "gap",
      set: { radius: 0.05, width: 0.44, thickness: 0.3 },
      seeds: [1],
    },
  ]);
  const { document } = session.shown;
  const [query] = document.queries;
  await page.open({ document: { ...document, queries: [query, { ...query, name: "again" }] }, query: "again" });
  page.change({
    lanes: [page.record.lanes[0], { algorithm: "rrt", settings: {} }, { algorithm: "rrt", settings: { seed: 8 } }],
  });
  const race = await check();
  assert.deepEqual(/** @type {any} */ (race.worlds[0]).queries, ["again"]);
  assert.deepEqual(
    race.planners.map(({ name, algorithm }) => [name, algorithm]),
    page.names.map((name, lane) => [name, session.plans[lane].algorithm]),
  );
});
