/**
 * An arm of six joints in three dimensions, covered by spheres, that reaches from one compartment of a shelf into
 * another.
 */

/** Joints 0 and 5 turn without end, the others between limits; radians. Heavy joints count more in the metric. */
const joint = (/** @type {number} */ most, /** @type {number} */ weight) =>
  /** @type {const} */ ({ kind: "interval", low: -most, high: most, weight });
const turn = (/** @type {number} */ weight) => /** @type {const} */ ({ kind: "circle", weight });

/** Height of the shoulder, then the lengths of upper arm, forearm, wrist, hand and fingers; metres. */
const [SHOULDER, UPPER, FORE, WRIST, HAND, FINGER] = [0.55, 0.7, 0.6, 0.16, 0.16, 0.12];
/** Boxes: the least and the greatest x, y and z. A shelf with two boards between two sides. */
export const BOXES = [
  [0.72, -0.62, 0, 1.12, -0.58, 1.35],
  [0.72, 0.58, 0, 1.12, 0.62, 1.35],
  ...[0.28, 0.7, 1.13].map((z) => [0.72, -0.58, z, 1.12, 0.58, z + 0.03]),
  [0.72, -0.015, 0.31, 1.12, 0.015, 0.7],
];

/**
 * Where a segment of spheres begins and ends, along the arm, and how thick it is: upper arm, forearm, wrist, hand.
 * @type {[length: number, spheres: number, radius: number][]}
 */
const LINKS = [
  [UPPER, 6, 0.075],
  [FORE, 6, 0.06],
  [WRIST, 2, 0.055],
  [HAND, 2, 0.05],
];
/** How many spheres there are, with the two fingers; the first ones belong to the upper arm. */
export const SPHERES = LINKS.reduce((sum, [, spheres]) => sum + spheres, 2);
const OWN = 3;

/**
 * The spheres of a configuration: x, y, z and radius of each.
 * @param {ArrayLike<number>} q
 * @param {number} [at]
 * @param {Float64Array} [spheres]
 */
export function place(q, at = 0, spheres = new Float64Array(4 * SPHERES)) {
  let [p, x, y, z] = [
    [0, 0, SHOULDER],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  /** Turns two axes into one another. @param {number[]} a @param {number[]} b @param {number} angle */
  const turned = (a, b, angle) => {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return [a.map((v, i) => c * v + s * b[i]), b.map((v, i) => c * v - s * a[i])];
  };
  let n = 0;
  const put = (/** @type {number[]} */ point, /** @type {number} */ radius) => {
    spheres.set([...point, radius], 4 * n);
    n += 1;
  };
  const along = (/** @type {number[]} */ axis, /** @type {number} */ length) => p.map((v, i) => v + length * axis[i]);
  [x, y] = turned(x, y, q[at]);
  LINKS.forEach(([length, spheres, radius], link) => {
    if (link < 3) [x, z] = turned(x, z, q[at + 1 + link]);
    else [x, y] = turned(x, y, q[at + 4]);
    for (let i = 1; i <= spheres; i += 1) put(along(x, (length * i) / spheres), radius);
    p = along(x, length);
  });
  [y, z] = turned(y, z, q[at + 5]);
  p = along(x, FINGER / 2);
  for (const side of [-1, 1]) put(along(y, 0.06 * side), 0.035);
  return spheres;
}

/**
 * The distance of a point from a box; 0 inside.
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {number[]} box
 */
function toBox(x, y, z, [ax, ay, az, bx, by, bz]) {
  return Math.hypot(Math.max(ax - x, 0, x - bx), Math.max(ay - y, 0, y - by), Math.max(az - z, 0, z - bz));
}

const spheres = new Float64Array(4 * SPHERES);

/** @type {import("planarium").ProblemDescription} */
export const description = {
  space: {
    coordinates: [turn(2), joint(1.9, 2), joint(2.6, 1.5), joint(2, 0.7), joint(2, 0.5), turn(0.3)],
    metric: "sum",
  },
  start: [-0.53, 0.93, -1.95, 0.57, 1.23, 0.61],
  goal: [0.1, 1.1, -1.51, 0.53, 1.95, 0.33],
  // What lies beyond a joint is no farther from it than all lengths that follow.
  reach: [
    UPPER + FORE + WRIST + HAND + FINGER,
    UPPER + FORE + WRIST + HAND + FINGER,
    FORE + WRIST + HAND + FINGER,
    WRIST + HAND + FINGER,
    HAND + FINGER,
    FINGER,
  ],
  clearance(rows, clearances) {
    for (let i = 0; i < clearances.length; i += 1) {
      place(rows, 6 * i, spheres);
      let least = Infinity;
      for (let k = 0; k < SPHERES; k += 1) {
        const [x, y, z, radius] = spheres.subarray(4 * k, 4 * k + 4);
        least = Math.min(least, z - radius); // the floor
        for (const box of BOXES) least = Math.min(least, toBox(x, y, z, box) - radius);
        if (k < 12) continue;
        // The hand and the arm itself: its column, and the upper arm.
        least = Math.min(least, toBox(x, y, z, [0, 0, 0, 0, 0, SHOULDER]) - radius - 0.1);
        for (let other = OWN; other < 6; other += 1) {
          const [ox, oy, oz, own] = spheres.subarray(4 * other, 4 * other + 4);
          least = Math.min(least, Math.hypot(x - ox, y - oy, z - oz) - radius - own);
        }
      }
      clearances[i] = least;
    }
  },
};

/** @type {import("planarium").PlannerOptions} */
export const options = { algorithm: "rrt-connect", step: 0.7, shortcut: 60, seed: 1 };
