/**
 * The panels of the coordinates and of the arm: coordinates, orientation of the last link, links, radius, joints and
 * their ranges.
 */
import { byId, make } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { withJoints } from "../domain/coordinates.js";
import { Slider, slidersOf } from "../widgets/slider.js";

/** @import { ArmRobot, LinkJoint } from "../domain/coordinates.js" */
/** @import { Robot } from "./robot.js" */
/** @import { ReachSession } from "./session.js" */

/** Links at most, as in the core. */
const MOST_LINKS = 8;
/** Joints that a fixed orientation needs. */
const ORIENTED = 3;
/** Joint limits at first, and at most, radians. */
const LIMITS = /** @type {[number, number]} */ ([-2.5, 2.5]);
const WIDEST = 2 * Math.PI;
/** The range of a link that begins to slide, metres. */
const RANGE = /** @type {[number, number]} */ ([0, 0.5]);

/** @param {ReachSession} session @param {() => void} onOrientation   another orientation is wanted */
export function showArmPanel(session, onOrientation) {
  const lengthRows = byId("lengths", HTMLElement);
  /** The kind of robot that the controls are for. */
  let kind = "";
  /** @type {Slider[]} */
  let angles = [];
  /** @type {Slider[]} */
  let lengths = [];
  /** The choice of each joint: it turns or it slides. @type {HTMLSelectElement[]} */
  let kinds = [];
  /**
   * The fields of the joints: limits or a range, and a fixed angle.
   * @type {{ input: HTMLInputElement, read: (joint: LinkJoint) => number }[]}
   */
  let fields = [];
  /** The joints that the fields are for. */
  let fielded = "";
  const setOrientation = (/** @type {number | null} */ angle) => {
    session.orientation = angle;
    onOrientation();
  };
  const isOriented = byId("keep", HTMLInputElement);
  isOriented.addEventListener("change", () => setOrientation(isOriented.checked ? session.robot.orientation : null));
  const direction = new Slider(
    { name: "direction", title: "orientation", unit: "rad", min: -Math.PI, max: Math.PI },
    0,
    setOrientation,
  );
  const hint = byId("keep-hint", HTMLElement);
  hint.before(direction.element);
  const count = new Slider({ name: "links", title: "Links", min: 1, max: MOST_LINKS, kind: "integer" }, 2, (length) => {
    const { joints, hasLimits } = session.robot;
    const { links } = session.robot.arm;
    const grown = Array.from({ length }, (_, i) => links[i] ?? links[links.length - 1]);
    change(
      { links: grown },
      grown.map((_, i) => joints[i] ?? turning(hasLimits)),
    );
  });
  const thickness = new Slider(
    { name: "radius", title: "Radius", unit: "m", min: 0, max: 0.15, step: 0.005 },
    0,
    (radius) => change({ radius }),
  );
  lengthRows.before(count.element);
  lengthRows.after(thickness.element);
  const isLimited = byId("stops", HTMLInputElement);
  isLimited.addEventListener("change", () =>
    change(
      {},
      session.robot.joints.map((joint) => (joint.type === "prismatic" ? joint : turning(isLimited.checked))),
    ),
  );
  const takesBack = byId("back", HTMLInputElement);
  takesBack.addEventListener("change", () => {
    session.takesBack = takesBack.checked;
  });
  const differs = comparer();
  session.app.onShow(show);

  function show() {
    const { robot, orientation } = session;
    const { dimension } = robot;
    // Controls are rebuilt only if their number differs, so that a slider can be held meanwhile.
    if (kind !== robot.scenario.robot || dimension !== angles.length || fielded !== fieldsOf(session)) build();
    angles.forEach((slider, i) => slider.show(robot.q[i]));
    takesBack.checked = session.takesBack;
    isOriented.disabled = dimension < ORIENTED;
    isOriented.checked = orientation !== null;
    hint.hidden = dimension >= ORIENTED;
    direction.element.hidden = orientation === null;
    if (orientation !== null) direction.show(orientation);
    if (differs("robot", robot)) showRobot(robot);
  }

  /** @param {Robot} robot */
  function showRobot(robot) {
    const { isArm, dimension, coordinates } = robot;
    refuse("");
    angles.forEach((slider, i) => slider.setLimits(coordinates[i].low, coordinates[i].high));
    if (!isArm) return;
    const { arm, hasLimits, joints } = robot;
    count.show(dimension);
    thickness.show(arm.radius ?? 0);
    isLimited.checked = hasLimits;
    lengths.forEach((slider, i) => {
      slider.setLimits(slider.info.min, Math.max(slider.info.max, arm.links[i]));
      slider.show(arm.links[i]);
    });
    kinds.forEach((select, i) => {
      select.value = joints[i].type;
    });
    for (const { input, read } of fields) {
      if (document.activeElement !== input) input.value = read(joints[Number(input.dataset.joint)]).toFixed(2);
    }
  }

  function build() {
    const { coordinates, q, isArm, scenario } = session.robot;
    kind = scenario.robot;
    fielded = fieldsOf(session);
    const { links = [] } = isArm ? session.robot.arm : {};
    const joints = isArm ? session.robot.joints : [];
    angles = slidersOf("joint-", coordinates, q, (i, angle) => session.setCoordinate(i, angle));
    lengths = links.map(
      (length, i) =>
        new Slider(
          { name: `link-${i}`, title: `link ${i + 1}`, unit: "m", min: 0.05, max: Math.max(1, length), step: 0.005 },
          length,
          (value) => {
            change({ links: session.robot.arm.links.with(i, value) });
          },
        ),
    );
    kinds = joints.map(({ type }, i) => {
      const select = make(
        "select",
        { id: `joint-${i}-type`, ariaLabel: `Link ${i + 1} turns or slides` },
        make("option", { value: "revolute" }, "turns"),
        make("option", { value: "prismatic" }, "slides"),
      );
      select.value = type;
      select.addEventListener("change", () => setKind(i, select.value === "prismatic"));
      return select;
    });
    fields = [];
    const field = (
      /** @type {number} */ i,
      /** @type {string} */ id,
      /** @type {string} */ word,
      /** @type {(joint: LinkJoint) => number} */ read,
      /** @type {(joint: LinkJoint, value: number) => LinkJoint | null} */ write,
    ) => {
      const input = make("input", {
        type: "number",
        id: `stop-${i}-${id}`,
        step: "any",
        ariaLabel: `${coordinates[i].name}, ${word}`,
        dataset: { joint: String(i) },
      });
      input.addEventListener("change", () => setField(i, input, write));
      fields.push({ input, read });
      return input;
    };
    /** The two ends of what a joint may do. @param {number} i @param {string} what */
    const ends = (i, what) =>
      ["minimum", "maximum"].map((word, end) =>
        field(
          i,
          String(end),
          `${word} ${what}`,
          (joint) => rangeOf(joint)[end],
          (joint, value) => {
            const [low, high] = rangeOf(joint).with(end, value);
            if (!(low < high)) return null;
            if (joint.type === "prismatic") return { ...joint, range: [low, high] };
            return Math.abs(low) <= WIDEST && Math.abs(high) <= WIDEST ? { ...joint, limits: [low, high] } : null;
          },
        ),
      );
    const rows = joints.map((joint, i) => {
      const row = make(
        "div",
        { className: "interval" },
        make("span", { className: "name" }, coordinates[i].name),
        kinds[i],
      );
      const slides = joint.type === "prismatic";
      if (!slides && !joint.limits) return row;
      const [from, to] = ends(i, slides ? "coordinate, metres" : "angle, radians");
      const angle = () =>
        field(
          i,
          "angle",
          "fixed angle to the link before, radians",
          (one) => (one.type === "prismatic" ? one.angle : 0),
          (one, value) => (one.type === "prismatic" && Number.isFinite(value) ? { ...one, angle: value } : null),
        );
      const fixed = slides ? [make("span", { className: "unit" }, "m at"), angle()] : [];
      const unit = make("span", { className: "unit" }, "rad");
      const interval = make("div", { className: "interval more" }, from, make("span", {}, "to"), to, ...fixed, unit);
      return make("div", {}, row, interval);
    });
    byId("joints", HTMLElement).replaceChildren(...angles.map(({ element }) => element));
    lengthRows.replaceChildren(...lengths.map(({ element }) => element));
    byId("intervals", HTMLElement).replaceChildren(...rows);
  }

  /** Makes a joint turn or slide. @param {number} i @param {boolean} slides */
  function setKind(i, slides) {
    const { joints, hasLimits } = session.robot;
    change({}, joints.with(i, slides ? { type: "prismatic", range: RANGE, angle: 0 } : turning(hasLimits)), kinds[i]);
  }

  /**
   * @param {number} i  the joint
   * @param {HTMLInputElement} input
   * @param {(joint: LinkJoint, value: number) => LinkJoint | null} write
   */
  function setField(i, input, write) {
    const { coordinates, joints } = session.robot;
    const joint = write(joints[i], input.value.trim() === "" ? NaN : Number(input.value));
    if (joint) return change({}, joints.with(i, joint), input);
    const { name } = coordinates[i];
    const reason =
      joints[i].type === "prismatic"
        ? `The range of ${name} must be two numbers, the lower first, and its angle a number.`
        : `The limits of ${name} must be two numbers from \u22126.28 to 6.28, the lower first.`;
    refuse(reason, input);
  }

  /**
   * Changes the arm; what the core refuses is explained.
   * @param {Partial<ArmRobot>} changes
   * @param {LinkJoint[]} [joints]
   * @param {HTMLInputElement | HTMLSelectElement} [input]  where it was asked for
   */
  function change(changes, joints = session.robot.joints, input = undefined) {
    const arm = withJoints({ ...session.robot.arm, ...changes }, joints);
    try {
      session.changeArm({ ...session.robot.document, robot: arm });
      input?.removeAttribute("aria-invalid");
    } catch (error) {
      refuse(error instanceof Error ? error.message : String(error), input);
      isLimited.checked = session.robot.hasLimits;
      kinds.forEach((select, i) => {
        select.value = session.robot.joints[i].type;
      });
    }
  }

  /** @param {string} reason @param {HTMLInputElement | HTMLSelectElement} [input] */
  function refuse(reason, input) {
    input?.setAttribute("aria-invalid", "true");
    const element = byId("arm-reason", HTMLElement);
    element.textContent = reason;
    element.hidden = reason === "";
  }
}

/** A joint that turns. @param {boolean} isLimited @returns {LinkJoint} */
function turning(isLimited) {
  return { type: "revolute", limits: isLimited ? LIMITS : undefined };
}

/** @param {LinkJoint} joint */
function rangeOf(joint) {
  return (joint.type === "prismatic" ? joint.range : joint.limits) ?? LIMITS;
}

/** Which fields the joints need, as a key. @param {ReachSession} session */
function fieldsOf({ robot }) {
  return robot.isArm
    ? robot.joints.map((joint) => (joint.type === "prismatic" ? "p" : joint.limits ? "l" : "r")).join("")
    : "";
}
