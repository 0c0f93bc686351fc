/**
 * Types that this page's modules share.
 *
 * @typedef {[number, number]} Point
 * @typedef {Extract<import("planarium").Robot, { type: "arm" }>} ArmRobot
 * @typedef {import("planarium").ScenarioDocument} ScenarioDocument
 *
 * @typedef {object} SceneEntry   a built-in scene
 * @property {string} id
 * @property {string} title
 * @property {import("planarium").Obstacle[]} obstacles
 * @property {Omit<ArmRobot, "type">} robot
 * @property {number[]} q    the configuration at first
 * @property {number[]} a    the start of the motion
 * @property {number[]} b    its end
 * @property {Point} target  of inverse kinematics
 *
 * @typedef {"hand" | "between" | "solve"} Mode   dragging, the motion from A to B, inverse kinematics
 */
export {};
