/** The settings: the planner, its parameters, the seed and the query. They are built from the tables of the core. */
import { byId, make, reveal, write } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";
import { withSeed } from "../../widgets/field.js";
import { FIRST, SettingsForm } from "./form.js";

/** @import { Field } from "../../widgets/field.js" */
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
    this.queryRow = byId("query-row", HTMLElement);
    this.query = byId("query", HTMLSelectElement);
    /** The robot: planners and parameters for others are not offered. */
    this.robot = "arm";
    const newSeed = button("new-seed", "New seed", () => this.reseed());
    const rest = byId("more-parameters", HTMLElement);
    this.form = new SettingsForm(
      this.planner,
      byId("parameters", HTMLElement),
      rest,
      (info) => this.fits(info),
      onChange,
      ({ summary }) => {
        byId("planner-summary", HTMLElement).textContent = summary;
        this.form.field("seed")?.element.append(newSeed);
        byId("main-parameters", HTMLElement).replaceChildren(...this.main.map(({ element }) => element));
        byId("more-parameters-fold", HTMLDetailsElement).hidden = rest.childElementCount === 0;
      },
    );
    this.query.addEventListener("change", onQuery);
    this.planner.disabled = false;
  }

  /** Whether a planner or a parameter is for the robot. @param {object} info */
  fits(info) {
    const { robots } = /** @type {{ robots?: readonly string[] | null }} */ (info);
    return !robots?.length || robots.includes(this.robot);
  }

  /** The planners for the robot. */
  get served() {
    return this.infos.filter((info) => this.fits(info));
  }

  /** Whether a planner is for the robot. @param {string} algorithm */
  serves(algorithm) {
    return this.served.some(({ id }) => id === algorithm);
  }

  /** Offers the planners for a robot. @param {string} robot */
  offer(robot) {
    this.robot = robot;
    this.form.offer(this.served);
  }

  /**
   * Selects a planner and some of its parameters.
   * @param {string} algorithm
   * @param {Settings} settings
   * @param {Settings} [scene]  those of the scene itself
   */
  suggest(algorithm, settings, scene = {}) {
    this.planner.value = algorithm;
    this.form.given = { ...settings };
    this.form.lead = new Set(Object.keys(scene));
    this.form.build();
    // What differs from the scene and from the defaults is in view.
    const differs = (/** @type {Field} */ { info: { name, default: value } }) =>
      settings[name] !== undefined && settings[name] !== (scene[name] ?? value);
    reveal(this.form.fields.find((field) => differs(field) && !this.main.includes(field))?.element);
  }

  /** The fields in view: the first main parameter, of those that the scene sets if there are any, and the seed. */
  get main() {
    const { form } = this;
    const [...names] = FIRST;
    const first = names.find((name) => form.lead.has(name)) ?? names.find((name) => form.field(name));
    return [first ?? "", "seed"].flatMap((name, i, all) => (all.indexOf(name) === i && form.field(name)) || []);
  }

  /** @param {string} algorithm */
  titleOf(algorithm) {
    return this.infos.find(({ id }) => id === algorithm)?.title ?? algorithm;
  }

  /** Offers the queries of a scenario. @param {string[]} names @param {string | undefined} selected */
  offerQueries(names, selected) {
    this.query.replaceChildren(
      ...names.map((name) => make("option", { value: name, selected: name === selected }, name)),
    );
    this.queryRow.hidden = names.length < 2;
  }

  /** Changes the texts of the queries. @param {string[]} texts */
  nameQueries(texts) {
    texts.forEach((text, i) => write(this.query.options[i], text));
  }

  get algorithm() {
    return this.planner.value;
  }

  /** The parameters of a planner and its seed; none for an unknown planner. @param {string} algorithm */
  parametersOf(algorithm) {
    const info = this.infos.find(({ id }) => id === algorithm);
    return info ? withSeed(info.parameters) : [];
  }

  /**
   * A plan with all parameters, defaults included.
   * @param {string} algorithm
   * @param {Settings} settings
   * @returns {Plan}
   */
  planFrom(algorithm, settings) {
    /** @type {Settings} */
    const all = {};
    for (const { name, default: value } of this.parametersOf(algorithm)) if (value !== null) all[name] = value;
    return { algorithm, settings: { ...all, ...settings } };
  }

  get plan() {
    return this.form.plan;
  }

  reseed() {
    const field = this.form.field("seed");
    if (!field) return;
    field.set(this.randomSeed());
    this.form.store(field);
    this.onChange();
  }
}
