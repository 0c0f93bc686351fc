/** Projector mode: a large stage, large text and bold lines. */
import { byId, make } from "./dom.js";

/** The class of the root. */
export const PROJECTED = "projector";

/** Whether projector mode is on. */
export function isProjected() {
  return document.documentElement.classList.contains(PROJECTED);
}

/** A frame keeps the lines that it was given: there Escape returns the focus. */
const isFrame = () => document.documentElement.classList.contains("embed");

export class Projector {
  /** @param {() => void} onChange */
  constructor(onChange) {
    this.onChange = onChange;
    this.button = make(
      "button",
      {
        type: "button",
        id: "projector",
        className: "quiet",
        ariaPressed: "false",
        title: "Large text and bold lines for a lecture; Escape exits",
        onclick: ({ detail }) => {
          this.turn(!isProjected());
          // After a click of the mouse Space plays, rather than leaving the mode again.
          if (detail > 0) document.getElementById("stage")?.focus({ preventScroll: true });
        },
      },
      "Projector",
    );
    byId("tools", HTMLElement).append(this.button);
    addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !event.defaultPrevented && isProjected() && !isFrame()) this.turn(false);
    });
  }

  /** @param {boolean} on */
  turn(on) {
    if (on === isProjected()) return;
    document.documentElement.classList.toggle(PROJECTED, on);
    this.button.ariaPressed = String(on);
    this.onChange();
  }
}
