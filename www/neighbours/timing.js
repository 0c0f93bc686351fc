/**
 * How long questions take: scan, tree and forest on ever more configurations of this robot, measured by the worker, as a table and
 * a chart. It stops within two seconds; what there was no time for is left out.
 *
 * What tests may rely on: `#timing` carries `data-timing` ("none", "running", "done") and `data-seconds`.
 */
import { grouped } from "../planner/counters.js";
import { byId, make } from "../app/dom.js";
import { Plot } from "../room/plot.js";

/** @import { IndexInfo } from "planarium" */
/** @import { Desk } from "./desk.js" */
/** @import { IndexId, Measured } from "./types.js" */

/** Those of the reports, and more. */
const SIZES = [100, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000];
/** Milliseconds that all of it may take; a measurement begun may go on a little beyond. */
const MOST = 1500;

/** @type {Record<IndexId, string>} */
const SHORT = { linear: "scan", "kd-tree": "kd-tree", forest: "forest" };

/** @type {{ id: "query" | "build" | "visited" | "recall", title: string, kinds: IndexId[], text: (one: Measured) => string }[]} */
const COLUMNS = [
  { id: "query", title: "A question", kinds: ["linear", "kd-tree", "forest"], text: ({ query }) => duration(query) },
  { id: "build", title: "Build", kinds: ["linear", "kd-tree", "forest"], text: ({ build }) => duration(build) },
  { id: "visited", title: "Visited", kinds: ["kd-tree", "forest"], text: ({ visited }) => grouped(Math.round(visited)) },
  { id: "recall", title: "Recall", kinds: ["forest"], text: ({ recall }) => `${(100 * recall).toFixed(recall === 1 ? 0 : 1)} %` },
];

export class Timing {
  /** @param {Desk} desk @param {IndexInfo[]} table */
  constructor(desk, table) {
    this.desk = desk;
    /** @type {Record<string, string>} */
    this.titles = Object.fromEntries(table.map(({ id, title }) => [id, title]));
    /** @type {Measured[]} */
    this.measured = [];
    /** What was measured: other settings are another measurement. */
    this.what = "";
    /** Was there no time for all of it? */
    this.isCut = false;
    this.element = byId("timing", HTMLElement);
    this.button = make("button", { type: "button", id: "measure", className: "primary" }, "Measure");
    this.told = make("p", { className: "hint", id: "measured" });
    this.table = make("tbody", {});
    const groups = COLUMNS.map(({ title, kinds }) => make("th", { scope: "colgroup", colSpan: kinds.length }, title));
    const kinds = COLUMNS.flatMap(({ kinds: some }) => some.map((kind) => make("th", { scope: "col" }, SHORT[kind])));
    this.scroll = make("div", { className: "scroll", tabIndex: 0, hidden: true }, make("table", { className: "standings", id: "timings" },
      make("caption", {}, "Time for a question, build time, configurations visited, and the part of the true nearest found"),
      make("thead", {}, make("tr", {}, make("th", { scope: "col", rowSpan: 2 }, "n"), ...groups), make("tr", {}, ...kinds)), this.table));
    this.scroll.setAttribute("role", "region");
    this.scroll.setAttribute("aria-label", "Timings");
    this.plot = new Plot("timings", "Time for a question, microseconds");
    this.plot.element.hidden = true;
    this.element.append(make("div", { className: "row" }, this.told, this.button), make("div", { className: "charts" }, this.plot.element), this.scroll);
    this.button.addEventListener("click", () => void this.run());
    this.desk.onChange((change) => { if (change !== "answer" && change !== "list") this.tell(); });
    this.put("none");
  }

  /** @param {"none" | "running" | "done"} state */
  put(state) {
    this.element.dataset.timing = state;
    this.button.disabled = state === "running";
    this.tell();
  }

  get key() { return JSON.stringify([this.desk.entry.id, this.desk.k, this.desk.given]); }

