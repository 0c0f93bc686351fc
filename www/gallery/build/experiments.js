/**
 * Entries of Experiments: a document and its view. The picture shows the first trials of each setting: the page runs
 * them all.
 */
import { Experiment } from "planarium/full";
import { View as Frame } from "planarium/draw";
import { SERIES } from "../../app/palette.js";
import { plannerTitle } from "../../experiments/factors.js";
import { encodeExperiment } from "../../experiments/link.js";
import { SOLVED, isShare, measureInfo, scaleOf, titled } from "../../experiments/measures.js";
import { drawLine, setStroke } from "../../draw/marks.js";
import { drawDots } from "./sheet.js";

/** @import { ExperimentDocument, ExperimentSeeds, TrialRow } from "planarium/full" */
/** @import { Brush } from "../../draw/figure.js" */
/** @import { View } from "../../experiments/link.js" */
/** @import { Entry } from "../format.js" */
/** @import { Documents, Opened } from "./open.js" */

/** @typedef {Extract<Entry, { page: "experiments" }>} ExperimentEntry */
/**
 * A group of trials: the value across, the others in words, and the measured values of those with a path.
 * @typedef {{ x: string, series: string, values: number[], n: number }} Group
 */

/** Trials of a picture, about, and most seeds of a setting; a share needs more of both. */
const FEW = { trials: 24, seeds: 5 };
const MANY = { trials: 240, seeds: 25 };
const PANE = { width: 600, height: 300 };
const MARGIN = { left: 20, right: 20, top: 46, bottom: 52 };
/** Width of a letter, about, pixels. */
const LETTER = 7;

/** The rows of a document, by its text: several entries may show one. @type {Map<string, TrialRow[]>} */
const known = new Map();

/** @param {ExperimentEntry} entry @param {Documents} documents @returns {Promise<Opened>} */
export async function openExperiment({ state: { document: name, worlds: kept, view = {} } }, documents) {
  const whole = documents.experiment(name);
  const document = {
    ...whole,
    worlds: whole.worlds.filter(
      (world) =>
        !kept || ("scenario" in world && typeof world.scenario === "object" && kept.includes(world.scenario.name)),
    ),
  };
  const measured = measureOf(view, document);
  const most = isShare(measured) ? MANY : FEW;
  const key = JSON.stringify([document, most]);
  const rows = known.get(key) ?? firstRows(/** @type {ExperimentDocument} */ (document), most);
  known.set(key, rows);
  const draw = (/** @type {Brush} */ brush) =>
    view.chart === "ecdf"
      ? drawShares(brush, rows, view.work ?? "iterations")
      : drawGroups(brush, groupsOf(rows, view, measured), measured, view);
  return { address: `experiments.html#${await encodeExperiment({ document, view })}`, panes: [draw], pane: PANE };
}

/** @param {NonNullable<ExperimentEntry["state"]["view"]>} view @param {{ measures?: string[] }} document */
function measureOf({ chart, measure }, { measures = [] }) {
  if (chart === "success") return measure && isShare(measure) ? measure : SOLVED;
  return measure ?? measures[0] ?? "length";
}

/**
 * Runs the first trials of every setting.
 * @param {ExperimentDocument} document
 * @param {typeof FEW} most
 * @returns {TrialRow[]}
 */
function firstRows(document, most) {
  const all = Experiment.parse(document);
  const seeds = countOf(document.seeds);
  const kept = Math.max(1, Math.min(most.seeds, Math.floor((most.trials * seeds) / all.trialCount)));
  all.free();
  const worlds = document.worlds.map((world) =>
    "seeds" in world && world.seeds ? { ...world, seeds: first(world.seeds, most.seeds) } : world,
  );
  const experiment = Experiment.parse({ ...document, worlds, seeds: first(document.seeds, kept) });
  const rows = Array.from({ length: experiment.trialCount }, (_, i) => {
    const trial = experiment.trial(i);
    while (trial.stepFor(1000));
    const row = { ...trial.row(), build_seconds: trial.buildSeconds, search_seconds: trial.searchSeconds };
    trial.free();
    return row;
  });
  experiment.free();
  return rows;
}

/** @param {ExperimentSeeds} seeds */
function countOf(seeds) {
  return Array.isArray(seeds) ? seeds.length : seeds.count;
}

/** @param {ExperimentSeeds} seeds @param {number} count @returns {ExperimentSeeds} */
function first(seeds, count) {
  return Array.isArray(seeds) ? seeds.slice(0, count) : { ...seeds, count: Math.min(count, seeds.count) };
}

