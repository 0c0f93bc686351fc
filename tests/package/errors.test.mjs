/**
 * Bad input that no document or option in JSON has, and what is no call at all. What the core refuses is in
 * refusals.test.mjs.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  Drive,
  Experiment,
  Fleet,
  FleetPlanner,
  Navigation,
  Neighbours,
  Planner,
  Problem,
  Reach,
  Scenario,
  Subdivision,
  Trajectories,
} from "planarium/full";
import { arm, car, disc, fails, finish, revoked } from "./scenes.mjs";

const query = (/** @type {object} */ fields) => ({ ...arm, queries: [{ ...arm.queries[0], ...fields }] });

/** Parses what no type allows. @param {unknown} document */
const parse = (document) => Scenario.parse(/** @type {any} */ (document));

test("numbers that JSON cannot say are refused by name, where they stand", () => {
  for (const value of [NaN, Infinity, -Infinity]) {
    fails(
      () => Scenario.parse(query({ start: [0, value] })),
      "not-finite",
      "/queries/0/start/1",
      new RegExp(String(value)),
    );
  }
  fails(() => parse({ ...arm, "a/b~c": { x: NaN } }), "not-finite", "/a~1b~0c/x");
  fails(() => parse({ ...car, robot: { ...car.robot, speed: [0, Infinity] } }), "not-finite", "/robot/speed/1");
  fails(() => Scenario.parse(JSON.stringify(arm).replace("0.8", "1e999")), "invalid-json");
});

test("an object is read as it is, whatever text can say of it", () => {
  const other = { ...arm.queries[0], name: "other" };
  const both = { ...arm, queries: [...arm.queries, other] };
  const names = (/** @type {unknown} */ document) =>
    parse(document)
      .document()
      .queries.map(({ name }) => name);
  const lists = /** @type {any} */ (Array.prototype);
  lists.toJSON = function () {
    return Array.from(this).slice(0, 1);
  };
  try {
    assert.deepEqual(names(both), [arm.queries[0].name, "other"]);
  } finally {
    delete lists.toJSON;
  }
  assert.deepEqual(names(both), [arm.queries[0].name, "other"]);
  for (const name of ["null", "\ud800", "__proto__"]) {
    const [given, text] = [query({ name }), JSON.stringify(query({ name }))];
    assert.equal(names(given)[0], name === "\ud800" ? "\ufffd" : name);
    if (name !== "\ud800") assert.deepEqual(parse(given).document(), parse(text).document());
  }
  let deep = {};
  for (let i = 0; i < 200; i += 1) deep = { deep };
  fails(() => parse({ ...arm, deep }), "invalid-json", undefined, /recursion limit exceeded$/u);
  fails(() => parse({ ...arm, robot: { ...arm.robot, links: [1, -1] } }), "out-of-range", "/robot/links/1");
  fails(() => parse(new Float64Array([1, 2])), "wrong-type");
});

test("what is no document at all", () => {
  const circle = /** @type {{ self?: object }} */ ({});
  circle.self = circle;
  fails(() => parse(circle), "invalid-json");
  fails(
    () =>
      parse({
        get name() {
          throw new Error("never read me");
        },
      }),
    "invalid-json",
    undefined,
    /never read me/,
  );
  fails(() => parse({ name: 1n }), "wrong-type", "/name", /a bigint/);
  let reads = 0;
  const fickle = {
    nothing: null,
    get name() {
      reads += 1;
      if (reads > 1) throw new Error("only once");
      return "n";
    },
  };
  fails(() => parse(fickle), "unknown-field", "/nothing");
  assert.equal(reads, 1, "a field is read once");
  for (const value of [undefined, () => 1, Symbol("s")])
    fails(() => Scenario.parse(/** @type {any} */ (value)), "wrong-type");
  for (const value of [null, 1, true, [], "[]"])
    fails(() => Scenario.parse(/** @type {any} */ (value)), "wrong-type", "");
  fails(() => Scenario.parse("[".repeat(100_000)), "invalid-json");
  fails(() => Scenario.parse(" ".repeat(33 * 1024 * 1024)), "too-large");
});

