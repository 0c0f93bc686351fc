/** Rounding, so that edited documents stay readable. */

/** The unit of angles, radians. */
export const ANGLE = 1e-4;

/** Rounds to whole units, without binary residue. @param {number} value @param {number} unit  a power of ten */
export function rounded(value, unit) {
  return Number((Math.round(value / unit) * unit).toFixed(Math.max(0, -Math.round(Math.log10(unit))))) + 0; // no -0, which JSON does not store
}

/**
 * Rounds the joints of an arm that follows its end effector: finely, so that the end effector stays in place.
 * @param {ArrayLike<number>} pose
 */
export function fine(pose) {
  return Array.from(pose, (angle) => rounded(angle, 1e-7));
}
