/** An arm: its document, the core's scenario of it, its configuration and what the core computes of it. */
import { Scenario } from "planarium";
import { wrap } from "planarium/draw";
import { coordinatesOf, fitted } from "../domain/coordinates.js";
import { ellipseOf, tipOf } from "./jacobian.js";

/** @import { ScenarioDocument } from "../domain/types.js" */
/** @typedef {Extract<import("planarium").Robot, { type: "arm" }>} ArmRobot */

export class Arm {
  /** @param {ScenarioDocument | string} document @param {ArrayLike<number>} q @throws {Error} with `code` and `pointer`, if the core refuses it */
  constructor(document, q) {
    this.scenario = Scenario.parse(document);
    const { robot } = this.scenario;
    if (robot !== "arm") {
      this.scenario.free();
      throw Object.assign(new Error(`This page is for arms; the robot of this scenario is a ${robot.replace("_", " ")}.`), { code: "unsupported", pointer: "/robot/type" });
    }
    this.document = this.scenario.document();
    this.joints = coordinatesOf({ scenario: this.scenario, document: this.document });
    this.pose = this.poseAt(q);
  }

  get q() { return this.pose.q; }
  get parts() { return this.pose.parts; }
  get check() { return this.pose.check; }
  get ellipse() { return this.pose.ellipse; }
  get robot() { return /** @type {ArmRobot} */ (this.document.robot); }
  get dimension() { return this.robot.links.length; }
  get base() { return this.robot.base; }
  get hasLimits() { return this.robot.joint_limits !== undefined; }

  /** The sum of its links, metres. */
  get reach() { return this.robot.links.reduce((sum, link) => sum + link, 0); }

  get tip() { return tipOf(this.parts); }

  /** The direction of the last link, radians in (-pi, pi]. */
  get orientation() { return wrap(this.q.reduce((sum, angle) => sum + angle, 0)); }

  /** A configuration of this arm from one with more or fewer joints. @param {ArrayLike<number>} q */
  fitted(q) { return fitted(q, this.joints); }

  /** @param {ArrayLike<number>} values */
  poseAt(values) {
    const q = this.fitted(values);
    const parts = this.scenario.footprint(q);
    return { q, parts, check: this.scenario.check(q), ellipse: ellipseOf(parts) };
  }

  /** @param {ArrayLike<number>} q */
  moveTo(q) { this.pose = this.poseAt(q); }

  /** @param {ArrayLike<number>} q */
  isFree(q) { return this.scenario.check(Float64Array.from(q)).free; }

  free() { this.scenario.free(); }
}
