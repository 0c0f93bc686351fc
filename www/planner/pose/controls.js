/** The robot's coordinates as sliders and numbers: the way to pose it without a pointer, and the exact way with one. */
import { byId, make } from "../../app/dom.js";

/** @import { SceneFacts, State } from "../../domain/types.js" */
/** @typedef {{ range: HTMLInputElement, number: HTMLInputElement, low: number, high: number }} Control */

export class Pose {
  /** @param {(pose: number[]) => void} onPose */
  constructor(onPose) {
    this.element = byId("pose", HTMLElement);
    this.touching = byId("touching", HTMLElement);
    this.onPose = onPose;
    this.awaits = false;
    /** @type {Control[]} */
    this.coordinates = [];
  }

  /** Makes the controls for a robot. @param {SceneFacts} facts */
  build({ coordinates, start }) {
    this.coordinates = [];
    this.element.replaceChildren();
    coordinates.forEach(({ name, low, high, unit }, i) => {
      const step = (high - low) / 2000;
      const range = make("input", { type: "range", min: String(low), max: String(high), step: String(step), id: `pose-${i}` });
      const number = make("input", { type: "number", min: String(low), max: String(high), step: "0.01", id: `pose-${i}-number`, autocomplete: "off" });
      range.setAttribute("aria-label", name);
      number.setAttribute("aria-label", `${name}, ${unit === "rad" ? "radians" : "metres"}`);
      range.addEventListener("input", () => this.give(i, Number(range.value)));
      number.addEventListener("change", () => {
        const value = Number(number.value);
        const good = number.value.trim() !== "" && value >= low && value <= high;
        if (good) number.removeAttribute("aria-invalid");
        else number.setAttribute("aria-invalid", "true");
        if (good) this.give(i, value);
      });
      this.coordinates.push({ range, number, low, high });
      this.element.append(make("div", { className: "coordinate" }, make("span", { className: "name" }, name), range, number, make("span", { className: "unit" }, unit)));
    });
    this.show(start ?? coordinates.map(({ low, high }) => (low + high) / 2));
    this.tell("", true);
  }

  /** Puts a pose into the controls. @param {ArrayLike<number>} pose */
  show(pose) {
    this.coordinates.forEach(({ range, number }, i) => {
      if (!range.matches(":active")) range.value = String(pose[i]);
      if (document.activeElement !== number) number.value = pose[i].toFixed(3);
      number.removeAttribute("aria-invalid");
    });
  }

  /** @param {string} text @param {boolean} free */
  tell(text, free) {
    this.touching.textContent = text;
    this.touching.dataset.free = String(free);
  }

  /** @param {number} index @param {number} value */
  give(index, value) {
    const pose = this.coordinates.map(({ range, low, high }) => Math.min(high, Math.max(low, Number(range.value))));
    pose[index] = value;
    // The other controls are read again before the worker has answered.
    this.coordinates[index].range.value = String(value);
    this.onPose(pose);
  }

  /** @param {State} state */
  reflect(state) {
    if (state.pose) this.show(state.pose);
    this.tell(state.touching.text, state.touching.free);
    if (!state.inHand || !this.awaits) return;
    this.awaits = false;
    this.coordinates[0]?.range.focus();
  }

  /** Once the robot is in the hand, the focus goes to its first coordinate. */
  awaitFocus() { this.awaits = true; }
}
