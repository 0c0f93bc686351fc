/**
 * Times of scan, tree and forest on more and more configurations, as a table and a chart. Measuring stops within two
 * seconds and can be continued.
 *
 * For tests: `#timing` carries `data-timing` ("none", "running", "done") and `data-seconds`.
 */
import { Chart } from "../widgets/chart.js";
import { byId, grouped, make, write } from "../app/dom.js";
import { csvFile } from "../formats/csv.js";
import { KINDS } from "./measurement.js";

/** @import { IndexInfo } from "planarium" */
/** @import { NeighbourSession } from "./session.js" */
/** @import { Kind, Measured } from "./measurement.js" */

/** Numbers of configurations: those of the course reports, and more. */
const SIZES = [100, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000];
/** Milliseconds of all measurements; the last one may take a little longer. */
const MOST = 1500;

/**
 * The columns of the table, each for some indexes.
 * @type {{ id: "query" | "build" | "visited" | "recall", kinds: readonly Kind[], text: (one: Measured) => string }[]}
 */
const COLUMNS = [
  { id: "query", kinds: KINDS, text: ({ query }) => duration(query) },
  { id: "build", kinds: KINDS, text: ({ build }) => duration(build) },
  { id: "visited", kinds: ["kd-tree", "forest"], text: ({ visited }) => grouped(Math.round(visited)) },
  { id: "recall", kinds: ["forest"], text: ({ recall }) => `${(100 * recall).toFixed(recall === 1 ? 0 : 1)} %` },
];

/** @param {NeighbourSession} session @param {IndexInfo[]} table @returns {() => Blob}  the measurements as a file */
export function watchTiming(session, table) {
  const { app, worker } = session;
  const element = byId("timing", HTMLElement);
  const button = byId("measure", HTMLButtonElement);
  const chart = new Chart("timings", "Query time, microseconds");
  byId("timing-chart", HTMLElement).append(chart.element);
  /** @type {Measured[]} */
  let measured = [];
  /** The settings that were measured. */
  let key = "";
  /** Whether it was stopped before its end. */
  let isCut = false;
  button.addEventListener("click", () => void run());
  app.onShow(explain);
  setState("none");
  return csv;

  /** @param {"none" | "running" | "done"} state */
  function setState(state) {
    element.dataset.timing = state;
    button.disabled = state === "running";
    explain();
  }

  /** The settings that would be measured. */
  function wanted() {
    return JSON.stringify([session.entry.id, session.k, session.given]);
  }

  /** Whether the measurement can be continued. */
  function isPaused() {
    return isCut && key === wanted();
  }

  function explain() {
    const { entry, k } = session;
    const { metric } = session.given;
    const what = `${entry.title.toLowerCase()}, k = ${k}${metric ? `, ${metric} metric` : ""}`;
    write(button, isPaused() ? "Measure the rest" : "Measure");
    const note = isPaused()
      ? `Paused at ${grouped(measured.at(-1)?.n ?? 0)} configurations after ${MOST / 1000} s. \u201cMeasure the rest\u201d may take several seconds.`
      : measured.length > 0 && key !== wanted()
        ? `Measured with other settings; measure again for ${what}.`
        : `Up to 100,000 configurations (${what}). Median of several batches, including the JavaScript call.`;
    app.write({ measured: note });
  }

  async function run() {
    const most = isPaused() ? Infinity : MOST;
    const isComplete = (/** @type {number} */ n) => measured.filter((one) => one.n === n).length === KINDS.length;
    measured = most === MOST ? [] : measured.filter(({ n }) => isComplete(n));
    key = wanted();
    isCut = false;
    setState("running");
    const began = performance.now();
    await app.track(worker.beginMeasurement(session.document, session.k, session.given));
    for (const n of SIZES.filter((size) => !isComplete(size))) {
      const left = most - (performance.now() - began);
      const some = (left > 0 && (await app.track(worker.measure(n, left)))) || [];
      isCut = some.length < KINDS.length;
      if (some.length === 0) break;
      measured.push(...some);
      show();
    }
    await app.track(worker.endMeasurement());
    element.dataset.seconds = ((performance.now() - began) / 1000).toFixed(3);
    setState("done");
    app.announcer.say(summary());
  }

  function show() {
    byId("timings", HTMLTableElement).tBodies[0].replaceChildren(
      ...[...new Set(measured.map(({ n }) => n))].map((n) => {
        const cells = COLUMNS.flatMap(({ id, kinds, text }) =>
          kinds.map((kind) => {
            const one = measured.find(({ index, n: other }) => index === kind && other === n);
            return make("td", { dataset: { index: kind, of: id, value: one?.[id] ?? "" } }, one ? text(one) : "\u2013");
          }),
        );
        return make("tr", { dataset: { n } }, make("th", { scope: "row" }, grouped(n)), ...cells);
      }),
    );
    byId("timing-results", HTMLElement).hidden = false;
    const lines = KINDS.map((kind) => ({
      label: kind,
      className: kind,
      points: measured
        .filter(({ index }) => index === kind)
        .map(({ n, query }) => /** @type {[number, number]} */ ([n, 1e6 * query])),
    }));
    chart.draw(lines, { title: "configurations", isLog: true }, { title: "microseconds", isLog: true }, summary());
  }

  function csv() {
    const rows = measured.map(({ n, index, build, query, visited, recall }) => [
      n,
      index,
      build,
      query,
      visited,
      recall,
    ]);
    return csvFile(["n", "index", "build_seconds", "query_seconds", "visited", "recall"], rows);
  }

  /** The largest measurement in words. */
  function summary() {
    const last = measured.at(-1)?.n ?? 0;
    const times = measured
      .filter(({ n }) => n === last)
      .map(({ index, query }) => `${table.find(({ id }) => id === index)?.title} ${duration(query)}`);
    return times.length === 0
      ? "Nothing was measured."
      : `Query time with ${grouped(last)} configurations: ${times.join(", ")}.`;
  }
}

/** @param {number} seconds */
function duration(seconds) {
  if (seconds >= 1) return `${seconds.toFixed(2)} s`;
  if (seconds >= 1e-3) return `${(1e3 * seconds).toPrecision(3)} ms`;
  const micro = 1e6 * seconds;
  return `${micro === 0 || micro >= 99.95 ? Math.round(micro) : micro.toPrecision(3)} \u00b5s`;
}
