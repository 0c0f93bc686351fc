/** A fleet in a world of another program: robots as in its panel, each of which goes to the place of another one. */

/** @import { FleetDocument } from "planarium/full" */
/** @import { OpenedWorld } from "../worlds/door.js" */

/** Robots at most, and how far apart their places are at least, in sizes of a robot. */
const MOST = 8;
const APART = 2.5;

/**
 * @param {OpenedWorld} opened
 * @returns {Promise<FleetDocument>}
 * @throws {Error} with `code` and `pointer`: there is room for fewer than two robots
 */
export async function fleetOf({ document, spread }) {
  const { name, title, world, robot } = document;
  const radius = robot.type === "disc" ? robot.radius : "shape" in robot ? reachOf(robot.shape.vertices) : 0;
  const places = await spread(MOST);
  // Those before it are farther apart.
  const crowded = places.findIndex((place, i) =>
    places.slice(0, i).some((other) => Math.hypot(place[0] - other[0], place[1] - other[1]) < 2 * APART * radius),
  );
  const count = crowded < 0 ? places.length : crowded;
  if (count < 2)
    throw Object.assign(new Error("There is no room for two robots of this size: choose a smaller one."), {
      code: "no-place",
      pointer: "",
    });
  const half = Math.floor(count / 2);
  return /** @type {FleetDocument} */ ({
    format: "planarium-fleet-1",
    name,
    title,
    world,
    robots: places.slice(0, count).map((start, i) => ({
      name: `robot ${i + 1}`,
      robot,
      start,
      goal: places[(i + half) % count],
    })),
  });
}

/** @param {readonly (readonly number[])[]} vertices */
const reachOf = (vertices) => Math.max(...vertices.map(([x, y]) => Math.hypot(x, y)));
