/**
 * What a reader chooses about a world that is opened, and the options of `readWorld` that follow from it. What equals
 * its default is left out, so that files decide.
 */

/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Options, Report } from "./types.js" */

/**
 * Lengths in metres, the steering angle in degrees.
 * @typedef {object} Choices
 * @property {"file" | "disc" | "footprint" | "car"} robot   "file": that of the files
 * @property {number} radius
 * @property {number} length
 * @property {number} width
 * @property {number} wheelbase
 * @property {number} steering
 * @property {number} margin
 * @property {"occupied" | "free"} unknown
 * @property {number | undefined} threshold
 * @property {number | undefined} scale      metres per pixel or cell
 * @property {number} wall_thickness
 * @property {number} min_island             cells
 * @property {number} simplify
 * @property {boolean | undefined} walkable   whether areas are where the robot may be
 * @property {string[] | undefined} layers   all where absent
 * @property {number | undefined} tolerance   of curves
 * @property {boolean} filled                 whether closed lines are areas
 * @property {string} filters                 `KEY=VALUE` or `KEY!=VALUE`, separated by commas
 * @property {string | undefined} level       the first where absent
 */

/** Before anything is chosen. @type {Choices} */
export const FIRST = {
  robot: "file",
  radius: 0.2,
  length: 0.8,
  width: 0.6,
  wheelbase: 0.5,
  steering: 35,
  margin: 0,
  unknown: "occupied",
  threshold: undefined,
  scale: undefined,
  wall_thickness: 0,
  min_island: 0,
  simplify: 0,
  walkable: undefined,
  layers: undefined,
  tolerance: undefined,
  filled: false,
  filters: "",
  level: undefined,
};

/** @param {Choices} choices @returns {Options["robot"]} */
function robotOf({ robot, radius, length, width, wheelbase, steering }) {
  if (robot === "disc") return radius === 0 ? { type: "point" } : { type: "disc", radius };
  const [x, y] = [length / 2, width / 2];
  if (robot === "footprint")
    return {
      type: "footprint",
      corners: [
        [-x, -y],
        [x, -y],
        [x, y],
        [-x, y],
      ],
    };
  return robot === "car" ? { type: "car", length, width, wheelbase, steering: (steering * Math.PI) / 180 } : undefined;
}

/**
 * Conditions on properties of features; null if the text has something else.
 * @param {string} text   `KEY=VALUE` or `KEY!=VALUE`, separated by commas
 * @returns {NonNullable<Options["filters"]> | null}
 */
export function filtersOf(text) {
  const parts = text.split(",").filter((part) => part.trim() !== "");
  const filters = parts.flatMap((part) => {
    const [, key, not, value] = /^\s*([^=]*?)\s*(!?)=\s*(.*?)\s*$/.exec(part) ?? [];
    return key ? { key, value, keep: not === "" } : [];
  });
  return filters.length === parts.length ? filters : null;
}

/** @param {Choices} choices @returns {Options} */
export function optionsOf(choices) {
  const { unknown, threshold, scale, min_island, simplify, wall_thickness, walkable, layers } = choices;
  const { tolerance, filled, level } = choices;
  const filters = filtersOf(choices.filters);
  const given = {
    robot: robotOf(choices),
    threshold,
    scale,
    walkable,
    layers,
    tolerance,
    level,
    fill: filled ? ["*"] : undefined,
    filters: filters?.length ? filters : undefined,
    unknown: unknown === "free" ? unknown : undefined,
    min_island: min_island || undefined,
    simplify: simplify || undefined,
    wall_thickness: wall_thickness || undefined,
  };
  return Object.fromEntries(Object.entries(given).filter(([, value]) => value !== undefined));
}

/** Rounded to two digits. @param {number} value */
const round = (value) => Number(value.toPrecision(2));

/**
 * Robots that fit a world whose files have none; null where they have one, or queries for it. A disc of 0.2 m is small
 * enough for most buildings; cells of the size of a room, and worlds of the size of a table, have their own: where a
 * plan is drawn so small, a robot of a twenty-fifth of it still has room between shelves.
 * @param {ScenarioDocument} document
 * @param {Report} report
 * @returns {Pick<Choices, "radius"> & Partial<Choices> | null}
 */
export function fitting({ robot, queries, world }, { grid }) {
  if (robot.type !== "disc" || robot.radius || queries.length > 0 || !world.bounds) return null;
  const { min, max } = world.bounds;
  const least = Math.min(max[0] - min[0], max[1] - min[1]);
  const usual = grid && grid.resolution > 0.4 ? 0.3 * grid.resolution : 0.2;
  const radius = round(Math.min(usual, 0.02 * least));
  return {
    robot: "disc",
    radius,
    length: round(4 * radius),
    width: round(3 * radius),
    wheelbase: round(2.5 * radius),
  };
}
