/** The keyboard car without a page: time that no frame decides, and Euler's steps beside the arc. */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Driving } from "../../www/planner/driving/driving.js";
import { ROAD, scenario } from "./road.mjs";

/** @import { DriveKey } from "planarium" */
/** @import { Session } from "../../www/planner/session.js" */

/** When the tests of time begin, in milliseconds. */
const from = 1e12;

/**
 * A drive that begins at `from`, with what it needs of a session.
 * @param {boolean} [byKeys]  time passes with keys alone
 */
function begun(byKeys = false) {
  const document = scenario.document();
  const { start, goal } = document.queries[0];
  const shown = {
    scenario,
    document,
    query: "home",
    start,
    goal,
    hand: null,
    check: null,
    driven: null,
    placed: { isNear: () => false },
  };
  const session = { shown, wake() {}, timeline: { pause() {} }, byHand: { release() {}, game: {} } };
  const driving = new Driving(/** @type {Session} */ (/** @type {unknown} */ (session)));
  driving.start(byKeys, from);
  return driving;
}

describe("time", () => {
  /** Moments of keys, milliseconds. @type {[number, DriveKey][]} */
  const keys = [
    [3, "faster"],
    [111.4, "faster"],
    [127, "left"],
    [600.01, "faster"],
    [640, "right"],
    [641, "right"],
    [1234.5, "slower"],
    [1802, "left"],
  ];

  /**
   * Drives for two seconds.
   * @param {number} rate  frames a second
   * @param {number} [late]  milliseconds after which a key is heard
   */
  function driven(rate, late = 0) {
    const driving = begun();
    /** @type {[number, () => void][]} */
    const happens = keys.map(([at, key]) => [at + late, () => driving.press(key, from + at)]);
    for (let frame = 1; frame <= 2.2 * rate; frame++)
      happens.push([(1000 * frame) / rate, () => driving.pass(from + (1000 * frame) / rate)]);
    happens.sort(([a], [b]) => a - b);
    for (const [, then] of happens) then();
    driving.pause(from + 2030);
    assert.ok(driving.state && driving.state.blocked === null);
    return { state: driving.state, trace: [...driving.trace], record: driving.record()?.record ?? [] };
  }

  test("the same keys lead to the same bits at 30, 60, 120 and 144 frames a second", () => {
    const slow = driven(30);
    assert.ok(slow.trace.length > 3 * 150);
    for (const rate of [60, 120, 144]) assert.deepEqual(driven(rate), slow, `${rate} frames a second`);
  });

  test("a key that is heard late counts from its moment all the same", () => {
    assert.deepEqual(driven(60, 25), driven(60));
  });

  test("a pose after two seconds is that of the package's drive by the same keys, one step after the other", () => {
    const { state, record } = driven(60);
    assert.equal(record.length, keys.length);
    const direct = scenario.drive();
    for (const { step, key } of record) {
      direct.tick(step - direct.state.steps);
      direct.press(key);
    }
    assert.deepEqual(direct.tick(state.steps - direct.state.steps).pose, state.pose);
  });

  test("a page that nobody saw for a while has not driven on meanwhile", () => {
    const driving = begun();
    driving.press("faster", from);
    driving.pass(from + 16);
    driving.pass(from + 60_000);
    assert.ok(driving.state && driving.state.steps < 30, `${driving.state?.steps}`);
  });

  test("by keys alone, each takes a quarter of a second", () => {
    const driving = begun(true);
    driving.press("faster", from);
    driving.pass(from + 5000);
    driving.press("keep", from + 6000);
    assert.deepEqual([driving.state?.steps, driving.moves], [50, false]);
  });

  test("while the car rests no time goes by: a recording begins with its first key", () => {
    const driving = begun();
    driving.press("faster", from + 8000);
    driving.pass(from + 8130);
    assert.deepEqual([driving.state?.steps, driving.record()?.record], [10, [{ step: 0, key: "faster" }]]);
  });

  test("a recording is replayed in its own time to the same bits, and shown at any part of it", () => {
    const driving = begun();
    for (const [at, key] of keys) driving.press(key, from + at);
    driving.pass(from + 2030);
    const { state, trace } = driving;
    const recording = /** @type {{ record: import("planarium").KeyPress[], steps: number }} */ (driving.record());
    const again = /** @type {NonNullable<ReturnType<typeof driving.again>>} */ (driving.again());
    assert.ok(state && Math.abs(again.seconds - recording.steps * scenario.drive().stepSeconds) < 1e-12);
    for (const part of [0, 0.5, 1, 0.25, 1]) {
      const { pose, driven } = again.at(part);
      const direct = scenario.drive().replay(recording.record, Math.round(part * recording.steps));
      assert.deepEqual([[...pose], driven.steering], [direct.pose, direct.phi]);
    }
    assert.deepEqual([...again.at(0).pose], ROAD.queries?.[0].start);
    again.free();
    driving.replay(from, recording);
    driving.pass(from + 16);
    assert.ok(driving.tape && driving.state && driving.state.steps < recording.steps);
    for (let at = 100; at < 4000; at += 100) driving.pass(from + at);
    assert.deepEqual([driving.tape, driving.state?.pose, driving.trace], [null, state.pose, trace]);
  });

  test("while it is paused no time goes by; C goes on", () => {
    const driving = begun();
    driving.press("faster", from);
    driving.pass(from + 130);
    driving.pause(from + 130);
    assert.deepEqual([driving.state?.steps, driving.moves], [10, false]);
    driving.press("keep", from + 5000);
    driving.pass(from + 5130);
    assert.deepEqual([driving.state?.steps, driving.paused], [20, false]);
  });
});

