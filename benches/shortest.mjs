/**
 * `npm run bench:shortest`: shortest paths of web maps by `planarium/shortest`, and paths of planners, beside
 * `recast-navigation`, `pathfinding` and `@turf/shortest-path`.
 *
 *   --queries N    queries in each world (100)
 *   --turf N       of them for @turf/shortest-path, which prepares nothing (10); it has the small worlds alone
 *   --only WORD    worlds whose name has the word
 *   --ours         Planarium alone; needs no peers
 *   --json FILE    writes the medians
 *   --write        updates the table in docs/benchmarks.md
 *
 * Worlds are generated, and maps of MovingAI and ROS where the variable PLANARIUM_WORLDS names their folder. All sides
 * get the same areas and queries, in metres; turf, which knows degrees alone, gets them at the equator, and no distance to
 * keep, which it does not know. Whether a path touches an obstacle is judged here, by the distance of each of its
 * segments from each side of each area, with a thousandth of the distance to spare. `pathfinding` gets a grid with cells
 * of one metre; a cell is free if its centre is. Preparation is CPU time, a query the fastest of five runs. Run `npm ci` in
 * `benches/peers/shortest` first: it installs the peers.
 */
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { Scenario } from "planarium";
import { readWorld } from "planarium/import";
import { prepare } from "planarium/shortest";
import { Problem, root, script } from "../scripts/run.mjs";
import { integer, update } from "./peers/arguments.mjs";
import { digits, quantile, table } from "./peers/report.mjs";
import { generator } from "./peers/worlds.mjs";

/** @typedef {[number, number]} Position */
/** The corners of its border, then those of its holes. @typedef {Position[][]} Area */
/**
 * Areas that are kept at a distance; `cell` is that of recast-navigation. A grid consists of cells of a metre. All in
 * metres.
 * @typedef {{ name: string, size: Position, areas: Area[], distance: number, cell: number, isSmall: boolean, isGrid?: boolean }} World
 */
/** @typedef {[Position, Position]} Query */
/** @typedef {{ preparation: number, find: (query: Query) => Position[] | null, count?: number, distance?: number }} Side */
/** @typedef {{ length: number, milliseconds: number, path: Position[] | null }} Run */

/** Planners with their options. They prepare nothing: each query is a run of its own. */
const PLANNERS = /** @type {const} */ ([
  ["`planarium`, the default planner", {}],
  ["`planarium`, `bit-star`", { algorithm: "bit-star" }],
]);

/** A path is judged to touch an obstacle if it is nearer than this part of the distance. */
const KEPT = 0.999;

/** Metres per degree at the equator, as turf has them. */
const DEGREE = (6_371_008.8 * Math.PI) / 180;

/** The distance of neighbouring points in turf's grid, in metres; by default 100 kilometres. */
const RESOLUTION = 1;

/** How far areas reach up for recast-navigation, in metres. */
const HEIGHT = 3;

/** The maps: their files, the distance that is kept, and the cells that recast-navigation has of them. */
const MAPS = /** @type {const} */ ([
  [["movingai/Berlin_0_256.map"], 0.3, 0.1],
  [["movingai/NewYork_1_512.map"], 0.3, 0.2],
  [["ros/warehouse.yaml", "ros/warehouse.pgm"], 0.25, 0.05],
  [["ros/warehouse.yaml", "ros/warehouse.pgm"], 0, 0.05],
]);

/** Milliseconds of the processor so far. */
function processor() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/**
 * Houses that are turned in any direction and may overlap.
 * @param {string} name
 * @param {number} count
 * @param {number} side  of the world
 * @param {boolean} isSmall
 * @returns {World}
 */
function houses(name, count, side, isSmall) {
  const random = generator(count);
  const areas = Array.from({ length: count }, () => {
    const [x, y, turn] = [random() * side, random() * side, random() * Math.PI];
    const [a, b] = [2 + random() * 8, 2 + random() * 8];
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    const corners = /** @type {Position[]} */ ([
      [-a, -b],
      [a, -b],
      [a, b],
      [-a, b],
    ]);
    return [corners.map(([u, v]) => /** @type {Position} */ ([x + cos * u - sin * v, y + sin * u + cos * v]))];
  });
  return { name, size: [side, side], areas, distance: 0.5, cell: 0.25, isSmall };
}

/** What the world of a map is called. @param {(typeof MAPS)[number]} map */
const nameOf = ([paths, distance]) => `${basename(paths[0]).replace(/\..*/u, "")}, ${distance} m`;

