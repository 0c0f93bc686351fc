/** A drone that flies through a town of voxels: a ball in three dimensions. */

/** Voxels across, deep and high, each a metre wide; and the radius of the drone. */
export const [WIDE, DEEP, HIGH] = [24, 24, 10];
export const RADIUS = 0.4;
/** Distances beyond this are not looked for. */
const FAR = 3;

/** The heights of the houses, by a generator of its own so that the town is the same everywhere. */
export const heights = (() => {
  let seed = 7;
  const draw = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
  return Array.from({ length: WIDE }, (_, x) =>
    Array.from({ length: DEEP }, (_, y) => {
      const isStreet = x % 6 < 2 || y % 6 < 2;
      const height = Math.floor(3 + 8 * draw());
      return isStreet ? 0 : Math.min(height, HIGH);
    }),
  );
})();

/** Whether a voxel is taken: houses, and bridges over streets. @param {number} x @param {number} y @param {number} z */
export function isTaken(x, y, z) {
  return z < heights[x][y] || (x % 6 < 2 && y % 6 === 4 && z >= 4 && z < 6) || (y % 6 < 2 && x % 6 === 3 && z < 3);
}

/**
 * The clearance of the drone at a point: the distance to the nearest voxel that is taken, less its radius.
 * @param {number} x
 * @param {number} y
 * @param {number} z
 */
function clearanceAt(x, y, z) {
  let least = Math.min(FAR, z, HIGH - z, x, WIDE - x, y, DEEP - y);
  const from = (/** @type {number} */ at) => Math.max(0, Math.floor(at - least));
  const to = (/** @type {number} */ at, /** @type {number} */ end) => Math.min(end - 1, Math.floor(at + least));
  for (let i = from(x); i <= to(x, WIDE); i += 1) {
    for (let j = from(y); j <= to(y, DEEP); j += 1) {
      for (let k = from(z); k <= to(z, HIGH); k += 1) {
        if (isTaken(i, j, k))
          least = Math.min(
            least,
            Math.hypot(Math.max(i - x, 0, x - i - 1), Math.max(j - y, 0, y - j - 1), Math.max(k - z, 0, z - k - 1)),
          );
      }
    }
  }
  return least - RADIUS;
}

const side = (/** @type {number} */ length) => /** @type {const} */ ({ kind: "interval", low: 0, high: length });

/** @type {import("planarium").ProblemDescription} */
export const description = {
  space: { coordinates: [side(WIDE), side(DEEP), side(HIGH)] },
  start: [1, 1, 1],
  goal: [19, 19, 1.2],
  clearance(rows, clearances) {
    for (let i = 0; i < clearances.length; i += 1)
      clearances[i] = clearanceAt(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]);
  },
};

/** @type {import("planarium").PlannerOptions} */
export const options = { algorithm: "rrt-star", step: 3, improveIterations: 1000, seed: 3 };