test("generators and planners take objects, and words where words are", () => {
  const scenario = Scenario.parse(arm);
  fails(() => Scenario.generate(/** @type {any} */ (7)), "wrong-type", "/kind");
  fails(() => Scenario.generate("forest", /** @type {any} */ (5)), "wrong-type");
  for (const [given, code, pointer] of /** @type {[any, string, string][]} */ ([
    ["prm", "wrong-type", ""],
    [[1], "wrong-type", ""],
    [{ seed: 0.5 }, "out-of-range", "/seed"],
    [{ seed: -1 }, "out-of-range", "/seed"],
    [{ step: Infinity }, "not-finite", "/step"],
  ]))
    fails(() => scenario.planner(given), code, pointer);
});

test("options are named in camelCase; the sentence names the right one", () => {
  const scenario = Scenario.parse(arm);
  const planner = (/** @type {object} */ options) => () => scenario.planner(/** @type {any} */ (options));
  fails(planner({ max_iterations: 5 }), "unknown-parameter", "/max_iterations", /maxIterations, not "max_iterations"/);
  fails(planner({ algorithm: "rrt", goal_bias: 0.1 }), "unknown-parameter", "/goal_bias", /goalBias/);
  fails(planner({ maxIterations: -5 }), "out-of-range", "/maxIterations", /^maxIterations must lie/);
  fails(
    planner({ goalBais: 1 }),
    "unknown-parameter",
    "/goalBais",
    /"goalBais"; known options are [^_]*edgeCheck[^_]*$/,
  );
  fails(planner({ query: "max_iterations_2" }), "unknown-query", "/query", /"max_iterations_2"/);
  fails(() => new Trajectories(/** @type {any} */ ({ half_side: 1 })), "unknown-parameter", "/half_side", /halfSide/);
  fails(
    () => scenario.reach(/** @type {any} */ ({ target: [1, 1], free_only: true })),
    "unknown-parameter",
    "/free_only",
    /freeOnly/,
  );
  fails(() => Scenario.generate("forest", /** @type {any} */ ({ a_b: 1 })), "unknown-parameter", "/a_b", /aB/);
  // Fields of documents stay as they are.
  fails(
    () => Scenario.parse(car).planner({ algorithm: "sst", selectionRadius: -1 }),
    "out-of-range",
    "/selectionRadius",
  );
  const robot = /** @type {any} */ (arm.robot);
  fails(
    () => Scenario.parse({ ...arm, robot: { ...robot, joint_limits: [[0, 1]] } }),
    "wrong-dimension",
    "/robot/joint_limits",
    /./,
  );
});

test("configurations", () => {
  const scenario = Scenario.parse(arm);
  const wrong = /** @type {any[]} */ ([
    undefined,
    null,
    1,
    "01",
    {},
    { length: 2 },
    new DataView(new ArrayBuffer(16)),
    new Set([1, 2]),
  ]);
  for (const q of wrong) fails(() => scenario.check(q), "wrong-type", "/q");
  for (const q of [[], [0], [0, 0, 0], new Float64Array(3)]) fails(() => scenario.check(q), "wrong-dimension", "/q");
  fails(() => scenario.check(new Array(4_000_000_000)), "too-large", "/q", /4000000000/);
  fails(() => scenario.check([0, NaN]), "not-finite", "/q/1", /NaN/);
  fails(() => scenario.check([0, Infinity]), "not-finite", "/q/1");
  fails(() => scenario.check(/** @type {any} */ ([0, "1"])), "wrong-type", "/q/1", /"1"/);
  // oxlint-disable-next-line no-sparse-arrays -- a hole is what is tested
  fails(() => scenario.check(/** @type {any} */ ([0, ,])), "wrong-type", "/q/1");
  fails(() => scenario.check(/** @type {any} */ (new BigInt64Array(2))), "wrong-type", "/q");
  fails(() => scenario.distance([0, 0], [0]), "wrong-dimension", "/b");
  fails(() => scenario.interpolate([0, 0], [1, 1], NaN), "not-finite", "/t");
  fails(() => scenario.interpolate([0, 0], [1, 1], 1.5), "out-of-range", "/t");
  fails(() => scenario.interpolate([0, 0], [1, 1], /** @type {any} */ ("0.5")), "wrong-type", "/t");
  fails(() => scenario.endEffectors([1, 2, 3]), "wrong-dimension", "/vertices");
  const proxy = new Proxy([0, 0], {
    get() {
      throw new Error("hands off");
    },
  });
  fails(() => scenario.check(proxy), "wrong-type", "/q", /hands off/);
});

