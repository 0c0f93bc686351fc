/**
 * The arm in the hand: its tip, a link, a point of the configuration square or of an axis is dragged by mouse, finger or keys.
 * However many moves come, one a frame is obeyed. A finger that holds nothing scrolls the page.
 */
import { wrap } from "../domain/coordinates.js";
import { distanceToSegment } from "../planner/pose/grip.js";

/** @import { Sheet } from "../room/sheet.js" */
/** @import { Axes } from "./axes.js" */
/** @import { Bench } from "./bench.js" */
/** @import { Square } from "./square.js" */
/** @import { Point } from "./types.js" */
/** @import { Workspace } from "./workspace.js" */
/** @typedef {{ x: number, y: number, isTouch: boolean }} Place   CSS pixels of a sheet */
/** Does what a held thing does when the pointer is there. @typedef {(place: Place) => void} Grip */

/** How near to a thing a pointer must be, CSS pixels. */
const NEAR = { mouse: 16, touch: 26 };
/** What a press of an arrow key moves the tip by, as part of the arm's reach; with Shift ten times that. */
const STEP = 0.01;

/** @type {Record<string, Point>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Hand {
  /**
   * @param {Bench} bench
   * @param {{ pull: (wanted: Point) => void, aim: (target: Point) => void }} wishes   for the tip, for the target
   */
  constructor(bench, wishes) {
    this.bench = bench;
    this.wishes = wishes;
    /** @type {Grip | null} */
    this.grip = null;
    /** The newest move, not yet obeyed. @type {Place | null} */
    this.pending = null;
    bench.room.onFrame(() => this.pass());
  }

  /** Obeys the newest move. */
  pass() {
    const { pending, grip } = this;
    this.pending = null;
    if (pending && grip) grip(pending);
  }

  /** Hears pointers on a sheet. @param {Sheet} sheet @param {(place: Place) => Grip | null} take   what is held there */
  listen({ canvas }, take) {
    const placeOf = (/** @type {PointerEvent} */ event) => ({ x: event.offsetX, y: event.offsetY, isTouch: event.pointerType === "touch" });
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !event.isPrimary) return;
      const place = placeOf(event);
      this.grip = take(place);
      if (!this.grip) return;
      canvas.setPointerCapture(event.pointerId);
      this.pending = place;
      this.bench.room.wake();
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!event.isPrimary) return;
      const place = placeOf(event);
      if (!this.grip) {
        if (!place.isTouch) canvas.dataset.over = String(take(place) !== null);
        return;
      }
      this.pending = place;
      this.bench.room.wake();
    });
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, () => {
        this.pass();
        this.grip = null;
        this.bench.tell("rest");
      });
    }
    // What is held by a finger is not scrolled away.
    canvas.addEventListener("touchstart", (event) => {
      const [touch] = event.touches;
      const box = canvas.getBoundingClientRect();
      if (event.touches.length === 1 && take({ x: touch.clientX - box.left, y: touch.clientY - box.top, isTouch: true })) event.preventDefault();
    }, { passive: false });
  }

  /** On the workspace: the target where there is one, the tip, a link. @param {Workspace} workspace @returns {(place: Place) => Grip | null} */
  onWorkspace(workspace) {
    return ({ x, y, isTouch }) => {
      const { bench } = this;
      const { arm, mode, target } = bench;
      const { view } = workspace;
      if (!view) return null;
      const near = isTouch ? NEAR.touch : NEAR.mouse;
      const isNear = (/** @type {Point} */ point) => Math.hypot(view.x(point[0]) - x, view.y(point[1]) - y) <= near;
      const planeOf = (/** @type {Place} */ place) => view.toPlane(place.x, place.y);
      if (mode === "solve" && isNear(target)) return (place) => this.wishes.aim(planeOf(place));
      if (isNear(arm.tip)) return (place) => this.wishes.pull(planeOf(place));
      const [px, py] = planeOf({ x, y, isTouch });
      let joint = -1;
      let least = Infinity;
      arm.parts.forEach((part, i) => {
        if (part.type !== "capsule") return;
        const distance = distanceToSegment(px, py, part.a, part.b) - part.radius;
        if (distance < least) [least, joint] = [distance, i];
      });
      if (joint >= 0 && least * view.scaleX <= near) return this.turning(joint, px, py, planeOf);
      // With a mouse the tip, or the target, comes from anywhere.
      if (isTouch) return null;
      return mode === "solve" ? (place) => this.wishes.aim(planeOf(place)) : (place) => this.wishes.pull(planeOf(place));
    };
  }

  /** A link is held: its joint turns with the pointer. @param {number} joint @param {number} px @param {number} py @param {(place: Place) => Point} planeOf @returns {Grip} */
  turning(joint, px, py, planeOf) {
    const { bench } = this;
    const held = bench.arm.parts[joint];
    if (held.type !== "capsule") return () => {};
    const offset = Math.atan2(py - held.a[1], px - held.a[0]) - Math.atan2(held.b[1] - held.a[1], held.b[0] - held.a[0]);
    return (place) => {
      const { arm } = bench;
      const part = arm.parts[joint];
      if (part?.type !== "capsule") return;
      const [x, y] = planeOf(place);
      const link = Math.atan2(part.b[1] - part.a[1], part.b[0] - part.a[0]);
      const wanted = Math.atan2(y - part.a[1], x - part.a[0]) - offset;
      const q = Float64Array.from(arm.q);
      q[joint] += wrap(wanted - link);
      bench.pose(q);
    };
  }

  /** On the configuration square: the pose itself. @param {Square} square @returns {(place: Place) => Grip | null} */
  onSquare(square) {
    return ({ x, y, isTouch }) => {
      const { bench } = this;
      if (!square.view || bench.arm.dimension !== 2) return null;
      const [px, py] = square.place(bench.arm.q);
      if (isTouch && Math.hypot(px - x, py - y) > NEAR.touch) return null;
      return (place) => {
        const q = square.poseAt(place.x, place.y);
        if (q) bench.pose(q);
      };
    };
  }

  /** On the axes: one joint. @param {Axes} axes @returns {(place: Place) => Grip | null} */
  onAxes(axes) {
    return ({ x, isTouch }) => {
      const joint = axes.jointAt(x, isTouch ? NEAR.touch : NEAR.mouse);
      if (joint < 0) return null;
      return (place) => {
        const q = Float64Array.from(this.bench.arm.q);
        q[joint] = axes.valueAt(joint, place.y);
        this.bench.pose(q);
      };
    };
  }

  /** Arrow keys, while the stage has the focus, move the tip or the target. @param {HTMLElement} stage */
  listenKeys(stage) {
    stage.addEventListener("keydown", (event) => {
      const way = ARROWS[event.key];
      if (!way || event.target !== stage || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      const { bench } = this;
      const { arm, mode, target, pull } = bench;
      const step = arm.reach * STEP * (event.shiftKey ? 10 : 1);
      const [x, y] = mode === "solve" ? target : pull && !pull.reached ? pull.wanted : arm.tip;
      this.wishes[mode === "solve" ? "aim" : "pull"]([x + step * way[0], y + step * way[1]]);
    });
  }
}
