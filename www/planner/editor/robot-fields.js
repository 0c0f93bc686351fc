/** The numbers of a robot, each with how it is set: what the panel of the robot shows for each type. */
import { jointsOf } from "../../domain/coordinates.js";
import { MOST_LINKS, footprintOf, linked, marginOf, sized, withArm, withMargin } from "./robots.js";
import { rounded } from "./units.js";

/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { LinkJoint } from "../../domain/coordinates.js" */
/** @import { Arm, Open, Robot, Shaped } from "./robots.js" */
/** @typedef {{ document: ScenarioDocument, text: string }} Change   `text`: what becomes of start and goal */
/**
 * @typedef {object} Entry   a number of a robot
 * @property {string} name      in the id of its field
 * @property {string} title
 * @property {string} unit
 * @property {number | null} value   null: it is not given
 * @property {"number" | "integer"} kind
 * @property {number | null} min
 * @property {number | null} max
 * @property {string} meaning
 * @property {string | null} empty   what an empty field means; null: it is not left empty
 * @property {string} group     entries of one group are in one part of the panel
 * @property {(open: Open, value: number | null) => Change} set
 */

/** The range of a link that begins to slide, metres. */
const RANGE = /** @type {[number, number]} */ ([0, 0.5]);

/**
 * @param {string} name @param {string} title @param {string} unit @param {number | null} value
 * @param {Entry["set"]} set @param {Partial<Entry>} [more]
 * @returns {Entry}
 */
function entry(name, title, unit, value, set, more = {}) {
  return {
    name,
    title,
    unit,
    value,
    kind: "number",
    min: null,
    max: null,
    meaning: "",
    empty: null,
    group: "size",
    set,
    ...more,
  };
}

/** @param {(robot: any, value: number) => Robot} set @returns {Entry["set"]} */
const robotSet =
  (set) =>
  ({ document }, value) => ({ document: { ...document, robot: set(document.robot, value ?? 0) }, text: "" });

/** @param {Robot} robot @param {number} unit  of lengths @returns {Entry[]} */
export function entriesOf(robot, unit) {
  const margin = entry(
    "margin",
    "Margin",
    "m",
    marginOf(robot),
    robotSet((one, value) => withMargin(one, value)),
    { min: 0, meaning: "Plans as if the robot were larger by this on all sides.", group: "margin" },
  );
  switch (robot.type) {
    case "disc":
      return [
        entry(
          "robot-radius",
          "Radius",
          "m",
          robot.radius,
          robotSet((one, radius) => ({ ...one, radius })),
          { min: 0, meaning: "0: a point." },
        ),
        margin,
      ];
    case "rigid_body":
      return [...footprint(robot, unit), margin];
    case "car":
      return [...footprint(robot, unit), ...carEntries(robot), margin];
    default:
      return [...armEntries(robot), margin];
  }
}

/** @param {Shaped} robot @param {number} unit @returns {Entry[]} */
function footprint({ shape }, unit) {
  const { length, width } = footprintOf(shape);
  const text = (/** @type {number} */ value) => rounded(value, unit / 100);
  return [
    entry(
      "robot-length",
      "Length",
      "m",
      text(length),
      robotSet((one, value) => ({ ...one, shape: sized(one.shape, value, width, unit) })),
      { min: unit },
    ),
    entry(
      "robot-width",
      "Width",
      "m",
      text(width),
      robotSet((one, value) => ({ ...one, shape: sized(one.shape, length, value, unit) })),
      { min: unit },
    ),
  ];
}

/** @param {Extract<Robot, { type: "car" }>} robot @returns {Entry[]} */
function carEntries(robot) {
  /** @param {"speed" | "steering"} what @param {string} title @param {string} unit @returns {Entry[]} */
  const limits = (what, title, unit) =>
    ["from", "to"].map((end, i) =>
      entry(
        `${what}-${end}`,
        `${title} ${end}`,
        unit,
        robot[what][i],
        robotSet((one, value) => ({ ...one, [what]: one[what].with(i, value) })),
        { group: "Speed and steering" },
      ),
    );
  return [
    entry(
      "wheelbase",
      "Wheelbase",
      "m",
      robot.wheelbase,
      robotSet((one, wheelbase) => ({ ...one, wheelbase })),
    ),
    ...limits("speed", "Speed", "m/s"),
    ...limits("steering", "Steering", "rad"),
  ];
}

