/** The aims of the benchmark, which were set beforehand, and how figures are judged by them. */
import { digits, table } from "./report.mjs";

/** @typedef {import("./report.mjs").RowFigures} RowFigures */
/** @typedef {"stretch" | "reached" | "MISSED"} Verdict */

/**
 * @typedef {object} Aim  a bound on the median of a figure, in every row that has it
 * @property {string} name
 * @property {RegExp} rows  the names of its rows
 * @property {string} figure  the name of the figure in those rows
 * @property {number} [least]  the bound: the figure is at least this,
 * @property {number} [most]  or at most this
 * @property {number} [stretch]  a higher aim
 */

const ROADMAPS = /^k-PRM, forest/;
const ARM_TREES = /^RRT-Connect, .*\dR/;
const BODIES = /^RRT-Connect, body/;

/** @type {Aim[]} */
export const aims = [
  {
    name: "k-PRM, equal motions, native",
    rows: ROADMAPS,
    figure: "OMPL, plain / native, equal motions",
    least: 7,
    stretch: 11,
  },
  {
    name: "k-PRM, equal motions, Node",
    rows: ROADMAPS,
    figure: "OMPL, plain / Node, equal motions",
    least: 5,
    stretch: 8,
  },
  { name: "k-PRM, batch, native", rows: ROADMAPS, figure: "OMPL, plain / native, batch", least: 12, stretch: 20 },
  { name: "k-PRM, batch, Node", rows: ROADMAPS, figure: "OMPL, plain / Node, batch", least: 9, stretch: 14 },
  { name: "RRT-Connect, arms, native", rows: ARM_TREES, figure: "OMPL, plain / native", least: 6, stretch: 9 },
  { name: "RRT-Connect, arms, Node", rows: ARM_TREES, figure: "OMPL, plain / Node", least: 4, stretch: 6 },
  { name: "RRT-Connect, bodies, native", rows: BODIES, figure: "OMPL, plain / native", least: 5, stretch: 8 },
  { name: "RRT-Connect, bodies, Node", rows: BODIES, figure: "OMPL, plain / Node", least: 3, stretch: 5 },
  { name: "RRT by controls, native", rows: /^Kinodynamic RRT/, figure: "OMPL, plain / native", least: 10 },
  { name: "RRT by controls, Node", rows: /^Kinodynamic RRT/, figure: "OMPL, plain / Node", least: 6 },
  { name: "SST, native", rows: /^SST/, figure: "OMPL, plain / native", least: 15 },
  { name: "SST, Node", rows: /^SST/, figure: "OMPL, plain / Node", least: 9 },
  { name: "Node over native, k-PRM, batch", rows: ROADMAPS, figure: "Node, batch / native, batch", most: 1.5 },
  {
    name: "20 samples on an edge over a proof, native",
    rows: ROADMAPS,
    figure: "native, batch, sampled / native, batch",
    least: 5,
  },
  {
    name: "20 samples on an edge over a proof, Node",
    rows: ROADMAPS,
    figure: "Node, batch, sampled / Node, batch",
    least: 4,
  },
  { name: "one thread over two, k-PRM, batch", rows: /^Two threads/, figure: "one thread / two threads", least: 1.7 },
  { name: "first roadmap of a new process, ms", rows: /^First roadmap/, figure: "Node, ms after loading", most: 50 },
  { name: "first answer, Node over native", rows: /^First answer/, figure: "Node / native", most: 2 },
  {
    name: "default planner on city maps, Node, ms",
    rows: /^Map/,
    figure: "planarium, the default planner, Node, ms",
    most: 2,
  },
  {
    name: "default planner on city maps, % longer than the shortest path",
    rows: /^Map/,
    figure: "planarium, the default planner, % longer than the shortest path",
    most: 1,
  },
  { name: "BIT* on city maps, Node, ms", rows: /^Map/, figure: "planarium, bit-star, Node, ms", most: 8 },
  ...["disc", "rigid_body"].map((robot) => ({
    name: `first path on city maps, native, ${robot}`,
    rows: /^First path on a map/,
    figure: `OMPL on cells / native, ${robot}`,
    least: 3,
  })),
  ...["box", "torus"].map((space) => ({
    name: `nearest in a ${space} of three dimensions, time over kiddo's`,
    rows: /^Neighbours/,
    figure: `kd-tree / kiddo, query, ${space}, 3 dimensions`,
    most: 1,
  })),
  { name: "200 discs in an open hall, native, ms", rows: /^A plan for 200/, figure: "native, ms", most: 5000 },
  {
    name: "100 discs on a map of 32 x 32 squares, % planned",
    rows: /^A plan for 100/,
    figure: "plans found, %",
    least: 100,
  },
  {
    name: "shortest path of a point, native, time over polyanya's",
    rows: /^Shortest paths/,
    figure: "native / polyanya, median query",
    most: 3,
  },
  {
    name: "200 discs, the longest iteration, Node, ms",
    rows: /^A plan for 200/,
    figure: "Node, ms of the longest iteration",
    most: 16,
  },
  {
    name: "memory in Node with edges and events, bytes per vertex",
    rows: /^Memory/,
    figure: "Node, bytes per vertex, with its edges and events",
    most: 200,
  },
  { name: "graph and index, bytes per vertex", rows: /^Graph and index/, figure: "native, bytes per vertex", most: 64 },
];