describe("Euler's steps beside the arc", () => {
  /** @param {Driving} driving @returns {NonNullable<Driving["beside"]>} */
  const besideOf = ({ beside }) => beside ?? assert.fail("they are drawn");

  test("they belong to the control shown, else to the control held since it was changed", () => {
    const driving = begun(true);
    driving.setEuler(0.25);
    assert.ok(!driving.beside, "nothing moves");
    for (const key of /** @type {const} */ (["faster", "left", "keep"])) driving.press(key, from);
    // Held for half a second.
    const held = [...driving.trace.slice(-3 * 51)];
    const { poses, apart } = besideOf(driving);
    assert.deepEqual(poses.slice(0, 3), Float64Array.from(held.slice(0, 3)));
    // A step goes straight on along the heading of its start, for a quarter of a second at 0.1 m/s.
    assert.equal(poses.length, 9);
    const theta = poses[2];
    const [dx, dy] = [poses[3] - poses[0], poses[4] - poses[1]];
    assert.ok(Math.hypot(dx - 0.025 * Math.cos(theta), dy - 0.025 * Math.sin(theta)) < 1e-12);
    const [[x, y], [toX, toY]] = [held, [...poses]].map((rows) => rows.slice(-3));
    assert.ok(apart === Math.hypot(toX - x, toY - y) && apart > 1e-4, `${apart}`);
    driving.roll(0.4, 0.5, 1);
    const shown = scenario.rollout(driving.state?.pose ?? [], 0.4, 0.5, 1, { integration: "euler", dt: 0.25 });
    assert.deepEqual(besideOf(driving).poses, shown.poses);
    driving.setEuler(0);
    assert.ok(!driving.beside);
    assert.equal(driving.announcement, "Free for all 1.00 s.");
  });

  test("the gap falls with the step, and is unknown where they touch something", () => {
    const driving = begun();
    driving.roll(0.4, 0.5, 1.5);
    const gaps = [0.5, 0.25, 0.1, 0.01].map((dt) => {
      driving.setEuler(dt);
      return Number(besideOf(driving).apart) / dt;
    });
    assert.ok(
      gaps.every((gap) => Math.abs(gap / gaps[3] - 1) < 0.05),
      `${gaps}`,
    );
    // The arc turns away from the wall; a step of half a second goes straight into it.
    driving.start(false, from, [1.17, 0.5, 0]);
    driving.setEuler(0.5);
    driving.roll(0.5, 0.7, 1);
    assert.ok(driving.rollout?.blocked === null && besideOf(driving).apart === null, `${driving.announcement}`);
    assert.match(driving.announcement, /touches something before that/);
  });
});
