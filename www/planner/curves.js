/**
 * Charts of the number of vertices and the path length against iterations, or in a race against clearance evaluations,
 * and of the gap to the shortest path where that is known. They have few points, so that a long run costs no more than
 * a short one.
 */
import { gapOf } from "./optimum.js";
import { letter } from "./race/standings.js";
import { thinned } from "./run-log/curve.js";
import { Chart } from "../widgets/chart.js";
import { numberText as words } from "../widgets/format.js";
import { byId, make } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { labelled, tableHead } from "../widgets/elements.js";

/** @import { Page } from "./page.js" */
/** @import { Line } from "../widgets/chart.js" */

/** Milliseconds between two drawings. */
const PAUSE = 250;
/** Rows of the table, about. */
const ROWS = 10;
/** Numbers in a row: time, vertices, cost. */
const WIDTH = 3;
/** The least gap on a logarithmic axis, in percent: smaller ones are drawn there. */
const LEAST = 0.01;

/** @param {Page} page */
export function watchCurves(page) {
  const fold = byId("curves-fold", HTMLDetailsElement);
  const vertices = new Chart("vertices", "Vertices", { isTimeline: true });
  const cost = new Chart("cost", "Path length", { isTimeline: true });
  const gap = new Chart("gap", "Gap to the shortest path", { isTimeline: true });
  const charts = [vertices, cost, gap];
  const table = make("table", { className: "standings" });
  const scroll = labelled("region", "Curves as a table", make("div", { className: "scroll", tabIndex: 0 }, table));
  const numbers = make("details", {}, make("summary", {}, "As a table"), scroll);
  byId("curves", HTMLElement).append(
    make("div", { className: "charts" }, vertices.element, cost.element, gap.element),
    numbers,
  );

  /** Identifies the drawn curves. */
  let drawn = "";
  const isDue = pacer(PAUSE);
  page.session.optima.viewers.push(() => fold.open);

  page.onState(() => update());
  fold.addEventListener("toggle", () => update());
  numbers.addEventListener("toggle", () => draw());

  /** Draws the curves if they have changed, at rest or after a pause. */
  function update() {
    const { state } = page;
    const { plannings, clock, lanes } = page.session;
    if (!fold.open || !state) return;
    for (const chart of charts) chart.show(state.clock.now);
    const key = `${plannings} ${clock.head} ${lanes.map(({ run, optimum }) => [run?.ended, optimum?.length])}`;
    if (key === drawn || !isDue(state.settled)) return;
    drawn = key;
    draw();
  }

  function draw() {
    const { state, names, session } = page;
    if (!fold.open || !state) return;
    const { head, isRace, column: clock } = session.clock;
    const runs = session.lanes.flatMap(({ run }) => run ?? []);
    const lanes = thinned(runs, clock, head);
    // While the runs of other planners begin.
    if (lanes.length > 0 && lanes.length !== names.length) return;
    const time = isRace ? "clearance evaluations" : "iterations";
    const unit = state.lanes[0].unit;
    const label = (/** @type {number} */ i) => (isRace ? letter(i) : "");
    const [grown, costs] = [1, 2].map((which) =>
      lanes.map((rows, i) => ({ label: label(i), points: column(rows, which) })),
    );
    // A path that keeps away from obstacles is not compared with the shortest.
    const keepsAway = session.lanes.some((lane) => lane.keepsAway);
    const optima = session.lanes.map(({ optimum }) => (keepsAway ? null : optimum));
    const [optimum] = optima;
    const isExact = optima.every((one) => one?.isExact !== false);
    const gapsOf = (/** @type {typeof lanes} */ all) =>
      all.map((rows, i) => ({
        label: label(i),
        points: column(rows, 2).flatMap(([at, length]) => pairOf(at, gapOf(length, optima[i]))),
      }));
    const gaps = gapsOf(thinned(runs, clock, head, true));
    const measure = keepsAway ? "cost" : "length";
    cost.title.textContent = unit ? `Path ${measure}, ${unit}` : "Path cost";
    const across = { title: time, low: 0, high: Math.max(1, head) };
    vertices.draw(
      grown,
      across,
      { title: "vertices", low: 0 },
      `Vertices against ${time}, up to ${words(head)}. ${summaryOf(grown, names, time)}`,
    );
    /** @type {Line[]} */
    const truth =
      optimum && optima.every((one) => one?.length === optimum.length)
        ? [
            {
              label: isExact ? "shortest" : "reference",
              points: [
                [0, optimum.length],
                [across.high, optimum.length],
              ],
              isLevel: true,
              className: "optimum",
            },
          ]
        : [];
    cost.draw(
      [...costs, ...truth],
      across,
      { title: `path ${measure}` },
      `The ${measure} of the best path against ${time}, up to ${words(head)}. ${summaryOf(costs, names, time)}${truth.length > 0 ? ` The ${isExact ? "shortest path" : "reference"} has length ${words(truth[0].points[0][1])}.` : ""}`,
    );
    gap.element.hidden = optima.every((one) => !one);
    gap.title.textContent = `Gap to the ${isExact ? "shortest path" : "reference"}, %`;
    const drawn = gaps.map(({ label, points }) => ({
      label,
      points: points.map(([at, percent]) => /** @type {[number, number]} */ ([at, Math.max(LEAST, percent)])),
    }));
    if (!gap.element.hidden)
      gap.draw(
        drawn,
        { title: time, isLog: true, low: Math.max(1, head), high: Math.max(2, head) },
        { title: "gap", isLog: true },
        `Gap of the best path in percent against ${time}, both logarithmic. ${summaryOf(gaps, names, time)}`,
      );
    for (const chart of charts) chart.show(state.clock.now);
    if (numbers.open)
      list(
        [
          ["vertices", grown],
          [`path ${measure}`, costs],
          ...(gap.element.hidden ? [] : [/** @type {[string, Line[]]} */ (["gap, %", gapsOf(lanes)])]),
        ],
        names,
        time,
      );
  }

  /**
   * The same as a table, at some times, with those of all first paths.
   * @param {[string, Line[]][]} curves
   * @param {string[]} names
   * @param {string} time
   */
  function list(curves, names, time) {
    const [[, grown], [, costs]] = curves;
    const all = [...new Set(grown.flatMap(({ points }) => points.map(([at]) => at)))].sort((a, b) => a - b);
    const each = Math.max(1, Math.ceil(all.length / ROWS));
    const firsts = new Set(costs.flatMap(({ points }) => points.slice(0, 1).map(([at]) => at)));
    const times = all.filter((at, i) => i % each === 0 || i === all.length - 1 || firsts.has(at));
    const heads = names.flatMap((name) => curves.map(([title]) => `${name}: ${title}`));
    table.replaceChildren(
      make("caption", {}, "Vertices and path length"),
      tableHead([time, ...heads]),
      make(
        "tbody",
        {},
        ...times.map((at) =>
          make(
            "tr",
            {},
            make("th", { scope: "row" }, words(at)),
            ...names.flatMap((_, i) => curves.map(([, lines]) => make("td", {}, valueAt(lines[i], at)))),
          ),
        ),
      ),
    );
  }
}

/** @param {Float64Array} rows @param {number} which @returns {[number, number][]} */
function column(rows, which) {
  /** @type {[number, number][]} */
  const points = [];
  for (let i = 0; i < rows.length; i += WIDTH) if (rows[i + which] < Infinity) points.push([rows[i], rows[i + which]]);
  return points;
}

/** A point, if its value is known. @param {number} at @param {number | null} value @returns {[number, number][]} */
function pairOf(at, value) {
  return value === null ? [] : [[at, value]];
}

/** @param {Line} line @param {number} at */
function valueAt({ points }, at) {
  const point = points.findLast(([time]) => time <= at);
  return point ? words(point[1]) : "\u2013";
}

/** The curves in words. @param {Line[]} lines @param {string[]} names @param {string} time */
function summaryOf(lines, names, time) {
  return lines
    .map(({ points }, i) => {
      if (points.length === 0) return `${names[i]}: none yet.`;
      const [first, last] = [points[0], points[points.length - 1]];
      return `${names[i]}: ${words(first[1])} at ${words(first[0])} ${time}, ${words(last[1])} at ${words(last[0])}.`;
    })
    .join(" ");
}
