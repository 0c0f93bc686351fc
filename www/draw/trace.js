/**
 * A straight motion between two configurations as a curve of the end effector in the workspace, and as straight lines, one for each
 * copy of the unrolled torus, in configuration space.
 */
import { wrap } from "../domain/coordinates.js";

/** @import { Scenario } from "../domain/types.js" */

const TURN = 2 * Math.PI;
/** Longest turn of one joint in one straight piece of a drawn curve, radians. */
const PIECE = 0.14;

/** The signed difference of two coordinates, the short way round on a circle. @param {number} from @param {number} to @param {boolean} circle */
export function way(from, to, circle) {
  return circle ? wrap(to - from) : to - from;
}

/** The same angle between -pi (without it) and pi. @param {number} angle */
export function folded(angle) { return Math.abs(angle) > Math.PI ? way(0, angle, true) : angle; }

/** Curves of the end-effector along motions. */
export class Tracer {
  /** @param {Scenario} scenario */
  constructor(scenario) {
    this.scenario = scenario;
    this.circles = scenario.circles();
    this.straight = scenario.robot !== "arm";
  }

  /**
   * The end-effector's curves along many motions, fetched in one call.
   * @param {Float64Array} ends  rows of 2 * dimension: from, to
   * @param {boolean[]} [circles]  coordinates whose motions go the short way round
   * @returns {{ points: Float64Array, firsts: Uint32Array }}  points of the plane, x and y in turn; curve i has the points from firsts[i] up to firsts[i + 1]
   */
  curves(ends, circles = this.circles) {
    const n = circles.length;
    const motions = ends.length / (2 * n);
    const firsts = new Uint32Array(motions + 1);
    for (let m = 0; m < motions; m++) firsts[m + 1] = firsts[m] + 1 + this.pieces(ends, 2 * n * m, circles);
    const rows = new Float64Array(firsts[motions] * n);
    for (let m = 0; m < motions; m++) {
      const from = 2 * n * m;
      const pieces = firsts[m + 1] - firsts[m] - 1;
      for (let j = 0; j < n; j++) {
        const begin = ends[from + j];
        const turn = way(begin, ends[from + n + j], circles[j]);
        for (let p = 0; p <= pieces; p++) rows[(firsts[m] + p) * n + j] = begin + (turn * p) / pieces;
      }
    }
    return { points: this.scenario.endEffectors(rows), firsts };
  }

  /** @param {Float64Array} ends @param {number} from @param {boolean[]} circles */
  pieces(ends, from, circles) {
    if (this.straight) return 1;
    const n = circles.length;
    let most = 0;
    for (let j = 0; j < n; j++) most = Math.max(most, Math.abs(way(ends[from + j], ends[from + n + j], circles[j])));
    return Math.max(1, Math.min(48, Math.ceil(most / PIECE)));
  }
}

/**
 * A motion of two joints on the square: a straight line, and if it leaves the square copies of it, a whole turn away, that enter on
 * the opposite side. The caller clips them to the square.
 * @param {ArrayLike<number>} ends  from (2), to (2), starting at `at`
 * @param {number} at
 * @param {boolean[]} circles  the sides of the square that are circles
 * @param {boolean[]} short    coordinates whose motions go the short way round
 * @param {(x0: number, y0: number, x1: number, y1: number) => void} draw
 */
export function unrolled(ends, at, circles, short, draw) {
  const x0 = circles[0] ? folded(ends[at]) : ends[at];
  const y0 = circles[1] ? folded(ends[at + 1]) : ends[at + 1];
  const x1 = x0 + way(ends[at], ends[at + 2], short[0]);
  const y1 = y0 + way(ends[at + 1], ends[at + 3], short[1]);
  for (const dx of circles[0] ? shifts(x1) : [0]) {
    for (const dy of circles[1] ? shifts(y1) : [0]) draw(x0 + dx, y0 + dy, x1 + dx, y1 + dy);
  }
}

/** None, and the turn that brings an angle back between -pi and pi. @param {number} angle */
function shifts(angle) { return Math.abs(angle) > Math.PI ? [0, -Math.sign(angle) * TURN] : [0]; }

/** The distance of a point to a segment. @param {number} x @param {number} y @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export function distanceToSegment(x, y, a, b) {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const t = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y);
}
