/** The arm in the panel: its joints, and what it is made of. */
import { byId, make } from "../app/dom.js";
import { Slider } from "../room/slider.js";

/** @import { Bench, Change } from "./bench.js" */
/** @import { ArmRobot, Point } from "./types.js" */

/** Links at most, as the core has it. */
const MOST_LINKS = 8;
/** Stops that a joint is given at first, radians. */
const STOPS = 2.5;
/** Stops that can be chosen, radians. */
const WIDEST = 2 * Math.PI;

export class ArmPanel {
  /** @param {Bench} bench */
  constructor(bench) {
    this.bench = bench;
    this.joints = byId("joints", HTMLElement);
    this.made = byId("arm", HTMLElement);
    /** @type {Slider[]} */
    this.angles = [];
    /** @type {Slider[]} */
    this.lengths = [];
    this.key = "";
    this.count = new Slider({ name: "links", title: "Links", unit: "", min: 1, max: MOST_LINKS, kind: "integer" }, 2, (count) => this.setCount(count));
    this.radius = new Slider({ name: "radius", title: "Radius", unit: "m", min: 0, max: 0.15, step: 0.005 }, 0, (radius) => this.change({ radius }));
    this.stops = make("input", { type: "checkbox", id: "stops" });
    this.stops.setAttribute("role", "switch");
    this.stops.addEventListener("change", () => this.setStops(this.stops.checked));
    this.intervals = make("div", { id: "intervals" });
    this.links = make("div", { id: "lengths" });
    this.reason = make("p", { className: "reason", id: "arm-reason", role: "status", hidden: true });
    const stops = make("label", { className: "row", htmlFor: "stops" }, make("span", { className: "name" }, "Joints have stops"), this.stops);
    this.made.append(this.count.element, this.links, this.radius.element, stops, this.intervals, this.reason);
    bench.onChange((change) => this.show(change));
  }

  /** @param {Change} change */
  show(change) {
    const { bench: { arm } } = this;
    const { robot } = arm;
    // Built anew only where there are others: whoever holds a slider goes on holding it.
    const key = `${arm.dimension} ${arm.hasLimits}`;
    if (key !== this.key) {
      this.key = key;
      this.build();
    }
    this.angles.forEach((slider, i) => {
      const { low, high } = arm.joints[i];
      if (slider.info.min !== low || slider.info.max !== high) slider.span(low, high);
      slider.show(arm.q[i]);
    });
    if (change !== "arm") return;
    this.refuse("");
    this.count.show(arm.dimension);
    this.radius.show(robot.radius ?? 0);
    this.stops.checked = arm.hasLimits;
    this.lengths.forEach((slider, i) => {
      if (slider.info.max < robot.links[i]) slider.span(slider.info.min, robot.links[i]);
      slider.show(robot.links[i]);
    });
    this.fillIntervals();
  }

  build() {
    const { bench } = this;
    const { arm } = bench;
    this.angles = arm.joints.map(({ name, low, high }, i) => new Slider({ name: `joint-${i}`, title: name, unit: "rad", min: low, max: high }, arm.q[i], (angle) => {
      const q = Float64Array.from(bench.arm.q);
      q[i] = angle;
      bench.pose(q);
    }));
    this.joints.replaceChildren(...this.angles.map(({ element }) => element));
    this.lengths = arm.robot.links.map((length, i) => new Slider({ name: `link-${i}`, title: `link ${i}`, unit: "m", min: 0.05, max: Math.max(1, length), step: 0.005 }, length, (value) => {
      const links = [...bench.arm.robot.links];
      links[i] = value;
      this.change({ links });
    }));
    this.links.replaceChildren(...this.lengths.map(({ element }) => element));
    this.intervals.replaceChildren();
  }

  /** The stops of each joint, as numbers. */
  fillIntervals() {
    const { bench } = this;
    const { joint_limits: limits } = bench.arm.robot;
    if (!limits) {
      this.intervals.replaceChildren();
      return;
    }
    if (this.intervals.childElementCount === limits.length) {
      [...this.intervals.querySelectorAll("input")].forEach((input, k) => { if (document.activeElement !== input) input.value = limits[k >> 1][k % 2].toFixed(2); });
      return;
    }
    this.intervals.replaceChildren(...limits.map((interval, i) => {
      const fields = interval.map((value, end) => {
        const word = end === 0 ? "least" : "greatest";
        const input = make("input", { type: "number", id: `stop-${i}-${end}`, step: "any", min: String(-WIDEST), max: String(WIDEST), value: value.toFixed(2), autocomplete: "off", ariaLabel: `joint ${i}, ${word} angle, radians` });
        input.addEventListener("change", () => {
          const limitsNow = bench.arm.robot.joint_limits?.map((pair) => /** @type {Point} */ ([...pair]));
          if (!limitsNow) return;
          limitsNow[i][end] = input.value.trim() === "" ? NaN : Number(input.value);
          this.change({ joint_limits: limitsNow }, input);
        });
        return input;
      });
      return make("div", { className: "interval" }, make("span", { className: "name" }, `joint ${i}`), fields[0], make("span", {}, "to"), fields[1], make("span", { className: "unit" }, "rad"));
    }));
  }

  /** @param {number} count */
  setCount(count) {
    const { links, joint_limits: limits } = this.bench.arm.robot;
    const last = links[links.length - 1];
    const grown = Array.from({ length: count }, (_, i) => links[i] ?? last);
    this.change({ links: grown, ...(limits ? { joint_limits: grown.map((_, i) => limits[i] ?? [-STOPS, STOPS]) } : {}) });
  }

  /** @param {boolean} on */
  setStops(on) {
    this.change({ joint_limits: on ? this.bench.arm.robot.links.map(() => /** @type {Point} */ ([-STOPS, STOPS])) : undefined });
  }

  /** Makes the arm another; that the core refuses it is said. @param {Partial<ArmRobot>} parts @param {HTMLInputElement} [input]  where it was asked for */
  change(parts, input) {
    const { bench } = this;
    const { document: scenario } = bench.arm;
    const robot = /** @type {ArmRobot} */ ({ ...bench.arm.robot, ...parts });
    if (robot.joint_limits === undefined) delete robot.joint_limits;
    const bad = robot.joint_limits?.findIndex((pair) => !pair.every((value) => Math.abs(value) <= WIDEST) || !(pair[0] < pair[1])) ?? -1;
    try {
      if (bad >= 0) throw new Error(`The stops of joint ${bad} must be two numbers, the lesser first, from \u22126.28 to 6.28.`);
      bench.change({ ...scenario, robot });
      this.refuse("");
      input?.removeAttribute("aria-invalid");
    } catch (error) {
      this.refuse(error instanceof Error ? error.message : String(error));
      input?.setAttribute("aria-invalid", "true");
      this.stops.checked = bench.arm.hasLimits;
    }
  }

  /** @param {string} reason */
  refuse(reason) {
    this.reason.textContent = reason;
    this.reason.hidden = reason === "";
  }
}
