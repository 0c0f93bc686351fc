/**
 * `npm run bench:worlds`: every planner with its defaults in many worlds: generated ones, and maps and parking cases of
 * other people.
 *
 *   --only IDS        planners, with commas between them (all)
 *   --groups NAMES    groups of worlds, with commas between them (all)
 *   --queries N       queries of each map, and worlds of each generator and robot (50)
 *   --first N         the seed of the first generated world (5000)
 *   --seconds S       the limit of a run, of the processor's time (5)
 *   --set NAME=VALUE  an option of every planner that has it; may be repeated
 *   --jobs N          runs at the same time (as many as there are processors)
 *   --binary FILE     the program that plans (built if it is not given)
 *   --rows FILE       also writes a line of JSON for each run
 *   --write           updates the table in docs/benchmarks.md, or docs/worlds.md
 *   --files           measures the files of other people instead, beside OMPL: see worlds/files.mjs
 *   --seeds N         seeds of each of their planners (5)
 *   --json FILE       writes the medians of those planners
 *
 * PLANARIUM_WORLDS names a folder with `movingai/*.map`, `ros/*.yaml`, `ompl/circle_*.txt` and `tpcap/*.csv`,
 * PLANARIUM_SCENARIOS one with scenarios; without them, the worlds are generated ones. A query counts if there is a
 * path: if some planner found one, or the shortest is known. A planner is compared with the shortest path where there
 * is an exact one, else with the shortest that any planner found.
 */
