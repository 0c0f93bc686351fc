/**
 * Configurations at equal distances along the path. Time shows in the colour, from start to goal, and in the width of
 * the line, so that colour is not the only sign.
 */
import { disc } from "../../draw/marks.js";

/** @import { PathPlayback } from "./path-playback.js" */
/** @import { Part } from "../../domain/types.js" */
/** @import { Pane } from "./pane.js" */
/**
 * @typedef {{ part: number, parts: Part[], x: number, y: number, colour: string }} Flash   `part`: 0 to 1 along the
 *   path; `x` and `y` in pixels of the pane
 */

export class Strobe {
  /** @param {Pane} pane @param {PathPlayback} playback @param {number} count */
  constructor(pane, playback, count) {
    this.playback = playback;
    this.count = count;
    const { start, goal } = /** @type {import("../../app/palette.js").Palette} */ (pane.palette);
    /** @type {Flash[]} */
    this.flashes = Array.from({ length: count }, (_, i) => {
      const part = (i + 1) / (count + 1);
      const pose = playback.configuration(part);
      const [x, y] = pane.pixels(pose);
      return {
        part,
        parts: playback.scenario.footprint(pose),
        x,
        y,
        colour: `color-mix(in oklab, ${goal} ${100 * part}%, ${start})`,
      };
    });
  }

  /** Those on the part of the path that is drawn. */
  get seen() {
    return this.flashes.filter(({ part }) => part <= this.playback.drawn);
  }

  /**
   * A dot for each configuration, growing along the path.
   * @param {CanvasRenderingContext2D} context
   * @param {string} ground
   */
  draw(context, ground) {
    for (const { part, x, y, colour } of this.seen) {
      context.fillStyle = ground;
      disc(context, x, y, 3.2 + 2.2 * part);
      context.fillStyle = colour;
      disc(context, x, y, 2 + 2.2 * part);
    }
  }
}
