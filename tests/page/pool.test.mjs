/** The pool of workers that share jobs: lost workers, pauses, failures. No browser. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Jobs, Pool } from "../../www/app/pool.js";

Object.defineProperty(globalThis, "navigator", { value: { hardwareConcurrency: 4 }, configurable: true });

const never = new AbortController().signal;
const coded = Object.assign(new Error("refused"), { code: "out-of-range" });

/** A pool of workers that are letters. @returns {Pool<string>} */
function letters() {
  const others = ["b", "c"];
  return new Pool("a", () => others.shift() ?? assert.fail("one processor is left to the page"));
}

/** Lets other workers act. */
const turn = () => new Promise((resolve) => setImmediate(resolve));

test("jobs are shared by one worker fewer than processors, and by no more than there are jobs", async () => {
  const pool = letters();
  /** @type {[string, number][]} */
  const acts = [];
  const act = async (/** @type {string} */ worker, /** @type {number} */ job) => {
    acts.push([worker, job]);
    await turn();
  };
  await pool.run(new Jobs([0, 1]), never, act);
  assert.deepEqual(pool.workers, ["a", "b"]);
  await pool.run(new Jobs([2, 3, 4, 5]), never, act);
  assert.deepEqual(pool.workers, ["a", "b", "c"]);
  assert.deepEqual(acts.slice(0, 5), [
    ["a", 0],
    ["b", 1],
    ["a", 2],
    ["b", 3],
    ["c", 4],
  ]);
  assert.deepEqual(acts[5][1], 5);
});

test("the job of a lost worker is done by another one, also if the others had nothing left; the last one's error is thrown", async () => {
  const pool = letters();
  const done = new Set();
  let isLate = false;
  await pool.run(new Jobs([0, 1, 2]), never, async (worker, job) => {
    // It is lost once the others have ended.
    if (worker === "a") {
      while (done.size < 2) await turn();
      await turn();
      isLate = true;
      throw new Error("lost");
    }
    assert.ok(!isLate || job === 0);
    done.add(job);
  });
  assert.deepEqual(done, new Set([0, 1, 2]));
  assert.deepEqual([pool.workers, pool.most], [["b", "c"], 2]);
  const jobs = new Jobs([3, 4, 5]);
  await assert.rejects(
    pool.run(jobs, never, async () => {
      throw new Error("lost");
    }),
    /lost/,
  );
  assert.equal(pool.workers.length, 1);
  assert.deepEqual(jobs.left.sort(), [3, 4, 5], "nothing is done, and nothing is forgotten");
});

test("an error with a code ends the run once all workers have stopped; jobs stay, and no worker is dropped", async () => {
  const pool = letters();
  pool.held.set("a", undefined);
  const jobs = new Jobs([0, 1, 2, 3, 4, 5]);
  /** @type {number[]} */
  const done = [];
  await assert.rejects(
    pool.run(jobs, never, async (_, job) => {
      if (job === 0) throw coded;
      await turn();
      done.push(job);
    }),
    coded,
  );
  assert.deepEqual(done, [1, 2]);
  assert.deepEqual(jobs.left, [0, 3, 4, 5]);
  assert.equal(pool.workers.length, 3);
  assert.ok(!pool.held.has("a"), "what it holds is unknown");
});

test("after a pause each worker goes on with its job; a lost worker's is taken over", async () => {
  const pool = letters();
  const jobs = new Jobs([0, 1, 2, 3]);
  const pause = new AbortController();
  await pool.run(jobs, pause.signal, async () => {
    pause.abort();
    return false;
  });
  assert.deepEqual([...jobs.begun], [["a", 0]]);
  assert.equal(jobs.count, 4);
  /** @type {Map<number, string>} */
  const by = new Map();
  const again = new AbortController();
  await pool.run(jobs, again.signal, async (worker, job) => {
    await turn();
    by.set(job, worker);
    if (by.size === 3) again.abort();
    return false;
  });
  assert.deepEqual(
    by,
    new Map([
      [0, "a"],
      [1, "b"],
      [2, "c"],
    ]),
  );
  pool.drop("b");
  await pool.run(jobs, never, async (worker, job) => {
    by.set(job, worker);
  });
  assert.equal(by.get(0), "a");
  assert.equal(by.get(2), "c");
  assert.notEqual(by.get(1), "b");
  assert.equal(jobs.count, 0);
});
