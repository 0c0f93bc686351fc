/** The motion from A to B: setting its ends, the way round of each joint, and playing it. */
import { byId, make } from "../app/dom.js";
import { button, press } from "../widgets/elements.js";
import { Transport } from "../widgets/transport.js";

/** @import { ArmSession, Change } from "./session.js" */
/** @import { Direction } from "./motion.js" */

/** The part of the motion in a step. */
const STEP = 0.01;
/** @type {Direction[]} */
const DIRECTIONS = ["short", "long"];

export class MotionPanel {
  /** @param {ArmSession} session @param {HTMLElement} stage   on which Space plays too */
  constructor(session, stage) {
    this.session = session;
    this.slider = make("input", { type: "range", id: "along", className: "timeline", min: "0", max: "1", step: "0.001", value: "0", ariaLabel: "Progress from A to B" });
    this.slider.addEventListener("input", () => {
      this.transport.pause();
      session.setProgress(Number(this.slider.value));
    });
    this.transport = new Transport(session.app, byId("between", HTMLElement), {
      name: "between", label: "The motion from A to B", unit: "percent", steps: [1, 10], slowest: 4, fastest: 200, pace: 28, isWhole: false,
      advance: (count) => {
        session.setProgress(session.progress + count * STEP);
        return session.progress < 1;
      },
      reset: () => session.setProgress(0),
      paceText: (pace) => `${(1 / (pace * STEP)).toFixed(1)} s`,
    });
    this.transport.bar.prepend(this.slider);
    // From its end it starts again.
    this.transport.play.addEventListener("click", () => { if (this.transport.isPlaying && session.progress >= 1) session.setProgress(0); });
    stage.addEventListener("keydown", (event) => {
      if (session.mode !== "between" || event.target !== stage || event.key !== " ") return;
      event.preventDefault();
      this.transport.play.click();
    });
    this.directions = byId("rounds", HTMLElement);
    const onClick = (/** @type {string} */ id, /** @type {() => Partial<ArmSession>} */ changes) => byId(id, HTMLButtonElement).addEventListener("click", () => this.change(changes()));
    onClick("set-a", () => ({ a: Float64Array.from(session.arm.q), progress: 0 }));
    onClick("set-b", () => ({ b: Float64Array.from(session.arm.q), progress: 1 }));
    onClick("swap", () => ({ a: session.b, b: session.a, progress: 0 }));
    for (const direction of DIRECTIONS) {
      onClick(`all-${direction}`, () => ({ directions: session.arm.joints.map(({ isCircle }) => (isCircle ? direction : "short")), progress: 0 }));
    }
    session.onChange((change) => this.show(change));
  }

  /** @param {Partial<ArmSession>} changes */
  change(changes) {
    const { session } = this;
    this.transport.pause();
    Object.assign(session, changes);
    if (session.mode === "between") session.setProgress(session.progress);
    session.update("rest");
  }

  /** @param {Change} change */
  show(change) {
    const { session: { mode, progress, arm, directions }, slider } = this;
    if (mode !== "between" && this.transport.isPlaying) this.transport.pause();
    if (!slider.matches(":active")) slider.value = String(progress);
    slider.setAttribute("aria-valuetext", `${Math.round(100 * progress)} percent`);
    if (change === "pose" || change === "iterate") return;
    if (change === "arm") this.build();
    [...this.directions.children].forEach((row, i) => {
      for (const element of row.querySelectorAll("button")) press(element, element.dataset.direction === directions[i]);
    });
    for (const direction of DIRECTIONS) byId(`all-${direction}`, HTMLButtonElement).disabled = arm.hasLimits;
  }

  /** A row for each joint. */
  build() {
    const { session } = this;
    this.directions.replaceChildren(...session.arm.joints.map(({ name, isCircle }, i) => {
      const choices = DIRECTIONS.map((direction) => {
        const element = button("", direction, () => this.change({ directions: session.directions.with(i, direction) }));
        element.dataset.direction = direction;
        element.ariaLabel = `${name}: the ${direction} way round`;
        return element;
      });
      const way = isCircle ? make("div", { className: "segments" }, ...choices) : make("span", { className: "hint" }, "limited: one way only");
      return make("div", { className: "row" }, make("span", { className: "name" }, name), way);
    }));
  }
}
