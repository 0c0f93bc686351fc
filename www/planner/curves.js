/**
 * Charts of the number of vertices and the path length against iterations, or in a race against clearance evaluations. They have few
 * points, so that a long run costs no more than a short one.
 */
import { letter } from "./race/standings.js";
import { thinned } from "./run-log/curve.js";
import { Chart } from "../widgets/chart.js";
import { numberText as words } from "../widgets/format.js";
import { byId, make } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { labelled } from "../widgets/elements.js";

/** @import { Page } from "./page.js" */
/** @import { Line } from "../widgets/chart.js" */

/** Milliseconds between two drawings. */
const PAUSE = 250;
/** Rows of the table, about. */
const ROWS = 10;
/** Numbers in a row: time, vertices, cost. */
const WIDTH = 3;

/** @param {Page} page */
export function watchCurves(page) {
  const fold = byId("curves-fold", HTMLDetailsElement);
  const vertices = new Chart("vertices", "Vertices", { isTimeline: true });
  const cost = new Chart("cost", "Path length", { isTimeline: true });
  const charts = [vertices, cost];
  const table = make("table", { className: "standings" });
  const scroll = labelled("region", "Curves as a table", make("div", { className: "scroll", tabIndex: 0 }, table));
  const numbers = make("details", {}, make("summary", {}, "As a table"), scroll);
  byId("curves", HTMLElement).append(make("div", { className: "charts" }, vertices.element, cost.element), numbers);

  /** Identifies the drawn curves. */
  let drawn = "";
  const isDue = pacer(PAUSE);

  page.onState(() => update());
  fold.addEventListener("toggle", () => update());
  numbers.addEventListener("toggle", () => draw());

  /** Draws the curves if they have changed, at rest or after a pause. */
  function update() {
    const { state, session: { plannings, clock, lanes } } = page;
    if (!fold.open || !state) return;
    for (const chart of charts) chart.show(state.clock.now);
    const key = `${plannings} ${clock.head} ${lanes.map(({ run }) => run?.ended)}`;
    if (key === drawn || !isDue(state.settled)) return;
    drawn = key;
    draw();
  }

  function draw() {
    const { state, names, session } = page;
    if (!fold.open || !state) return;
    const { head, isRace, column: clock } = session.clock;
    const lanes = thinned(session.lanes.flatMap(({ run }) => run ?? []), clock, head);
    // While the runs of other planners begin.
    if (lanes.length > 0 && lanes.length !== names.length) return;
    const time = isRace ? "clearance evaluations" : "iterations";
    const unit = state.lanes[0].unit;
    const [grown, costs] = [1, 2].map((which) => lanes.map((rows, i) => ({ label: isRace ? letter(i) : "", points: column(rows, which) })));
    cost.title.textContent = unit ? `Path length, ${unit}` : "Path cost";
    const across = { title: time, low: 0, high: Math.max(1, head) };
    vertices.draw(grown, across, { title: "vertices", low: 0 }, `Vertices against ${time}, up to ${words(head)}. ${summaryOf(grown, names, time)}`);
    cost.draw(costs, across, { title: "path length" }, `Length of the best path against ${time}, up to ${words(head)}. ${summaryOf(costs, names, time)}`);
    for (const chart of charts) chart.show(state.clock.now);
    if (numbers.open) list(grown, costs, names, time);
  }

  /** The same as a table, at some times, with those of all first paths. @param {Line[]} grown @param {Line[]} costs @param {string[]} names @param {string} time */
  function list(grown, costs, names, time) {
    const all = [...new Set(grown.flatMap(({ points }) => points.map(([at]) => at)))].sort((a, b) => a - b);
    const each = Math.max(1, Math.ceil(all.length / ROWS));
    const firsts = new Set(costs.flatMap(({ points }) => points.slice(0, 1).map(([at]) => at)));
    const times = all.filter((at, i) => i % each === 0 || i === all.length - 1 || firsts.has(at));
    const heads = names.flatMap((name) => [`${name}: vertices`, `${name}: path length`]);
    table.replaceChildren(
      make("caption", {}, "Vertices and path length"),
      make("thead", {}, make("tr", {}, ...[time, ...heads].map((title) => make("th", { scope: "col" }, title)))),
      make("tbody", {}, ...times.map((at) => make("tr", {}, make("th", { scope: "row" }, words(at)),
        ...grown.flatMap((line, i) => [make("td", {}, valueAt(line, at)), make("td", {}, valueAt(costs[i], at))])))),
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

/** @param {Line} line @param {number} at */
function valueAt({ points }, at) {
  const point = points.findLast(([time]) => time <= at);
  return point ? words(point[1]) : "\u2013";
}

/** The curves in words. @param {Line[]} lines @param {string[]} names @param {string} time */
function summaryOf(lines, names, time) {
  return lines.map(({ points }, i) => {
    if (points.length === 0) return `${names[i]}: none yet.`;
    const [first, last] = [points[0], points[points.length - 1]];
    return `${names[i]}: ${words(first[1])} at ${words(first[0])} ${time}, ${words(last[1])} at ${words(last[0])}.`;
  }).join(" ");
}