/** A map, which begins at 0, 0. @param {string} folder @param {(typeof MAPS)[number]} map @returns {Promise<World>} */
async function mapOf(folder, map) {
  const [paths, distance, cell] = map;
  const read = (/** @type {string} */ path) => new Uint8Array(readFileSync(join(folder, path)));
  const files = paths.map((path) => ({ name: basename(path), bytes: read(path) }));
  const { scenario } = await readWorld(files, { robot: { type: "point" } });
  const name = nameOf(map);
  const { bounds, obstacles } = scenario.world;
  if (bounds === undefined) throw new Problem(`${name} has no bounds`);
  const [x0, y0] = bounds.min;
  const moved = (/** @type {readonly (readonly [number, number])[]} */ ring) =>
    ring.map(([x, y]) => /** @type {Position} */ ([x - x0, y - y0]));
  const areas = obstacles.map((one) => {
    if (one.type !== "polygon") throw new Problem(`${name} has other obstacles than areas`);
    return /** @type {Area} */ ([one.vertices, ...(one.holes ?? [])].map(moved));
  });
  const size = /** @type {Position} */ ([bounds.max[0] - x0, bounds.max[1] - y0]);
  const isGrid = paths[0].endsWith(".map");
  return { name, size, areas, distance, cell, isSmall: false, isGrid };
}

/** All sides of areas, in squares where they may be. */
class Judge {
  /** @type {Map<string, [Position, Position][]>} */
  #squares = new Map();
  #side = 8;
  /** @type {Area[]} */
  #areas;

  /** @param {Area[]} areas */
  constructor(areas) {
    this.#areas = areas;
    for (const ring of areas.flat()) {
      for (const [i, a] of ring.entries()) {
        const b = ring[(i + 1) % ring.length];
        for (const key of this.#keys(a, b, 0)) {
          const square = this.#squares.get(key) ?? [];
          if (square.length === 0) this.#squares.set(key, square);
          square.push([a, b]);
        }
      }
    }
  }

  /** @param {Position} a @param {Position} b @param {number} beyond */
  *#keys(a, b, beyond) {
    const at = (/** @type {number} */ x) => Math.floor(x / this.#side);
    for (let x = at(Math.min(a[0], b[0]) - beyond); x <= at(Math.max(a[0], b[0]) + beyond); x += 1)
      for (let y = at(Math.min(a[1], b[1]) - beyond); y <= at(Math.max(a[1], b[1]) + beyond); y += 1) yield `${x},${y}`;
  }

  /** Whether a position lies in an area: by the sides that a ray to the right crosses. @param {Position} p */
  #isInside([x, y]) {
    return this.#areas.some((area) => {
      let crossings = 0;
      for (const ring of area) {
        for (const [i, a] of ring.entries()) {
          const b = ring[(i + 1) % ring.length];
          if (a[1] > y !== b[1] > y && x < a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) crossings += 1;
        }
      }
      return crossings % 2 === 1;
    });
  }

  /** Whether a path is nearer to an area than a distance, or in it. @param {Position[]} path @param {number} distance */
  isTouched(path, distance) {
    if (this.#isInside(path[0])) return true;
    const most = distance ** 2;
    return path.some((p, i) => {
      const q = path[i + 1] ?? p;
      const pieces = Math.ceil(Math.hypot(q[0] - p[0], q[1] - p[1]) / this.#side) || 1;
      const at = (/** @type {number} */ k) =>
        /** @type {Position} */ ([0, 1].map((j) => p[j] + ((q[j] - p[j]) * k) / pieces));
      for (let k = 0; k < pieces; k += 1) {
        const [from, to] = [at(k), at(k + 1)];
        for (const key of this.#keys(from, to, distance))
          for (const [a, b] of this.#squares.get(key) ?? []) if (between(from, to, a, b) < most) return true;
      }
      return false;
    });
  }
}

/** The squared distance of two segments. @param {Position} p @param {Position} q @param {Position} a @param {Position} b */
function between(p, q, a, b) {
  const side = (/** @type {Position} */ u, /** @type {Position} */ v, /** @type {Position} */ w) =>
    (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]);
  if (side(p, q, a) * side(p, q, b) < 0 && side(a, b, p) * side(a, b, q) < 0) return 0;
  const from = (/** @type {Position} */ u, /** @type {Position} */ v, /** @type {Position} */ w) => {
    const [x, y] = [w[0] - v[0], w[1] - v[1]];
    const part = ((u[0] - v[0]) * x + (u[1] - v[1]) * y) / (x * x + y * y || 1);
    const along = Math.max(0, Math.min(1, part));
    return (u[0] - v[0] - along * x) ** 2 + (u[1] - v[1] - along * y) ** 2;
  };
  return Math.min(from(p, a, b), from(q, a, b), from(a, p, q), from(b, p, q));
}

/** Chords of arcs are a little shorter. @param {number} value */
const percent = (value) => `${value.toFixed(2).replace("-0.00", "0.00")} %`;

/** @param {Position[]} path */
const lengthOf = (path) =>
  path.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - path[i][0], y - path[i][1]), 0);

