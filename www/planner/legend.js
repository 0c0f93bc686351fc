/** The legend of the stage. */
import { byId, write } from "../app/dom.js";

/** @import { Page } from "./page.js" */
/** @import { LaneState } from "./run-log/lane-state.js" */
/** @import { State } from "./state.js" */

/** @param {Page} page @param {State} state */
export function showLegend(
  { calm, session: { shown } },
  { lanes, view, growing, playing, clock, hover, touching, isBad, certificate, pose },
) {
  const map = shown?.world?.map;
  const some = (/** @type {(lane: LaneState) => boolean} */ is) => lanes.some(is);
  const waits = growing && !playing && clock.now > 0;
  const flashes = growing && !calm;
  const hasPath = some(({ status, isMiss }) => status === "solved" || isMiss);
  // Trees that go on after their first path show their best one.
  const hasBest = some(({ kind, cost }) => kind !== "roadmap" && cost < Infinity);
  const samples = some(({ hasRejected }) => hasRejected);
  const motions = some(({ hasRefused }) => hasRefused);
  const seen = {
    robot: pose !== null,
    obstacle: !map && shown !== null && shown.document.world.obstacles.length > 0,
    map: Boolean(map),
    unknown: Boolean(map?.hasUnknown),
    guard: some(({ hasGuards }) => hasGuards),
    newest: flashes || waits,
    waiting: some(({ waiting }) => waiting > 0),
    // Rejected elements are shown by the view option, or flash while the graph grows.
    rejected: (view.refused || flashes || waits) && (samples || motions),
    path: hasPath || hasBest,
    poses: hasPath && view.strobe,
    regions: view.regions && some(({ kind }) => kind !== "roadmap"),
    informed: some(({ isInformed }) => isInformed),
    piece: some(({ isApart }) => isApart),
    searched: some(({ isSearched }) => isSearched),
    optimum: view.optimum && some(({ optimum }) => optimum !== null),
    blocked: certificate !== null,
    free: certificate !== null,
    raw: view.raw && some(({ raw }) => raw !== null),
    touching: !touching.free || hover?.free === false || isBad,
  };
  for (const [name, isSeen] of Object.entries(seen)) byId(`legend-${name}`, HTMLElement).hidden = !isSeen;
  byId("legend-rejected", HTMLElement).dataset.kinds = `${samples ? "samples " : ""}${motions ? "motions" : ""}`;
  const kinds = [...new Set(lanes.map(({ kind }) => kind))];
  byId("legend-growth-row", HTMLElement).dataset.kind = kinds.find((kind) => kind === "trees") ?? kinds[0];
  write(
    byId("legend-growth", HTMLElement),
    kinds.filter((kind) => kind !== "tree" || !kinds.includes("trees")).join(", "),
  );
  write(
    byId("legend-optimum-name", HTMLElement),
    some(({ optimum }) => optimum === "reference") ? "reference" : "shortest path",
  );
  const path = byId("legend-path", HTMLElement);
  const isProven = some((lane) => lane.isProven);
  const isMiss = lanes.every((lane) => lane.isMiss);
  path.dataset.proven = String(isProven);
  path.dataset.miss = String(isMiss);
  const also = [
    !isMiss && some((lane) => lane.isMiss) ? "dashed: closest approach" : "",
    lanes.every((lane) => lane.isProven) ? "" : isProven ? "hollow: not proven" : "not proven",
  ];
  const words = path.querySelector("span");
  if (words) write(words, [isMiss ? "closest approach" : "path", ...also].filter(Boolean).join(", "));
}
