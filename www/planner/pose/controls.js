/** The robot's coordinates as sliders and numbers, to pose it without a pointer and exactly. */
import { byId, write } from "../../app/dom.js";
import { slidersOf } from "../../widgets/slider.js";

/** @import { Coordinate } from "../../domain/types.js" */
/** @import { Slider } from "../../widgets/slider.js" */
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
    const values = start ?? coordinates.map(({ low, high }) => (low + high) / 2);
    this.sliders = slidersOf("pose-", coordinates, values, () =>
      this.onPose(this.sliders.map(({ current }) => current)),
    );
    for (const { number } of this.sliders) number.step = "0.01";
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