  /** What is measured, or was. */
  tell() {
    const { desk } = this;
    const { metric } = desk.given;
    const what = `${desk.entry.title.toLowerCase()}, k = ${desk.k}${metric ? `, ${metric} metric` : ""}`;
    const goesOn = this.isCut && this.what === this.key;
    this.button.textContent = goesOn ? "Measure the rest" : "Measure";
    const last = this.measured.at(-1)?.n ?? 0;
    if (goesOn) this.told.textContent = `Stopped after ${MOST / 1000} s, at ${grouped(last)} configurations: this machine is slow, or has other things to do. The rest takes as long as it takes.`;
    else this.told.textContent = this.measured.length > 0 && this.what !== this.key
      ? `What stands here was measured with other settings; measure again for ${what}.`
      : `Up to 100,000 configurations drawn for this: ${what}. Each time is the middle of several batches, the call from JavaScript included.`;
  }

  async run() {
    const { desk } = this;
    const { room, asker } = desk;
    const most = this.isCut && this.what === this.key ? Infinity : MOST;
    const kinds = Object.keys(SHORT).length;
    const isWhole = (/** @type {number} */ n) => this.measured.filter((one) => one.n === n).length === kinds;
    this.measured = most === MOST ? [] : this.measured.filter(({ n }) => isWhole(n));
    this.what = this.key;
    this.isCut = false;
    this.put("running");
    const began = performance.now();
    await room.await(asker.ask("begin", desk.document, desk.k, desk.given));
    for (const n of SIZES.filter((size) => !isWhole(size))) {
      const left = most - (performance.now() - began);
      const some = left > 0 ? await room.await(asker.ask("measure", n, left)) : null;
      this.isCut = !some || some.length < kinds;
      if (!some || some.length === 0) break;
      this.measured.push(...some);
      this.show();
    }
    await room.await(asker.ask("end"));
    this.element.dataset.seconds = ((performance.now() - began) / 1000).toFixed(3);
    this.put("done");
    room.announcer.say(this.summary);
  }

  show() {
    const sizes = [...new Set(this.measured.map(({ n }) => n))];
    this.table.replaceChildren(...sizes.map((n) => {
      const cells = COLUMNS.flatMap(({ id, kinds, text }) => kinds.map((kind) => {
        const one = this.measured.find(({ index, n: other }) => index === kind && other === n);
        const cell = make("td", {}, one ? text(one) : "\u2013");
        Object.assign(cell.dataset, { index: kind, of: id, value: one ? String(one[id]) : "" });
        return cell;
      }));
      const row = make("tr", {}, make("th", { scope: "row" }, grouped(n)), ...cells);
      row.dataset.n = String(n);
      return row;
    }));
    this.scroll.hidden = false;
    this.plot.element.hidden = false;
    const ids = [...new Set(this.measured.map(({ index }) => index))];
    this.plot.draw(ids.map((id) => ({
      label: id, className: id, points: this.measured.filter(({ index }) => index === id).map(({ n, query }) => /** @type {[number, number]} */ ([n, 1e6 * query])),
    })), { title: "configurations", isLog: true }, { title: "microseconds", isLog: true }, this.summary);
  }

  /** The largest measurement in words. */
  get summary() {
    const last = this.measured.at(-1)?.n;
    const words = this.measured.filter(({ n }) => n === last).map(({ index, query }) => `${this.titles[index]} ${duration(query)}`);
    return words.length === 0 ? "Nothing was measured." : `Time for a question among ${grouped(last ?? 0)}: ${words.join(", ")}.`;
  }
}

/** @param {number} seconds */
function duration(seconds) {
  if (seconds >= 1) return `${seconds.toFixed(2)} s`;
  if (seconds >= 1e-3) return `${(1e3 * seconds).toPrecision(3)} ms`;
  const micro = 1e6 * seconds;
  return `${micro === 0 || micro >= 99.95 ? Math.round(micro) : micro.toPrecision(3)} \u00b5s`;
}
