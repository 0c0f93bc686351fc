/** Handles to drag: the tip, a link, the target, a configuration in the square, a joint on its axis. */
import { wrap } from "planarium/draw";
import { distanceToSegment } from "../draw/trace.js";
import { watchArrows, watchDrag } from "../draw/drag.js";

/** @import { Grip, Place } from "../draw/drag.js" */
/** @import { Figure } from "../draw/figure.js" */
/** @import { Point } from "../domain/types.js" */
/** @import { ParallelAxes } from "./parallel-axes.js" */
/** @import { ArmSession } from "./session.js" */
/** @import { Square } from "./square.js" */
/** @import { Workspace } from "./workspace.js" */

/** The step of an arrow key, as a part of the arm's reach. */
const STEP = 0.01;

/**
 * @param {ArmSession} session @param {HTMLElement} stage   receives arrow keys
 * @param {{ workspace: Figure<Workspace>, square: Figure<Square>, axes: Figure<ParallelAxes> }} figures
 * @param {(target: Point) => void} setTarget
 */
export function watchHandles(session, stage, { workspace, square, axes }, setTarget) {
  const { app } = session;
  watchDrag(app, workspace.canvas, grabInWorkspace);
  watchDrag(app, square.canvas, ({ x, y, isTouch, near }) => {
    const [px, py] = square.drawing.place(session.arm.q);
    if (isTouch && Math.hypot(px - x, py - y) > near) return null;
    return (place) => session.moveTo(square.drawing.view.toPlane(place.x, place.y));
  });
  watchDrag(app, axes.canvas, ({ x, near }) => {
    const joint = axes.drawing.jointAt(x, near);
    return joint < 0 ? null : (place) => session.turnJoint(joint, axes.drawing.valueAt(joint, place.y));
  });
  watchArrows(stage, (coordinate, direction, factor) => {
    if (coordinate > 1) return false;
    const { arm, mode, target, tipGoal } = session;
    const [...point] = mode === "solve" ? target : tipGoal && !tipGoal.reached ? tipGoal.wanted : arm.tip;
    point[coordinate] += direction * factor * STEP * arm.reach;
    moveEnd(point);
    return true;
  });

  /** Moves the tip; in inverse kinematics the target. @param {Point} point */
  function moveEnd(point) {
    if (session.mode === "solve") setTarget(point);
    else session.moveTip(point);
  }

  /** @param {Place} place @returns {Grip | null} */
  function grabInWorkspace({ x, y, near, isTouch }) {
    const { arm, mode, target } = session;
    const { view } = workspace.drawing;
    const isNear = (/** @type {Point} */ point) => Math.hypot(view.x(point[0]) - x, view.y(point[1]) - y) <= near;
    const pointOf = (/** @type {Place} */ place) => view.toPlane(place.x, place.y);
    if (mode === "solve" && isNear(target)) return (place) => setTarget(pointOf(place));
    if (isNear(arm.tip)) return (place) => session.moveTip(pointOf(place));
    const [px, py] = view.toPlane(x, y);
    const distances = arm.parts.map((part) => (part.type === "capsule" ? distanceToSegment(px, py, part.a, part.b) - part.radius : Infinity));
    const least = Math.min(...distances);
    if (least * view.scaleX <= near) return turnLink(distances.indexOf(least), px, py, pointOf);
    // A finger elsewhere scrolls the page; a click with the mouse moves the tip or the target there.
    return isTouch ? null : (place) => moveEnd(pointOf(place));
  }

  /** Turns the joint of a link with the pointer. @param {number} joint @param {number} px @param {number} py @param {(place: Place) => Point} pointOf @returns {Grip} */
  function turnLink(joint, px, py, pointOf) {
    /** The angle of the pointer from the link, about its joint. @param {number} x @param {number} y */
    const angleFromLink = (x, y) => {
      const part = session.arm.parts[joint];
      if (part?.type !== "capsule") return 0;
      return wrap(Math.atan2(y - part.a[1], x - part.a[0]) - Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]));
    };
    const offset = angleFromLink(px, py);
    return (place) => session.turnJoint(joint, session.arm.q[joint] + wrap(angleFromLink(...pointOf(place)) - offset));
  }
}
