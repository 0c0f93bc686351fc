/** The sentences of the page. */
import { capital, num, small, tuple } from "../widgets/format.js";
import { touchingSentence } from "../domain/names.js";
import { isNearlySingular } from "./jacobian.js";

/** @import { IkRun } from "./ik-run.js" */
/** @import { Motion } from "./motion.js" */
/** @import { Robot } from "./robot.js" */
/** @import { ReachSession, Refusal } from "./session.js" */
/** @typedef {{ text: string, isBad: boolean }} Sentence */

/** Angles that are named one by one, at most. */
const MOST_NAMED = 2;

/** Why a target is out of reach. */
const REASONS = {
  "too-far": "it is too far away",
  "too-near": "it is too near to the base",
  limits: "the joint limits keep the tip away",
  orientation: "the joint limits do not allow this orientation",
};

/** The collisions of the robot, or nothing. @param {ReachSession} session */
export function collisionText({ robot: { scenario, check } }) {
  return check.free ? "" : capital(`${touchingSentence(scenario, check)}.`);
}

/** The robot for screen readers. @param {ReachSession} session */
export function descriptionOf(session) {
  const { robot } = session;
  const { q, isArm, tip } = robot;
  const { world } = robot.document;
  const where = isArm
    ? `${jointsText(robot)}; the tip is at ${tuple(tip)} metres.`
    : `Its reference point is at ${tuple(tip)} metres, theta is ${num(q[2])} radians.`;
  return `${capital(robotText(robot))}, ${world.obstacles.length} obstacles. ${where} ${collisionText(session) || "No collision."}`;
}

/** The joints of an arm in words. @param {Robot} robot */
function jointsText({ q, slides, coordinates }) {
  if (!slides) return `Joints at ${[...q].map((angle) => num(angle)).join(", ")} radians`;
  return `Joints at ${coordinates.map(({ unit }, i) => `${num(q[i])} ${unit === "m" ? "metres" : "radians"}`).join(", ")}`;
}

/** @param {Robot} robot */
export function robotText({ isArm, dimension }) {
  return isArm ? `${dimension} ${dimension === 1 ? "link" : "links"}` : "a body";
}

/** @param {ReachSession} session @returns {Sentence} */
export function sentenceOf(session) {
  const { mode, run, tipGoal, refusal, orientation } = session;
  const { isArm, slides, dimension, ellipse } = session.robot;
  if (refusal) return refusalSentence(session, refusal);
  if (mode === "between") return motionSentence(session);
  if (run) return ikSentence(session, run);
  const collision = collisionText(session);
  const isBad = collision !== "";
  if (tipGoal?.isStuck)
    return {
      text: `Local minimum: from this configuration the tip gets no closer to ${tuple(tipGoal.wanted)} than ${num(tipGoal.distance)} m, although another configuration would.`,
      isBad,
    };
  if (tipGoal && !tipGoal.reached) {
    return {
      text: `${tuple(tipGoal.wanted)} is out of reach${orientation === null ? "" : " in this orientation"}. The nearest reachable point is ${tuple(tipGoal.point)}, ${num(tipGoal.distance)} m away.`,
      isBad,
    };
  }
  if (isBad) return { text: collision, isBad };
  if (!isArm) return { text: "Drag the body to move it; drag the ring in front of it to turn it.", isBad };
  if (!isNearlySingular(ellipse))
    return {
      text: `Drag the ring to move the tip; drag a link to ${slides ? "turn or slide it" : "turn its joint"}.`,
      isBad,
    };
  if (dimension === 1)
    return { text: `One joint: the tip can only move along a ${slides ? "line" : "circle"}.`, isBad };
  return {
    text: `Nearly singular: the links are almost in line, and the tip can hardly move along them (manipulability ${num(ellipse.manipulability, 3)} m\u00b2).`,
    isBad,
  };
}

/** @param {ReachSession} session @param {Refusal} refusal @returns {Sentence} */
function refusalSentence({ robot: { coordinates, scenario } }, { i, angle, check }) {
  const { name, unit } = coordinates[i];
  const turn =
    unit === "m" && scenario.robot === "arm"
      ? `${name} slid ${num(Math.abs(angle), 3)} m ${angle > 0 ? "out" : "in"}`
      : `${name} turned ${Math.round((180 * Math.abs(angle)) / Math.PI)}\u00b0 ${angle > 0 ? "counter-clockwise" : "clockwise"}`;
  return {
    text: check.free
      ? `Taken back: the robot collides on the way as ${turn}.`
      : `Taken back: ${turn}, and ${touchingSentence(scenario, check)}.`,
    isBad: true,
  };
}