/** @param {Open} open @returns {Arm} */
const armOf = ({ document }) => /** @type {Arm} */ (document.robot);

/** @param {Arm} arm @returns {Entry[]} */
function armEntries(arm) {
  return [
    entry(
      "links",
      "Links",
      "",
      arm.links.length,
      (open, value) => {
        const grown = linked(armOf(open), value ?? 1);
        return withArm(open, grown.arm, grown.joints);
      },
      { kind: "integer", min: 1, max: MOST_LINKS },
    ),
    entry(
      "robot-radius",
      "Radius",
      "m",
      arm.radius ?? 0,
      robotSet((one, radius) => ({ ...one, radius })),
      { min: 0, meaning: "Half the width of the links." },
    ),
    ...["x", "y"].map((name, i) =>
      entry(
        `base-${name}`,
        `Base ${name}`,
        "m",
        arm.base[i],
        robotSet((one, value) => ({ ...one, base: one.base.with(i, value) })),
      ),
    ),
    ...jointsOf(arm).flatMap((joint, i) => linkEntries(arm, joint, i)),
  ];
}

/** @param {Arm} arm @param {LinkJoint} joint @param {number} i @returns {Entry[]} */
function linkEntries(arm, joint, i) {
  const group = `Link ${i + 1}`;
  /** @param {(joint: LinkJoint, value: number | null) => LinkJoint} set @returns {Entry["set"]} */
  const jointSet = (set) => (open, value) => {
    const joints = jointsOf(armOf(open));
    return withArm(open, armOf(open), joints.with(i, set(joints[i], value)));
  };
  const slides = joint.type === "prismatic";
  const range = slides ? joint.range : joint.limits;
  const ends = ["from", "to"].map((end, k) =>
    entry(
      `joint-${i + 1}-${end}`,
      `${slides ? "Slides" : "Turns"} ${end}`,
      slides ? "m" : "rad",
      range?.[k] ?? null,
      jointSet((one, value) => withEnd(one, k, value)),
      { group, empty: slides ? null : "none: it turns freely" },
    ),
  );
  const angle = () =>
    entry(
      `joint-${i + 1}-angle`,
      "At the angle",
      "rad",
      slides ? joint.angle : 0,
      jointSet((one, value) => ({ ...one, angle: value ?? 0 })),
      { group },
    );
  return [
    entry(
      `link-${i + 1}`,
      "Length",
      "m",
      arm.links[i],
      robotSet((one, value) => ({ ...one, links: one.links.with(i, value) })),
      { group },
    ),
    ...ends,
    ...(slides ? [angle()] : []),
  ];
}

/** A joint with another end of its range; without one it turns freely. @param {LinkJoint} joint @param {number} end @param {number | null} value @returns {LinkJoint} */
function withEnd(joint, end, value) {
  if (joint.type === "prismatic") {
    const [low, high] = joint.range.with(end, value ?? RANGE[end]);
    return { ...joint, range: [low, high] };
  }
  if (value === null) return { type: "revolute" };
  const [low, high] = (joint.limits ?? [-Math.PI, Math.PI]).with(end, value);
  return { type: "revolute", limits: [low, high] };
}

/** The document with a link that slides, or turns. @param {Open} open @param {number} i @param {boolean} slides */
export function withJointType(open, i, slides) {
  const joints = jointsOf(armOf(open));
  return withArm(
    open,
    armOf(open),
    joints.with(i, slides ? { type: "prismatic", range: RANGE, angle: 0 } : { type: "revolute" }),
  );
}
