/** The keyboard car and rollouts, as the package has them. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import { arm, car, fails } from "./scenes.mjs";

/** @import { Drive, DriveKey } from "planarium" */

const drive = () => Scenario.parse(car).drive();

/** @param {Drive} one @param {DriveKey[]} keys */
function press(one, ...keys) {
  for (const key of keys) one.press(key);
  return one;
}

test("a drive starts at rest at the start of the first query, or where the options say", () => {
  assert.deepEqual(drive().state, {
    pose: [0.5, 0.5, 0],
    v: 0,
    phi: 0,
    steps: 0,
    seconds: 0,
    blocked: null,
    traceCount: 1,
    keyCount: 0,
  });
  assert.deepEqual(Scenario.parse(car).drive([1, 1.5, 7]).state.pose, [1, 1.5, 7 - 2 * Math.PI]);
  assert.equal(drive().stepSeconds, 0.01);
});

test("its state names what it stops at, and its trace is read by a cursor", () => {
  const one = press(drive(), "faster", "faster", "faster", "faster", "faster");
  const stopped = one.tick(500);
  assert.deepEqual([stopped.blocked, stopped.v, stopped.steps, stopped.seconds], [1, 0, 500, 5]);
  assert.equal(stopped.traceCount, one.traceSince(0).length / 3);
  assert.deepEqual([...one.traceSince(stopped.traceCount - 1)], [...stopped.pose]);
  assert.equal(one.traceSince(stopped.traceCount).length, 0);
  press(one, "slower", "slower", "slower", "slower", "slower");
  assert.equal(one.tick(1000).blocked, "bounds");
});

test("a record replays to the same bits, and as far as the caller asks", () => {
  const one = press(drive(), "faster", "left");
  one.tick(30);
  press(one, "faster", "right", "right").tick(77);
  const record = one.record();
  assert.deepEqual(record[2], { step: 30, key: "faster" });
  const other = drive();
  assert.deepEqual(other.replay(record, 107), one.state);
  assert.deepEqual(other.traceSince(0), one.traceSince(0));
  assert.deepEqual(other.record(), record);
  assert.deepEqual([other.replay(record, 29).keyCount, other.replay([], 0).steps], [2, 0]);
  fails(() => other.replay([record[2], record[0]], 107), "out-of-range", "/record/1/step");
  fails(() => other.replay([{ step: -1, key: "left" }], 1), "out-of-range", "/record/0/step");
  fails(() => other.replay([{ step: 1, key: /** @type {any} */ ("jump") }], 1), "out-of-range", "/record/0/key");
  fails(() => other.replay(/** @type {any} */ ([null]), 1), "wrong-type", "/record/0");
  fails(() => other.replay(/** @type {any} */ ("left"), 1), "wrong-type", "/record");
  fails(
    () =>
      other.replay(
        /** @type {any} */ (
          new Proxy([0, 0], {
            get() {
              throw undefined;
            },
          })
        ),
        1,
      ),
    "invalid-json",
  );
  fails(() => other.replay([{ step: NaN, key: "left" }], 1), "not-finite", "/record/0/step");
  fails(
    () =>
      other.replay(
        /** @type {any} */ ([
          {
            get step() {
              throw new Error("hands off");
            },
          },
        ]),
        1,
      ),
    "invalid-json",
  );
});

test("a rollout has poses and seconds, and names what it hits", () => {
  const scenario = Scenario.parse(car);
  const free = scenario.rollout([0.5, 0.5, 0], 0.5, Math.PI / 4, 1.005);
  assert.deepEqual([free.poses.length, free.seconds, free.blocked], [3 * 102, 1.005, null]);
  assert.equal(scenario.rollout([0.5, 0.5, 0], 0.5, 0, 10).blocked, 1);
  fails(() => scenario.rollout([0.5, 0.5, 0], 0.6, 0, 1), "out-of-range", "/v");
  fails(() => scenario.rollout([0.5, 0.5, 0], 0.1, 2, 1), "out-of-range", "/phi");
  fails(() => scenario.rollout([0.5, 0.5, 0], 0.1, 0, -1), "out-of-range", "/duration");
  fails(() => scenario.rollout([0.5, 0.5, 0], NaN, 0, 1), "not-finite", "/v");
  fails(() => scenario.rollout([0.5, 0.5], 0.1, 0, 1), "wrong-dimension", "/q");
});

test("a rollout takes its integration and its step", () => {
  const scenario = Scenario.parse(car);
  const { poses, seconds } = scenario.rollout([0.5, 0.5, 0], 0.5, Math.PI / 4, 1, { integration: "euler", dt: 0.1 });
  assert.deepEqual([poses.length, seconds], [3 * 11, 1]);
  for (const [options, code, pointer] of /** @type {[any, string, string][]} */ ([
    [{ integration: "heun" }, "out-of-range", "/integration"],
    [{ dt: 0 }, "out-of-range", "/dt"],
    [{ dt: NaN }, "not-finite", "/dt"],
    [{ step: 1 }, "unknown-field", "/step"],
  ]))
    fails(() => scenario.rollout([0.5, 0.5, 0], 0.1, 0, 1, options), code, pointer);
});

test("what is wrong is refused", () => {
  fails(() => Scenario.parse(arm).drive(), "unsupported");
  fails(() => Scenario.parse(arm).rollout([0, 0], 0, 0, 1), "unsupported");
  fails(() => Scenario.parse({ ...car, queries: [] }).drive(), "unknown-query", "/q");
  fails(() => Scenario.parse(car).drive([1.5, 0.5, 0]), "start-in-collision", "/q");
  fails(() => Scenario.parse(car).drive([1, 1]), "wrong-dimension", "/q");
  const one = drive();
  for (const n of [-1, 0.5, 1_000_001]) fails(() => one.tick(n), "out-of-range", "/n");
  fails(() => one.tick(NaN), "not-finite", "/n");
  fails(() => one.press(/** @type {any} */ ("up")), "out-of-range", "/key");
  fails(() => one.press(/** @type {any} */ (1)), "wrong-type", "/key");
});
