/**
 * The settings: which planner, its parameters, the seed, the query. Built from the planners' own tables, so a planner
 * that the core learns appears here by itself.
 */
import { byId, make } from "../../app/dom.js";
import { Field, withSeed } from "../../widgets/field.js";
import { Presets } from "./presets.js";

/** @import { Plan, PlannerInfo, Settings } from "../../domain/types.js" */

/** Parameters worth a place of their own; the others stand under "More parameters". */
export const FIRST = new Set(["k", "k_rule", "samples", "failures", "step", "blossom", "goal_bias", "sampler", "seed"]);

/** How the others are grouped, in this order; what no group names comes last. @type {[string, string[]][]} */
const GROUPS = [
  ["Samples", ["insertion", "discard", "spread", "goal_every"]],
  ["Controls", ["controls", "duration_steps", "shortest_steps", "near_goal_steps", "blocked", "integration"]],
  ["Tree", ["nearest", "once", "goal_test", "selection_radius", "pruning_radius", "improve_iterations"]],
  ["Last quarter", ["late_duration_steps", "late_goal_every"]],
  ["Edges", ["radius", "extend", "metric", "steering", "edge_check", "edge_samples", "tolerance"]],
  ["Search", ["search", "cost", "heuristic"]],
  ["Path shortening", ["reduce", "shortcut", "partial_shortcut"]],
];
const REST = "Limits";

export class Panel {
  /**
   * @param {PlannerInfo[]} planners
   * @param {() => number} randomSeed
   * @param {() => void} onChange   a setting that makes a new run was changed
   * @param {() => void} onQuery    another query was chosen
   */
  constructor(planners, randomSeed, onChange, onQuery) {
    this.randomSeed = randomSeed;
    this.onChange = onChange;
    this.infos = planners;
    this.planner = byId("planner", HTMLSelectElement);
    this.summary = byId("planner-summary", HTMLElement);
    this.first = byId("parameters", HTMLElement);
    this.rest = byId("more-parameters", HTMLElement);
    this.more = byId("more", HTMLDetailsElement);
    this.queryRow = byId("query-row", HTMLElement);
    this.query = byId("query", HTMLSelectElement);
    /** @type {Field[]} */
    this.fields = [];
    /** What was given by hand or by a scene, by name: kept when the planner changes. @type {Settings} */
    this.given = {};
    /** Names of what the scene sets by itself. @type {Set<string>} */
    this.lead = new Set();
    /** The robot on the stage: planners and parameters that are not for it are not offered. */
    this.robot = "arm";
    this.presets = new Presets((settings) => {
      const { seed } = this.given;
      this.given = { ...(seed === undefined ? {} : { seed }), ...settings };
      this.build();
      onChange();
    }).identify("preset");
    this.planner.addEventListener("change", () => {
      this.build();
      onChange();
    });
    this.query.addEventListener("change", onQuery);
    this.planner.disabled = false;
    this.offer();
  }

  /** Is a planner or a parameter for the robot on the stage? @param {object} info */
  fits(info) {
    const { robots } = /** @type {{ robots?: readonly string[] | null }} */ (info);
    return !robots?.length || robots.includes(this.robot);
  }

  /** Does a planner serve the robot on the stage? @param {string} algorithm */
  serves(algorithm) { return this.infos.some((info) => info.id === algorithm && this.fits(info)); }

  /** Offers what is for a robot. @param {string} [robot] */
  offer(robot = this.robot) {
    const { planner } = this;
    const before = planner.value;
    this.robot = robot;
    planner.replaceChildren(...this.infos.filter((info) => this.fits(info)).map(({ id, title }) => make("option", { value: id }, title)));
    planner.value = before;
    if (planner.selectedIndex < 0) planner.selectedIndex = 0;
    this.build();
  }

  /** A planner and some of its parameters, the rest at their defaults. @param {string} algorithm @param {Settings} settings @param {Settings} [scene]  what the scene itself sets */
  suggest(algorithm, settings, scene = {}) {
    this.planner.value = algorithm;
    this.given = { ...settings };
    this.lead = new Set(Object.keys(scene));
    this.build();
  }

  /** @param {string} algorithm */
  titleOf(algorithm) { return this.infos.find(({ id }) => id === algorithm)?.title ?? algorithm; }

