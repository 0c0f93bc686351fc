/**
 * Handles to drag: the tip, a link, a body, the target, a configuration in the square, a coordinate on its axis. And
 * keys.
 */
import { wrap } from "planarium/draw";
import { sizeOf, slidesOf } from "../domain/coordinates.js";
import { placedHandles } from "../draw/placed-handles.js";
import { contains } from "../domain/obstacles.js";
import { distanceToSegment } from "../draw/trace.js";
import { watchArrows, watchDrag } from "../draw/drag.js";

/** @import { Grip, Place } from "../draw/drag.js" */
/** @import { Figure } from "../draw/figure.js" */
/** @import { Point } from "../domain/types.js" */
/** @import { ParallelAxes } from "./parallel-axes.js" */
/** @import { ReachSession } from "./session.js" */
/** @import { Square } from "./square.js" */
/** @import { Workspace } from "./workspace.js" */

/** The step of an arrow key, as a part of the reach of an arm or of the size of a body's world. */
const STEP = 0.01;
/** The turn of a key, five degrees; of a link that slides, a part of the reach. */
const TURN = Math.PI / 36;
const SLIDE = 0.02;

/**
 * @param {ReachSession} session @param {HTMLElement} stage   receives keys
 * @param {{ workspace: Figure<Workspace>, square: Figure<Square>, axes: Figure<ParallelAxes> }} figures
 * @param {(target: Point) => void} setTarget
 */
export function watchHandles(session, stage, { workspace, square, axes }, setTarget) {
  const { app } = session;
  watchDrag(app, workspace.canvas, grabInWorkspace);
  watchDrag(app, square.canvas, ({ x, y, isTouch, near }) => {
    const [px, py] = square.drawing.place(session.robot.q);
    if (isTouch && Math.hypot(px - x, py - y) > near) return null;
    return (place) => session.moveTo(square.drawing.view.toPlane(place.x, place.y));
  });
  watchDrag(app, axes.canvas, ({ x, near }) => {
    const joint = axes.drawing.jointAt(x, near);
    return joint < 0 ? null : (place) => session.setCoordinate(joint, axes.drawing.valueAt(joint, place.y));
  });
  watchArrows(stage, (coordinate, direction, factor) => {
    const { robot, mode, target, tipGoal } = session;
    if (coordinate > 1) {
      if (!robot.isArm) session.turn(coordinate, direction * TURN);
      return !robot.isArm;
    }
    const [...point] = mode === "solve" ? target : tipGoal && !tipGoal.reached ? tipGoal.wanted : robot.tip;
    point[coordinate] += direction * factor * STEP * (robot.isArm ? robot.reach : sizeOf(robot.scenario));
    moveEnd(point);
    return true;
  });
  stage.addEventListener("keydown", (event) => {
    // The key itself: with Shift its character depends on the layout.
    const joint = Number(/^(?:Digit|Numpad)([1-8])$/.exec(event.code)?.[1]) - 1;
    if (
      event.target !== stage ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      !session.robot.isArm ||
      !(joint < session.robot.dimension)
    )
      return;
    event.preventDefault();
    const by = session.robot.coordinates[joint].unit === "m" ? SLIDE * session.robot.reach : TURN;
    session.turn(joint, event.shiftKey ? -by : by);
  });

  /** Moves the tip or the body; in inverse kinematics the target. @param {Point} point */
  function moveEnd(point) {
    if (session.mode === "solve") setTarget(point);
    else if (session.robot.isArm) session.moveTip(point);
    else session.moveTo([...point, session.robot.q[2]]);
  }

  /** @param {Place} place @returns {Grip | null} */
  function grabInWorkspace({ x, y, near, isTouch }) {
    const { robot, mode, target } = session;
    const { view } = workspace.drawing;
    const isNear = (/** @type {number[]} */ [px, py]) => Math.hypot(px - x, py - y) <= near;
    const pointOf = (/** @type {Place} */ place) => view.toPlane(place.x, place.y);
    if (!robot.isArm) return grabBody(pointOf({ x, y, near, isTouch }), isTouch, isNear, pointOf);
    if (mode === "solve" && isNear(view.place(target))) return (place) => setTarget(pointOf(place));
    if (isNear(view.place(robot.tip))) return (place) => session.moveTip(pointOf(place));
    const [px, py] = view.toPlane(x, y);
    const distances = robot.parts.map((part) =>
      part.type === "capsule" ? distanceToSegment(px, py, part.a, part.b) - part.radius : Infinity,
    );
    const least = Math.min(...distances);
    const link = distances.indexOf(least);
    if (least * view.scaleX <= near)
      return robot.coordinates[link].unit === "m" ? slideLink(link, px, py, pointOf) : turnLink(link, px, py, pointOf);
    // A finger elsewhere scrolls the page; a click with the mouse moves the tip or the target there.
    return isTouch ? null : (place) => moveEnd(pointOf(place));
  }

  /**
   * Turns a body by the handle in front of it, or moves it.
   * @param {Point} point
   * @param {boolean} isTouch
   * @param {(place: number[]) => boolean} isNear  CSS pixels
   * @param {(place: Place) => Point} pointOf
   * @returns {Grip | null}
   */
  function grabBody([px, py], isTouch, isNear, pointOf) {
    const { parts, q } = session.robot;
    const [x, y] = q;
    const [middle, front] = placedHandles(workspace.drawing.view, parts, q);
    if (isNear(front)) {
      return (place) => {
        const [toX, toY] = pointOf(place);
        session.setCoordinate(2, Math.atan2(toY - y, toX - x));
      };
    }
    const isInside = isNear(middle) || parts.some((part) => part.type === "polygon" && contains(part.vertices, px, py));
    if (isTouch && !isInside) return null;
    // What was grabbed stays under the pointer; a click elsewhere moves the reference point there.
    const [dx, dy] = isInside ? [x - px, y - py] : [0, 0];
    return (place) => {
      const [toX, toY] = pointOf(place);
      moveEnd([toX + dx, toY + dy]);
    };
  }

  /**
   * Slides a link along its direction with the pointer.
   * @param {number} joint
   * @param {number} px
   * @param {number} py
   * @param {(place: Place) => Point} pointOf
   * @returns {Grip}
   */
  function slideLink(joint, px, py, pointOf) {
    const { robot } = session;
    const [before, angle] = [robot.q[joint], slidesOf(robot.arm, robot.q)[joint] ?? 0];
    return (place) => {
      const [x, y] = pointOf(place);
      session.setCoordinate(joint, before + (x - px) * Math.cos(angle) + (y - py) * Math.sin(angle));
    };
  }

  /**
   * Turns the joint of a link with the pointer.
   * @param {number} joint
   * @param {number} px
   * @param {number} py
   * @param {(place: Place) => Point} pointOf
   * @returns {Grip}
   */
  function turnLink(joint, px, py, pointOf) {
    /** The angle of the pointer from the link, about its joint. @param {number} x @param {number} y */
    const angleFromLink = (x, y) => {
      const part = session.robot.parts[joint];
      if (part?.type !== "capsule") return 0;
      return wrap(Math.atan2(y - part.a[1], x - part.a[0]) - Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]));
    };
    const offset = angleFromLink(px, py);
    return (place) =>
      session.setCoordinate(joint, session.robot.q[joint] + wrap(angleFromLink(...pointOf(place)) - offset));
  }
}
