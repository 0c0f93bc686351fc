/** What is drawn of a trajectory: speeds and accelerations against time, by their units, with their limits. */

/** @import { Line } from "../../widgets/chart.js" */
/** @import { Coordinate, ScenarioDocument } from "../../domain/types.js" */
/** @import { Used } from "./limits.js" */
/** @import { State, Timed } from "./timed.js" */
/**
 * @typedef {object} Curve
 * @property {string} label   empty where it is the only one
 * @property {(state: State) => number} at
 */
/**
 * @typedef {object} Quantity   a chart
 * @property {string} id
 * @property {string} title
 * @property {string} unit
 * @property {Curve[]} curves
 * @property {[string, number][]} limits   drawn as levels, with their names
 * @property {boolean} isSigned   it may be below 0: limits hold on both sides
 */

/** Points of a curve, about. */
const POINTS = 500;

/** @param {Float64Array} vector */
const lengthOf = ([x, y]) => Math.hypot(x, y);
/** The part of a vector along the heading. @param {Float64Array} pose @param {Float64Array} vector */
const along = ([, , theta], [x, y]) => x * Math.cos(theta) + y * Math.sin(theta);
/** The part to its left. @param {Float64Array} pose @param {Float64Array} vector */
const across = ([, , theta], [x, y]) => y * Math.cos(theta) - x * Math.sin(theta);

/**
 * What is drawn for a robot.
 * @param {ScenarioDocument["robot"]} robot
 * @param {Coordinate[]} coordinates
 * @param {Used} used   limits
 * @returns {Quantity[]}
 */
export function quantitiesOf({ type }, coordinates, used) {
  const { speed, acceleration, turnRate = 0, turnAcceleration = 0, lateralAcceleration: aside } = used;
  if (type === "arm") return jointsOf(coordinates, speed, acceleration);
  if (type === "car") {
    return [
      {
        ...SPEED,
        title: "Speed, negative in reverse",
        curves: [{ label: "", at: ({ pose, velocity }) => along(pose, velocity) }],
        limits: level(speed),
        isSigned: true,
      },
      {
        ...ACCELERATION,
        curves: [
          { label: "along", at: ({ pose, acceleration: vector }) => along(pose, vector) },
          { label: "sideways", at: ({ pose, acceleration: vector }) => across(pose, vector) },
        ],
        limits: [
          [aside === undefined ? "limit" : "limit along", acceleration],
          ...(aside === undefined ? [] : [/** @type {[string, number]} */ (["limit sideways", aside])]),
        ],
        isSigned: true,
      },
    ];
  }
  /** @type {Quantity[]} */
  const plane = [
    {
      ...SPEED,
      curves: [{ label: "", at: ({ velocity }) => lengthOf(velocity) }],
      limits: level(speed),
      isSigned: false,
    },
    {
      ...ACCELERATION,
      curves: [{ label: "", at: ({ acceleration: vector }) => lengthOf(vector) }],
      limits: level(acceleration),
      isSigned: false,
    },
  ];
  if (type === "disc" && !used.differential) return plane;
  return [
    ...plane,
    {
      id: "turn-rate",
      title: "Turn rate",
      unit: "rad/s",
      curves: [{ label: "", at: ({ velocity }) => velocity[2] }],
      limits: level(turnRate),
      isSigned: true,
    },
    {
      id: "turn-acceleration",
      title: "Turn acceleration",
      unit: "rad/s\u00b2",
      curves: [{ label: "", at: ({ acceleration: vector }) => vector[2] }],
      limits: level(turnAcceleration),
      isSigned: true,
    },
  ];
}

/** The limit of a quantity that has one. @param {number} value @returns {[string, number][]} */
const level = (value) => [["limit", value]];

const SPEED = { id: "speed", title: "Speed", unit: "m/s" };
const ACCELERATION = { id: "acceleration", title: "Acceleration", unit: "m/s\u00b2" };

/**
 * Of the joints of an arm, those that turn apart from those that slide.
 * @param {Coordinate[]} coordinates
 * @param {number} speed
 * @param {number} acceleration
 * @returns {Quantity[]}
 */
function jointsOf(coordinates, speed, acceleration) {
  const units = [...new Set(coordinates.map(({ unit }) => unit))];
  return units.flatMap((unit) => {
    const joints = coordinates.flatMap(({ name, unit: own }, i) => (own === unit ? [{ name, i }] : []));
    const kind = units.length === 1 ? "" : unit === "rad" ? " of joints that turn" : " of joints that slide";
    return [
      {
        id: `speed-${unit}`,
        title: `Speed${kind}`,
        unit: `${unit}/s`,
        curves: joints.map(({ name, i }) => ({ label: name, at: (/** @type {State} */ { velocity }) => velocity[i] })),
        limits: level(speed),
        isSigned: true,
      },
      {
        id: `acceleration-${unit}`,
        title: `Acceleration${kind}`,
        unit: `${unit}/s\u00b2`,
        curves: joints.map(({ name, i }) => ({
          label: name,
          at: (/** @type {State} */ { acceleration: vector }) => vector[i],
        })),
        limits: level(acceleration),
        isSigned: true,
      },
    ];
  });
}

/** The style of a curve, beside its dashes. @param {number} i */
export const styleOf = (i) => `dash-${i % 4} series-${i % 5}`;

/**
 * The names of the curves in all charts; one that is alone has none.
 * @param {Quantity[]} quantities
 * @param {string[]} letters   of a race, one a path; none where there is one path
 */
export function legendOf(quantities, letters) {
  const most = quantities.reduce((a, b) => (b.curves.length > a.curves.length ? b : a));
  const each = letters.length > 0 ? letters : [""];
  return each.flatMap((letter) => most.curves.map(({ label }) => [letter, label].filter(Boolean).join(" ")));
}

/**
 * The curves of a quantity, of each trajectory, and the levels of its limits.
 * @param {Quantity} quantity
 * @param {Timed[]} paths
 * @returns {Line[]}
 */
export function linesOf({ curves, limits, isSigned }, paths) {
  const period = Math.max(...paths.map(({ duration }) => duration));
  let count = 0;
  const lines = paths.flatMap((timed) => {
    const each = Math.max(1, Math.ceil(timed.count / POINTS));
    const states = Array.from({ length: timed.count }, (_, row) => row)
      .filter((row) => row % each === 0 || row === timed.count - 1)
      .map((row) => timed.state(timed.rows[row * timed.width]));
    return curves.map(({ at }) => ({
      label: "",
      points: states.map((state) => /** @type {[number, number]} */ ([state.time, at(state)])),
      className: styleOf(count++),
    }));
  });
  const levels = limits.flatMap(([, value]) =>
    (isSigned ? [value, -value] : [value]).map((height) => ({
      label: "",
      points: /** @type {[number, number][]} */ ([
        [0, height],
        [period, height],
      ]),
      isLevel: true,
      className: "limit",
    })),
  );
  return [...lines, ...levels];
}