/**
 * Each aim with the rows that have its figure; a figure without a value, since no world was solved by both sides, is
 * left out.
 * @param {RowFigures[]} rows
 */
export function judge(rows) {
  return aims.map((aim) => ({
    aim: aim.name,
    bound: boundOf(aim),
    results: rows
      .filter(({ row }) => aim.rows.test(row))
      .flatMap(({ row, figures }) =>
        figures
          .filter(({ name, value }) => name === aim.figure && value.count > 0)
          .map(({ value }) => ({ row, value: value.median, verdict: verdictOf(aim, value.median) })),
      ),
  }));
}

/** @param {Aim} aim @param {number} value @returns {Verdict} */
function verdictOf({ least = -Infinity, most = Infinity, stretch = Infinity }, value) {
  if (value < least || value > most) return "MISSED";
  return value >= stretch ? "stretch" : "reached";
}

/** @param {Aim} aim */
function boundOf({ least, most, stretch }) {
  return `${least !== undefined ? `>= ${least}` : `<= ${most}`}${stretch === undefined ? "" : ` (${stretch})`}`;
}

/** The aims in Markdown: the medians of their rows, and how many are missed. @param {RowFigures[]} rows */
export function aimTable(rows) {
  const judged = judge(rows);
  const body = judged.map(({ aim, bound, results }) => [
    aim,
    bound,
    results
      .map(({ row, value }) => (results.length > 1 ? `${placeOf(row)}: ${digits(value)}` : digits(value)))
      .join("; "),
    overall(results),
  ]);
  const all = judged.flatMap(({ results }) => results);
  const count = (/** @type {Verdict} */ verdict) => all.filter((result) => result.verdict === verdict).length;
  return (
    `${table(["aim", "bound (stretch)", "reached", "verdict"], body)}\n` +
    `Of ${all.length} figures with an aim, ${count("MISSED")} miss it and ${count("stretch")} reach the stretch aim.\n`
  );
}

/** The verdict on all rows of an aim. @param {ReturnType<typeof judge>[number]["results"]} results */
function overall(results) {
  if (results.length === 0) return "not measured";
  const missed = results.filter(({ verdict }) => verdict === "MISSED").map(({ row }) => placeOf(row));
  if (missed.length > 0) return missed.length === results.length ? "**MISSED**" : `**MISSED**: ${missed.join("; ")}`;
  return results.every(({ verdict }) => verdict === "stretch") ? "stretch" : "reached";
}

/** The world of a row, without its planner. @param {string} row */
export const placeOf = (row) => row.slice(row.indexOf(",") + 1).trim();
