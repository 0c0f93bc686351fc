/** The run of the start page: its picture is drawn when pages are built, and the page grows it again. */

/** A generated scenario and a planner, under the names of documents. */
export const RUN = /** @type {const} */ ({
  kind: "discs",
  options: { count: 90, smallest: 0.025, largest: 0.05, gap: 0.07, radius: 0.015, seed: 6 },
  algorithm: "rrt-star",
  settings: { step: 0.07, improve_iterations: 1300, max_iterations: 100_000, seed: 3 },
});
