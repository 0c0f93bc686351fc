/**
 * Custom robots: planners of a problem whose functions are the caller's, what they throw, and what they may do
 * meanwhile.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { Problem, Scenario, solve } from "planarium";
import { root } from "../../scripts/run.mjs";
import { twoDiscs } from "./golden.mjs";
import { arm, fails } from "./scenes.mjs";

/** @typedef {import("planarium").ProblemDescription} Description */

const square = {
  coordinates: [
    { kind: /** @type {const} */ ("interval"), low: -2, high: 2 },
    { kind: /** @type {const} */ ("interval"), low: -2, high: 2 },
  ],
};
/** Around a disc of radius 1. @type {Description} */
const disc = {
  space: square,
  start: [-1.5, 0],
  goal: [1.5, 0],
  clearance(rows, clearances) {
    for (let i = 0; i < clearances.length; i += 1)
      clearances[i] = Math.sqrt(rows[2 * i] ** 2 + rows[2 * i + 1] ** 2) - 1;
  },
};

test("a problem is solved in one call, streamed, and its roadmap asked again", async () => {
  assert.equal(solve(new Problem(disc), { seed: 1 }).status, "solved");
  const problem = new Problem(disc);
  assert.equal(problem.dimension, 2);
  const planner = problem.planner({ algorithm: "prm", samples: 100, k: 8 });
  problem.free();
  let vertices = 0;
  for await (const growth of planner.growth()) vertices += growth.vertices.length / 2;
  assert.equal(vertices, planner.vertexCount);
  assert.equal(planner.query([0, 1.5], [0, -1.5]).status, "solved");
  assert.deepEqual([...planner.firstHits([-1.5, 1.5, 1.5, 1.5])], [1]);
  fails(() => planner.reopen(Scenario.parse(arm)), "unsupported");
  fails(() => new Problem(disc).planner({ algorithm: "rrt" }).roadmap("json"), "unsupported");
});

test("a saved roadmap is continued where the space is the same and all of it is free", () => {
  for (const free of /** @type {const} */ (["clearance", "samples"])) {
    const [problem, other] = [
      new Problem(twoDiscs(free)),
      new Problem(twoDiscs(free === "clearance" ? "samples" : "clearance")),
    ];
    const planner = problem.planner({ algorithm: "prm", samples: 100, k: 8, seed: 1 });
    planner.step(1e6);
    const text = planner.roadmap("json");
    if (free === "clearance")
      assert.equal(JSON.parse(text).checksum, "e442a668a112afdb", "the form of the crate's own tests");
    for (const kept of [text, planner.roadmap("binary")]) {
      const resumed = problem.resume(kept, { shortcut: 0 });
      while (resumed.step(7) === "running");
      assert.deepEqual(
        [resumed.status, resumed.path(), resumed.result().edge_check],
        [planner.status, planner.path(), planner.result().edge_check],
      );
      assert.equal(resumed.roadmap("json"), text);
      assert.deepEqual(
        resumed.query([0.7, 1, 3.3, 3], [3.3, 3, 0.7, 1]).path,
        planner.query([0.7, 1, 3.3, 3], [3.3, 3, 0.7, 1]).path,
      );
    }
    assert.match(planner.roadmap("graphml"), /<graphml/);
    fails(() => other.resume(text), "other-scenario", "/edgeCheck");
    fails(() => problem.resume(text, { samples: 5 }), "unsupported", "/samples");
    fails(() => problem.resume(text.replace('"k":8', '"k":9')), "invalid-roadmap", "/checksum");
    fails(() => Scenario.parse(arm).resume(text), "other-scenario", "/fingerprint");
    fails(() => new Problem(disc).resume(text), "other-scenario", "/metric/space/coordinates");
  }
  const planner = new Problem(disc).planner({ algorithm: "prm", samples: 60, k: 6 });
  planner.step(1e6);
  const text = planner.roadmap("json");
  const thrown = new Error("own");
  assert.throws(
    () =>
      new Problem({
        ...disc,
        clearance() {
          throw thrown;
        },
      }).resume(text),
    (error) => error === thrown,
  );
  assert.throws(
    () =>
      new Problem({
        ...disc,
        clearance(rows, clearances) {
          disc.clearance(rows, clearances);
          clearances.forEach((c, i) => {
            clearances[i] = c - 0.3;
          });
        },
      }).resume(text),
    { code: "invalid-roadmap" },
  );
  fails(() => new Problem(disc).resume(/** @type {any} */ (3)), "wrong-type", "/roadmap");
});