import { spawn, spawnSync } from "node:child_process";
import { appendFileSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { parseArgs } from "node:util";
import { script } from "../scripts/run.mjs";
import { integer, update } from "./peers/arguments.mjs";
import { quantile } from "./peers/report.mjs";
import { converted } from "./worlds/convert.mjs";
import { measureFiles } from "./worlds/files.mjs";

/** @typedef {{ file: string } | { generate: string, options: Record<string, unknown> }} World */
/**
 * @typedef {{ group: string, robot: string, world: World, query?: string, name: string, limit?: number }} Task  a query
 *   of a world
 */
/**
 * @typedef {{ status?: string, seconds: number, first: number | null, length: number, longest: number, error?: string,
 *   exact?: boolean }} Reply
 */
/** @typedef {{ task: Task, planner: string, reply: Reply }} Row */

/** The generators, and the robots of each. */
const generators = {
  forest: ["arm"],
  clutter: ["disc", "rigid_body", "car", "arm"],
  discs: ["disc", "rigid_body", "car", "arm"],
  maze: ["disc", "rigid_body", "car"],
  gap: ["disc", "rigid_body", "car", "arm"],
  "bug-trap": ["disc"],
};

/** The planners whose paths are measured along arcs of controls. */
const by_controls = ["rrt-control", "sst"];

/** The shortest path among more obstacles than this takes too long to be asked for. */
const MOST_OBSTACLES = 500;

await script(async () => {
  const { values: given } = parseArgs({
    options: {
      only: { type: "string" },
      groups: { type: "string" },
      queries: { type: "string", default: "50" },
      first: { type: "string", default: "5000" },
      seconds: { type: "string", default: "5" },
      set: { type: "string", multiple: true, default: [] },
      jobs: { type: "string", default: `${availableParallelism()}` },
      binary: { type: "string" },
      rows: { type: "string" },
      write: { type: "boolean", default: false },
      files: { type: "boolean", default: false },
      seeds: { type: "string", default: "5" },
      json: { type: "string" },
    },
  });
  const [queries, first, jobs, seconds] = [
    integer("queries", given.queries, 1),
    integer("first", given.first, 0),
    integer("jobs", given.jobs, 1),
    Number(given.seconds),
  ];
  const binary = given.binary ?? build();
  const folder = mkdtempSync(join(tmpdir(), "planarium-worlds-"));
  const settings = given.set.map((setting) => /** @type {[string, string]} */ (setting.split("=")));
  const parametersOf = (/** @type {string[]} */ options) =>
    Object.fromEntries(
      settings.filter(([name]) => options.includes(name)).map(([name, value]) => [name, value_of(value)]),
    );
  try {
    const groups = given.groups?.split(",");
    if (given.files) {
      const { text, cells } = await measureFiles(serve(binary), {
        folder,
        seconds,
        seeds: integer("seeds", given.seeds, 1),
        planners: planned(given.only?.split(","))
          .filter(({ id }) => id !== "default")
          .map(({ id, robots, options }) => ({ id, robots, parameters: parametersOf(options) })),
        only: groups,
      });
      console.log(text);
      if (given.json !== undefined) writeFileSync(given.json, JSON.stringify(cells));
      if (given.write) update("files", `${text}\n`, "worlds.md");
      return;
    }
    const tasks = (await worlds(folder, queries, first, serve(binary))).filter(
      (task) => groups?.includes(task.group) ?? true,
    );
    const planners = planned(given.only?.split(","));
    /** @type {Row[]} */
    const rows = [];
    const pending = tasks.flatMap((task) => [
      ...(task.limit === undefined ? [] : [{ task, planner: "optimum", job: { ...task.world, query: task.query } }]),
      ...planners
        .filter((planner) => planner.robots.includes(task.robot))
        .map(({ id, options }) => ({
          task,
          planner: id,
          job: {
            ...task.world,
            query: task.query,
            planner: id === "default" ? undefined : id,
            defaults: id === "default",
            seed: 1,
            seconds,
            parameters: parametersOf(options),
          },
        })),
    ]);
    console.error(`bench: ${tasks.length} queries, ${pending.length} runs`);
    let next = 0;
    await Promise.all(
      Array.from({ length: jobs }, async () => {
        const side = serve(binary);
        while (next < pending.length) {
          const { task, planner, job } = pending[next];
          next += 1;
          const reply = /** @type {Reply} */ (await side.ask(job));
          rows.push({ task, planner, reply });
          if (given.rows !== undefined)
            appendFileSync(given.rows, `${JSON.stringify({ ...task, planner, ...reply })}\n`);
          if (next % 1000 === 0) console.error(`bench: ${next} of ${pending.length}`);
        }
        side.end();
      }),
    );
    const text = tables(
      rows,
      planners.map((planner) => planner.id),
    );
    console.log(text);
    if (given.write) update("worlds", `${text}\n`);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

/** @param {string} text */
function value_of(text) {
  if (text === "true" || text === "false") return text === "true";
  return Number.isNaN(Number(text)) ? text : Number(text);
}

/** The program that plans. */
function build() {
  const crate = ["--package", "planarium-formats", "--bench", "worlds"];
  const done = spawnSync("cargo", ["build", "--release", ...crate, "--message-format=json"], {
    encoding: "utf8",
    stdio: ["ignore", "pipe", "inherit"],
    maxBuffer: 1 << 28,
  });
  const built = done.stdout
    .split("\n")
    .filter((line) => line.includes('"executable":"'))
    .map((line) => JSON.parse(line));
  const found = built.find((message) => message.target.name === "worlds");
  if (done.status !== 0 || found === undefined) throw new Error("cargo built no bench");
  return found.executable;
}

/** A process that plans, one job at a time. @param {string} binary */
function serve(binary) {
  const child = spawn(binary, ["--serve"], { stdio: ["pipe", "pipe", "inherit"] });
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  return {
    /** @param {object} job @returns {Promise<any>} */
    async ask(job) {
      child.stdin.write(`${JSON.stringify(job)}\n`);
      const line = await lines.next();
      if (line.done === true) throw new Error("the bench has ended");
      return JSON.parse(line.value);
    },
    end() {
      child.stdin.end();
    },
  };
}

/** The planners of the catalogue with the default one before them. @param {string[] | undefined} only */
function planned(only) {
  const catalogue = JSON.parse(readFileSync("schema/catalogue.json", "utf8"));
  const all = catalogue.planners.map((/** @type {any} */ planner) => ({
    id: planner.id,
    robots: planner.robots,
    options: planner.parameters.map((/** @type {any} */ option) => option.name),
  }));
  const robots = ["arm", "disc", "rigid_body", "car"];
  const listed = [{ id: "default", robots, options: ["max_iterations", "tolerance"] }, ...all];
  return listed.filter((planner) => only?.includes(planner.id) ?? true);
}

/**
 * Every query of every world.
 * @param {string} folder of files to write
 * @param {number} queries
 * @param {number} first  the seed of the first generated world
 * @param {ReturnType<typeof serve>} side
 * @returns {Promise<Task[]>}
 */
async function worlds(folder, queries, first, side) {
  /** @type {Task[]} */
  const tasks = [];
  const { PLANARIUM_SCENARIOS: scenarios, PLANARIUM_WORLDS: maps } = process.env;
  const all = [
    ...(maps === undefined
      ? []
      : await converted(maps, queries, (files, options, times) => side.ask({ read: files, options, times }))),
    ...(scenarios === undefined
      ? []
      : readdirSync(scenarios)
          .filter((file) => file.endsWith(".json"))
          .sort()
          .map((file) => ({
            group: "course reports",
            scenario: JSON.parse(readFileSync(join(scenarios, file), "utf8")),
          }))
          .filter(({ scenario }) => scenario.format === "planarium-scenario-1")),
  ];
  for (const { group, scenario } of all) {
    const file = join(folder, `${tasks.length}.json`);
    writeFileSync(file, JSON.stringify(scenario));
    const is_exact = scenario.robot.type === "disc" && scenario.world.obstacles.length <= MOST_OBSTACLES;
    for (const query of scenario.queries) {
      tasks.push({
        group,
        robot: scenario.robot.type,
        world: { file },
        query: query.name,
        name: `${scenario.name} ${query.name}`,
        ...(is_exact ? { limit: 1 } : {}),
      });
    }
  }
  side.end();
  for (const [generate, robots] of Object.entries(generators)) {
    for (const robot of robots) {
      for (let seed = first; seed < first + queries; seed += 1) {
        const options = { seed, ...(robots.length > 1 ? { robot } : {}) };
        tasks.push({
          group: generate,
          robot,
          world: { generate, options },
          name: `${generate} ${robot} ${seed}`,
          ...(robot === "disc" ? { limit: 1 } : {}),
        });
      }
    }
  }
  return tasks;
}

/**
 * The tables: what each planner did, and how many queries it solved in each group.
 * @param {Row[]} rows @param {string[]} planners
 */
function tables(rows, planners) {
  /** @type {Map<string, { task: Task, best: number, isSolvable: boolean }>} */
  const known = new Map();
  for (const { task, planner, reply } of rows) {
    const entry = known.get(task.name) ?? { task, best: Infinity, isSolvable: false };
    known.set(task.name, entry);
    // Lengths of cars by controls are others than along curves.
    if (reply.error !== undefined || (task.robot === "car" && planner === "optimum")) continue;
    const isSolved = planner === "optimum" ? reply.length !== null : reply.status === "solved";
    if (!isSolved) continue;
    entry.isSolvable = true;
    if (!by_controls.includes(planner)) entry.best = Math.min(entry.best, reply.length);
  }
  const groups = [...new Set([...known.values()].map(({ task }) => `${task.group} ${task.robot}`))];
  const percent = (/** @type {number} */ part, /** @type {number} */ all) =>
    all === 0 ? "–" : `${Math.floor((1000 * part) / all) / 10}`;
  const head = [
    "planner",
    "queries",
    "solved, %",
    "seconds, median",
    "95th",
    "length over the best, %, median",
    "95th",
    "longest step, ms",
  ];
  const first = [head, head.map(() => "---")];
  const second = [
    ["solved, %", ...planners],
    ["---", ...planners.map(() => "---")],
  ];
  const of = (/** @type {string} */ planner) =>
    rows.filter(
      (row) => row.planner === planner && row.reply.error === undefined && known.get(row.task.name)?.isSolvable,
    );
  for (const planner of planners) {
    const own = of(planner);
    const solved = own.filter(({ reply }) => reply.status === "solved");
    const times = solved.map(({ reply }) => reply.seconds);
    const gaps = by_controls.includes(planner)
      ? []
      : solved.flatMap(({ task, reply }) => {
          const best = known.get(task.name)?.best ?? 0;
          return best > 0 ? [100 * (reply.length / best - 1)] : [];
        });
    const at = (/** @type {number[]} */ values, /** @type {number} */ share, /** @type {number} */ digits) =>
      values.length === 0 ? "–" : quantile(values, share).toFixed(digits);
    first.push([
      `\`${planner}\``,
      `${own.length}`,
      percent(solved.length, own.length),
      at(times, 0.5, 3),
      at(times, 0.95, 2),
      at(gaps, 0.5, 1),
      at(gaps, 0.95, 0),
      (1000 * Math.max(0, ...own.map(({ reply }) => reply.longest))).toFixed(1),
    ]);
  }
  for (const group of groups) {
    const cells = planners.map((planner) => {
      const own = of(planner).filter(({ task }) => `${task.group} ${task.robot}` === group);
      return percent(own.filter(({ reply }) => reply.status === "solved").length, own.length);
    });
    const count = [...known.values()].filter(
      ({ task, isSolvable }) => isSolvable && `${task.group} ${task.robot}` === group,
    ).length;
    second.push([`${group} (${count})`, ...cells]);
  }
  return [first, second].map((table) => table.map((row) => `| ${row.join(" | ")} |`).join("\n")).join("\n\n");
}
