/** How much room there is, in sentences. */
import { counted, grouped } from "../../app/dom.js";
import { obstacleName } from "../../domain/names.js";
import { num, percent } from "../../widgets/format.js";

/** @import { RouteGraph, Safest, Widest } from "planarium/full" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { Clearances } from "../../paths/clearance.js" */
/** @import { Optimum } from "../stage/lane.js" */
/** @import { Fault } from "./question.js" */

/** Why the scene has none of something. */
export const OTHERS = {
  discs: "This is known of discs, from a start to a goal.",
  routes: "Route graphs are for discs and rigid bodies.",
  optimum: "This is known of discs and of arms with two joints.",
};

/** What is asked. */
export const MEANINGS = {
  widest: "How wide a disc may be to pass, and the tightest gap on its way.",
  safest: "The path that keeps as far from everything as any can, and the shortest of these.",
  routes: "A few nodes and proven edges over which the robot gets everywhere, for a route server.",
};

/** @param {string} text */
const closed = (text) => text.replace(/\.?$/, ".");

/** A clearance: of less than a centimetre in millimetres. @param {number} metres */
export const clearanceText = (metres) => (metres < 0.01 ? `${num(1000 * metres)} mm` : `${num(metres, 3)} m`);

/** Why a question has no answer. @param {Fault} fault */
export function faultText({ code, message }) {
  if (code === "start-in-collision") return "The start is in collision: nothing passes.";
  if (code === "goal-in-collision") return "The goal is in collision: nothing passes.";
  return closed(message[0].toUpperCase() + message.slice(1));
}

/** The two sides of a gap, or what is beside an end. @param {Widest["between"]} between */
function sides(between) {
  const names = between.map((one) => (one === "bounds" ? "the bounds" : obstacleName(one)));
  const [a, b] = names;
  return a === b ? `two parts of ${a}` : names.join(" and ");
}

/** The shortest path, or what it is. @param {Optimum | null} optimum @param {string} robot */
export function optimumText(optimum, robot) {
  if (!optimum) return "Dashed: as short as a free path can be; it touches obstacles.";
  const exact = optimum.isExact ? "; no free path is shorter." : ", on a fine grid: a run may find a shorter one.";
  return `${num(optimum.length)} ${robot === "arm" ? "rad" : "m"} long${exact}`;
}

/**
 * How wide a disc may be, and what limits it.
 * @param {Widest} widest
 * @param {ScenarioDocument["robot"]} robot
 */
export function widestText({ radius, limit, between }, robot) {
  if (radius === null) return "Not even a point passes: obstacles in contact separate the start from the goal.";
  const by =
    limit === "gap"
      ? `the tightest gap is ${num(2 * radius, 3)} m wide, between ${sides(between)}`
      : `a wider one does not fit at the ${limit}, beside ${sides(between)}`;
  const own = robot.type === "disc" ? (robot.radius ?? 0) + (robot.margin ?? 0) : 0;
  const name = robot.margin ? "This robot, with its margin," : "This robot";
  const spare =
    own === 0
      ? ""
      : own < radius
        ? ` ${name} has ${num(own, 3)} m: there is room to spare.`
        : ` ${name} has ${num(own, 3)} m: it does not pass.`;
  return `A disc of up to ${num(radius, 3)} m radius passes; ${by}.${spare}`;
}

/**
 * The safest path.
 * @param {Safest} safest
 * @param {number | null} shortest   the length of the shortest path of the robot, if it is known
 */
export function safestText({ radius, length }, shortest) {
  if (radius === null) return "There is none: not even a point passes.";
  if (length === null) return "It was not found: rounding closes the passage.";
  const longer = shortest ? 100 * (length / shortest - 1) : null;
  const compared = longer === null ? "" : `, ${percent(Math.max(0, longer))} longer than the shortest`;
  return `${num(length)} m long${compared}. Its centre keeps ${num(radius, 3)} m from everything; no path keeps a larger distance.`;
}

/** A route graph. @param {RouteGraph} graph */
export function routesText({ nodes, edges, parts, covered, largestDetour, samples, longestLeg }) {
  if (nodes.length === 0) return "No free place was found.";
  const joined = parts === 1 ? "" : `, in ${parts} parts that are not joined`;
  return (
    `${counted(nodes.length, "node")} and ${counted(edges.length, "edge")}${joined}. Ways over it are at most ` +
    `${num(largestDetour)} times as long as over a roadmap of ${grouped(samples)} places, and ${num(Math.floor(1000 * covered) / 10, 1)} % of ` +
    `the free places see a node within ${num(longestLeg)} m.`
  );
}

/** The clearance along the path. @param {Clearances} clearances @param {number} metres   along the path, of the smallest */
export function alongText({ least }, metres) {
  if (!least) return "There is nothing to keep clear of.";
  return least.distance === 0
    ? `The path touches something, ${num(metres)} m along it.`
    : `Smallest clearance: ${clearanceText(least.distance)}, ${num(metres)} m along the path.`;
}
