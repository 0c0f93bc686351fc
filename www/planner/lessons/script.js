/** Guided lessons: a few steps each, every one a scene with a planner at work and a sentence or two about it. */
import { SCENES } from "../scenes/scenes.js";

/** @import { Plan } from "../../domain/types.js" */

/**
 * @typedef {object} LessonStep
 * @property {string} text          one or two sentences, 160 characters at most
 * @property {string} [scene]       this scene, with its own planner and settings; else that of the step before
 * @property {string} [algorithm]   another planner than there was, with no settings but those below
 * @property {Plan["settings"]} [settings]   laid over the scene's, or over those of the step before
 * @property {number} [iteration]   where the run rests, at its end where that would take long to watch; else it runs to its end
 *
 * @typedef {object} Lesson
 * @property {string} id
 * @property {string} title
 * @property {LessonStep[]} steps   five at most; the first has a scene
 */

/** @type {Lesson[]} */
export const LESSONS = [
  {
    id: "sampling", title: "A map from chance",
    steps: [
      { scene: "stones", iteration: 0, text: "The square holds every pose of the arm: one joint across, one up. In its grey parts the arm touches something." },
      { iteration: 200, text: "Poses are drawn by chance. Those that touch something are rejected, all others become vertices of a map." },
      { settings: { samples: 40 }, text: "Forty vertices are too few here: the map stays in pieces, with start and goal in different ones." },
      { settings: { samples: 260 }, text: "With 260 vertices the same planner finds a path: the map now reaches round every stone on the way." },
      { settings: { sampler: "halton" }, text: "Halton samples follow a rule instead of chance. They fall more evenly, with fewer clumps and smaller holes." },
    ],
  },
  {
    id: "neighbours", title: "How many neighbours?",
    steps: [
      { scene: "stones", settings: { k: 1 }, text: "Each vertex is joined to its nearest neighbour alone. The map falls into dozens of pieces, and there is no path." },
      { settings: { k: 4 }, text: "With four neighbours few pieces are left, but start and goal are still in different ones." },
      { settings: { k: 9 }, text: "With nine the pieces that matter have grown together, and a path is found." },
      { settings: { k: 30 }, text: "With thirty the path is hardly shorter, but three times as many motions had to be checked." },
      { algorithm: "prm-star", settings: { samples: 260, seed: 0 }, text: "PRM* takes their number from a rule: it grows slowly with the samples, and here it is 23." },
    ],
  },
  {
    id: "edges", title: "What is between two poses",
    steps: [
      { scene: "veil", text: "An edge is a whole motion. Here three places of it are looked at, and the path goes through the wall." },
      { settings: { edge_samples: 5 }, text: "With five places the wall is still missed. Watch where the path turns out to collide." },
      { settings: { edge_samples: 20 }, text: "Twenty places see the wall, and the path goes round the back. Whether twenty are enough, nobody knows." },
      { settings: { seed: 17 }, text: "With another seed they are not: on its way round the back, the arm clips one of the discs." },
      { settings: { edge_check: "proven" }, text: "A proven edge is free all along, however thin or small what is in the way: whatever the seed, nothing is touched." },
    ],
  },
  {
    id: "passage", title: "The narrow passage",
    steps: [
      { scene: "passage", text: "Samples fill both rooms, but hardly any falls into the passage. This time it was enough for a path." },
      { settings: { seed: 0 }, text: "Another seed, and the map falls in two: each room is known well, the way between them is not." },
      { settings: { samples: 1200 }, iteration: 3208, text: "Four times as many samples do it, but most of them only crowd the rooms." },
      { settings: { samples: 260, sampler: "gaussian" }, text: "Gaussian samples stay near obstacles. More of them fall into the passage, and 260 are enough." },
      { algorithm: "rrt-connect", settings: { seed: 0 }, text: "Two trees need no map of the rooms: they meet in the passage after a few dozen iterations." },
    ],
  },
  {
    id: "pull", title: "The pull into the open",
    steps: [
      { scene: "open", iteration: 40, text: "For each sample the nearest vertex takes a step towards it. Vertices beside large empty places are nearest most often." },
      { iteration: 120, text: "So the tree is pulled into the open: with a third of its vertices it already spans the room." },
      { text: "What is left are small gaps: samples fall close to the tree, and its steps become shorter." },
      { settings: { goal_bias: 0.3 }, text: "Now the goal takes the place of three samples in ten: the tree needs about a tenth of the vertices." },
      { scene: "trap", settings: { goal_bias: 0.6 }, iteration: 3951, text: "In a trap such haste runs into the wall again and again: it takes twice as long as a goal bias of 0.05." },
    ],
  },
  {
    id: "trees", title: "One tree or two",
    steps: [
      { scene: "thicket", algorithm: "rrt", settings: { step: 0.5, seed: 1 }, iteration: 1608, text: "One tree spreads through the space of four joints until it comes upon the goal: 1,608 iterations." },
      { scene: "thicket", text: "Two trees reach for each other as far as they get: 146 iterations, and a shorter path." },
      { scene: "shelf", algorithm: "rrt", settings: { step: 0.2, seed: 8 }, iteration: 12010, text: "A goal deep in a shelf is hard to come upon: one tree needs more than 12,000 iterations." },
      { scene: "shelf", text: "From inside it is easy to find out: with a tree at each end, 172 iterations do." },
      { scene: "trap", algorithm: "rrt-connect", settings: { step: 0.1, seed: 5 }, text: "In the bug trap two trees are only twice as quick as one: somebody still has to find the mouth." },
    ],
  },
  {
    id: "reach", title: "A place, not a pose",
    steps: [
      { scene: "pick", iteration: 0, text: "The crosshair is where the hand is to be. Eight faint poses put it there: inverse kinematics has found them." },
      { text: "Each of them is a root of the second tree. Whichever the first tree meets is the goal: 254 iterations." },
      { algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 }, text: "In a map all eight are vertices, and one search ends at the one that is nearest along the map." },
      { algorithm: "rrt", settings: { step: 0.3, seed: 3 }, iteration: 1441, text: "One tree reaches for each in turn. It takes 1,441 iterations, as a goal in a shelf is hard to come upon." },
    ],
  },
  {
    id: "wheels", title: "What wheels can do",
    steps: [
      { scene: "turn", text: "A car goes where its wheels point. Its edges are Reeds-Shepp curves: the shortest there are, forward and backward." },
      { settings: { steering: "dubins", max_iterations: 250 }, text: "Without a reverse gear, along Dubins curves, the same tree never gets round: the road is too narrow." },
      { scene: "blossom", settings: { blossom: 1 }, iteration: 1857, text: "Or nobody computes curves: a control drawn by chance is held for a while. With one try each it takes 1,857 iterations." },
      { settings: { blossom: 3 }, text: "With three tries, of which the one that comes closest to the sample stays, 296 iterations do." },
      { settings: { blossom: 5 }, iteration: 1073, text: "Five tries cost more than they help here: 1,073 iterations. But the path is a little shorter." },
    ],
  },
];

/**
 * What is on the stage at a step, all steps before it taken into account.
 * @param {Lesson} lesson
 * @param {number} at   from 0
 * @returns {Plan & { scene: string }}
 */
export function stageAt({ steps }, at) {
  let stage = { scene: "", algorithm: "", settings: {} };
  for (const { scene, algorithm, settings } of steps.slice(0, at + 1)) {
    const entry = scene ? SCENES.find(({ id }) => id === scene) : null;
    if (entry) stage = { scene: entry.id, algorithm: entry.algorithm, settings: entry.settings };
    if (algorithm) stage = { ...stage, algorithm, settings: {} };
    stage = { ...stage, settings: { ...stage.settings, ...settings } };
  }
  return stage;
}