/** The value that a row has of a measure; NaN without a path. @param {TrialRow} row @param {string} measure */
function valueOf(row, measure) {
  if (measure === SOLVED) return row.status === "solved" ? 100 : 0;
  return row.status === "solved" ? Number(row[measure] ?? NaN) * scaleOf(measure) : NaN;
}

/** A value of a column in words. @param {string} column @param {unknown} value */
function wordOf(column, value) {
  return column === "planner" ? plannerTitle({ algorithm: String(value) }) : String(value);
}

/** The columns of planners in which rows differ. @param {TrialRow[]} rows */
function settingsOf(rows) {
  return Object.keys(rows[0]).filter(
    (column) => /^planner(\.|$)/.test(column) && new Set(rows.map((row) => row[column])).size > 1,
  );
}

/**
 * Rows by the value of the axis and the others in words, of a heat map those of the second axis.
 * @param {TrialRow[]} rows
 * @param {View} view
 * @param {string} measure
 * @returns {Group[]}
 */
function groupsOf(rows, { chart, axis = "planner", second }, measure) {
  const others = chart === "heat" && second ? [second] : settingsOf(rows).filter((column) => column !== axis);
  /** @type {Map<string, Group>} */
  const groups = new Map();
  for (const row of rows) {
    const [x, series] = [
      (row[axis] ?? null) === null ? "" : wordOf(axis, row[axis]),
      others
        .filter((column) => row[column] !== null)
        .map((column) => wordOf(column, row[column]))
        .join(", "),
    ];
    const group = groups.get(`${x}|${series}`) ?? { x, series, values: [], n: 0 };
    groups.set(`${x}|${series}`, group);
    group.n++;
    const value = valueOf(row, measure);
    if (!Number.isNaN(value)) group.values.push(value);
  }
  return [...groups.values()];
}

/**
 * Dots and the mean of each group; numbers of the report as crosses.
 * @param {Brush} brush
 * @param {Group[]} groups
 * @param {string} measure
 * @param {View} shown
 */
function drawGroups(brush, groups, measure, { axis = "planner", reported = [], isLog = false }) {
  const { context, palette } = brush;
  const [places, series] = [[...new Set(groups.map(({ x }) => x))], [...new Set(groups.map((group) => group.series))]];
  const values = [...groups.flatMap((group) => group.values), ...reported.map(({ value = 0 }) => value)];
  const isOfTrials = isShare(measure);
  const range = /** @type {[number, number]} */ (
    isOfTrials ? [0, 100] : isLog ? decadesOf(values) : [0, Math.max(...values, 0) || 1]
  );
  const { title } = measureInfo(measure, "");
  const view = frameOf(brush, range, isLog, isOfTrials ? `${title}, %` : titled(measureInfo(measure, "")), series);
  const slot = 1 / places.length;
  context.fillStyle = palette.quiet;
  // Names that begin alike are cut, so that they fit.
  const cut = places.some((place) => place.length * LETTER > slot * view.scaleX)
    ? (/** @type {RegExpExecArray} */ (/^(.*[-_ ])?.*\n(?:\1.*(?:\n|$))*$/.exec(`${places.join("\n")}\n`))[1]?.length ??
      0)
    : 0;
  places.forEach((place, i) =>
    linesOf(place.slice(cut), slot * view.scaleX).forEach((text, row) =>
      context.fillText(text, view.x((i + 0.5) * slot), view.floor + 8 + 14 * row),
    ),
  );
  for (const { x, series: name, values: all } of groups) {
    const colour = palette[SERIES[series.indexOf(name) % SERIES.length]];
    const at = view.x(slot * (places.indexOf(x) + (series.indexOf(name) + 1) / (series.length + 1)));
    if (!isOfTrials)
      drawDots(
        context,
        all.map((value) => [at, view.y(value)]),
        colour,
        5,
        0.5,
      );
    if (all.length === 0) continue;
    const mean = view.y(all.reduce((sum, value) => sum + value, 0) / all.length);
    setStroke(context, colour, isOfTrials ? 4 : 2.4);
    const half = Math.min(14, (0.4 * slot * view.scaleX) / series.length);
    drawLine(context, at - half, mean, at + half, mean);
  }
  setStroke(context, palette.ink, 1.4);
  for (const { x, value = NaN } of reported) {
    const [px, py] = [view.x(slot * (places.indexOf(wordOf(axis, x)) + 0.06)), view.y(value)];
    for (const side of [-1, 1]) drawLine(context, px - 4, py - 4 * side, px + 4, py + 4 * side);
  }
}

