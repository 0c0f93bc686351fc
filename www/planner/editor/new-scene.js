/** Scenes with nothing in them but a robot. */
import { rectangular } from "./robots.js";

/** @import { Point, ScenarioDocument } from "../../domain/types.js" */
/** @import { Robot } from "./robots.js" */

/** The bounds of an empty scene, and of one with an arm, metres. */
const SIDE = 10;
const REACH = 2;

/** A robot for the empty scene, with its start and goal. @type {Record<Robot["type"], { robot: Robot, start: number[], goal: number[] }>} */
const ROBOTS = {
  disc: { robot: { type: "disc", radius: 0.3 }, start: [1, 1], goal: [9, 9] },
  rigid_body: { robot: { type: "rigid_body", shape: rectangular(1, 0.6) }, start: [1, 1, 0], goal: [9, 9, 0] },
  car: {
    robot: { type: "car", shape: rectangular(1, 0.5), wheelbase: 0.6, speed: [-1, 1], steering: [-0.785, 0.785] },
    start: [1, 1, 0],
    goal: [9, 9, 0],
  },
  arm: { robot: { type: "arm", base: [0, 0], links: [0.9, 0.7], radius: 0.03 }, start: [2.4, 0.6], goal: [0.2, 0.6] },
};

/** @param {Robot["type"]} type @returns {ScenarioDocument} */
export function emptyScene(type) {
  const { robot, start, goal } = ROBOTS[type];
  /** @type {[Point, Point]} */
  const [min, max] =
    type === "arm"
      ? [
          [-REACH, -REACH],
          [REACH, REACH],
        ]
      : [
          [0, 0],
          [SIDE, SIDE],
        ];
  const tolerance = type === "car" ? { goal_tolerance: { translation: 0.5, rotation: 0.3 } } : {};
  return {
    format: "planarium-scenario-1",
    name: "new-scene",
    title: "New scene",
    world: { bounds: { min, max }, obstacles: [] },
    robot,
    queries: [{ name: "query", start, goal, ...tolerance }],
  };
}
