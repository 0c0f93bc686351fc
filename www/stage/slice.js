/**
 * The obstacles on a square of two joints, the others held still: poses tested one by one on a grid, first a coarse one, then
 * a fine one, as much as a frame has time for.
 */

/** @import { Scenario } from "../types.js" */
/** @import { View } from "./view.js" */

/** Cells a side, of the first picture and of the last. */
const SIDES = [24, 96];

export class Slice {
  /** @param {Scenario} scenario @param {ArrayLike<number>} pose  the others are held as here @param {[number, number]} axes @param {View["box"]} box  of the two */
  constructor(scenario, pose, axes, box) {
    this.scenario = scenario;
    this.pose = Float64Array.from(pose);
    this.axes = axes;
    this.box = box;
    this.key = keyOf(pose, axes);
    this.level = 0;
    this.mask = new Uint8Array(SIDES[0] ** 2);
    this.next = 0;
  }

  get side() { return SIDES[this.level]; }

  /** Is the last picture made? */
  get isDone() { return this.level === SIDES.length; }

  /** Goes on testing until the clock passes `until`. @param {number} until @returns {{ side: number, mask: Uint8Array } | null} a picture that is complete: rows from the lowest angles, 1 is collision */
  advance(until) {
    const { scenario, pose, axes: [across, up], box: { min, max }, side, mask } = this;
    while (this.next < mask.length && performance.now() < until) {
      pose[across] = min[0] + ((max[0] - min[0]) * ((this.next % side) + 0.5)) / side;
      pose[up] = min[1] + ((max[1] - min[1]) * (Math.floor(this.next / side) + 0.5)) / side;
      mask[this.next++] = scenario.check(pose).free ? 0 : 1;
    }
    if (this.next < mask.length) return null;
    this.level++;
    this.next = 0;
    if (!this.isDone) this.mask = new Uint8Array(this.side ** 2);
    return { side, mask };
  }
}

/** What a slice depends on. @param {ArrayLike<number>} pose @param {[number, number]} axes */
export function keyOf(pose, axes) { return Array.from(pose, (value, j) => (axes.includes(j) ? "" : value)).join(); }
