/** The sentences of the page. */
import { capital, num, small, tuple } from "../widgets/format.js";
import { touchingSentence } from "../domain/names.js";
import { isNearlySingular } from "./jacobian.js";

/** @import { IkRun } from "./ik-run.js" */
/** @import { ArmSession } from "./session.js" */
/** @typedef {{ text: string, isBad: boolean }} Sentence */

/** Why a target is out of reach. */
const REASONS = {
  "too-far": "it is too far away", "too-near": "it is too near to the base", limits: "the joint limits keep the tip away",
  orientation: "the joint limits do not allow this orientation",
};

/** The collisions of the arm, or nothing. @param {ArmSession} session */
export function collisionText({ arm: { scenario, check } }) { return check.free ? "" : capital(`${touchingSentence(scenario, check)}.`); }

/** The arm for screen readers. @param {ArmSession} session */
export function descriptionOf(session) {
  const { arm: { q, dimension, tip, document: { world } } } = session;
  return `${linksText(dimension)}, ${world.obstacles.length} obstacles. Joints at ${[...q].map((angle) => num(angle)).join(", ")} radians; the tip is at ${tuple(tip)} metres. ${collisionText(session) || "No collision."}`;
}

/** @param {number} count */
export function linksText(count) { return `${count} ${count === 1 ? "link" : "links"}`; }

/** @param {ArmSession} session @returns {Sentence} */
export function sentenceOf(session) {
  const { mode, run, tipGoal, arm: { dimension, ellipse }, orientation } = session;
  if (mode === "between") return motionSentence(session);
  if (run) return ikSentence(session, run);
  const collision = collisionText(session);
  const isBad = collision !== "";
  if (tipGoal?.isStuck) return { text: `Local minimum: from this configuration the tip gets no closer to ${tuple(tipGoal.wanted)} than ${num(tipGoal.distance)} m, although another configuration would.`, isBad };
  if (tipGoal && !tipGoal.reached) {
    return { text: `${tuple(tipGoal.wanted)} is out of reach${orientation === null ? "" : " in this orientation"}. The nearest reachable point is ${tuple(tipGoal.point)}, ${num(tipGoal.distance)} m away.`, isBad };
  }
  if (isBad) return { text: collision, isBad };
  if (!isNearlySingular(ellipse)) return { text: "Drag the ring to move the tip; drag a link to turn its joint.", isBad };
  if (dimension === 1) return { text: "One joint: the tip can only move along a circle.", isBad };
  return { text: `Nearly singular: the links are almost in line, and the tip can hardly move along them (manipulability ${num(ellipse.manipulability, 3)} m\u00b2).`, isBad };
}

/** @param {ArmSession} session @returns {Sentence} */
function motionSentence(session) {
  const { motion, arm } = session;
  const long = arm.joints.filter((_, i) => Math.abs(motion.turns[i]) > Math.PI).map(({ name }) => name);
  const how = long.length === 0 ? "Each joint turns the short way round" : `${capital(long.join(" and "))} ${long.length > 1 ? "turn" : "turns"} the long way round`;
  const begin = `${how}, ${num(motion.length)} rad in total.`;
  if (motion.hit === null) return { text: `${begin} The motion is proven to be collision-free.`, isBad: false };
  const collision = collisionText(session);
  const where = motion.hit >= 0.005 ? `The motion collides after ${Math.round(100 * motion.hit)} %.` : arm.isFree(motion.a) ? "The motion collides at once." : "A itself is in collision.";
  return { text: `${begin} ${where} ${collision}`.trimEnd(), isBad: collision !== "" || !arm.isFree(motion.a) };
}

/** @param {ArmSession} session @param {IkRun} run @returns {Sentence} */
function ikSentence({ target, orientation, arm: { scenario } }, run) {
  const { method, verdict, solutions: { length: count } } = run;
  if (run.isRunning) {
    const { run: { iterations, restarts }, last: { error } } = run;
    const text = iterations === 0 ? `Drag the target, then press Play: ${inSentence(method.title)} moves the tip there step by step.`
      : `${method.title}, start ${restarts + 1}: the error is ${small(error)} ${orientation === null ? "m" : "m or rad"}.`;
    return { text, isBad: false };
  }
  switch (verdict?.verdict) {
    case "out-of-reach": {
      const { reason, nearest } = verdict;
      const digits = nearest && nearest.distance < 0.005 ? 6 : 2;
      const where = nearest ? ` The nearest point is ${tuple(nearest.point, digits)}, ${num(nearest.distance, digits)} m away.` : "";
      return { text: `${tuple(target, digits)} is out of reach: ${REASONS[reason ?? "too-far"]}.${where}`, isBad: false };
    }
    case "in-collision": {
      const { touching } = verdict;
      return { text: touching ? `All solutions found collide: ${touchingSentence(scenario, { free: false, touching })}.` : "All solutions found collide.", isBad: true };
    }
    case "not-found": return { text: `The target is reachable, but ${inSentence(method.title)} did not converge.`, isBad: false };
    default: {
      const elbows = method.id === "closed-form" && count === 2 ? " (elbow up and elbow down)" : "";
      const found = count === 1 ? "One configuration reaches the target" : `${count === 2 ? "Two" : count} configurations reach the target${elbows}`;
      return { text: `${found}; ${freeText(count, run.freeCount)}.`, isBad: run.freeCount === 0 };
    }
  }
}

/** A method within a sentence: names of people stay capital. @param {string} title */
function inSentence(title) { return title.replace(/^(?!Newton)./, (letter) => letter.toLowerCase()); }

/** The number of solutions that are free, in words. @param {number} count @param {number} free */
function freeText(count, free) {
  if (count === 1) return free === 1 ? "it does not collide" : "it collides";
  if (free === count) return count === 2 ? "neither collides" : "none collides";
  if (free === 0) return count === 2 ? "both collide" : "all of them collide";
  return `${free} of them ${free === 1 ? "is" : "are"} collision-free`;
}
