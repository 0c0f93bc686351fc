/** What the editor finds out about its documents: which of several suits, what collides, what the selection can become. */
import { objectsOf, poseOf } from "./objects.js";
import { cut, placeOf } from "./parts.js";

/** @import { Check, Configuration, Obstacle, ScenarioDocument } from "../../domain/types.js" */
/** @import { Editor } from "./editor.js" */
/** @typedef {{ end: "start" | "goal", pose: Configuration, check: Check }} Collision */

/** Whether a polygon lies in another one, by document. @type {WeakMap<ScenarioDocument, Map<Obstacle, boolean>>} */
const inside = new WeakMap();

/**
 * The first document with start and goal free, or else the first that the core accepts.
 * @param {Editor} editor
 * @param {ScenarioDocument[]} documents
 */
export function best(editor, documents) {
  /** @param {ScenarioDocument} document @returns {number} 0: refused, 1: start or goal in collision, 2: both free */
  const suits = (document) => {
    const scenario = editor.read(document);
    const poses = objectsOf(document, editor.shown.query).map((object) => poseOf(document, object));
    const free = scenario && poses.every((pose) => !pose || scenario.check(pose).free);
    scenario?.free();
    return scenario ? 1 + Number(free) : 0;
  };
  return documents.find((one) => suits(one) === 2) ?? documents.find(suits) ?? documents[0];
}

/** Start and goal in collision, once planning was refused. @param {Editor} editor @returns {Collision[]} */
export function collisionsOf({ session, shown }) {
  if (!session.refusal) return [];
  return /** @type {const} */ (["start", "goal"]).flatMap((end) => {
    const pose = shown[end];
    const check = pose && shown.scenario.check(pose);
    return check && !check.free ? [{ end, pose, check }] : [];
  });
}

/** The kind of the selection; an "end" is a start or goal. @param {Editor} editor */
export function kindOf({ obstacle, selected }) {
  if (obstacle) return obstacle.type;
  return selected?.kind === "bounds" ? "bounds" : selected ? "end" : "";
}

/** For the selected goal of an arm: one configuration, or any that reaches a point. @param {Editor} editor */
export function goalOf({ selected, shown, target }) {
  return selected?.kind !== "goal" || shown.scenario.robot !== "arm" ? "" : target ? "target" : "pose";
}

/** For the selected polygon: whether it can be cut out of another, or its selected hole filled. @param {Editor} editor */
export function holeOf({ obstacle, selected, part, document }) {
  if (!selected || obstacle?.type !== "polygon") return "";
  if (part !== null && (placeOf(obstacle, part)?.line ?? 0) > 0) return "fill";
  return isInside(document, obstacle, selected.index) ? "cut" : "";
}

/** @param {ScenarioDocument} document @param {Obstacle} polygon @param {number} index  of it */
function isInside(document, polygon, index) {
  const known = inside.get(document) ?? new Map();
  inside.set(document, known);
  if (!known.has(polygon)) known.set(polygon, cut(document.world.obstacles, index) !== null);
  return known.get(polygon);
}
