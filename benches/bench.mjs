/**
 * `npm run bench`: the reports' roadmaps and single queries, natively and in Node, beside OMPL and OxMPL, in one run.
 *
 *   --quick           three worlds a row and few runs: does it work at all?
 *   --worlds N        worlds a row (50)
 *   --sides a,b       of native, node, ompl, oxmpl (all); peers that are not installed are left out, aloud
 *   --rows TEXT       only rows whose name contains the text
 *   --no-build        takes what is built
 *   --json FILE       writes all figures
 *   --readme          puts the summary into the README
 *
 * In every world all sides take their turns, each in a process of its own, pinned to the same core; so what disturbs the machine
 * disturbs all of them, and ratios are taken world by world. Every run is fresh; its set-up is told apart.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { Problem, ask, root, script } from "../scripts/run.mjs";
import { arms } from "./peers/arms.mjs";
import { aimTable, armTable, digits, figures, ratioTable, spread, summaryTable } from "./peers/report.mjs";
import { pinned, sideNames, startSide } from "./peers/sides.mjs";
import { rows, writeWorlds } from "./peers/worlds.mjs";

/** @typedef {import("./peers/sides.mjs").Side} Side */
/** @typedef {import("./peers/sides.mjs").SideName} SideName */
/** @typedef {import("./peers/sides.mjs").Run} Run */
/** @typedef {import("./peers/worlds.mjs").Row} Row */

/** Milliseconds within which the first roadmap of a cold page is to stand. */
const COLD = 50;

await script(async () => {
  const { values: options } = parseArgs({
    options: {
      quick: { type: "boolean", default: false }, worlds: { type: "string" }, sides: { type: "string" }, rows: { type: "string", default: "" },
      "no-build": { type: "boolean", default: false }, json: { type: "string" }, readme: { type: "boolean", default: false },
    },
  });
  const count = Number(options.worlds ?? (options.quick ? 3 : 50));
  if (!Number.isInteger(count) || count < 1) throw new Problem(`--worlds takes a whole number from 1, not ${options.worlds}.`);
  const runs = options.quick ? { prm: 1, "rrt-connect": 3, "rrt-control": 3, sst: 3, cold: 2, warm: 2 } : { prm: 3, "rrt-connect": 10, "rrt-control": 5, sst: 5, cold: 10, warm: 10 };
  const names = /** @type {SideName[]} */ (options.sides?.split(",") ?? sideNames);
  const unknown = names.find((name) => !sideNames.includes(name));
  if (unknown !== undefined) throw new Problem(`There is no side \`${unknown}\`; there are ${sideNames.join(", ")}.`);
  const chosen = rows.filter(({ name }) => name.includes(options.rows));
  if (chosen.length === 0) throw new Problem(`No row contains \`${options.rows}\`; there are: ${rows.map(({ name }) => name).join("; ")}.`);

  /** @type {Map<SideName, Side | undefined>} */
  const sides = new Map();
  const folder = mkdtempSync(join(tmpdir(), "planarium-bench-"));
  try {
    for (const name of names) sides.set(name, await startSide(name, !options["no-build"]));
    // Loaded only now: the package may just have been built.
    const { Scenario } = await import("planarium");
    const measured = [];
    for (const row of chosen) {
      console.error(`bench: ${row.name}`);
      const worlds = writeWorlds(Scenario, row, count, folder);
      const present = arms(row).filter(({ side }) => sides.get(side) !== undefined);
      measured.push(figures(row, await takeTurns(sides, present, worlds, runs[row.planner], runs.warm)));
    }
    const forests = writeWorlds(Scenario, rows[2], runs.cold, folder);
    const cold = names.includes("node") ? coldStarts(forests) : undefined;
    const memory = names.includes("node") ? inNode("memory.mjs", [forests[0].json, options.quick ? "2000" : "200000"]) : undefined;
    print(measured, sides, count, runs);
    if (cold !== undefined) console.log(`${coldSentence(cold)}\n\n${memorySentence(memory)}`);
    if (options.json !== undefined) {
      const titles = [...sides.values()].flatMap((side) => side?.title ?? []);
      writeFileSync(options.json, `${JSON.stringify({ sides: titles, worlds: count, runs, rows: measured, cold, memory }, null, 1)}\n`);
    }
    if (options.readme) updateReadme(`${headline(sides, count, runs)}\n\n${summaryTable(measured)}\n${aimTable(measured)}${cold === undefined ? "" : `\n${coldSentence(cold)}\n`}`);
  } finally {
    for (const side of sides.values()) side?.stop();
    rmSync(folder, { recursive: true, force: true });
  }
});

