/**
 * The robot in the hand: a point of the configuration square is a pose; a link that is dragged turns its joint; a disc
 * goes where it is put.
 */
import { shownPose } from "./picture.js";

/** @import { Pane } from "./pane.js" */
/** @import { Picture } from "./picture.js" */

/** How near to a part a pointer must be to hold it, CSS pixels. */
const REACH = 18;

export class Grip {
  /**
   * @param {Pane} workspace @param {Pane} cspace
   * @param {() => Picture | null} picture
   * @param {(pose: Float64Array) => void} onPose
   */
  constructor(workspace, cspace, picture, onPose) {
    this.picture = picture;
    this.onPose = onPose;
    /** Which joint is held, and by how much the pointer was off its link when it was taken. @type {{ joint: number, offset: number } | null} */
    this.held = null;
    listen(cspace, (x, y) => this.square(cspace, x, y), (x, y) => this.square(cspace, x, y));
    listen(workspace, (x, y) => this.take(workspace, x, y), (x, y) => this.drag(workspace, x, y));
  }

  /** @param {Pane} pane @param {number} x @param {number} y @returns {boolean} */
  square(pane, x, y) {
    if (!pane.view) return false;
    const [a, b] = pane.view.toPlane(x, y);
    const { min, max } = pane.view.box;
    this.onPose(Float64Array.of(clamp(a, min[0], max[0]), clamp(b, min[1], max[1])));
    return true;
  }

  /** @param {Pane} pane @param {number} x @param {number} y @returns {boolean} */
  take(pane, x, y) {
    const picture = this.picture();
    if (!picture || !pane.view) return false;
    if (picture.scenario.robot === "disc") return this.drag(pane, x, y);
    const pose = shownPose(picture) ?? picture.start;
    if (!pose) return false;
    const parts = picture.scenario.footprint(pose);
    const [px, py] = pane.view.toPlane(x, y);
    let nearest = -1;
    let least = Infinity;
    parts.forEach((part, i) => {
      if (part.type !== "capsule") return;
      const distance = distanceToSegment(px, py, part.a, part.b) - part.radius;
      if (distance < least) { least = distance; nearest = i; }
    });
    if (nearest < 0 || least * pane.view.scaleX > REACH) return false;
    const part = parts[nearest];
    if (part.type !== "capsule") return false;
    const link = Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]);
    this.held = { joint: nearest, offset: Math.atan2(py - part.a[1], px - part.a[0]) - link };
    this.onPose(Float64Array.from(pose));
    return true;
  }

  /** @param {Pane} pane @param {number} x @param {number} y @returns {boolean} */
  drag(pane, x, y) {
    const picture = this.picture();
    if (!picture || !pane.view) return false;
    const [px, py] = pane.view.toPlane(x, y);
    if (picture.scenario.robot === "disc") {
      const { min, max } = picture.scenario.extent();
      this.onPose(Float64Array.of(clamp(px, min[0], max[0]), clamp(py, min[1], max[1])));
      return true;
    }
    const pose = picture.hand;
    if (!this.held || !pose) return false;
    const part = picture.scenario.footprint(pose)[this.held.joint];
    if (part.type !== "capsule") return false;
    const link = Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]);
    const wanted = Math.atan2(py - part.a[1], px - part.a[0]) - this.held.offset;
    const next = Float64Array.from(pose);
    const turned = next[this.held.joint] + wrap(wanted - link);
    const limits = jointLimits(picture, this.held.joint);
    next[this.held.joint] = limits ? clamp(turned, limits[0], limits[1]) : wrap(turned);
    this.onPose(next);
    return true;
  }
}

/**
 * One pointer at a time, captured while it is down.
 * @param {Pane} pane
 * @param {(x: number, y: number) => boolean} down   true: the pointer holds something
 * @param {(x: number, y: number) => boolean} move
 */
function listen(pane, down, move) {
  const canvas = pane.top.canvas;
  let holding = false;
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !event.isPrimary) return;
    holding = down(event.offsetX, event.offsetY);
    if (holding) canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (holding && event.isPrimary) move(event.offsetX, event.offsetY);
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { holding = false; });
}

/** The limits of a joint, or null where it is a circle. @param {Picture} picture @param {number} joint */
export function jointLimits(picture, joint) {
  const robot = picture.document.robot;
  return robot.type === "arm" && robot.joint_limits ? robot.joint_limits[joint] : null;
}

/** @param {number} value @param {number} low @param {number} high */
function clamp(value, low, high) { return Math.min(high, Math.max(low, value)); }

/** An angle brought between -pi and pi. @param {number} angle */
export function wrap(angle) {
  const turn = angle % (2 * Math.PI);
  if (turn > Math.PI) return turn - 2 * Math.PI;
  return turn <= -Math.PI ? turn + 2 * Math.PI : turn;
}

/** @param {number} x @param {number} y @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function distanceToSegment(x, y, a, b) {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const t = clamp(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy), 0, 1);
  return Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y);
}
