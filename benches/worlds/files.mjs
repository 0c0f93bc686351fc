/**
 * The files of `PLANARIUM_WORLDS` by every planner that serves, beside OMPL on the cells of those that have some: each
 * side in its own process, in turns, one run at a time. A run is one of a new planner from its set-up to its first path, and every
 * path of ours is verified.
 */
import { readdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { Scenario } from "planarium";
import { placesIn } from "../../www/worlds/places.js";
import { Problem } from "../../scripts/run.mjs";
import { startGridSide } from "../peers/sides.mjs";
import { quantile } from "../peers/report.mjs";
import { withPicture } from "./convert.mjs";

/** @typedef {import("./convert.mjs").Reading} Reading */
/** @typedef {import("./convert.mjs").Grid} Grid */
/** @typedef {{ ask(job: object): Promise<any>, end(): void }} Ours */
/** @typedef {{ id: string, robots: string[], parameters: object }} Planner */
/** @typedef {{ name: string, files: string[], robot?: object, words: string, options?: object }} Entry */
/** @typedef {{ times: number[], valid: number, solved: number, runs: number }} Cell */

/**
 * A planner in a world: the median of its times in seconds, Infinity for most without a path; and how many of the paths that
 * it found are free.
 * @typedef {{ name: string, robot: string, planner: string, seconds: number, solved: number, valid: number }} Measured
 */

/** The planners of OMPL that run beside ours of the same id. */
const PEERS = ["rrt-connect", "rrt", "prm", "bit-star"];

/** How often a file is read. */
const READS = 5;

/**
 * @param {Ours} ours
 * @param {{ folder: string, seconds: number, seeds: number, planners: Planner[], only: string[] | undefined }} options
 * @returns {Promise<{ text: string, cells: Measured[] }>} the tables, and what is in their cells
 */
export async function measureFiles(ours, { folder, seconds, seeds, planners, only }) {
  const { PLANARIUM_WORLDS: worlds } = process.env;
  if (worlds === undefined) throw new Problem("PLANARIUM_WORLDS names no folder with files.");
  const peer = await startGridSide();
  /** @type {Measured[]} */
  const measured = [];
  /** @type {Map<string, string[][]>} */
  const tables = new Map();
  const entries = entriesOf(worlds, folder).filter(({ name }) => only?.some((text) => name.includes(text)) ?? true);
  for (const [i, entry] of entries.entries()) {
    console.error(`bench: ${entry.name}, ${entry.words} (${i + 1} of ${entries.length})`);
    const options = { ...entry.options, ...(entry.robot ? { robot: entry.robot } : {}) };
    const reading = /** @type {Reading & { error?: string }} */ (
      await ours.ask({ read: entry.files, options, times: READS })
    );
    if (reading.error !== undefined) throw new Problem(`${entry.name}: ${reading.error}`);
    const { scenario, report, grid } = reading;
    const query = queryOf(scenario);
    const file = join(folder, `${i}.json`);
    writeFileSync(file, JSON.stringify({ ...scenario, queries: query ? [query] : [] }));
    const kind = scenario.robot.type;
    const serving = planners.filter(({ robots }) => robots.includes(kind));
    const cells =
      grid && kind !== "car" && query && peer
        ? writeCells(join(folder, `${i}.txt`), grid, scenario.robot, query)
        : null;
    const peers = cells ? PEERS : [];
    /** @type {Map<string, Cell>} */
    const found = new Map();
    const cellOf = (/** @type {string} */ key) => {
      const cell = found.get(key) ?? { times: [], valid: 0, solved: 0, runs: 0 };
      found.set(key, cell);
      return cell;
    };
    const isHopeless = (/** @type {string} */ key) => {
      const { runs, solved } = cellOf(key);
      return runs - solved > seeds / 2;
    };
    for (let seed = 1; query && seed <= seeds; seed += 1) {
      for (const { id, parameters } of serving) {
        if (!isHopeless(id)) {
          const reply = await ours.ask({ file, query: query.name, planner: id, seed, seconds, parameters });
          if (reply.error !== undefined) throw new Problem(`${entry.name}, ${id}: ${reply.error}`);
          if (reply.status === "solved" && !reply.valid)
            throw new Problem(`${entry.name}, ${id}: the path is not valid`);
          const isSolved = reply.status === "solved" && (reply.first ?? reply.seconds) <= seconds;
          note(cellOf(id), isSolved ? (reply.first ?? reply.seconds) : null, isSolved);
        }
        const other = `OMPL ${id}`;
        if (!peers.includes(id) || peer === null || cells === null || isHopeless(other)) continue;
        const reply = await peer.reply(`${cells.file} ${id} ${seed} ${seconds}`);
        const isSolved = reply.path.length > 0;
        const path = reply.path.map(cells.back);
        const verdict = isSolved
          ? await ours.ask({ file, query: query.name, path: pinned(path, query) })
          : { why: "none" };
        if (verdict.error !== undefined) throw new Problem(`${entry.name}, ${other}: ${verdict.error}`);
        note(cellOf(other), isSolved ? reply.seconds : null, verdict.why === null);
      }
    }
    for (const [planner, cell] of found) {
      const { solved, valid } = cell;
      measured.push({ name: entry.name, robot: kind, planner, seconds: medianOf(cell, seeds), solved, valid });
    }
    const times = [...found].map(([key, cell]) => `${key} ${cellText(cell, seeds, true)}`);
    console.error(`bench: ${times.join(", ")}`);
    const table = kind === "car" ? "cars" : kind === "disc" ? "discs" : "bodies";
    const head = [
      "file, robot",
      "size",
      "obstacles",
      "read",
      ...serving.map(({ id }) => `\`${id}\``),
      ...(table === "cars" ? [] : PEERS.map((id) => `OMPL \`${id}\``)),
    ];
    const rows = tables.get(table) ?? [head, head.map(() => "---")];
    tables.set(table, rows);
    rows.push([
      `\`${entry.name}\`, ${entry.words}`,
      sizeOf(report),
      `${scenario.world.obstacles.length}`,
      milliseconds(reading.seconds),
      ...serving.map(({ id }) => cellText(found.get(id), seeds, false)),
      ...(table === "cars" ? [] : PEERS.map((id) => cellText(found.get(`OMPL ${id}`), seeds, true))),
    ]);
  }
  ours.end();
  peer?.stop();
  const title = `${peer ? `${peer.title}; ` : ""}medians of ${seeds} seeds in milliseconds, of ${READS} readings; – is none within ${seconds} s.`;
  const text = [...tables.values()].map((rows) => rows.map((row) => `| ${row.join(" | ")} |`).join("\n"));
  return { text: [title, ...text].join("\n\n"), cells: measured };
}

/** @param {Cell} cell @param {number | null} seconds @param {boolean} isValid */
function note(cell, seconds, isValid) {
  cell.runs += 1;
  cell.solved += seconds === null ? 0 : 1;
  cell.valid += isValid ? 1 : 0;
  cell.times.push(seconds ?? Infinity);
}

/** Runs that were left out count as none that found a path. @param {Cell} cell @param {number} seeds */
function medianOf({ times }, seeds) {
  return quantile([...times, ...Array.from({ length: seeds - times.length }, () => Infinity)], 0.5);
}

/**
 * The median of the times; behind it, of how many paths a verifier refuses some.
 * @param {Cell | undefined} cell @param {number} seeds @param {boolean} isPeer
 */
function cellText(cell, seeds, isPeer) {
  if (cell === undefined) return isPeer ? "" : "–";
  const { solved, valid } = cell;
  const median = medianOf(cell, seeds);
  if (!Number.isFinite(median)) return "–";
  return `${milliseconds(median)}${valid < solved ? `, ${solved - valid} of ${solved} not free` : ""}`;
}

/** @param {number} seconds */
function milliseconds(seconds) {
  const value = 1e3 * seconds;
  return value < 10 ? value.toFixed(value < 1 ? 2 : 1) : value.toFixed(0);
}

/** @param {any} report */
function sizeOf({ grid, files, bounds: [low, high] }) {
  if (grid) return `${grid.width} x ${grid.height} cells`;
  const [width, height] = [high[0] - low[0], high[1] - low[1]].map((side) => Number(side.toPrecision(3)));
  const bytes = files.reduce((/** @type {number} */ sum, /** @type {any} */ file) => sum + file.bytes, 0);
  return `${width} x ${height} m, ${Math.ceil(bytes / 1000)} kB`;
}

/**
 * The last query of the file at whose ends the robot is free; without one, start and goal as the page proposes them.
 * @param {import("./convert.mjs").Scenario} scenario
 */
function queryOf(scenario) {
  const parsed = Scenario.parse(/** @type {any} */ (scenario));
  const isFree = (/** @type {import("./convert.mjs").Query} */ { start, goal }) =>
    [start, goal].every((end) => parsed.check(end).free);
  const own = scenario.queries.findLast(isFree);
  const places = own ? null : placesIn(parsed);
  parsed.free();
  return own ?? (places ? { name: "places", ...places } : null);
}

/**
 * The cells with robot and query for OMPL, whose grid begins in the origin and is not turned.
 * @param {string} file @param {Grid} grid @param {any} robot @param {import("./convert.mjs").Query} query
 */
function writeCells(file, { rows, resolution, origin, sides: [right, up] }, robot, query) {
  const turn = Math.atan2(right[1], right[0]);
  const unit = (/** @type {number[]} */ side) => side.map((x) => x / resolution);
  const [along, across] = [unit(right), unit(up)];
  const there = (/** @type {number[]} */ [x, y, ...angles]) => {
    const [dx, dy] = [x - origin[0], y - origin[1]];
    return [dx * along[0] + dy * along[1], dx * across[0] + dy * across[1], ...angles.map((angle) => angle - turn)];
  };
  const back = (/** @type {number[]} */ [x, y, ...angles]) => [
    origin[0] + x * along[0] + y * across[0],
    origin[1] + x * along[1] + y * across[1],
    ...angles.map((angle) => angle + turn),
  ];
  const items = [
    ["grid", rows[0].length, rows.length, resolution],
    ...rows.map((row) => ["cells", row]),
    robot.type === "disc" ? ["radius", robot.radius] : ["shape", ...robot.shape.vertices.flat()],
    ["start", ...there(query.start)],
    ["goal", ...there(query.goal)],
  ];
  writeFileSync(file, items.map((item) => `${item.join(" ")}\n`).join(""));
  return { file, back };
}

/** The path with the very ends of the query, which were rounded on the way. @param {number[][]} path @param {any} query */
const pinned = (path, { start, goal }) => [start, ...path.slice(1, -1), goal];

/** @param {string} worlds @param {string} folder of files to write @returns {Entry[]} */
function entriesOf(worlds, folder) {
  const at = (/** @type {string} */ name) => join(worlds, name);
  const all = (/** @type {string} */ name, /** @type {RegExp} */ kind) =>
    readdirSync(at(name))
      .filter((file) => kind.test(file))
      .sort((a, b) => a.localeCompare(b, "en", { numeric: true }))
      .map((file) => at(`${name}/${file}`));
  const disc = (/** @type {number} */ radius) => ({
    robot: { type: "disc", radius },
    words: radius === 0 ? "a point" : `a disc of ${radius} m`,
  });
  const body = (/** @type {number} */ length, /** @type {number} */ width) => {
    const [x, y] = [length / 2, width / 2];
    const corners = [
      [-x, -y],
      [x, -y],
      [x, y],
      [-x, y],
    ];
    return { robot: { type: "footprint", corners }, words: `${length} x ${width} m` };
  };
  const inMetres = { scale: 1 };
  const blocks = join(folder, "blocks.pgm");
  writeFileSync(blocks, blocksMap());
  /** @type {(files: string[], robots: { robot: object, words: string }[], options?: object) => Entry[]} */
  const world = (files, robots, options) =>
    robots.map((robot) => ({ name: basename(files[0]), files, options, ...robot }));
  return [
    ...all("ros", /^(depot|warehouse)\.yaml$/).flatMap((file) =>
      world(withPicture(file), [disc(0.2), body(0.9, 0.62)]),
    ),
    ...world(withPicture(at("ros/tb3_sandbox.yaml")), [disc(0.2), body(0.5, 0.4)]),
    ...world([at("ros/testmap.yaml"), at("ros/testmap.png")], [disc(0.04), body(0.08, 0.05)]),
    ...all("movingai", /\.map$/).flatMap((file) => world([file, `${file}.scen`], [disc(0.3), body(0.6, 0.4)])),
    ...world([blocks], [disc(0.04), body(0.2, 0.08)], { scale: 0.05 }),
    ...world([at("ompl/env1.txt")], [disc(0), body(0.3, 0.2)]),
    ...world([at("ompl/circle_obstacles.txt"), at("ompl/circle_queries.txt")], [disc(0), body(0.9, 0.62)]),
    ...all("geojson", /./).flatMap((file) => world([file], [disc(0.2), body(0.5, 0.4)])),
    ...world([at("wkt/BUW.wkt")], [disc(0.2), body(0.5, 0.4)]),
    ...world([at("rmf/office.building.yaml")], [disc(0.2), body(0.5, 0.4)]),
    ...all("svg", /^(parking1|warehouse)\.svg$/).flatMap((file) =>
      world([file], [disc(0.2), body(0.9, 0.62)], inMetres),
    ),
    ...all("dxf", /./).flatMap((file) => world([file], [disc(0.2), body(0.5, 0.4)])),
    ...all("tpcap", /^Case\d+\.csv$/).map((file) => ({ name: basename(file), files: [file], words: "its car" })),
  ];
}

/** A picture of 1024 x 1024 cells with 10,000 blocks, between which two cells and more are free. */
function blocksMap() {
  const side = 1024;
  const pixels = Buffer.alloc(side * side, 255);
  let state = 1;
  const below = (/** @type {number} */ count) => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    return (state >>> 16) % count;
  };
  for (let i = 0; i < 10_000; i += 1) {
    const [left, top] = [12 + 10 * (i % 100), 12 + 10 * Math.floor(i / 100)];
    const [width, height] = [4 + below(5), 4 + below(5)];
    const [x, y] = [left + below(9 - width), top + below(9 - height)];
    for (let row = y; row < y + height; row += 1) pixels.fill(0, row * side + x, row * side + x + width);
  }
  return Buffer.concat([Buffer.from(`P5 ${side} ${side} 255\n`), pixels]);
}