test("interpolate takes two configurations and a fraction", () => {
  const problem = new Problem(disc);
  assert.deepEqual([...problem.interpolate([-1, 0], [1, 2], 0.5)], [0, 1]);
  fails(() => problem.interpolate([0], [0, 0], 0.5), "wrong-dimension", "/a");
  fails(() => problem.interpolate([0, 0], [9, 0], 0.5), "out-of-range", "/b");
  fails(() => problem.interpolate([0, 0], [1, 0], 2), "out-of-range", "/t");
});

test("what a function throws comes out of step as it is, and stays", async () => {
  const thrown = [
    new TypeError("own"),
    "a word",
    undefined,
    null,
    new WebAssembly.RuntimeError("unreachable"),
    new Proxy(
      {},
      {
        get() {
          throw new Error("trap");
        },
        getPrototypeOf() {
          throw new Error("trap");
        },
      },
    ),
  ];
  for (const what of thrown) {
    let calls = 0;
    const problem = new Problem({
      ...disc,
      clearance(rows, clearances) {
        calls += 1;
        if (calls > 20) throw what;
        disc.clearance(rows, clearances);
      },
    });
    const planner = problem.planner({ algorithm: "rrt", seed: 1 });
    for (const call of [() => planner.step(1e6), () => planner.step(1), () => planner.stepFor(1)]) {
      let caught = /** @type {unknown} */ ("nothing");
      try {
        call();
      } catch (error) {
        caught = error;
      }
      assert.ok(Object.is(caught, what));
    }
    assert.deepEqual(
      [planner.status, planner.finish(), planner.path().length, planner.result().status],
      ["failed", "failed", 0, "failed"],
    );
    const { iterations, edgeCount } = planner;
    calls = -1e9;
    const sound = new Problem(disc).planner({ algorithm: "rrt", seed: 1 });
    sound.step(iterations);
    assert.deepEqual(planner.edgesSince(0), sound.edgesSince(0).subarray(0, 2 * edgeCount));
    const streamed = new Problem({
      ...disc,
      isFree: undefined,
      clearance(rows, clearances) {
        if ((calls += 1) > -1e9 + 9) throw what;
        disc.clearance(rows, clearances);
      },
    }).planner();
    let caught = /** @type {unknown} */ ("nothing");
    try {
      for await (const growth of streamed.growth()) assert.ok(growth);
    } catch (error) {
      caught = error;
    }
    assert.ok(Object.is(caught, what));
  }
  // The core is as it was.
  assert.equal(solve(Scenario.parse(arm), { seed: 1 }).status, "solved");
  const own = new Error("at the start");
  assert.throws(
    () =>
      new Problem({
        ...disc,
        clearance() {
          throw own;
        },
      }).planner(),
    own,
  );
});

