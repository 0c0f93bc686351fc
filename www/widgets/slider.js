/** A number as a slider and a field, with the reason beside an invalid value. */
import { grouped, make } from "../app/dom.js";
import { reasonAgainst, showReason } from "./field.js";

/** @import { Coordinate } from "../domain/types.js" */

/**
 * @typedef {object} SliderInfo
 * @property {string} name   the id of the slider; that of the field ends in "-number"
 * @property {string} title
 * @property {string} [unit]
 * @property {number} min
 * @property {number} max
 * @property {readonly [number, number]} [allowed]   what the field takes, if that is more than the slider reaches
 * @property {number} [step]
 * @property {"integer" | "number"} [kind]
 * @property {boolean} [isLog]   its steps are equal ratios, and a change counts when it is released
 */

/** @type {Record<string, string>} */
const SPOKEN = { rad: "radians", m: "metres" };
/** Steps of a logarithmic slider. */
const LOG_STEPS = 300;

export class Slider {
  /** @param {SliderInfo} info @param {number} value @param {(value: number) => void} onInput */
  constructor(info, value, onInput) {
    const { name, title, unit = "", isLog = false, kind = "number" } = info;
    this.info = { ...info, kind };
    this.onInput = onInput;
    this.current = value;
    this.range = make("input", { type: "range", id: name, ariaLabel: title });
    this.number = make("input", {
      type: "number",
      id: `${name}-number`,
      ariaLabel: unit ? `${title}, ${SPOKEN[unit] ?? unit}` : title,
    });
    this.reason = make("p", { className: "reason", id: `${name}-reason`, hidden: true });
    this.number.setAttribute("aria-describedby", this.reason.id);
    this.range.addEventListener("input", () => {
      if (isLog) this.write(this.rangeValue);
      else this.give(this.rangeValue);
    });
    if (isLog) this.range.addEventListener("change", () => this.give(this.rangeValue));
    this.number.addEventListener("change", () =>
      this.give(this.number.value.trim() === "" ? NaN : Number(this.number.value)),
    );
    this.row = make(
      "div",
      { className: "coordinate" },
      make("span", { className: "name" }, title),
      this.range,
      this.number,
      make("span", { className: "unit" }, unit),
    );
    this.element = make("div", {}, this.row, this.reason);
    this.setLimits(info.min, info.max);
  }

  /** The value at the slider; of a logarithmic one rounded to two digits. */
  get rangeValue() {
    const { range } = this;
    const { min, max, isLog } = this.info;
    if (!isLog) return Number(range.value);
    const value = min * (max / min) ** (Number(range.value) / LOG_STEPS);
    return Math.min(max, Math.max(min, Number(value.toPrecision(2))));
  }

  /** What the field takes. */
  get allowed() {
    return this.info.allowed ?? [this.info.min, this.info.max];
  }

  /** Reports a valid value. @param {number} value */
  give(value) {
    const [min, max] = this.allowed;
    const reason = reasonAgainst({ ...this.info, min, max, choices: null }, value);
    this.refuse(reason);
    if (reason) return;
    this.show(value);
    this.onInput(value);
  }

  /** @param {string} reason */
  refuse(reason) {
    showReason(this.reason, this.number, reason);
  }

  /** Writes a value into the field, unless it has the focus. @param {number} value */
  write(value) {
    // A field that takes small numbers shows their digits.
    const isSmall = value !== 0 && Math.abs(value) < 0.1 && this.info.allowed !== undefined;
    const text = isSmall
      ? String(value)
      : value.toFixed(this.info.kind === "integer" ? 0 : 3).replace(/^-(0(\.0*)?)$/, "$1");
    if (document.activeElement !== this.number && this.number.value !== text) this.number.value = text;
    if (this.info.isLog) this.range.setAttribute("aria-valuetext", grouped(value));
  }

  /** Shows a value. @param {number} value */
  show(value) {
    const { range } = this;
    const { min, max, isLog } = this.info;
    this.current = value;
    if (!range.matches(":active"))
      range.value = String(isLog ? Math.round((LOG_STEPS * Math.log(value / min)) / Math.log(max / min)) : value);
    this.write(value);
    if (document.activeElement !== this.number) this.refuse("");
  }

  /** @param {number} min @param {number} max */
  setLimits(min, max) {
    const { info, range, number } = this;
    Object.assign(info, { min, max });
    const step = info.step ?? (info.kind === "integer" ? 1 : (max - min) / 2000);
    Object.assign(
      range,
      info.isLog
        ? { min: "0", max: String(LOG_STEPS), step: "1" }
        : { min: String(min), max: String(max), step: String(step) },
    );
    const [least, most] = this.allowed;
    Object.assign(number, { min: String(least), max: String(most), step: info.kind === "integer" ? "1" : "any" });
    this.show(this.current);
  }
}

/**
 * A slider for each coordinate of a configuration.
 * @param {string} prefix   begins the names, which end in the number of the coordinate
 * @param {Coordinate[]} coordinates
 * @param {ArrayLike<number>} values
 * @param {(i: number, value: number) => void} onInput
 */
export function slidersOf(prefix, coordinates, values, onInput) {
  return coordinates.map(({ name: title, low: min, high: max, unit }, i) => {
    const info = { name: `${prefix}${i}`, title, unit, min, max };
    return new Slider(info, values[i], (value) => onInput(i, value));
  });
}
