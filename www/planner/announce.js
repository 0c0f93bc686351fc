/** Announces the milestones of runs. */
import { Announcer } from "../app/announcer.js";
import { letters } from "./race/standings.js";

/** @import { Page } from "./page.js" */

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
