/** Tells milestones to those who listen to the page instead of looking at it, at most one a second and the newest last. */
import { byId } from "./dom.js";

/** Milliseconds between two announcements. */
const PAUSE = 1000;

export class Announcer {
  constructor() {
    this.element = byId("announcer", HTMLElement);
    this.last = -Infinity;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
  }

  /** @param {string} text */
  say(text) {
    clearTimeout(this.timer);
    const wait = Math.max(0, this.last + PAUSE - performance.now());
    this.timer = setTimeout(() => {
      this.last = performance.now();
      this.element.textContent = text;
    }, wait);
  }
}
