/** The rows beside those of generated worlds: first answers, maps, fleets, new processes, memory, neighbours, threads. */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Problem, ask, root } from "../../scripts/run.mjs";
import { placeOf } from "./aims.mjs";
import { quantile, spread } from "./report.mjs";
import { rows, squares, writeWorlds } from "./worlds.mjs";

/** @typedef {import("./report.mjs").Figure} Figure */
/** @typedef {import("./sides.mjs").Side} Side */
/**
 * @typedef {object} Setting
 * @property {string[]} forests  scenarios of arms of four links, one for each new process
 * @property {boolean} isQuick
 * @property {Side | undefined} native
 * @property {Side | undefined} node
 * @property {typeof import("planarium").Scenario} Scenario
 * @property {typeof import("planarium/full").Fleet} Fleet
 * @property {string} folder  for files
 */
/**
 * @typedef {object} Extra
 * @property {string} name
 * @property {import("./sides.mjs").SideName} side
 * @property {(setting: Setting) => Figure[] | Promise<Figure[]>} measure
 */

/** The rows in whose worlds first answers are measured. */
const firsts = rows.filter(({ name }) =>
  ["RRT-Connect, forest 4R", "RRT-Connect, body in clutter", "Kinodynamic RRT, car in clutter"].includes(name),
);

/** City maps, with the length of their sides in metres. */
const CITIES = { Berlin_0_256: 256, NewYork_1_512: 512 };

/** @type {Extra[]} */
export const extras = [
  ...firsts.map((row) => ({
    name: `First answer, ${placeOf(row.name)}`,
    side: /** @type {const} */ ("node"),
    measure: (/** @type {Setting} */ setting) => firstAnswers(row, setting),
  })),
  ...Object.keys(CITIES).map((map) => ({
    name: `Map, ${map}`,
    side: /** @type {const} */ ("node"),
    measure: (/** @type {Setting} */ setting) => queriesOfMap(map, setting),
  })),
  ...Object.entries(CITIES).map(([map, side]) => ({
    name: `First path on a map, ${map}`,
    side: /** @type {const} */ ("ompl"),
    measure: (/** @type {Setting} */ setting) => firstPaths(map, side, setting),
  })),
  { name: "A plan for 200 discs in an open hall", side: "node", measure: fleets },
  { name: "A plan for 100 discs on a map of 32 x 32 squares", side: "native", measure: fleetsOnMaps },
  { name: "Shortest paths of a point, ten maps", side: "native", measure: shortestPaths },
  { name: "First roadmap of a new process (4R, n = 1000)", side: "node", measure: coldStarts },
  { name: "Memory of the WebAssembly instance (4R, k = 10)", side: "node", measure: instance },
  { name: "Graph and index (4R, n = 1,000,000)", side: "native", measure: graphAndIndex },
  { name: "Neighbours beside kiddo", side: "native", measure: neighbours },
  { name: "Two threads (k-PRM, batch, 4R, n = 10,000)", side: "native", measure: threads },
];

/** @throws {Problem} there is none */
function folderOfMaps() {
  const { PLANARIUM_WORLDS: folder } = process.env;
  if (folder === undefined) throw new Problem("PLANARIUM_WORLDS names no folder with maps.");
  return folder;
}

/** @param {string} name @param {number[]} values @returns {Figure} */
const figure = (name, ...values) => ({ name, value: spread(values.filter(Number.isFinite)) });

/**
 * The default planner with all around it. Both sides answer in turn; the first world warms them up.
 * @param {import("./worlds.mjs").Row} row
 * @param {Setting} setting
 */
async function firstAnswers(row, { native, node, Scenario, folder, isQuick }) {
  const times = [];
  for (const { json } of writeWorlds(Scenario, row, 0, isQuick ? 3 : 30, folder)) {
    const of = async (/** @type {Side | undefined} */ side) => milliseconds(side, `${json} first 0 30`);
    times.push([await of(native), await of(node)]);
  }
  return compared(times.slice(1));
}

/**
 * Random queries of a disc of 0.3 m on a city map: the planners of `npm run bench:shortest`, with the medians of time and of
 * how much longer their paths are than the shortest ones.
 * @param {string} map
 * @param {Setting} setting
 */
function queriesOfMap(map, { folder, isQuick }) {
  folderOfMaps();
  const file = join(folder, `${map}.json`);
  const args = ["--ours", "--only", map, "--queries", isQuick ? "5" : "100", "--json", file];
  printedBy("shortest.mjs", args);
  /** @type {{ side: string, milliseconds: number, longer: number | null }[]} the last is null where no path was found */
  const medians = JSON.parse(readFileSync(file, "utf8"));
  return medians.flatMap(({ side, milliseconds, longer }) => {
    const name = side.replaceAll("`", "");
    // Lengths that differ by rounding alone are equal.
    const percent = longer === null ? NaN : Math.round(1e4 * longer) / 1e4 + 0;
    return [figure(`${name}, Node, ms`, milliseconds), figure(`${name}, % longer than the shortest path`, percent)];
  });
}

