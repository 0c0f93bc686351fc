/** The sentences above the stage. */
import { counted, grouped } from "../app/dom.js";
import { leaders, letter, letters } from "./race/standings.js";
import { costText, endText, isPlaced, lengthText, robotName, touchingSentence, weightedText } from "../domain/names.js";
import { EVENT, PAST } from "./run-log/columns.js";
import { coordinatesOf, turnsAlong } from "../domain/coordinates.js";
import { capital, duration, num } from "../widgets/format.js";

/**
 * @typedef {{ algorithm: string, isProven: boolean, sentence: string }} Story   a scene's sentence about its own
 *   planner, and whether that proves its edges
 */
/** @import { PathPlayback } from "./stage/path-playback.js" */
/** @import { Asked, Lane } from "./stage/lane.js" */
/** @import { RunLog } from "./run-log/run-log.js" */
/** @import { Session } from "./session.js" */
/** @import { Check, Scenario } from "../domain/types.js" */

/** Iterations of a tree, or of guards, that the first sentence is shown for, before the scene's own. */
const OPENING = 60;

/**
 * The sentence above the stage, and whether it reports a failure.
 * @param {Session} session
 * @returns {[string, boolean]}
 */
export function sentenceOf({ shown, lanes, clock, stage, editor, driving, certifying, story, byHand: { game } }) {
  if (!shown) return ["", false];
  const { hand, check, scenario } = shown;
  if (driving?.on) return [driving.sentence, driving.state?.blocked !== null];
  if (editor?.sentence && !hand) return [editor.sentence, editor.isBad];
  if (hand && check) {
    if (!check.free) return [poseSentence(scenario, check), false];
    const hasSquare = [...stage.places.values()].some(({ kind }) => kind === "cspace");
    return [game.arrived ? arrival(game.touches) : invitation(scenario, hasSquare), false];
  }
  if (certifying?.on) return [certifying.sentence, false];
  const { run, playback, asked } = lanes[0];
  if (!run) return [`${scenario.title || scenario.name}.`, false];
  if (clock.isRace) return [race(lanes), false];
  if (run.status === "running") return [going(run, story), false];
  return [asked ? answered(asked, scenario) : ending(run, playback), Boolean(playback?.flaw)];
}

/**
 * A run in progress: first the task and the elements of the graph, then the scene's own sentence, if its own planner
 * runs, or else the planner's activity.
 * @param {RunLog} run
 * @param {Story} scene
 */
export function going(run, scene) {
  const { phase, settings } = run;
  const checked = run.isProven
    ? "proven to be collision-free"
    : settings.edge_check === "none"
      ? "that nobody checks"
      : "checked at sampled points only";
  const sought = `Looking for a path from start to ${run.goals.length > 1 ? "any configuration at the crosshair" : "goal"}`;
  const own = `the ${robotName(run.scenario.robot)}\u2019s configurations`;
  const begins = run.shown < OPENING;
  if (phase === "improving" && run.goesOn)
    return `A path is found. ${run.kind === "trees" ? "The trees restart" : `The ${run.isTree ? "tree" : "roadmap"} grows on`} by motions ${checked}, and the best path gets shorter.`;
  if (phase === "improving") return `A path is found; it is now being shortened by motions ${checked}.`;
  if (phase === "sampling")
    return `${sought}. Each dot is a collision-free configuration of the ${robotName(run.scenario.robot)}.`;
  if (phase === "searching")
    return `Searching the roadmap from ${String(settings.search).startsWith("bidirectional") ? "both ends" : "the start"}. Vertices already expanded are bold.`;
  if (begins && phase === "guarding") return `${sought}. Guards are configurations that no other guard sees.`;
  if (begins && phase === "growing")
    return `${sought}. ${run.kind === "trees" ? `Two trees of ${own} grow towards each other` : `A tree of ${own} grows from the start`}.`;
  if (run.algorithm === scene.algorithm && run.isProven === scene.isProven)
    return scene.sentence.replace("{controls}", controls(run));
  switch (phase) {
    case "connecting":
      return run.isLazy
        ? `Nearby configurations become candidates. A line will be a motion ${checked}, once the best path wants it.`
        : `Nearby configurations are now connected. Each line is a motion ${checked}.`;
    case "guarding":
      return "A sample that no guard sees becomes a guard; one that sees guards of several components connects them.";
    default:
      return run.kind === "trees"
        ? "Two trees, rooted at start and goal, grow towards each other until they meet."
        : "A tree grows from the start, step by step towards samples, until it reaches the goal.";
  }
}

