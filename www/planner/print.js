/** Lines for the printed page: the scene, the planners with their settings, the time shown, and the link. */
import { byId, grouped, make } from "../app/dom.js";
import { printLink } from "../app/printed-link.js";
import { themeOf } from "../app/theme.js";
import { encodeLink } from "./link/codec.js";
import { experimentOf } from "./link/experiment.js";
import { letter } from "./race/standings.js";
import { FIRST } from "./settings/form.js";

/** @import { Page } from "./page.js" */

/** @param {Page} page */
export function watchPrint(page) {
  const line = make("p", { id: "printed" });
  const stage = byId("stage", HTMLElement);
  printLink(() => experimentOf(page), encodeLink);
  byId("story", HTMLElement).before(line);
  addEventListener("beforeprint", () => {
    line.textContent = lineOf(page);
    // The printed page is light, but the canvases stay as they were drawn.
    stage.style.colorScheme = themeOf(document);
  });
  addEventListener("afterprint", () => stage.style.removeProperty("color-scheme"));
}

/** What was run. @param {Page} page */
export function lineOf({ title, plans: lanes, planners, state }) {
  const plans = lanes.map(({ algorithm, settings }, lane) => {
    const name = lanes.length > 1 ? `${letter(lane)} ${planners.titleOf(algorithm)}` : planners.titleOf(algorithm);
    const values = [...FIRST]
      .filter((one) => settings[one] !== undefined)
      .map((one) => `${one.replaceAll("_", " ")} ${settings[one]}`);
    return [name, ...values].join(", ");
  });
  const now = grouped(state?.clock.now ?? 0);
  return [title, ...plans, state?.clock.isRace ? `${now} clearance evaluations` : `iteration ${now}`].join(" \u00b7 ");
}