test("motions asked of a run", () => {
  const planner = Scenario.parse(disc).planner();
  fails(() => planner.firstHits([1, 2, 3, 4, 5, 6]), "wrong-dimension", "/ends", /rows of 4 numbers/);
  fails(() => planner.firstHits([1, 2, 3, NaN]), "not-finite", "/ends/3");
  fails(() => planner.firstHits(/** @type {any} */ ("1234")), "wrong-type", "/ends");
  fails(() => planner.firstHits([1, 2, 3, 11]), "out-of-range", "/ends", /\[3\.0, 11\.0\] lies outside the limits/);
  fails(() => planner.firstHits([1e300, 2, 3, 4]), "out-of-range", "/ends");
  planner.step(1);
  fails(() => planner.record(), "unsupported", "", /1 were made/);
});

test("pictures of the configuration space", () => {
  const scenario = Scenario.parse(arm);
  fails(() => scenario.cspace({ width: 0, height: 8 }), "out-of-range");
  fails(() => scenario.cspace({ width: 8, height: 2 ** 40 }), "out-of-range");
  fails(() => scenario.cspace({ width: 1e9, height: 1e9 }), "out-of-range");
  fails(() => scenario.cspace(/** @type {any} */ ({ width: 8 })), "missing-field", "/height");
  fails(() => scenario.cspace(/** @type {any} */ (undefined)), "wrong-type");
  fails(() => Scenario.parse(disc).cspace({ width: 8, height: 8 }), "unsupported");
  fails(() => Scenario.parse(disc).cspaceRange(), "unsupported");
});

/** The counts of the rows that these methods return. @type {Record<string, string>} */
const COUNTS = {
  verticesSince: "vertexCount",
  edgesSince: "edgeCount",
  tracesSince: "edgeCount",
  motionsSince: "edgeCount",
  eventsSince: "eventCount",
  historySince: "historyCount",
  iteratesSince: "iterateCount",
  solutionsSince: "solutionCount",
  acceptedSince: "acceptedCount",
  refusedSince: "refusedCount",
  traceSince: "traceCount",
};

/** @param {object} one @param {string} read */
const countOf = (one, read) => Reflect.get(read === "traceSince" ? Reflect.get(one, "state") : one, COUNTS[read]);

test("counts and cursors", () => {
  const counting = [
    Scenario.parse(arm).planner(),
    Scenario.parse(arm).reach({ target: [0.1, 0.1] }),
    new Trajectories(),
  ];
  for (const one of counting) {
    for (const n of [-1, 0.5, 2 ** 53]) fails(() => one.step(n), "out-of-range", "/n");
    for (const n of [NaN, Infinity]) fails(() => one.step(n), "not-finite", "/n");
    for (const n of /** @type {any[]} */ ([undefined, null, "1", 1n, {}])) fails(() => one.step(n), "wrong-type", "/n");
    fails(() => one.stepFor(-1), "out-of-range", "/ms");
    fails(() => one.stepFor(NaN), "not-finite", "/ms");
    assert.equal(one.iterations, 0);
  }
  const driven = finish(Scenario.parse(car).planner({ maxIterations: 50 }));
  for (const one of [...counting, driven, Scenario.parse(car).drive()]) {
    const reads = Object.getOwnPropertyNames(Object.getPrototypeOf(one)).filter((name) => name.endsWith("Since"));
    assert.ok(reads.length > 0);
    for (const read of reads) {
      for (const row of [-1, 0.5, countOf(one, read) + 1])
        fails(() => Reflect.get(one, read).call(one, row), "out-of-range", "/row");
      fails(() => Reflect.get(one, read).call(one, NaN), "not-finite", "/row");
    }
  }
});

