/**
 * The figures on the stage: each has a caption and a sheet of canvases. Their sizes and pointer events are passed to
 * the session.
 */
import { byId, make, write } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { LAYERS } from "../draw/layer.js";
import { robotName } from "../domain/names.js";

/** @import { LayerName } from "../draw/layer.js" */
/** @import { Page } from "./page.js" */
/** @import { PaneKind, Pointer, SceneFacts, State } from "../domain/types.js" */
/**
 * @typedef {{ id: string, kind: PaneKind, lane: number, caption: string, note?: string }} Sheet   the note describes
 *   the drawing
 */
/**
 * @typedef {{ figure: HTMLElement, caption: HTMLElement, note: HTMLElement, usual: string, standing: string, sheet:
 *   HTMLElement, top: HTMLCanvasElement, kind: PaneKind, lane: number }} Figure
 */

export class Sheets {
  /** @param {Page} page */
  constructor(page) {
    this.session = page.session;
    this.element = byId("stage", HTMLElement);
    /** @type {Map<string, Figure>} */
    this.figures = new Map();
    this.isDescriptionDue = pacer(1000);
    /** The coordinates on the axes of the configuration space, where it has more than two. */
    this.axes = "";
    this.observer = new ResizeObserver(() => this.measure());
  }

  /** Shows the figures for a scenario. @param {SceneFacts} facts */
  arrange({ robot, dimension, coordinates }) {
    const square = robot !== "disc" && dimension >= 2;
    const marked = { arm: "tip", disc: "centre", rigid_body: "origin", car: "rear axle" }[robot];
    this.show([
      {
        id: "workspace",
        kind: "workspace",
        lane: 0,
        caption: "Workspace",
        note: `dots mark the ${robotName(robot)}\u2019s ${marked}`,
      },
      ...(square
        ? [
            {
              id: "cspace",
              kind: /** @type {const} */ ("cspace"),
              lane: 0,
              caption: "Configuration space",
              note: `each dot: two ${dimension > 2 ? "of its " : ""}${coordinates.every(({ unit }) => unit === "rad") ? "joint angles" : "coordinates"}`,
            },
          ]
        : []),
    ]);
  }

  /** Shows some sheets, in this order. @param {Sheet[]} wanted */
  show(wanted) {
    for (const [id, { figure, sheet, kind, lane }] of this.figures) {
      if (wanted.some((one) => one.id === id && one.kind === kind && one.lane === lane)) continue;
      this.observer.unobserve(sheet);
      figure.remove();
      this.figures.delete(id);
      this.session.stage.remove(id);
    }
    for (const [at, { id, kind, lane, caption, note = "" }] of wanted.entries()) {
      const figure = this.figures.get(id) ?? this.add(id, kind, lane);
      write(figure.caption, caption);
      figure.usual = note;
      this.writeNote(figure);
      // Moving an element would release a captured pointer.
      if (this.element.children[at] !== figure.figure)
        this.element.insertBefore(figure.figure, this.element.children[at] ?? null);
    }
    this.element.classList.toggle("single", wanted.length === 1);
    this.element.dataset.sheets = String(wanted.length);
    this.measure();
  }

  /** Shows the standing of a lane in a race. @param {number} lane @param {string} text */
  setStanding(lane, text) {
    for (const figure of this.figures.values()) {
      if (figure.lane !== lane) continue;
      figure.standing = text;
      this.writeNote(figure);
    }
  }

  /** Notes the coordinates of the configuration space. @param {State} state @param {SceneFacts | null} facts */
  showAxes(
    {
      view: {
        axes: [across, up],
        slice,
      },
    },
    facts,
  ) {
    const { dimension = 0, coordinates = [] } = facts ?? {};
    this.axes =
      dimension > 2 && across < dimension && up < dimension
        ? `${coordinates[across].name} across, ${coordinates[up].name} up${slice ? "; slice at the robot\u2019s configuration" : ""}`
        : "";
    for (const figure of this.figures.values()) this.writeNote(figure);
  }

