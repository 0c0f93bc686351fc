/** The rows that compare with no peer: new processes, memory, threads. */
import { join } from "node:path";
import { Problem, ask, root } from "../../scripts/run.mjs";
import { spread } from "./report.mjs";

/** @typedef {import("./report.mjs").Figure} Figure */
/**
 * @typedef {{ forests: string[], isQuick: boolean }} Setting  scenarios of arms of four links, one for each new process
 */
/** @typedef {{ name: string, side: import("./sides.mjs").SideName, measure: (setting: Setting) => Figure[] }} Extra */

/** @type {Extra[]} */
export const extras = [
  { name: "First roadmap of a new process (4R, n = 1000)", side: "node", measure: coldStarts },
  { name: "Memory of the WebAssembly instance (4R, k = 10)", side: "node", measure: instance },
  { name: "Graph and index (4R, n = 1,000,000)", side: "native", measure: graphAndIndex },
  { name: "Two threads (k-PRM, batch, 4R, n = 10,000)", side: "native", measure: threads },
];

/** @param {string} name @param {number[]} values @returns {Figure} */
const figure = (name, ...values) => ({ name, value: spread(values) });

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
 * Runs a script in a new Node process on all cores, as engines compile beside the page, and returns what it prints as
 * JSON.
 * @param {string} script
 * @param {string[]} args
 */
function inNode(script, args) {
  const answer = ask(process.execPath, [join(root, "benches", "peers", script), ...args]);
  if (answer === undefined) throw new Problem(`benches/peers/${script} failed.`);
  return JSON.parse(answer);
}

/** Runs a benchmark of the crate on all cores and returns what it prints. @param {string[]} args */
function inCargo(args) {
  const answer = ask("cargo", ["bench", "--locked", ...args]);
  if (answer === undefined) throw new Problem(`\`cargo bench --locked ${args.join(" ")}\` failed.`);
  return answer;
}
