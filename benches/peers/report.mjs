/** Figures from runs: medians over the runs in each world, then medians and quartiles over worlds. */
import { comparisons } from "./arms.mjs";

/** @typedef {import("./worlds.mjs").Row} Row */
/** @typedef {import("./sides.mjs").Run} Run */
/** @typedef {{ median: number, low: number, high: number, count: number }} Spread  the median and quartiles of `count` values */
/** @typedef {{ arm: string, milliseconds: Spread, setup: number, solved: number, motions: number, vertices: number, edges: number, length: number }} ArmFigures */
/** @typedef {{ name: string, ratio: Spread, aim: string, reached: boolean | undefined }} RatioFigures */
/** @typedef {{ row: string, arms: ArmFigures[], ratios: RatioFigures[] }} RowFigures */

/**
 * The quantile of some values by the nearest rank; NaN if there are none.
 * @param {number[]} values
 * @param {number} part
 */
export function quantile(values, part) {
  if (values.length === 0) return NaN;
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.round((sorted.length - 1) * part)];
}

/** @param {number[]} values @returns {Spread} */
export function spread(values) {
  return { median: quantile(values, 0.5), low: quantile(values, 0.25), high: quantile(values, 0.75), count: values.length };
}

/**
 * The median of the seconds that the runs in a world took after the set-up. A query that was given up counts as infinite, so that
 * unsolved queries make no world look fast. A roadmap is built whether or not it is solved.
 * @param {Row["planner"]} planner
 * @param {Run[]} runs
 */
export function seconds(planner, runs) {
  return quantile(runs.map((run) => (planner === "prm" || run.solved ? run.build + run.search : Infinity)), 0.5);
}

/**
 * The figures of one row.
 * @param {Row} row
 * @param {Map<string, Run[][]>} results  of each arm, for each world, its runs
 * @returns {RowFigures}
 */
export function figures({ name, planner }, results) {
  const times = new Map([...results].map(([arm, worlds]) => [arm, worlds.map((runs) => seconds(planner, runs))]));
  const lengths = new Map([...results].map(([arm, worlds]) => [arm, worlds.map(medianLength)]));
  const count = [...lengths.values()][0].length;
  // Lengths are compared in worlds that all sides solved; otherwise a side that solves more has the harder worlds.
  const shared = Array.from({ length: count }, (_, world) => world).filter((world) => [...lengths.values()].every((each) => Number.isFinite(each[world])));
  const arms = [...results].map(([arm, worlds]) => {
    const runs = worlds.flat();
    const median = (/** @type {(run: Run) => number} */ of) => quantile(runs.map(of), 0.5);
    return {
      arm,
      milliseconds: spread(finite(times.get(arm) ?? []).map((time) => time * 1e3)),
      setup: median((run) => run.setup * 1e3),
      solved: runs.filter((run) => run.solved).length / runs.length,
      motions: median((run) => run.motions), vertices: median((run) => run.vertices), edges: median((run) => run.edges),
      length: quantile(shared.map((world) => lengths.get(arm)?.[world] ?? NaN), 0.5),
    };
  });
  const ratios = comparisons[planner].flatMap(({ name, over, under, least, most }) => {
    const [a, b] = [times.get(over), times.get(under)];
    if (a === undefined || b === undefined) return [];
    // A world that only one side solved has no ratio.
    const ratio = spread(a.flatMap((time, world) => (Number.isFinite(time) && Number.isFinite(b[world]) ? [time / b[world]] : [])));
    const aim = least !== undefined ? `>= ${least}` : most !== undefined ? `<= ${most}` : "";
    // Without a world that both solved the aim is not judged.
    const isJudged = ratio.count > 0 && aim !== "";
    const reached = isJudged ? ratio.median >= (least ?? 0) && ratio.median <= (most ?? Infinity) : undefined;
    return [{ name, ratio, aim, reached }];
  });
  return { row: name, arms, ratios };
}

/** @param {Run[]} runs */
function medianLength(runs) {
  return quantile(runs.filter((run) => run.solved).map((run) => run.length), 0.5);
}

/** @param {number[]} values */
function finite(values) {
  return values.filter(Number.isFinite);
}

