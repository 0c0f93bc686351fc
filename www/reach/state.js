/** What is on the bench as a link holds it, and back: every number as it is, so that a run is the same to the last bit. */
import { flag, json, list, name, number, record, rule, settings, whole } from "../formats/rules.js";
import { documentOf } from "./bench.js";
import { SCENES } from "./scenes.js";

/** @import { Rule } from "../formats/rules.js" */
/** @import { Bench } from "./bench.js" */
/** @import { Solving } from "./solving.js" */
/** @import { ArmRobot, Mode, Point, ScenarioDocument } from "./types.js" */
/** @import { Round } from "./way.js" */

/**
 * @typedef {object} State
 * @property {string} [scene]    one of the page's own; where it is absent there is a world
 * @property {object} [world]    the reader's own
 * @property {Partial<ArmRobot>} robot   what is not as in the scene
 * @property {boolean} [free]    the scene's joints have stops, this arm's have none
 * @property {number[]} q
 * @property {Mode} mode
 * @property {number[]} [a]
 * @property {number[]} [b]
 * @property {number[]} [long]   joints that go the long way round
 * @property {number} [along]
 * @property {number} [lock]
 * @property {Point} [target]
 * @property {Record<string, number | string | boolean>} [solve]   settings of inverse kinematics
 * @property {number} [steps]    its iterations; `q` is then where it starts
 */

/** As many as the core allows. */
const MOST_STEPS = 200_000;
const MODES = ["hand", "between", "solve"];
const angles = list(number, 1, 8);
const pair = list(number, 2, 2);

/** @type {Rule} */
export const stateRule = record({
  scene: name, world: record({}, json(8)),
  robot: record({ type: name, base: pair, links: list(number, 1, 8), radius: number, joint_limits: list(pair, 1, 8) }),
  free: flag, q: angles, mode: rule((value) => typeof value === "string" && MODES.includes(value)),
  a: angles, b: angles, long: list(whole(7), 0, 8), along: rule((value) => typeof value === "number" && value >= 0 && value <= 1),
  lock: number, target: pair, solve: settings, steps: whole(MOST_STEPS),
});

/** @param {Bench} bench @param {Solving["told"]} solving @returns {State} */
export function stateOf(bench, { start, steps, settings: solve }) {
  const { arm, entry, mode, a, b, rounds, along, lock, target } = bench;
  const { robot, document: { world } } = arm;
  const given = /** @type {Record<string, unknown>} */ (entry ? { radius: 0, ...entry.robot } : {});
  const others = Object.entries(robot).filter(([key, value]) => (key !== "type" || !entry) && JSON.stringify(value) !== JSON.stringify(given[key]));
  return {
    ...(entry ? { scene: entry.id } : { world }),
    robot: Object.fromEntries(others),
    free: entry?.robot.joint_limits && !robot.joint_limits ? true : undefined,
    q: Array.from(mode === "solve" ? start : arm.q), mode,
    a: Array.from(a), b: Array.from(b), long: rounds.flatMap((round, i) => (round === "long" ? [i] : [])),
    along: mode === "between" ? along : undefined, lock: lock === null ? undefined : lock,
    target, solve,
    steps: mode === "solve" && steps > 0 ? steps : undefined,
  };
}

/** Puts on the bench what a link holds. @param {Bench} bench @param {Solving} solving @param {State} state @throws {Error} there is no such scene, or the core refuses it */
export function putState(bench, solving, state) {
  const { scene, world, robot, free, q, mode, a, b, long = [], along = 0, lock, target, solve, steps = 0 } = state;
  const { method, ...given } = solve ?? {};
  if (typeof method === "string") solving.choose(method, given);
  const entry = SCENES.find(({ id }) => id === scene);
  if (scene && !entry) throw new Error(`There is no scene "${scene}" here.`);
  if (entry) {
    bench.openEntry(entry);
    const changed = /** @type {ArmRobot} */ ({ type: "arm", ...entry.robot, ...robot });
    if (free) delete changed.joint_limits;
    if (free || Object.keys(robot).length > 0) bench.change({ ...documentOf(entry), robot: changed });
  } else {
    bench.openDocument(/** @type {ScenarioDocument} */ ({ format: "planarium-scenario-1", name: "link", title: "From a link", world, robot: { type: "arm", ...robot }, queries: [] }));
  }
  const { arm } = bench;
  if (a) bench.a = arm.fitted(a);
  if (b) bench.b = arm.fitted(b);
  bench.rounds = arm.joints.map(({ isCircle }, i) => /** @type {Round} */ (isCircle && long.includes(i) ? "long" : "short"));
  if (target) bench.target = target;
  if (lock !== undefined && arm.dimension > 2) bench.lock = lock;
  bench.turnTo(mode);
  bench.along = along;
  bench.pose(q);
  if (mode === "solve" && steps > 0) solving.advance(steps);
}
