/** A select of a planner's presets. A preset sets all other parameters but the seed to their defaults. */
import { namesOfDocuments } from "../../domain/option-names.js";
import { make } from "../../app/dom.js";

/** @import { PlannerInfo, Settings } from "../../domain/types.js" */

export class Presets {
  /** @param {(settings: Settings) => void} onChoose */
  constructor(onChoose) {
    /** @type {PlannerInfo["presets"]} */
    this.presets = [];
    /** @type {Map<string, unknown>} */
    this.defaults = new Map();
    this.select = make("select", { onchange: () => onChoose(this.presets.find((preset) => preset.id === this.select.value)?.settings ?? {}) });
    this.element = make("label", { className: "row" }, make("span", { className: "name" }, "Settings"), this.select);
  }

  /** @param {string} id  of the select @param {string} [label]  in place of "Settings" */
  identify(id, label) {
    this.select.id = this.element.htmlFor = id;
    if (label) this.select.ariaLabel = label;
  }

  /** Offers a planner's presets; without any the row is hidden. @param {PlannerInfo} info @param {Settings} given */
  offer({ presets, parameters }, given) {
    this.defaults = new Map(parameters.map(({ name, default: value }) => [name, value ?? undefined]));
    this.presets = presets.map((preset) => ({ ...preset, settings: namesOfDocuments(preset.settings) }));
    this.element.hidden = presets.length === 0;
    const option = (/** @type {string} */ value, /** @type {string} */ title) => make("option", { value, disabled: value === "own" }, title);
    this.select.replaceChildren(option("own", "custom"), option("", "defaults"), ...this.presets.map(({ id, title }) => option(id, title)));
    this.mark(given);
  }

  /** Selects the preset that equals the settings, if any. @param {Settings} given */
  mark(given) {
    const { defaults } = this;
    const isEqual = (/** @type {Settings} */ settings) => Object.keys({ ...given, ...settings })
      .every((name) => name === "seed" || (given[name] ?? defaults.get(name)) === (settings[name] ?? defaults.get(name)));
    this.select.value = this.presets.find(({ settings }) => isEqual(settings))?.id ?? (isEqual({}) ? "" : "own");
  }
}
