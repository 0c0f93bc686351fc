/** Figures from runs: medians over the runs in each world, then medians and quartiles over worlds. */
import { comparisons, lines } from "./arms.mjs";

/** @typedef {import("./worlds.mjs").Row} Row */
/** @typedef {import("./sides.mjs").Run} Run */
/**
 * @typedef {{ median: number, low: number, high: number, count: number }} Spread  the median and quartiles of `count`
 *   values
 */
/**
 * @typedef {{ arm: string, milliseconds: Spread, setup: number, solved: number, motions: number, vertices: number,
 *   edges: number, length: number }} ArmFigures
 */
/** @typedef {{ name: string, value: Spread }} Figure  mostly a ratio of the times of two arms */
/** @typedef {{ row: string, arms: ArmFigures[], figures: Figure[] }} RowFigures */

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
  return {
    median: quantile(values, 0.5),
    low: quantile(values, 0.25),
    high: quantile(values, 0.75),
    count: values.length,
  };
}

/**
 * The median of the seconds that the runs in a world took after the set-up. A query that was given up counts as
 * infinite, so that unsolved queries make no world look fast. A roadmap is built whether or not it is solved.
 * @param {Row["planner"]} planner
 * @param {Run[]} runs
 */
export function seconds(planner, runs) {
  return quantile(
    runs.map((run) => (planner === "prm" || run.solved ? run.build + run.search : Infinity)),
    0.5,
  );
}

/**
 * The figures of one row.
 * @param {Row} row
 * @param {Map<string, Run[][]>} results  of each arm, for each world, its runs
 * @returns {RowFigures}
 */
export function figures(row, results) {
  const { name, planner } = row;
  const times = new Map([...results].map(([arm, worlds]) => [arm, worlds.map((runs) => seconds(planner, runs))]));
  const lengths = new Map([...results].map(([arm, worlds]) => [arm, worlds.map(medianLength)]));
  const count = [...lengths.values()][0].length;
  // Lengths are compared in worlds that all sides solved; otherwise a side that solves more has the harder worlds.
  const shared = Array.from({ length: count }, (_, world) => world).filter((world) =>
    [...lengths.values()].every((each) => Number.isFinite(each[world])),
  );
  const arms = [...results].map(([arm, worlds]) => {
    const runs = worlds.flat();
    const median = (/** @type {(run: Run) => number} */ of) => quantile(runs.map(of), 0.5);
    return {
      arm,
      milliseconds: spread(finite(times.get(arm) ?? []).map((time) => time * 1e3)),
      setup: median((run) => run.setup * 1e3),
      solved: runs.filter((run) => run.solved).length / runs.length,
      motions: median((run) => run.motions),
      vertices: median((run) => run.vertices),
      edges: median((run) => run.edges),
      length: quantile(
        shared.map((world) => lengths.get(arm)?.[world] ?? NaN),
        0.5,
      ),
    };
  });
  const ratios = comparisons(row).flatMap(([over, under]) => {
    const [a, b] = [times.get(over), times.get(under)];
    if (a === undefined || b === undefined) return [];
    // A world that only one side solved has no ratio.
    const value = spread(
      a.flatMap((time, world) => (Number.isFinite(time) && Number.isFinite(b[world]) ? [time / b[world]] : [])),
    );
    return [{ name: `${over} / ${under}`, value }];
  });
  return { row: name, arms, figures: ratios };
}

/** @param {Run[]} runs */
function medianLength(runs) {
  return quantile(
    runs.filter((run) => run.solved).map((run) => run.length),
    0.5,
  );
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

/** All figures of some rows. @param {RowFigures[]} rows */
export function figureTable(rows) {
  const body = rows.flatMap(({ row, figures }) =>
    figures.map(({ name, value }) => [
      row,
      name,
      digits(value.median),
      value.count > 1 ? range(value) : "",
      String(value.count),
    ]),
  );
  return table(["job", "figure, time / time if not named otherwise", "median", "quartiles", "of"], body);
}

/** All arms. @param {RowFigures[]} rows */
export function armTable(rows) {
  const body = rows.flatMap(({ row, arms }) =>
    arms.map((arm) => [
      row,
      arm.arm,
      digits(arm.milliseconds.median),
      range(arm.milliseconds),
      digits(arm.setup),
      `${Math.round(100 * arm.solved)} %`,
      digits(arm.motions),
      arm.vertices === 0 ? "-" : digits(arm.vertices),
      arm.edges === 0 ? "-" : digits(arm.edges),
      digits(arm.length),
    ]),
  );
  return table(
    [
      "job",
      "who",
      "ms, median",
      "quartiles",
      "set-up, ms",
      "solved",
      "motions tried",
      "vertices",
      "edges",
      "path length",
    ],
    body,
  );
}

/** The columns of docs/benchmarks.md. @param {Row[]} rows @param {RowFigures[]} measured  in the same order */
export function summaryTable(rows, measured) {
  const body = measured.flatMap(({ row, arms, figures }, i) => {
    const arm = (/** @type {string} */ name) => arms.find((each) => each.arm === name);
    const time = (/** @type {string} */ name) => digits(arm(name)?.milliseconds.median ?? NaN);
    const solved = (/** @type {string} */ name) => digits(Math.round(100 * (arm(name)?.solved ?? NaN)));
    const ratio = (/** @type {string} */ name) => {
      const found = figures.find((each) => each.name === name);
      return found === undefined ? "-" : `**${digits(found.value.median)}** (${range(found.value)})`;
    };
    return lines(rows[i]).map(({ title, ours, peer }) => [
      row + title,
      time(`native${ours}`),
      time(`Node${ours}`),
      peer === "" ? time("OMPL, plain") : "-",
      time(`OMPL${peer}`),
      time("OxMPL"),
      ...(peer === "" ? [ratio(`OMPL, plain / native${ours}`), ratio(`OMPL, plain / Node${ours}`)] : ["-", "-"]),
      ratio(`OMPL${peer} / native${ours}`),
      ratio(`OMPL${peer} / Node${ours}`),
      `${solved(arm(`native${ours}`) === undefined ? `Node${ours}` : `native${ours}`)}, ${solved(`OMPL${peer}`)}, ${solved("OxMPL")}`,
    ]);
  });
  const ratios = ["plain / native", "plain / Node", "OMPL / native", "OMPL / Node"];
  return table(["", "native", "Node", "OMPL, plain", "OMPL", "OxMPL", ...ratios, "solved, %: ours, OMPL, OxMPL"], body);
}
