/** Small controls that the panels share. */
import { make } from "../app/dom.js";

/** @param {string} id @param {string} text @param {(event: MouseEvent) => void} onClick */
export function button(id, text, onClick) {
  const element = make("button", { type: "button", id }, text);
  element.addEventListener("click", onClick);
  return element;
}

/** Marks a button as pressed or not. @param {Element} element @param {boolean} isPressed */
export function press(element, isPressed) { element.setAttribute("aria-pressed", String(isPressed)); }

/** Gives an element a role and a name for screen readers. @param {string} role @param {string} label @param {HTMLElement} element */
export function labelled(role, label, element) {
  element.setAttribute("role", role);
  element.setAttribute("aria-label", label);
  return element;
}