test("use after free throws freed; freeing twice does nothing", () => {
  const scenario = Scenario.parse(arm);
  const drive = Scenario.parse(car).drive();
  const handles = [
    scenario.planner(),
    scenario.neighbours(),
    scenario.reach({ target: [1, 0] }),
    drive,
    new Trajectories(),
    scenario,
  ];
  for (const [i, handle] of handles.entries()) {
    if (i % 2 === 0) handle.free();
    handle[Symbol.dispose]();
    handle.free();
    for (const [name, { get, value }] of Object.entries(
      Object.getOwnPropertyDescriptors(Object.getPrototypeOf(handle)),
    )) {
      if (name === "constructor" || name === "free" || name.startsWith("__")) continue;
      fails(() => (get ?? value).call(handle), "freed", "", /freed/);
    }
  }
});

test("what a scenario makes outlives it", () => {
  const scenario = Scenario.parse(car);
  const [planner, index, drive] = [scenario.planner(), scenario.neighbours(), scenario.drive()];
  scenario.free();
  assert.equal(planner.step(1), "running");
  index.add([[1, 1, 0]]);
  assert.deepEqual([...index.nearest([1, 1, 0], 1).distances], [0]);
  drive.press("faster");
  assert.equal(drive.tick(10).v, 0.1);
});

test("handles come from the package alone", () => {
  for (const Class of /** @type {any[]} */ ([Scenario, Planner, Neighbours, Reach, Drive, Subdivision])) {
    fails(() => new Class(), "illegal-constructor");
    fails(() => new Class(Symbol("planarium"), {}), "illegal-constructor");
  }
});

test("values that have no JSON form are refused where they stand; undefined is absent, null a value", () => {
  const [scenario, fleet, task] = [
    Scenario.parse(arm),
    Fleet.generate("swap"),
    Navigation.generate("rooms", { seed: 1 }),
  ];
  const experiment = (/** @type {object} */ fields) => ({
    format: "planarium-experiment-1",
    worlds: [{ scenario: arm }],
    planners: [{ algorithm: "prm" }],
    seeds: [1],
    ...fields,
  });
  class Kept {
    #seed = 5;
    get seed() {
      return this.#seed;
    }
  }
  /** Calls with a value, and where it stands. @type {[(value: any) => unknown, string][]} */
  const places = [
    [(seed) => scenario.planner({ seed }), "/seed"],
    [(maxIterations) => scenario.planner({ maxIterations }), "/maxIterations"],
    [(algorithm) => scenario.planner({ algorithm }), "/algorithm"],
    [(links) => Scenario.generate("forest", { links }), "/links"],
    [(target) => scenario.reach({ target: [1, target] }), "/target/1"],
    [(query) => scenario.certify({ query }), "/query"],
    [(trees) => scenario.neighbours({ index: "forest", trees }), "/trees"],
    [(free) => scenario.sampleConfigurations(1, { free }), "/free"],
    [(metric) => scenario.optimum({ metric }), "/metric"],
    [(count) => new Trajectories({ count }), "/count"],
    [(order) => fleet.planner({ order: ["a", order] }), "/order/1"],
    [(count) => Fleet.generate("ring", { count }), "/count"],
    [(title) => Fleet.parse({ ...fleet.toJSON(), title }), "/title"],
    [(hidden) => task.training({ hidden }), "/hidden"],
    [(title) => Navigation.parse({ ...task.toJSON(), title }), "/title"],
    [(title) => Experiment.parse(/** @type {any} */ (experiment({ title }))), "/title"],
    [
      (k) => Experiment.parse(/** @type {any} */ (experiment({ planners: [{ algorithm: "prm", set: { k } }] }))),
      "/planners/0/set/k",
    ],
    [(title) => Scenario.parse({ ...arm, title }), "/title"],
    [(x) => Scenario.parse(query({ goal: [0, x] })), "/queries/0/goal/1"],
    [(radius) => parse({ ...arm, "a/b": { radius } }), "/a~1b/radius"],
    [(x) => scenario.check([0, x]), "/q/1"],
    [
      (x) =>
        scenario.neighbours().add([
          [0, 0],
          [x, 0],
        ]),
      "/rows/1/0",
    ],
  ];
  for (const value of [
    Symbol("x"),
    () => 1,
    class {},
    1n,
    new Map([["seed", 5]]),
    new Set([5]),
    Promise.resolve(5),
    /5/,
    new Kept(),
    Object.create({ seed: 5 }),
    new ArrayBuffer(8),
    Object(5),
  ]) {
    for (const [call, pointer] of places) fails(() => call(value), "wrong-type", pointer);
    if (typeof value === "object") fails(() => scenario.planner(/** @type {any} */ (value)), "wrong-type", "");
  }
  for (const [call, pointer] of places.slice(0, 3))
    for (const value of [null, [5], { valueOf: undefined }]) fails(() => call(value), "wrong-type", pointer);
  for (const value of ["5", new Date(0), { valueOf: undefined }, null, [5], true])
    fails(() => scenario.planner(/** @type {any} */ ({ seed: value })), "wrong-type", "/seed");
  const plain = finish(scenario.planner()).fingerprint();
  for (const given of /** @type {any[]} */ ([
    undefined,
    null,
    {},
    { seed: undefined, step: undefined },
    Object.create(null),
  ]))
    assert.equal(finish(scenario.planner(given)).fingerprint(), plain);
  assert.equal(Scenario.parse(/** @type {any} */ ({ ...arm, title: undefined })).title, arm.name);
});