  /** @param {Figure} figure */
  writeNote({ kind, note, usual, standing }) {
    const axes = kind === "cspace" ? this.axes : "";
    write(note, standing && axes ? `${standing}; ${axes}` : standing || axes || usual);
  }

  /** @param {string} id @param {PaneKind} kind @param {number} lane @returns {Figure} */
  add(id, kind, lane) {
    const sheet = make("div", { className: "sheet" });
    const caption = make("span", {});
    const note = make("small", {});
    const figure = make("figure", { className: `pane ${kind}`, id }, make("figcaption", {}, caption, " ", note), sheet);
    const entries = LAYERS.map((name) => [name, make("canvas", { ariaHidden: "true" })]);
    const canvases = /** @type {Record<LayerName, HTMLCanvasElement>} */ (Object.fromEntries(entries));
    for (const [name, canvas] of Object.entries(canvases)) canvas.dataset.layer = name;
    sheet.append(...Object.values(canvases));
    const { top } = canvases;
    Object.assign(top, { ariaHidden: null, role: "img" });
    this.listen(top, id);
    this.session.stage.add(id, kind, lane, canvases);
    const made = { figure, caption, note, usual: "", standing: "", sheet, top, kind, lane };
    this.figures.set(id, made);
    this.observer.observe(sheet);
    return made;
  }

  /** Passes the sizes of the sheets to the stage. */
  measure() {
    let isOther = false;
    // All boxes are read before a style is written, so that the document is laid out once.
    const boxes = Array.from(this.figures, ([id, { sheet }]) => ({ id, sheet, box: sheet.getBoundingClientRect() }));
    for (const { id, sheet, box } of boxes) {
      // A change below one device pixel does not count.
      const [width, height] = [box.width, box.height].map(
        (side) => Math.round(side * devicePixelRatio) / devicePixelRatio,
      );
      if (width < 1 || height < 1) continue;
      // A canvas stretched by a fraction of a pixel is blurred.
      for (const canvas of sheet.children)
        if (canvas instanceof HTMLElement) Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
      isOther = this.session.stage.resize(id, width, height) || isOther;
    }
    // What is drawn is out of date until the next frame, which is asked for.
    if (isOther) this.session.markDirty();
  }

  /** Describes the canvases for screen readers, at rest and about once a second. @param {State} state */
  describe({ settled, summary }) {
    if (!this.isDescriptionDue(settled)) return;
    for (const { top, kind, lane, caption } of this.figures.values()) {
      const what = kind === "cspace" ? "Configuration space" : "Workspace";
      const text = `${what}${caption.textContent === what ? "" : ` of ${caption.textContent}`}: ${summary[lane] ?? ""}`;
      if (top.ariaLabel !== text) top.ariaLabel = text;
    }
  }

  /**
   * Passes on the primary pointer, captured while it is down.
   * @param {HTMLCanvasElement} canvas
   * @param {string} pane
   */
  listen(canvas, pane) {
    /**
     * @param {"pointerdown" | "pointermove" | "pointerup" | "pointercancel" | "pointerleave"} name
     * @param {(isDown: boolean, event: PointerEvent) => Pointer["type"] | null} typeOf
     */
    const send = (name, typeOf) =>
      canvas.addEventListener(name, (event) => {
        const type = event.isPrimary ? typeOf(canvas.hasPointerCapture(event.pointerId), event) : null;
        if (type)
          void this.session.pointer({
            pane,
            type,
            x: event.offsetX,
            y: event.offsetY,
            shift: event.shiftKey,
            touch: event.pointerType === "touch",
          });
      });
    send("pointerdown", (_, { button, pointerId }) => {
      if (button !== 0) return null;
      canvas.setPointerCapture(pointerId);
      return "down";
    });
    send("pointermove", (isDown) => (isDown ? "move" : "hover"));
    send("pointerup", (isDown) => (isDown ? "up" : null));
    send("pointercancel", (isDown) => (isDown ? "cancel" : null));
    send("pointerleave", () => "leave");
  }
}
