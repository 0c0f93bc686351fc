/**
 * Turns a pointer that holds the robot into a configuration: a point of the configuration space; a link, which turns its joint; the tip,
 * which the arm follows; a disc, a body or its heading.
 */
import { wrap } from "planarium/draw";
import { distanceToSegment } from "../../draw/trace.js";
import { contained, coordinatesOf } from "../../domain/coordinates.js";

/** @import { Pane } from "../stage/pane.js" */
/** @import { CSpace } from "../stage/cspace-pane.js" */
/** @import { Scenario } from "../../domain/types.js" */

/** Distance within which a pointer holds a link, CSS pixels. */
const REACH = 18;
/** Distance within which it holds the tip. */
const TIP = 12;

export class Grip {
  constructor() {
    /** The joint, or its number plus one for the tip, and the angle between pointer and link. @type {{ joint: number, offset: number } | null} */
    this.held = null;
  }

  /** The configuration at a point of the configuration space. @param {CSpace} pane @param {number} x @param {number} y @returns {Float64Array | null} */
  square(pane, x, y) {
    const { lane, view } = pane;
    if (!lane || !view) return null;
    const coordinates = coordinatesOf(lane.shown);
    const pose = Float64Array.from(lane.pose ?? lane.shown.start ?? coordinates.map(({ low, high }) => (low + high) / 2));
    view.toPlane(x, y).forEach((value, i) => {
      const { low, high } = coordinates[pane.axes[i]];
      pose[pane.axes[i]] = Math.min(high, Math.max(low, value));
    });
    return pose;
  }

  /** Takes hold of the robot in the workspace. @param {Pane} pane @param {number} x @param {number} y @returns {Float64Array | null} null: the pointer is not on it */
  take(pane, x, y) {
    const { lane, view } = pane;
    if (!lane || !view) return null;
    const { scenario } = lane;
    this.held = null;
    if (lane.shown.placed) return lane.shown.placed.take(pane, x, y);
    if (scenario.robot === "disc") return this.drag(pane, x, y);
    const pose = lane.pose ?? lane.shown.start;
    if (!pose) return null;
    const links = linksOf(scenario, pose);
    const [px, py] = view.toPlane(x, y);
    const [tipX, tipY] = links[links.length - 1].b;
    if (Math.hypot(px - tipX, py - tipY) * view.scaleX <= TIP) this.held = { joint: links.length, offset: 0 };
    else {
      const distances = links.map(({ a, b, radius }) => distanceToSegment(px, py, a, b) - radius);
      const least = Math.min(...distances);
      if (least * view.scaleX > REACH) return null;
      const joint = distances.indexOf(least);
      this.held = { joint, offset: angleTo(links[joint], px, py) };
    }
    return Float64Array.from(pose);
  }

  /** Moves the robot with the pointer. @param {Pane} pane @param {number} x @param {number} y @returns {Float64Array | null} */
  drag(pane, x, y) {
    const { lane, view } = pane;
    if (!lane || !view) return null;
    const { scenario, hand, placed } = lane.shown;
    if (placed) return placed.drag(pane, x, y);
    const [px, py] = view.toPlane(x, y);
    const coordinates = coordinatesOf(lane.shown);
    if (scenario.robot === "disc") return contained(Float64Array.of(px, py), coordinates);
    if (!this.held || !hand) return null;
    if (this.held.joint === scenario.dimension) return Float64Array.from(scenario.follow(hand, [px, py]).configuration);
    const { joint, offset } = this.held;
    const next = Float64Array.from(hand);
    next[joint] += wrap(angleTo(linksOf(scenario, hand)[joint], px, py) - offset);
    return contained(next, coordinates);
  }
}

/** The links of an arm. @param {Scenario} scenario @param {ArrayLike<number>} pose */
function linksOf(scenario, pose) { return scenario.footprint(Float64Array.from(pose)).filter((part) => part.type === "capsule"); }

/** The angle from a link to a point. @param {ReturnType<typeof linksOf>[number]} link @param {number} x @param {number} y */
function angleTo({ a, b }, x, y) { return Math.atan2(y - a[1], x - a[0]) - Math.atan2(b[1] - a[1], b[0] - a[0]); }
