/** The end effector in the editor. It counts as one more joint after the last; dragging it moves the arm of a start or goal. */
import { rounded, withPose, withTarget } from "./objects.js";

/** @import { Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { Shown } from "../lane.js" */
/** @import { Point, EditorObject } from "./objects.js" */

/** The unit of joints that follow, radians: fine enough for the end effector to stay in place. */
const FINE = 1e-7;

/** Whether a part is the end effector. @param {Scenario} scenario @param {EditorObject | null} object @param {number | null} part */
export function isTip({ robot, dimension }, object, part) {
  return robot === "arm" && object !== null && object.kind !== "obstacle" && part === dimension;
}

/** The position of the end effector. @param {Scenario} scenario @param {ArrayLike<number>} pose @returns {Point} */
export function tipOf(scenario, pose) { return scenario.endEffector(Float64Array.from(pose)); }

/**
 * Moves a start or goal by its end effector, without jumps.
 * @param {Shown} shown @param {EditorObject} object @param {ArrayLike<number>} pose
 * @param {() => Scenario} [arm]   of the current scenario; each change frees the previous one
 * @returns {(point: Point) => ScenarioDocument}
 */
export function followTip({ document, scenario }, object, pose, arm = () => scenario) {
  let now = Float64Array.from(pose);
  return (point) => {
    now = Float64Array.from(arm().follow(now, point).configuration);
    return withPose(document, object, now.map((angle) => rounded(angle, FINE)));
  };
}

/** The document with a target in place of the goal, or with the first configuration that reaches the target as its goal. @param {Shown} shown @param {EditorObject} object @returns {ScenarioDocument | null} */
export function otherGoal({ document, scenario, goal, target, goals, start }, object) {
  if (scenario.robot !== "arm" || object.kind !== "goal") return null;
  if (goal) {
    const [x, y] = tipOf(scenario, goal);
    return withTarget(document, object, { point: [rounded(x, 1e-6), rounded(y, 1e-6)] });
  }
  if (!target || !start) return null;
  const pose = goals[0] ?? scenario.nearestReachable(target.point, target.orientation).configuration;
  return withPose(document, object, pose);
}