/**
 * First paths of a disc and of a body by RRT-Connect, for the longest query of a city map, beside OMPL's on the cells, as
 * `npm run bench:worlds -- --files` measures them. Our paths are proven; our steps are as long as OMPL's, or adapt.
 * @param {string} map
 * @param {number} side  of the map, metres
 * @param {Setting} setting
 */
function firstPaths(map, side, { folder, isQuick }) {
  folderOfMaps();
  const file = join(folder, `${map}-first.json`);
  const shared = ["--files", "--groups", map, "--only", "rrt-connect", "--seeds", isQuick ? "3" : "25", "--json", file];
  const measured = [["--set", `step=${0.2 * Math.hypot(side, side)}`], []].map((steps) => {
    printedBy("worlds.mjs", [...shared, ...steps]);
    return /** @type {import("../worlds/files.mjs").Measured[]} */ (JSON.parse(readFileSync(file, "utf8")));
  });
  return ["disc", "rigid_body"].flatMap((robot) => {
    const of = (/** @type {number} */ run, /** @type {string} */ planner) => {
      const found = measured[run].find((cell) => cell.robot === robot && cell.planner === planner);
      if (!found) throw new Problem(`There are no paths of OMPL on ${map}.`);
      return found;
    };
    const [ours, theirs, adapting] = [of(0, "rrt-connect"), of(0, "OMPL rrt-connect"), of(1, "rrt-connect")];
    return [
      figure(`native, ${robot}, ms`, 1e3 * ours.seconds),
      figure(`native, steps that adapt, ${robot}, ms`, 1e3 * adapting.seconds),
      figure(`OMPL on cells, ${robot}, ms`, 1e3 * theirs.seconds),
      figure(`OMPL on cells, ${robot}, % of paths that are not free`, 100 * (1 - theirs.valid / theirs.solved)),
      figure(`OMPL on cells / native, ${robot}`, theirs.seconds / ours.seconds),
      figure(
        `OMPL on cells / native, steps that adapt, ${robot}`,
        of(1, "OMPL rrt-connect").seconds / adapting.seconds,
      ),
    ];
  });
}

/** Times of the kd-tree over times of kiddo's, for several numbers of states; queries for one neighbour and for ten. */
function neighbours() {
  const lines = inCargo(["--bench", "nearest", "--", "kiddo"]).split("\n");
  const rows = lines.map((line) => line.split("|").map((cell) => cell.trim())).filter(([, , n]) => /^[\d,]+$/.test(n));
  if (rows.length === 0) throw new Problem("`cargo bench --bench nearest -- kiddo` prints no rows.");
  return [...new Set(rows.map(([, space]) => space))].flatMap((space) => {
    const own = rows.filter(([, name]) => name === space);
    const ratios = (/** @type {number} */ ours) =>
      own.flatMap((cells) => {
        const [mine, others] = [cells[ours], cells[ours + 1]].map((cell) => cell.split(", ").map(Number));
        return mine.map((time, i) => time / others[i]);
      });
    return [
      figure(`kd-tree / kiddo, insertion, ${space}`, ...ratios(3)),
      figure(`kd-tree / kiddo, query, ${space}`, ...ratios(5)),
    ];
  });
}

/**
 * Discs that cross halls, 4 m² for each: the times of three seeds, and the longest iteration of all. A small hall warms
 * the sides up.
 * @param {Setting} setting
 */
async function fleets({ native, node, Fleet, folder, isQuick }) {
  /** @type {number[][]} */
  const times = [];
  let longest = 0;
  const halls = isQuick ? [[30, 0]] : [0, 1, 2].map((seed) => [200, seed]);
  for (const [count, seed] of [[20, 0], ...halls]) {
    const fleet = Fleet.generate("hall", { count, seed });
    const file = join(folder, `hall-${count}-${seed}.json`);
    writeFileSync(file, JSON.stringify(fleet));
    fleet.free();
    times.push([
      await milliseconds(native, `${file} fleet ${seed} 1`),
      await milliseconds(node, `${file} fleet ${seed} 1`),
    ]);
    longest = Math.max(longest, await milliseconds(node, `${file} longest ${seed} 1`));
  }
  return [...compared(times.slice(1)), figure("Node, ms of the longest iteration", longest)];
}

/** Discs of 0.3 m on three maps of squares of a metre, of which a fifth is blocked. @param {Setting} setting */
async function fleetsOnMaps({ native, folder, isQuick }) {
  const times = [];
  for (let seed = 0; seed < 3; seed += 1) {
    const file = join(folder, `squares-${seed}.json`);
    writeFileSync(file, JSON.stringify(squares(seed, isQuick ? 20 : 100)));
    times.push(await milliseconds(native, `${file} fleet ${seed} 1`));
  }
  const solved = times.filter(Number.isFinite);
  return [figure("plans found, %", (100 * solved.length) / times.length), figure("native, ms", ...solved)];
}

