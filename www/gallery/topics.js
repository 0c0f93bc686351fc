/** The topics of the gallery, and the order of entries in each: the best ones, then all others as their files have them. */

/** @import { Entry, Topic } from "./format.js" */

/** @type {{ id: Topic, title: string, about: string, best: string[] }[]} */
const TOPICS = [
  {
    id: "sampling",
    title: "Sampling",
    about: "Random configurations and trajectories: which ones are kept, and where they fall.",
    best: ["sampling-four", "1-trajectories", "4-fig-1", "4-fig-21", "1-time", "3-1-1", "3-2-1"],
  },
  {
    id: "roadmaps",
    title: "Roadmaps",
    about:
      "Probabilistic roadmaps (PRM): how many neighbours and samples they need, how edges are checked, and how they are searched.",
    best: [
      "2-c-space",
      "2-unconnected",
      "1-neighbours",
      "1-searches",
      "1-visibility",
      "roadmaps-thin-wall",
      "5-3r",
      "2-joint-lines",
      "1-prismatic",
      "1-bidirectional",
      "3-2-5-1",
      "1-3r",
      "3-rrt-prm",
      "5-k-jumps",
    ],
  },
  {
    id: "narrow-passages",
    title: "Narrow passages",
    about: "Gaps, traps and shelves, where few samples fall and every planner needs longer.",
    best: ["narrow-samplers", "narrow-trap", "narrow-slot", "narrow-corner", "2-3r", "narrow-doors", "2-clockwise"],
  },
  {
    id: "trees",
    title: "Trees",
    about: "Rapidly-exploring random trees (RRT), from one end or from both.",
    best: ["4-voronoi", "trees-connect", "4-wrap", "4-race", "3-2-4-1", "4-approximate", "4-rrt"],
  },
  {
    id: "optimal-paths",
    title: "Optimal paths",
    about: "Planners whose paths approach the shortest one as they continue.",
    best: ["optimal-star", "optimal-informed", "optimal-batches", "4-prm-star", "4-comparison"],
  },
  {
    id: "cars",
    title: "Cars",
    about: "Robots that cannot move sideways: steering curves, controls, and the models behind them.",
    best: [
      "cars-parking",
      "cars-turn",
      "4-blossom",
      "2-maze-hard",
      "cars-sparse",
      "3-car2",
      "4-euler-trees",
      "3-3-3-1",
    ],
  },
  {
    id: "neighbours",
    title: "Neighbours",
    about: "The nearest configurations: metrics that wrap and metrics that do not, kd-trees, and approximate search.",
    best: ["3-1-2", "4-fig-13", "1-naive-roadmap", "3-2-2-5", "2-annoy", "4-fig-9", "1-approximate", "3-weights"],
  },
  {
    id: "kinematics",
    title: "Kinematics",
    about: "Poses, collisions, motions between two configurations, and inverse kinematics.",
    best: ["1-ik-several", "1-ik-closed", "1-ik-singular", "1-ik-newton", "3-1-3", "2-red", "1-safe", "3-2-3"],
  },
  {
    id: "fleets",
    title: "Fleets",
    about: "Several robots that share a floor: who gives way, and when no order of priorities works.",
    best: [],
  },
  {
    id: "learned-edges",
    title: "Learned edges",
    about: "PRM-RL: a roadmap whose edges a trained policy drives reliably, noise included.",
    best: ["1-prm-rl", "learned-alone", "1-prm-rl-cargo"],
  },
];

/**
 * The topics with their entries, best first.
 * @template {Pick<Entry, "id" | "topic">} E
 * @param {E[]} entries
 */
export function byTopic(entries) {
  return TOPICS.map((topic) => {
    const own = entries.filter((entry) => entry.topic === topic.id);
    const placeOf = (/** @type {E} */ { id }) => topic.best.indexOf(id) + 1 || Infinity;
    return { ...topic, entries: own.sort((a, b) => (placeOf(a) === placeOf(b) ? 0 : placeOf(a) - placeOf(b))) };
  });
}
