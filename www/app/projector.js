/** Projector mode: a large stage, large text and bold lines. */
import { byId, make } from "./dom.js";

const CLASS = "projector";

/** Whether projector mode is on. */
export function isProjected() { return document.documentElement.classList.contains(CLASS); }

export class Projector {
  /** @param {() => void} onChange */
  constructor(onChange) {
    this.onChange = onChange;
    this.button = make("button", { type: "button", id: "projector", className: "quiet", ariaPressed: "false" }, "Projector");
    this.button.title = "Large text and bold lines for a lecture; Escape exits";
    byId("tools", HTMLElement).append(this.button);
    this.button.addEventListener("click", () => this.turn(!isProjected()));
    addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !event.defaultPrevented && isProjected()) this.turn(false);
    });
  }

  /** @param {boolean} on */
  turn(on) {
    if (on === isProjected()) return;
    document.documentElement.classList.toggle(CLASS, on);
    this.button.setAttribute("aria-pressed", String(on));
    this.onChange();
  }
}
