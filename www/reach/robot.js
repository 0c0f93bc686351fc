/**
 * The robot, an arm or a body: its document, the core's scenario of it, its configuration and what the core computes of
 * it.
 */
import { Scenario } from "planarium/full";
import { wrap } from "planarium/draw";
import { coordinatesOf, directionsOf, fitted, hasSlide, jointsOf, longestOf, slidesOf } from "../domain/coordinates.js";
import { robotName } from "../domain/names.js";
import { ellipseOf, tipOf } from "./jacobian.js";

/** @import { Point, ScenarioDocument } from "../domain/types.js" */
/** @import { ArmRobot } from "../domain/coordinates.js" */

export class Robot {
  /**
   * @param {ScenarioDocument | string} document
   * @param {ArrayLike<number>} q
   * @throws {Error} with `code` and `pointer`, if the core refuses it
   */
  constructor(document, q) {
    this.scenario = Scenario.parse(document);
    const { robot } = this.scenario;
    if (robot !== "arm" && robot !== "rigid_body") {
      this.scenario.free();
      throw Object.assign(
        new Error(`This page is for arms and bodies; the robot of this scenario is a ${robotName(robot)}.`),
        { code: "unsupported", pointer: "/robot/type" },
      );
    }
    this.isArm = robot === "arm";
    this.document = this.scenario.document();
    this.coordinates = coordinatesOf({ scenario: this.scenario, document: this.document });
    this.pose = this.poseAt(q);
  }

  get q() {
    return this.pose.q;
  }
  get parts() {
    return this.pose.parts;
  }
  get check() {
    return this.pose.check;
  }
  /** Without meaning for a body. */
  get ellipse() {
    return this.pose.ellipse;
  }
  get dimension() {
    return this.coordinates.length;
  }

  /** The document of an arm. */
  get arm() {
    return /** @type {ArmRobot} */ (this.document.robot);
  }
  get base() {
    return this.arm.base;
  }
  get joints() {
    return jointsOf(this.arm);
  }

  /** Whether every joint that turns has limits, and one does. */
  get hasLimits() {
    const turning = this.isArm ? this.joints.flatMap((joint) => (joint.type === "revolute" ? [joint] : [])) : [];
    return turning.length > 0 && turning.every(({ limits }) => limits !== undefined);
  }

  /** Whether a link of the arm slides. */
  get slides() {
    return this.isArm && hasSlide(this.arm);
  }

  /** The sum of the greatest lengths of the links of an arm, metres. */
  get reach() {
    return longestOf(this.arm).reduce((sum, link) => sum + link, 0);
  }

  /** The tip of an arm, the reference point of a body. @returns {Point} */
  get tip() {
    return this.isArm ? tipOf(this.parts) : [this.q[0], this.q[1]];
  }

  /** The direction of the last link, or of a body, radians in (-pi, pi]. */
  get orientation() {
    return this.isArm ? wrap(directionsOf(this.arm, this.q)[this.dimension - 1]) : this.q[2];
  }

  /** A configuration of this robot from one with more or fewer numbers. @param {ArrayLike<number>} q */
  fitted(q) {
    return fitted(q, this.coordinates);
  }

  /** @param {ArrayLike<number>} values */
  poseAt(values) {
    const q = this.fitted(values);
    const parts = this.scenario.footprint(q);
    return {
      q,
      parts,
      check: this.scenario.check(q),
      ellipse: ellipseOf(parts, this.isArm ? slidesOf(this.arm, q) : []),
    };
  }

  /** @param {ArrayLike<number>} q */
  moveTo(q) {
    this.pose = this.poseAt(q);
  }

  /** @param {ArrayLike<number>} q */
  isFree(q) {
    return this.scenario.check(Float64Array.from(q)).free;
  }

  free() {
    this.scenario.free();
  }
}
