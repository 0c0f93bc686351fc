/** Two discs that change places among pillars: both move at once, so a configuration has four numbers. */

/** The radius of both discs, and the side of the room; metres. */
export const RADIUS = 0.28;
export const SIDE = 4;
/** Pillars: x, y, radius. */
export const PILLARS = [
  [2, 2, 0.45],
  [0.9, 3.1, 0.25],
  [3.1, 0.9, 0.25],
  [2, 3.75, 0.2],
  [2, 0.25, 0.2],
  [0.75, 1.0, 0.18],
  [3.25, 3.0, 0.18],
];

const coordinate = /** @type {const} */ ({ kind: "interval", low: RADIUS, high: SIDE - RADIUS });

/** @type {import("planarium").ProblemDescription} */
export const description = {
  space: { coordinates: [coordinate, coordinate, coordinate, coordinate] },
  start: [0.6, 2, 3.4, 2],
  goal: [3.4, 2, 0.6, 2],
  // A disc moves a metre while its coordinate changes by one.
  reach: [1, 1, 1, 1],
  clearance(rows, clearances) {
    for (let i = 0; i < clearances.length; i += 1) {
      const [ax, ay, bx, by] = rows.subarray(4 * i, 4 * i + 4);
      let clearance = Math.hypot(ax - bx, ay - by) - 2 * RADIUS;
      for (const [x, y, radius] of PILLARS) {
        clearance = Math.min(
          clearance,
          Math.hypot(ax - x, ay - y) - radius - RADIUS,
          Math.hypot(bx - x, by - y) - radius - RADIUS,
        );
      }
      clearances[i] = clearance;
    }
  },
};

/** @type {import("planarium").PlannerOptions} */
export const options = { algorithm: "rrt-connect", step: 0.2, shortcut: 400, seed: 8 };
