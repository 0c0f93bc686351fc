/** A map between a box of the plane (y up) and the CSS pixels of a sheet (y down). */

/** @import { Box } from "../domain/types.js" */
export class View {
  /**
   * @param {Box} box
   * @param {number} width   of the sheet, CSS pixels
   * @param {number} height
   * @param {{ left: number, right: number, top: number, bottom: number }} margin  CSS pixels
   * @param {boolean} stretched  true: fills the sheet, each axis by itself; false: one scale, centred
   */
  constructor(box, width, height, margin, stretched) {
    const innerWidth = Math.max(1, width - margin.left - margin.right);
    const innerHeight = Math.max(1, height - margin.top - margin.bottom);
    let scaleX = innerWidth / Math.max(box.max[0] - box.min[0], 1e-12);
    let scaleY = innerHeight / Math.max(box.max[1] - box.min[1], 1e-12);
    if (!stretched) scaleX = scaleY = Math.min(scaleX, scaleY);
    this.box = box;
    this.width = width;
    this.height = height;
    this.scaleX = scaleX;
    this.scaleY = scaleY;
    this.originX = margin.left + innerWidth / 2 - (scaleX * (box.min[0] + box.max[0])) / 2;
    this.originY = margin.top + innerHeight / 2 + (scaleY * (box.min[1] + box.max[1])) / 2;
  }

  /** Distance of the dots of the grid, in the plane: the least of 1, 2, 5 times a power of ten that is at least 46 pixels. */
  get grid() {
    const least = 46 / this.scaleX;
    const power = 10 ** Math.floor(Math.log10(least));
    return (([1, 2, 5].find((factor) => factor * power >= least)) ?? 10) * power;
  }

  /** @param {number} x */
  x(x) { return this.originX + this.scaleX * x; }

  /** @param {number} y */
  y(y) { return this.originY - this.scaleY * y; }

  /** A point of the plane in CSS pixels. @param {ArrayLike<number>} point @returns {[number, number]} */
  place(point) { return [this.x(point[0]), this.y(point[1])]; }

  /** CSS pixels to the plane. @param {number} px @param {number} py @returns {[number, number]} */
  toPlane(px, py) { return [(px - this.originX) / this.scaleX, (this.originY - py) / this.scaleY]; }
}

/** The view of a sheet that is not drawn yet. */
export const NO_VIEW = new View({ min: [0, 0], max: [1, 1] }, 1, 1, { left: 0, right: 0, top: 0, bottom: 0 }, false);