/** @param {ReachSession} session @returns {Sentence} */
function motionSentence(session) {
  const { motion, robot, b } = session;
  const begin = motion.missed.length > 0 ? missText(robot, motion, b) : wayText(session);
  if (motion.hit === null)
    return { text: `${begin} The motion is proven to be collision-free.`, isBad: motion.missed.length > 0 };
  const collision = collisionText(session);
  const touch = motion.touch ? `: ${touchingSentence(robot.scenario, motion.touch)}` : "";
  const where =
    motion.hit >= 0.005
      ? `The motion collides after ${Math.round(100 * motion.hit)}\u00a0%${touch}.`
      : robot.isFree(motion.a)
        ? `The motion collides at once${touch}.`
        : `A itself is in collision${touch}.`;
  return { text: `${begin} ${where}`, isBad: collision !== "" || !robot.isFree(motion.a) || motion.missed.length > 0 };
}

/** How a motion that ends at B gets there. @param {ReachSession} session */
function wayText({ motion, motion: { turns }, robot: { isArm, slides, coordinates }, directions }) {
  const long = coordinates
    .filter(({ isCircle }, i) => isCircle && Math.abs(turns[i]) > Math.PI)
    .map(({ name }) => name);
  const faulty = directions.includes("faulty")
    ? " Here the faulty way is right: no two angles differ by more than half a turn."
    : "";
  if (!isArm)
    return `The body moves ${num(Math.hypot(turns[0], turns[1]))} m, and theta turns ${num(Math.abs(turns[2]))} rad the ${long.length > 0 ? "long" : "short"} way round.${faulty}`;
  const how =
    long.length === 0
      ? "Each joint turns the short way round"
      : `${capital(long.join(" and "))} ${long.length > 1 ? "turn" : "turns"} the long way round`;
  const sum = (/** @type {"rad" | "m"} */ wanted) =>
    turns.reduce((total, turn, i) => total + (coordinates[i].unit === wanted ? Math.abs(turn) : 0), 0);
  const total = slides ? `${num(sum("rad"))} rad and ${num(sum("m"))} m` : `${num(motion.length)} rad`;
  return `${how}, ${total} in total.${faulty}`;
}

/** Where a motion ends by the faulty way. @param {Robot} robot @param {Motion} motion @param {ArrayLike<number>} b */
function missText(robot, motion, b) {
  const end = robot.fitted(motion.at(1));
  const { length } = motion.missed;
  const ends = motion.missed.map(
    (i) => `${robot.coordinates[i].name} ends at ${num(end[i])} rad instead of ${num(b[i])} rad`,
  );
  return `Faulty: ${length > MOST_NAMED ? `${length} joints end elsewhere` : ends.join(" and ")}, so the motion does not end at B.`;
}

/** @param {ReachSession} session @param {IkRun} run @returns {Sentence} */
function ikSentence({ target, orientation, robot: { scenario, slides } }, run) {
  const { method, verdict } = run;
  const { length: count } = run.solutions;
  if (run.isRunning) {
    const { iterations, restarts } = run.run;
    const { error } = run.last;
    const text =
      iterations === 0
        ? `Drag the target, then press Play: ${inSentence(method.title)} moves the tip there step by step.`
        : `${method.title}, start ${restarts + 1}: the error is ${small(error)} ${orientation === null ? "m" : "m or rad"}.`;
    return { text, isBad: false };
  }
  switch (verdict?.verdict) {
    case "out-of-reach": {
      const { reason, nearest } = verdict;
      const digits = nearest && nearest.distance < 0.005 ? 6 : 2;
      const where = nearest
        ? ` The nearest point is ${tuple(nearest.point, digits)}, ${num(nearest.distance, digits)} m away.`
        : "";
      return {
        text: `${tuple(target, digits)} is out of reach: ${REASONS[reason ?? "too-far"]}.${where}`,
        isBad: false,
      };
    }
    case "in-collision": {
      const { touching } = verdict;
      return {
        text: touching
          ? `All solutions found collide: ${touchingSentence(scenario, { free: false, touching })}.`
          : "All solutions found collide.",
        isBad: true,
      };
    }
    case "not-found": {
      const known = slides ? "Whether the target is reachable is not known" : "The target is reachable";
      return { text: `${known}${slides ? ":" : ", but"} ${inSentence(method.title)} did not converge.`, isBad: false };
    }
    default: {
      const elbows = method.id === "closed-form" && count === 2 ? " (elbow up and elbow down)" : "";
      const found =
        count === 1
          ? "One configuration reaches the target"
          : `${count === 2 ? "Two" : count} configurations reach the target${elbows}`;
      return { text: `${found}; ${freeText(count, run.freeCount)}.`, isBad: run.freeCount === 0 };
    }
  }
}

/** A method within a sentence: names of people stay capital. @param {string} title */
function inSentence(title) {
  return title.replace(/^(?!Newton)./, (letter) => letter.toLowerCase());
}

/** The number of solutions that are free, in words. @param {number} count @param {number} free */
function freeText(count, free) {
  if (count === 1) return free === 1 ? "it does not collide" : "it collides";
  if (free === count) return count === 2 ? "neither collides" : "none collides";
  if (free === 0) return count === 2 ? "both collide" : "all of them collide";
  return `${free} of them ${free === 1 ? "is" : "are"} collision-free`;
}