/** How an extension chooses its control. @param {RunLog} run */
function controls({ settings: { blossom = 1 } }) {
  return blossom === 1
    ? "one random control is tried"
    : `${blossom} random controls are tried; the one that ends closest to the sample is kept`;
}

/** A run that has ended. @param {RunLog} run @param {PathPlayback | null} playback */
export function ending(run, playback) {
  const iterations = counted(run.made, "iteration");
  const { robot } = run.scenario;
  const { length, cost, blends, blended_length: blended, approximate } = run.result;
  if (run.status === "solved") {
    const early = run.result.explanation ? ` ${capital(run.result.explanation)}.` : "";
    // What nearness to obstacles adds is no length.
    const [first, best] = cost
      ? [`cost ${run.rawLength.toFixed(2)}`, `cost ${cost.value.toFixed(2)}, ${costText(length, run.scenario)}`]
      : [lengthText(run.rawLength, run.scenario), costText(length, run.scenario)];
    const shorter = playback?.raw ? `, ${cost ? "improved" : "shortened"} from ${first}` : "";
    if (playback?.flaw) return `Path found, but not verified: ${collision(run.scenario, playback.flaw.check)}`;
    // A tree that grows past its first path finds shorter ones.
    if (run.goesOn && run.countOf(EVENT.solved) > 1) {
      return `First path after ${grouped(run.foundBy(run.made))} iterations, ${first}; after ${grouped(run.made)} the best: ${best}, ${certainty(run.isProven)}.${early}`;
    }
    const round = blends?.filter(([before]) => before > 0).length ?? 0;
    const rounded =
      blends && blended !== undefined
        ? `, ${round} of ${counted(blends.length, "corner")} rounded: ${lengthText(blended, run.scenario)}`
        : "";
    return `Path found after ${iterations}: ${best}${shorter}${rounded}, ${certainty(run.isProven)}.${early}`;
  }
  const { reason, explanation = "no path was found" } = run.result;
  const why = capital(explanation);
  if (run.isLazy)
    return reason === "not-connected"
      ? `${why}: every way along candidate edges needs a motion that is not free.`
      : `${why}.`;
  if (run.pieces) {
    const { k } = run.settings;
    // The components say the reason themselves, in a sentence of two lines; the legend has their colours.
    const before =
      reason !== "not-connected"
        ? `${why}. The roadmap has`
        : `This roadmap has no path: ${typeof k === "number" ? `with k = ${k} ` : ""}it has`;
    return `${before} ${grouped(run.pieces.count)} connected components, with start and goal in different ones.`;
  }
  if (!run.isTree) return `${why}.`;
  if (!approximate || !playback)
    return `${why}: ${run.kind === "trees" ? "the two trees never met" : "the tree never got closer to the goal than its root"}.`;
  // Under controls nearness to the goal is not a length of a drive.
  const left =
    robot === "rigid_body" || run.isDriven
      ? weightedText(approximate.goal_distance, run.scenario)
      : lengthText(approximate.goal_distance, run.scenario);
  const miss = `${why}. The closest approach, dashed, ends ${left} from the goal`;
  if (run.isProven) return `${miss}.`;
  return `${miss}, not proven${playback.flaw ? `: ${collision(run.scenario, playback.flaw.check)}` : "."}`;
}

/** A roadmap that was asked for another path. @param {Asked} asked @param {Scenario} scenario */
function answered({ result, visited, seconds, isProven, playback }, scenario) {
  const work = `${counted(visited, "vertex", "vertices")} visited in ${duration(seconds)}`;
  if (!playback) return `The roadmap has no path from this start to this goal: ${work}.`;
  if (playback.flaw)
    return `The roadmap has a path, but it is not verified: ${collision(scenario, playback.flaw.check)}`;
  return `The roadmap has a path, ${work}: ${costText(result.length, scenario)}, ${certainty(isProven)}.`;
}

/** @param {boolean} isProven */
function certainty(isProven) {
  return isProven ? "proven to be collision-free" : "not proven. A check afterwards found no collision";
}

/** @param {Scenario} scenario @param {Check} check */
function collision(scenario, check) {
  return `${touchingSentence(scenario, check).replaceAll(" touches ", " hits ")} on the way. To fix it, set \u201cCollision checking\u201d to proven.`;
}

/**
 * How to pose the robot by hand.
 * @param {Scenario} scenario
 * @param {boolean} square  whether the configuration space is shown
 */
