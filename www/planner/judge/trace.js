/** The line of a path of another program: up to its first contact, and after it; along arcs where it moves along them. */
import { wrap } from "planarium/draw";

/** @import { DrawnPath, Judgement } from "../../paths/judging.js" */
/** @typedef {{ before: Float64Array, after: Float64Array }} Trace   rows of configurations */

/** Radians that an arc turns between two rows. */
const TURN = 0.1;

/**
 * @param {DrawnPath} path
 * @param {number} dimension
 * @param {Judgement["contact"]} contact
 * @param {boolean} isArcs
 * @returns {Trace}
 */
export function traceOf({ rows, indices }, dimension, contact, isArcs) {
  /** @type {number[]} */
  const before = [];
  /** @type {number[]} */
  const after = [];
  const row = (/** @type {number} */ i) => rows.subarray(i * dimension, (i + 1) * dimension);
  let line = before;
  for (let i = 0; i < indices.length; i++) {
    line.push(...row(i));
    if (i + 1 === indices.length) break;
    const next = indices[i + 1];
    const isHere = contact !== null && line === before && contact.edge < next;
    const [from, to] = [row(i), row(i + 1)];
    // A place between two waypoints that are drawn may be on any of the motions between them.
    const share = isHere ? (contact.edge + contact.fraction - indices[i]) / (next - indices[i]) : 1;
    const pieces = isArcs ? Math.ceil(Math.abs(wrap(to[2] - from[2])) / TURN) : 1;
    for (let k = 1; k < pieces; k++) {
      if (k / pieces >= share) meet();
      line.push(...onArc(from, to, k / pieces));
    }
    if (isHere) meet();
  }
  return { before: Float64Array.from(before), after: Float64Array.from(after) };

  /** The line reaches the contact, and goes on after it. */
  function meet() {
    if (!contact || line === after) return;
    before.push(...contact.configuration);
    after.push(...contact.configuration);
    line = after;
  }
}

/**
 * A pose on the arc of constant curvature that begins at a pose, turns to the heading of another one and is as long as
 * the way between both along the heading in the middle.
 * @param {Float64Array} from @param {Float64Array} to @param {number} part
 */
function onArc([x, y, theta], [toX, toY, toTheta], part) {
  const half = wrap(toTheta - theta) / 2;
  const along = (toX - x) * Math.cos(theta + half) + (toY - y) * Math.sin(theta + half);
  // Of a chord that turns by an angle: its length is that of the arc times the sine of half of it, divided by the half.
  const chord = half === 0 ? along * part : (along * Math.sin(half * part)) / Math.sin(half);
  return [
    x + chord * Math.cos(theta + half * part),
    y + chord * Math.sin(theta + half * part),
    theta + 2 * half * part,
  ];
}
