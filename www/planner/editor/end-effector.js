/**
 * The end effector of an arm in the editor's hand: a start or goal is led by it, and a target is where it is to be, in whatever
 * pose. It counts as one more joint, behind the last.
 */
import { rounded, withPose, withTarget } from "./objects.js";

/** @import { Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { Shown } from "../lane.js" */
/** @import { Point, EditorObject } from "./objects.js" */

/** What joints are rounded to when they follow, radians: finer than by hand, so that the end effector stays where it was put. */
const FINE = 1e-7;

/** Is it the end effector that is held or picked? @param {Scenario} scenario @param {EditorObject | null} thing @param {number | null} part */
export function isTip({ robot, dimension }, thing, part) {
  return robot === "arm" && thing !== null && thing.kind !== "obstacle" && part === dimension;
}

/** Where the end effector is. @param {Scenario} scenario @param {ArrayLike<number>} pose @returns {Point} */
export function tipOf(scenario, pose) { return scenario.endEffector(Float64Array.from(pose)); }

/**
 * Leads a start or goal by its end effector, from one place to the next without a jump.
 * @param {Shown} shown @param {EditorObject} thing @param {ArrayLike<number>} pose
 * @param {() => Scenario} [arm]   the arm at the time: each change puts another scenario on the stage, and frees the one before
 * @returns {(point: Point) => ScenarioDocument}
 */
export function leads({ document, scenario }, thing, pose, arm = () => scenario) {
  let now = Float64Array.from(pose);
  return (point) => {
    now = Float64Array.from(arm().follow(now, point).configuration);
    return withPose(document, thing, now.map((angle) => rounded(angle, FINE)));
  };
}

/** The document whose goal is any pose that reaches where its goal does, or again the first pose found that does. @param {Shown} shown @param {EditorObject} thing @returns {ScenarioDocument | null} */
export function otherGoal({ document, scenario, goal, target, goals, start }, thing) {
  if (scenario.robot !== "arm" || thing.kind !== "goal") return null;
  if (goal) {
    const [x, y] = tipOf(scenario, goal);
    return withTarget(document, thing, { point: [rounded(x, 1e-6), rounded(y, 1e-6)] });
  }
  if (!target || !start) return null;
  const pose = goals[0] ?? scenario.nearestReachable(target.point, target.orientation).configuration;
  return withPose(document, thing, pose);
}
