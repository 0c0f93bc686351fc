/** Announces milestones: the end of a run, paths found in a race, a collision, the arrival at the goal. */
import { letters } from "./race/standings.js";

/** @import { Page } from "./page.js" */

/** @param {Page} page */
export function watchAnnouncements(page) {
  const last = { end: "", touch: "" };
  let finders = "";
  /** @param {keyof typeof last} kind @param {string} text */
  const announce = (kind, text) => {
    if (text !== last[kind] && text !== "") page.app.announcer.say(text);
    last[kind] = text;
  };
  page.onState((state) => {
    const found = state.clock.isRace
      ? letters(state.lanes.flatMap(({ standing }, i) => (standing.found === null ? [] : [i])))
      : "";
    if (found.length > finders.length) page.app.announcer.say(`${found} found a path.`);
    finders = found;
    const isOver =
      state.settled &&
      !state.inHand &&
      state.lanes.every(({ status }) => status === "solved" || status === "exhausted");
    announce("end", isOver ? state.sentence : "");
    announce("touch", state.arrived ? state.sentence : state.touching.text);
  });
}
