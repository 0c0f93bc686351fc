/**
 * Planning in workers: the bits of a planner stepped by hand, the end of a run by every way, and what is lost with a
 * worker.
 */
import assert from "node:assert/strict";
import { cpSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { Worker } from "node:worker_threads";
import { PlanariumError, Problem, Scenario } from "planarium";
import { PlannerPool } from "planarium/worker";
import { chromium } from "playwright-core";
import { root } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { ensureBrowser } from "../../scripts/setup.mjs";
import { addFiles, emptyFolder } from "./packed.mjs";
import { arm, car, disc, finish } from "./scenes.mjs";

/** @import { PlannerOptions, ResultDocument, ScenarioDocument } from "planarium" */

const long = /** @type {const} */ ({ algorithm: "prm", samples: 1_000_000 });
const place = pathToFileURL(join(root, "dist", "package")).href;

/** @param {(pool: PlannerPool) => Promise<void>} body @param {import("planarium/worker").PoolOptions} [options] */
async function within(body, options) {
  const pool = new PlannerPool(options);
  try {
    await body(pool);
  } finally {
    pool.terminate();
  }
}

/** A worker of further code, and the messages that are sent to it. @param {string} code @param {any[]} [sent] */
const workerOf =
  (code, sent = []) =>
  () => {
    const worker = new Worker(
      `import(${JSON.stringify(`${place}/worker-entry.js`)}).then(async () => { const { parentPort } = await import("node:worker_threads"); ${code} });`,
      { eval: true },
    );
    const { postMessage } = worker;
    return Object.assign(worker, {
      postMessage: (/** @type {any} */ message) => {
        sent.push(message);
        postMessage.call(worker, message);
      },
    });
  };

/** Ends a worker that keeps an array that it has sent. */
const transferred = `const { postMessage } = parentPort;
parentPort.postMessage = (message, ...transfer) => {
  const arrays = Object.values(message.value ?? {}).filter((value) => ArrayBuffer.isView(value));
  postMessage.call(parentPort, message, ...transfer);
  if (arrays.some(({ byteLength }) => byteLength > 0)) process.exit(9);
};`;

/** A result without the seconds that it took. @param {ResultDocument} result */
const untimed = ({ stats, ...result }) => ({ ...result, stats: { ...stats, build_seconds: 0, search_seconds: 0 } });

test("a run in a worker is the run stepped by hand, of a document, a text or a scenario, slice by slice; arrays are transferred", () =>
  within(
    async (pool) => {
      const options = /** @type {const} */ ({ algorithm: "prm", seed: 6, k: 5 });
      const plain = finish(Scenario.parse(arm).planner(options));
      for (const input of [arm, JSON.stringify(arm), Scenario.parse(arm)]) {
        /** @type {[number[], number[], number[]]} */
        const grown = [[], [], []];
        const results = [];
        for await (const { vertices, edges, events, status, result } of pool.growth(input, options, { budget: 0.5 })) {
          [vertices, edges, events].forEach((rows, i) => grown[i].push(...rows));
          assert.equal(result?.status ?? "running", status);
          results.push(result);
        }
        assert.deepEqual(grown, [[...plain.verticesSince(0)], [...plain.edgesSince(0)], [...plain.eventsSince(0)]]);
        assert.ok(results.length > 2);
        const last = results.pop();
        assert.deepEqual(
          results.filter((result) => result !== null),
          [],
        );
        assert.ok(last);
        assert.deepEqual(untimed(last), untimed(plain.result()));
      }
      let slices = 0;
      const result = await pool.plan(arm, options, {
        onProgress: () => {
          slices += 1;
        },
      });
      assert.deepEqual(untimed(result), untimed(plain.result()));
      assert.ok(slices > 1);
    },
    { worker: workerOf(transferred) },
  ));

test("several runs at once are those one by one, on more workers or fewer than runs", async () => {
  const seeds = [1, 2, 3, 4, 5];
  const expected = seeds.map((seed) => finish(Scenario.parse(arm).planner({ seed })).fingerprint());
  for (const workers of [1, 3]) {
    let started = 0;
    const worker = () => {
      started += 1;
      return workerOf("")();
    };
    await within(
      async (pool) => {
        const results = await Promise.all(seeds.map((seed) => pool.plan(arm, { seed })));
        assert.deepEqual(
          results.map(({ fingerprint }) => fingerprint),
          expected,
        );
        await pool.plan(arm, { seed: 6 });
        assert.equal(started, workers);
      },
      { workers, worker },
    );
  }
});

test("a slice is planned ahead of a slow loop, and none after it", async () => {
  /** @type {any[]} */
  const sent = [];
  await within(
    async (pool) => {
      let handled = 0;
      for await (const { result } of pool.growth(arm, { algorithm: "prm", samples: 300 }, { budget: 0 })) {
        const asked = sent.filter((message) => "run" in message && !("given" in message)).length;
        assert.equal(asked, (handled += 1) + Number(result === null));
      }
      assert.ok(handled > 100);
    },
    { worker: workerOf("", sent) },
  );
});

test("a signal ends a run with its reason: before, while it plans, and in the loop; the worker goes on", () =>
  within(
    async (pool) => {
      const reason = new Error("enough");
      await assert.rejects(pool.plan(arm, long, { signal: AbortSignal.abort(reason) }), reason);
      const controller = new AbortController();
      const planned = pool.plan(arm, long, { signal: controller.signal });
      const other = pool.plan(arm, { seed: 1 });
      controller.abort(reason);
      await assert.rejects(planned, reason);
      const late = new AbortController();
      await assert.rejects(
        async () => {
          for await (const { iterations } of pool.growth(arm, long, { signal: late.signal }))
            if (iterations > 0) late.abort();
        },
        { name: "AbortError" },
      );
      assert.equal((await other).status, "solved");
      assert.equal((await pool.plan(arm, { seed: 1 })).fingerprint, (await other).fingerprint);
    },
    { workers: 1 },
  ));

test("a loop that breaks off, and a listener that throws, end the run, and the worker goes on", async () => {
  /** @type {any[]} */
  const sent = [];
  await within(
    async (pool) => {
      for await (const { iterations } of pool.growth(arm, long)) if (iterations > 0) break;
      await assert.rejects(
        pool.plan(arm, long, {
          onProgress: () => {
            throw new RangeError("mine");
          },
        }),
        { message: "mine" },
      );
      assert.equal((await pool.plan(arm)).status, "solved");
      assert.deepEqual(
        sent.filter(({ isOver }) => isOver).map(({ run }) => run),
        [0, 1, 2],
      );
    },
    { workers: 1, worker: workerOf("", sent) },
  );
});

test("a listener may be asynchronous: the next slice waits for it, its rejection is the plan's, and a signal does not wait for it", () =>
  within(
    async (pool) => {
      /** @type {string[]} */
      const log = [];
      const slow = async () => {
        log.push("begun");
        await new Promise((resolve) => setImmediate(resolve));
        log.push("ended");
      };
      assert.equal(
        (await pool.plan(arm, { algorithm: "prm", samples: 300 }, { onProgress: slow, budget: 0 })).status,
        "solved",
      );
      assert.ok(log.length > 10);
      assert.ok(
        log.every((word, i) => word === ["begun", "ended"][i % 2]),
        "one after the other",
      );
      const reason = new RangeError("mine");
      await assert.rejects(
        pool.plan(arm, long, {
          onProgress: async () => {
            throw reason;
          },
        }),
        reason,
      );
      const controller = new AbortController();
      const enough = new Error("enough");
      await assert.rejects(
        pool.plan(arm, long, {
          signal: controller.signal,
          onProgress: () => new Promise(() => controller.abort(enough)),
        }),
        enough,
      );
      const lost = new PlannerPool();
      await assert.rejects(lost.plan(arm, long, { onProgress: () => new Promise(() => lost.terminate()) }), {
        code: "freed",
      });
    },
    { workers: 1 },
  ));

test("messages that are not the pool's are ignored, on both sides", async () => {
  const foreign = `for (const message of [null, 7, "text", {}, [], { run: 0 }, { run: 0, fault: null }, { run: 0, value: {} }, { run: 0, call: 0 }, { run: 0, call: 0, fault: {} }, { run: 99, fault: { code: "internal" } }, { run: 99, thrown: [1] }]) parentPort.postMessage(message);`;
  /** @type {any} */
  let worker;
  await within(
    async (pool) => {
      const planned = pool.plan(arm, { algorithm: "prm" }, { budget: 0 });
      for (const message of [null, 7, "text", {}, { run: 99 }, { run: 99, isOver: true }]) worker.postMessage(message);
      assert.equal((await planned).status, "solved");
    },
    { worker: () => (worker = workerOf(foreign)()) },
  );
  await within((pool) => assert.rejects(pool.plan(arm), { name: "PlanariumError", code: "init-failed" }), {
    worker: () => ({ postMessage: 1 }),
  });
});

test("a problem is planned for where its functions come from a module", () =>
  within(
    async (pool) => {
      const text = `const space = { coordinates: [{ kind: "interval", low: -2, high: 2 }, { kind: "interval", low: -2, high: 2 }] };
    export const around = (radius, box) => ({
      space, start: [-1.5, 0], goal: [1.5, 0],
      clearance(rows, clearances) { for (let i = 0; i < clearances.length; i += 1) clearances[i] = Math.sqrt(rows[2 * i] ** 2 + rows[2 * i + 1] ** 2) - radius - box.get("grown"); },
    });
    export default { space, start: [-1.5, 0], goal: [1.5, 0], isFree(rows, free) { free.fill(1); } };
    export const late = async () => { throw new RangeError("late"); };
    export const failing = { space, start: [-1.5, 0], goal: [1.5, 0], calls: undefined, isFree(rows, free) { free.fill(1); if ((this.made = (this.made ?? 0) + free.length) > 50) throw new RangeError("mine"); } };
    export const unsendable = { space, start: [-1.5, 0], goal: [1.5, 0], isFree() { throw () => 1; } };`;
      const module = `data:text/javascript,${encodeURIComponent(text)}`;
      const { around } = await import(module);
      const options = /** @type {const} */ ({ algorithm: "rrt-star", seed: 3, improveIterations: 50 });
      const box = new Map([["grown", 0.25]]);
      const planner = new Problem(around(0.75, box)).planner(options);
      const expected = finish(planner).result();
      let vertices = 0;
      let result = null;
      for await (const growth of pool.growth(
        { module: new URL(module), export: "around", arguments: [0.75, box] },
        options,
        { budget: 1 },
      )) {
        vertices += growth.vertices.length / 2;
        result = growth.result;
      }
      assert.ok(result);
      assert.deepEqual(untimed(result), untimed(expected));
      assert.equal(vertices, planner.vertexCount);
      assert.equal((await pool.plan({ module })).edge_check, "sampled");
      await assert.rejects(pool.plan({ module, export: "late" }), { name: "RangeError", message: "late" });
      await assert.rejects(pool.plan({ module, export: "failing" }, { algorithm: "prm" }), {
        name: "RangeError",
        message: "mine",
      });
      await assert.rejects(pool.plan({ module, export: "unsendable" }), {
        name: "PlanariumError",
        code: "callback-failed",
      });
      await assert.rejects(pool.plan({ module }, { algorithm: "sst" }), { code: "unsupported", pointer: "/algorithm" });
    },
    { workers: 1 },
  ));

test("errors have their code and pointer", () =>
  within(
    async (pool) => {
      for (const [scenario, options, settings, expected] of /** @type {[any, any, any, object][]} */ ([
        [{ ...disc, robot: { type: "disc", radius: -1 } }, {}, {}, { code: "out-of-range", pointer: "/robot/radius" }],
        ["{", {}, {}, { code: "invalid-json" }],
        [arm, { algorithm: "prm", k: -1 }, {}, { code: "out-of-range", pointer: "/k" }],
        [arm, { improveIteration: 1 }, {}, { code: "unknown-parameter", pointer: "/improveIteration" }],
        [
          arm,
          {
            get seed() {
              throw new Error("unreadable");
            },
          },
          {},
          { code: "wrong-type", message: /unreadable/ },
        ],
        [() => arm, {}, {}, { code: "wrong-type" }],
        [arm, { seed: () => 1 }, {}, { code: "wrong-type", pointer: "/seed" }],
        [arm, {}, { budget: () => 8 }, { code: "wrong-type", pointer: "/budget" }],
        [arm, {}, 8, { code: "wrong-type", message: /settings must be an object/ }],
        [arm, {}, new AbortController().signal, { code: "wrong-type", message: /AbortSignal/ }],
        [
          new Problem({ space: { coordinates: [{ kind: "circle" }] }, start: [0], goal: [1], isFree() {} }),
          {},
          {},
          { code: "unsupported", message: /module/ },
        ],
        [{ space: {}, isFree() {} }, {}, {}, { code: "unsupported", message: /module/ }],
        [{ module: "./robot.js" }, {}, {}, { code: "wrong-type", pointer: "/module", message: /import\.meta\.url/ }],
        [{ module: "data:text/javascript,", export: 1 }, {}, {}, { code: "wrong-type", pointer: "/export" }],
        [
          { module: "data:text/javascript,", arguments: [() => 1] },
          {},
          {},
          { code: "wrong-type", pointer: "/arguments" },
        ],
        [{ module: "data:text/javascript,", name: "x" }, {}, {}, { code: "unknown-field", pointer: "/name" }],
        [
          { module: "file:///missing.mjs" },
          {},
          {},
          { code: "module-failed", pointer: "/module", message: /missing\.mjs/ },
        ],
        [
          { module: "data:text/javascript,export const a = 1, b = 2", export: "c" },
          {},
          {},
          { code: "module-failed", pointer: "/export", message: /"c"; it has a, b/ },
        ],
        [
          { module: "data:text/javascript,export default { start: [0] }" },
          {},
          {},
          { code: "missing-field", pointer: "/space" },
        ],
        [arm, {}, { budget: NaN }, { code: "not-finite", pointer: "/budget" }],
        [arm, {}, { signal: new AbortController() }, { code: "wrong-type", pointer: "/signal" }],
        [arm, {}, { onProgress: 1 }, { code: "wrong-type", pointer: "/onProgress" }],
        [arm, {}, { bugdet: 1 }, { code: "unknown-field", pointer: "/bugdet" }],
      ])) {
        await assert.rejects(pool.plan(scenario, options, settings), (error) => {
          assert.ok(error instanceof PlanariumError);
          const { code, pointer, message } = error;
          for (const [name, value] of Object.entries(expected)) {
            if (name === "message") assert.match(message, value);
            else assert.equal({ code, pointer }[name], value, message);
          }
          return true;
        });
      }
      assert.equal((await pool.plan(arm)).status, "solved");
      assert.throws(() => new PlannerPool({ workers: 0 }), { code: "out-of-range", pointer: "/workers" });
      for (const wrong of /** @type {any[]} */ ([4, "4", [4], new Map([["workers", 4]])]))
        assert.throws(() => new PlannerPool(wrong), { name: "PlanariumError", code: /wrong-type|unknown-field/ });
      assert.throws(() => new PlannerPool(/** @type {any} */ ({ worker: null, threads: 1 })), {
        code: "unknown-field",
        pointer: "/threads",
      });
    },
    { workers: 1 },
  ));

test("a core or a worker that is lost ends its runs as internal, and the next run has a new worker", async () => {
  const trap = `const { initSync } = await import(${JSON.stringify(`${place}/planarium_glue.js`)});
    parentPort.on("message", (message) => { if ("given" in message && message.given.options?.seed === 13) setTimeout(() => new Uint8Array(initSync().memory.buffer).fill(0xff)); });`;
  const exit = `parentPort.on("message", (message) => { if (message.given?.options?.seed === 13) process.exit(7); });`;
  for (const [code, message] of /** @type {const} */ ([
    [trap, /Planarium/],
    [exit, /exit code 7/],
  ])) {
    await within(
      async (pool) => {
        assert.equal((await pool.plan(arm)).status, "solved");
        const runs = [pool.plan(arm, long), pool.plan(arm, { ...long, seed: 13 })];
        for (const run of runs) await assert.rejects(run, { name: "PlanariumError", code: "internal", message });
        assert.equal((await pool.plan(arm)).status, "solved");
      },
      { workers: 1, worker: workerOf(code) },
    );
  }
});

test("a worker or a core that cannot be loaded is an error, and is tried again", async () => {
  let isMissing = true;
  const worker = () => new Worker(isMissing ? new URL("file:///missing.mjs") : new URL(`${place}/worker-entry.js`));
  await within(
    async (pool) => {
      await assert.rejects(pool.plan(arm), { code: "init-failed", message: /missing\.mjs/ });
      isMissing = false;
      assert.equal((await pool.plan(arm)).status, "solved");
    },
    { worker },
  );
  for (const core of [new Uint8Array(8), () => {}])
    await within((pool) => assert.rejects(pool.plan(arm), { code: "init-failed" }), { core });
  await within((pool) => assert.rejects(pool.plan(arm), { code: "init-failed", message: /none/ }), {
    worker: () => {
      throw new Error("none");
    },
  });
});

test("a method without its pool is refused", () =>
  within(async (pool) => {
    const { plan, growth, terminate } = pool;
    for (const self of /** @type {any[]} */ ([undefined, null, 5, {}, PlannerPool.prototype, new Proxy(pool, {})])) {
      await assert.rejects(plan.call(self, arm), { name: "PlanariumError", code: "illegal-invocation" });
      await assert.rejects(growth.call(self, arm).next(), { code: "illegal-invocation" });
      assert.throws(() => terminate.call(self), { code: "illegal-invocation" });
      assert.throws(() => pool[Symbol.dispose].call(self), { code: "illegal-invocation" });
    }
    assert.equal((await pool.plan(arm)).status, "solved");
  }));

test("terminate ends what runs, in the middle of a slice too, and there is no further run", async () => {
  const pool = new PlannerPool();
  const runs = [pool.plan(arm, long, { budget: 1e9 }), pool.plan(arm, long)];
  pool[Symbol.dispose]();
  for (const run of [...runs, pool.plan(arm)]) await assert.rejects(run, { name: "PlanariumError", code: "freed" });
});

test("a remote planner has the bits of a local one, however it is stepped, also where two share a worker", () =>
  within(
    async (pool) => {
      const cases = /** @type {[ScenarioDocument, PlannerOptions, (number | [number, number])[]][]} */ ([
        [arm, { algorithm: "prm", seed: 6, k: 5 }, [1, 7, 100, 0]],
        [arm, { algorithm: "rrt-star", seed: 2, improveIterations: 200 }, [[1e6, 1]]],
        [disc, { algorithm: "rrt-connect", seed: 3 }, [3, [64, 0]]],
        [car, { algorithm: "rrt-control", seed: 1, maxIterations: 300 }, [[100, 1], 40]],
      ]);
      await Promise.all(
        cases.map(async ([document, options, steps]) => {
          const local = Scenario.parse(document).planner(options);
          local.record();
          finish(local);
          const planner = await pool.planner(document, options);
          for (const width of /** @type {const} */ (["dimension", "eventWidth", "historyWidth"]))
            assert.equal(planner[width], local[width]);
          await planner.record();
          /** @type {Record<string, number[]>} */
          const grown = { vertices: [], edges: [], events: [], traces: [], motions: [], history: [] };
          let made = 0;
          for (let turn = 0, status = "running"; status === "running"; turn++) {
            const [iterations, budget] = [steps[turn % steps.length]].flat();
            const growth = await planner.step(iterations, { budget });
            for (const [name, rows] of Object.entries(grown)) rows.push(...Reflect.get(growth, name));
            assert.ok(growth.iterations - made <= iterations);
            if (budget !== undefined && growth.status === "running")
              assert.ok(growth.iterations > made, "one at least");
            else if (growth.status === "running") assert.equal(growth.iterations - made, iterations);
            assert.equal(growth.result === null, growth.status === "running");
            ({ status, iterations: made } = growth);
          }
          for (const [name, rows] of Object.entries(grown)) {
            const key = /** @type {"verticesSince"} */ (`${name}Since`);
            assert.deepEqual(rows, [...local[key](0)], name);
          }
          assert.equal(await planner.fingerprint(), local.fingerprint());
          assert.deepEqual(await planner.path(), local.path());
          assert.deepEqual(await planner.historySince(made - 1), local.historySince(made - 1));
          assert.deepEqual(untimed(await planner.result()), untimed(local.result()));
          assert.equal((await planner.stats()).configuration_checks, local.stats().configuration_checks);
          assert.equal((await planner.step(5)).iterations, made, "none once the run has ended");
          planner.free();
        }),
      );
    },
    { workers: 1, worker: workerOf(transferred) },
  ));

test("a remote planner asks its roadmap, and rejects with the errors of a local one", () =>
  within(
    async (pool) => {
      const options = /** @type {const} */ ({ algorithm: "prm", seed: 6, k: 5 });
      const local = finish(Scenario.parse(arm).planner(options));
      const planner = await pool.planner(arm, options);
      await planner.step(Number.MAX_SAFE_INTEGER);
      const [start, goal] = [
        [0, 0],
        [2, 0.5],
      ];
      assert.deepEqual(untimed(await planner.query(goal, start)), untimed(local.query(goal, start)));
      const rrt = await pool.planner(arm, { algorithm: "rrt" });
      const other = Scenario.parse(arm).planner({ algorithm: "rrt" });
      await rrt.step(1);
      other.step(1);
      for (const [remote, own] of /** @type {[() => Promise<unknown>, () => unknown][]} */ ([
        [() => planner.query([0], goal), () => local.query([0], goal)],
        [() => planner.query([NaN, 0], goal), () => local.query([NaN, 0], goal)],
        [() => rrt.query(start, goal), () => other.query(start, goal)],
        [() => rrt.record(), () => other.record()],
        [() => rrt.historySince(2), () => other.historySince(2)],
        ...[-1, 2.5, NaN, Infinity, /** @type {any} */ ("2")].map((n) => [() => rrt.step(n), () => other.step(n)]),
        [
          () => pool.planner(arm, { algorithm: "prm", k: -1 }),
          () => Scenario.parse(arm).planner({ algorithm: "prm", k: -1 }),
        ],
      ])) {
        /** @type {unknown} */
        let expected;
        assert.throws(own, (error) => Boolean((expected = error)));
        const { name, code, pointer, message } = /** @type {PlanariumError} */ (expected);
        await assert.rejects(remote(), { name, code, pointer, message });
      }
      for (const [wrong, expected] of /** @type {[() => Promise<unknown>, object][]} */ ([
        [() => rrt.step(1, { budget: -1 }), { code: "out-of-range", pointer: "/budget" }],
        [() => rrt.step(1, /** @type {any} */ ({ bugdet: 1 })), { code: "unknown-field", pointer: "/bugdet" }],
        [() => rrt.query(/** @type {any} */ (() => start), goal), { code: "wrong-type" }],
        [() => rrt.path.call(/** @type {any} */ ({})), { code: "illegal-invocation" }],
        [() => pool.planner(arm, {}, /** @type {any} */ ({ budget: 1 })), { code: "unknown-field" }],
        [() => pool.planner(arm, {}, /** @type {any} */ ({ signal: 1 })), { code: "wrong-type", pointer: "/signal" }],
      ]))
        await assert.rejects(wrong(), { name: "PlanariumError", ...expected });
      assert.equal((await rrt.step(1)).iterations, 2, "an error ends no run");
    },
    { workers: 1 },
  ));

test("a signal or free ends a remote planner in the middle of a step, and the worker goes on with others", async () => {
  /** @type {any[]} */
  const sent = [];
  await within(
    async (pool) => {
      const other = await pool.planner(arm, { algorithm: "prm" });
      const controller = new AbortController();
      const aborted = await pool.planner(arm, long, { signal: controller.signal });
      const enough = new RangeError("enough");
      const [step, query] = [aborted.step(Number.MAX_SAFE_INTEGER), aborted.path()];
      assert.equal((await other.step(10)).iterations, 10, "it has its turn meanwhile");
      controller.abort(enough);
      for (const call of [step, query, aborted.result()]) await assert.rejects(call, enough);
      await assert.rejects(pool.planner(arm, long, { signal: controller.signal }), enough);
      const freed = await pool.planner(arm, long);
      const waiting = freed.step(Number.MAX_SAFE_INTEGER);
      freed[Symbol.dispose]();
      freed.free();
      for (const call of [waiting, freed.step(1)])
        await assert.rejects(call, { name: "PlanariumError", code: "freed" });
      assert.equal((await other.step(5)).iterations, 15);
      assert.equal(sent.filter(({ isOver }) => isOver).length, 2);
      pool.terminate();
      await assert.rejects(other.step(1), { code: "freed" });
    },
    { workers: 1, worker: workerOf("", sent) },
  );
});

test("a lost worker fails its remote planners as internal, and the next one has a new worker", () =>
  within(
    async (pool) => {
      const planner = await pool.planner(arm, long);
      const step = planner.step(Number.MAX_SAFE_INTEGER);
      const killer = pool.planner(arm, { seed: 13 });
      for (const call of [step, killer, step.catch(() => planner.path())])
        await assert.rejects(call, { name: "PlanariumError", code: "internal", message: /exit code 7/ });
      planner.free();
      const again = await pool.planner(arm, { seed: 1 });
      assert.equal((await again.step(1)).iterations, 1);
    },
    {
      workers: 1,
      worker: workerOf(
        `parentPort.on("message", (message) => { if (message.given?.options?.seed === 13) process.exit(7); });`,
      ),
    },
  ));

test("for await over a planner is its growth", async () => {
  const planner = Scenario.parse(arm).planner({ seed: 2 });
  let edges = 0;
  for await (const growth of planner) edges += growth.edges.length / 2;
  assert.equal(planner.status, "solved");
  assert.equal(edges, planner.edgeCount);
});

test("in Chromium: several runs, progress, a signal, a core given by its address, an error", async () => {
  const site = emptyFolder();
  cpSync(join(root, "dist", "package"), join(site, "package"), { recursive: true });
  cpSync(join(site, "package", "planarium_bg.wasm"), join(site, "elsewhere.wasm"));
  addFiles(site, { "index.html": "<!doctype html><title>workers</title>" });
  const server = await serve({ root: site, port: 0 });
  const browser = await chromium.launch({ executablePath: (await ensureBrowser()).chromium, args: ["--no-sandbox"] });
  try {
    const page = await browser.newPage();
    await page.goto(server.url);
    const found = await page.evaluate(`(async () => {
      const { PlannerPool } = await import("./package/worker.js");
      const [arm, long] = ${JSON.stringify([arm, long])};
      const [pool, other] = [new PlannerPool(), new PlannerPool({ workers: 1, core: new URL("elsewhere.wasm", location) })];
      let slices = 0;
      const results = await Promise.all([1, 2, 3].map((seed) => pool.plan(arm, { seed }, { onProgress: () => { slices += 1; } })));
      const controller = new AbortController();
      const caught = [];
      for (const [settings, options] of [[{ signal: controller.signal, onProgress: () => controller.abort("enough") }, long], [{}, { k: -1, algorithm: "prm" }]]) {
        await pool.plan(arm, options, settings).catch((error) => caught.push(error.pointer ?? error));
      }
      const { fingerprint } = await other.plan(arm, { seed: 1 });
      await new PlannerPool({ core: "missing.wasm" }).plan(arm).catch(({ code, message }) => caught.push(code, message));
      pool.terminate();
      other.terminate();
      return { fingerprints: [...results.map((result) => result.fingerprint), fingerprint], caught, slices };
    })()`);
    const {
      fingerprints,
      caught: [reason, pointer, code, message],
      slices,
    } = /** @type {any} */ (found);
    assert.deepEqual(
      fingerprints,
      [1, 2, 3, 1].map((seed) => finish(Scenario.parse(arm).planner({ seed })).fingerprint()),
    );
    assert.deepEqual([reason, pointer, code], ["enough", "/k", "init-failed"]);
    assert.match(message, /404/);
    assert.ok(slices >= 6, `${slices} slices`);
  } finally {
    await browser.close();
    await server.close();
  }
});
