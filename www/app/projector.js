/** Projector mode: a large stage, large text and bold lines. */
import { byId, make } from "./dom.js";

const CLASS = "projector";

/** Whether the address of a frame asks for it, as that of a slide does: then it stays. */
const isAsked = () => ["embed", "projector"].every((name) => new URLSearchParams(location.search).get(name) === "1");

/** Whether projector mode is on. */
export function isProjected() {
  return document.documentElement.classList.contains(CLASS);
}

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
    document.documentElement.classList.toggle(CLASS, isAsked());
    addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !event.defaultPrevented && isProjected()) this.turn(false);
    });
  }

  /** @param {boolean} on */
  turn(on) {
    if (on === isProjected() || (!on && isAsked())) return;
    document.documentElement.classList.toggle(CLASS, on);
    this.button.ariaPressed = String(on);
    this.onChange();
  }
}
