/** The motion from A to B: setting its ends, the way round of each angle, and playing it. */
import { byId, make } from "../app/dom.js";
import { button, press } from "../widgets/elements.js";
import { Transport } from "../widgets/transport.js";

/** @import { Coordinate } from "../domain/types.js" */
/** @import { ReachSession, Change } from "./session.js" */
/** @import { Direction } from "./motion.js" */

/** The part of the motion in a step. */
const STEP = 0.01;
/** @type {Direction[]} */
const DIRECTIONS = ["short", "long", "faulty"];

/** @param {ReachSession} session @param {HTMLElement} stage   on which Space plays too */
export function showMotionPanel(session, stage) {
  const slider = make("input", {
    type: "range",
    id: "along",
    className: "timeline",
    min: "0",
    max: "1",
    step: "0.001",
    value: "0",
    ariaLabel: "Progress from A to B",
  });
  slider.addEventListener("input", () => {
    transport.pause();
    session.setProgress(Number(slider.value));
  });
  const transport = new Transport(session.app, byId("between", HTMLElement), {
    name: "between",
    label: "The motion from A to B",
    unit: "percent",
    steps: [1, 10],
    slowest: 4,
    fastest: 200,
    pace: 28,
    isWhole: false,
    advance: (count) => {
      session.setProgress(session.progress + count * STEP);
      return session.progress < 1;
    },
    reset: () => session.setProgress(0),
    paceText: (pace) => `${(1 / (pace * STEP)).toFixed(1)} s`,
  });
  transport.bar.prepend(slider);
  // From its end it starts again.
  transport.play.addEventListener("click", () => {
    if (transport.isPlaying && session.progress >= 1) session.setProgress(0);
  });
  stage.addEventListener("keydown", (event) => {
    if (session.mode !== "between" || event.target !== stage || event.key !== " ") return;
    event.preventDefault();
    transport.play.click();
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
  session.onChange(show);

  /** @param {Partial<ReachSession>} changes */
  function change(changes) {
    transport.pause();
    Object.assign(session, changes);
    if (session.mode === "between") session.setProgress(session.progress);
    session.update("rest");
  }

  /** @param {Change} what */
  function show(what) {
    const { mode, progress, robot, directions } = session;
    if (mode !== "between" && transport.isPlaying) transport.pause();
    if (!slider.matches(":active")) slider.value = String(progress);
    slider.setAttribute("aria-valuetext", `${Math.round(100 * progress)} percent`);
    if (what === "pose" || what === "iterate") return;
    if (what === "robot") rounds.replaceChildren(...robot.coordinates.map(rowOf));
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
