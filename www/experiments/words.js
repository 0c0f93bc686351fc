/** What the page says of an experiment and of its trials, in sentences. */
import { counted, grouped } from "../app/dom.js";
import { capital } from "../widgets/format.js";
import { seedCount } from "./axis-text.js";
import { plannerTitle, valuesOf } from "./factors.js";
import { SOLVED } from "./measures.js";
import { sampleOf } from "./tables.js";
import { titleOf } from "./worlds.js";

/** Planners and worlds that a caption names, at most. */
const NAMES = 3;

/** @import { ExperimentAxis } from "planarium/full" */
/** @import { ExperimentSession } from "./session.js" */

/** @param {ExperimentSession} session */
export function sentenceOf({ phase, info, rows, document: { title, worlds, planners }, refusal, ceiling }) {
  const about = (/** @type {string} */ end) =>
    title ? `${title.replace(/[.:]$/, "")}${/[?!]$/.test(title) ? "" : end} ` : "";
  const begin = about(":");
  if (phase === "refused" || phase === "failed")
    return `${about(".")}${phase === "refused" ? "The experiment is refused" : "The trials stopped"}: ${refusal?.message ?? ""}.`;
  if (!info) {
    // Whatever the document is, as it is not checked yet.
    const isDrawn = /"ensure":(?!"any")/.test(JSON.stringify(worlds) ?? "");
    const draws = isDrawn ? " Worlds are drawn until each is known to have a path, or none." : "";
    return `${begin}Checking the experiment\u2026${draws}`;
  }
  if (rows.done === 0 && phase === "ready")
    return `${begin}${grouped(info.trialCount)} trials of ${counted(planners.length, "planner")} in ${counted(worlds.length, "kind of world", "kinds of worlds")}. Press Run.`;
  if (phase !== "done")
    return `${begin}${grouped(info.trialCount)} trials ${phase === "running" ? "are running" : "wait"}\u2026`;
  const solved = sampleOf(rows, Array.from(rows.ended()), SOLVED).reduce((sum, one) => sum + one, 0);
  const limit = ceiling && ceiling.most < 100 ? ` At most ${Number(ceiling.most.toFixed(1))} % can be solved.` : "";
  return `${begin}${grouped(solved)} of ${grouped(rows.count)} trials found a path.${limit}`;
}

/** What was run, for the caption of a chart. @param {Pick<ExperimentSession, "document" | "rows">} session */
export function subjectOf({ document: { planners, worlds, seeds }, rows }) {
  const list = (/** @type {string[]} */ all, /** @type {string} */ noun) =>
    all.length > NAMES ? counted(all.length, noun) : all.join(", ");
  const algorithms = [...new Set(planners.map((planner) => plannerTitle(planner) + setOf(planner.set)))];
  const names = [...new Set(worlds.map((world) => titleOf(world) + setOf("set" in world ? world.set : undefined)))];
  const [settings, each] = [expansions(planners), seedCount(seeds)];
  const inEach = rows.count / (settings * each);
  const hasQueries = worlds.some(({ queries = [] }) => queries.length > 1);
  const factors = [
    settings > 1 ? counted(settings, "setting") : "",
    inEach > 1 ? (hasQueries ? counted(inEach, "query", "queries") : counted(inEach, "world")) : "",
    each > 1 ? counted(each, "seed") : "",
  ].filter(Boolean);
  const product = Number.isInteger(inEach) && factors.length > 1 ? ` (${factors.join(" x ")})` : "";
  return `${list(algorithms, "planner")}; ${list(names, "world")}; ${counted(rows.count, "trial")}${product}.`;
}

/** Options that do not vary. @param {Record<string, unknown> | undefined} set */
function setOf(set) {
  const words = Object.entries(set ?? {}).map(([name, value]) => `${name.replaceAll("_", " ")} ${value}`);
  if (words.length === 0) return "";
  return ` (${words.length > NAMES ? `${words.length} options set` : words.join(", ")})`;
}

/** How many settings planners with parameters that vary are. @param {{ vary?: Record<string, ExperimentAxis> }[]} planners */
function expansions(planners) {
  return planners
    .map(({ vary }) => Object.values(vary ?? {}).reduce((product, axis) => product * valuesOf(axis).length, 1))
    .reduce((sum, one) => sum + one, 0);
}

/** @param {ExperimentSession} session */
export function progressOf({ rows, phase, runtime, uncertified, isBusy }) {
  if (rows.count === 0) return "";
  if (uncertified > 0) return `${counted(uncertified, "world")} left to examine for a path`;
  const left = rows.done > 0 && isBusy ? (runtime / rows.done) * (rows.count - rows.done) : 0;
  const seconds = phase === "done" ? `, ${(runtime / 1000).toFixed(1)} s` : left > 0 ? `, ${timeText(left)} left` : "";
  return `${grouped(rows.done)} of ${grouped(rows.count)}${seconds}`;
}

/**
 * A refusal as a sentence, with the title of the planner that it begins with; names of parameters stay as they are.
 * @param {string} message
 */
export function refusalText(message) {
  const named = message.replace(/^[a-z-]+/, (algorithm) => plannerTitle({ algorithm }));
  return /^(?:these|this|there|the|another|unknown|an?|no|it) /.test(named) ? capital(named) : named;
}

/** @param {number} milliseconds */
function timeText(milliseconds) {
  const seconds = Math.ceil(milliseconds / 1000);
  return seconds < 60
    ? `${seconds} s`
    : seconds < 3600
      ? `${Math.round(seconds / 60)} min`
      : `${(seconds / 3600).toFixed(1)} h`;
}
