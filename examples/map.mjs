/**
 * From a map to a path, in Node: node examples/map.mjs FILE... RADIUS X,Y X,Y
 * The files of one world, such as map.yaml, the radius of the robot in metres, start and goal. A file that another one
 * names is read from beside it. Prints the status, the length and the path as JSON.
 */
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { solve } from "planarium";
import { readWorld } from "planarium/import";

const given = process.argv.slice(2);
if (given.length < 4) {
  console.error("usage: node examples/map.mjs FILE... RADIUS X,Y X,Y");
  process.exit(2);
}
const [radius, start, goal] = given.splice(-3).map((text) => text.split(",").map(Number));
const robot = { type: "disc", radius: radius[0] };

/** The world of files, with those that they name. */
async function open(names) {
  const files = names.map((name) => ({ name, bytes: readFileSync(name) }));
  try {
    return await readWorld(files, { robot, start, goal });
  } catch (error) {
    if (error.code !== "missing-file") throw error;
    const wanted = join(dirname(error.file), error.wanted);
    if (names.includes(wanted)) throw error;
    return open([...names, wanted]);
  }
}

const { scenario, report } = await open(given);
console.error(`${report.format}: ${report.obstacles.polygons} polygons, robot ${report.robot}`);
const { status, length, path } = solve(scenario, { seed: 1 });
console.log(JSON.stringify({ status, length, path }));
