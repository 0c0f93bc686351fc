/** The limits by which a robot's path is timed: their names and units, and those that the page chooses. */
import { hasSlide, sizeOf } from "../../domain/coordinates.js";

/** @import { TimingLimits } from "planarium/full" */
/** @import { Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @typedef {"speed" | "acceleration" | "turn_rate" | "turn_acceleration" | "lateral_acceleration"} LimitName */
/** @typedef {Partial<Record<LimitName, number>> & { differential?: boolean }} Given   by whoever uses the page */
/** @typedef {TimingLimits & { speed: number, acceleration: number }} Used   one number for each */
/** @typedef {{ name: LimitName, title: string, unit: string, usual: number | null }} Limit   null: none */

/** The names of the limits in the package. @type {Record<LimitName, keyof TimingLimits>} */
const SPELLED = {
  speed: "speed",
  acceleration: "acceleration",
  turn_rate: "turnRate",
  turn_acceleration: "turnAcceleration",
  lateral_acceleration: "lateralAcceleration",
};
/** Of joints and turns: radians a second, and a second squared. */
const TURNING = { speed: 1, acceleration: 2 };
/** About how many seconds a robot takes to cross its world. */
const CROSSING = 10;

/** The largest of 1, 2, 5, 10 and so on up to a number. @param {number} value */
function rounded(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].map((digit) => digit * power).find((one) => one <= value) ?? power;
}

/**
 * The limits of the robot of a scenario.
 * @param {{ scenario: Scenario, document: ScenarioDocument }} shown
 * @param {boolean} isDifferential   a disc turns on the spot and drives along its heading
 * @returns {Limit[]}
 */
export function limitsOf({ scenario, document: { robot } }, isDifferential) {
  if (robot.type === "arm") {
    const [speed, acceleration] = hasSlide(robot) ? ["rad/s, m/s", "rad/s\u00b2, m/s\u00b2"] : ["rad/s", "rad/s\u00b2"];
    return [
      { name: "speed", title: "Speed of joints", unit: speed, usual: TURNING.speed },
      { name: "acceleration", title: "Acceleration", unit: acceleration, usual: TURNING.acceleration },
    ];
  }
  const speed = Number(rounded(sizeOf(scenario) / CROSSING).toPrecision(1));
  /** @type {Limit[]} */
  const plane = [
    { name: "speed", title: "Speed", unit: "m/s", usual: speed },
    { name: "acceleration", title: "Acceleration", unit: "m/s\u00b2", usual: 2 * speed },
  ];
  if (robot.type === "rigid_body" || isDifferential)
    return [
      ...plane,
      { name: "turn_rate", title: "Turn rate", unit: "rad/s", usual: TURNING.speed },
      { name: "turn_acceleration", title: "Turn acceleration", unit: "rad/s\u00b2", usual: TURNING.acceleration },
    ];
  return robot.type === "car"
    ? [...plane, { name: "lateral_acceleration", title: "Sideways acceleration", unit: "m/s\u00b2", usual: null }]
    : plane;
}

/**
 * The limits that are used, as the package takes them.
 * @param {Limit[]} limits
 * @param {Given} given
 * @param {boolean} isDifferential
 * @returns {Used}
 */
export function usedLimits(limits, given, isDifferential) {
  const entries = limits.flatMap(({ name, usual }) => {
    const value = given[name] ?? usual;
    return value === null ? [] : [[SPELLED[name], value]];
  });
  const used = /** @type {Used} */ (/** @type {unknown} */ (Object.fromEntries(entries)));
  return isDifferential ? { ...used, differential: true } : used;
}
