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

test("a drive starts at rest at the start of the first query, or where it is told to", () => {
  assert.deepEqual(drive().state, { pose: [0.5, 0.5, 0], v: 0, phi: 0, steps: 0, seconds: 0, blocked: null, traceCount: 1, keyCount: 0 });
  assert.deepEqual(Scenario.parse(car).drive([1, 1.5, 7]).state.pose, [1, 1.5, 7 - 2 * Math.PI]);
  assert.equal(drive().stepSeconds, 0.01);
});

test("keys change v by 0.1 and phi by pi / 12, within the limits of the car", () => {
  const one = press(drive(), "faster", "faster", "faster", "left", "keep");
  assert.deepEqual([one.state.v, one.state.phi, one.state.keyCount], [0.3, Math.PI / 12, 5]);
  press(one, "faster", "faster", "faster", "left", "left", "left", "left");
  assert.deepEqual([one.state.v, one.state.phi], [0.5, Math.PI / 4]);
  press(one, "right", "right", "right", "slower");
  assert.deepEqual([one.state.v, one.state.phi], [0.4, 0]);
});

test("the same keys at 30 and at 120 pictures a second lead to the same pose, bit for bit", () => {
  /** @type {Record<number, DriveKey>} */
  const keys = { 0: "faster", 20: "faster", 40: "left", 100: "right", 120: "right", 160: "faster" };
  /** @param {number} rate  pictures a second */
  const at = (rate) => {
    const one = drive();
    for (let picture = 1; picture <= 2 * rate; picture++) {
      // A fixed step: as many of them as have become due.
      const due = Math.floor((picture / rate) * 100 + 1e-9);
      while (one.state.steps < due) {
        const { steps } = one.state;
        if (keys[steps]) one.press(keys[steps]);
        one.tick(1);
      }
    }
    return [...one.traceSince(0)];
  };
  const slow = at(30);
  assert.equal(slow.length, 3 * 201);
  assert.deepEqual(at(120), slow);
  assert.deepEqual(at(60), slow);
});

test("it stops at what is in its way, says which, and backs off", () => {
  const one = press(drive(), "faster", "faster", "faster", "faster", "faster");
  const stopped = one.tick(500);
  assert.deepEqual([stopped.blocked, stopped.v, stopped.steps, stopped.seconds], [1, 0, 500, 5]);
  assert.ok(stopped.pose[0] > 1.39 && stopped.pose[0] < 1.4);
  assert.equal(stopped.traceCount, one.traceSince(0).length / 3);
  assert.deepEqual([...one.traceSince(stopped.traceCount - 1)], [...stopped.pose]);
  assert.equal(one.traceSince(stopped.traceCount).length, 0);
  press(one, "slower", "slower", "slower", "slower", "slower");
  const back = one.tick(10);
  assert.equal(back.blocked, null);
  assert.ok(back.pose[0] < stopped.pose[0]);
  assert.equal(one.tick(1000).blocked, "bounds");
});

test("a record replays to the same bits, and as far as it is told to", () => {
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
  fails(() => other.replay(/** @type {any} */ (new Proxy([0, 0], { get() { throw undefined; } })), 1), "invalid-json");
  fails(() => other.replay([{ step: NaN, key: "left" }], 1), "not-finite", "/record/0/step");
  fails(() => other.replay(/** @type {any} */ ([{ get step() { throw new Error("hands off"); } }]), 1), "invalid-json");
});

test("a rollout holds one control, step by step, up to what it hits", () => {
  const scenario = Scenario.parse(car);
  const free = scenario.rollout([0.5, 0.5, 0], 0.5, Math.PI / 4, 1.005);
  assert.deepEqual([free.poses.length, free.seconds, free.blocked], [3 * 102, 1.005, null]);
  // The circle of radius L / tan(phi) = 0.2 about (0.5, 0.7).
  for (let i = 0; i < free.poses.length; i += 3) assert.ok(Math.abs(Math.hypot(free.poses[i] - 0.5, free.poses[i + 1] - 0.7) - 0.2) < 1e-12);
  const hit = scenario.rollout([0.5, 0.5, 0], 0.5, 0, 10);
  assert.equal(hit.blocked, 1);
  assert.ok(hit.seconds > 1.77 && hit.seconds < 1.81);
  fails(() => scenario.rollout([0.5, 0.5, 0], 0.6, 0, 1), "out-of-range", "/v");
  fails(() => scenario.rollout([0.5, 0.5, 0], 0.1, 2, 1), "out-of-range", "/phi");
  fails(() => scenario.rollout([0.5, 0.5, 0], 0.1, 0, -1), "out-of-range", "/duration");
  fails(() => scenario.rollout([0.5, 0.5, 0], NaN, 0, 1), "not-finite", "/v");
  fails(() => scenario.rollout([0.5, 0.5], 0.1, 0, 1), "wrong-dimension", "/q");
});

test("Euler's steps turn the circle of a rollout into a spiral", () => {
  const scenario = Scenario.parse(car);
  /** How far the last pose is from the circle. @param {"exact" | "euler"} integration @param {number} dt */
  const off = (integration, dt) => {
    const { poses, seconds } = scenario.rollout([0.5, 0.5, 0], 0.5, Math.PI / 4, 1, { integration, dt });
    assert.deepEqual([poses.length / 3, seconds], [Math.round(1 / dt) + 1, 1]);
    return Math.hypot(poses[poses.length - 3] - 0.5, poses[poses.length - 2] - 0.7) - 0.2;
  };
  assert.ok(Math.abs(off("exact", 0.1)) < 1e-12);
  assert.ok(off("euler", 0.1) > 0.01 && off("euler", 0.01) > 0.001 && off("euler", 0.01) < off("euler", 0.1) / 5);
  /** @param {any} options */
  const rolled = (options) => () => scenario.rollout([0.5, 0.5, 0], 0.1, 0, 1, options);
  fails(rolled({ integration: "heun" }), "out-of-range", "/integration");
  fails(rolled({ dt: 0 }), "out-of-range", "/dt");
  fails(rolled({ dt: NaN }), "not-finite", "/dt");
  fails(rolled({ step: 1 }), "unknown-field", "/step");
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
