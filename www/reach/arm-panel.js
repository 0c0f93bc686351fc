/** The panels of the coordinates and of the arm: angles, orientation of the last link, links, radius and joint limits. */
import { byId, make } from "../app/dom.js";
import { Slider } from "../widgets/slider.js";

/** @import { ArmRobot } from "./robot.js" */
/** @import { ReachSession, Change } from "./session.js" */

/** Links at most, as in the core. */
const MOST_LINKS = 8;
/** Joints that a fixed orientation needs. */
const ORIENTED = 3;
/** Joint limits at first, and at most, radians. */
const LIMITS = /** @type {[number, number]} */ ([-2.5, 2.5]);
const WIDEST = 2 * Math.PI;

/** @param {ReachSession} session @param {() => void} onOrientation   another orientation is wanted */
export function showArmPanel(session, onOrientation) {
  const lengthRows = byId("lengths", HTMLElement);
  /** The kind of robot that the controls are for. */
  let kind = "";
  /** @type {Slider[]} */
  let angles = [];
  /** @type {Slider[]} */
  let lengths = [];
  /** The fields of the joint limits, two for each joint. @type {HTMLInputElement[]} */
  let ends = [];
  const setOrientation = (/** @type {number | null} */ angle) => {
    session.orientation = angle;
    onOrientation();
  };
  const isOriented = byId("keep", HTMLInputElement);
  isOriented.addEventListener("change", () => setOrientation(isOriented.checked ? session.robot.orientation : null));
  const direction = new Slider({ name: "direction", title: "orientation", unit: "rad", min: -Math.PI, max: Math.PI }, 0, setOrientation);
  const hint = byId("keep-hint", HTMLElement);
  hint.before(direction.element);
  const count = new Slider({ name: "links", title: "Links", min: 1, max: MOST_LINKS, kind: "integer" }, 2, (length) => {
    const { links, joint_limits: limits } = session.robot.arm;
    const grown = Array.from({ length }, (_, i) => links[i] ?? links[links.length - 1]);
    change({ links: grown, joint_limits: limits && grown.map((_, i) => limits[i] ?? LIMITS) });
  });
  const thickness = new Slider({ name: "radius", title: "Radius", unit: "m", min: 0, max: 0.15, step: 0.005 }, 0, (radius) => change({ radius }));
  lengthRows.before(count.element);
  lengthRows.after(thickness.element);
  const isLimited = byId("stops", HTMLInputElement);
  isLimited.addEventListener("change", () => change({ joint_limits: isLimited.checked ? session.robot.arm.links.map(() => LIMITS) : undefined }));
  const takesBack = byId("back", HTMLInputElement);
  takesBack.addEventListener("change", () => { session.takesBack = takesBack.checked; });
  session.onChange(show);

  /** @param {Change} what */
  function show(what) {
    const { robot, orientation } = session;
    const { arm, isArm, hasLimits, dimension } = robot;
    // Controls are rebuilt only if their number differs, so that a slider can be held meanwhile.
    if (kind !== robot.scenario.robot || dimension !== angles.length || ends.length !== (hasLimits ? 2 * dimension : 0)) build();
    angles.forEach((slider, i) => slider.show(robot.q[i]));
    takesBack.checked = session.takesBack;
    isOriented.disabled = dimension < ORIENTED;
    isOriented.checked = orientation !== null;
    hint.hidden = dimension >= ORIENTED;
    direction.element.hidden = orientation === null;
    if (orientation !== null) direction.show(orientation);
    if (what !== "robot") return;
    refuse("");
    angles.forEach((slider, i) => slider.setLimits(robot.coordinates[i].low, robot.coordinates[i].high));
    if (!isArm) return;
    count.show(dimension);
    thickness.show(arm.radius ?? 0);
    isLimited.checked = hasLimits;
    lengths.forEach((slider, i) => {
      slider.setLimits(slider.info.min, Math.max(slider.info.max, arm.links[i]));
      slider.show(arm.links[i]);
    });
    const limits = (arm.joint_limits ?? []).flat();
    ends.forEach((input, k) => { if (document.activeElement !== input) input.value = limits[k].toFixed(2); });
  }

  function build() {
    const { coordinates, q, isArm, scenario } = session.robot;
    kind = scenario.robot;
    const { links = [], joint_limits: limits = [] } = isArm ? session.robot.arm : {};
    angles = coordinates.map(({ name, low, high, unit }, i) => new Slider({ name: `joint-${i}`, title: name, unit, min: low, max: high }, q[i], (angle) => session.setCoordinate(i, angle)));
    lengths = links.map((length, i) => new Slider({ name: `link-${i}`, title: `link ${i + 1}`, unit: "m", min: 0.05, max: Math.max(1, length), step: 0.005 }, length, (value) => {
      change({ links: session.robot.arm.links.with(i, value) });
    }));
    ends = limits.flatMap((_, i) => ["minimum", "maximum"].map((word, end) => {
      const ariaLabel = `${coordinates[i].name}, ${word} angle, radians`;
      const input = make("input", { type: "number", id: `stop-${i}-${end}`, step: "any", min: String(-WIDEST), max: String(WIDEST), autocomplete: "off", ariaLabel });
      input.addEventListener("change", () => setLimit(i, end, input));
      return input;
    }));
    byId("joints", HTMLElement).replaceChildren(...angles.map(({ element }) => element));
    lengthRows.replaceChildren(...lengths.map(({ element }) => element));
    byId("intervals", HTMLElement).replaceChildren(...limits.map((_, i) => make("div", { className: "interval" },
      make("span", { className: "name" }, coordinates[i].name), ends[2 * i], make("span", {}, "to"), ends[2 * i + 1], make("span", { className: "unit" }, "rad"))));
  }

  /** @param {number} joint @param {number} end  0 or 1 @param {HTMLInputElement} input */
  function setLimit(joint, end, input) {
    const { coordinates, arm: { joint_limits: limits = [] } } = session.robot;
    const [low, high] = limits[joint].with(end, input.value.trim() === "" ? NaN : Number(input.value));
    if (Math.abs(low) <= WIDEST && Math.abs(high) <= WIDEST && low < high) change({ joint_limits: limits.with(joint, [low, high]) }, input);
    else refuse(`The limits of ${coordinates[joint].name} must be two numbers from \u22126.28 to 6.28, the lower first.`, input);
  }

  /** Changes the arm; what the core refuses is explained. @param {Partial<ArmRobot>} changes @param {HTMLInputElement} [input]  where it was asked for */
  function change(changes, input) {
    const arm = /** @type {ArmRobot} */ ({ ...session.robot.arm, ...changes });
    if (!arm.joint_limits) delete arm.joint_limits;
    try {
      session.changeArm({ ...session.robot.document, robot: arm });
      input?.removeAttribute("aria-invalid");
    } catch (error) {
      refuse(error instanceof Error ? error.message : String(error), input);
      isLimited.checked = session.robot.hasLimits;
    }
  }

  /** @param {string} reason @param {HTMLInputElement} [input] */
  function refuse(reason, input) {
    input?.setAttribute("aria-invalid", "true");
    const element = byId("arm-reason", HTMLElement);
    element.textContent = reason;
    element.hidden = reason === "";
  }
}
