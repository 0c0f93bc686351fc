/**
 * A planner's settings: its presets, its main parameters, and the others in groups. A preset sets all parameters but
 * the seed.
 */
import { make } from "../../app/dom.js";
import { namesOfDocuments } from "../../domain/option-names.js";
import { Field, withSeed } from "../../widgets/field.js";
import { Fields } from "../../widgets/options.js";
import { fits } from "./planners.js";
import { row } from "../../widgets/elements.js";

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
  ["Obstacles", ["clearance_weight", "clearance_within"]],
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
   * @param {(lane: Plan) => void} onChange   the planner and the settings given to it, after a valid change
   * @param {(info: PlannerInfo) => void} [onBuild]   the fields of a planner were made
   */
  constructor(planner, first, rest, onChange, onBuild = () => {}) {
    super([]);
    this.planner = planner;
    this.first = first;
    this.rest = rest;
    this.onChange = onChange;
    this.onBuild = onBuild;
    /** The planners for the robot. @type {PlannerInfo[]} */
    this.infos = [];
    /** The lane that is shown; its settings may be for another planner, and are kept for that. @type {Plan} */
    this.lane = { algorithm: "", settings: {} };
    /** Begins the ids of the fields. */
    this.family = "parameter";
    /** Changes to the parameter of the seed. @type {Partial<ParameterInfo>} */
    this.seed = {};
    /** Parameters that the scene sets; they count as main parameters. */
    this.lead = "";
    /** @type {PlannerInfo["presets"]} */
    this.presets = [];
    this.preset = make("select", { id: "preset", onchange: () => this.apply() });
    this.presetRow = row("Settings", this.preset);
    planner.addEventListener("change", () => onChange({ ...this.lane, algorithm: planner.value }));
  }

  /**
   * Shows a lane. Fields are made for another planner, robot or scene, and else set where their value is another one.
   * @param {Plan} lane
   * @param {PlannerInfo[]} infos   the planners for the robot
   * @param {string} robot
   * @param {Settings} [scene]   the settings of the scene itself
   */
  show(lane, infos, robot, scene) {
    const lead = scene ? Object.keys(scene).join(" ") : this.lead;
    const isOther = lane.algorithm !== this.lane.algorithm || infos !== this.infos || lead !== this.lead;
    if (infos !== this.infos)
      this.planner.replaceChildren(...infos.map(({ id, title }) => make("option", { value: id }, title)));
    Object.assign(this, { lane, infos, lead });
    this.planner.value = lane.algorithm;
    if (isOther) this.build(robot);
    for (const field of this.fields) {
      const value = this.wanted(field);
      // What was typed and is invalid stays as long as its value does.
      if (field.current !== value) field.set(value ?? "");
      field.validate();
    }
    this.selectPreset();
  }

  get info() {
    return this.infos.find(({ id }) => id === this.lane.algorithm) ?? this.infos[0];
  }

  /** The value of a field in the lane; undefined for automatic. @param {Field} field */
  wanted({ info: { name, default: usual } }) {
    return this.lane.settings[name] ?? usual ?? undefined;
  }

  /** Reports the values of the fields; an invalid one leaves its parameter as it was. */
  report() {
    const settings = { ...this.lane.settings };
    for (const field of this.fields.filter((one) => one.validate())) {
      const { value, info } = field;
      if (value === undefined) delete settings[info.name];
      else if (value !== this.wanted(field)) settings[info.name] = value;
    }
    this.onChange({ ...this.lane, settings });
  }

  /** Reports the settings of the chosen preset, and the seed. */
  apply() {
    const { seed } = this.lane.settings;
    const preset = this.presets.find(({ id }) => id === this.preset.value);
    this.onChange({ ...this.lane, settings: { ...(seed === undefined ? {} : { seed }), ...preset?.settings } });
  }

  /** Makes the fields of the planner. @param {string} robot */
  build(robot) {
    const { family, info } = this;
    this.fields = withSeed(info.parameters)
      .filter((given) => fits(given, robot))
      .map((given) => {
        const parameter = given.name === "seed" ? { ...given, ...this.seed } : given;
        const value = this.lane.settings[parameter.name] ?? parameter.default;
        return new Field(parameter, value, () => this.report(), family);
      });
    const isFirst = (/** @type {Field} */ { info: { name } }) => FIRST.has(name) || this.leads(name);
    this.first.replaceChildren(this.presetRow, ...this.fields.filter(isFirst).map(({ element }) => element));
    this.rest.replaceChildren(...groupsOf(this.fields.filter((field) => !isFirst(field))));
    this.onBuild(info);
  }

  /** Whether the scene sets a parameter. @param {string} name */
  leads(name) {
    return this.lead.split(" ").includes(name);
  }

  /** Offers the presets, and selects the one that equals the settings. */
  selectPreset() {
    const all = this.info.presets.map((preset) => ({ ...preset, settings: namesOfDocuments(preset.settings) }));
    const presets = all.filter(({ settings }) => !repeatsFault(settings) || this.equals(settings));
    const option = (/** @type {string} */ value, /** @type {string} */ title) =>
      make("option", { value, disabled: value === "own" }, title);
    this.preset.replaceChildren(
      option("own", "custom"),
      option("", "defaults"),
      ...presets.map(({ id, title }) => option(id, title)),
    );
    this.presets = presets;
    this.presetRow.hidden = presets.length === 0;
    this.preset.value = presets.find(({ settings }) => this.equals(settings))?.id ?? (this.equals({}) ? "" : "own");
  }

  /** Whether the settings are those of a preset, but for the seed. @param {Settings} settings */
  equals(settings) {
    const { info } = this;
    const { settings: given } = this.lane;
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