/** The areas as GeoJSON. @param {Area[]} areas @param {number} [unit]  metres of a number of it */
function collection(areas, unit = 1) {
  const features = areas.map((area) => {
    const coordinates = area.map((ring) => [...ring, ring[0]].map(([x, y]) => [x / unit, y / unit]));
    return {
      type: /** @type {const} */ ("Feature"),
      properties: {},
      geometry: { type: /** @type {const} */ ("Polygon"), coordinates },
    };
  });
  return { type: /** @type {const} */ ("FeatureCollection"), features };
}

/**
 * @param {World} world
 * @param {boolean} manyQueries
 * @returns {Side & { lengths: (query: Query) => number | undefined }}
 */
function planarium({ areas, distance, size }, manyQueries) {
  const obstacles = collection(areas);
  const began = processor();
  const paths = prepare(obstacles, {
    minDistance: distance,
    bounds: [-20, -20, size[0] + 20, size[1] + 20],
    coordinates: "metres",
    manyQueries,
  });
  const preparation = processor() - began;
  return {
    preparation,
    find: (query) => paths.query(...query)?.geometry.coordinates ?? null,
    lengths: (query) => paths.query(...query)?.properties.length,
  };
}

/** The disc in a world, or the point, with queries by number. @param {World} world @param {Query[]} queries */
function scenarioOf({ areas, distance, size, name }, queries) {
  return Scenario.parse({
    format: "planarium-scenario-1",
    name,
    world: {
      bounds: { min: [-20, -20], max: [size[0] + 20, size[1] + 20] },
      obstacles: areas.map(([vertices, ...holes]) => ({ type: "polygon", vertices, holes })),
    },
    robot: { type: "disc", radius: distance },
    queries: queries.map(([start, goal], i) => ({ name: `${i}`, start, goal })),
  });
}

/** @param {World} world @param {Query[]} queries @param {object} options  of the planner @returns {Side} */
function planned(world, queries, options) {
  const began = processor();
  const scenario = scenarioOf(world, queries);
  const preparation = processor() - began;
  const find = (/** @type {Query} */ query) => {
    const planner = scenario.planner({ query: `${queries.indexOf(query)}`, seed: 1, ...options });
    while (planner.step(1_000_000) === "running");
    const result = planner.result();
    planner.free();
    return result.status === "solved" ? /** @type {Position[]} */ (result.path) : null;
  };
  return { preparation, find };
}

/** A* on a grid of metres. @param {any} modules @param {World} world @returns {Side} */
function gridded({ Grid, AStarFinder, DiagonalMovement, Heuristic }, world) {
  const scenario = scenarioOf(world, []);
  const range = (/** @type {number} */ count) => Array.from({ length: Math.floor(count) }, (_, i) => i);
  const began = processor();
  const blocked = range(world.size[1]).map((y) =>
    range(world.size[0]).map((x) => (scenario.check([x + 0.5, y + 0.5]).free ? 0 : 1)),
  );
  const grid = new Grid(blocked);
  const preparation = processor() - began;
  const finder = new AStarFinder({
    diagonalMovement: DiagonalMovement.OnlyWhenNoObstacles,
    heuristic: Heuristic.octile,
  });
  const find = (/** @type {Query} */ [start, goal]) => {
    const [a, b] = [start, goal].map((end) => end.map(Math.floor));
    const cells = finder.findPath(a[0], a[1], b[0], b[1], grid.clone());
    if (cells.length === 0) return null;
    const middles = cells.map((/** @type {number[]} */ [x, y]) => /** @type {Position} */ ([x + 0.5, y + 0.5]));
    return [start, ...middles.slice(1, -1), goal];
  };
  return { preparation, find };
}

