/**
 * How far the tip of a planar arm goes when its joints turn a little: the ellipse of its velocities where the joints' have norm 1.
 *
 * Source: Yoshikawa 1985, "Manipulability of Robotic Mechanisms". Column i of the Jacobian is the tip's way when joint i turns: the
 * vector from that joint to the tip, a quarter turn on. The half axes are the roots of the eigenvalues of J times its transpose.
 */

/** @import { Part } from "../domain/types.js" */

/**
 * @typedef {object} Ellipse
 * @property {number} major           half axes, metres a radian
 * @property {number} minor
 * @property {number} angle           of the major one, radians
 * @property {number} manipulability  their product, square metres; 0 in a singular pose
 */

/** Below this part of the major axis the minor one counts as nearly nothing. */
const NEARLY = 0.06;

/** @param {Part[]} parts   the links, from the base on @returns {Ellipse} */
export function ellipseOf(parts) {
  const [tipX, tipY] = tipOf(parts);
  let xx = 0;
  let xy = 0;
  let yy = 0;
  for (const part of parts) {
    if (part.type !== "capsule") continue;
    const x = -(tipY - part.a[1]);
    const y = tipX - part.a[0];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const middle = (xx + yy) / 2;
  const half = Math.hypot((xx - yy) / 2, xy);
  const determinant = Math.max(0, xx * yy - xy * xy);
  const major = Math.sqrt(middle + half);
  // The product is known more exactly than the smaller of the two.
  const manipulability = Math.sqrt(determinant);
  return { major, minor: major > 0 ? manipulability / major : 0, angle: 0.5 * Math.atan2(2 * xy, xx - yy), manipulability };
}

/** @param {Ellipse} ellipse */
export function isNearlySingular({ major, minor }) { return minor < NEARLY * major; }

/** The end of the last link. @param {Part[]} parts @returns {[number, number]} */
export function tipOf(parts) {
  const last = parts[parts.length - 1];
  return last?.type === "capsule" ? last.b : [0, 0];
}
