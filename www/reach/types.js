/**
 * The words that this page's modules share. Types only.
 *
 * @typedef {[number, number]} Point
 * @typedef {Extract<import("planarium").Robot, { type: "arm" }>} ArmRobot
 * @typedef {import("planarium").ScenarioDocument} ScenarioDocument
 *
 * @typedef {object} SceneEntry   one of the page's own scenes
 * @property {string} id
 * @property {string} title
 * @property {import("planarium").Obstacle[]} obstacles
 * @property {Omit<ArmRobot, "type">} robot
 * @property {number[]} q    to begin with
 * @property {number[]} a    to go from
 * @property {number[]} b    to go to
 * @property {Point} target  of the end effector
 *
 * @typedef {"hand" | "between" | "solve"} Mode   what the stage is for: the arm in the hand, the way from A to B, inverse kinematics to watch
 */
export {};