/** @param {any} modules @param {World} world @returns {Side | null} */
function recast({ NavMeshQuery, generateTiledNavMesh }, { areas, distance, size, cell }) {
  /** @type {number[]} */ const positions = [];
  /** @type {number[]} */ const indices = [];
  // A floor, and on it a wall along each side of an area: what they enclose cannot be reached.
  const quad = (/** @type {number[][]} */ corners) => {
    const n = positions.length / 3;
    positions.push(...corners.flat());
    indices.push(n, n + 2, n + 1, n, n + 3, n + 2);
  };
  const [[x0, y0], [x1, y1]] = [
    [-20, -20],
    [size[0] + 20, size[1] + 20],
  ];
  quad([
    [x0, 0, y0],
    [x1, 0, y0],
    [x1, 0, y1],
    [x0, 0, y1],
  ]);
  for (const ring of areas.flat()) {
    for (const [i, a] of ring.entries()) {
      const b = ring[(i + 1) % ring.length];
      quad([
        [a[0], 0, a[1]],
        [b[0], 0, b[1]],
        [b[0], HEIGHT, b[1]],
        [a[0], HEIGHT, a[1]],
      ]);
    }
  }
  const began = processor();
  const made = generateTiledNavMesh(positions, indices, {
    tileSize: 128,
    cs: cell,
    ch: 0.2,
    walkableRadius: Math.ceil(distance / cell),
    walkableHeight: 2,
    walkableClimb: 1,
    maxEdgeLen: 120,
    maxSimplificationError: 0.5,
  });
  if (!made.success) return null;
  const mesh = new NavMeshQuery(made.navMesh, { maxNodes: 65535 });
  const preparation = processor() - began;
  const at = (/** @type {Position} */ [x, z]) => ({ x, y: 0, z });
  const options = { maxPathPolys: 8192, maxStraightPathPoints: 8192 };
  const find = (/** @type {Query} */ [start, goal]) => {
    const found = mesh.computePath(at(start), at(goal), options);
    if (!found.success || found.path.length === 0) return null;
    const path = found.path.map((/** @type {{ x: number, z: number }} */ { x, z }) => /** @type {Position} */ ([x, z]));
    // A path that ends elsewhere is a part of one.
    return Math.hypot(path.at(-1)[0] - goal[0], path.at(-1)[1] - goal[1]) < 0.5 ? path : null;
  };
  return { preparation, find };
}

/** @param {any} shortestPath @param {World} world @param {number} count @returns {Side} */
function turf(shortestPath, { areas }, count) {
  const obstacles = collection(areas, DEGREE);
  const degrees = (/** @type {Position} */ [x, y]) => [x / DEGREE, y / DEGREE];
  const find = (/** @type {Query} */ [start, goal]) => {
    const { geometry } = shortestPath(degrees(start), degrees(goal), {
      obstacles,
      units: "meters",
      resolution: RESOLUTION,
    });
    const path = geometry.coordinates.map((/** @type {Position} */ [x, y]) => [x * DEGREE, y * DEGREE]);
    // Without a path it answers with the straight line, and its paths may end elsewhere.
    return Math.hypot(path.at(-1)[0] - goal[0], path.at(-1)[1] - goal[1]) < 0.5 ? path : null;
  };
  return { preparation: 0, find, count, distance: 0 };
}

/** What the bench needs of its peers. */
async function peers() {
  const folder = join(root, "benches", "peers", "shortest");
  if (!existsSync(join(folder, "node_modules"))) throw new Problem(`Run \`npm ci\` in ${folder} first.`);
  const require = createRequire(join(folder, "package.json"));
  const load = (/** @type {string} */ name) => import(pathToFileURL(require.resolve(name)).href);
  const [mesh, generators, finder, grids] = await Promise.all(
    ["recast-navigation", "recast-navigation/generators", "@turf/shortest-path", "pathfinding"].map(load),
  );
  await mesh.init();
  return {
    recast: { ...mesh, ...generators },
    turf: finder.shortestPath ?? finder.default,
    grids: grids.default,
  };
}

/** Queries between free positions that a path joins. @param {World} world @param {Judge} judge @param {Side} side @param {number} count */
function queriesOf({ size, distance }, judge, side, count) {
  const random = generator(7);
  const free = () => {
    for (;;) {
      const at = /** @type {Position} */ ([random() * size[0], random() * size[1]]);
      // As far as the cells of recast-navigation may be off, too.
      if (!judge.isTouched([at], distance + 0.4)) return at;
    }
  };
  /** @type {Query[]} */ const queries = [];
  while (queries.length < count) {
    const query = /** @type {Query} */ ([free(), free()]);
    if (side.find(query) !== null) queries.push(query);
  }
  return queries;
}

