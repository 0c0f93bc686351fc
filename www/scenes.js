/** The page's own scenes, in the order of a first lesson. */

/** @import { SceneEntry } from "./types.js" */

/** @type {SceneEntry[]} */
export const SCENES = [
  {
    id: "stones", title: "Two links among stones", algorithm: "prm", pace: 130, settings: { samples: 260, k: 9, seed: 0 },
    story: "Each point is a pose that touches nothing, each line a motion proven free: a map grows.",
  },
  {
    id: "firs", title: "A clearing of firs", algorithm: "rrt-connect", pace: 14, settings: { step: 0.35, seed: 7 },
    story: "Two trees, rooted at the start and at the goal, reach for each other until they meet.",
  },
  {
    id: "shelf", title: "Into the shelf", algorithm: "rrt-connect", pace: 30, settings: { step: 0.2, seed: 8 },
    story: "Three links must draw back out of one compartment before they can enter the next.",
  },
  {
    id: "thicket", title: "Four links in a thicket", algorithm: "rrt-connect", pace: 22, settings: { step: 0.5, seed: 1 },
    story: "Four joints span a space that nobody can draw; two trees find their way through it.",
  },
  {
    id: "rings", title: "A disc in the rings", algorithm: "prm", pace: 300, settings: { samples: 900, k: 9, seed: 14 },
    story: "Every line is a way that the whole disc fits through; one leads inwards, gate by gate.",
  },
  {
    id: "locked", title: "No way round", algorithm: "prm", pace: 150, settings: { samples: 300, k: 9, seed: 1 },
    story: "Joint limits close the way round: the map fills two rooms that no motion connects.",
  },
];
