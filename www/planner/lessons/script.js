/**
 * Guided lessons. Each step asks a question about a scene and a planner; a run and a sentence or two give the answer.
 */
import { SCENES } from "../scenes/scenes.js";

/** @import { Settings, Plan } from "../../domain/types.js" */

/**
 * @typedef {object} Setup   the run of a step
 * @property {string} [scene]       with its own planner and settings; absent for the previous step's
 * @property {string} [algorithm]   another planner, with the settings below only
 * @property {Settings} [settings]   added to those of the scene or of the previous step
 * @property {number} [iteration]   at which the run pauses; absent for its end
 *
 * @typedef {Setup & { question: string, choices: string[], answer: number, text: string }} LessonStep   `answer` is an
 *   index of `choices`
 * @typedef {{ id: string, title: string, steps: LessonStep[] }} Lesson   the first step has a scene
 */

/** @param {string} id @param {string} title @param {...LessonStep} steps @returns {Lesson} */
const lesson = (id, title, ...steps) => ({ id, title, steps });

/**
 * @param {Setup} setup
 * @param {string} question
 * @param {string[]} choices
 * @param {number} answer
 * @param {string} text  after the run
 * @returns {LessonStep}
 */
const step = (setup, question, choices, answer, text) => ({ ...setup, question, choices, answer, text });