/** @param {Side} side @param {Query[]} queries @returns {Run[]} */
function runs({ find, count = Infinity }, queries) {
  const chosen = queries.slice(0, count);
  // What is prepared is asked once before, so that no side is measured cold.
  if (count === Infinity) chosen.forEach(find);
  return chosen.map((query) => {
    // The least of some: the others have waited for other programs.
    const times = Array.from({ length: count === Infinity ? 5 : 1 }, () => {
      const began = performance.now();
      find(query);
      return performance.now() - began;
    });
    const path = find(query);
    return { milliseconds: Math.min(...times), path, length: path === null ? NaN : lengthOf(path) };
  });
}

await script(async () => {
  const { values: options } = parseArgs({
    options: {
      queries: { type: "string", default: "100" },
      turf: { type: "string", default: "10" },
      only: { type: "string", default: "" },
      ours: { type: "boolean", default: false },
      json: { type: "string" },
      write: { type: "boolean", default: false },
    },
  });
  const [count, few] = [integer("queries", options.queries, 1), integer("turf", options.turf, 1)];
  const modules = options.ours ? null : await peers();
  const folder = process.env.PLANARIUM_WORLDS;
  const isChosen = (/** @type {string} */ name) => name.includes(options.only);
  const chosen = MAPS.filter((map) => isChosen(nameOf(map)));
  const maps = folder === undefined ? [] : await Promise.all(chosen.map((map) => mapOf(folder, map)));
  const worlds = [houses("20 houses", 20, 100, true), houses("2000 houses", 2000, 1000, false), ...maps];
  /** @type {string[][]} */ const body = [];
  const medians = [];
  for (const world of worlds.filter(({ name }) => isChosen(name))) {
    const judge = new Judge(world.areas);
    const ours = planarium(world, false);
    const queries = queriesOf(world, judge, ours, count);
    const shortest = queries.map(ours.lengths);
    /** @type {[string, Side | null][]} */
    const sides = [
      ["`planarium/shortest`", ours],
      ["with `manyQueries`", planarium(world, true)],
      ...PLANNERS.map(([name, options]) => /** @type {[string, Side]} */ ([name, planned(world, queries, options)])),
    ];
    if (modules !== null) {
      sides.push(["`recast-navigation`", recast(modules.recast, world)]);
      if (world.isGrid) sides.push(["`pathfinding`, A*", gridded(modules.grids, world)]);
      sides.push(["`@turf/shortest-path`", world.isSmall ? turf(modules.turf, world, few) : null]);
    }
    for (const [name, side] of sides) {
      if (side === null) {
        body.push([world.name, name, ...Array.from({ length: 6 }, () => "-")]);
        continue;
      }
      const done = runs(side, queries);
      const found = done.filter(({ path }) => path !== null);
      const over = done.flatMap(({ length }, i) =>
        Number.isNaN(length) ? [] : [100 * (length / (shortest[i] ?? NaN) - 1)],
      );
      const share = (/** @type {number} */ distance) => {
        const touching = found.filter(({ path }) => path !== null && judge.isTouched(path, distance));
        return `${digits((100 * touching.length) / (found.length || 1))} %`;
      };
      const times = done.map(({ milliseconds }) => milliseconds);
      const median = quantile(times, 0.5);
      const longer = quantile(over, 0.5);
      medians.push({ world: world.name, side: name, milliseconds: median, longer });
      body.push([
        world.name,
        name,
        digits(side.preparation),
        `${digits(median)} (${digits(Math.max(...times))})`,
        `${found.length} of ${done.length}`,
        `${percent(longer)} (${percent(Math.max(...over))})`,
        // The shortest path of a point touches corners.
        world.distance === 0 ? "-" : share(1e-9),
        world.distance === 0 || side.distance === 0 ? "-" : share(KEPT * world.distance),
      ]);
      console.log(body.at(-1)?.join(" | "));
    }
  }
  const head = [
    "world",
    "side",
    "preparation, ms",
    "query, ms",
    "found",
    "longer",
    "cross an obstacle",
    "nearer than asked",
  ];
  const text = table(head, body);
  console.log(text);
  if (options.json !== undefined) writeFileSync(options.json, `${JSON.stringify(medians, null, 1)}\n`);
  if (options.write) update("shortest", text);
});