test("a function may use everything but the planner that calls it", () => {
  const scenario = Scenario.parse(arm);
  /** @type {import("planarium").Planner | undefined} */ let planner;
  const other = new Problem(disc).planner({ algorithm: "rrt", seed: 3 });
  const codes = new Set();
  const problem = new Problem({
    ...disc,
    clearance(rows, clearances) {
      disc.clearance(rows, clearances);
      if (planner === undefined) return;
      for (const call of [
        () => planner?.step(1),
        () => planner?.free(),
        () => planner?.vertexCount,
        () => planner?.result(),
        () => planner?.growth(),
      ]) {
        try {
          call();
          codes.add("none");
        } catch (error) {
          codes.add(/** @type {any} */ (error).code);
        }
      }
      other.step(1);
      const another = new Problem(disc);
      another.planner({ seed: 4 }).free();
      another.free();
      assert.ok(scenario.check([0, 0]));
    },
  });
  planner = problem.planner({ algorithm: "rrt-connect", seed: 1 });
  assert.equal(planner.step(1e6), "solved");
  assert.deepEqual([...codes], ["in-use"]);
  assert.equal(
    planner.fingerprint(),
    (() => {
      const sound = new Problem(disc).planner({ algorithm: "rrt-connect", seed: 1 });
      sound.step(1e6);
      return sound.fingerprint();
    })(),
  );
  assert.ok(other.iterations > 0);
  // Uncaught, its refusal ends the run.
  /** @type {import("planarium").Planner | undefined} */ let reckless;
  const unwise = new Problem({
    ...disc,
    clearance(rows, clearances) {
      disc.clearance(rows, clearances);
      reckless?.step(1);
    },
  });
  reckless = unwise.planner({ seed: 1 });
  fails(() => reckless?.step(10), "in-use");
  reckless.free();
  // A problem can be planned for, but not freed, while it is asked about its start.
  let depth = 0;
  /** @type {Problem} */
  const nested = new Problem({
    ...disc,
    clearance(rows, clearances) {
      disc.clearance(rows, clearances);
      depth += 1;
      if (depth === 1) nested.planner({ seed: 1 }).free();
      if (depth === 1) fails(() => nested.free(), "in-use");
    },
  });
  nested.planner({ seed: 1 }).free();
  nested.free();
  fails(() => nested.planner(), "freed");
});

test("calls within functions are bounded, and the bound is an error of its own", () => {
  let most = 0;
  let depth = 0;
  const nested = () => {
    depth += 1;
    most = Math.max(most, depth);
    try {
      return new Problem({
        ...disc,
        clearance(rows, clearances) {
          disc.clearance(rows, clearances);
          nested().free();
        },
      }).planner({ seed: 1 });
    } finally {
      depth -= 1;
    }
  };
  fails(nested, "too-deep");
  assert.ok(most > 16, `${most} deep`);
  /** @type {import("planarium").Planner[]} */
  const planners = [];
  const stepped = () => {
    const planner = new Problem({
      ...disc,
      clearance(rows, clearances) {
        disc.clearance(rows, clearances);
        if (planners.length > depth) stepped();
      },
    }).planner({ seed: 1 });
    planners.push(planner);
    try {
      return planner.step(3);
    } finally {
      planner.free();
    }
  };
  fails(stepped, "too-deep");
  // The core is as it was, and so are the depths.
  assert.equal(solve(Scenario.parse(arm), { seed: 1 }).status, "solved");
});

test("wrong results have codes", () => {
  const wrong = (/** @type {any} */ clearance, /** @type {string} */ code) =>
    fails(() => new Problem({ ...disc, clearance }).planner(), code, "/clearance");
  wrong(() => {}, "not-finite");
  wrong((/** @type {any} */ _, /** @type {Float64Array} */ out) => {
    out.fill(NaN);
  }, "not-finite");
  wrong((/** @type {any} */ _, /** @type {any} */ out) => {
    out[0] = "many";
  }, "not-finite");
  wrong((/** @type {Float64Array} */ rows) => Array.from(rows), "wrong-type");
  wrong(async (/** @type {any} */ rows, /** @type {any} */ out) => {
    disc.clearance(rows, out);
  }, "wrong-type");
  wrong((/** @type {any} */ _, /** @type {Float64Array} */ out) => {
    out.fill(1);
    structuredClone(out, { transfer: [out.buffer] });
  }, "wrong-type");
  // The arrays that were given away are made anew.
  let calls = 0;
  const problem = new Problem({
    ...disc,
    clearance(rows, clearances) {
      disc.clearance(rows, clearances);
      if ((calls += 1) % 2) structuredClone(rows, { transfer: [rows.buffer] });
    },
  });
  assert.equal(solve(problem, { seed: 1 }).status, "solved");
});

