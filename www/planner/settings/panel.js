/** The settings: the planner, its parameters, the seed and the query. They are built from the tables of the core. */
import { byId, make, reveal, write } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";
import { FIRST, SettingsForm } from "./form.js";

/** @import { Field } from "../../widgets/field.js" */
/** @import { Plan, PlannerInfo, Settings } from "../../domain/types.js" */

export class Panel {
  /**
   * @param {() => number} randomSeed
   * @param {{ lane: (lane: Plan) => void, query: (name: string) => void, own: () => void, seeds: (() => void) | null }} on   another
   *   planner or setting, another query, or the scene's own planner was chosen; `seeds`: a run over many seeds is
   *   wanted, null where there is no page for it
   */
  constructor(randomSeed, on) {
    this.randomSeed = randomSeed;
    this.on = on;
    this.planner = byId("planner", HTMLSelectElement);
    this.queryRow = byId("query-row", HTMLElement);
    this.query = byId("query", HTMLSelectElement);
    this.own = button("own-planner", "", () => {
      on.own();
      this.planner.focus();
    });
    this.own.hidden = true;
    /** The settings of the scene that is shown. @type {Settings | undefined} */
    this.scene = undefined;
    const newSeed = button("new-seed", "New seed", () => this.reseed());
    const rest = byId("more-parameters", HTMLElement);
    this.form = new SettingsForm(this.planner, byId("parameters", HTMLElement), rest, on.lane, ({ summary }) => {
      byId("planner-summary", HTMLElement).textContent = summary;
      this.form.field("seed")?.element.append(newSeed);
      byId("main-parameters", HTMLElement).replaceChildren(...this.main.map(({ element }) => element));
      byId("more-parameters-fold", HTMLDetailsElement).hidden = rest.childElementCount === 0;
    });
    byId("planner-summary", HTMLElement).after(this.own);
    if (on.seeds) byId("main-parameters", HTMLElement).after(button("over-seeds", "Over 100 seeds", on.seeds));
    this.query.addEventListener("change", () => on.query(this.query.value));
    this.planner.disabled = false;
  }

  /**
   * Shows planner A.
   * @param {Plan} lane
   * @param {PlannerInfo[]} infos   the planners for the robot
   * @param {string} robot
   * @param {Settings} [scene]   the settings of the scene itself
   */
  show(lane, infos, robot, scene) {
    const { form } = this;
    const isOther = scene !== this.scene || form.lane.algorithm !== lane.algorithm;
    this.scene = scene;
    form.show(lane, infos, robot, scene);
    if (!isOther) return;
    // What differs from the scene and from the defaults is in view.
    const differs = (/** @type {Field} */ { info: { name, default: value } }) =>
      lane.settings[name] !== undefined && lane.settings[name] !== (scene?.[name] ?? value);
    reveal(form.fields.find((field) => differs(field) && !this.main.includes(field))?.element);
  }

  /** The fields in view: the first main parameter, of those that the scene sets if there are any, and the seed. */
  get main() {
    const { form } = this;
    const [...names] = FIRST;
    const first = names.find((name) => form.leads(name)) ?? names.find((name) => form.field(name));
    return [first ?? "", "seed"].flatMap((name, i, all) => (all.indexOf(name) === i && form.field(name)) || []);
  }

  /** Offers the scene's own planner, where another one or other settings are shown. @param {string} title  or empty */
  offerOwn(title) {
    this.own.hidden = title === "";
    const isShown = this.form.info.title === title;
    this.own.textContent = isShown ? "Use this scene\u2019s settings" : `Use this scene\u2019s planner: ${title}`;
  }

  /** Offers the queries of a scenario. @param {string[]} names @param {string | undefined} selected */
  offerQueries(names, selected) {
    this.query.replaceChildren(
      ...names.map((name) => make("option", { value: name, selected: name === selected }, name)),
    );
    this.queryRow.hidden = names.length < 2;
  }

  /** @param {string} name */
  selectQuery(name) {
    this.query.value = name;
  }

  /** Changes the texts of the queries. @param {string[]} texts */
  nameQueries(texts) {
    texts.forEach((text, i) => write(this.query.options[i], text));
  }

  /** Chooses another seed. */
  reseed() {
    const { lane } = this.form;
    this.on.lane({ ...lane, settings: { ...lane.settings, seed: this.randomSeed() } });
  }
}
