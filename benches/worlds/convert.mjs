/** Maps and parking cases of other people as scenarios, by the readers of planarium-formats; and queries on maps. */
import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";

/** @typedef {{ name: string, start: number[], goal: number[], goal_tolerance?: object }} Query */
/** @typedef {{ format: string, name: string, world: any, robot: any, queries: Query[] }} Scenario */

/**
 * Cells from the lowest row, 1 for obstacles; the lower left corner of the grid, and the sides of the cell there.
 * @typedef {{ rows: string[], resolution: number, origin: number[], sides: number[][] }} Grid
 */
/** @typedef {{ seconds: number, report: any, scenario: Scenario, grid: Grid | null }} Reading */
/** @typedef {(files: string[], options: object, times?: number) => Promise<Reading>} Read */

/** The clearance that ends of queries on grids have beside the robot, in cells. */
const MARGIN = 0.05;

/** A generator of numbers in [0, 1), by Marsaglia's xorshift. @param {number} seed */
function random(seed) {
  let state = (seed * 2654435761 + 88172645) >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state >>>= 0;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 4294967296;
  };
}

/**
 * Pairs of free cells between which a disc can move: the cells whose middle is far enough from every blocked one,
 * joined to their neighbours.
 * @param {boolean[][]} blocked @param {number} radius in cells @param {number} count @param {number} seed
 */
function pairs(blocked, radius, count, seed) {
  const [height, width] = [blocked.length, blocked[0].length];
  const far = Math.ceil(radius + 1);
  // A robot between the middles of neighbours keeps at least as far as this from what is near neither.
  const reach = Math.hypot(radius + MARGIN, 0.5);
  const is_free = (/** @type {number} */ x, /** @type {number} */ y) => {
    if (x + 0.5 < reach || y + 0.5 < reach || width - x - 0.5 < reach || height - y - 0.5 < reach) return false;
    for (let v = Math.max(0, y - far); v <= Math.min(height - 1, y + far); v += 1) {
      for (let u = Math.max(0, x - far); u <= Math.min(width - 1, x + far); u += 1) {
        if (blocked[v][u] && Math.hypot(Math.max(0, Math.abs(u - x) - 0.5), Math.max(0, Math.abs(v - y) - 0.5)) < reach)
          return false;
      }
    }
    return true;
  };
  const part = new Int32Array(width * height).fill(-1);
  /** @type {number[]} */
  const free = [];
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1)
      if (is_free(x, y)) {
        part[y * width + x] = 0;
        free.push(y * width + x);
      }
  let parts = 0;
  for (const first of free) {
    if (part[first] !== 0) continue;
    parts += 1;
    const queue = [first];
    part[first] = parts;
    while (queue.length > 0) {
      const at = /** @type {number} */ (queue.pop());
      for (const next of [at - 1, at + 1, at - width, at + width]) {
        if (part[next] === 0) {
          part[next] = parts;
          queue.push(next);
        }
      }
    }
  }
  const draw = random(seed);
  const found = [];
  for (let tries = 0; found.length < count && tries < 1000 * count; tries += 1) {
    const [a, b] = [0, 0].map(() => free[Math.floor(draw() * free.length)]);
    if (a !== b && part[a] === part[b])
      found.push([a, b].map((at) => [(at % width) + 0.5, Math.floor(at / width) + 0.5]));
  }
  return found;
}

/**
 * Queries between the middles of cells.
 * @param {Grid} grid @param {number} radius in metres @param {number} count @param {number} seed
 * @returns {Query[]}
 */
function queriesOn({ rows, resolution, origin, sides: [right, up] }, radius, count, seed) {
  const blocked = rows.map((row) => [...row].map((cell) => cell === "1"));
  const place = (/** @type {number[]} */ [x, y]) => [0, 1].map((i) => origin[i] + x * right[i] + y * up[i]);
  return pairs(blocked, radius / resolution, count, seed).map(([start, goal], i) => ({
    name: `${i}`,
    start: place(start),
    goal: place(goal),
  }));
}

/** Files of a folder. @param {string} folder @param {RegExp} kind */
const filesOf = (folder, kind) =>
  readdirSync(folder)
    .filter((file) => kind.test(file))
    .sort()
    .map((file) => join(folder, file));

/** The picture of a map of ROS lies beside it under its name. @param {string} yaml */
export const withPicture = (yaml) => [
  yaml,
  ...filesOf(join(yaml, ".."), /\.(pgm|png)$/).filter((file) => isNamed(yaml, file)),
];

/** @param {string} yaml @param {string} picture */
const isNamed = (yaml, picture) => readFileSync(yaml, "utf8").includes(basename(picture));

/**
 * All of a folder.
 * @param {string} folder
 * @param {number} count queries of each map
 * @param {Read} read
 * @returns {Promise<{ group: string, scenario: Scenario }[]>}
 */
export async function converted(folder, count, read) {
  /** @type {{ group: string, scenario: Scenario }[]} */
  const all = [];
  const map = async (
    /** @type {string} */ group,
    /** @type {string[]} */ files,
    /** @type {number} */ radius,
    /** @type {number} */ seed,
  ) => {
    const { scenario, grid } = await read(files, { robot: { type: "disc", radius } });
    if (grid === null) throw new Error(`${files[0]} has no cells`);
    all.push({ group, scenario: { ...scenario, queries: queriesOn(grid, radius, count, seed) } });
  };
  for (const file of filesOf(join(folder, "movingai"), /\.map$/)) await map("city maps", [file], 0.3, 1);
  for (const file of filesOf(join(folder, "ros"), /\.yaml$/)) await map("ROS maps", withPicture(file), 0.2, 2);
  const circles = ["circle_obstacles.txt", "circle_queries.txt"].map((name) => join(folder, "ompl", name));
  const { scenario } = await read(circles, {});
  all.push({ group: "circles", scenario: { ...scenario, queries: scenario.queries.slice(0, 2 * count) } });
  for (const file of filesOf(join(folder, "tpcap"), /^Case\d+\.csv$/))
    all.push({ group: "parking", scenario: (await read([file], {})).scenario });
  return all;
}
