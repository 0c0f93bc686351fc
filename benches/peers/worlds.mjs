/**
 * The worlds and jobs of the benchmark. Every world is generated from a seed, and is written twice: as a scenario
 * document for Planarium, and as flat text with one item per line for the peers.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

/** @typedef {import("planarium").ScenarioDocument} ScenarioDocument */
/** @typedef {{ json: string, text: string }} World  paths of the two forms */

/**
 * @typedef {object} Row  one job on one kind of world
 * @property {string} name
 * @property {"prm" | "rrt-connect" | "rrt-control" | "sst"} planner
 * @property {import("planarium").GeneratorId} generator
 * @property {Record<string, string | number>} options
 * @property {number} links  of an arm; 0 of a body or a car
 */

/**
 * The jobs: the reports' roadmaps, single queries in their forests and two other kinds of world, bodies, and cars by
 * controls.
 * @type {Row[]}
 */
export const rows = [
  ...[2, 3, 4].map((links) => row("prm", "forest", { links }, `forest ${links}R`, links)),
  ...[2, 3, 4].map((links) => row("rrt-connect", "forest", { links }, `forest ${links}R`, links)),
  row("rrt-connect", "discs", { robot: "arm", links: 3, count: 12, largest: 0.1 }, "discs 3R, thick links", 3),
  row("rrt-connect", "clutter", { robot: "arm", links: 4, radius: 0, count: 14, largest: 0.2 }, "clutter 4R", 4),
  row("rrt-connect", "clutter", { robot: "rigid_body", count: 8, smallest: 0.12, largest: 0.26 }, "body in clutter", 0),
  row("rrt-connect", "gap", { robot: "rigid_body", width: 0.14, thickness: 0.2 }, "body through a gap", 0),
  row("rrt-control", "clutter", { robot: "car", count: 8, smallest: 0.12, largest: 0.26 }, "car in clutter", 0),
  row("sst", "clutter", { robot: "car", count: 8, smallest: 0.12, largest: 0.26 }, "car in clutter", 0),
];

