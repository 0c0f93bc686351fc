/** One rival in a race: its planner, its settings, and a way to be rid of it. Its seed is that of planner A unless it is given one. */
import { letter } from "./standings.js";
import { make } from "../../app/dom.js";
import { Field, withSeed } from "../../widgets/field.js";
import { FIRST, groupsOf } from "../settings/panel.js";
import { Presets } from "../settings/presets.js";

/** @import { Plan, PlannerInfo, Settings } from "../../domain/types.js" */

export class Rival {
  /**
   * @param {PlannerInfo[]} infos   those that are for the robot on the stage
   * @param {(info: object) => boolean} fits   is a parameter for it, too
   * @param {Plan} plan   settings that its planner does not know are kept for one that does
   * @param {{ change: () => void, remove: () => void }} then
   */
  constructor(infos, fits, { algorithm, settings }, then) {
    this.infos = infos;
    this.fits = fits;
    this.change = then.change;
    /** @type {Settings} */
    this.given = { ...settings };
    /** @type {Field[]} */
    this.fields = [];
    this.lane = 0;
    this.presets = new Presets((settings) => {
      const { seed } = this.given;
      this.given = { ...(seed === undefined ? {} : { seed }), ...settings };
      this.build();
      this.change();
    });
    this.name = make("legend", {});
    this.planner = make("select", {}, ...infos.map(({ id, title }) => make("option", { value: id }, title)));
    this.planner.value = algorithm;
    this.planner.addEventListener("change", () => {
      this.build();
      this.change();
    });
    this.remove = make("button", { type: "button" }, "Remove");
    this.remove.addEventListener("click", then.remove);
    this.first = make("div", {});
    this.more = make("div", {});
    this.rest = make("details", {}, make("summary", {}, "More parameters"), this.more);
    this.settings = make("details", {}, make("summary", {}, "Settings"), this.first, this.rest);
    this.element = make("fieldset", { className: "rival" }, this.name, make("div", { className: "row" }, this.planner, this.remove), this.settings);
  }

  /** Another robot is on the stage, which these planners serve, its own among them. @param {PlannerInfo[]} infos */
  offer(infos) {
    const { value } = this.planner;
    this.infos = infos;
    this.planner.replaceChildren(...infos.map(({ id, title }) => make("option", { value: id }, title)));
    this.planner.value = value;
    this.build();
  }

  /** It races in this lane. @param {number} lane  1 to 3 */
  place(lane) {
    if (lane === this.lane) return;
    this.lane = lane;
    this.name.textContent = `Rival ${letter(lane)}`;
    this.planner.id = `rival-${letter(lane)}-planner`;
    this.planner.setAttribute("aria-label", `Planner of ${letter(lane)}`);
    this.remove.setAttribute("aria-label", `Remove ${letter(lane)}`);
    this.presets.identify(`rival-${letter(lane)}-preset`, `Settings of ${letter(lane)}`);
    this.build();
  }

  build() {
    const info = this.infos.find(({ id }) => id === this.planner.value) ?? this.infos[0];
    this.presets.offer(info, this.given);
    this.fields = withSeed(info.parameters).filter(this.fits).map((parameter) => {
      const one = parameter.name === "seed" ? { ...parameter, default: null, default_meaning: "the seed of A", robots: [] } : parameter;
      const field = new Field(one, this.given[one.name] ?? one.default, () => {
        const { value } = field;
        if (value === undefined) delete this.given[one.name];
        else this.given[one.name] = value;
        this.presets.mark(this.given);
        this.change();
      }, `rival-${letter(this.lane)}`);
      return field;
    });
    this.first.replaceChildren(this.presets.element, ...this.fields.filter(({ info: { name } }) => FIRST.has(name)).map(({ element }) => element));
    this.more.replaceChildren(...groupsOf(this.fields));
  }

  /** What it is asked beside planner A, or null while a field holds a value that is refused. @param {Plan} beside @returns {Plan | null} */
  plan(beside) {
    /** @type {Settings} */
    const settings = { seed: beside.settings.seed ?? 0 };
    for (const field of this.fields) {
      if (!field.validate()) return null;
      const { value } = field;
      if (value !== undefined) settings[field.info.name] = value;
    }
    return { algorithm: this.planner.value, settings };
  }

  /** Says beside a field why the core refused its value. @param {string} pointer @param {string} reason */
  refuse(pointer, reason) {
    const field = this.fields.find(({ info }) => `/${info.name}` === pointer);
    if (!field) return;
    field.refuse(reason);
    this.settings.open = true;
    if (this.more.contains(field.element)) this.rest.open = true;
  }
}
