/**
 * A rival in a race: its planner, its settings, and a button that removes it. Without a seed it has that of planner A.
 */
import { make } from "../../app/dom.js";
import { SettingsForm } from "../settings/form.js";
import { letter } from "./standings.js";

/** @import { Plan } from "../../domain/types.js" */

export class Rival {
  /** @param {number} lane  1 to 3 @param {{ change: (lane: Plan) => void, remove: () => void }} on */
  constructor(lane, on) {
    const name = letter(lane);
    this.planner = make("select", { id: `rival-${name}-planner`, ariaLabel: `Planner of ${name}` });
    const first = make("div", {});
    const rest = make("div", {});
    this.form = new SettingsForm(this.planner, first, rest, on.change);
    this.form.family = `rival-${name}`;
    this.form.seed = { default: null, default_meaning: "the seed of A", robots: [] };
    Object.assign(this.form.preset, { id: `rival-${name}-preset`, ariaLabel: `Settings of ${name}` });
    const remove = make("button", { type: "button", ariaLabel: `Remove ${name}`, onclick: on.remove }, "Remove");
    const more = make("details", {}, make("summary", {}, "More parameters"), rest);
    this.element = make(
      "fieldset",
      { className: "rival" },
      make("legend", {}, `Rival ${name}`),
      make("div", { className: "row" }, this.planner, remove),
      make("details", {}, make("summary", {}, "Settings"), first, more),
    );
  }
}
