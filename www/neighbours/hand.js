/** The target in the hand: dragged in the workspace or on the square, or moved by arrow keys. However many moves come, one a frame is obeyed. */

/** @import { Sheet } from "../room/sheet.js" */
/** @import { Desk } from "./desk.js" */
/** @import { Square } from "./square.js" */
/** @import { Workspace } from "./workspace.js" */
/** Does what a held thing does when the pointer is there, CSS pixels. @typedef {(x: number, y: number) => void} Grip */

/** How near to a handle a pointer must be, CSS pixels. */
const NEAR = { mouse: 18, touch: 30 };
/** A press of an arrow key, as part of a coordinate's range; with Shift ten times that. */
const STEP = 0.005;

/** Which coordinate, and which way. @type {Record<string, [number, number]>} */
const KEYS = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageDown: [2, -1], PageUp: [2, 1] };

export class Hand {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    /** @type {Grip | null} */
    this.grip = null;
    /** The newest move, not yet obeyed. @type {[number, number] | null} */
    this.pending = null;
    desk.room.onFrame(() => this.obey());
  }

  /** Obeys the newest move. */
  obey() {
    const { pending, grip } = this;
    this.pending = null;
    if (pending && grip) grip(...pending);
  }

  /** Hears pointers on a sheet. @param {Sheet} sheet @param {(x: number, y: number, reach: number) => Grip | null} take   what is held there */
  listen({ canvas }, take) {
    const reachOf = (/** @type {PointerEvent} */ { pointerType }) => (pointerType === "touch" ? NEAR.touch : NEAR.mouse);
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !event.isPrimary) return;
      this.grip = take(event.offsetX, event.offsetY, reachOf(event));
      if (!this.grip) return;
      canvas.setPointerCapture(event.pointerId);
      this.pending = [event.offsetX, event.offsetY];
      this.desk.room.wake();
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!event.isPrimary) return;
      if (!this.grip) {
        canvas.dataset.over = String(take(event.offsetX, event.offsetY, reachOf(event)) !== null);
        return;
      }
      this.pending = [event.offsetX, event.offsetY];
      this.desk.room.wake();
    });
    const release = () => {
      // A press may be over before there was a frame.
      this.obey();
      this.grip = null;
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    // A finger that holds something does not scroll the page.
    canvas.addEventListener("touchstart", (event) => {
      const { left, top } = canvas.getBoundingClientRect();
      const [touch] = event.touches;
      if (take(touch.clientX - left, touch.clientY - top, NEAR.touch)) event.preventDefault();
    }, { passive: false });
  }

  /** @param {Workspace} workspace */
  onWorkspace(workspace) {
    const { desk } = this;
    return (/** @type {number} */ px, /** @type {number} */ py, /** @type {number} */ reach) => {
      const { view } = workspace;
      if (!view) return null;
      const away = workspace.handles.map(([x, y]) => Math.hypot(view.x(x) - px, view.y(y) - py));
      const nearest = away.reduce((best, distance, i) => (distance < away[best] ? i : best), 0);
      if (away[nearest] > reach) return null;
      return (/** @type {number} */ toX, /** @type {number} */ toY) => {
        const [x, y] = view.toPlane(toX, toY);
        if (desk.isArm) this.turnTo(nearest, x, y);
        else if (nearest === 0) desk.aim([x, y, ...desk.q.subarray(2)]);
        else desk.turn(2, Math.atan2(y - desk.q[1], x - desk.q[0]));
      };
    };
  }

  /** A joint turns so that its link points there. @param {number} joint @param {number} x @param {number} y */
  turnTo(joint, x, y) {
    const { desk } = this;
    const part = desk.scenario.footprint(desk.q)[joint];
    if (part.type !== "capsule") return;
    const before = desk.q.subarray(0, joint).reduce((sum, angle) => sum + angle, 0);
    desk.turn(joint, Math.atan2(y - part.a[1], x - part.a[0]) - before);
  }

  /** @param {Square} square */
  onSquare(square) {
    return () => {
      const { view } = square;
      return view && ((/** @type {number} */ x, /** @type {number} */ y) => {
        this.desk.aim(view.toPlane(x, y));
      });
    };
  }

  /** @param {HTMLElement} stage */
  listenKeys(stage) {
    stage.addEventListener("keydown", (event) => {
      const { desk } = this;
      const [i, way] = KEYS[event.key] ?? [NaN, 0];
      if (!(i < desk.dimension) || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      const { low, high } = desk.coordinates[i];
      desk.turn(i, desk.q[i] + way * STEP * (event.shiftKey ? 10 : 1) * (high - low));
    });
  }
}
