/**
 * `npm run bench`: the reports' roadmaps and single queries, natively and in Node, beside OMPL and OxMPL, in one run.
 *
 *   --quick           three worlds per row and few runs, as a smoke test
 *   --worlds N        worlds per row (50)
 *   --sides a,b       of native, node, ompl, oxmpl (all); peers that are not installed are skipped, with a message
 *   --rows TEXT       only rows whose name contains the text
 *   --no-build        uses the existing build
 *   --json FILE       writes all figures
 *   --write           updates the table in docs/benchmarks.md
 *
 * All sides run in turn in every world, each in its own process pinned to the same core, so that disturbances affect all of them
 * alike. Ratios are taken per world. Every run has a new planner, whose set-up is measured separately.
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

/** The aim for the first roadmap of a new process, in milliseconds. */
const COLD = 50;

await script(async () => {
  const { values: options } = parseArgs({
    options: {
      quick: { type: "boolean", default: false }, worlds: { type: "string" }, sides: { type: "string" }, rows: { type: "string", default: "" },
      "no-build": { type: "boolean", default: false }, json: { type: "string" }, write: { type: "boolean", default: false },
    },
  });
  const count = Number(options.worlds ?? (options.quick ? 3 : 50));
  if (!Number.isInteger(count) || count < 1) throw new Problem(`--worlds must be an integer of at least 1, not ${options.worlds}.`);
  const runs = options.quick ? { prm: 1, "rrt-connect": 3, "rrt-control": 3, sst: 3, cold: 2, warm: 2 } : { prm: 3, "rrt-connect": 10, "rrt-control": 5, sst: 5, cold: 10, warm: 10 };
  const names = /** @type {SideName[]} */ (options.sides?.split(",") ?? sideNames);
  const unknown = names.find((name) => !sideNames.includes(name));
  if (unknown !== undefined) throw new Problem(`There is no side \`${unknown}\`. Sides: ${sideNames.join(", ")}.`);
  const chosen = rows.filter(({ name }) => name.includes(options.rows));
  if (chosen.length === 0) throw new Problem(`No row contains \`${options.rows}\`. Rows: ${rows.map(({ name }) => name).join("; ")}.`);

  /** @type {Map<SideName, Side | undefined>} */
  const sides = new Map();
  const folder = mkdtempSync(join(tmpdir(), "planarium-bench-"));
  try {
    for (const name of names) sides.set(name, await startSide(name, !options["no-build"]));
    // Imported here, since the package may just have been built.
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
    if (options.write) updateTable(`${headline(sides, count, runs)}\n\n${summaryTable(measured)}${cold === undefined ? "" : `\n${coldSentence(cold)}\n`}`);
  } finally {
    for (const side of sides.values()) side?.stop();
    rmSync(folder, { recursive: true, force: true });
  }
});

/**
 * Runs all arms in all worlds. The first arm changes with every world.
 * @param {Map<SideName, Side | undefined>} sides
 * @param {import("./peers/arms.mjs").Arm[]} present
 * @param {import("./peers/worlds.mjs").World[]} worlds
 * @param {number} runs
 * @param {number} warm
 */
async function takeTurns(sides, present, worlds, runs, warm) {
  const ask = (/** @type {typeof present[number]} */ { side, job }, /** @type {typeof worlds[number]} */ world, /** @type {number} */ seed, /** @type {number} */ times) =>
    /** @type {Side} */ (sides.get(side)).ask(job(world, seed, times));
  // The first runs warm up caches and, in Node, the compiler. They are not counted.
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
 * Runs a script in a new Node process on the common core and returns what it prints as JSON.
 * @param {string} script
 * @param {string[]} args
 */
function inNode(script, args) {
  const [program, ...rest] = [...pinned, process.execPath, join(root, "benches", "peers", script), ...args];
  const answer = ask(program, rest);
  if (answer === undefined) throw new Problem(`benches/peers/${script} failed.`);
  return JSON.parse(answer);
}

/** The times of new processes to load the package and to build a first roadmap. @param {import("./peers/worlds.mjs").World[]} worlds */
function coldStarts(worlds) {
  const starts = worlds.map(({ json }) => inNode("cold.mjs", [json]));
  return { load: spread(starts.map(({ load }) => load)), roadmap: spread(starts.map(({ roadmap }) => roadmap)) };
}

/** @param {ReturnType<typeof coldStarts>} cold */
function coldSentence({ load, roadmap }) {
  return `First roadmap of a new process (4R, n = 1000), ${roadmap.count} processes: ${digits(roadmap.median)} ms (${digits(roadmap.low)} to ${digits(roadmap.high)}), ` +
    `after ${digits(load.median)} ms of loading (aim: ${COLD} ms).`;
}

/** @param {{ before: number, peak: number, vertices: number, edges: number, events: number }} memory */
function memorySentence({ before, peak, vertices, edges, events }) {
  const megabytes = (/** @type {number} */ bytes) => digits(bytes / 1e6);
  return `Memory of the WebAssembly instance with a 4R roadmap of ${vertices} vertices, ${edges} edges, ${events} events: ${megabytes(peak)} MB at peak, ` +
    `${megabytes(before)} MB before, ${Math.round((peak - before) / vertices)} bytes per vertex, with its edges and events.`;
}

/**
 * The sides that took part, and the number of runs.
 * @param {Map<SideName, Side | undefined>} sides
 * @param {number} count
 * @param {Record<Row["planner"], number>} runs
 */
function headline(sides, count, runs) {
  const titles = [...sides.values()].flatMap((side) => side?.title ?? []);
  return `${titles.join("; ")}${pinned.length > 0 ? "; on one core" : ""}. ${count} worlds per row, ${runs.prm} roadmaps or ${runs["rrt-connect"]} queries in each.`;
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
  if (absent.length > 0) console.log(`\nSKIPPED, not installed: ${absent.join(", ")}.`);
  console.log(`\n${summaryTable(measured)}\n${aimTable(measured)}\n${ratioTable(measured)}\n${armTable(measured)}`);
}

/** Writes a table between the two marks of docs/benchmarks.md. @param {string} table */
function updateTable(table) {
  const file = join(root, "docs", "benchmarks.md");
  const text = readFileSync(file, "utf8");
  const updated = text.replace(/(<!-- bench -->\n).*?(<!-- \/bench -->)/s, (_, before, after) => `${before}${table}${after}`);
  if (!text.includes("<!-- bench -->\n")) throw new Problem("docs/benchmarks.md has no marks `<!-- bench -->` and `<!-- /bench -->` for the table.");
  writeFileSync(file, updated);
}
