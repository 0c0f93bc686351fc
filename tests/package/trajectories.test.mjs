/** Many trajectories through the package: what it takes, gives and refuses. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Trajectories, particlePoints, trajectoryOptions } from "planarium/full";
import { fails } from "./scenes.mjs";

test("trajectories are accepted one by one, and read by cursors", () => {
  const trajectories = new Trajectories({ seed: 3, count: 200 });
  assert.equal(trajectories.status, "running");
  assert.equal(trajectories.step(1), "running");
  assert.equal(trajectories.acceptedCount, 1, "the first one crosses nothing");
  assert.equal(trajectories.acceptedSince(0).length, 6);
  while (trajectories.step(37) === "running");
  assert.deepEqual([trajectories.status, trajectories.acceptedCount], ["solved", 200]);
  assert.equal(trajectories.step(100), "solved");
  const { iterations, refusedCount } = trajectories;
  assert.equal(iterations, 200 + refusedCount);
  const tries = trajectories.tries();
  assert.ok(tries instanceof Uint32Array && tries.length === 200);
  assert.equal(
    tries.reduce((sum, count) => sum + count, 0),
    iterations,
  );
  const rows = trajectories.acceptedSince(0);
  assert.deepEqual(trajectories.acceptedSince(150), rows.slice(900));
  for (let i = 0; i < rows.length; i += 6) {
    const [x, y, theta, v, w, duration] = rows.subarray(i, i + 6);
    assert.ok(
      Math.abs(x) <= 3 &&
        Math.abs(y) <= 3 &&
        Math.abs(theta) <= Math.PI &&
        v >= 0 &&
        v <= 1 &&
        Math.abs(w) <= Math.PI &&
        duration === 1,
    );
  }
  const refusals = trajectories.refusedSince(0);
  assert.equal(refusals.length, 9 * refusedCount);
  for (let i = 0; i < refusals.length; i += 9) assert.ok(refusals[i + 6] < 200 && Number.isInteger(refusals[i + 6]));
  const result = trajectories.result();
  assert.deepEqual(
    [result.accepted, result.refused, result.status, result.seed, result.model],
    [200, refusedCount, "solved", 3, "arc"],
  );
  assert.match(trajectories.fingerprint, /^[0-9a-f]{16}$/);
  assert.equal(trajectories.fingerprint, result.fingerprint);
});

test("options are an object of numbers and words", () => {
  for (const [given, code, pointer] of /** @type {[any, string, string][]} */ ([
    [7, "wrong-type", ""],
    [{ count: "many" }, "wrong-type", "/count"],
    [{ seed: -1 }, "out-of-range", "/seed"],
    [{ seed: "1" }, "wrong-type", "/seed"],
  ]))
    fails(() => new Trajectories(given), code, pointer);
});

test("the table tells every option", () => {
  const table = trajectoryOptions();
  assert.deepEqual(
    table.map(({ option }) => option),
    [
      "model",
      "count",
      "halfSide",
      "spread",
      "slowest",
      "fastest",
      "leastTurnRate",
      "greatestTurnRate",
      "duration",
      "index",
      "maxIterations",
    ],
  );
});

test("points of one particle are x and y in turn", () => {
  const [x, y] = particlePoints({ x: 1, y: 2, theta: 0, v: Math.PI, w: Math.PI }, new Float64Array([1]));
  assert.ok(Math.hypot(x - 1, y - 4) < 1e-15);
  assert.equal(particlePoints({}, []).length, 0);
  fails(() => particlePoints({ v: -1 }, [0]), "out-of-range", "/v");
  fails(() => particlePoints({ x: Infinity }, [0]), "not-finite", "/x");
  fails(() => particlePoints({}, [0, -1]), "out-of-range", "/times/1");
  fails(() => particlePoints({}, [NaN]), "not-finite", "/times/0");
  fails(() => particlePoints(/** @type {any} */ ({ speed: 1 }), [0]), "unknown-parameter", "/speed");
  fails(() => particlePoints({}, /** @type {any} */ ("now")), "wrong-type", "/times");
});
