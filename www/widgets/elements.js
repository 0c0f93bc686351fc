/** Small controls that the panels share. */
import { make } from "../app/dom.js";

/** @import { Properties } from "../app/dom.js" */

/**
 * @param {string} id
 * @param {string} text
 * @param {(event: MouseEvent) => void} onClick
 * @param {Properties<"button">} [properties]
 */
export function button(id, text, onClick, properties) {
  return make("button", { type: "button", id, onclick: onClick, ...properties }, text);
}

/** A control in a row with its name. @param {string} name @param {...HTMLElement} controls */
export function row(name, ...controls) {
  return make("label", { className: "row" }, make("span", { className: "name" }, name), ...controls);
}

/** A switch. @param {string} id @param {(isOn: boolean) => void} onChange @param {boolean} [isOn]   at first */
export function toggle(id, onChange, isOn = false) {
  const input = make("input", { type: "checkbox", role: "switch", id, checked: isOn });
  input.addEventListener("change", () => onChange(input.checked));
  return input;
}

/** @param {string} id @param {string} label @param {[string, string][]} options @param {string} [value]   at first */
export function select(id, label, options, value) {
  const element = make(
    "select",
    { id, ariaLabel: label },
    ...options.map(([key, text]) => make("option", { value: key }, text)),
  );
  if (value !== undefined) element.value = value;
  return element;
}

/** The head of a table. @param {string[]} titles   of the columns */
export function tableHead(titles) {
  return make("thead", {}, make("tr", {}, ...titles.map((title) => make("th", { scope: "col" }, title))));
}

/** Marks a button as pressed or not. @param {Element} element @param {boolean} isPressed */
export function press(element, isPressed) {
  element.ariaPressed = String(isPressed);
}

/**
 * Gives an element a role and a name for screen readers.
 * @param {string} role
 * @param {string} label
 * @param {HTMLElement} element
 */
export function labelled(role, label, element) {
  return Object.assign(element, { role, ariaLabel: label });
}