/**
 * All arms in all worlds; who begins moves on with every world.
 * @param {Map<SideName, Side | undefined>} sides
 * @param {import("./peers/arms.mjs").Arm[]} present
 * @param {import("./peers/worlds.mjs").World[]} worlds
 * @param {number} runs
 * @param {number} warm
 */
async function takeTurns(sides, present, worlds, runs, warm) {
  const ask = (/** @type {typeof present[number]} */ { side, job }, /** @type {typeof worlds[number]} */ world, /** @type {number} */ seed, /** @type {number} */ times) =>
    /** @type {Side} */ (sides.get(side)).ask(job(world, seed, times));
  // The first runs meet cold caches and, in Node, code that the engine has not compiled well yet. They are not counted.
  for (const arm of present) await ask(arm, worlds[0], 1_000_000, warm);
  /** @type {Map<string, Run[][]>} */
  const results = new Map(present.map(({ name }) => [name, []]));
  for (const [number, world] of worlds.entries()) {
    for (let turn = 0; turn < present.length; turn += 1) {
      const arm = present[(number + turn) % present.length];
      results.get(arm.name)?.push(await ask(arm, world, runs * number, runs));
    }
  }
  return results;
}

/**
 * What a fresh Node process, on the core of all the others, prints as JSON.
 * @param {string} script
 * @param {string[]} args
 */
function inNode(script, args) {
  const [program, ...rest] = [...pinned, process.execPath, join(root, "benches", "peers", script), ...args];
  const answer = ask(program, rest);
  if (answer === undefined) throw new Problem(`benches/peers/${script} failed.`);
  return JSON.parse(answer);
}

/** Fresh processes, each with its first roadmap. @param {import("./peers/worlds.mjs").World[]} worlds */
function coldStarts(worlds) {
  const starts = worlds.map(({ json }) => inNode("cold.mjs", [json]));
  return { load: spread(starts.map(({ load }) => load)), roadmap: spread(starts.map(({ roadmap }) => roadmap)) };
}

/** @param {ReturnType<typeof coldStarts>} cold */
function coldSentence({ load, roadmap }) {
  return `First roadmap of a cold page (4R, n = 1000), ${roadmap.count} fresh processes: ${digits(roadmap.median)} ms (${digits(roadmap.low)} to ${digits(roadmap.high)}), ` +
    `after ${digits(load.median)} ms of loading. Aim: <= ${COLD} ms, ${roadmap.median <= COLD ? "reached" : "MISSED"}.`;
}

/** @param {{ before: number, peak: number, vertices: number, edges: number, events: number }} memory */
function memorySentence({ before, peak, vertices, edges, events }) {
  const megabytes = (/** @type {number} */ bytes) => digits(bytes / 1e6);
  return `Memory of the WebAssembly instance with a 4R roadmap of ${vertices} vertices, ${edges} edges, ${events} events: ${megabytes(peak)} MB at most, ` +
    `${megabytes(before)} MB before, ${Math.round((peak - before) / vertices)} bytes a vertex with all that hangs on it.`;
}

/**
 * Who took part, and in how much.
 * @param {Map<SideName, Side | undefined>} sides
 * @param {number} count
 * @param {Record<Row["planner"], number>} runs
 */
function headline(sides, count, runs) {
  const titles = [...sides.values()].flatMap((side) => side?.title ?? []);
  return `${titles.join("; ")}${pinned.length > 0 ? "; on one core" : ""}. ${count} worlds a row, ${runs.prm} roadmaps or ${runs["rrt-connect"]} queries in each.`;
}

/**
 * @param {import("./peers/report.mjs").RowFigures[]} measured
 * @param {Map<SideName, Side | undefined>} sides
 * @param {number} count
 * @param {Record<Row["planner"], number>} runs
 */
function print(measured, sides, count, runs) {
  const absent = [...sides].filter(([, side]) => side === undefined).map(([name]) => name);
  console.log(headline(sides, count, runs));
  if (absent.length > 0) console.log(`\nLEFT OUT, not installed: ${absent.join(", ")}.`);
  console.log(`\n${summaryTable(measured)}\n${aimTable(measured)}\n${ratioTable(measured)}\n${armTable(measured)}`);
}

/** Puts a table between the README's two marks. @param {string} table */
function updateReadme(table) {
  const file = join(root, "README.md");
  const text = readFileSync(file, "utf8");
  const updated = text.replace(/(<!-- bench -->\n).*?(<!-- \/bench -->)/s, (_, before, after) => `${before}${table}${after}`);
  if (!text.includes("<!-- bench -->\n")) throw new Problem("README.md has no place for the table: `<!-- bench -->` and `<!-- /bench -->`.");
  writeFileSync(file, updated);
}
