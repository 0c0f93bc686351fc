/** The door of the fold "How much room": what measures it is loaded when the fold is opened. */
import { byId, make } from "../../app/dom.js";
import { hasSite } from "../../app/site.js";

/** @import { Page } from "./room-panel.js" */

/** What a page in one file says, which has neither the worker nor the core that measures. */
const ALONE =
  "A page in one file does not measure how much room there is: open it on the site, or use planarium widest, planarium safest and planarium route-graph on the command line.";

/** @param {Page} page */
export async function openRoom(page) {
  if (hasSite()) new (await import("./room-panel.js")).RoomPanel(page);
  else byId("room", HTMLElement).append(make("p", { className: "hint" }, ALONE));
}
