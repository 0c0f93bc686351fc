/** Ready fleets: what generates each, and what to see in it. The first one is there at first. */

/** @import { FleetGeneratorId } from "planarium/full" */
/** @import { Settings } from "../domain/types.js" */

/** @typedef {{ kind: FleetGeneratorId, options: Settings }} Generated   options that differ from the defaults */
/** @typedef {Generated & { id: string, title: string, what: string }} Entry */

/** @type {Entry[]} */
export const SCENES = [
  {
    id: "ring",
    title: "Ring",
    kind: "ring",
    options: { count: 12 },
    what: "Every robot goes to the other side of the ring. In the middle all would meet: the first goes straight, the others turn aside or wait.",
  },
  {
    id: "swap",
    title: "Swap",
    kind: "swap",
    options: {},
    what: "Two robots in a corridor change places; the bay lets one step aside before the other passes. Put into an order, neither can go first: the other stands in its way.",
  },
  {
    id: "exchange",
    title: "Exchange",
    kind: "ring",
    options: { count: 8, exchange: true },
    what: "Each robot goes to the place of the next. No goal is free before another robot leaves it, so no order of priorities works; all leave at once.",
  },
  {
    id: "crossroads",
    title: "Crossroads",
    kind: "crossroads",
    options: {},
    what: "Robots cross from four sides, and some of them wait. Plan robot 3 first, and all are there sooner; plan robot 8 first, and there is no plan: another one stands before it.",
  },
  {
    id: "corridor",
    title: "Corridor",
    kind: "corridor",
    options: {},
    what: "The corridor lets one robot pass at a time. Those from the other side wait until it is free.",
  },
  {
    id: "crowd",
    title: "A hundred discs",
    kind: "hall",
    options: { count: 100 },
    what: "A hundred discs share one roadmap. Each is planned for around all those before it.",
  },
  {
    id: "bodies",
    title: "Rectangles",
    kind: "ring",
    options: { count: 8, shape: "rectangle", pillar: 0.6 },
    what: "Bodies turn as they go. That no two of them touch is proven between all moments, not only at some.",
  },
];