test("descriptions are refused with code and pointer", () => {
  const { clearance, ...rest } = disc;
  const isFree = () => {};
  for (const [given, code, pointer] of /** @type {[any, string, string][]} */ ([
    [undefined, "wrong-type", ""],
    [[], "wrong-type", ""],
    [{}, "missing-field", "/space"],
    [{ ...disc, space: {} }, "missing-field", "/space/coordinates"],
    [{ ...disc, space: { coordinates: [{ kind: "sphere" }] } }, "out-of-range", "/space/coordinates/0/kind"],
    [{ ...disc, space: { ...square, metric: "l3" } }, "out-of-range", "/space/metric"],
    [{ ...disc, goal: [3, 0] }, "out-of-range", "/goal"],
    [{ ...rest, goal: undefined, clearance }, "missing-field", "/goal"],
    [{ ...disc, goals: [[1, 1]] }, "duplicate-field", "/goals"],
    [rest, "missing-field", "/clearance"],
    [{ ...disc, isFree }, "duplicate-field", "/isFree"],
    [{ ...rest, isFree: true }, "wrong-type", "/isFree"],
    [{ ...disc, resolution: 1 }, "unknown-field", "/resolution"],
    [{ ...rest, isFree, reach: [1, 1] }, "unknown-field", "/reach"],
    [{ ...disc, clearence: 1 }, "unknown-field", "/clearence"],
    [{ ...disc, isfree() {} }, "wrong-type", "/isfree"],
    [{ ...disc, clearance: undefined, isFree: Symbol("f") }, "wrong-type", "/isFree"],
    [{ ...disc, start: [0, () => 1] }, "wrong-type", "/start/1"],
  ]))
    fails(() => new Problem(given), code, pointer);
  fails(() => new Problem({ ...disc, goal: [0, 0] }).planner(), "goal-in-collision", "/goal");
  fails(() => new Problem({ ...disc, start: [0, 0] }).planner(), "start-in-collision", "/start");
  // A description may be an object of a class.
  class Robot {
    space = square;
    start = [-1.5, 0];
    goals = [[1.5, 0]];
    get radius() {
      return 1;
    }
    isFree(/** @type {Float64Array} */ rows, /** @type {Float64Array} */ free) {
      for (let i = 0; i < free.length; i += 1) free[i] = Number(Math.hypot(rows[2 * i], rows[2 * i + 1]) > this.radius);
    }
  }
  assert.equal(solve(new Problem(new Robot())).edge_check, "sampled");
});

test("the examples solve in Node, and their paths are free wherever one looks", async () => {
  for (const name of ["two-discs", "six-joints", "drone"]) {
    const { description, options } = await import(`../../examples/own/${name}.js`);
    const result = solve(new Problem(description), options);
    assert.equal(result.status, "solved", name);
    assert.equal(result.edge_check, undefined);
    const circles = description.space.coordinates.map((/** @type {{ kind: string }} */ { kind }) => kind === "circle");
    const [n, count] = [circles.length, 2000];
    const [rows, clearances] = [new Float64Array(n * count), new Float64Array(count)];
    result.path.slice(1).forEach((q, k) => {
      const from = result.path[k];
      for (let i = 0; i < count; i += 1) {
        for (let j = 0; j < n; j += 1) {
          const d = q[j] - from[j];
          rows[n * i + j] = from[j] + (i / count) * (circles[j] ? d - 2 * Math.PI * Math.round(d / (2 * Math.PI)) : d);
        }
      }
      description.clearance(rows, clearances);
      assert.ok(
        clearances.every((clearance) => clearance > 0),
        `${name}, edge ${k}: ${Math.min(...clearances)}`,
      );
    });
  }
});

test("freed planners and problems keep no function alive", () => {
  const script = `
    import { Problem } from "planarium";
    const alive = [];
    const make = () => {
      const big = new Float64Array(1e5);
      const problem = new Problem({ space: { coordinates: [{ kind: "circle" }] }, start: [0], goal: [1], clearance(rows, out) { out.fill(1 + big[0]); } });
      alive.push(new WeakRef(big));
      const planner = problem.planner({ algorithm: "rrt-star", improveIterations: 20 });
      planner.step(10);
      planner.free();
      try { problem.planner({ algorithm: "none" }); } catch {}
      problem.free();
    };
    for (let i = 0; i < 50; i += 1) make();
    for (let i = 0; i < 10; i += 1) { await new Promise((resolve) => setImmediate(resolve)); gc(); }
    console.log(alive.filter((ref) => ref.deref() !== undefined).length);`;
  assert.ok(
    Number(
      execFileSync(process.execPath, ["--expose-gc", "--input-type=module", "-e", script], {
        cwd: root,
        encoding: "utf8",
      }),
    ) <= 1,
  );
});
