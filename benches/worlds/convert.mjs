/**
 * Maps and parking cases of other people as scenarios: occupancy grids of MovingAI and ROS with their cells as
 * rectangles, the circles and the grid of OMPL, the cases of TPCAP.
 */
import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";

/** @typedef {{ name: string, start: number[], goal: number[], goal_tolerance?: object }} Query */
/** @typedef {{ name: string, world: object, robot: object, queries: Query[] }} Scenario  without its format */

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

/** @param {number[]} low @param {number[]} high */
const rectangle = ([x0, y0], [x1, y1]) => ({
  type: "polygon",
  vertices: [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ],
});

/**
 * The blocked cells of a grid as rectangles, each as wide as it can be and then as high.
 * @param {boolean[][]} blocked rows, the lowest first
 */
function rectangles(blocked) {
  const open = blocked.map((row) => [...row]);
  const found = [];
  for (let y = 0; y < open.length; y += 1) {
    for (let x = 0; x < open[y].length; x += 1) {
      if (!open[y][x]) continue;
      let right = x;
      while (open[y][right]) right += 1;
      let top = y;
      while (top < open.length && open[top].slice(x, right).every(Boolean)) {
        open[top].fill(false, x, right);
        top += 1;
      }
      found.push([x, y, right, top]);
    }
  }
  return found;
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
 * @param {string} name
 * @param {boolean[][]} blocked
 * @param {number} radius in cells
 * @param {number[][][]} ends in cells
 * @param {number} scale
 * @returns {Scenario}
 */
function grid(name, blocked, radius, ends, scale) {
  const metres = (/** @type {number[]} */ at) => at.map((x) => x * scale);
  return {
    name,
    world: {
      bounds: { min: [0, 0], max: metres([blocked[0].length, blocked.length]) },
      obstacles: rectangles(blocked).map(([x0, y0, x1, y1]) => rectangle(metres([x0, y0]), metres([x1, y1]))),
    },
    robot: { type: "disc", radius: radius * scale },
    queries: ends.map(([start, goal], i) => ({ name: `${i}`, start: metres(start), goal: metres(goal) })),
  };
}

/** @param {string} file @param {number} count */
export function movingAi(file, count) {
  const [header, rows] = readFileSync(file, "latin1").split(/^map\r?\n/m);
  if (!header.includes("octile")) throw new Error(`${file} is no map of MovingAI`);
  const blocked = rows
    .trimEnd()
    .split(/\r?\n/)
    .reverse()
    .map((row) => [...row].map((cell) => !".G".includes(cell)));
  // Every pair of a disc that is smaller than a cell and of a chain of cells that share sides.
  return grid(basename(file, ".map"), blocked, 0.3, pairs(blocked, 0.3, count, 1), 1);
}

/** @param {string} yaml @param {number} count */
export function rosMap(yaml, count) {
  const text = readFileSync(yaml, "utf8");
  const value = (/** @type {string} */ key) => RegExp(`^${key}:\\s*"?([^"\\n]*)"?`, "m").exec(text)?.[1] ?? "";
  if (!value("image").endsWith(".pgm")) return undefined;
  const bytes = readFileSync(join(yaml, "..", value("image")));
  const words = [];
  let at = 0;
  while (words.length < 4) {
    const rest = bytes.subarray(at, at + 200).toString("latin1");
    const found = /^(\s*(#[^\n]*\n)?)*(\S+)/.exec(rest);
    if (found === null) throw new Error(`${yaml}: the image has no header`);
    words.push(found[3]);
    at += found[0].length;
  }
  const [kind, width, height, most] = [words[0], ...words.slice(1).map(Number)];
  const pixels =
    kind === "P5" ? bytes.subarray(at + 1) : bytes.subarray(at).toString("latin1").trim().split(/\s+/).map(Number);
  const [resolution, free] = [Number(value("resolution")), Number(value("free_thresh"))];
  const is_blocked = (/** @type {number} */ pixel) => {
    const light = pixel / Number(most);
    return (value("negate") === "1" ? light : 1 - light) >= free;
  };
  const blocked = Array.from({ length: Number(height) }, (_, y) =>
    Array.from({ length: Number(width) }, (_, x) => is_blocked(pixels[(Number(height) - 1 - y) * Number(width) + x])),
  );
  const radius = 0.2 / resolution;
  return grid(basename(yaml, ".yaml"), blocked, radius, pairs(blocked, radius, count, 2), resolution);
}

/** @param {string} folder @param {number} count @returns {Scenario[]} */
export function ompl(folder, count) {
  const discs = readFileSync(join(folder, "circle_obstacles.txt"), "utf8")
    .split("\n")
    .slice(2)
    .map((line) => line.trim().split(/\s+/).map(Number));
  const ends = new Map();
  for (const line of readFileSync(join(folder, "circle_queries.txt"), "utf8").split("\n")) {
    const found = /^(\d+)\s+(start|goal):\s+(\S+)\s+(\S+)/.exec(line);
    if (found !== null) ends.set(found[1], { ...ends.get(found[1]), [found[2]]: [Number(found[3]), Number(found[4])] });
  }
  const circles = {
    name: "circles",
    world: {
      bounds: { min: [-10, -10], max: [80, 80] },
      obstacles: discs
        .filter((disc) => disc.length === 4)
        .map(([, x, y, radius]) => ({ type: "disc", center: [x, y], radius })),
    },
    robot: { type: "disc", radius: 0 },
    queries: [...ends].slice(0, count).map(([name, query]) => ({ name, ...query })),
  };
  return [circles];
}

/** @param {string} file @returns {Scenario} */
export function parking(file) {
  const numbers = readFileSync(file, "utf8").trim().split(",").map(Number);
  const [x, y] = numbers;
  const corners = numbers.slice(7, 7 + numbers[6]);
  let at = 7 + numbers[6];
  const polygons = corners.map((count) => Array.from({ length: count }, () => [numbers[at++] - x, numbers[at++] - y]));
  const [start, goal] = [
    [0, 0, numbers[2]],
    [numbers[3] - x, numbers[4] - y, numbers[5]],
  ];
  const all = [...polygons.flat(), start, goal];
  const bound = (/** @type {number} */ i, /** @type {1 | -1} */ sign) =>
    sign * Math.max(...all.map((point) => sign * point[i])) + sign * 6;
  return {
    name: basename(file, ".csv").toLowerCase(),
    world: {
      bounds: { min: [bound(0, -1), bound(1, -1)], max: [bound(0, 1), bound(1, 1)] },
      obstacles: polygons.map((vertices) => ({ type: "polygon", vertices })),
    },
    // The vehicle of the competition.
    robot: {
      type: "car",
      shape: {
        type: "polygon",
        vertices: [
          [-0.929, -0.971],
          [3.76, -0.971],
          [3.76, 0.971],
          [-0.929, 0.971],
        ],
      },
      wheelbase: 2.8,
      speed: [-2.5, 2.5],
      steering: [-0.75, 0.75],
    },
    queries: [{ name: "park", start, goal, goal_tolerance: { translation: 0.25, rotation: 0.1 } }],
  };
}

/**
 * All of a folder.
 * @param {string} folder
 * @param {number} count queries of each map
 * @returns {{ group: string, scenario: Scenario }[]}
 */
export function converted(folder, count) {
  const files = (/** @type {string} */ name, /** @type {RegExp} */ kind) =>
    readdirSync(join(folder, name))
      .filter((file) => kind.test(file))
      .sort()
      .map((file) => join(folder, name, file));
  const of = (/** @type {string} */ group, /** @type {(Scenario | undefined)[]} */ scenarios) =>
    scenarios.flatMap((scenario) => (scenario === undefined ? [] : [{ group, scenario }]));
  return [
    ...of(
      "city maps",
      files("movingai", /\.map$/).map((file) => movingAi(file, count)),
    ),
    ...of(
      "ROS maps",
      files("ros", /\.yaml$/).map((file) => rosMap(file, count)),
    ),
    ...of("circles", ompl(join(folder, "ompl"), 2 * count)),
    ...of("parking", files("tpcap", /^Case\d+\.csv$/).map(parking)),
  ];
}
