/** The panels of the joints and of the arm: angles, orientation of the last link, links, radius and joint limits. */
import { byId, make } from "../app/dom.js";
import { Slider } from "../widgets/slider.js";

/** @import { ArmSession, Change } from "./session.js" */
/** @import { ArmRobot, Point } from "./types.js" */

/** Links at most, as in the core. */
const MOST_LINKS = 8;
/** Joints that a fixed orientation needs. */
const ORIENTED = 3;
/** Joint limits at first, and at most, radians. */
const LIMITS = /** @type {Point} */ ([-2.5, 2.5]);
const WIDEST = 2 * Math.PI;

export class ArmPanel {
  /** @param {ArmSession} session @param {() => void} onOrientation   another orientation is wanted */
  constructor(session, onOrientation) {
    this.session = session;
    /** @type {Slider[]} */
    this.angles = [];
    /** @type {Slider[]} */
    this.lengths = [];
    /** The fields of the joint limits, two for each joint. @type {HTMLInputElement[]} */
    this.limits = [];
    const setOrientation = (/** @type {number | null} */ angle) => {
      session.orientation = angle;
      onOrientation();
    };
    this.isOriented = byId("keep", HTMLInputElement);
    this.isOriented.addEventListener("change", () => setOrientation(this.isOriented.checked ? session.arm.orientation : null));
    this.orientation = new Slider({ name: "direction", title: "orientation", unit: "rad", min: -Math.PI, max: Math.PI }, 0, setOrientation);
    this.orientationHint = byId("keep-hint", HTMLElement);
    this.orientationHint.before(this.orientation.element);
    this.count = new Slider({ name: "links", title: "Links", min: 1, max: MOST_LINKS, kind: "integer" }, 2, (count) => this.setCount(count));
    this.radius = new Slider({ name: "radius", title: "Radius", unit: "m", min: 0, max: 0.15, step: 0.005 }, 0, (radius) => this.change({ radius }));
    byId("lengths", HTMLElement).before(this.count.element);
    byId("lengths", HTMLElement).after(this.radius.element);
    this.hasLimits = byId("stops", HTMLInputElement);
    this.hasLimits.addEventListener("change", () => this.change({ joint_limits: this.hasLimits.checked ? session.arm.robot.links.map(() => LIMITS) : undefined }));
    session.onChange((change) => this.show(change));
  }

  /** @param {Change} change */
  show(change) {
    const { session: { arm, orientation } } = this;
    const { robot, hasLimits, dimension } = arm;
    // Controls are rebuilt only if their number differs, so that a slider can be held meanwhile.
    if (dimension !== this.angles.length || this.limits.length !== (hasLimits ? 2 * dimension : 0)) this.build();
    this.angles.forEach((slider, i) => slider.show(arm.q[i]));
    this.isOriented.disabled = dimension < ORIENTED;
    this.isOriented.checked = orientation !== null;
    this.orientationHint.hidden = dimension >= ORIENTED;
    this.orientation.element.hidden = orientation === null;
    if (orientation !== null) this.orientation.show(orientation);
    if (change !== "arm") return;
    this.refuse("");
    this.angles.forEach((slider, i) => slider.setLimits(arm.joints[i].low, arm.joints[i].high));
    this.count.show(dimension);
    this.radius.show(robot.radius ?? 0);
    this.hasLimits.checked = hasLimits;
    this.lengths.forEach((slider, i) => {
      slider.setLimits(slider.info.min, Math.max(slider.info.max, robot.links[i]));
      slider.show(robot.links[i]);
    });
    const limits = (robot.joint_limits ?? []).flat();
    this.limits.forEach((input, k) => { if (document.activeElement !== input) input.value = limits[k].toFixed(2); });
  }

  build() {
    const { session } = this;
    const { joints, q, robot: { links, joint_limits: limits = [] } } = session.arm;
    this.angles = joints.map(({ name, low, high }, i) => new Slider({ name: `joint-${i}`, title: name, unit: "rad", min: low, max: high }, q[i], (angle) => session.turnJoint(i, angle)));
    this.lengths = links.map((length, i) => new Slider({ name: `link-${i}`, title: `link ${i + 1}`, unit: "m", min: 0.05, max: Math.max(1, length), step: 0.005 }, length, (value) => {
      this.change({ links: session.arm.robot.links.with(i, value) });
    }));
    this.limits = limits.flatMap((_, i) => ["minimum", "maximum"].map((word, end) => {
      const ariaLabel = `${joints[i].name}, ${word} angle, radians`;
      const input = make("input", { type: "number", id: `stop-${i}-${end}`, step: "any", min: String(-WIDEST), max: String(WIDEST), autocomplete: "off", ariaLabel });
      input.addEventListener("change", () => this.setLimit(i, end, input));
      return input;
    }));
    byId("joints", HTMLElement).replaceChildren(...this.angles.map(({ element }) => element));
    byId("lengths", HTMLElement).replaceChildren(...this.lengths.map(({ element }) => element));
    byId("intervals", HTMLElement).replaceChildren(...limits.map((_, i) => make("div", { className: "interval" },
      make("span", { className: "name" }, joints[i].name), this.limits[2 * i], make("span", {}, "to"), this.limits[2 * i + 1], make("span", { className: "unit" }, "rad"))));
  }

  /** @param {number} count */
  setCount(count) {
    const { links, joint_limits: limits } = this.session.arm.robot;
    const grown = Array.from({ length: count }, (_, i) => links[i] ?? links[links.length - 1]);
    this.change({ links: grown, joint_limits: limits && grown.map((_, i) => limits[i] ?? LIMITS) });
  }

  /** @param {number} joint @param {number} end  0 or 1 @param {HTMLInputElement} input */
  setLimit(joint, end, input) {
    const { arm: { joints, robot: { joint_limits: limits = [] } } } = this.session;
    const [low, high] = limits[joint].with(end, input.value.trim() === "" ? NaN : Number(input.value));
    if (Math.abs(low) <= WIDEST && Math.abs(high) <= WIDEST && low < high) this.change({ joint_limits: limits.with(joint, [low, high]) }, input);
    else this.refuse(`The limits of ${joints[joint].name} must be two numbers from \u22126.28 to 6.28, the lower first.`, input);
  }

  /** Changes the arm; what the core refuses is explained. @param {Partial<ArmRobot>} changes @param {HTMLInputElement} [input]  where it was asked for */
  change(changes, input) {
    const { session } = this;
    const robot = /** @type {ArmRobot} */ ({ ...session.arm.robot, ...changes });
    if (!robot.joint_limits) delete robot.joint_limits;
    try {
      session.changeArm({ ...session.arm.document, robot });
      input?.removeAttribute("aria-invalid");
    } catch (error) {
      this.refuse(error instanceof Error ? error.message : String(error), input);
      this.hasLimits.checked = session.arm.hasLimits;
    }
  }

  /** @param {string} reason @param {HTMLInputElement} [input] */
  refuse(reason, input) {
    input?.setAttribute("aria-invalid", "true");
    const element = byId("arm-reason", HTMLElement);
    element.textContent = reason;
    element.hidden = reason === "";
  }
}
