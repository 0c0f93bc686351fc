/** How many, as a slider whose steps are equal ratios, and a field for the exact number. */
import { grouped } from "../planner/counters.js";
import { make } from "../app/dom.js";
import { reasonAgainst } from "../widgets/field.js";

/** Steps of the slider. */
const STEPS = 300;

export class Count {
  /** @param {{ name: string, title: string, min: number, max: number }} info @param {number} value @param {(value: number) => void} onInput */
  constructor(info, value, onInput) {
    const { name, title, min, max } = info;
    this.info = info;
    this.onInput = onInput;
    this.range = make("input", { type: "range", id: name, min: "0", max: String(STEPS), step: "1", ariaLabel: title });
    this.number = make("input", { type: "number", id: `${name}-number`, min: String(min), max: String(max), step: "1", autocomplete: "off", inputMode: "numeric", ariaLabel: title });
    this.reason = make("p", { className: "reason", id: `${name}-reason`, hidden: true });
    this.number.setAttribute("aria-describedby", this.reason.id);
    this.range.addEventListener("input", () => this.tell(this.valueAt(Number(this.range.value))));
    this.range.addEventListener("change", () => this.give(this.valueAt(Number(this.range.value))));
    this.number.addEventListener("change", () => this.give(this.number.value.trim() === "" ? NaN : Number(this.number.value)));
    this.row = make("div", { className: "coordinate" }, make("span", { className: "name" }, title), this.range, this.number, make("span", { className: "unit" }));
    this.element = make("div", {}, this.row, this.reason);
    this.show(value);
  }

  /** Two good digits of what a step stands for. @param {number} step */
  valueAt(step) {
    const { min, max } = this.info;
    const value = min * (max / min) ** (step / STEPS);
    const unit = 10 ** (Math.floor(Math.log10(value)) - 1);
    return Math.min(max, Math.max(min, Math.round(value / unit) * unit));
  }

  /** @param {number} value */
  tell(value) {
    this.number.value = String(value);
    this.range.setAttribute("aria-valuetext", grouped(value));
  }

  /** @param {number} value */
  give(value) {
    const reason = reasonAgainst({ ...this.info, kind: "integer", unit: "", choices: null, robots: [], default: this.info.min, meaning: "" }, value);
    this.reason.textContent = reason;
    this.reason.hidden = reason === "";
    if (reason) this.number.setAttribute("aria-invalid", "true");
    else this.number.removeAttribute("aria-invalid");
    if (reason) return;
    this.show(value);
    this.onInput(value);
  }

  /** Puts a value in. @param {number} value */
  show(value) {
    const { min, max } = this.info;
    const part = Math.log(Math.min(max, Math.max(min, value)) / min) / Math.log(max / min);
    this.range.value = String(Math.round(STEPS * part));
    this.tell(value);
  }
}
