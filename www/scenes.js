/** The page's own scenes, in the order of a first lesson. */

/** @typedef {import("./types.js").SceneEntry} SceneEntry */

/** @type {SceneEntry[]} */
export const SCENES = [
  {
    id: "stones", title: "Two links among stones", algorithm: "prm", pace: 110, settings: { samples: 320, k: 9, seed: 4 },
    story: "Each point is a pose of the arm that touches nothing, each line a motion proven free; together they become a map.",
  },
  {
    id: "firs", title: "A clearing of firs", algorithm: "rrt-connect", pace: 14, settings: { step: 0.35, seed: 3 },
    story: "Two trees, one rooted at the start and one at the goal, grow towards each other until they meet.",
  },
  {
    id: "shelf", title: "Into the shelf", algorithm: "rrt-connect", pace: 30, settings: { step: 0.3, seed: 2 },
    story: "Three links have to come out of one compartment before they can go into the next.",
  },
  {
    id: "thicket", title: "Four links in a thicket", algorithm: "rrt-connect", pace: 30, settings: { step: 0.5, seed: 1 },
    story: "Four joints make a space nobody can draw; the tree finds its way through it all the same.",
  },
  {
    id: "rings", title: "A disc in the rings", algorithm: "rrt-connect", pace: 40, settings: { step: 0.25, seed: 1 },
    story: "A disc looks for the gates of five walls: every line is as wide as the disc, and proven clear.",
  },
  {
    id: "locked", title: "No way round", algorithm: "prm", pace: 160, settings: { samples: 350, k: 9, seed: 1 },
    story: "Joint limits close the way round: the roadmap fills two rooms that no motion connects.",
  },
];
