/** The motion from A to B: setting its ends, the way round of each angle, and playing it. */
import { byId, make } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { button, press } from "../widgets/elements.js";
import { Course } from "../widgets/course.js";

/** @import { Coordinate } from "../domain/types.js" */
/** @import { ReachSession } from "./session.js" */
/** @import { Direction } from "./motion.js" */

/** The part of the motion in a step. */
const STEP = 0.01;
/** @type {Direction[]} */
const DIRECTIONS = ["short", "long", "faulty"];

/** @param {ReachSession} session @param {HTMLElement} stage   on which Space plays too */
export function showMotionPanel(session, stage) {
  const course = new Course(session.app, byId("between", HTMLElement), {
    name: "between",
    label: "The motion from A to B",
    unit: "percent",
    steps: [1, 10],
    slowest: 4,
    fastest: 200,
    pace: 28,
    isWhole: false,
    axis: {
      id: "along",
      label: "Progress from A to B",
      end: () => 1,
      time: () => session.progress,
      seek: (progress) => session.setProgress(progress),
      unit: STEP,
      grain: "0.001",
      text: (progress) => `${Math.round(100 * progress)} percent`,
    },
    paceText: (pace) => `${(1 / (pace * STEP)).toFixed(1)} s`,
  });
  stage.addEventListener("keydown", (event) => {
    if (session.mode !== "between" || event.target !== stage || event.key !== " ") return;
    event.preventDefault();
    course.toggle();
  });
  const rounds = byId("rounds", HTMLElement);
  const onClick = (/** @type {string} */ id, /** @type {() => Partial<ReachSession>} */ changes) =>
    byId(id, HTMLButtonElement).addEventListener("click", () => change(changes()));
  onClick("set-a", () => ({ a: Float64Array.from(session.robot.q), progress: 0 }));
  onClick("set-b", () => ({ b: Float64Array.from(session.robot.q), progress: 1 }));
  onClick("swap", () => ({ a: session.b, b: session.a, progress: 0 }));
  for (const direction of DIRECTIONS) {
    onClick(`all-${direction}`, () => ({
      directions: session.robot.coordinates.map(({ isCircle }) => (isCircle ? direction : "short")),
      progress: 0,
    }));
  }
  const differs = comparer();
  session.app.onShow(show);

  /** @param {Partial<ReachSession>} changes */
  function change(changes) {
    course.pause();
    Object.assign(session, changes);
    if (session.mode === "between") session.setProgress(session.progress);
    session.app.changed();
  }

  function show() {
    const { mode, robot, directions } = session;
    if (mode !== "between" && course.isPlaying) course.pause();
    if (differs("robot", robot)) rounds.replaceChildren(...robot.coordinates.map(rowOf));
    [...rounds.children].forEach((row, i) => {
      for (const element of row.querySelectorAll("button")) press(element, element.dataset.direction === directions[i]);
    });
    for (const direction of DIRECTIONS)
      byId(`all-${direction}`, HTMLButtonElement).disabled = robot.coordinates.every(({ isCircle }) => !isCircle);
  }

  /** @param {Coordinate} coordinate @param {number} i */
  function rowOf({ name, isCircle, unit }, i) {
    const choices = DIRECTIONS.map((direction) => {
      const properties = { ariaLabel: `${name}: the ${direction} way`, dataset: { direction } };
      return button("", direction, () => change({ directions: session.directions.with(i, direction) }), properties);
    });
    const way = isCircle
      ? make("div", { className: "segments" }, ...choices)
      : make("span", { className: "hint" }, unit === "m" ? "straight" : "limited: one way only");
    return make("div", { className: "row" }, make("span", { className: "name" }, name), way);
  }
}
