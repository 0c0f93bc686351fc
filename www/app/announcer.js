/** Tells milestones to those who listen to the page instead of looking at it, at most one a second and the newest last. */
import { letters } from "../planner/race/standings.js";
import { byId } from "./dom.js";

/** @import { Page } from "../planner/page.js" */

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

/** Milestones: a run's end, the paths found in a race, a touch, an arrival. @param {Page} page */
export function watchAnnouncements(page) {
  const announcer = new Announcer();
  let end = "";
  let touch = "";
  let finders = "";
  page.onState((state) => {
    const found = state.clock.isRace ? letters(state.lanes.flatMap(({ standing }, i) => (standing.found === null ? [] : [i]))) : "";
    if (found.length > finders.length) announcer.say(`${found} found a path.`);
    finders = found;
    const over = state.settled && !state.inHand && state.lanes.every(({ status }) => status === "solved" || status === "exhausted");
    const ending = over ? state.sentence : "";
    if (ending !== end && ending !== "") announcer.say(ending);
    end = ending;
    const touching = state.arrived ? state.sentence : state.touching.free ? "" : state.touching.text;
    if (touching !== touch && touching !== "") announcer.say(touching);
    touch = touching;
  });
}
