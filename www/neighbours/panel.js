/**
 * The settings: how the list is sampled, the target and the query. Options of the indexes are built from the core's
 * table.
 */
import { byId, make } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { tuple } from "../widgets/format.js";
import { Options } from "../widgets/options.js";
import { Slider, slidersOf } from "../widgets/slider.js";

/** @import { IndexId, IndexInfo } from "planarium" */
/** @import { NeighbourSession, Weights } from "./session.js" */

/** Weights of a metre and a radian in the course reports. @type {Weights[]} */
const PAIRS = [
  [0.7, 0.3],
  [0.7, 0.15],
];

/** @param {NeighbourSession} session @param {IndexInfo[]} table */
export function showPanel(session, table) {
  const { n, seed } = session.sampling;
  const counts = new Slider(
    { name: "count", title: "Count", min: 1, max: 100_000, kind: "integer", isLog: true },
    n,
    (count) => void session.sample({ n: count }),
  );
  const seeds = new Slider(
    { name: "seed", title: "Seed", min: 0, max: 999, kind: "integer" },
    seed,
    (value) => void session.sample({ seed: value }),
  );
  const free = byId("free", HTMLInputElement);
  free.addEventListener("change", () => void session.sample({ free: free.checked }));
  byId("list-settings", HTMLElement).prepend(counts.element, seeds.element);
  const preset = byId("preset", HTMLSelectElement);
  preset.addEventListener("change", () => {
    const [q, k] = session.entry.presets[Number(preset.value)];
    if (preset.value !== "") session.setQuery({ q: session.fitted(q), k });
  });
  /** @type {Slider[]} */
  let target = [];
  const neighbours = new Slider({ name: "k", title: "k", min: 1, max: 500, kind: "integer" }, session.k, (k) =>
    session.setQuery({ k }),
  );
  byId("query-settings", HTMLElement).prepend(neighbours.element);
  const weights = /** @type {const} */ (["metre", "radian"]).map(
    (unit, i) =>
      new Slider({ name: unit, title: unit, min: 0.01, max: 1, step: 0.01 }, 1, (value) => {
        weigh(/** @type {Weights} */ (session.weights.with(i, value)));
      }),
  );
  byId("weights", HTMLElement).append(...weights.map(({ element }) => element));
  const pairs = byId("pairs", HTMLSelectElement);
  pairs.append(
    make("option", { value: "" }, "\u2013"),
    ...PAIRS.map((pair) => make("option", { value: pair.join() }, pair.join(" and "))),
  );
  pairs.addEventListener("change", () => {
    if (pairs.value) weigh(/** @type {Weights} */ (pairs.value.split(",").map(Number)));
  });
  const asking = byId("ask", HTMLInputElement);
  asking.addEventListener("change", () => session.setQuery({ isAsking: asking.checked }));
  const index = byId("index", HTMLSelectElement);
  index.append(...table.map(({ id, title }) => make("option", { value: id }, title)));
  index.addEventListener("change", () => session.setQuery({ index: /** @type {IndexId} */ (index.value) }));
  const differs = comparer();
  session.app.onShow(show);

  /** @param {Weights} pair */
  function weigh(pair) {
    session.app.guard(() => void session.weigh(pair));
  }

  /** The options of the index; only an arm has a choice of metrics. */
  function showOptions() {
    const info = table.find(({ id }) => id === session.index) ?? table[0];
    session.app.write({ "index-summary": info.summary });
    const options = new Options(
      byId("index-settings", HTMLElement),
      info.parameters.filter(({ name }) => name !== "metric" || session.isArm),
      session.given,
      () => {
        // The options of other indexes stay for later.
        if (options.settings) session.setQuery({ given: { ...session.given, ...options.settings } });
      },
    );
  }

  function showRobot() {
    const { coordinates } = session;
    preset.replaceChildren(
      make("option", { value: "" }, "\u2013"),
      ...session.entry.presets.map(([at, count], i) =>
        make("option", { value: String(i) }, `${tuple(at)}, k = ${count}`),
      ),
    );
    target = slidersOf("q", coordinates, session.q, (i, value) => session.setCoordinate(i, value));
    byId("target", HTMLElement).replaceChildren(...target.map(({ element }) => element));
  }

  function show() {
    const { coordinates, sampling, q, k, isAsking } = session;
    const { presets } = session.entry;
    if (differs("robot", coordinates)) showRobot();
    if (differs("options", session.index, coordinates)) showOptions();
    counts.show(sampling.n);
    seeds.show(sampling.seed);
    free.checked = sampling.free;
    target.forEach((slider, i) => slider.show(q[i]));
    neighbours.show(k);
    asking.checked = isAsking;
    byId("weights", HTMLElement).hidden = !session.isPlaced;
    weights.forEach((slider, i) => {
      const value = session.weights[i];
      slider.setLimits(Math.min(0.01, value), Math.max(1, value));
      slider.show(value);
    });
    pairs.value = session.weights.join();
    if (pairs.selectedIndex < 0) pairs.value = "";
    index.value = session.index;
    const chosen = presets.findIndex(
      ([at, count]) => count === k && session.scenario.distance(session.fitted(at), q) < 1e-9,
    );
    preset.value = chosen < 0 ? "" : String(chosen);
  }
}
