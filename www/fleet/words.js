/** The plan in sentences. */
import { counted, grouped } from "../app/dom.js";
import { capital, num } from "../widgets/format.js";

/** @import { FleetSession } from "./session.js" */

/** Robots that a sentence names, at most. */
const NAMED = 4;

/** A robot by its number, and its name if that is another. @param {FleetSession} session @param {number} i */
export function nameOf({ robots }, i) {
  const number = String(i + 1);
  return robots[i].name === number ? `robot ${number}` : `robot ${number} (${robots[i].name})`;
}

/** Several robots in words. @param {FleetSession} session @param {number[]} all */
function namesOf(session, all) {
  const [first, ...rest] = all.slice(0, NAMED).map((i) => nameOf(session, i));
  const others = all.length - NAMED;
  const words = [first, ...rest.map((name) => name.replace(/^robot /, "")), ...(others > 0 ? [`${others} more`] : [])];
  if (words.length === 1) return words[0];
  return `${rest.length > 0 ? words[0].replace(/^robot/, "robots") : words[0]}${words
    .slice(1, -1)
    .map((word) => `, ${word}`)
    .join("")} and ${words.at(-1)}`;
}

/** @param {number} count  of robots, two or more */
function allOf(count) {
  return count === 2 ? "both" : `all ${grouped(count)}`;
}

/** @param {FleetSession} session @returns {string} */
export function sentenceOf(session) {
  if (session.isStraight) return straightSentence(session);
  const { status } = session.run;
  if (status === "solved") return solvedSentence(session);
  if (status === "exhausted") return failedSentence(session);
  return runningSentence(session);
}

/** @param {FleetSession} session */
function runningSentence({ run, robots, isOrdered, algorithm }) {
  const vertices = counted(
    run.roadmaps.reduce((most, roadmap) => Math.max(most, roadmap.vertices.length / 3), 0),
    "vertex",
    "vertices",
  );
  const { length } = robots;
  if (!isOrdered) return `Two trees grow towards each other, for ${allOf(length)} robots at once: ${vertices}.`;
  if (run.planned === 0 && run.isBuilding) {
    if (run.roadmaps.length > 1) return `${run.roadmaps.length} roadmaps grow, one for each kind of robot.`;
    return length === 1
      ? `A roadmap grows: ${vertices}.`
      : `A roadmap grows, which all ${length} robots share: ${vertices}.`;
  }
  if (algorithm === "pbs")
    return length === 1
      ? "The robot is planned for."
      : `${capital(allOf(length))} robots are planned for: where two would meet, one gives way.`;
  return `${run.planned} of ${counted(length, "robot")} planned, one after the other, each around those before it.`;
}

/** @param {FleetSession} session */
function solvedSentence({ run: { result }, robots, isOrdered, order, algorithm }) {
  if (!result) return "";
  const { waits, makespan } = result;
  const { restarts } = result.stats;
  const waiting = waits > 0.005 ? `Together they wait ${num(waits, 1)} s.` : "None has to wait.";
  const all =
    robots.length === 1 ? "The robot reaches its goal" : `${capital(allOf(robots.length))} robots reach their goals`;
  const found = `${all} in ${num(makespan, 1)} s${robots.length === 1 ? "." : `, and no two of them touch at any time. ${waiting}`}`;
  if (!isOrdered)
    return found.replace(waiting, `The composite planned for ${robots.length === 2 ? "both" : "all"} of them at once.`);
  if (algorithm === "pbs")
    return restarts > 0
      ? `${found} ${restarts === 1 ? "One other choice" : `${grouped(restarts)} other choices`} of who gives way came before.`
      : found;
  return restarts > 0 && !order
    ? `${found} ${restarts === 1 ? "Another order was" : `${restarts} other orders were`} tried before this one.`
    : found;
}

/** Why there is no plan, as far as is known. @param {FleetSession} session */
function failedSentence(session) {
  const { isOrdered, algorithm } = session;
  const { result } = session.run;
  const [robot, ...others] = session.run.blocked;
  const reason = result?.reason;
  const { iterations = 0, restarts = 0, vertices = 0 } = result?.stats ?? {};
  if (reason === "too-late")
    return "The plan lasts so long that the times of its fast robots are no longer distinct. Speeds that differ less may help.";
  const gaveUp =
    reason === "graph-full"
      ? "there is no memory for more vertices"
      : `it gave up after ${counted(iterations, "iteration")}`;
  if (!isOrdered) return `The composite found no plan: ${gaveUp}. Another seed may, or more iterations.`;
  if (reason === "not-connected" && robot !== undefined)
    return `No plan was found: the roadmap does not connect the start of ${nameOf(session, robot)} to its goal (${counted(vertices, "vertex", "vertices")} in all). More samples may help.`;
  const last =
    robot === undefined || others.length === 0
      ? ""
      : ` At last ${nameOf(session, robot)} found no path, because ${namesOf(session, others)} ${others.length === 1 ? "was" : "were"} in its way.`;
  if (reason === "no-order") return `On this roadmap no order of priorities gives a plan.${last}`;
  if (reason === "order-limit")
    return `${algorithm === "prioritized" && restarts === 0 ? "No plan was found in this order." : `No plan was found in ${counted(restarts + 1, "order")} of priorities; there are others.`}${last}`;
  return `No plan was found: ${gaveUp}.${last}`;
}

/** @param {FleetSession} session */
function straightSentence({ conflicts, touching, robots, time }) {
  if (conflicts.length === 0) return "If all drove straight to their goals at once, no two would touch.";
  const now = touching.map(({ robots: [a, b] }) => `${a + 1} and ${b + 1}`);
  if (now.length > 0 && now.length <= 3) return `At ${num(time, 1)} s robots ${now.join(", ")} touch.`;
  if (now.length > 3) return `At ${num(time, 1)} s ${now.length} pairs of robots touch.`;
  return `If all ${robots.length} robots drove straight to their goals at once, ${counted(conflicts.length, "pair")} would touch. Obstacles are ignored.`;
}

/** What a robot does, for the list. @param {FleetSession} session @param {number} i */
export function laneSentence(session, i) {
  const { shown, isStraight } = session;
  const { blocked, status } = session.run;
  const way = shown[i];
  const name = nameOf(session, i);
  if (!isStraight && status === "exhausted" && blocked[0] === i) return `${name}: no plan was found`;
  const isInTheWay = !isStraight && blocked.includes(i) ? ", in the way" : "";
  if (!way) return `${name}: no plan yet${isInTheWay}`;
  const waits = way.waits > 0.005 ? `, waits ${num(way.waits, 1)} s` : "";
  return `${name}: arrives at ${num(way.arrival, 1)} s${waits}${isInTheWay}`;
}
