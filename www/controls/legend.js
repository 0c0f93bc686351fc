/** The legend names what can be seen just now, and no more. */
import { write } from "./counters.js";
import { byId } from "./dom.js";

/** @import { Page } from "../page.js" */
/** @import { State } from "../types.js" */

/** @param {Page} page @param {State} state */
export function showLegend({ view, calm }, { lanes, growing, hover, touching, isBad }) {
  const [lane] = lanes;
  const [flashes, isSolved] = [growing && !calm, lanes.some(({ status }) => status === "solved")];
  // What is refused stays where it is wanted to, and else flashes while it grows.
  const refuses = view.refused || flashes;
  const seen = {
    guard: lane.hasGuards, newest: flashes, waiting: lane.waiting > 0,
    rejected: refuses && (lane.hasRejected || lane.hasRefused), path: isSolved || lane.isMiss,
    raw: view.raw && lane.raw !== null, poses: view.strobe && (isSolved || lane.isMiss),
    touching: !touching.free || hover?.free === false || isBad,
  };
  for (const [name, isSeen] of Object.entries(seen)) byId(`legend-${name}`, HTMLElement).hidden = !isSeen;
  byId("legend-rejected", HTMLElement).dataset.kinds = `${lane.hasRejected ? "samples " : ""}${lane.hasRefused ? "motions" : ""}`;
  write(byId("legend-growth", HTMLElement), lane.kind);
  const path = byId("legend-path", HTMLElement);
  path.dataset.proven = String(lane.isProven);
  path.dataset.miss = String(lane.isMiss);
  const words = path.querySelector("span");
  if (words) write(words, `${lane.isMiss ? "nearest miss" : "path"}${lane.isProven ? "" : ", not proven"}`);
}
