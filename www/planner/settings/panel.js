/** The settings: the planner, its parameters, the seed and the query. They are built from the tables of the core. */
import { byId, make } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";
import { withSeed } from "../../widgets/field.js";
import { SettingsForm } from "./form.js";

/** @import { Plan, PlannerInfo, Settings } from "../../domain/types.js" */

export class Panel {
  /**
   * @param {PlannerInfo[]} planners
   * @param {() => number} randomSeed
   * @param {() => void} onChange   a setting of the run changed
   * @param {() => void} onQuery    another query was selected
   */
  constructor(planners, randomSeed, onChange, onQuery) {
    this.randomSeed = randomSeed;
    this.onChange = onChange;
    this.infos = planners;
    this.planner = byId("planner", HTMLSelectElement);
    this.summary = byId("planner-summary", HTMLElement);
    this.more = byId("more", HTMLDetailsElement);
    this.queryRow = byId("query-row", HTMLElement);
    this.query = byId("query", HTMLSelectElement);
    /** The robot: planners and parameters for others are not offered. */
    this.robot = "arm";
    this.form = new SettingsForm(byId("parameters", HTMLElement), byId("more-parameters", HTMLElement), (info) => this.fits(info), onChange);
    this.form.identify("preset");
    this.newSeed = button("new-seed", "New seed", () => this.reseed());
    this.planner.addEventListener("change", () => {
      this.build();
      onChange();
    });
    this.query.addEventListener("change", onQuery);
    this.planner.disabled = false;
  }

  /** Whether a planner or a parameter is for the robot. @param {object} info */
  fits(info) {
    const { robots } = /** @type {{ robots?: readonly string[] | null }} */ (info);
    return !robots?.length || robots.includes(this.robot);
  }

  /** Whether a planner is for the robot. @param {string} algorithm */
  serves(algorithm) { return this.infos.some((info) => info.id === algorithm && this.fits(info)); }

  /** Offers the planners for a robot. @param {string} robot */
  offer(robot) {
    this.robot = robot;
    offerPlanners(this.planner, this.infos.filter((info) => this.fits(info)));
  }

  /** Selects a planner and some of its parameters. @param {string} algorithm @param {Settings} settings @param {Settings} [scene]  those of the scene itself */
  suggest(algorithm, settings, scene = {}) {
    this.planner.value = algorithm;
    this.form.given = { ...settings };
    this.form.lead = new Set(Object.keys(scene));
    this.build();
  }

  /** @param {string} algorithm */
  titleOf(algorithm) { return this.infos.find(({ id }) => id === algorithm)?.title ?? algorithm; }

  /** Offers the queries of a scenario. @param {string[]} names @param {string | undefined} selected */
  offerQueries(names, selected) {
    this.query.replaceChildren(...names.map((name) => make("option", { value: name, selected: name === selected }, name)));
    this.queryRow.hidden = names.length < 2;
  }

  get algorithm() { return this.planner.value; }

  /** The parameters of a planner and its seed; none for an unknown planner. @param {string} algorithm */
  parametersOf(algorithm) {
    const info = this.infos.find(({ id }) => id === algorithm);
    return info ? withSeed(info.parameters) : [];
  }

  /** A plan with all parameters, defaults included. @param {string} algorithm @param {Settings} settings @returns {Plan} */
  planFrom(algorithm, settings) {
    /** @type {Settings} */
    const all = {};
    for (const { name, default: value } of this.parametersOf(algorithm)) if (value !== null) all[name] = value;
    return { algorithm, settings: { ...all, ...settings } };
  }

  /** The plan, or null while a field holds an invalid value. @returns {Plan | null} */
  get plan() {
    const { settings } = this.form;
    return settings && { algorithm: this.algorithm, settings };
  }

  reseed() {
    const field = this.form.field("seed");
    if (!field) return;
    field.set(this.randomSeed());
    this.form.store(field);
    this.onChange();
  }

  build() {
    const info = this.infos.find(({ id }) => id === this.planner.value) ?? this.infos[0];
    this.summary.textContent = info.summary;
    this.form.build(info, "parameter");
    this.form.field("seed")?.element.append(this.newSeed);
    this.more.hidden = this.form.rest.childElementCount === 0;
  }
}

/** Offers planners in a select; the one selected stays so, or else the first one is. @param {HTMLSelectElement} select @param {PlannerInfo[]} infos */
export function offerPlanners(select, infos) {
  const { value } = select;
  select.replaceChildren(...infos.map(({ id, title }) => make("option", { value: id }, title)));
  select.value = value;
  if (select.selectedIndex < 0) select.selectedIndex = 0;
}