test("a method of another class, or without its object, is refused, and every handle goes on", () => {
  const [scenario, carScenario, fleet, task] = [
    Scenario.parse(arm),
    Scenario.parse(car),
    Fleet.generate("swap"),
    Navigation.generate("rooms", { seed: 1 }),
  ];
  const experiment = Experiment.parse({
    format: "planarium-experiment-1",
    worlds: [{ scenario: arm }],
    planners: [{ algorithm: "prm" }],
    seeds: [1],
  });
  const problem = new Problem({
    space: { coordinates: [{ kind: "circle" }] },
    start: [0],
    goal: [1],
    isFree(_, free) {
      free.fill(1);
    },
  });
  class Own extends Problem {
    get twice() {
      return 2 * this.dimension;
    }
  }
  const own = new Own({
    space: { coordinates: [{ kind: "circle" }] },
    start: [0],
    goal: [1],
    isFree(_, free) {
      free.fill(1);
    },
  });
  /** @type {any[]} */
  const handles = [
    scenario,
    scenario.planner(),
    scenario.reach({ target: [1, 0] }),
    scenario.neighbours(),
    scenario.certify(),
    carScenario.drive(),
    new Trajectories(),
    fleet,
    fleet.planner(),
    experiment,
    experiment.trial(0),
    task,
    task.training(),
    problem,
  ];
  const prototypes = handles.map((handle) => Object.getPrototypeOf(handle));
  assert.equal(new Set(prototypes).size, handles.length);
  let members = 0;
  prototypes.forEach((prototype, i) => {
    const strangers = [
      ...handles.filter((_, j) => j !== i),
      undefined,
      null,
      5,
      "text",
      {},
      prototype,
      Object.create(prototype),
      Object.assign(Object.create(prototype), handles[i]),
      new Proxy(handles[i], {}),
    ];
    for (const key of Reflect.ownKeys(prototype)) {
      if (key === "constructor" || String(key).startsWith("__") || key === Symbol.for("nodejs.util.inspect.custom"))
        continue;
      members += 1;
      const { get, value } = /** @type {PropertyDescriptor} */ (Object.getOwnPropertyDescriptor(prototype, key));
      for (const stranger of strangers) fails(() => (get ?? value).call(stranger), "illegal-invocation", "");
    }
  });
  assert.ok(members > 150, `${members} members`);
  const { step } = /** @type {Planner} */ (handles[1]);
  fails(() => step(1), "illegal-invocation", "", /^step belongs to a Planner, and was called on undefined\.$/);
  fails(
    () => FleetPlanner.prototype.result.call(/** @type {any} */ (fleet)),
    "illegal-invocation",
    "",
    /^result belongs to a FleetPlanner, and was called on a Fleet\.$/,
  );
  assert.deepEqual([own.dimension, own.twice], [1, 2], "a class may be extended");
  const { parse } = Scenario;
  assert.equal(parse(arm).name, arm.name, "functions of classes need no class");
  assert.ok(
    prototypes.every((prototype) => prototype.__v_skip === true),
    "Vue makes no proxies of them",
  );
  for (const one of [...handles, own]) one.free();
});

