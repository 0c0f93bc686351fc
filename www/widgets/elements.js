/** Small controls that the panels share. */
import { make } from "../controls/dom.js";

/** @param {string} id @param {string} text @param {() => void} onClick */
export function button(id, text, onClick) {
  const element = make("button", { type: "button", id }, text);
  element.addEventListener("click", onClick);
  return element;
}

/** Marks a button as pressed or not. @param {Element} element @param {boolean} isPressed */
export function press(element, isPressed) { element.setAttribute("aria-pressed", String(isPressed)); }

/** A control and its name in a row. @param {string} title @param {HTMLElement} control */
export function row(title, control) {
  return make("label", { className: "row", htmlFor: control.id }, make("span", { className: "name" }, title), control);
}

/** A switch. @param {string} id @param {(isOn: boolean) => void} onChange */
export function toggle(id, onChange) {
  const input = make("input", { type: "checkbox", id, role: "switch" });
  input.addEventListener("change", () => onChange(input.checked));
  return input;
}

/** A list to choose from. @param {string} id @param {{ id: string, title: string }[]} choices @param {(id: string) => void} onChange */
export function select(id, choices, onChange) {
  const element = make("select", { id }, ...choices.map(({ id: value, title }) => make("option", { value }, title)));
  element.addEventListener("change", () => onChange(element.value));
  return element;
}

/** Elements that belong together, under a name for screen readers. @param {"group" | "region"} role @param {string} label @param {HTMLElement} element */
export function labelled(role, label, element) {
  element.setAttribute("role", role);
  element.setAttribute("aria-label", label);
  return element;
}
