/**
 * The robot in the hand: a point of the configuration square is a pose; a link that is dragged turns its joint, the end of the last
 * one leads the arm; a disc goes
 * where it is put, a body too, unless it is taken by the handle that turns it. What a pointer says in pixels of a pane becomes a configuration.
 */
import { distanceToSegment } from "../../draw/trace.js";
import { contained, coordinatesOf, wrap } from "../../domain/coordinates.js";

/** @import { Pane } from "../stage/pane.js" */
/** @import { CSpace } from "../stage/cspace-pane.js" */

/** How near to a part a pointer must be to hold it, CSS pixels: a finger is less exact than a mouse. */
const REACH = 18;
/** How near to the end of an arm to lead it by that. */
const TIP = 12;

export class Grip {
  constructor() {
    /** Which joint is held, or behind the last one the end effector, and by how much the pointer was off its link when it was taken. @type {{ joint: number, offset: number } | null} */
    this.held = null;
  }

  /** A point of the configuration square. @param {CSpace} pane @param {number} x @param {number} y @returns {Float64Array | null} */
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

  /** Takes hold of the robot in the workspace. @param {Pane} pane @param {number} x @param {number} y @returns {Float64Array | null} null: there is nothing to hold here */
  take(pane, x, y) {
    const { lane, view } = pane;
    if (!lane || !view) return null;
    const { scenario } = lane;
    this.held = null;
    if (lane.shown.placed) return lane.shown.placed.take(pane, x, y);
    if (scenario.robot === "disc") return this.drag(pane, x, y);
    const pose = lane.pose ?? lane.shown.start;
    if (!pose) return null;
    const parts = scenario.footprint(pose);
    const [px, py] = view.toPlane(x, y);
    let nearest = -1;
    let least = Infinity;
    parts.forEach((part, i) => {
      if (part.type !== "capsule") return;
      const distance = distanceToSegment(px, py, part.a, part.b) - part.radius;
      if (distance < least) { least = distance; nearest = i; }
    });
    const last = parts[parts.length - 1];
    if (last.type === "capsule" && Math.hypot(px - last.b[0], py - last.b[1]) * view.scaleX <= TIP) {
      this.held = { joint: parts.length, offset: 0 };
      return Float64Array.from(pose);
    }
    if (nearest < 0 || least * view.scaleX > REACH) return null;
    const part = parts[nearest];
    if (part.type !== "capsule") return null;
    const link = Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]);
    this.held = { joint: nearest, offset: Math.atan2(py - part.a[1], px - part.a[0]) - link };
    return Float64Array.from(pose);
  }

  /** @param {Pane} pane @param {number} x @param {number} y @returns {Float64Array | null} */
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
    const part = scenario.footprint(hand)[this.held.joint];
    if (part.type !== "capsule") return null;
    const link = Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]);
    const wanted = Math.atan2(py - part.a[1], px - part.a[0]) - this.held.offset;
    const next = Float64Array.from(hand);
    next[this.held.joint] += wrap(wanted - link);
    return contained(next, coordinates);
  }
}
