/** What the editor says: the selection and its coordinates, what is refused, what is in collision, how to use a tool. */
import { errorInfo } from "../../app/error-info.js";
import { coordinatesOf } from "../../domain/coordinates.js";
import { touchingSentence } from "../../domain/names.js";
import { capital } from "../../widgets/format.js";
import { EDGES } from "./bounds.js";
import { boundsOf, numbersOf, poseOf } from "./objects.js";
import { collisionsOf } from "./offers.js";
import { partText } from "./parts.js";
import { rounded } from "./units.js";

/** @import { Coordinate, EditTool } from "../../domain/types.js" */
/** @import { Editor } from "./editor.js" */

/** How to use each tool. @type {Record<EditTool, string>} */
const HINTS = {
  select: "Drag the start, goal, any obstacle or the bounds; press Play to plan again.",
  disc: "Drag from the centre of the disc outwards.",
  rectangle: "Drag from corner to corner; hold Shift for a square.",
  polygon: "Click the corners; click the first one again, double-click or press Enter to close the polygon.",
  wall: "Click the points; double-click or press Enter to end the wall, or click its first point to close it.",
};

/** @param {string[]} names @returns {Coordinate[]} */
const metres = (names) => names.map((name) => ({ name, unit: "m", low: -Infinity, high: Infinity, isCircle: false }));

/** The coordinates of points and discs, of points of walls, and of the bounds. */
const PLACE = { disc: metres(["x", "y", "radius"]), wall: metres(["x", "y", "width"]), bounds: metres(EDGES) };

/** @param {string} message */
export function sentence(message) {
  return message && `${capital(message)}.`;
}

/** The selection, in words. @param {Editor} editor @returns {string} */
export function titleOf(editor) {
  const { selected, part, obstacle, shown, parts, tip } = editor;
  if (!selected) return "";
  const name = nameOf(editor);
  if (tip) return `${name}, end effector`;
  if (part === null || parts === 0) return name;
  if (obstacle) return `${name}, ${partText(obstacle, part)}`;
  if (selected.kind === "bounds") return `${name}, ${EDGES[part]} edge`;
  return shown.placed ? `${name}, its heading` : `${name}, joint ${part + 1}`;
}

/** @param {Editor} editor */
function nameOf({ selected, obstacle, target }) {
  if (obstacle) return `Obstacle ${selected?.index}, a ${obstacle.type}`;
  if (selected?.kind === "bounds") return "Bounds";
  if (selected?.kind === "start") return "Start";
  return target ? "Target" : "Goal";
}

/** The coordinates of the selection. @param {Editor} editor */
export function fieldsOf({ document, selected, part, shown, tip, unit, obstacle }) {
  const numbers = tip?.map((value) => rounded(value, unit)) ?? numbersOf(document, selected, part ?? 0);
  const place = boundsOf(document, selected) ? PLACE.bounds : PLACE[obstacle?.type === "wall" ? "wall" : "disc"];
  const coordinates = poseOf(document, selected) && !tip ? coordinatesOf(shown) : place;
  return numbers.map((value, i) => ({ ...coordinates[i], value }));
}

/** The selection and its coordinates. @param {Editor} editor */
export function whereaboutsOf(editor) {
  const places = fieldsOf(editor).map(({ name, value }) => `${name} ${value}`);
  return places.length > 0 ? `${titleOf(editor)}: ${places.join(", ")}.` : "";
}

/** A start or goal in collision, or a target out of reach, in words. @param {Editor} editor @returns {string} */
export function touchingOf(editor) {
  const { scenario, target } = editor.shown;
  const { refusal } = editor.session;
  if (target && refusal) return sentence(errorInfo(refusal.error).message);
  return collisionsOf(editor)
    .map(({ end, check }) => `The ${end} is in collision: ${touchingSentence(scenario, check)}.`)
    .join(" ");
}

/** The sentence above the stage; empty during a run. @param {Editor} editor @returns {string} */
export function sentenceOf({ on, reason, touching, tool, shown, session: { clock } }) {
  if (!on) return "";
  if (reason) return reason;
  if (clock.now > 0 || clock.playing) return "";
  if (touching && shown.target) return touching;
  return touching ? `${touching} Move it out of collision to plan.` : HINTS[tool];
}
