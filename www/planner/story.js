/** The page's sentences: what is to be seen just now. */
import { leaders, letters } from "./race/standings.js";
import { isPlaced, lengthText, robotName, touchingSentence } from "../domain/names.js";
import { PAST } from "./run-log/run-log.js";

/** @typedef {{ algorithm: string, isProven: boolean, sentence: string }} Story   what a scene says of its own planner, and whether it is to prove its edges */
/** @import { PathPlayback } from "../domain/path-playback.js" */
/** @import { Lane } from "./lane.js" */
/** @import { Run } from "./run-log/run-log.js" */
/** @import { Check, Scenario } from "../domain/types.js" */

/** Iterations of a tree, or of guards, for which the page says what is looked for before the scene has its say. */
const OPENING = 60;

/**
 * A run that goes on: first what is looked for and what it is made of, then the scene's own sentence, if this is what its own
 * planner was asked, else what the planner is at.
 * @param {Run} run
 * @param {Story} scene
 */
export function going(run, scene) {
  const { phase } = run;
  const free = run.isProven ? "proven free" : "free in the places looked at";
  const sought = `The ${robotName(run.scenario.robot)} seeks a way from start to ${run.goals.length > 1 ? "any pose at the crosshair" : "goal"}`;
  const begins = run.shown < OPENING;
  if (phase === "improving") return `A path is found; now it is made shorter, by motions ${free}.`;
  if (phase === "sampling") return `${sought}: each point is a pose that touches nothing.`;
  if (phase === "searching") return "The search goes out from the start; the bold vertices are those it has been to.";
  if (begins && phase === "guarding") return `${sought}: a few poses stand guard, each seeing what no other sees.`;
  if (begins && phase === "growing") return `${sought}: ${run.kind === "trees" ? "two trees of poses reach for each other" : "a tree of poses grows from the start"}.`;
  if (run.algorithm === scene.algorithm && run.isProven === scene.isProven) return scene.sentence;
  switch (phase) {
    case "connecting": return `Each pose is joined to its neighbours, where the motion is ${free}.`;
    case "guarding": return "A pose that no guard sees becomes a guard, in a ring; one that sees several links them.";
    default: return run.kind === "trees"
      ? "Two trees, rooted at the start and at the goal, reach for each other until they meet."
      : "A tree grows from the start, step by step towards samples, until it reaches the goal.";
  }
}

/** A run that has ended. @param {Run} run @param {PathPlayback | null} playback */
export function ending(run, playback) {
  const iterations = run.made.toLocaleString("en");
  const { robot } = run.scenario;
  const { length, approximate } = run.result;
  if (run.status === "solved") {
    const shorter = playback?.raw ? `, cut from ${lengthText(run.rawLength, robot)}` : "";
    const found = `Found after ${iterations} iterations: a path of ${isPlaced(robot) ? "length " : ""}${lengthText(length, robot)}${shorter}`;
    if (run.isProven) return `${found}, proven free from end to end.`;
    if (playback?.flaw) return `Found, not proven. ${collision(run, playback.flaw.check)}`;
    return `${found}, not proven. Checked afterwards, it touches nothing.`;
  }
  if (!run.isTree && run.expanded === 0) return `No path: ${iterations} iterations were too few to search the roadmap.`;
  if (run.pieces) return `No path: ${asked(run)}the map is in ${run.pieces.count.toLocaleString("en")} pieces. Start and goal lie in different ones, in their colours.`;
  if (!approximate || !playback) return `No path after ${iterations} iterations: ${run.kind === "trees" ? "the two trees never met" : "the tree never came nearer to the goal"}.`;
  const miss = `No path after ${iterations} iterations. The nearest miss, dashed, ends ${lengthText(approximate.goal_distance, robot)} from the goal`;
  return `${miss}${run.isProven ? "." : `, not proven. ${playback.flaw ? collision(run, playback.flaw.check) : ""}`}`.trim();
}

/** How many neighbours each vertex was to have, if that was said. @param {Run} run */
function asked({ settings: { k } }) {
  return typeof k === "number" ? `with ${k} neighbour${k === 1 ? "" : "s"} each, ` : "";
}

/** @param {Run} run @param {Check} check */
function collision({ scenario }, check) {
  return `It collides: ${touchingSentence(scenario, check)}. To mend it, set \u201cCollision checking\u201d to proven.`;
}

/** What to do with the robot in the hand. @param {Scenario} scenario @param {boolean} square  is there a configuration square beside the workspace */
export function invitation(scenario, square) {
  if (isPlaced(scenario.robot)) return `Your turn: drag the ${robotName(scenario.robot)} from its start to its goal, touching nothing; the handle before it turns it.`;
  if (scenario.robot === "disc") return "Your turn: drag the disc from its start to its goal without touching anything.";
  return square
    ? "Your turn: drag a link, the arm\u2019s end, or the point in the square, from the start to the goal without touching anything."
    : "Your turn: drag the links, or the arm\u2019s end, from the start to the goal without touching anything.";
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
  const kind = run.kind === "trees" ? "Two trees" : `A ${run.kind}`;
  const state = run.status === "running" ? run.phase : run.status;
  const { past } = run;
  return `${title}. ${kind} with ${past[PAST.vertices].toLocaleString("en")} vertices and ${past[PAST.edges].toLocaleString("en")} edges; ${state}.`;
}

/** Several planners on one scenario. @param {Lane[]} lanes */
export function race(lanes) {
  const standings = lanes.map(({ standing }) => standing);
  const { first, shortest, isOver } = leaders(standings);
  if (first.length === 0) return isOver ? "None found a path." : "All get the same number of clearance evaluations, the work that proofs are made of.";
  const { found } = standings[first[0]];
  if (isOver && lanes.every(({ run }) => run?.past[PAST.evaluations] === 0)) return "There is nothing to keep clear of here: no clearance is ever evaluated, so all are done at once.";
  const [best] = shortest;
  const winner = `${letters(first)} found a path first, after ${found?.toLocaleString("en")} clearance evaluations`;
  if (best === undefined) return `${winner}.`;
  return `${winner}; ${letters(shortest)} ${isOver ? "has" : "so far has"} the shortest, ${lengthText(standings[best].cost, lanes[best].scenario.robot)}.`;
}
