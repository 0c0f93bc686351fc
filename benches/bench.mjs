/**
 * `npm run bench`: roadmaps and queries of arms, bodies and cars, natively and in Node, beside OMPL and OxMPL, then first
 * answers, maps (where PLANARIUM_WORLDS has some), fleets, new processes, memory and threads; in one run, which ends
 * with the aims reached and missed.
 *
 *   --quick           three worlds per row and few runs, as a smoke test
 *   --worlds N        worlds per row (50)
 *   --sides a,b       of native, node, ompl, oxmpl (all); peers that are not installed are skipped, with a message
 *   --first N         the seed of the first world (0)
 *   --rows TEXT       only rows whose name contains the text; may be repeated
 *   --no-build        uses the existing build
 *   --json FILE       writes all figures
 *   --write           updates the tables in docs/benchmarks.md
 *
 * All sides run in turn in every world, each in its own process pinned to the same core, so that disturbances affect
 * all of them alike. Ratios are taken per world. Every run has a new planner, whose set-up is measured separately.
 */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { Problem, script } from "../scripts/run.mjs";
import { aimTable, judge } from "./peers/aims.mjs";
import { integer, update } from "./peers/arguments.mjs";
import { arms } from "./peers/arms.mjs";
import { extras } from "./peers/extras.mjs";
import { armTable, figureTable, figures, summaryTable } from "./peers/report.mjs";
import { pinned, sideNames, startSide } from "./peers/sides.mjs";
import { rows, writeWorlds } from "./peers/worlds.mjs";

/** @typedef {import("./peers/sides.mjs").Side} Side */
/** @typedef {import("./peers/sides.mjs").SideName} SideName */
/** @typedef {import("./peers/sides.mjs").Run} Run */
/** @typedef {import("./peers/worlds.mjs").Row} Row */

await script(async () => {
  const { values: options } = parseArgs({
    options: {
      quick: { type: "boolean", default: false },
      worlds: { type: "string" },
      first: { type: "string", default: "0" },
      sides: { type: "string" },
      rows: { type: "string", multiple: true, default: [""] },
      "no-build": { type: "boolean", default: false },
      json: { type: "string" },
      write: { type: "boolean", default: false },
    },
  });
  const count = integer("worlds", options.worlds ?? (options.quick ? "3" : "50"), 1);
  const first = integer("first", options.first, 0);
  const runs = options.quick
    ? { prm: 1, "rrt-connect": 3, "rrt-control": 3, sst: 3, cold: 2, warm: 2 }
    : { prm: 3, "rrt-connect": 10, "rrt-control": 5, sst: 5, cold: 10, warm: 10 };
  const names = /** @type {SideName[]} */ (options.sides?.split(",") ?? sideNames);
  const unknown = names.find((name) => !sideNames.includes(name));
  if (unknown !== undefined) throw new Problem(`There is no side \`${unknown}\`. Sides: ${sideNames.join(", ")}.`);
  const isChosen = (/** @type {{ name: string }} */ { name }) => options.rows.some((text) => name.includes(text));
  const chosen = rows.filter(isChosen);
  const others = extras.filter(isChosen).filter(({ side }) => names.includes(side));
  if (chosen.length + others.length === 0) {
    throw new Problem(
      `No row contains \`${options.rows.join("`, `")}\`. Rows: ${[...rows, ...extras].map(({ name }) => name).join("; ")}.`,
    );
  }

  /** @type {Map<SideName, Side | undefined>} */
  const sides = new Map();
  const folder = mkdtempSync(join(tmpdir(), "planarium-bench-"));
  try {
    for (const name of names) sides.set(name, await startSide(name, !options["no-build"]));
    // Imported here, since the package may just have been built.
    const [{ Scenario }, { Fleet }] = [await import("planarium"), await import("planarium/full")];
    const measured = [];
    for (const row of chosen) {
      console.error(`bench: ${row.name}`);
      const worlds = writeWorlds(Scenario, row, first, count, folder);
      const present = arms(row).filter(({ side }) => sides.get(side) !== undefined);
      measured.push(figures(row, await takeTurns(sides, present, worlds, runs[row.planner], runs.warm)));
    }
    const forests = writeWorlds(Scenario, rows[2], 0, runs.cold, folder).map(({ json }) => json);
    const missing = [...sides].filter(([, side]) => side === undefined).map(([name]) => `${name}, not installed`);
    const further = [];
    for (const { name, measure } of others) {
      console.error(`bench: ${name}`);
      try {
        const [native, node] = /** @type {const} */ (["native", "node"]).map((side) => sides.get(side));
        const setting = { forests, isQuick: options.quick, native, node, Scenario, Fleet, folder };
        further.push({ row: name, arms: [], figures: await measure(setting) });
      } catch (error) {
        // What was measured before must not be lost.
        if (!(error instanceof Problem)) throw error;
        missing.push(`${name}: ${error.message}`);
      }
    }
    const all = [...measured, ...further];
    const skipped = missing.map((each) => `\n\nSKIPPED: ${each}`).join("");
    const summary = `${headline(sides, count, runs)}${skipped}\n\n${summaryTable(chosen, measured)}\n${figureTable(further)}`;
    console.log(`${summary}\n${figureTable(measured)}\n${armTable(measured)}\n${aimTable(all)}`);
    if (options.json !== undefined) {
      const titles = [...sides.values()].flatMap((side) => side?.title ?? []);
      writeFileSync(
        options.json,
        `${JSON.stringify({ sides: titles, worlds: count, runs, rows: all, aims: judge(all) }, null, 1)}\n`,
      );
    }
    if (options.write) {
      update("bench", summary);
      update("aims", aimTable(all));
    }
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
  const ask = (
    /** @type {typeof present[number]} */ { side, job },
    /** @type {typeof worlds[number]} */ world,
    /** @type {number} */ seed,
    /** @type {number} */ times,
  ) => /** @type {Side} */ (sides.get(side)).ask(job(world, seed, times));
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
 * The sides that took part, and the number of runs.
 * @param {Map<SideName, Side | undefined>} sides
 * @param {number} count
 * @param {Record<Row["planner"], number>} runs
 */
function headline(sides, count, runs) {
  const titles = [...sides.values()].flatMap((side) => side?.title ?? []);
  return `${titles.join("; ")}${pinned.length > 0 ? "; on one core" : ""}. ${count} worlds per row, ${runs.prm} roadmaps, ${runs["rrt-connect"]} queries of an arm or a body, or ${runs.sst} of a car in each.`;
}
