/**
 * Dragging with mouse and finger, at most once a frame, and with arrow keys. A finger that grabs nothing scrolls the
 * page.
 */

/** @import { App } from "../app/app.js" */

/**
 * A place of the pointer, CSS pixels of a canvas.
 * @typedef {{ x: number, y: number, near: number, isTouch: boolean }} Place   `near`: the distance within which it
 *   grabs something
 */
/** Moves what was grabbed to a place. @typedef {(place: Place) => void} Grip */

const NEAR = { mouse: 16, touch: 28 };

/** Each key's coordinate and direction. @type {Record<string, [number, number]>} */
const KEYS = {
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
  ArrowDown: [1, -1],
  ArrowUp: [1, 1],
  PageDown: [2, -1],
  PageUp: [2, 1],
};

/**
 * @param {App} app
 * @param {HTMLCanvasElement} canvas
 * @param {(place: Place) => Grip | null} grab  what there is at a place
 */
export function watchDrag(app, canvas, grab) {
  /** @type {Grip | null} */
  let grip = null;
  /** The newest place, until the next frame. @type {Place | null} */
  let next = null;
  const placeAt = (/** @type {number} */ x, /** @type {number} */ y, /** @type {boolean} */ isTouch) => ({
    x,
    y,
    isTouch,
    near: isTouch ? NEAR.touch : NEAR.mouse,
  });
  const placeOf = (/** @type {PointerEvent} */ { offsetX, offsetY, pointerType }) =>
    placeAt(offsetX, offsetY, pointerType === "touch");
  const drag = (/** @type {PointerEvent} */ event) => {
    next = placeOf(event);
    app.requestFrame();
  };
  const move = () => {
    if (next) grip?.(next);
    next = null;
  };
  app.onFrame(move);
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !event.isPrimary) return;
    grip = grab(placeOf(event));
    if (!grip) return;
    canvas.setPointerCapture(event.pointerId);
    drag(event);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!event.isPrimary) return;
    if (grip) drag(event);
    else if (event.pointerType !== "touch") canvas.dataset.over = String(grab(placeOf(event)) !== null);
  });
  for (const type of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(type, () => {
      // The last place may be newer than the last frame.
      move();
      grip = null;
    });
  }
  canvas.addEventListener(
    "touchstart",
    (event) => {
      const [{ clientX, clientY }] = event.touches;
      const { left, top } = canvas.getBoundingClientRect();
      if (event.touches.length === 1 && grab(placeAt(clientX - left, clientY - top, true))) event.preventDefault();
    },
    { passive: false },
  );
}

/**
 * Arrow and page keys while an element has the focus.
 * @param {HTMLElement} element
 * @param {(coordinate: number, direction: number, factor: number) => boolean} move  by 10 with Shift; returns whether
 *   the key was used
 */
export function watchArrows(element, move) {
  element.addEventListener("keydown", (event) => {
    const key = KEYS[event.key];
    if (!key || event.target !== element || event.ctrlKey || event.metaKey || event.altKey) return;
    if (move(...key, event.shiftKey ? 10 : 1)) event.preventDefault();
  });
}
