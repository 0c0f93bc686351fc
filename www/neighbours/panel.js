/** The settings: where the list comes from, the target, the question. What the indexes take is built from the core's own table. */
import { byId, make } from "../app/dom.js";
import { Options } from "../room/options.js";
import { Slider } from "../room/slider.js";
import { Count } from "./count.js";

/** @import { IndexInfo } from "planarium" */
/** @import { Desk, Change } from "./desk.js" */
/** @import { IndexId, Settings } from "./types.js" */

/** The most neighbours that are asked for. */
const MOST = 500;

export class Panel {
  /** @param {Desk} desk @param {IndexInfo[]} table */
  constructor(desk, table) {
    this.desk = desk;
    this.table = table;
    const { draw } = desk;
    this.count = new Count({ name: "count", title: "Count", min: 100, max: 100_000 }, draw.n, (n) => void desk.fill({ n }));
    this.seed = new Slider({ name: "seed", title: "Seed", unit: "", min: 0, max: 999, kind: "integer" }, draw.seed, (seed) => void desk.fill({ seed }));
    this.free = make("input", { type: "checkbox", id: "free", checked: draw.free });
    this.free.setAttribute("role", "switch");
    this.free.addEventListener("change", () => void desk.fill({ free: this.free.checked }));
    byId("list-settings", HTMLElement).append(this.count.element, this.seed.element,
      make("label", { className: "row", htmlFor: "free" }, make("span", { className: "name" }, "Only free ones"), this.free));
    this.preset = make("select", { id: "preset", ariaLabel: "Preset" });
    this.preset.addEventListener("change", () => {
      const preset = desk.entry.presets[Number(this.preset.value)];
      if (preset && this.preset.value !== "") {
        desk.place(preset.q);
        desk.question({ k: preset.k });
      }
    });
    this.targets = byId("target", HTMLElement);
    /** @type {Slider[]} */
    this.sliders = [];
    this.k = new Slider({ name: "k", title: "k", unit: "", min: 1, max: MOST, kind: "integer" }, desk.k, (k) => desk.question({ k }));
    this.index = make("select", { id: "index" }, ...table.map(({ id, title }) => make("option", { value: id }, title)));
    this.index.addEventListener("change", () => {
      desk.question({ index: /** @type {IndexId} */ (this.index.value) });
      this.build();
    });
    this.summary = make("p", { className: "hint", id: "index-summary" });
    this.host = make("div", { id: "index-settings" });
    /** @type {Options | null} */
    this.options = null;
    byId("question", HTMLElement).append(this.k.element,
      make("label", { className: "row", htmlFor: "index" }, make("span", { className: "name" }, "Index"), this.index), this.summary, this.host);
    desk.onChange((change) => this.show(change));
  }

  /** The parameters of the index, as far as they are for the robot. */
  build() {
    const { desk } = this;
    const info = this.table.find(({ id }) => id === desk.index);
    if (!info) return;
    this.summary.textContent = info.summary;
    // Of a disc the metric is always the same one.
    const own = info.parameters.filter(({ name }) => name !== "metric" || desk.isArm);
    this.options = new Options(this.host, own, desk.given, () => {
      const given = this.options?.settings;
      // What another index takes is kept for when it comes back.
      if (given) desk.question({ given: { ...this.others(own.map(({ name }) => name)), ...given } });
    });
  }

  /** What is set and is not for this index. @param {string[]} names @returns {Settings} */
  others(names) { return Object.fromEntries(Object.entries(this.desk.given).filter(([name]) => !names.includes(name))); }

  /** @param {Change} change */
  show(change) {
    const { desk } = this;
    if (change === "robot") {
      const values = (/** @type {number[]} */ q) => q.map((value) => String(value).replace("-", "\u2212")).join(", ");
      this.preset.replaceChildren(make("option", { value: "" }, "\u2013"), ...desk.entry.presets.map(({ q, k }, i) => make("option", { value: String(i) }, `(${values(q)}), k = ${k}`)));
      this.sliders = desk.coordinates.map(({ name, low, high, unit }, i) => new Slider({ name: `q${i}`, title: name, unit, min: low, max: high }, desk.q[i], (value) => desk.turn(i, value)));
      this.targets.replaceChildren(make("label", { className: "row", htmlFor: "preset" }, make("span", { className: "name" }, "Preset"), this.preset), ...this.sliders.map(({ element }) => element));
      this.build();
    }
    if (change === "list" && typeof desk.source !== "string") {
      this.count.show(desk.source.n);
      this.seed.show(desk.source.seed);
      this.free.checked = desk.source.free;
    }
    if (change === "answer") return;
    this.sliders.forEach((slider, i) => slider.show(desk.q[i]));
    this.k.show(desk.k);
    this.index.value = desk.index;
    const at = desk.entry.presets.findIndex(({ q, k }) => k === desk.k && q.every((value, i) => Math.abs(turned(value - desk.q[i], desk.coordinates[i].isCircle)) < 1e-9));
    this.preset.value = at < 0 ? "" : String(at);
  }
}

/** A difference, of angles the short way round. @param {number} difference @param {boolean} isCircle */
function turned(difference, isCircle) { return isCircle ? difference - 2 * Math.PI * Math.round(difference / (2 * Math.PI)) : difference; }
