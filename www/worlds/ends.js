/** Start and goal as numbers: what is dragged on the map can be typed, too. */
import { make } from "../app/dom.js";
import { reasonAgainst, showReason } from "../widgets/field.js";

/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Places } from "./types.js" */
/** @typedef {keyof Places} End */
/** @typedef {NonNullable<ScenarioDocument["world"]["bounds"]>} Bounds */

/** The coordinates of an end: a label, and the metres or radians of one displayed unit. */
const COORDINATES = /** @type {const} */ ([
  { name: "x", title: "x, m", unit: 1 },
  { name: "y", title: "y, m", unit: 1 },
  { name: "heading", title: "heading, \u00b0", unit: Math.PI / 180 },
]);

/** The significant digits of the longer side of a world that are shown. */
const DIGITS = 5;

/** The digits after the point. @param {Bounds | undefined} bounds */
function decimalsIn(bounds) {
  if (!bounds) return 3;
  const side = Math.max(bounds.max[0] - bounds.min[0], bounds.max[1] - bounds.min[1]);
  return Math.min(12, Math.max(0, Math.floor(DIGITS - Math.log10(side))));
}

export class Ends {
  /** @param {(places: Places) => void} place   both, when a coordinate is typed */
  constructor(place) {
    this.place = place;
    /** @type {Places | null} */
    this.places = null;
    /** @type {Bounds | undefined} */
    this.bounds = undefined;
    this.rows = [this.row("start", "Start"), this.row("goal", "Goal")];
    this.element = make("div", { className: "world-ends" }, ...this.rows.map(({ element }) => element));
  }

  /** @param {End} end @param {string} title */
  row(end, title) {
    const fields = COORDINATES.map(({ name, title: label, unit }, i) => {
      const id = `world-${end}-${name}`;
      const input = make("input", { type: "number", step: "any", id });
      const reason = make("p", { className: "reason", id: `${id}-reason`, hidden: true });
      input.setAttribute("aria-describedby", reason.id);
      input.addEventListener("input", () => showReason(reason, input, this.type(end, i, input.value)));
      // What was refused is not used: the place is shown again.
      input.addEventListener("blur", () => this.show(this.places, this.bounds));
      return { input, reason, unit, element: make("label", {}, make("span", { className: "unit" }, label), input) };
    });
    const parts = [...fields.map(({ element }) => element), ...fields.map(({ reason }) => reason)];
    return { end, fields, element: make("fieldset", {}, make("legend", { className: "name" }, title), ...parts) };
  }

  /** Moves an end to what was typed; returns why that is refused, or nothing. @param {End} end @param {number} i @param {string} text */
  type(end, i, text) {
    if (!this.places) return "";
    const [min, max] = i === 2 ? [-360, 360] : [this.rounded(this.bounds?.min[i]), this.rounded(this.bounds?.max[i])];
    const value = text.trim() === "" ? NaN : Number(text);
    const reason = reasonAgainst({ kind: "number", min, max, choices: null }, value);
    if (reason) return `${COORDINATES[i].name}: ${reason}`;
    const pose = [...this.places[end]];
    pose[i] = value * COORDINATES[i].unit;
    this.place({ ...this.places, [end]: pose });
    return "";
  }

  /** A number as it is shown. @param {number | undefined} value */
  rounded(value) {
    return value === undefined ? null : Number(value.toFixed(decimalsIn(this.bounds)));
  }

  /** Shows both ends, but for the field that is being typed in. @param {Places | null} places @param {Bounds | undefined} bounds */
  show(places, bounds) {
    this.places = places;
    this.bounds = bounds;
    this.element.hidden = !places;
    if (!places) return;
    for (const { end, fields } of this.rows)
      for (const [i, { input, reason, unit, element }] of fields.entries()) {
        const value = places[end][i];
        element.hidden = value === undefined;
        if (input === document.activeElement) continue;
        if (value !== undefined) input.value = String(this.rounded(value / unit));
        showReason(reason, input, "");
      }
  }
}
