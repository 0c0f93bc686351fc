/** The door of the fold "Timing": what times paths is loaded when the fold is opened. */
import { byId, make } from "../../app/dom.js";
import { hasSite } from "../../app/site.js";

/** @import { Page, TimingPanel } from "./timing-panel.js" */

/** What a page in one file says, which has neither the worker nor the core that times. */
const ALONE = "A page in one file does not time paths: open it on the site, or use planarium time on the command line.";

/** @param {Page} page @returns {Promise<TimingPanel | null>} null: the page cannot time paths, and says so */
export async function openTiming(page) {
  if (hasSite()) return new (await import("./timing-panel.js")).TimingPanel(page);
  byId("timing", HTMLElement).append(make("p", { className: "hint" }, ALONE));
  return null;
}
