/** The state that a link stores; numbers are stored in full, so that a run is the same to the last bit. */
import {
  flag,
  json,
  list,
  name,
  number,
  oneOf,
  record,
  rule,
  settings,
  whole,
  withDefaults,
} from "../formats/rules.js";
import { Robot } from "./robot.js";
import { sceneOf } from "./scenes.js";

/** @import { Point, ScenarioDocument } from "../domain/types.js" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { ArmRobot } from "../domain/coordinates.js" */
/** @import { IkPanel } from "./ik-panel.js" */
/** @import { Direction } from "./motion.js" */
/** @import { ReachSession, Mode } from "./session.js" */

/** Iterations at most, as in the core. */
const MOST_STEPS = 200_000;
const angles = list(number, 1, 8);
const pair = /** @type {Rule<Point>} */ (list(number, 2, 2));

export const stateRule = withDefaults(
  {
    // A scene of this page or of the planner's, or a world; and what differs from the scene: the robot, and whether its
    // joints are no longer the scene's.
    scene: name,
    world: /** @type {Rule<ScenarioDocument["world"]>} */ (record({}, json(8))),
    robot: record({
      type: name,
      base: pair,
      links: list(number, 1, 8),
      radius: number,
      joint_limits: list(pair, 1, 8),
      joints: list(json(3), 1, 8),
      shape: record({}, json(5)),
      metric: record({ translation: number, rotation: number }),
    }),
    free: flag,
    // The configuration, in inverse kinematics that of the start.
    q: angles,
    mode: oneOf(/** @type {Mode[]} */ (["hand", "between", "solve"])),
    // Whether turns by keys that collide are taken back.
    back: flag,
    // The motion from A to B: coordinates that turn the long way round, and the faulty way; and the progress.
    a: angles,
    b: angles,
    long: list(whole(7), 0, 8),
    faulty: list(whole(7), 0, 8),
    along: /** @type {Rule<number>} */ (rule((value) => typeof value === "number" && value >= 0 && value <= 1)),
    // The fixed orientation, and inverse kinematics: its settings and iterations.
    lock: number,
    target: pair,
    solve: settings,
    steps: whole(MOST_STEPS),
  },
  { q: [], robot: {}, free: false, mode: "hand", back: false, long: [], faulty: [], along: 0, solve: {}, steps: 0 },
);

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */

/** @param {ReachSession} session @param {IkPanel} ik @returns {State} */
export function stateOf(session, ik) {
  const { entry, mode, a, b, directions, progress, orientation, target, run, takesBack } = session;
  const { isArm, q } = session.robot;
  const { world, robot } = session.robot.document;
  const scene = /** @type {Record<string, unknown>} */ (entry ? { radius: 0, ...entry.document.robot } : {});
  const those = (/** @type {Direction} */ wanted) =>
    directions.flatMap((direction, i) => (direction === wanted ? [i] : []));
  return {
    ...(entry ? { scene: entry.id } : { world }),
    robot: Object.fromEntries(
      Object.entries(robot).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(scene[key])),
    ),
    free: ["joint_limits", "joints"].some((name) => name in scene && !(name in robot)),
    q: Array.from(mode === "solve" ? ik.start : q),
    mode,
    back: takesBack,
    a: Array.from(a),
    b: Array.from(b),
    long: those("long"),
    faulty: those("faulty"),
    along: mode === "between" ? progress : 0,
    lock: orientation ?? undefined,
    target: isArm ? target : undefined,
    solve: isArm ? { method: ik.method.id, ...ik.given } : {},
    steps: run?.run.iterations ?? 0,
  };
}

/**
 * @param {ReachSession} session
 * @param {IkPanel} ik
 * @param {State} state
 * @param {AbortSignal} [signal]   something else is opened meanwhile
 * @throws {Error} there is no such scene, or the core refuses it
 */
export async function openState(
  session,
  ik,
  {
    scene,
    world,
    robot: changes,
    free,
    q,
    mode,
    back,
    a,
    b,
    long,
    faulty,
    along,
    lock,
    target,
    solve: { method, ...given },
    steps,
  },
  signal,
) {
  const entry = scene ? await sceneOf(scene) : null;
  signal?.throwIfAborted();
  if (entry) {
    const { joint_limits: limits, joints, ...rest } = /** @type {ArmRobot} */ (entry.document.robot);
    const own = free ? rest : { ...rest, ...(limits && { joint_limits: limits }), ...(joints && { joints }) };
    const document = { ...entry.document, robot: /** @type {ArmRobot} */ ({ ...own, ...changes }), queries: [] };
    // The core checks it before anything changes.
    new Robot(document, []).free();
    session.openScene(entry);
    if (free || Object.keys(changes).length > 0) session.changeArm(document);
  } else {
    session.open(
      /** @type {ScenarioDocument} */ ({
        format: "planarium-scenario-1",
        name: "link",
        title: "From a link",
        world,
        robot: { type: "arm", ...changes },
        queries: [],
      }),
    );
  }
  if (typeof method === "string") ik.choose(method, given);
  const { robot } = session;
  if (a) session.a = robot.fitted(a);
  if (b) session.b = robot.fitted(b);
  session.directions = robot.coordinates.map(({ isCircle }, i) =>
    isCircle && long.includes(i) ? "long" : isCircle && faulty.includes(i) ? "faulty" : "short",
  );
  if (target) session.target = target;
  if (lock !== undefined && robot.isArm && robot.dimension > 2) session.orientation = lock;
  session.takesBack = back;
  session.setMode(robot.isArm || mode !== "solve" ? mode : "hand");
  session.progress = along;
  session.moveTo(q.length > 0 ? q : session.mode === "between" ? session.motion.at(along) : robot.q);
  if (session.mode === "solve" && steps > 0) ik.advance(steps);
}
