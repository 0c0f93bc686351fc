/** The state that a link stores; numbers are stored in full, so that a run is the same to the last bit. */
import { withDefaults, flag, json, list, name, number, record, rule, settings, whole } from "../formats/rules.js";
import { SCENES } from "./scenes.js";
import { documentOf } from "./session.js";

/** @import { ArmSession } from "./session.js" */
/** @import { IkPanel } from "./ik-panel.js" */
/** @import { ArmRobot, Mode, Point, ScenarioDocument } from "./types.js" */

/**
 * @typedef {object} State
 * @property {string} [scene]    a built-in scene; without it `world` is given
 * @property {object} [world]
 * @property {Partial<ArmRobot>} robot   what differs from the scene
 * @property {boolean} free      without the joint limits of the scene
 * @property {number[]} q        the configuration; in inverse kinematics where the run starts
 * @property {Mode} mode
 * @property {number[]} [a]
 * @property {number[]} [b]
 * @property {number[]} long     joints that turn the long way round
 * @property {number} along      progress from A to B
 * @property {number} [lock]     the fixed orientation
 * @property {Point} [target]
 * @property {Record<string, number | string | boolean>} solve   settings of inverse kinematics
 * @property {number} steps      its iterations
 */

/** Iterations at most, as in the core. */
const MOST_STEPS = 200_000;
const angles = list(number, 1, 8);
const pair = list(number, 2, 2);

export const stateRule = withDefaults({
  scene: name, world: record({}, json(8)),
  robot: record({ type: name, base: pair, links: list(number, 1, 8), radius: number, joint_limits: list(pair, 1, 8) }),
  free: flag, q: angles, mode: rule((value) => ["hand", "between", "solve"].includes(String(value))),
  a: angles, b: angles, long: list(whole(7), 0, 8), along: rule((value) => typeof value === "number" && value >= 0 && value <= 1),
  lock: number, target: pair, solve: settings, steps: whole(MOST_STEPS),
}, { robot: {}, free: false, mode: "hand", long: [], along: 0, solve: {}, steps: 0 });

/** @param {ArmSession} session @param {IkPanel} ik @returns {State} */
export function stateOf(session, ik) {
  const { arm: { robot, q, document: { world } }, entry, mode, a, b, directions, progress, orientation, target } = session;
  const scene = /** @type {Record<string, unknown>} */ (entry ? { type: "arm", radius: 0, ...entry.robot } : {});
  return {
    ...(entry ? { scene: entry.id } : { world }),
    robot: Object.fromEntries(Object.entries(robot).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(scene[key]))),
    free: Boolean(entry?.robot.joint_limits && !robot.joint_limits),
    q: Array.from(mode === "solve" ? ik.start : q), mode, a: Array.from(a), b: Array.from(b),
    long: directions.flatMap((direction, i) => (direction === "long" ? [i] : [])), along: mode === "between" ? progress : 0,
    lock: orientation ?? undefined, target, solve: { method: ik.method.id, ...ik.given }, steps: mode === "solve" ? ik.run?.run.iterations ?? 0 : 0,
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
