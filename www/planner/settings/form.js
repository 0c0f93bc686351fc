/**
 * A planner's settings: its presets, its main parameters, and the others in groups. A preset sets all parameters but
 * the seed.
 */
import { make } from "../../app/dom.js";
import { namesOfDocuments } from "../../domain/option-names.js";
import { Field, withSeed } from "../../widgets/field.js";
import { Fields } from "../../widgets/options.js";

/** @import { ParameterInfo, Plan, PlannerInfo, Settings } from "../../domain/types.js" */

/** The main parameters. */
export const FIRST = new Set([
  "k",
  "k_rule",
  "samples",
  "failures",
  "batch_size",
  "step",
  "blossom",
  "goal_bias",
  "sampler",
  "seed",
]);

/** The groups of the others; parameters of no group come last. @type {[string, string[]][]} */
const GROUPS = [
  ["Samples", ["insertion", "discard", "spread", "goal_every", "free_samples"]],
  ["Controls", ["controls", "duration_steps", "shortest_steps", "near_goal_steps", "blocked", "integration"]],
  ["Tree", ["vertices", "nearest", "once", "goal_test", "selection_radius", "pruning_radius"]],
  ["Last quarter", ["late_duration_steps", "late_goal_every"]],
  ["Neighbours", ["near", "radius", "radius_factor", "neighbour_index", "neighbour_metric"]],
  ["Edges", ["extend", "metric", "steering", "edge_check", "edge_samples", "tolerance", "direct"]],
  ["Search", ["search", "cost", "heuristic"]],
  ["Path shortening", ["reduce", "shortcut", "partial_shortcut", "path_shortcuts", "blend"]],
  ["Termination", ["improve_iterations", "stop_evaluations", "stop_cost", "stop_stale", "stop_converged", "stop_when"]],
];
const REST = "Limits";

/**
 * Settings that the course reports used and that may give a wrong path: presets with one of them are offered only where
 * a lesson or a link opens them.
 * @type {Record<string, string[]>}
 */
const FAULTS = { edge_check: ["none", "sampled"], neighbour_metric: ["naive"], insertion: ["one-by-one"] };

export class SettingsForm extends Fields {
  /**
   * @param {HTMLSelectElement} planner
   * @param {HTMLElement} first   for the main parameters
   * @param {HTMLElement} rest    for the others
   * @param {(info: ParameterInfo) => boolean} fits   whether a parameter is for the robot
   * @param {() => void} onChange
   * @param {(info: PlannerInfo) => void} [onBuild]   the fields of a planner were made
   */
  constructor(planner, first, rest, fits, onChange, onBuild = () => {}) {
    super([]);
    this.planner = planner;
    this.first = first;
    this.rest = rest;
    this.fits = fits;
    this.onChange = onChange;
    this.onBuild = onBuild;
    /** The planners for the robot. @type {PlannerInfo[]} */
    this.infos = [];
    /** Settings by hand, of a preset or of a scene, stored when the planner changes. @type {Settings} */
    this.given = {};
    /** Begins the ids of the fields. */
    this.family = "parameter";
    /** Changes to the parameter of the seed. @type {Partial<ParameterInfo>} */
    this.seed = {};
    /** Parameters that the scene sets; they count as main parameters. @type {Set<string>} */
    this.lead = new Set();
    /** @type {PlannerInfo["presets"]} */
    this.presets = [];
    this.preset = make("select", {
      id: "preset",
      onchange: () => this.apply(this.presets.find(({ id }) => id === this.preset.value)?.settings ?? {}),
    });
    this.presetRow = make(
      "label",
      { className: "row", htmlFor: "preset" },
      make("span", { className: "name" }, "Settings"),
      this.preset,
    );
    planner.addEventListener("change", () => {
      this.build();
      onChange();
    });
  }

