/**
 * A rival in a race: its planner, its settings, and a button that removes it. Without a seed of its own it has that of
 * planner A.
 */
import { make } from "../../app/dom.js";
import { SettingsForm } from "../settings/form.js";
import { letter } from "./standings.js";

/** @import { Panel } from "../settings/panel.js" */
/** @import { Plan } from "../../domain/types.js" */

export class Rival {
  /**
   * @param {Panel} panel
   * @param {Plan} plan   settings that its planner does not have are stored for one that does
   * @param {{ change: () => void, remove: () => void }} on
   */
  constructor(panel, { algorithm, settings }, on) {
    this.lane = 0;
    this.planner = make("select", {});
    const first = make("div", {});
    const rest = make("div", {});
    this.form = new SettingsForm(this.planner, first, rest, (info) => panel.fits(info), on.change);
    this.form.given = { ...settings };
    this.form.seed = { default: null, default_meaning: "the seed of A", robots: [] };
    this.form.offer(panel.served);
    this.planner.value = algorithm;
    this.name = make("legend", {});
    this.remove = make("button", { type: "button", onclick: on.remove }, "Remove");
    const more = make("details", {}, make("summary", {}, "More parameters"), rest);
    this.element = make(
      "fieldset",
      { className: "rival" },
      this.name,
      make("div", { className: "row" }, this.planner, this.remove),
      make("details", {}, make("summary", {}, "Settings"), first, more),
    );
  }

  /** Gives it a lane. @param {number} lane  1 to 3 */
  place(lane) {
    if (lane === this.lane) return;
    this.lane = lane;
    const name = letter(lane);
    const { preset, presetRow } = this.form;
    this.name.textContent = `Rival ${name}`;
    Object.assign(this.planner, { id: `rival-${name}-planner`, ariaLabel: `Planner of ${name}` });
    this.remove.ariaLabel = `Remove ${name}`;
    Object.assign(preset, { id: `rival-${name}-preset`, ariaLabel: `Settings of ${name}` });
    presetRow.htmlFor = preset.id;
    this.form.family = `rival-${name}`;
    this.form.build();
  }

  /** The plan, or null while a field holds an invalid value. @param {Plan} first  planner A's @returns {Plan | null} */
  plan(first) {
    const { plan } = this.form;
    return plan && { ...plan, settings: { seed: first.settings.seed ?? 0, ...plan.settings } };
  }
}