/** A text in lines of about a width at most. @param {string} text @param {number} width  pixels */
function linesOf(text, width) {
  return text.split(" ").reduce((/** @type {string[]} */ lines, word) => {
    const longer = lines.length > 0 ? `${lines[lines.length - 1]} ${word}` : "";
    return longer && longer.length * LETTER <= width ? [...lines.slice(0, -1), longer] : [...lines, word];
  }, []);
}

/**
 * The share of trials solved, by work, for each planner.
 * @param {Brush} brush
 * @param {TrialRow[]} rows
 * @param {string} work
 */
function drawShares(brush, rows, work) {
  const { context, palette } = brush;
  const settings = settingsOf(rows);
  /** @type {Map<string, number[]>} */
  const all = new Map();
  for (const row of rows) {
    const name = settings.map((column) => wordOf(column, row[column])).join(", ");
    all.set(name, [...(all.get(name) ?? []), valueOf(row, work)]);
  }
  const most = Math.max(...rows.map((row) => valueOf(row, work)).filter((value) => !Number.isNaN(value)), 1);
  const view = frameOf(brush, [0, 100], false, `solved, %, after ${work.replaceAll("_", " ")}`, [...all.keys()]);
  [...all.values()].forEach((values, i) => {
    setStroke(context, palette[SERIES[i % SERIES.length]], 2);
    context.beginPath();
    context.lineTo(view.x(0), view.y(0));
    const solved = values.filter((value) => !Number.isNaN(value)).sort((a, b) => a - b);
    solved.forEach((value, k) => {
      context.lineTo(view.x(value / most), view.y((100 * k) / values.length));
      context.lineTo(view.x(value / most), view.y((100 * (k + 1)) / values.length));
    });
    context.lineTo(view.x(1), view.y((100 * solved.length) / values.length));
    context.stroke();
  });
  context.fillStyle = palette.quiet;
  context.fillText(String(most), view.x(1), view.y(0) + 8);
}

/** The powers of ten around some values. @param {number[]} values @returns {[number, number]} */
function decadesOf(values) {
  const some = values.filter((value) => value > 0).map(Math.log10);
  return some.length === 0 ? [1, 10] : [10 ** Math.floor(Math.min(...some)), 10 ** Math.ceil(Math.max(...some))];
}

/**
 * A frame from 0 to 1 across and over a range up, with a title and the names of series.
 * @param {Brush} brush
 * @param {[number, number]} range
 * @param {boolean} isLog
 * @param {string} title
 * @param {string[]} series
 * @returns {{ x: (value: number) => number, y: (value: number) => number, scaleX: number, floor: number }}  `floor`:
 *   the place of the least value
 */
function frameOf({ context, palette, width, height }, [least, most], isLog, title, series) {
  const frame = new Frame({ min: [0, 0], max: [1, 1.08] }, width, height, MARGIN, true);
  const up = (/** @type {number} */ value) =>
    isLog ? Math.log10(value / least) / Math.log10(most / least) : (value - least) / (most - least);
  const view = {
    x: (/** @type {number} */ value) => frame.x(value),
    y: (/** @type {number} */ value) => frame.y(up(value)),
    scaleX: frame.scaleX,
    floor: frame.y(0),
  };
  setStroke(context, palette.line, 1);
  for (const part of [0, 0.5, 1]) drawLine(context, view.x(0), frame.y(part), view.x(1), frame.y(part));
  context.fillStyle = palette.quiet;
  context.font = "13px system-ui, sans-serif";
  context.textAlign = "left";
  context.textBaseline = "bottom";
  context.fillText(String(Number(most.toPrecision(3))), view.x(0), frame.y(1) - 2);
  if (isLog) context.fillText(String(Number(least.toPrecision(3))), view.x(0), view.floor - 2);
  context.fillStyle = palette.ink;
  let at = view.x(0);
  for (const [i, text] of [title, ...series].entries()) {
    if (i > 0) context.fillStyle = palette[SERIES[(i - 1) % SERIES.length]];
    if (at + LETTER * text.length < width) context.fillText(text, at, 26);
    at += LETTER * text.length + 14;
  }
  context.textAlign = "center";
  context.textBaseline = "top";
  return view;
}
