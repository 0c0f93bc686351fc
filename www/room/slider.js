/**
 * One number as a slider and a field: the quick way and the exact way, and both without a pointer. A value that is refused is
 * said to be, and never handed on.
 */
import { make } from "../app/dom.js";
import { reasonAgainst } from "../widgets/field.js";

/** @typedef {{ name: string, title: string, unit: string, min: number, max: number, step?: number, digits?: number, kind?: "integer" | "number" }} SliderInfo   `digits` after the point */

/** In words, for those who hear them. @type {Record<string, string>} */
const UNITS = { rad: "radians", m: "metres", "": "" };

export class Slider {
  /** @param {SliderInfo} info @param {number} value @param {(value: number) => void} onInput */
  constructor(info, value, onInput) {
    const { name, title, unit, min, max, kind = "number", step = kind === "integer" ? 1 : (max - min) / 2000 } = info;
    this.info = info;
    this.onInput = onInput;
    this.current = value;
    const label = unit ? `${title}, ${UNITS[unit] ?? unit}` : title;
    this.range = make("input", { type: "range", id: name, min: String(min), max: String(max), step: String(step), ariaLabel: title });
    this.number = make("input", { type: "number", id: `${name}-number`, min: String(min), max: String(max), step: kind === "integer" ? "1" : "any", autocomplete: "off", ariaLabel: label });
    this.reason = make("p", { className: "reason", id: `${name}-reason`, hidden: true });
    this.number.setAttribute("aria-describedby", this.reason.id);
    this.range.addEventListener("input", () => this.give(Number(this.range.value)));
    this.number.addEventListener("change", () => this.give(this.number.value.trim() === "" ? NaN : Number(this.number.value)));
    this.row = make("div", { className: "coordinate" }, make("span", { className: "name" }, title), this.range, this.number, make("span", { className: "unit" }, unit));
    this.element = make("div", {}, this.row, this.reason);
    this.show(value);
  }

  /** @param {number} value */
  give(value) {
    const { kind = "number", min, max } = this.info;
    const reason = reasonAgainst({ ...this.info, kind, min, max, choices: null, robots: [], default: min, meaning: "" }, value);
    this.refuse(reason);
    if (reason) return;
    this.current = value;
    this.range.value = String(value);
    this.write();
    this.onInput(value);
  }

  /** @param {string} reason */
  refuse(reason) {
    this.reason.textContent = reason;
    this.reason.hidden = reason === "";
    if (reason) this.number.setAttribute("aria-invalid", "true");
    else this.number.removeAttribute("aria-invalid");
  }

  write() {
    const { kind, digits = kind === "integer" ? 0 : 3 } = this.info;
    const text = this.current.toFixed(digits).replace(/^-(0(\.0*)?)$/, "$1");
    if (document.activeElement !== this.number && this.number.value !== text) this.number.value = text;
  }

  /** Puts a value in; whoever is typing is left alone. @param {number} value */
  show(value) {
    this.current = value;
    if (!this.range.matches(":active")) this.range.value = String(value);
    this.write();
    if (document.activeElement !== this.number) this.refuse("");
  }

  /** Other ends. @param {number} min @param {number} max */
  span(min, max) {
    Object.assign(this.info, { min, max });
    for (const input of [this.range, this.number]) Object.assign(input, { min: String(min), max: String(max) });
    this.range.step = String((max - min) / 2000);
    this.show(this.current);
  }
}
