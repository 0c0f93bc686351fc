/** The robot's coordinates as sliders and numbers, to pose it without a pointer and exactly. */
import { byId, write } from "../../app/dom.js";
import { Slider } from "../../widgets/slider.js";

/** @import { Coordinate } from "../../domain/types.js" */
/**
 * @typedef {object} State   of the page
 * @property {number[] | null} pose
 * @property {string} turns
 * @property {{ text: string, free: boolean }} touching
 * @property {boolean} inHand
 */

export class Pose {
  /** @param {(pose: number[]) => void} onPose */
  constructor(onPose) {
    this.element = byId("pose", HTMLElement);
    this.turns = byId("turns", HTMLElement);
    this.touching = byId("touching", HTMLElement);
    this.onPose = onPose;
    /** Whether the first slider takes the focus with the next pose by hand. */
    this.awaitsFocus = false;
    /** @type {Slider[]} */
    this.sliders = [];
  }

  /** Makes the sliders for a robot. @param {{ coordinates: Coordinate[], start: number[] | null }} facts */
  build({ coordinates, start }) {
    this.sliders = coordinates.map(({ name, low, high, unit }, i) => {
      const value = start?.[i] ?? (low + high) / 2;
      const slider = new Slider({ name: `pose-${i}`, title: name, unit, min: low, max: high }, value, () =>
        this.onPose(this.sliders.map(({ current }) => current)),
      );
      slider.number.step = "0.01";
      return slider;
    });
    this.element.replaceChildren(...this.sliders.map(({ element }) => element));
  }

  /** @param {State} state */
  reflect({ pose, turns, touching, inHand }) {
    if (pose) this.sliders.forEach((slider, i) => slider.show(pose[i]));
    write(this.turns, turns);
    write(this.touching, touching.text);
    this.touching.dataset.free = String(touching.free);
    if (!inHand || !this.awaitsFocus) return;
    this.awaitsFocus = false;
    this.sliders[0]?.range.focus();
  }
}