/** A number with three significant digits. @param {number} value */
export function digits(value) {
  if (!Number.isFinite(value)) return "-";
  return value >= 1000 ? String(Math.round(value)) : String(Number(value.toPrecision(3)));
}

/** @param {Spread} spread */
const range = ({ low, high }) => `${digits(low)} to ${digits(high)}`;

/** @param {string[]} head @param {string[][]} body */
export function table(head, body) {
  return [head, head.map(() => "---"), ...body].map((cells) => `| ${cells.join(" | ")} |\n`).join("");
}

/** All ratios, with their aims. @param {RowFigures[]} rows */
export function ratioTable(rows) {
  const body = rows.flatMap(({ row, ratios }) => ratios.map(({ name, ratio, aim, reached }) => [
    row, name, digits(ratio.median), range(ratio), String(ratio.count), aim, reached === undefined ? "" : reached ? "reached" : "MISSED",
  ]));
  return table(["job", "time / time", "median", "quartiles", "worlds", "aim", ""], body);
}

/** All arms. @param {RowFigures[]} rows */
export function armTable(rows) {
  const body = rows.flatMap(({ row, arms }) => arms.map((arm) => [
    row, arm.arm, digits(arm.milliseconds.median), range(arm.milliseconds), digits(arm.setup), `${Math.round(100 * arm.solved)} %`,
    digits(arm.motions), arm.vertices === 0 ? "-" : digits(arm.vertices), arm.edges === 0 ? "-" : digits(arm.edges), digits(arm.length),
  ]));
  return table(["job", "who", "ms, median", "quartiles", "set-up, ms", "solved", "motions tried", "vertices", "edges", "path length"], body);
}

/** The columns of docs/benchmarks.md. @param {RowFigures[]} rows */
export function summaryTable(rows) {
  const body = rows.flatMap(({ row, arms, ratios }) => {
    const arm = (/** @type {string} */ name) => arms.find((each) => each.arm === name);
    const time = (/** @type {string} */ name) => digits(arm(name)?.milliseconds.median ?? NaN);
    const solved = (/** @type {string} */ name) => digits(Math.round(100 * (arm(name)?.solved ?? NaN)));
    const ratio = (/** @type {string} */ name) => {
      const found = ratios.find((each) => each.name === name);
      return found === undefined ? "-" : `**${digits(found.ratio.median)}** (${range(found.ratio)})`;
    };
    const kinds = arms.some(({ arm }) => arm.endsWith(", batch")) ? [", equal motions", ", batch"] : [""];
    return kinds.map((kind) => [
      row + kind, time(`native${kind}`), time(`Node${kind}`), time("OMPL, plain"), time("OMPL"), time("OxMPL"), ratio(`OMPL, plain / native${kind}`),
      ratio(`OMPL, plain / Node${kind}`), ratio(`OMPL / native${kind}`), ratio(`OMPL / Node${kind}`),
      `${solved(arm(`native${kind}`) === undefined ? `Node${kind}` : `native${kind}`)}, ${solved("OMPL")}, ${solved("OxMPL")}`,
    ]);
  });
  const ratios = ["plain / native", "plain / Node", "OMPL / native", "OMPL / Node"];
  return table(["", "native", "Node", "OMPL, plain", "OMPL", "OxMPL", ...ratios, "solved, %: ours, OMPL, OxMPL"], body);
}

/** Every aim, with the medians of its rows in order. @param {RowFigures[]} rows */
export function aimTable(rows) {
  /** @type {Map<string, RatioFigures[]>} */
  const aims = new Map();
  for (const { row, ratios } of rows) {
    for (const ratio of ratios.filter(({ aim }) => aim !== "")) {
      const name = `${row.split(",")[0]}: ${ratio.name}`;
      aims.set(name, [...(aims.get(name) ?? []), ratio]);
    }
  }
  const body = [...aims].map(([name, ratios]) => [
    name, ratios[0].aim, ratios.map(({ ratio }) => digits(ratio.median)).join(", "), `${ratios.filter(({ reached }) => reached).length} of ${ratios.length}`,
  ]);
  return table(["ratio", "aim", "medians of the rows", "rows that reach it"], body);
}
