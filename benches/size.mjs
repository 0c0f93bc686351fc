/**
 * Large worlds in Node: reading, the first path, and the memory of the WebAssembly instance, which never shrinks.
 * `node benches/size.mjs rectangles|discs|corners COUNT` prints a row; `node benches/size.mjs` all of them, each in a process of its own.
 */
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { Scenario } from "planarium";
import { root } from "../scripts/run.mjs";

const ROWS = [
  ["rectangles", 1000],
  ["rectangles", 10_000],
  ["rectangles", 100_000],
  ["discs", 100_000],
  ["corners", 10_000],
  ["corners", 100_000],
  ["corners", 1_000_000],
];

const [kind, count] = process.argv.slice(2);
if (kind === undefined) {
  console.log("| world | text, MB | read, ms | first path, ms | memory, MB |\n|---|---|---|---|---|");
  for (const [name, size] of ROWS) {
    process.stdout.write(execFileSync(process.execPath, [fileURLToPath(import.meta.url), String(name), String(size)]));
  }
} else {
  await measure(kind, Number(count));
}

/**
 * An obstacle in each square metre, or one polygon with upright teeth.
 * @param {string} kind
 * @param {number} count
 */
function obstacles(kind, count) {
  const side = Math.ceil(Math.sqrt(count));
  // Lehmer's generator: the same numbers in every run.
  let state = 1;
  const random = () => (state = (state * 48_271) % 2_147_483_647) / 2_147_483_647;
  if (kind === "corners") {
    const teeth = Array.from({ length: count - 2 }, (_, i) => [
      (100 * i) / (count - 2),
      i % 2 === 0 ? 10 : 20 + 20 * random(),
    ]);
    return { side: 100, list: [{ type: "polygon", vertices: [...teeth, [100, 0], [0, 0]] }] };
  }
  const list = Array.from({ length: count }, (_, i) => {
    const [x, y] = [i % side, Math.floor(i / side)];
    const radius = 0.1 + 0.25 * random();
    const center = [x + 0.15 + radius + (0.7 - 2 * radius) * random(), y + 0.5];
    if (kind === "discs") {
      return { type: "disc", center, radius: Math.min(radius, 0.35) };
    }
    const [left, right] = [center[0] - radius, center[0] + radius];
    const [bottom, top] = [y + 0.15, y + 0.2 + 0.6 * random()];
    return {
      type: "polygon",
      vertices: [
        [left, bottom],
        [right, bottom],
        [right, top],
        [left, top],
      ],
    };
  });
  return { side, list };
}

/**
 * Prints a row.
 * @param {string} kind
 * @param {number} count
 */
async function measure(kind, count) {
  const glue = pathToFileURL(join(root, "dist", "package", "planarium_glue.js")).href;
  const { initSync } = await import(glue);
  /** @type {WebAssembly.Memory} */
  const memory = initSync().memory;
  const { side, list } = obstacles(kind, count);
  const ends =
    kind === "corners"
      ? [
          [2, 60],
          [98, 60],
        ]
      : [
          [0, 0],
          [20, 20],
        ];
  const text = JSON.stringify({
    format: "planarium-scenario-1",
    name: "size",
    world: { bounds: { min: [-0.5, -0.5], max: [side + 0.5, side + 0.5] }, obstacles: list },
    robot: { type: "disc", radius: 0.1 },
    queries: [{ name: "across", start: ends[0], goal: ends[1] }],
  });
  const began = process.cpuUsage().user;
  const scenario = Scenario.parse(text);
  const read = process.cpuUsage().user;
  const planner = scenario.planner({ algorithm: "rrt-connect" });
  while (planner.step(1000) === "running");
  const planned = process.cpuUsage().user;
  if (planner.status !== "solved") {
    throw new Error(`${kind} ${count}: ${planner.status}`);
  }
  const columns = [text.length / 1e6, (read - began) / 1e3, (planned - read) / 1e3, memory.buffer.byteLength / 1e6];
  console.log(`| ${count} ${kind} | ${columns.map((x) => x.toFixed(1)).join(" | ")} |`);
}
