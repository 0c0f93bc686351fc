/** What the three pages share: a planner that is stepped once a frame, and then a robot that follows its path. */
import init, { Problem } from "planarium";

/** Seconds that a robot takes along its path, there and back. */
const SECONDS = 8;

/**
 * Plans for a problem, a slice a frame, and moves the robot along the path.
 * @param {import("planarium").ProblemDescription} description
 * @param {import("planarium").PlannerOptions} options
 * @param {(planner: import("planarium").Planner) => void} grow  draws what is new
 * @param {(q: number[], path: number[][] | null) => void} show  draws the robot, and the path once there is one
 */
export async function run(description, options, grow, show) {
  await init();
  const problem = new Problem(description);
  const planner = problem.planner(options);
  const status = /** @type {HTMLElement} */ (document.querySelector("#status"));
  const circles = description.space.coordinates.map(({ kind }) => kind === "circle");
  /** @type {number[][] | null} */
  let path = null;
  let began = 0;
  /** @param {number} now */
  const frame = (now) => {
    if (path === null) {
      planner.stepFor(8);
      grow(planner);
      status.textContent = `${planner.status}: ${planner.vertexCount} vertices`;
      if (planner.status === "solved") {
        const result = planner.result();
        [path, began] = [result.path, now];
        status.textContent = `solved: ${planner.vertexCount} vertices, a path of ${path.length} waypoints, every edge ${result.edge_check ?? "proven"}`;
      }
    }
    const part = path === null ? 0 : (1 - Math.cos(((now - began) / 1000 / SECONDS) * 2 * Math.PI)) / 2;
    show(path === null ? [...description.start] : along(path, part, circles), path);
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

/**
 * The configuration at a fraction of a path.
 * @param {number[][]} path
 * @param {number} part
 * @param {boolean[]} circles
 */
function along(path, part, circles) {
  const difference = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    a.map((v, i) => {
      const d = b[i] - v;
      return circles[i] ? d - 2 * Math.PI * Math.round(d / (2 * Math.PI)) : d;
    });
  const lengths = path.slice(1).map((q, i) => Math.hypot(...difference(path[i], q)));
  let left = part * lengths.reduce((sum, length) => sum + length, 0);
  const at = lengths.findIndex((length) => (left -= length) <= 0);
  if (at < 0) return path[path.length - 1];
  const fraction = 1 + left / lengths[at];
  return difference(path[at], path[at + 1]).map((d, i) => path[at][i] + fraction * d);
}
