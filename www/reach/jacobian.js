/**
 * The velocities of the tip for joint velocities of norm 1: the manipulability ellipse.
 *
 * Source: Yoshikawa 1985, "Manipulability of Robotic Mechanisms". Column i of the Jacobian is the velocity of the tip
 * as joint i turns: the vector from that joint to the tip, rotated by a quarter turn; of a joint that slides, the
 * direction of its link. The half axes are the roots of the eigenvalues of J J^T.
 */

/** @import { Part, Point } from "../domain/types.js" */

/** The ratio of the axes below which the arm counts as nearly singular. */
const NEARLY = 0.06;

/**
 * The half axes, metres per radian, or per metre of a joint that slides; the angle of the major one, radians; and their
 * product, square metres, 0 where the arm is singular.
 * @param {Part[]} parts   the links, from the base on
 * @param {(number | null)[]} [slides]   the direction of each joint that slides, radians
 */
export function ellipseOf(parts, slides = []) {
  const [tipX, tipY] = tipOf(parts);
  let xx = 0;
  let xy = 0;
  let yy = 0;
  for (const [i, part] of parts.entries()) {
    if (part.type !== "capsule") continue;
    const slide = slides[i] ?? null;
    const [x, y] = slide === null ? [-(tipY - part.a[1]), tipX - part.a[0]] : [Math.cos(slide), Math.sin(slide)];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const middle = (xx + yy) / 2;
  const half = Math.hypot((xx - yy) / 2, xy);
  const determinant = Math.max(0, xx * yy - xy * xy);
  const major = Math.sqrt(middle + half);
  // The product is more exact than the smaller axis.
  const manipulability = Math.sqrt(determinant);
  return {
    major,
    minor: major > 0 ? manipulability / major : 0,
    angle: 0.5 * Math.atan2(2 * xy, xx - yy),
    manipulability,
  };
}

/** @param {ReturnType<typeof ellipseOf>} ellipse */
export function isNearlySingular({ major, minor }) {
  return minor < NEARLY * major;
}

/** The end of the last link. @param {Part[]} parts @returns {Point} */
export function tipOf(parts) {
  const last = parts[parts.length - 1];
  return last?.type === "capsule" ? last.b : [0, 0];
}
