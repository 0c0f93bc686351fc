/**
 * A straight motion between two configurations as straight lines, one for each copy of the unrolled torus, in
 * configuration space.
 */
import { difference, wrap } from "planarium/draw";

const TURN = 2 * Math.PI;

/** The same angle between -pi (without it) and pi. @param {number} angle */
export function folded(angle) {
  return Math.abs(angle) > Math.PI ? wrap(angle) : angle;
}

/**
 * A motion of two joints on the square: a straight line, and if it leaves the square copies of it, a whole turn away,
 * that enter on the opposite side. The caller clips them to the square.
 * @param {ArrayLike<number>} ends  from (2), to (2), starting at `at`
 * @param {number} at
 * @param {boolean[]} circles  the sides of the square that are circles
 * @param {boolean[]} short    coordinates whose motions go the short way round
 * @param {(x0: number, y0: number, x1: number, y1: number) => void} draw
 */
export function unrolled(ends, at, circles, short, draw) {
  const x0 = circles[0] ? folded(ends[at]) : ends[at];
  const y0 = circles[1] ? folded(ends[at + 1]) : ends[at + 1];
  const x1 = x0 + difference(ends[at], ends[at + 2], short[0]);
  const y1 = y0 + difference(ends[at + 1], ends[at + 3], short[1]);
  for (const dx of circles[0] ? shifts(x1) : [0]) {
    for (const dy of circles[1] ? shifts(y1) : [0]) draw(x0 + dx, y0 + dy, x1 + dx, y1 + dy);
  }
}

/** None, and the turn that brings an angle back between -pi and pi. @param {number} angle */
function shifts(angle) {
  return Math.abs(angle) > Math.PI ? [0, -Math.sign(angle) * TURN] : [0];
}

/**
 * The distance of a point to a segment.
 * @param {number} x
 * @param {number} y
 * @param {ArrayLike<number>} a
 * @param {ArrayLike<number>} b
 */
export function distanceToSegment(x, y, a, b) {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const t = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y);
}
