/**
 * A part of a large world on the stage: the wheel and two buttons zoom, a hand drags. A small world is always shown
 * whole, so this is loaded with the first large one.
 */
import { View } from "planarium/draw";
import { make, makeSvg } from "../app/dom.js";
import { button, press } from "../widgets/elements.js";
import { loadStyle } from "../app/site.js";

/** @import { Box } from "../domain/types.js" */
/** @import { Page } from "./page.js" */

/** How much a button, a notch of the wheel and an arrow key change. */
const STEP = { button: 1.6, wheel: 1.0015, key: 60 };
/** The most that a world is enlarged. */
const MOST = 400;
/** A scene with as many obstacles is large, as is every world of another program. */
const LARGE = 200;
/** Around the window, as `View` has it, CSS pixels. */
const MARGIN = 14;

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** @type {Record<string, string>} */
const SIGNS = {
  "zoom-in": "M4 10h12M10 4v12",
  "zoom-out": "M4 10h12",
  "zoom-whole": "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4",
  "zoom-hand":
    "M10 2v16M2 10h16M7.5 4.5 10 2l2.5 2.5M7.5 15.5 10 18l2.5-2.5M4.5 7.5 2 10l2.5 2.5M15.5 7.5 18 10l-2.5 2.5",
};

/** Of the page, once it has one. @type {Zoom | undefined} */
let zoom;

/** Offers to zoom from now on. @param {Page} page */
export async function offerZoom(page) {
  await loadStyle();
  zoom ??= new Zoom(page);
}

class Zoom {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.isHand = false;
    this.hand = tool("zoom-hand", "Drag the map", () => this.take(!this.isHand));
    press(this.hand, false);
    this.bar = make(
      "div",
      { className: "zoom", role: "toolbar", ariaLabel: "Zoom" },
      tool("zoom-in", "Zoom in", () => this.zoom(STEP.button)),
      tool("zoom-out", "Zoom out", () => this.zoom(1 / STEP.button)),
      tool("zoom-whole", "Show all", () => this.show(undefined)),
      this.hand,
    );
    this.bar.addEventListener("keydown", (event) => {
      const arrow = ARROWS[event.key];
      if (!arrow) return;
      event.preventDefault();
      event.stopPropagation();
      this.pan(STEP.key * arrow[0], STEP.key * arrow[1]);
    });
    /** The box of canvases that is listened to. @type {HTMLElement | null} */
    this.box = null;
    page.onOpen(() => {
      this.take(false);
      this.attend();
    });
    page.onState(() => this.attend());
  }

  get place() {
    return this.page.session.stage.at("workspace");
  }

  /** Follows the figure of the workspace, which a race replaces. */
  attend() {
    const { place, page } = this;
    const { shown } = page.session;
    this.bar.hidden = !shown?.world && (shown?.document.world.obstacles.length ?? 0) < LARGE;
    if (!place || place.figure.box === this.box) return;
    const { box, element } = place.figure;
    this.box = box;
    element.querySelector("figcaption")?.prepend(this.bar);
    box.addEventListener("wheel", (event) => this.roll(event), { passive: false });
    // Before the canvas, which poses the robot or edits the scene.
    box.addEventListener("pointerdown", (event) => this.grab(event), { capture: true });
  }

  /** The box that fills the pane. @param {View} view @returns {Box} */
  windowOf(view) {
    const min = view.toPlane(MARGIN, view.height - MARGIN);
    return { min, max: view.toPlane(view.width - MARGIN, MARGIN) };
  }

  /** @param {Box | undefined} window   undefined: all of the world */
  show(window) {
    const { session } = this.page;
    if (!session.shown) return;
    session.shown.window = window;
    session.stage.invalidate();
    session.markDirty();
  }

  /** @param {number} factor @param {[number, number]} [at]   what stays where it is, CSS pixels */
  zoom(factor, at) {
    const { place, page } = this;
    const view = place?.pane.view;
    const { shown } = page.session;
    if (!view || !shown) return;
    const { min, max } = this.windowOf(view);
    const extent = shown.scenario.extent();
    const fit = new View(extent, view.width, view.height).scaleX;
    const wanted = Math.min(view.scaleX * factor, fit * MOST);
    if (wanted <= fit * 1.001) {
      this.show(undefined);
      return;
    }
    const part = view.scaleX / wanted;
    const [px, py] = at ? view.toPlane(...at) : [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
    this.show(
      within(
        {
          min: [px + (min[0] - px) * part, py + (min[1] - py) * part],
          max: [px + (max[0] - px) * part, py + (max[1] - py) * part],
        },
        extent,
      ),
    );
  }

  /** Moves what is shown, where that is not all. @param {number} dx @param {number} dy  CSS pixels */
  pan(dx, dy) {
    const view = this.place?.pane.view;
    const { shown } = this.page.session;
    if (!view || !shown?.window) return;
    const { min, max } = this.windowOf(view);
    const [x, y] = [-dx / view.scaleX, dy / view.scaleY];
    this.show(within({ min: [min[0] + x, min[1] + y], max: [max[0] + x, max[1] + y] }, shown.scenario.extent()));
  }

  /** @param {WheelEvent} event */
  roll(event) {
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : 40);
    // All is shown: the page may scroll on.
    if (pixels > 0 && !this.page.session.shown?.window) return;
    event.preventDefault();
    this.zoom(STEP.wheel ** -pixels, [event.offsetX, event.offsetY]);
  }

  /** @param {boolean} isHand */
  take(isHand) {
    this.isHand = isHand;
    press(this.hand, isHand);
    this.box?.classList.toggle("dragged", isHand);
  }

  /** Drags the world by the hand, or with the middle button. @param {PointerEvent} event */
  grab(event) {
    if (!(event.button === 1 || (event.button === 0 && this.isHand))) return;
    const { box } = this;
    if (!box) return;
    event.preventDefault();
    event.stopPropagation();
    const { pointerId } = event;
    let { clientX, clientY } = event;
    box.setPointerCapture(pointerId);
    const { session } = this.page;
    session.stage.isDragged = true;
    const move = (/** @type {PointerEvent} */ next) => {
      if (next.pointerId !== pointerId) return;
      this.pan(next.clientX - clientX, next.clientY - clientY);
      ({ clientX, clientY } = next);
    };
    const end = () => {
      session.stage.isDragged = false;
      session.markDirty();
      box.removeEventListener("pointermove", move);
      for (const name of /** @type {const} */ (["pointerup", "pointercancel"])) box.removeEventListener(name, end);
    };
    box.addEventListener("pointermove", move);
    for (const name of /** @type {const} */ (["pointerup", "pointercancel"])) box.addEventListener(name, end);
  }
}

/** @param {keyof typeof SIGNS} id @param {string} name @param {() => void} act */
function tool(id, name, act) {
  const sign = makeSvg("path", { d: SIGNS[id], fill: "none", stroke: "currentColor", "stroke-width": 1.6 });
  const made = button(id, "", act, { ariaLabel: name, title: name });
  made.append(makeSvg("svg", { viewBox: "0 0 20 20", "aria-hidden": "true" }, sign));
  return made;
}

/** A window whose middle is within the world. @param {Box} window @param {Box} extent @returns {Box} */
function within({ min, max }, extent) {
  const shift = [0, 1].map((i) => {
    const middle = (min[i] + max[i]) / 2;
    return Math.min(extent.max[i], Math.max(extent.min[i], middle)) - middle;
  });
  return { min: [min[0] + shift[0], min[1] + shift[1]], max: [max[0] + shift[0], max[1] + shift[1]] };
}
