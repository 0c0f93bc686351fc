/** The arm on the stage: its document, the core's scenario of it, its pose and what follows from that. */
import { contained, coordinatesOf, wrap } from "../domain/coordinates.js";
import { ellipseOf, tipOf } from "./jacobian.js";

/** @import { Check, Coordinate, Library, Part, Scenario } from "../domain/types.js" */
/** @import { Ellipse } from "./jacobian.js" */
/** @import { ArmRobot, Point, ScenarioDocument } from "./types.js" */

export class Arm {
  /** @param {Library} library @param {ScenarioDocument | string} document @param {ArrayLike<number>} q @throws {Error} with `code` and `pointer`, where the core refuses it */
  constructor(library, document, q) {
    this.library = library;
    /** @type {Scenario} */
    this.scenario = library.Scenario.parse(document);
    if (this.scenario.robot !== "arm") {
      const { robot } = this.scenario;
      this.scenario.free();
      throw Object.assign(new Error(`The robot is a ${robot.replace("_", " ")}; this page is about arms.`), { code: "unsupported", pointer: "/robot/type" });
    }
    this.document = this.scenario.document();
    /** @type {Coordinate[]} */
    this.joints = coordinatesOf({ scenario: this.scenario, document: this.document });
    this.circles = this.joints.map(({ isCircle }) => isCircle);
    /** What the space is, as a number that differs where it does. */
    this.version = Arm.count++;
    /** @type {Float64Array} */
    this.q = new Float64Array(this.dimension);
    /** @type {Part[]} */
    this.parts = [];
    /** @type {Check} */
    this.check = { free: true, touching: [] };
    /** @type {Ellipse} */
    this.ellipse = { major: 0, minor: 0, angle: 0, manipulability: 0 };
    this.turn(this.fitted(q));
  }

  static count = 0;

  get robot() { return /** @type {ArmRobot} */ (this.document.robot); }
  get dimension() { return this.robot.links.length; }
  get base() { return this.robot.base; }
  get hasLimits() { return this.robot.joint_limits !== undefined; }

  /** How far it reaches, metres. */
  get reach() { return this.robot.links.reduce((sum, link) => sum + link, 0); }

  /** @returns {Point} */
  get tip() { return tipOf(this.parts); }

  /** The direction of the last link, radians in (-pi, pi]. */
  get orientation() { return wrap(this.q.reduce((sum, angle) => sum + angle, 0)); }

  /** A pose for this arm, of one that may have had more or fewer joints. @param {ArrayLike<number>} q */
  fitted(q) { return contained(Float64Array.from({ length: this.dimension }, (_, i) => q[i] ?? 0), this.joints); }

  /** Takes a pose. @param {ArrayLike<number>} q  within its joints' ranges, or a turn away */
  turn(q) {
    this.q = this.fitted(q);
    this.parts = this.scenario.footprint(this.q);
    this.check = this.scenario.check(this.q);
    this.ellipse = ellipseOf(this.parts);
  }

  /** Turns one joint alone. @param {number} joint @param {number} angle */
  turnJoint(joint, angle) {
    const q = Float64Array.from(this.q);
    q[joint] = angle;
    this.turn(q);
  }

  /** Does another pose touch nothing? @param {ArrayLike<number>} q */
  isFree(q) { return this.scenario.check(Float64Array.from(q)).free; }

  free() { this.scenario.free(); }
}
