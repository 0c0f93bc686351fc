/** An option as a native control with its label, its meaning, and the reason beside an invalid value. */
import { make } from "../app/dom.js";

/** @import { ParameterInfo } from "../domain/types.js" */

/** Milliseconds after the last keystroke at which a typed value counts. */
const TYPING = 900;

/** A text whose names of options are between backticks. @param {string} text @returns {(string | HTMLElement)[]} */
const marked = (text) => text.split("`").map((part, i) => (i % 2 ? make("code", {}, part) : part));

export class Field {
  /**
   * @param {ParameterInfo} info
   * @param {number | string | boolean | null} value   null: automatic
   * @param {() => void} onChange   called after a valid change
   * @param {string} [family]   begins the ids of its elements
   * @param {boolean} [isLive]  whether a typed value counts before the field is left
   */
  constructor(info, value, onChange, family = "parameter", isLive = true) {
    this.info = info;
    this.onChange = onChange;
    const id = `${family}-${info.name}`;
    this.control = control(info, value, id);
    this.reason = make("p", { className: "reason", id: `${id}-reason`, hidden: true });
    const meaning = make("p", { className: "hint", id: `${id}-meaning` }, ...marked(info.meaning));
    this.automatic = make("span", {}, automatic(info));
    meaning.append(this.automatic);
    this.control.setAttribute("aria-describedby", `${id}-meaning ${id}-reason`);
    /** The last valid value. */
    this.current = this.value;
    this.timer = 0;
    this.control.addEventListener("change", () => this.commit());
    this.control.addEventListener("input", () => {
      clearTimeout(this.timer);
      if (this.validate() && isLive) this.timer = window.setTimeout(() => this.commit(), TYPING);
    });
    const name = make("span", { className: "name" }, info.title || info.name);
    if (info.unit) name.append(make("span", { className: "unit" }, ` ${info.unit}`));
    this.row = make("label", { className: "row", htmlFor: id }, name, this.control);
    this.element = make("div", { className: "field" }, this.row, this.reason, meaning);
  }

  /** Reports a change, if the value is valid. */
  commit() {
    clearTimeout(this.timer);
    if (!this.validate() || this.value === this.current) return;
    this.current = this.value;
    this.onChange();
  }

  /** The value, or undefined for automatic. @returns {number | string | boolean | undefined} */
  get value() {
    const { control, info } = this;
    if (control instanceof HTMLInputElement && control.type === "checkbox") return control.checked;
    const text = control.value.trim();
    if (text === "") return undefined;
    return info.kind === "choice" ? text : Number(text);
  }

  /** @param {number | string | boolean} value */
  set(value) {
    if (this.control instanceof HTMLInputElement && this.control.type === "checkbox")
      this.control.checked = value === true;
    else this.control.value = String(value);
    this.current = this.value;
    this.validate();
  }

  /** Shows why the value is refused. @param {string} reason  or empty */
  refuse(reason) {
    showReason(this.reason, this.control, reason);
  }

  /** Whether the value is valid; an invalid one shows the reason. */
  validate() {
    const { info, value } = this;
    const { badInput } = this.control.validity;
    this.automatic.hidden = value !== undefined;
    let reason = "";
    if (badInput || value !== undefined) reason = reasonAgainst(info, badInput ? NaN : value);
    else if (info.default !== null && info.kind !== "choice")
      reason = `Enter ${info.kind === "integer" ? "a whole number" : "a number"}.`;
    this.refuse(reason);
    return reason === "";
  }
}

/**
 * Shows why the value of a control is refused, or that it is valid.
 * @param {HTMLElement} element @param {HTMLElement} control @param {string} reason  or empty
 */
export function showReason(element, control, reason) {
  element.textContent = reason;
  element.hidden = reason === "";
  control.ariaInvalid = reason ? "true" : null;
}

/**
 * Why a value is invalid, or empty.
 * @param {Pick<ParameterInfo, "kind" | "min" | "max" | "choices">} info
 * @param {unknown} value
 * @returns {string}
 */
export function reasonAgainst({ kind, min, max, choices }, value) {
  if (kind === "boolean") return typeof value === "boolean" ? "" : `${value} is neither true nor false.`;
  if (kind === "choice") return choices?.includes(String(value)) ? "" : `${value} is not an option.`;
  if (typeof value !== "number" || !Number.isFinite(value)) return "Enter a number.";
  if (kind === "integer" && !Number.isInteger(value)) return `${value} is not a whole number.`;
  if (min !== null && value < min) return `${value} is below ${min}.`;
  if (max !== null && value > max) return `${value} is above ${max}.`;
  return "";
}

/** The value of an empty field, in words. @param {ParameterInfo} info */
function automatic({ default_meaning: words }) {
  if (!words) return "";
  return nothing(words) ? ` ${words[0].toUpperCase()}${words.slice(1)}.` : ` Automatic: ${words}.`;
}

/** The word for an option that has no effect while it is empty. @param {string | null} [words] */
function nothing(words) {
  return /^(none|never)(?=:)/.exec(words ?? "")?.[0];
}

/**
 * @param {ParameterInfo} info
 * @param {number | string | boolean | null} value
 * @param {string} id
 * @returns {HTMLInputElement | HTMLSelectElement}
 */
function control(info, value, id) {
  if (info.kind === "choice") {
    const select = make("select", { id });
    if (info.default === null) select.append(make("option", { value: "" }, "automatic"));
    for (const choice of info.choices ?? []) select.append(make("option", { value: choice }, choice));
    if (value !== null) select.value = String(value);
    return select;
  }
  if (info.kind === "boolean") return make("input", { id, type: "checkbox", role: "switch", checked: value === true });
  const input = make("input", {
    id,
    type: "number",
    step: info.kind === "integer" ? "1" : "any",
    inputMode: info.kind === "integer" ? "numeric" : "decimal",
    value: value === null ? "" : String(value),
  });
  if (info.default === null) input.placeholder = nothing(info.default_meaning) ?? "automatic";
  return input;
}

/**
 * The parameters of a planner or a generator with its seed, which every one has.
 * @template {ParameterInfo} T
 * @param {T[]} parameters
 * @param {string} [what]   the seed determines
 */
export function withSeed(parameters, what = "run") {
  if (parameters.some(({ name }) => name === "seed")) return parameters;
  /** @type {ParameterInfo} */
  const seed = {
    name: "seed",
    title: "Seed",
    kind: "integer",
    unit: "",
    min: 0,
    max: Number.MAX_SAFE_INTEGER,
    default: 0,
    choices: null,
    robots: [],
    meaning: `Seed of the random numbers: the same seed gives the same ${what}, bit for bit.`,
  };
  return [...parameters, seed];
}
