/** Maps for the tests of worlds, made here: no file of others is needed. */

/**
 * A PGM of 48 x 30 pixels: a wall around, one across with a door, two islands, and a corner that is unknown.
 * @returns {Uint8Array}
 */
export function pgm() {
  const [width, height] = [48, 30];
  const grey = (/** @type {number} */ x, /** @type {number} */ y) => {
    const isEdge = x === 0 || y === 0 || x === width - 1 || y === height - 1;
    const isWall = x === 24 && (y < 12 || y > 18);
    const isIsland = (x === 8 && y === 8) || (x > 34 && x < 38 && y > 20 && y < 24);
    if (isEdge || isWall || isIsland) return 0;
    return x > 40 && y < 6 ? 205 : 254;
  };
  const header = Buffer.from(`P5\n# a map\n${width} ${height}\n255\n`);
  const pixels = Uint8Array.from({ length: width * height }, (_, i) => grey(i % width, Math.floor(i / width)));
  return Buffer.concat([header, pixels]);
}

/** A PGM of 250 x 250 pixels with thousands of obstacles, the same at every call. @returns {Uint8Array} */
export function noise() {
  let state = 1;
  const pixels = Uint8Array.from({ length: 250 * 250 }, () => {
    state = (state * 16807) % 2147483647;
    return state % 8 === 0 ? 0 : 254;
  });
  return Buffer.concat([Buffer.from("P5\n250 250\n255\n"), pixels]);
}

/** The YAML of a map. @param {string} [image] @param {number} [resolution] */
export const yaml = (image = "rooms.pgm", resolution = 0.1) =>
  `image: ${image}\nresolution: ${resolution}\norigin: [-1.0, -2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n`;

/** A MovingAI map of 6 x 4 cells, and two scenarios for it. */
export const MAP = "type octile\nheight 4\nwidth 6\nmap\n......\n..@@..\n..@@..\n......\n";
export const SCEN = "version 1\n0\tsmall.map\t6\t4\t0\t1\t5\t1\t7.8\n1\tsmall.map\t6\t4\t0\t3\t5\t0\t6.2\n";

/** A building of Open-RMF with two levels, a room of 6 x 4 m and a larger one; metres, y up. */
export const BUILDING = `coordinate_system: cartesian_meters
name: house
levels:
${[
  ["ground", 6],
  ["upper", 9],
]
  .map(
    ([name, width]) => `  ${name}:
    vertices: [[0, 0, 0, ""], [${width}, 0, 0, ""], [${width}, 4, 0, ""], [0, 4, 0, ""]]
    walls: [[0, 1, {}], [1, 2, {}], [2, 3, {}], [3, 0, {}]]
`,
  )
  .join("")}`;

/** A DXF drawing in metres: a room, and in it a closed line and a circle. */
export const DRAWING = [
  "0 SECTION 2 HEADER 9 $INSUNITS 70 6 0 ENDSEC 0 SECTION 2 ENTITIES",
  "0 LWPOLYLINE 8 walls 90 4 70 1 10 0 20 0 10 8 20 0 10 8 20 6 10 0 20 6",
  "0 LWPOLYLINE 8 desks 90 4 70 1 10 3 20 2 10 4 20 2 10 4 20 3 10 3 20 3",
  "0 CIRCLE 8 desks 10 6 20 3 40 0.5 0 ENDSEC 0 EOF",
]
  .join(" ")
  .replaceAll(" ", "\n");
