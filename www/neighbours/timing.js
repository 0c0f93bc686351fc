/**
 * Times of scan, tree and forest on more and more configurations, as a table and a chart. Measuring stops within two seconds and
 * can be continued.
 *
 * For tests: `#timing` carries `data-timing` ("none", "running", "done") and `data-seconds`.
 */
import { Chart } from "../widgets/chart.js";
import { byId, grouped, make } from "../app/dom.js";
import { csvFile } from "../formats/csv.js";

/** @import { IndexInfo } from "planarium" */
/** @import { NeighbourSession } from "./session.js" */
/** @import { IndexId, Measured } from "./types.js" */

/** Numbers of configurations: those of the course reports, and more. */
const SIZES = [100, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000];
/** Milliseconds of all measurements; the last one may take a little longer. */
const MOST = 1500;

/** @type {IndexId[]} */
const KINDS = ["linear", "kd-tree", "forest"];

/** The columns of the table, each for some indexes. @type {{ id: "query" | "build" | "visited" | "recall", kinds: IndexId[], text: (one: Measured) => string }[]} */
const COLUMNS = [
  { id: "query", kinds: KINDS, text: ({ query }) => duration(query) },
  { id: "build", kinds: KINDS, text: ({ build }) => duration(build) },
  { id: "visited", kinds: ["kd-tree", "forest"], text: ({ visited }) => grouped(Math.round(visited)) },
  { id: "recall", kinds: ["forest"], text: ({ recall }) => `${(100 * recall).toFixed(recall === 1 ? 0 : 1)} %` },
];

export class Timing {
  /** @param {NeighbourSession} session @param {IndexInfo[]} table */
  constructor(session, table) {
    this.session = session;
    this.table = table;
    /** @type {Measured[]} */
    this.measured = [];
    /** The settings that were measured. */
    this.key = "";
    /** Whether it was stopped before its end. */
    this.isCut = false;
    this.element = byId("timing", HTMLElement);
    this.button = byId("measure", HTMLButtonElement);
    this.button.addEventListener("click", () => void this.run());
    this.chart = new Chart("timings", "Query time, microseconds");
    byId("timing-chart", HTMLElement).append(this.chart.element);
    session.onChange((change) => { if (change === "robot" || change === "query") this.explain(); });
    this.setState("none");
  }

  /** @param {"none" | "running" | "done"} state */
  setState(state) {
    this.element.dataset.timing = state;
    this.button.disabled = state === "running";
    this.explain();
  }

  /** The settings that would be measured. */
  get wanted() { return JSON.stringify([this.session.entry.id, this.session.k, this.session.given]); }

  /** Whether the measurement can be continued. */
  get isPaused() { return this.isCut && this.key === this.wanted; }

  explain() {
    const { session: { entry, given: { metric }, k }, isPaused, measured } = this;
    const what = `${entry.title.toLowerCase()}, k = ${k}${metric ? `, ${metric} metric` : ""}`;
    this.button.textContent = isPaused ? "Measure the rest" : "Measure";
    const note = isPaused ? `Paused at ${grouped(measured.at(-1)?.n ?? 0)} configurations after ${MOST / 1000} s. \u201cMeasure the rest\u201d may take several seconds.`
      : measured.length > 0 && this.key !== this.wanted ? `Measured with other settings; measure again for ${what}.`
        : `Up to 100,000 configurations (${what}). Median of several batches, including the JavaScript call.`;
    this.session.app.write({ measured: note });
  }

  async run() {
    const { session: { app, worker, document, k, given } } = this;
    const most = this.isPaused ? Infinity : MOST;
    const isComplete = (/** @type {number} */ n) => this.measured.filter((one) => one.n === n).length === KINDS.length;
    this.measured = most === MOST ? [] : this.measured.filter(({ n }) => isComplete(n));
    this.key = this.wanted;
    this.isCut = false;
    this.setState("running");
    const began = performance.now();
    await app.track(worker.beginMeasurement(document, k, given));
    for (const n of SIZES.filter((size) => !isComplete(size))) {
      const left = most - (performance.now() - began);
      const some = (left > 0 && await app.track(worker.measure(n, left))) || [];
      this.isCut = some.length < KINDS.length;
      if (some.length === 0) break;
      this.measured.push(...some);
      this.show();
    }
    await app.track(worker.endMeasurement());
    this.element.dataset.seconds = ((performance.now() - began) / 1000).toFixed(3);
    this.setState("done");
    app.announcer.say(this.summary);
  }

  show() {
    const { measured } = this;
    byId("timings", HTMLTableElement).tBodies[0].replaceChildren(...[...new Set(measured.map(({ n }) => n))].map((n) => {
      const row = make("tr", {}, make("th", { scope: "row" }, grouped(n)), ...COLUMNS.flatMap(({ id, kinds, text }) => kinds.map((kind) => {
        const one = measured.find(({ index, n: other }) => index === kind && other === n);
        const cell = make("td", {}, one ? text(one) : "\u2013");
        Object.assign(cell.dataset, { index: kind, of: id, value: one?.[id] ?? "" });
        return cell;
      })));
      row.dataset.n = String(n);
      return row;
    }));
    byId("timing-results", HTMLElement).hidden = false;
    const lines = KINDS.map((kind) => ({
      label: kind, className: kind, points: measured.filter(({ index }) => index === kind).map(({ n, query }) => /** @type {[number, number]} */ ([n, 1e6 * query])),
    }));
    this.chart.draw(lines, { title: "configurations", isLog: true }, { title: "microseconds", isLog: true }, this.summary);
  }

  /** The largest measurement in words. */
  get summary() {
    const { measured, table } = this;
    const last = measured.at(-1)?.n ?? 0;
    const times = measured.filter(({ n }) => n === last).map(({ index, query }) => `${table.find(({ id }) => id === index)?.title} ${duration(query)}`);
    return times.length === 0 ? "Nothing was measured." : `Query time with ${grouped(last)} configurations: ${times.join(", ")}.`;
  }

  csv() {
    const rows = this.measured.map(({ n, index, build, query, visited, recall }) => [n, index, build, query, visited, recall]);
    return csvFile(["n", "index", "build_seconds", "query_seconds", "visited", "recall"], rows);
  }
}

/** @param {number} seconds */
function duration(seconds) {
  if (seconds >= 1) return `${seconds.toFixed(2)} s`;
  if (seconds >= 1e-3) return `${(1e3 * seconds).toPrecision(3)} ms`;
  const micro = 1e6 * seconds;
  return `${micro === 0 || micro >= 99.95 ? Math.round(micro) : micro.toPrecision(3)} \u00b5s`;
}
