/** Guided lessons: a few steps each, each a question about a scene and a planner, a run that answers it, and a sentence or two about the result. */
import { SCENES } from "../scenes/scenes.js";

/** @import { Plan } from "../../domain/types.js" */

/**
 * @typedef {object} LessonStep
 * @property {string} question      asked before the run
 * @property {string[]} choices     two to four
 * @property {number} answer        place of the right choice
 * @property {string} text          what the run has shown: one to three sentences, 160 characters at most
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
    id: "sampling", title: "Sampling a roadmap",
    steps: [
      {
        scene: "stones", iteration: 0,
        question: "What does one point of the configuration space stand for?", choices: ["A position of the tip", "Both joint angles at once", "A point on a link"], answer: 1,
        text: "Each point of the configuration space gives both joint angles. In its grey regions the arm is in collision.",
      },
      {
        iteration: 200,
        question: "Configurations are sampled at random. What happens to those in collision?", choices: ["They are rejected", "They are moved out of collision", "They become vertices too"], answer: 0,
        text: "Configurations in collision are rejected. All others become vertices of the roadmap.",
      },
      {
        settings: { samples: 40 },
        question: "Are 40 samples enough to connect start and goal?", choices: ["Yes", "No"], answer: 1,
        text: "Forty samples are too few here: the roadmap is disconnected, with start and goal in different components.",
      },
      {
        settings: { samples: 260 },
        question: "And 260 samples, with the same planner?", choices: ["A path is found", "There is still no path"], answer: 0,
        text: "With 260 samples start and goal are in the same component, and a path is found.",
      },
      {
        settings: { sampler: "halton" },
        question: "Halton samples are deterministic. How will they be distributed?", choices: ["In clumps, like random samples", "More evenly", "On a regular grid"], answer: 1,
        text: "Halton samples are distributed more evenly than random ones, with fewer clumps and smaller holes.",
      },
    ],
  },
  {
    id: "neighbours", title: "How many neighbours?",
    steps: [
      {
        scene: "stones", settings: { k: 1 },
        question: "k = 1: each vertex is connected to its nearest neighbour only. Is a path found?", choices: ["Yes", "No"], answer: 1,
        text: "With k = 1 the roadmap has dozens of connected components, and there is no path.",
      },
      {
        settings: { k: 4 },
        question: "k = 4: how many components will the roadmap have?", choices: ["One", "A few", "Dozens"], answer: 1,
        text: "With k = 4 few components are left, but start and goal are still in different ones.",
      },
      {
        settings: { k: 9 },
        question: "k = 9: will start and goal be connected?", choices: ["Yes", "No"], answer: 0,
        text: "With k = 9 start and goal are in the same component, and a path is found.",
      },
      {
        settings: { k: 30 },
        question: "k = 30: what changes most?", choices: ["The length of the path", "The number of motions checked", "Hardly anything"], answer: 1,
        text: "With k = 30 the path is hardly shorter, but three times as many motions are checked.",
      },
      {
        algorithm: "prm-star", settings: { samples: 260, seed: 0 },
        question: "PRM* computes k from the number of samples. How does k grow with it?", choices: ["Linearly", "Logarithmically", "Not at all"], answer: 1,
        text: "PRM* takes k proportional to the logarithm of the number of samples. For 260 samples in two dimensions k is 23.",
      },
    ],
  },
  {
    id: "edges", title: "Between two samples",
    steps: [
      {
        scene: "veil",
        question: "Each edge is checked at three points. Will the path be collision-free?", choices: ["Yes", "No"], answer: 1,
        text: "An edge is a whole motion. Checked at only three points, edges jump the thin wall, and so does the path.",
      },
      {
        settings: { edge_samples: 5 },
        question: "And with five checks per edge?", choices: ["The wall is found", "The wall is still missed"], answer: 1,
        text: "With five checks the wall is still missed. The hatched robot shows where the path collides.",
      },
      {
        settings: { edge_samples: 20 },
        question: "And with twenty?", choices: ["The path goes round the back", "The wall is still missed", "No path is found"], answer: 0,
        text: "With twenty checks the wall is found and the path goes round the back. But are twenty enough? There is no way to know.",
      },
      {
        settings: { seed: 17 },
        question: "Twenty checks per edge, another seed. Is the path collision-free?", choices: ["Yes", "No"], answer: 1,
        text: "With this seed it is not: on its way round the back, the arm hits one of the discs.",
      },
      {
        settings: { edge_check: "proven" },
        question: "With continuous collision checking, can another seed give a path that collides?", choices: ["Yes, but rarely", "No"], answer: 1,
        text: "Continuous collision checking proves whole edges collision-free, however small the obstacle: no seed gives a path that collides.",
      },
    ],
  },
  {
    id: "passage", title: "The narrow passage",
    steps: [
      {
        scene: "passage",
        question: "Two rooms and a narrow passage: how many of the 260 samples fall into the passage?", choices: ["Hardly any", "About a tenth", "About a third"], answer: 0,
        text: "Hardly any sample falls into the passage. With this seed they are just enough for a path.",
      },
      {
        settings: { seed: 0 },
        question: "The same planner with another seed: is a path found?", choices: ["Yes", "No"], answer: 1,
        text: "With this seed the roadmap has two components: it covers each room well but does not connect them.",
      },
      {
        settings: { samples: 1200 }, iteration: 3208,
        question: "Will 1,200 samples find a path?", choices: ["Yes", "No"], answer: 0,
        text: "With 1,200 samples a path is found, but most of them only crowd the rooms.",
      },
      {
        settings: { samples: 260, sampler: "gaussian" },
        question: "Back to 260 samples, from the Gaussian sampler. Where will most of them lie?", choices: ["In the middle of the rooms", "Near obstacles", "Anywhere"], answer: 1,
        text: "Gaussian samples lie near obstacles. More of them fall into the passage, and 260 are enough.",
      },
      {
        algorithm: "rrt-connect", settings: { seed: 0 },
        question: "RRT-Connect grows two trees instead of a roadmap. How many iterations will it need?", choices: ["Fewer than 100", "About 1,000", "About 10,000"], answer: 0,
        text: "The two trees meet in the passage after a few dozen iterations; they need not cover the rooms.",
      },
    ],
  },
  {
    id: "pull", title: "The Voronoi bias",
    steps: [
      {
        scene: "open", iteration: 40,
        question: "For each sample, the nearest vertex takes a step towards it. Which vertices are nearest most often?", choices: ["Those close to the root", "Those beside large empty regions", "All equally often"], answer: 1,
        text: "Vertices beside large empty regions are nearest most often, because their Voronoi cells are the largest.",
      },
      {
        iteration: 120,
        question: "How far will the tree reach with a third of its vertices?", choices: ["Across a third of the room", "Across almost the whole room"], answer: 1,
        text: "The Voronoi bias pulls the tree into open space: with a third of its vertices it already spans the room.",
      },
      {
        question: "What will the remaining vertices do?", choices: ["Fill the gaps", "Extend the tree outwards"], answer: 0,
        text: "Only small gaps are left: samples fall close to the tree, and its steps become shorter.",
      },
      {
        settings: { goal_bias: 0.3 },
        question: "With a goal bias of 0.3, how many vertices will the tree need?", choices: ["About a tenth as many", "About half as many", "More than before"], answer: 0,
        text: "The goal replaces three samples in ten, and nothing is in the way: the tree needs about a tenth of the vertices.",
      },
      {
        scene: "trap", settings: { goal_bias: 0.6 }, iteration: 3951,
        question: "In a bug trap: how does a goal bias of 0.6 compare with one of 0.05?", choices: ["It is about twice as fast", "There is little difference", "It takes about twice as long"], answer: 2,
        text: "In a bug trap such greed keeps hitting the wall: it takes twice as long as with a goal bias of 0.05.",
      },
    ],
  },
  {
    id: "trees", title: "One tree or two",
    steps: [
      {
        scene: "thicket", algorithm: "rrt", settings: { step: 0.5, seed: 1 }, iteration: 1608,
        question: "One tree in a four-dimensional space: how many iterations will it need?", choices: ["About 100", "About 1,600", "About 10,000"], answer: 1,
        text: "One tree explores the four-dimensional space until it reaches the goal: 1,608 iterations.",
      },
      {
        scene: "thicket",
        question: "And two trees that grow towards each other?", choices: ["About 150", "About 800", "About 3,000"], answer: 0,
        text: "Two trees need 146 iterations, and their path is shorter.",
      },
      {
        scene: "shelf", algorithm: "rrt", settings: { step: 0.2, seed: 8 }, iteration: 12010,
        question: "The goal is deep in a shelf. How many iterations will one tree need?", choices: ["About 200", "About 1,600", "More than 12,000"], answer: 2,
        text: "A goal deep in a shelf is hard to reach from outside: one tree needs more than 12,000 iterations.",
      },
      {
        scene: "shelf",
        question: "And with a tree at each end?", choices: ["About 170", "About 1,600", "About 6,000"], answer: 0,
        text: "From inside the shelf it is easy to get out: with a tree at each end, 172 iterations are enough.",
      },
      {
        scene: "trap", algorithm: "rrt-connect", settings: { step: 0.1, seed: 5 },
        question: "In the bug trap, how much faster are two trees than one?", choices: ["Not at all", "About twice as fast", "About ten times as fast"], answer: 1,
        text: "In the bug trap two trees are only about twice as fast as one: one of them still has to find the mouth.",
      },
    ],
  },
  {
    id: "reach", title: "A goal for the tip",
    steps: [
      {
        scene: "pick", iteration: 0,
        question: "The goal is the crosshair, a point for the tip. How many configurations reach it?", choices: ["Only one", "Two", "More than two"], answer: 2,
        text: "Inverse kinematics finds eight configurations that reach the crosshair. They are drawn faint.",
      },
      {
        question: "Two trees: at which of the eight configurations will the path end?", choices: ["The one nearest to the start", "The one whose branch meets the first tree"], answer: 1,
        text: "All eight are roots of the second tree. The one whose branch meets the first tree is the goal: 254 iterations.",
      },
      {
        algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 },
        question: "In a roadmap all eight are vertices. How many searches are needed?", choices: ["One", "Eight"], answer: 0,
        text: "One search is enough: it ends at the one of the eight that is nearest along the roadmap.",
      },
      {
        algorithm: "rrt", settings: { step: 0.3, seed: 3 }, iteration: 1441,
        question: "One tree tries the eight in turn. Is it faster than two trees?", choices: ["Yes", "No"], answer: 1,
        text: "One tree needs 1,441 iterations, because a goal in a shelf is hard to reach from outside.",
      },
    ],
  },
  {
    id: "wheels", title: "Car-like robots",
    steps: [
      {
        scene: "turn",
        question: "A car cannot move sideways. What do the edges of its tree look like?", choices: ["Straight lines", "Curves that the car can drive"], answer: 1,
        text: "Each edge is a Reeds-Shepp curve: the shortest that the car can drive, forward and backward.",
      },
      {
        settings: { steering: "dubins", max_iterations: 250 },
        question: "Without a reverse gear, along Dubins curves: will the car turn round?", choices: ["Yes, on a longer path", "No"], answer: 1,
        text: "Without a reverse gear the same tree finds no path: the road is too narrow.",
      },
      {
        scene: "blossom", settings: { blossom: 1 }, iteration: 1916,
        question: "Now each extension applies one random control for a while. How many iterations will it take?", choices: ["About 200", "About 2,000", "About 20,000"], answer: 1,
        text: "Without steering curves, with one random control per extension, it takes 1,916 iterations.",
      },
      {
        settings: { blossom: 3 },
        question: "Three controls per extension, of which the best is kept: how many iterations?", choices: ["About 350", "About 2,000", "About 6,000"], answer: 0,
        text: "With three controls per extension, of which the one that ends closest to the sample is kept, it takes 354 iterations.",
      },
      {
        settings: { blossom: 5 }, iteration: 1073,
        question: "And five controls per extension?", choices: ["Fewer iterations", "More iterations"], answer: 1,
        text: "Five controls per extension do not help here: 1,073 iterations. But the path is a little shorter.",
      },
    ],
  },
];

/**
 * The iteration that is shown while a step asks: where the run of the step before rests, if it is the same run, else 0.
 * @param {Lesson} lesson
 * @param {number} at   from 0
 */
export function beginningOf(lesson, at) {
  const { iteration } = lesson.steps[at - 1] ?? {};
  return iteration !== undefined && JSON.stringify(stageAt(lesson, at)) === JSON.stringify(stageAt(lesson, at - 1)) ? iteration : 0;
}

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