function invitation({ robot }, square) {
  const task = `Your turn: move the ${robotName(robot)} to the goal without a collision.`;
  if (isPlaced(robot)) return `${task} Drag it, or turn it by the handle in front of it.`;
  if (robot === "disc") return `${task} Drag it.`;
  return `${task} Drag a link${square ? ", the tip, or the dot in configuration space" : " or the tip"}.`;
}

/** The configuration posed by hand, in words. @param {Scenario} scenario @param {Check} check */
export function poseSentence(scenario, check) {
  return check.free ? "Collision-free." : `${capital(touchingSentence(scenario, check))}.`;
}

/**
 * How far each joint of an arm turns or slides: along its path, or the short way from the start to the configuration
 * posed by hand.
 * @param {Session} session
 */
export function turnsSentence({ shown, playbacks: [playback] }) {
  if (!shown || shown.scenario.robot !== "arm") return "";
  const { scenario, hand, start } = shown;
  const circles = scenario.circles();
  const turns = !hand ? playback?.turns : start && turnsAlong([start, hand], circles);
  if (!turns) return "";
  const units = coordinatesOf(shown).map(({ unit }) => unit);
  const words = turns.map(
    (turn, i) =>
      `joint ${i + 1} ${turn > 0 ? "+" : ""}${num(turn)} ${units[i]}${Math.abs(turn) > Math.PI && circles[i] ? ", the long way round" : ""}`,
  );
  return `${units.includes("m") ? "Turns and slides" : "Turns"} ${hand ? "from the start, the short way round" : "along the path"} (+ is counter-clockwise): ${words.join("; ")}.`;
}

/** @param {number} touches */
function arrival(touches) {
  if (touches === 0) return "You reached the goal without a collision.";
  return `You reached the goal, with ${touches === 1 ? "one collision" : `${touches} collisions`} on the way.`;
}

/** The figure in words, for screen readers. @param {string} title @param {RunLog | null} run */
export function summary(title, run) {
  if (!run) return `${title}. No planner has run.`;
  const kind = run.kind === "trees" ? "Two trees" : `A ${run.kind}`;
  const state =
    run.status === "running" ? run.phase : run.status === "exhausted" ? endText(run.known?.result.reason) : run.status;
  const { past } = run;
  return `${title}. ${kind} with ${grouped(past[PAST.vertices])} vertices and ${grouped(past[PAST.edges])} edges; ${state}.`;
}

/** A race. @param {Lane[]} lanes */
function race(lanes) {
  const standings = lanes.map(({ standing }) => standing);
  const colliding = standings.flatMap(({ collides }, i) => (collides ? [i] : []));
  if (colliding.length === 0) return standing(lanes, standings);
  const faulty =
    colliding.length > 1
      ? `The paths of ${letters(colliding)} collide: they were not proven.`
      : `The path of ${letters(colliding)} collides: it was not proven.`;
  return colliding.length === lanes.length ? faulty : `${faulty} ${standing(lanes, standings)}`;
}

/** Who leads. @param {Lane[]} lanes @param {import("./race/standings.js").Standing[]} standings */
function standing(lanes, standings) {
  const { first, shortest, isOver } = leaders(standings);
  if (first.length === 0)
    return isOver
      ? "Every planner gave up, without a path."
      : "All planners are shown after the same work, counted in clearance evaluations (distances computed).";
  const { found } = standings[first[0]];
  if (isOver && lanes.every(({ run }) => run?.past[PAST.clearanceEvaluations] === 0))
    return "There is nothing to avoid here: no clearance is ever evaluated, so all planners finish at once.";
  const [best] = shortest;
  const length = best === undefined ? "" : lengthText(standings[best].cost, lanes[best].scenario);
  const effort = `after ${grouped(found ?? 0)} clearance evaluations`;
  const isTied = first.length > 1;
  const winner = isTied
    ? `${letters(first)} tied: ${first.length === 2 ? "both" : "all"} found a path ${effort}`
    : `${letters(first)} found a path first, ${effort}`;
  // On one roadmap it is the searches that differ.
  const visited = lanes.map(({ run }) => (run && !run.isTree ? run.visited : 0));
  const isSearched = isTied && isOver && visited.every((count) => count > 0) && new Set(visited).size > 1;
  const searches = isSearched
    ? ` Vertices visited: ${visited.map((count, i) => `${letter(i)} ${grouped(count)}`).join(", ")}.`
    : "";
  if (best === undefined) return `${winner}.`;
  if (isTied && String(first) === String(shortest)) return `${winner}, of length ${length}.${searches}`;
  return `${winner}; ${letters(shortest)} ${shortest.length > 1 ? "have" : "has"} the shortest here${isOver ? "" : " so far"}, ${length}.${searches}`;
}
