/**
 * The scenes: small worlds, each with an arm, its configuration at first, the ends A and B of a motion, and a target.
 * And those of the planner's page.
 */
import { box, disc } from "../domain/obstacles.js";
import { sceneDocument } from "../planner/scenes/document.js";
import { SCENES as PLANNED } from "../planner/scenes/scenes.js";

/** @import { Obstacle, Point, ScenarioDocument } from "../domain/types.js" */
/** @import { ArmRobot } from "../domain/coordinates.js" */

/**
 * @typedef {{ q: number[], a: number[], b: number[], target: Point }} Configurations   at first, of the motion, and of
 *   inverse kinematics
 */
/**
 * @typedef {{ id: string, title: string, document: ScenarioDocument } & Partial<Configurations>} SceneEntry   those
 *   that are absent are chosen for the scenario
 */

/** @type {({ id: string, title: string, obstacles: Obstacle[], robot: Omit<ArmRobot, "type"> } & Configurations)[]} */
const ARMS = [
  {
    id: "islands",
    title: "Islands",
    obstacles: [disc(0.62, 0.62, 0.2), disc(-0.75, -0.3, 0.22), box(-0.75, 0.62, 0.34, 0.2)],
    robot: { base: [0, 0], links: [0.62, 0.5], radius: 0.03 },
    q: [-0.3, 1.1],
    a: [-0.55, 0.5],
    b: [2.35, 0.7],
    target: [0.2, 0.75],
  },
  {
    id: "plane",
    title: "No obstacles",
    obstacles: [],
    robot: { base: [0, 0], links: [0.6, 0.5], radius: 0.03 },
    q: [0.6, 0.9],
    a: [-2.4, 0.6],
    b: [2.6, -0.8],
    target: [-0.4, 0.6],
  },
  {
    id: "window",
    title: "Through a window",
    obstacles: [box(0.55, 0.3, 0.12, 0.9), box(0.55, -1.2, 0.12, 1.1)],
    robot: { base: [0, 0], links: [0.5, 0.45, 0.4], radius: 0.03 },
    q: [1.7, -0.6, -0.6],
    a: [1.9, -0.6, -0.4],
    b: [0.35, -0.45, 0.15],
    target: [1.05, 0.2],
  },
  {
    id: "limits",
    title: "Joint limits",
    obstacles: [disc(0.9, 0.75, 0.18), disc(-0.55, 0.8, 0.16)],
    robot: {
      base: [0, 0],
      links: [0.55, 0.45, 0.3],
      radius: 0.035,
      joint_limits: [
        [-0.4, 3.5],
        [-2.2, 2.2],
        [-1.6, 1.6],
      ],
    },
    q: [0.5, 0.9, 0.4],
    a: [0, 0.55, 0.5],
    b: [2.9, -0.75, -0.45],
    target: [0.2, 1],
  },
  {
    id: "boom",
    title: "A boom that slides",
    obstacles: [disc(0.75, 0.5, 0.16), box(-0.75, 0.35, 0.5, 0.12), disc(0.2, -0.75, 0.15)],
    robot: {
      base: [0, 0],
      links: [0.3, 0.15],
      radius: 0.035,
      joints: ["revolute", { type: "prismatic", range: [0, 0.7], angle: 0 }],
    },
    q: [0.1, 0.35],
    a: [0.15, 0.6],
    b: [1.5, 0.6],
    target: [-0.1, 0.8],
  },
  {
    id: "corner",
    title: "Round a corner",
    obstacles: [box(0.15, 0.35, 0.75, 0.14), box(0.76, -0.25, 0.14, 0.6), disc(-0.6, 0.5, 0.18)],
    robot: { base: [0, 0], links: [0.42, 0.38, 0.34, 0.3], radius: 0.025 },
    q: [1.9, -0.7, -0.6, -0.5],
    a: [2.2, -0.8, -0.7, -0.4],
    b: [-0.67, 0.36, 0.46, -0.42],
    target: [0.45, 0.9],
  },
  {
    id: "tentacle",
    title: "Eight links",
    obstacles: [disc(0.75, 0.45, 0.22), disc(0.55, -0.7, 0.2), disc(-0.75, 0.35, 0.24), disc(-0.35, -0.75, 0.16)],
    robot: { base: [0, 0], links: [0.2, 0.19, 0.18, 0.17, 0.16, 0.15, 0.14, 0.13], radius: 0.02 },
    q: [1.2, 0.3, -0.4, -0.4, -0.4, 0.2, 0.4, 0.4],
    a: [1.6, 0.2, -0.3, -0.4, -0.3, 0.2, 0.3, 0.3],
    b: [-1.7, -0.03, 0.26, 0.13, 0.18, -0.27, -0.31, -0.31],
    target: [1.05, -0.1],
  },
];

/** The scenes of this page. */
export const SCENES = ARMS.map(({ obstacles, robot, ...entry }) => {
  const queries = [{ name: "a-to-b", start: entry.a, goal: entry.b }];
  /** @type {ScenarioDocument} */
  const document = {
    format: "planarium-scenario-1",
    name: entry.id,
    title: entry.title,
    world: { obstacles },
    robot: { type: "arm", ...robot },
    queries,
  };
  return { ...entry, document };
});

/** Begins the id of a scene of the planner's page where a scene of this page has the same. */
const THEIRS = "plan-";

/** Scenes of the planner's page with a body. */
export const BODIES = ["corner", "crates"].map((id) => {
  const title = PLANNED.find((entry) => entry.id === id)?.title ?? id;
  return { id: SCENES.some((own) => own.id === id) ? THEIRS + id : id, title };
});

/** A scene of this page or of the planner's. @param {string} id @returns {Promise<SceneEntry>} */
export async function sceneOf(id) {
  const own = SCENES.find((entry) => entry.id === id);
  if (own) return own;
  const document = await sceneDocument(id.startsWith(THEIRS) ? id.slice(THEIRS.length) : id);
  return { id, title: document.title ?? document.name, document };
}