/** The exact shortest paths beside the crate polyanya, whose program compares their lengths. */
function shortestPaths() {
  const worlds = folderOfMaps();
  const maps = Object.keys(CITIES).map((map) => join(worlds, "movingai", `${map}.map`));
  const manifest = join(root, "benches", "peers", "polyanya", "Cargo.toml");
  const target = join(root, "target", "peers", "polyanya");
  const options = ["--release", "--locked", "--quiet", "--manifest-path", manifest, "--target-dir", target];
  const printed = ask("cargo", ["run", ...options, "--", ...maps]);
  const times = Array.from(
    (printed ?? "").matchAll(/query ([\d.]+) ms \(at most ([\d.]+)\).* polyanya ([\d.]+) ms \(([\d.]+)\)$/gm),
    (found) => found.slice(1).map(Number),
  );
  if (times.length === 0) throw new Problem("The program of benches/peers/polyanya failed.");
  return [
    figure("native, ms", ...times.map(([ours]) => ours)),
    figure("native / polyanya, median query", ...times.map(([ours, , others]) => ours / others)),
    figure("native / polyanya, longest query", ...times.map(([, ours, , others]) => ours / others)),
  ];
}

/**
 * The median of the times that a side replies; NaN without the side, and if a run found nothing.
 * @param {Side | undefined} side
 * @param {string} job
 */
async function milliseconds(side, job) {
  return side === undefined ? NaN : quantile((await side.reply(job)).seconds, 0.5) * 1e3;
}

/**
 * The times of the native side and of Node, and their ratios; without those of a side that is absent.
 * @param {number[][]} times
 */
function compared(times) {
  const of = (/** @type {string} */ name, /** @type {(times: number[]) => number} */ value) => {
    const known = times.map(value).filter(Number.isFinite);
    return known.length > 0 ? [figure(name, ...known)] : [];
  };
  return [
    ...of("native, ms", ([native]) => native),
    ...of("Node, ms", ([, node]) => node),
    ...of("Node / native", ([native, node]) => node / native),
  ];
}

/** Loads the package and builds a roadmap, each time in a new process. @param {Setting} setting */
function coldStarts({ forests }) {
  const starts = forests.map((file) => inNode("cold.mjs", [file]));
  return [
    figure("Node, ms of loading", ...starts.map(({ load }) => load)),
    figure("Node, ms after loading", ...starts.map(({ roadmap }) => roadmap)),
  ];
}

/** The instance never shrinks: its memory is its peak. @param {Setting} setting */
function instance({ forests, isQuick }) {
  const { before, peak, vertices, edges, events } = inNode("memory.mjs", [forests[0], isQuick ? "2000" : "200000"]);
  return [
    figure("vertices", vertices),
    figure("edges", edges),
    figure("events", events),
    figure("MB before", before / 1e6),
    figure("MB at peak", peak / 1e6),
    figure("Node, bytes per vertex, with its edges and events", (peak - before) / vertices),
  ];
}

/** @param {Setting} setting */
function graphAndIndex({ isQuick }) {
  const printed = inCargo(["--bench", "growth", "--", "memory", ...(isQuick ? ["--quick"] : [])]);
  const [, bytes] = printed.match(/^Graph and index: ([\d.]+) bytes per vertex/m) ?? [];
  if (bytes === undefined) throw new Problem("`cargo bench --bench growth -- memory` prints no bytes per vertex.");
  return [figure("native, bytes per vertex", Number(bytes))];
}

/** The bench prints a line such as `{"threads": 2, "ratio": 1.8}`: the time of one thread over that of several. */
function threads() {
  const printed = inCargo(["--bench", "planning", "--features", "parallel", "--", "threads"]);
  const lines = printed
    .split("\n")
    .filter((line) => line.startsWith("{"))
    .map((line) => JSON.parse(line));
  const ratio = lines.find((line) => line.threads === 2)?.ratio;
  if (typeof ratio !== "number")
    throw new Problem("`cargo bench --bench planning --features parallel -- threads` prints no ratio for two threads.");
  return [figure("one thread / two threads", ratio)];
}

/**
 * Runs a script of the peers in a new Node process on all cores, as engines compile beside the page, and returns what it
 * prints as JSON.
 * @param {string} script
 * @param {string[]} args
 */
function inNode(script, args) {
  return JSON.parse(printedBy(`peers/${script}`, args));
}

/** What a script of `benches` prints in a new Node process. @param {string} script @param {string[]} args */
function printedBy(script, args) {
  const answer = ask(process.execPath, [join(root, "benches", script), ...args]);
  if (answer === undefined) throw new Problem(`\`benches/${script} ${args.join(" ")}\` failed.`);
  return answer;
}

/** Runs a benchmark of the crate on all cores and returns what it prints. @param {string[]} args */
function inCargo(args) {
  const answer = ask("cargo", ["bench", "--locked", ...args]);
  if (answer === undefined) throw new Problem(`\`cargo bench --locked ${args.join(" ")}\` failed.`);
  return answer;
}
