/** The settings: how the list is sampled, the target and the query. Options of the indexes are built from the core's table. */
import { byId, make } from "../app/dom.js";
import { tuple } from "../widgets/format.js";
import { Options } from "../widgets/options.js";
import { Slider } from "../widgets/slider.js";

/** @import { IndexInfo } from "planarium" */
/** @import { NeighbourSession, Change } from "./session.js" */
/** @import { IndexId } from "./types.js" */

export class Panel {
  /** @param {NeighbourSession} session @param {IndexInfo[]} table */
  constructor(session, table) {
    const { sampling } = session;
    this.session = session;
    this.table = table;
    this.count = new Slider({ name: "count", title: "Count", min: 100, max: 100_000, kind: "integer", isLog: true }, sampling.n, (n) => void session.sample({ n }));
    this.seed = new Slider({ name: "seed", title: "Seed", min: 0, max: 999, kind: "integer" }, sampling.seed, (seed) => void session.sample({ seed }));
    this.free = byId("free", HTMLInputElement);
    this.free.addEventListener("change", () => void session.sample({ free: this.free.checked }));
    byId("list-settings", HTMLElement).prepend(this.count.element, this.seed.element);
    this.preset = byId("preset", HTMLSelectElement);
    this.preset.addEventListener("change", () => {
      const preset = session.entry.presets[Number(this.preset.value)];
      if (this.preset.value !== "") session.setQuery({ q: session.fitted(preset.q), k: preset.k });
    });
    /** @type {Slider[]} */
    this.sliders = [];
    this.k = new Slider({ name: "k", title: "k", min: 1, max: 500, kind: "integer" }, session.k, (k) => session.setQuery({ k }));
    byId("query-settings", HTMLElement).prepend(this.k.element);
    this.index = byId("index", HTMLSelectElement);
    this.index.append(...table.map(({ id, title }) => make("option", { value: id }, title)));
    this.index.addEventListener("change", () => {
      session.setQuery({ index: /** @type {IndexId} */ (this.index.value) });
      this.buildOptions();
    });
    session.onChange((change) => this.show(change));
  }

  /** The options of the index; only an arm has a choice of metrics. */
  buildOptions() {
    const { session, table } = this;
    const info = table.find(({ id }) => id === session.index) ?? table[0];
    session.app.write({ "index-summary": info.summary });
    const options = new Options(byId("index-settings", HTMLElement), info.parameters.filter(({ name }) => name !== "metric" || session.isArm), session.given, () => {
      // The options of other indexes stay for later.
      if (options.settings) session.setQuery({ given: { ...session.given, ...options.settings } });
    });
  }

  /** @param {Change} change */
  show(change) {
    const { session } = this;
    const { entry: { presets }, coordinates, sampling, q, k, index } = session;
    if (change === "result") return;
    if (change === "robot") {
      this.preset.replaceChildren(make("option", { value: "" }, "\u2013"), ...presets.map((preset, i) => make("option", { value: String(i) }, `${tuple(preset.q)}, k = ${preset.k}`)));
      this.sliders = coordinates.map(({ name, low, high, unit }, i) => new Slider({ name: `q${i}`, title: name, unit, min: low, max: high }, q[i], (value) => session.setCoordinate(i, value)));
      byId("target", HTMLElement).replaceChildren(...this.sliders.map(({ element }) => element));
      this.buildOptions();
    }
    this.count.show(sampling.n);
    this.seed.show(sampling.seed);
    this.free.checked = sampling.free;
    this.sliders.forEach((slider, i) => slider.show(q[i]));
    this.k.show(k);
    this.index.value = index;
    const preset = presets.findIndex((one) => one.k === k && session.scenario.distance(session.fitted(one.q), q) < 1e-9);
    this.preset.value = preset < 0 ? "" : String(preset);
  }
}