  /** The queries of a scenario. @param {string[]} names @param {string | undefined} chosen */
  offerQueries(names, chosen) {
    this.query.replaceChildren(...names.map((name) => make("option", { value: name, selected: name === chosen }, name)));
    this.queryRow.hidden = names.length < 2;
  }

  get algorithm() { return this.planner.value; }

  /** What a planner can be given, its seed with it; nothing where there is no such planner. @param {string} algorithm */
  parametersOf(algorithm) {
    const info = this.infos.find(({ id }) => id === algorithm);
    return info ? withSeed(info.parameters) : [];
  }

  /** What a planner would be asked with some settings, the rest at their defaults. @param {string} algorithm @param {Settings} settings @returns {Plan} */
  planFrom(algorithm, settings) {
    /** @type {Settings} */
    const all = {};
    for (const { name, default: value } of this.parametersOf(algorithm)) if (value !== null) all[name] = value;
    return { algorithm, settings: { ...all, ...settings } };
  }

  /** What the planner is asked, or null while a field holds a value that is refused. @returns {Plan | null} */
  get plan() {
    const { settings } = this;
    return settings && { algorithm: this.algorithm, settings };
  }

  /** Everything a run needs, or null while a field holds a value that is refused. @returns {Settings | null} */
  get settings() {
    /** @type {Settings} */
    const settings = {};
    for (const field of this.fields) {
      if (!field.validate()) return null;
      const value = field.value;
      if (value !== undefined) settings[field.info.name] = value;
    }
    return settings;
  }

  /** Says beside a field why the core refused its value. @param {string} pointer  JSON pointer into the options @param {string} reason @returns {boolean} whether there is such a field */
  refuse(pointer, reason) {
    const field = this.fields.find(({ info }) => `/${info.name}` === pointer);
    if (!field) return false;
    field.refuse(reason);
    if (this.rest.contains(field.element)) this.more.open = true;
    return true;
  }

  /** A seed nobody has seen. */
  reseed() {
    const field = this.fields.find(({ info }) => info.name === "seed");
    if (!field) return;
    field.set(this.randomSeed());
    this.keep(field);
    this.onChange();
  }

  /** Makes the fields of the chosen planner. */
  build() {
    const info = this.infos.find(({ id }) => id === this.planner.value) ?? this.infos[0];
    this.summary.textContent = info.summary;
    this.presets.offer(info, this.given);
    this.first.replaceChildren(this.presets.element);
    this.rest.replaceChildren();
    // What a scene sets by itself is there to be seen.
    const isFirst = (/** @type {string} */ name) => FIRST.has(name) || this.lead.has(name);
    this.fields = withSeed(info.parameters).filter((parameter) => this.fits(parameter)).map((parameter) => {
      const field = new Field(parameter, this.given[parameter.name] ?? parameter.default, () => {
        this.keep(field);
        this.onChange();
      });
      if (parameter.name === "seed") this.addSeedButton(field);
      if (isFirst(parameter.name)) this.first.append(field.element);
      return field;
    });
    this.rest.append(...groupsOf(this.fields.filter(({ info: { name } }) => !isFirst(name))));
    this.more.hidden = this.rest.childElementCount === 0;
  }

  /** @param {Field} field */
  addSeedButton(field) {
    const button = make("button", { type: "button", id: "new-seed" }, "New seed");
    button.addEventListener("click", () => this.reseed());
    field.element.append(button);
  }

  /** @param {Field} field */
  keep(field) {
    const value = field.value;
    if (value === undefined) delete this.given[field.info.name];
    else this.given[field.info.name] = value;
    this.presets.mark(this.given);
  }
}

/** The fields that are not first, under headings. @param {Field[]} fields @returns {HTMLElement[]} */
export function groupsOf(fields) {
  const others = fields.filter(({ info }) => !FIRST.has(info.name));
  const grouped = new Set(GROUPS.flatMap(([, names]) => names));
  const rest = others.filter(({ info }) => !grouped.has(info.name)).map(({ info }) => info.name);
  return [...GROUPS, /** @type {[string, string[]]} */ ([REST, rest])].flatMap(([title, names]) => {
    const elements = others.filter(({ info }) => names.includes(info.name)).map(({ element }) => element);
    return elements.length > 0 ? make("div", { className: "group" }, make("h3", {}, title), ...elements) : [];
  });
}