test("a caller's mistake is reported as such, and the core lives on", () => {
  const scenario = Scenario.parse(arm);
  const standing = scenario.planner();
  const kept = Scenario.parse(arm).planner({ algorithm: "prm", samples: 5 }).roadmap("binary");
  const detached = kept.slice();
  structuredClone(detached.buffer, { transfer: [detached.buffer] });
  fails(() => scenario.resume(detached), "wrong-type", "/roadmap");
  fails(() => scenario.resume(revoked()), "wrong-type", "/roadmap");
  const lengthless = Object.defineProperty(kept.slice(), "length", {
    get() {
      throw new Error("no length");
    },
  });
  assert.equal(scenario.resume(lengthless).phase, "searching", "bytes are copied without their properties");
  for (const length of [
    -1,
    2 ** 40,
    {
      valueOf() {
        throw new Error("no length");
      },
    },
  ]) {
    const list = new Proxy([[0, 0]], { get: (of, name) => (name === "length" ? length : Reflect.get(of, name)) });
    fails(() => scenario.neighbours().add(list), length === 2 ** 40 ? "too-large" : "wrong-type", "/rows");
  }
  let reads = 0;
  const fickle = new Proxy([0, 0, 0], {
    get: (of, name) => (name === "length" ? (reads += 1) + 1 : Reflect.get(of, name)),
  });
  assert.equal(scenario.check(fickle).free, true, "a length is read once");
  fails(() => scenario.check(fickle), "wrong-dimension", "/q");
  for (const q of [
    revoked(),
    {
      get 0() {
        return 1;
      },
    },
  ])
    fails(() => scenario.check(q), "wrong-type", "/q");
  for (const thrown of [
    Object.create(null),
    Symbol("s"),
    undefined,
    null,
    revoked(),
    {
      toString() {
        throw revoked();
      },
    },
    1n,
  ]) {
    fails(
      () =>
        scenario.check(
          new Proxy([0, 0], {
            get() {
              throw thrown;
            },
          }),
        ),
      "wrong-type",
      "/q",
    );
    fails(
      () =>
        scenario.planner(
          /** @type {any} */ ({
            get seed() {
              throw thrown;
            },
          }),
        ),
      "invalid-json",
    );
    fails(
      () =>
        parse({
          toJSON() {
            throw thrown;
          },
        }),
      "invalid-json",
    );
  }
  const deep = () => {
    scenario.check(new Proxy([0, 0], { get: () => deep() }));
  };
  fails(deep, "wrong-type", "/q");
  assert.equal(standing.step(1), "running");
});

test("a handle that is freed while its arguments are read is freed, and no other", () => {
  const standing = Scenario.parse(arm).planner();
  /** @type {((scenario: Scenario, free: () => void) => unknown)[]} */
  const calls = [
    (scenario, free) =>
      scenario.check(
        new Proxy([0, 0], {
          get: (of, name) => {
            free();
            return Reflect.get(of, name);
          },
        }),
      ),
    (scenario, free) =>
      scenario.planner(
        /** @type {any} */ ({
          toJSON() {
            free();
            return {};
          },
        }),
      ),
    (scenario, free) =>
      scenario.cspace({
        get width() {
          free();
          return 8;
        },
        height: 8,
      }),
    (scenario, free) =>
      scenario.resume(
        new Uint8Array(4),
        /** @type {any} */ ({
          get query() {
            free();
            return "over";
          },
        }),
      ),
  ];
  for (const call of calls) {
    const scenario = Scenario.parse(arm);
    fails(() => call(scenario, () => scenario.free()), "freed");
    fails(() => scenario.check([0, 0]), "freed");
  }
  assert.equal(standing.step(1), "running");
});
