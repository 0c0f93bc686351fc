/** What is known of a path, in sentences. */
import { counted } from "../../app/dom.js";
import { obstacleName, robotName } from "../../domain/names.js";
import { num, tuple } from "../../widgets/format.js";

/** @import { DrawnPath, Judgement } from "../../paths/judging.js" */
/** @import { Coordinate, Scenario } from "../../domain/types.js" */
/** @typedef {NonNullable<Judgement["contact"]>} Contact */
/** @typedef {NonNullable<Judgement["turns"]>["first"][number]} Turn */

/** @param {number} edge */
const between = (edge) => `between waypoints ${edge} and ${edge + 1}`;

/**
 * The obstacle that a path touches first; "bounds", or null for what is no obstacle.
 * @param {Contact} contact
 * @returns {number | "bounds" | null}
 */
export function touchedBy({ with: what }) {
  if (what === "bounds") return "bounds";
  return typeof what === "object" && "obstacle" in what ? what.obstacle : null;
}

/**
 * @param {Contact} contact
 * @param {Scenario["robot"]} robot
 * @param {Coordinate[]} coordinates
 */
function contactText({ with: what, part, point, edge, fraction }, robot, coordinates) {
  const mover = robot === "arm" ? `link ${part + 1}` : `the ${robotName(robot)}`;
  const place = point ? ` at ${tuple(point)}` : "";
  const where = `${between(edge)}, after ${num(100 * fraction, 1)} % of the way`;
  if (what === "bounds") return `${mover} leaves the bounds${place}, ${where}`;
  if (what === "unproven") return `it is too near to obstacles for too long to be proven free, ${where}`;
  if ("obstacle" in what) return `${mover} touches ${obstacleName(what.obstacle)}${place}, ${where}`;
  if ("joint-limit" in what) return `${coordinates[what["joint-limit"]].name} leaves its limits, ${where}`;
  return `${coordinates[what["half-turn"]].name} turns by half a turn ${between(edge)}, in either direction`;
}

/** Why a car cannot drive a turn. @param {Turn} turn */
export function turnText({ fault, radius, slip }) {
  if (fault === "sideways") return `slips by ${num((slip * 180) / Math.PI, 1)}\u00b0`;
  if (fault === "no-speed") return "goes where the car has no speed";
  return radius === null ? "is too tight" : `needs a radius of ${num(radius)} m`;
}

/**
 * The verdict on a path.
 * @param {Judgement} judgement
 * @param {Scenario["robot"]} robot
 * @param {Coordinate[]} coordinates
 */
export function verdictText({ waypoints, contact, clearance, turns }, robot, coordinates) {
  const parts = [
    contact ? `Not free: ${contactText(contact, robot, coordinates)}` : `Free, with ${counted(waypoints, "waypoint")}`,
  ];
  if (clearance)
    parts.push(
      `The smallest clearance is ${num(clearance.distance, 3)} m, to ${obstacleName(clearance.obstacle)}, ${waypoints > 1 ? between(clearance.edge) : "at its only waypoint"}`,
    );
  else if (!contact) parts.push("There is no obstacle");
  if (turns) {
    const [first] = turns.first;
    parts.push(
      first
        ? `The car cannot drive ${counted(turns.count, "turn")}: the first, ${between(first.edge)}, ${turnText(first)}`
        : "The car can drive every turn",
    );
  }
  return parts.map((part) => `${part}.`).join(" ");
}

/** What was left out of a file, in sentences; empty where nothing was. @param {DrawnPath} path */
export function readText({ count, indices, report: { columns, dropped, notes } }) {
  const left = columns.filter(({ meaning }) => meaning === null).map(({ name }) => name);
  const parts = [
    left.length > 0 ? `Left out: ${left.length === 1 ? "column" : "columns"} ${left.join(", ")}` : "",
    ...dropped.map(({ what, count: some }) => `Left out: ${some} ${what}`),
    ...notes.map((note) => note[0].toUpperCase() + note.slice(1).replace(/\.$/, "")),
    indices.length < count ? `Drawn: ${counted(indices.length, "waypoint")} of ${counted(count, "waypoint")}` : "",
  ];
  return parts
    .filter(Boolean)
    .map((part) => `${part}.`)
    .join(" ");
}
