/** The page's sentences: what is to be seen just now. */
import { touchingSentence } from "./names.js";

/** @import { Run } from "./run.js" */
/** @import { Check, Scenario } from "./types.js" */

/** A run that has ended. @param {Run} run @param {number} length */
export function ending(run, length) {
  const iterations = run.iterations.toLocaleString("en");
  if (run.status === "solved") {
    const unit = run.scenario.robot === "arm" ? "rad" : "m";
    return `Found after ${iterations} iterations: a path of ${length.toFixed(2)} ${unit}, proven free from end to end.`;
  }
  return run.isTree
    ? `No path after ${iterations} iterations: the two trees never met.`
    : `No path: the search has been to every vertex it can reach, the bold ones, and the goal is not among them.`;
}

/** What to do with the robot in the hand. @param {Scenario} scenario @param {boolean} square  is there a configuration square beside the workspace */
export function invitation(scenario, square) {
  if (scenario.robot === "disc") return "Your turn: drag the disc from its start to its goal without touching anything.";
  return square
    ? "Your turn: drag a link, or the point in the square, from the start to the goal without touching anything."
    : "Your turn: drag the links from the start to the goal without touching anything.";
}

/** The pose in the hand, in words. @param {Scenario} scenario @param {Check} check */
export function poseSentence(scenario, check) {
  if (check.free) return "Free: nothing touches.";
  const sentence = touchingSentence(scenario, check);
  return `${sentence[0].toUpperCase()}${sentence.slice(1)}.`;
}

/** @param {number} touches */
export function arrival(touches) {
  if (touches === 0) return "You reached the goal and touched nothing.";
  return `You reached the goal, touching something ${touches === 1 ? "once" : `${touches} times`} on the way.`;
}

/** The picture in words, for those who do not see it. @param {string} title @param {Run | null} run */
export function summary(title, run) {
  if (!run) return `${title}. Nothing is planned.`;
  const kind = run.isTree ? "two trees" : "roadmap";
  const state = run.status === "running" ? run.planner.phase : run.status;
  return `${title}. A ${kind} with ${run.vertices.count.toLocaleString("en")} vertices and ${run.edges.count.toLocaleString("en")} edges; ${state}.`.replace("A two", "Two");
}
