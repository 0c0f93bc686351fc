/** The state that a link stores; numbers are stored in full, so that a run is the same to the last bit. */
import { flag, json, list, name, number, oneOf, record, rule, settings, whole, withDefaults } from "../formats/rules.js";
import { SCENES, documentOf } from "./scenes.js";

/** @import { Point, ScenarioDocument } from "../domain/types.js" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { ArmRobot } from "./arm.js" */
/** @import { IkPanel } from "./ik-panel.js" */
/** @import { ArmSession, Mode } from "./session.js" */

/** Iterations at most, as in the core. */
const MOST_STEPS = 200_000;
const angles = list(number, 1, 8);
const pair = /** @type {Rule<Point>} */ (list(number, 2, 2));

export const stateRule = withDefaults({
  // A built-in scene or a world, and what differs from the scene: the arm, and whether its joint limits are off.
  scene: name, world: /** @type {Rule<ScenarioDocument["world"]>} */ (record({}, json(8))),
  robot: record({ type: name, base: pair, links: list(number, 1, 8), radius: number, joint_limits: list(pair, 1, 8) }), free: flag,
  // The configuration, in inverse kinematics that of the start.
  q: angles, mode: oneOf(/** @type {Mode[]} */ (["hand", "between", "solve"])),
  // The motion from A to B: joints that turn the long way round, and the progress.
  a: angles, b: angles, long: list(whole(7), 0, 8), along: /** @type {Rule<number>} */ (rule((value) => typeof value === "number" && value >= 0 && value <= 1)),
  // The fixed orientation, and inverse kinematics: its settings and iterations.
  lock: number, target: pair, solve: settings, steps: whole(MOST_STEPS),
}, { q: [], robot: {}, free: false, mode: "hand", long: [], along: 0, solve: {}, steps: 0 });

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */

/** @param {ArmSession} session @param {IkPanel} ik @returns {State} */
export function stateOf(session, ik) {
  const { arm: { robot, q, document: { world } }, entry, mode, a, b, directions, progress, orientation, target, run } = session;
  const scene = /** @type {Record<string, unknown>} */ (entry ? { type: "arm", radius: 0, ...entry.robot } : {});
  return {
    ...(entry ? { scene: entry.id } : { world }),
    robot: Object.fromEntries(Object.entries(robot).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(scene[key]))),
    free: Boolean(entry?.robot.joint_limits && !robot.joint_limits),
    q: Array.from(mode === "solve" ? ik.start : q), mode, a: Array.from(a), b: Array.from(b),
    long: directions.flatMap((direction, i) => (direction === "long" ? [i] : [])), along: mode === "between" ? progress : 0,
    lock: orientation ?? undefined, target, solve: { method: ik.method.id, ...ik.given }, steps: run?.run.iterations ?? 0,
  };
}

/** @param {ArmSession} session @param {IkPanel} ik @param {State} state @throws {Error} there is no such scene, or the core refuses it */
export function openState(session, ik, { scene, world, robot, free, q, mode, a, b, long, along, lock, target, solve: { method, ...given }, steps }) {
  if (typeof method === "string") ik.choose(method, given);
  const entry = SCENES.find(({ id }) => id === scene);
  if (scene && !entry) throw new Error(`There is no scene "${scene}".`);
  if (entry) {
    session.openScene(entry);
    const changed = /** @type {ArmRobot} */ ({ type: "arm", ...entry.robot, ...robot });
    if (free) delete changed.joint_limits;
    if (free || Object.keys(robot).length > 0) session.changeArm({ ...documentOf(entry), robot: changed });
  } else {
    session.openDocument(/** @type {ScenarioDocument} */ ({ format: "planarium-scenario-1", name: "link", title: "From a link", world, robot: { type: "arm", ...robot }, queries: [] }));
  }
  const { arm } = session;
  if (a) session.a = arm.fitted(a);
  if (b) session.b = arm.fitted(b);
  session.directions = arm.joints.map(({ isCircle }, i) => (isCircle && long.includes(i) ? "long" : "short"));
  if (target) session.target = target;
  if (lock !== undefined && arm.dimension > 2) session.orientation = lock;
  session.setMode(mode);
  session.progress = along;
  session.moveTo(q);
  if (mode === "solve" && steps > 0) ik.advance(steps);
}
