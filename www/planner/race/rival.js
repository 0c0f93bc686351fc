/** A rival in a race: its planner, its settings, and a button that removes it. Without a seed of its own it has that of planner A. */
import { make } from "../../app/dom.js";
import { SettingsForm } from "../settings/form.js";
import { offerPlanners } from "../settings/panel.js";
import { letter } from "./standings.js";

/** @import { ParameterInfo, Plan, PlannerInfo } from "../../domain/types.js" */

export class Rival {
  /**
   * @param {PlannerInfo[]} infos   of the planners for the robot
   * @param {(info: ParameterInfo) => boolean} fits   whether a parameter is for the robot
   * @param {Plan} plan   settings that its planner does not have are stored for one that does
   * @param {{ change: () => void, remove: () => void }} on
   */
  constructor(infos, fits, { algorithm, settings }, on) {
    this.infos = infos;
    this.lane = 0;
    const first = make("div", {});
    const rest = make("div", {});
    this.form = new SettingsForm(first, rest, fits, on.change);
    this.form.given = { ...settings };
    this.form.seed = { default: null, default_meaning: "the seed of A", robots: [] };
    this.name = make("legend", {});
    this.planner = make("select", {
      onchange: () => {
        this.build();
        on.change();
      },
    });
    offerPlanners(this.planner, infos);
    this.planner.value = algorithm;
    this.remove = make("button", { type: "button", onclick: on.remove }, "Remove");
    const more = make("details", {}, make("summary", {}, "More parameters"), rest);
    this.element = make("fieldset", { className: "rival" }, this.name, make("div", { className: "row" }, this.planner, this.remove),
      make("details", {}, make("summary", {}, "Settings"), first, more));
  }

  /** Offers the planners for another robot, its own among them. @param {PlannerInfo[]} infos */
  offer(infos) {
    this.infos = infos;
    offerPlanners(this.planner, infos);
    this.build();
  }

  /** Gives it a lane. @param {number} lane  1 to 3 */
  place(lane) {
    if (lane === this.lane) return;
    this.lane = lane;
    const name = letter(lane);
    this.name.textContent = `Rival ${name}`;
    Object.assign(this.planner, { id: `rival-${name}-planner`, ariaLabel: `Planner of ${name}` });
    this.remove.ariaLabel = `Remove ${name}`;
    this.form.identify(`rival-${name}-preset`, `Settings of ${name}`);
    this.build();
  }

  build() {
    const info = this.infos.find(({ id }) => id === this.planner.value) ?? this.infos[0];
    this.form.build(info, `rival-${letter(this.lane)}`);
  }

  /** The plan, or null while a field holds an invalid value. @param {Plan} first  planner A's @returns {Plan | null} */
  plan(first) {
    const { settings } = this.form;
    return settings && { algorithm: this.planner.value, settings: { seed: first.settings.seed ?? 0, ...settings } };
  }
}
