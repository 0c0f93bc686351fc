/** Dragging the target: its handles in the workspace, anywhere in the square, and arrow keys. */
import { directionsOf } from "../domain/coordinates.js";
import { watchArrows, watchDrag } from "../draw/drag.js";

/** @import { ArmRobot } from "../domain/coordinates.js" */
/** @import { Figure } from "../draw/figure.js" */
/** @import { NeighbourSession } from "./session.js" */
/** @import { Square } from "./square.js" */
/** @import { Workspace } from "./workspace.js" */

/** The step of an arrow key, as a part of the coordinate's range. */
const STEP = 0.005;

/**
 * @param {NeighbourSession} session
 * @param {HTMLElement} stage   receives keys
 * @param {{ workspace: Figure<Workspace>, square: Figure<Square> }} figures
 */
export function watchHandles(session, stage, { workspace, square }) {
  watchDrag(session.app, workspace.canvas, ({ x, y, near }) => {
    if (!session.isAsking) return null;
    const { view, handles } = workspace.drawing;
    const distances = handles.map(([hx, hy]) => Math.hypot(hx - x, hy - y));
    const least = Math.min(...distances);
    return least > near ? null : (place) => moveHandle(distances.indexOf(least), ...view.toPlane(place.x, place.y));
  });
  watchDrag(session.app, square.canvas, () =>
    session.isAsking ? (place) => session.moveTo(square.drawing.view.toPlane(place.x, place.y)) : null,
  );
  watchArrows(stage, (coordinate, direction, factor) => {
    if (coordinate >= session.dimension || !session.isAsking) return false;
    const { low, high } = session.coordinates[coordinate];
    session.setCoordinate(coordinate, session.q[coordinate] + direction * factor * STEP * (high - low));
    return true;
  });

  /**
   * Turns or slides a link towards a point, moves a body, or turns it.
   * @param {number} handle
   * @param {number} x
   * @param {number} y
   */
  function moveHandle(handle, x, y) {
    const { q, isArm, scenario } = session;
    const part = isArm ? scenario.footprint(q)[handle] : null;
    if (part?.type === "capsule") {
      const arm = /** @type {ArmRobot} */ (session.entry.document.robot);
      const directions = directionsOf(arm, q);
      const [dx, dy] = [x - part.a[0], y - part.a[1]];
      const isSlide = session.coordinates[handle].unit === "m";
      const along = dx * Math.cos(directions[handle]) + dy * Math.sin(directions[handle]) - arm.links[handle];
      session.setCoordinate(handle, isSlide ? along : Math.atan2(dy, dx) - (directions[handle - 1] ?? 0));
    } else if (handle === 0) session.moveTo([x, y, ...q.subarray(2)]);
    else session.setCoordinate(2, Math.atan2(y - q[1], x - q[0]));
  }
}
