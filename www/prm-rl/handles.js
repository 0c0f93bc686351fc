/** Dragging start and goal, marking an edge of the path with the pointer, choosing a drive, and arrow keys. */
import { watchArrows, watchDrag } from "../draw/drag.js";

/** @import { Figure } from "../draw/figure.js" */
/** @import { Demonstrations } from "./demonstrations.js" */
/** @import { Floor } from "./floor.js" */
/** @import { NavigationSession } from "./session.js" */

/** What an arrow key moves by, metres, and turns by, radians. */
const STEP = 0.05;
const TURN = Math.PI / 36;
/** Within this number of pixels the pointer marks an edge. */
const NEAR = 8;

/**
 * @param {NavigationSession} session
 * @param {HTMLElement} stage   receives keys
 * @param {{ floor: Figure<Floor>, demonstrations: Figure<Demonstrations> }} figures
 * @param {(ends: { start?: number[], goal?: number[] }) => void} move
 */
export function watchHandles(session, stage, { floor, demonstrations }, move) {
  watchDrag(session.app, floor.canvas, ({ x, y, near }) => {
    if (session.part !== "plan") return null;
    const { view, handles } = floor.drawing;
    const distances = handles.map(([, hx, hy]) => Math.hypot(hx - x, hy - y));
    const least = Math.min(...distances);
    if (least > near) return null;
    const [handle] = handles[distances.indexOf(least)];
    return (place) => {
      const [px, py] = within(view.toPlane(place.x, place.y));
      const { start } = session;
      if (handle === "goal") move({ goal: [px, py] });
      else if (handle === "start") move({ start: [px, py, start[2]] });
      else move({ start: [start[0], start[1], Math.atan2(py - start[1], px - start[0])] });
    };
  });
  for (const type of /** @type {const} */ (["pointermove", "pointerdown"])) {
    floor.canvas.addEventListener(type, ({ offsetX, offsetY }) => {
      const edge = session.part === "plan" ? floor.drawing.edgeAt(offsetX, offsetY, NEAR) : null;
      if (edge !== session.edge) session.select({ edge });
    });
  }
  floor.canvas.addEventListener("pointerleave", () => {
    if (session.edge !== null) session.select({ edge: null });
  });
  demonstrations.canvas.addEventListener("click", ({ offsetX, offsetY }) => {
    const piece = demonstrations.drawing.pieceAt(offsetX, offsetY);
    if (piece === null) return;
    session.training.selected = piece;
    session.app.changed();
  });
  watchArrows(stage, (coordinate, direction, factor) => {
    if (session.part !== "plan") return false;
    const { start, goal, moved } = session;
    const by = direction * factor;
    if (coordinate === 2) move({ start: start.with(2, start[2] + by * TURN) });
    else if (moved === "goal") move({ goal: within(goal.with(coordinate, goal[coordinate] + by * STEP)) });
    else move({ start: [...within(start.with(coordinate, start[coordinate] + by * STEP)), start[2]] });
    return true;
  });

  /** The nearest point of the floor. @param {number[]} point @returns {number[]} */
  function within(point) {
    const { min, max } = session.floor.world.bounds ?? { min: [-Infinity, -Infinity], max: [Infinity, Infinity] };
    return [0, 1].map((i) => Math.min(max[i], Math.max(min[i], point[i])));
  }
}