export const LESSONS = [
  lesson(
    "sampling",
    "Sampling a roadmap",
    step(
      { scene: "stones", iteration: 0 },
      "What does one point of the configuration space stand for?",
      ["A position of the tip", "Both joint angles at once", "A point on a link"],
      1,
      "Each point of the configuration space gives both joint angles. In its grey regions the arm is in collision.",
    ),
    step(
      { iteration: 200 },
      "Configurations are sampled at random. What happens to those in collision?",
      ["They are rejected", "They are moved out of collision", "They become vertices too"],
      0,
      "Configurations in collision are rejected. All others become vertices of the roadmap.",
    ),
    step(
      { settings: { samples: 40 } },
      "Are 40 samples enough to connect start and goal?",
      ["Yes", "No"],
      1,
      "Forty samples are too few here: the roadmap is disconnected, with start and goal in different components.",
    ),
    step(
      { settings: { samples: 260 } },
      "And 260 samples, with the same planner?",
      ["A path is found", "There is still no path"],
      0,
      "With 260 samples start and goal are in the same component, and a path is found.",
    ),
    step(
      { settings: { sampler: "halton" } },
      "Halton samples are deterministic. How will they be distributed?",
      ["In clumps, like random samples", "More evenly", "On a regular grid"],
      1,
      "Halton samples are distributed more evenly than random ones, with fewer clumps and smaller holes.",
    ),
  ),
  lesson(
    "neighbours",
    "How many neighbours?",
    step(
      { scene: "stones", settings: { k: 1 } },
      "k = 1: each vertex is connected to its nearest neighbour only. Is a path found?",
      ["Yes", "No"],
      1,
      "With k = 1 the roadmap has dozens of connected components, and there is no path.",
    ),
    step(
      { settings: { k: 4 } },
      "k = 4: how many components will the roadmap have?",
      ["One", "A few", "Dozens"],
      1,
      "With k = 4 few components are left, but start and goal are still in different ones.",
    ),
    step(
      { settings: { k: 9 } },
      "k = 9: will start and goal be connected?",
      ["Yes", "No"],
      0,
      "With k = 9 start and goal are in the same component, and a path is found.",
    ),
    step(
      { settings: { k: 30 } },
      "k = 30: what changes most?",
      ["The length of the path", "The number of motions checked", "Hardly anything"],
      1,
      "With k = 30 the path is hardly shorter, but three times as many motions are checked.",
    ),
    step(
      { algorithm: "prm-star", settings: { samples: 260, seed: 0 } },
      "PRM* computes k from the number of samples. How does k grow with it?",
      ["Linearly", "Logarithmically", "Not at all"],
      1,
      "PRM* takes k proportional to the logarithm of the number of samples. For 260 samples in two dimensions k is 23.",
    ),
  ),
  lesson(
    "edges",
    "Between two samples",
    step(
      { scene: "veil" },
      "Each edge is checked at three points. Will the path be collision-free?",
      ["Yes", "No"],
      1,
      "An edge is a whole motion. Checked at only three points, edges jump the thin wall, and so does the path.",
    ),
    step(
      { settings: { edge_samples: 5 } },
      "And with five checks per edge?",
      ["The wall is found", "The wall is still missed"],
      1,
      "With five checks the wall is still missed. The hatched robot shows where the path collides.",
    ),
    step(
      { settings: { edge_samples: 20 } },
      "And with twenty?",
      ["The path goes round the back", "The wall is still missed", "No path is found"],
      0,
      "With twenty checks the wall is found and the path goes round the back. But are twenty enough? There is no way to know.",
    ),
    step(
      { settings: { seed: 17 } },
      "Twenty checks per edge, another seed. Is the path collision-free?",
      ["Yes", "No"],
      1,
      "With this seed it is not: on its way round the back, the arm hits one of the discs.",
    ),
    step(
      { settings: { edge_check: "proven" } },
      "With continuous collision checking, can another seed give a path that collides?",
      ["Yes, but rarely", "No"],
      1,
      "Continuous collision checking proves whole edges collision-free, however small the obstacle: no seed gives a path that collides.",
    ),
  ),
  lesson(
    "passage",
    "The narrow passage",
    step(
      { scene: "passage" },
      "Two rooms and a narrow passage: how many of the 260 samples fall into the passage?",
      ["Hardly any", "About a tenth", "About a third"],
      0,
      "Hardly any sample falls into the passage. With this seed they are just enough for a path.",
    ),
    step(
      { settings: { seed: 0 } },
      "The same planner with another seed: is a path found?",
      ["Yes", "No"],
      1,
      "With this seed the roadmap has two components: it covers each room well but does not connect them.",
    ),
    step(
      { settings: { samples: 1200 }, iteration: 3208 },
      "Will 1,200 samples find a path?",
      ["Yes", "No"],
      0,
      "With 1,200 samples a path is found, but most of them only crowd the rooms.",
    ),
    step(
      { settings: { samples: 260, sampler: "gaussian" } },
      "Back to 260 samples, from the Gaussian sampler. Where will most of them lie?",
      ["In the middle of the rooms", "Near obstacles", "Anywhere"],
      1,
      "Gaussian samples lie near obstacles. More of them fall into the passage, and 260 are enough.",
    ),
    step(
      { algorithm: "rrt-connect", settings: { seed: 0 } },
      "RRT-Connect grows two trees instead of a roadmap. How many iterations will it need?",
      ["Fewer than 100", "About 1,000", "About 10,000"],
      0,
      "The two trees meet in the passage after a few dozen iterations; they need not cover the rooms.",
    ),
  ),
  lesson(
    "pull",
    "The Voronoi bias",
    step(
      { scene: "open", iteration: 40 },
      "For each sample, the nearest vertex takes a step towards it. Which vertices are nearest most often?",
      ["Those close to the root", "Those beside large empty regions", "All equally often"],
      1,
      "Vertices beside large empty regions are nearest most often, because their Voronoi cells are the largest.",
    ),
    step(
      { iteration: 120 },
      "How far will the tree reach with a third of its vertices?",
      ["Across a third of the room", "Across almost the whole room"],
      1,
      "The Voronoi bias pulls the tree into open space: with a third of its vertices it already spans the room.",
    ),
    step(
      {},
      "What will the remaining vertices do?",
      ["Fill the gaps", "Extend the tree outwards"],
      0,
      "Only small gaps are left: samples fall close to the tree, and its steps become shorter.",
    ),
    step(
      { settings: { goal_bias: 0.3 } },
      "With a goal bias of 0.3, how many vertices will the tree need?",
      ["About a tenth as many", "About half as many", "More than before"],
      0,
      "The goal replaces three samples in ten, and nothing is in the way: the tree needs about a tenth of the vertices.",
    ),
    step(
      { scene: "trap", settings: { goal_bias: 0.6 }, iteration: 3951 },
      "In a bug trap: how does a goal bias of 0.6 compare with one of 0.05?",
      ["It is about twice as fast", "There is little difference", "It takes about twice as long"],
      2,
      "In a bug trap such greed keeps hitting the wall: it takes twice as long as with a goal bias of 0.05.",
    ),
  ),
  lesson(
    "trees",
    "One tree or two",
    step(
      { scene: "thicket", algorithm: "rrt", settings: { step: 0.5, seed: 1 }, iteration: 1608 },
      "One tree in a four-dimensional space: how many iterations will it need?",
      ["About 100", "About 1,600", "About 10,000"],
      1,
      "One tree explores the four-dimensional space until it reaches the goal: 1,608 iterations.",
    ),
    step(
      { scene: "thicket" },
      "And two trees that grow towards each other?",
      ["About 150", "About 800", "About 3,000"],
      0,
      "Two trees need 146 iterations, and their path is shorter.",
    ),
    step(
      { scene: "shelf", algorithm: "rrt", settings: { step: 0.2, seed: 8 }, iteration: 12010 },
      "The goal is deep in a shelf. How many iterations will one tree need?",
      ["About 200", "About 1,600", "More than 12,000"],
      2,
      "A goal deep in a shelf is hard to reach from outside: one tree needs more than 12,000 iterations.",
    ),
    step(
      { scene: "shelf" },
      "And with a tree at each end?",
      ["About 170", "About 1,600", "About 6,000"],
      0,
      "From inside the shelf it is easy to get out: with a tree at each end, 172 iterations are enough.",
    ),
    step(
      { scene: "trap", algorithm: "rrt-connect", settings: { step: 0.1, seed: 5 } },
      "In the bug trap, how much faster are two trees than one?",
      ["Not at all", "About twice as fast", "About ten times as fast"],
      1,
      "In the bug trap two trees are only about twice as fast as one: one of them still has to find the mouth.",
    ),
  ),
  lesson(
    "reach",
    "A goal for the tip",
    step(
      { scene: "pick", iteration: 0 },
      "The goal is the crosshair, a point for the tip. How many configurations reach it?",
      ["Only one", "Two", "More than two"],
      2,
      "Inverse kinematics finds eight configurations that reach the crosshair. They are drawn faint.",
    ),
    step(
      {},
      "Two trees: at which of the eight configurations will the path end?",
      ["The one nearest to the start", "The one whose branch meets the first tree"],
      1,
      "All eight are roots of the second tree. The one whose branch meets the first tree is the goal: 254 iterations.",
    ),
    step(
      { algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 } },
      "In a roadmap all eight are vertices. How many searches are needed?",
      ["One", "Eight"],
      0,
      "One search is enough: it ends at the one of the eight that is nearest along the roadmap.",
    ),
    step(
      { algorithm: "rrt", settings: { step: 0.3, seed: 3 }, iteration: 1441 },
      "One tree tries the eight in turn. Is it faster than two trees?",
      ["Yes", "No"],
      1,
      "One tree needs 1,441 iterations, because a goal in a shelf is hard to reach from outside.",
    ),
  ),
  lesson(
    "wheels",
    "Car-like robots",
    step(
      { scene: "turn" },
      "A car cannot move sideways. What do the edges of its tree look like?",
      ["Straight lines", "Curves that the car can drive"],
      1,
      "Each edge is a Reeds-Shepp curve: the shortest that the car can drive, forward and backward.",
    ),
    step(
      { settings: { steering: "dubins", max_iterations: 250 } },
      "Without a reverse gear, along Dubins curves: will the car turn round?",
      ["Yes, on a longer path", "No"],
      1,
      "Without a reverse gear the same tree finds no path: the road is too narrow.",
    ),
    step(
      { scene: "blossom", settings: { blossom: 1 }, iteration: 1916 },
      "Now each extension applies one random control for a while. How many iterations will it take?",
      ["About 200", "About 2,000", "About 20,000"],
      1,
      "Without steering curves, with one random control per extension, it takes 1,916 iterations.",
    ),
    step(
      { settings: { blossom: 3 } },
      "Three controls per extension, of which the best is kept: how many iterations?",
      ["About 350", "About 2,000", "About 6,000"],
      0,
      "With three controls per extension, of which the one that ends closest to the sample is kept, it takes 354 iterations.",
    ),
    step(
      { settings: { blossom: 5 }, iteration: 1073 },
      "And five controls per extension?",
      ["Fewer iterations", "More iterations"],
      1,
      "Five controls per extension do not help here: 1,073 iterations, and the path is a little longer.",
    ),
  ),
];

/**
 * The iteration shown with a question: the one at which the previous step paused, if that has the same run, else 0.
 * @param {Lesson} lesson
 * @param {number} at   from 0
 */
export function beginningOf(lesson, at) {
  const { iteration } = lesson.steps[at - 1] ?? {};
  return iteration !== undefined && JSON.stringify(stageAt(lesson, at)) === JSON.stringify(stageAt(lesson, at - 1))
    ? iteration
    : 0;
}

/**
 * The scene and the plan of a step, which build on the previous steps.
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
