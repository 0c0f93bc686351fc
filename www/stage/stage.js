/**
 * The stage holds the panes, lays them out anew when their size, the screen's pixels or the colours change, and turns a
 * pointer on them into a pose.
 */
import { CSpace } from "./cspace.js";
import { Grip } from "./grip.js";
import { readPalette } from "./palette.js";
import { Workspace } from "./workspace.js";

/** @import { Picture } from "./picture.js" */

export class Stage {
  /**
   * @param {HTMLElement} element          with the figures `#workspace` and `#cspace` inside
   * @param {object} on
   * @param {() => void} on.change         something must be drawn
   * @param {(pose: Float64Array) => void} on.pose   a pointer holds the robot there
   */
  constructor(element, on) {
    this.element = element;
    this.on = on;
    this.workspace = new Workspace(/** @type {HTMLElement} */ (element.querySelector("#workspace")));
    this.cspace = new CSpace(/** @type {HTMLElement} */ (element.querySelector("#cspace")));
    /** @type {Picture | null} */
    this.picture = null;
    this.stale = false;
    new Grip(this.workspace, this.cspace, () => this.picture, on.pose);
    const observer = new ResizeObserver(() => this.relay());
    observer.observe(this.workspace.sheet);
    observer.observe(this.cspace.sheet);
    this.watchRatio();
  }

  /** The panes in use. */
  get panes() {
    return this.cspace.figure.hidden ? [this.workspace] : [this.workspace, this.cspace];
  }

  /** Asks to be told when the number of device pixels a CSS pixel changes. */
  watchRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
      this.relay();
      this.watchRatio();
    }, { once: true });
  }

  /** Everything is to be drawn anew before the next frame. */
  relay() {
    this.stale = true;
    this.on.change();
  }

  /** A new scene. @param {Picture} picture */
  show(picture) {
    this.picture = picture;
    const square = CSpace.fits(picture.scenario);
    this.cspace.figure.hidden = !square;
    this.element.classList.toggle("single", !square);
    this.relay();
  }

  /** A new run of the same scene. */
  restart() {
    for (const pane of this.panes) pane.restart();
    this.on.change();
  }

  /** No glow for those who asked for less motion. @param {boolean} enabled */
  setGlow(enabled) {
    for (const pane of [this.workspace, this.cspace]) pane.glow.enabled = enabled;
  }

  /** What someone who cannot see the canvases should know. @param {string} summary */
  describe(summary) {
    for (const pane of this.panes) {
      const canvas = pane.top.canvas;
      const text = `${pane === this.cspace ? "Configuration space" : "Workspace"}: ${summary}`;
      if (canvas.getAttribute("aria-label") !== text) canvas.setAttribute("aria-label", text);
    }
  }

  /** Is there growth that is not inked yet, or a glow that has not settled? */
  get busy() { return this.stale || this.panes.some((pane) => !pane.caughtUp || pane.glow.alive); }

  /** Has all growth been inked? */
  get caughtUp() { return !this.stale && this.panes.every((pane) => pane.caughtUp); }

  /** Draws one frame. @param {number} now @param {number} until  when to stop inking, on the clock of performance.now() */
  frame(now, until) {
    const picture = this.picture;
    if (!picture) return;
    if (this.stale) {
      this.stale = false;
      const palette = readPalette(this.element);
      for (const pane of this.panes) pane.layout(picture, palette, devicePixelRatio || 1);
    }
    const panes = this.panes;
    const began = performance.now();
    panes.forEach((pane, i) => pane.grow(now, began + ((until - began) * (i + 1)) / panes.length));
    for (const pane of panes) pane.drawTop(now);
  }
}