  /** Offers planners; the one selected stays so, or else the first one is. @param {PlannerInfo[]} infos */
  offer(infos) {
    const {
      planner,
      planner: { value },
    } = this;
    this.infos = infos;
    planner.replaceChildren(...infos.map(({ id, title }) => make("option", { value: id }, title)));
    planner.value = value;
    if (planner.selectedIndex < 0) planner.selectedIndex = 0;
  }

  get info() {
    return this.infos.find(({ id }) => id === this.planner.value) ?? this.infos[0];
  }

  /** The plan, or null while a field holds an invalid value. @returns {Plan | null} */
  get plan() {
    const { settings, planner } = this;
    return settings && { algorithm: planner.value, settings };
  }

  /** Applies a preset. @param {Settings} settings */
  apply(settings) {
    const { seed } = this.given;
    this.given = { ...(seed === undefined ? {} : { seed }), ...settings };
    this.build();
    this.onChange();
  }

  /** Makes the fields of the planner. */
  build() {
    const { family, info } = this;
    const option = (/** @type {string} */ value, /** @type {string} */ title) =>
      make("option", { value, disabled: value === "own" }, title);
    this.presets = info.presets
      .map((preset) => ({ ...preset, settings: namesOfDocuments(preset.settings) }))
      .filter(({ settings }) => !repeatsFault(settings) || this.equals(settings));
    this.presetRow.hidden = this.presets.length === 0;
    this.preset.replaceChildren(
      option("own", "custom"),
      option("", "defaults"),
      ...this.presets.map(({ id, title }) => option(id, title)),
    );
    this.selectPreset();
    this.fields = withSeed(info.parameters)
      .filter(this.fits)
      .map((given) => {
        const parameter = given.name === "seed" ? { ...given, ...this.seed } : given;
        const field = new Field(
          parameter,
          this.given[parameter.name] ?? parameter.default,
          () => {
            this.store(field);
            this.onChange();
          },
          family,
        );
        return field;
      });
    const isFirst = (/** @type {Field} */ { info: { name } }) => FIRST.has(name) || this.lead.has(name);
    this.first.replaceChildren(this.presetRow, ...this.fields.filter(isFirst).map(({ element }) => element));
    this.rest.replaceChildren(...groupsOf(this.fields.filter((field) => !isFirst(field))));
    this.onBuild(info);
  }

  /** Stores the value of a field. @param {Field} field */
  store({ info: { name }, value }) {
    if (value === undefined) delete this.given[name];
    else this.given[name] = value;
    this.selectPreset();
  }

  /** Selects the preset that equals the settings. */
  selectPreset() {
    const found = this.presets.find(({ settings }) => this.equals(settings));
    this.preset.value = found?.id ?? (this.equals({}) ? "" : "own");
  }

  /** Whether the settings are those of a preset, but for the seed. @param {Settings} settings */
  equals(settings) {
    const { given, info } = this;
    const defaults = new Map(info.parameters.map(({ name, default: value }) => [name, value ?? undefined]));
    return Object.keys({ ...given, ...settings }).every(
      (name) => name === "seed" || (given[name] ?? defaults.get(name)) === (settings[name] ?? defaults.get(name)),
    );
  }
}

/** @param {Settings} settings */
function repeatsFault(settings) {
  return Object.entries(FAULTS).some(([name, values]) => values.includes(String(settings[name])));
}

/** Fields under the headings of their groups. @param {Field[]} fields @returns {HTMLElement[]} */
function groupsOf(fields) {
  const grouped = new Set(GROUPS.flatMap(([, names]) => names));
  const rest = fields.map(({ info }) => info.name).filter((name) => !grouped.has(name));
  return [...GROUPS, /** @type {[string, string[]]} */ ([REST, rest])].flatMap(([title, names]) => {
    const elements = fields.filter(({ info }) => names.includes(info.name)).map(({ element }) => element);
    return elements.length > 0 ? make("div", { className: "group" }, make("h3", {}, title), ...elements) : [];
  });
}
