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