/** Numbers from 0 to 1, the same for a seed (Steele, Lea and Flood 2014, SplitMix). @param {number} seed */
export function generator(seed) {
  let state = BigInt(seed);
  return () => {
    state = BigInt.asUintN(64, state + 0x9e3779b97f4a7c15n);
    let z = state;
    z = BigInt.asUintN(64, (z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
    z = BigInt.asUintN(64, (z ^ (z >> 27n)) * 0x94d049bb133111ebn);
    return Number((z ^ (z >> 31n)) >> 11n) / 2 ** 53;
  };
}

/** The number of samples in a report's roadmap for an arm of this many links. @param {number} links */
export const samples = (links) => 300 * links - 200;

/**
 * @param {Row["planner"]} planner
 * @param {Row["generator"]} generator
 * @param {Row["options"]} options
 * @param {string} place
 * @param {number} links
 * @returns {Row}
 */
function row(planner, generator, options, place, links) {
  const name = { prm: "k-PRM", "rrt-connect": "RRT-Connect", "rrt-control": "Kinodynamic RRT", sst: "SST" }[planner];
  return { name: `${name}, ${place}`, planner, generator, options, links };
}

/**
 * Writes worlds of a row. A world that a peer cannot read is an error, not a gap.
 * @param {typeof import("planarium").Scenario} Scenario
 * @param {Row} row
 * @param {number} first  the seed of the first
 * @param {number} count
 * @param {string} folder
 * @returns {World[]}
 */
export function writeWorlds(Scenario, { name, generator, options }, first, count, folder) {
  const place = join(folder, name.replace(/\W+/g, "-"));
  mkdirSync(place, { recursive: true });
  return Array.from({ length: count }, (_, i) => {
    const seed = first + i;
    const scenario = Scenario.generate(generator, { ...options, seed });
    const document = scenario.document();
    scenario.free();
    const world = { json: join(place, `${seed}.json`), text: join(place, `${seed}.txt`) };
    writeFileSync(world.json, JSON.stringify(document));
    writeFileSync(world.text, flat(document));
    return world;
  });
}

/**
 * The document of an arm on circles, a disc, a convex body or a car, among convex polygons and discs, as flat text;
 * polygons counter-clockwise.
 * @param {ScenarioDocument} document
 */
export function flat({ world, robot, queries: [query] }) {
  /** @type {(string | number)[][]} */
  const items = [...machine(robot), ["start", ...query.start], ["goal", ...(query.goal ?? [])]];
  if (query.goal_tolerance)
    items.push(["tolerance", query.goal_tolerance.translation ?? 0, query.goal_tolerance.rotation ?? 0]);
  if (world.bounds) items.push(["bounds", ...world.bounds.min, ...world.bounds.max]);
  for (const obstacle of world.obstacles) {
    if (obstacle.type === "wall" || (obstacle.type === "polygon" && obstacle.holes))
      throw new Error("the programs of peers read neither walls nor holes");
    items.push(
      obstacle.type === "disc"
        ? ["disc", ...obstacle.center, obstacle.radius]
        : ["polygon", ...counterClockwise(obstacle.vertices).flat()],
    );
  }
  return items.map((item) => `${item.join(" ")}\n`).join("");
}

/**
 * The items of the robot.
 * @param {ScenarioDocument["robot"]} robot
 * @returns {(string | number)[][]}
 */
function machine(robot) {
  if (robot.type === "arm" && (robot.joint_limits ?? robot.joints) !== undefined)
    throw new Error("the peers know arms whose joints turn without limits, discs, bodies and cars");
  if (robot.type === "disc") return [["radius", robot.radius]];
  if (robot.type === "arm")
    return [
      ["base", ...robot.base],
      ["radius", robot.radius ?? 0],
      ["links", ...robot.links],
    ];
  const shape = ["shape", ...counterClockwise(robot.shape.vertices).flat()];
  if (robot.type === "rigid_body") return [shape];
  return [shape, ["wheelbase", robot.wheelbase], ["speed", ...robot.speed], ["steering", ...robot.steering]];
}

/** The corners of a convex polygon in counter-clockwise order. @param {readonly (readonly number[])[]} corners */
function counterClockwise(corners) {
  const turns = corners.map(([x, y], i) => {
    const [[x1, y1], [x2, y2]] = [1, 2].map((ahead) => corners[(i + ahead) % corners.length]);
    return (x1 - x) * (y2 - y1) - (y1 - y) * (x2 - x1);
  });
  if (turns.every((turn) => turn > 0)) return corners;
  if (turns.every((turn) => turn < 0)) return corners.toReversed();
  throw new Error("the peers know convex polygons only");
}

/**
 * A fleet on 32 x 32 squares: starts and goals are middles of squares that discs reach from each other.
 * @param {number} seed @param {number} count
 */
export function squares(seed, count) {
  const side = 32;
  const random = generator(seed);
  const blocked = Array.from({ length: side * side }, () => random() < 0.2);
  const place = (/** @type {number} */ square) => [square % side, Math.floor(square / side)];
  const near = (/** @type {number} */ square) => {
    const [x, y] = place(square);
    const sides = [
      x > 0 && square - 1,
      x < side - 1 && square + 1,
      y > 0 && square - side,
      y < side - 1 && square + side,
    ];
    return sides.filter((other) => other !== false && !blocked[other]);
  };
  /** @type {number[]} */
  let largest = [];
  const seen = new Set();
  for (const first of blocked.keys()) {
    if (blocked[first] || seen.has(first)) continue;
    const part = [first];
    seen.add(first);
    for (const square of part)
      for (const other of /** @type {number[]} */ (near(square)).filter((next) => !seen.has(next))) {
        part.push(other);
        seen.add(other);
      }
    if (part.length > largest.length) largest = part;
  }
  const [starts, goals] = [0, 1].map(() => {
    const left = [...largest];
    return Array.from({ length: count }, () => left.splice(Math.floor(random() * left.length), 1)[0]);
  });
  const middle = (/** @type {number} */ square) => place(square).map((x) => x + 0.5);
  return {
    format: "planarium-fleet-1",
    name: `squares-${count}-${seed}`,
    world: {
      bounds: { min: [0, 0], max: [side, side] },
      obstacles: [...blocked.keys()]
        .filter((square) => blocked[square])
        .map((square) => {
          const [x, y] = place(square);
          const vertices = [
            [x, y],
            [x + 1, y],
            [x + 1, y + 1],
            [x, y + 1],
          ];
          return { type: "polygon", vertices };
        }),
    },
    robots: starts.map((start, i) => ({
      name: String(i + 1),
      robot: { type: "disc", radius: 0.3 },
      speed: 1,
      start: middle(start),
      goal: middle(goals[i]),
    })),
  };
}
