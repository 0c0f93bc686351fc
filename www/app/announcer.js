/** Announces milestones to screen readers, at most one a second. */
import { byId } from "./dom.js";
import { paced } from "./paced.js";

/** Milliseconds between two announcements. */
const PAUSE = 1000;

export class Announcer {
  constructor() {
    const element = byId("announcer", HTMLElement);
    this.say = paced(PAUSE, (/** @type {string} */ text) => { element.textContent = text; });
  }
}
