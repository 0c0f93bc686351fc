/** The figures on the stage, their captions and descriptions. Pointer events on them are passed to the session. */
import { byId, write } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { measure } from "../draw/figure.js";
import { robotName } from "../domain/names.js";

/** @import { Page } from "./page.js" */
/** @import { SceneFacts } from "./session.js" */
/** @import { State } from "./state.js" */
/** @import { PaneKind, Pointer } from "../domain/types.js" */
/**
 * @typedef {{ id: string, kind: PaneKind, lane: number, caption: string, note?: string }} Named   the note describes
 *   the drawing
 */
/** The two parts of a note. @typedef {{ usual: string, standing: string }} Note */

export class Figures {
  /** @param {Page} page */
  constructor(page) {
    this.app = page.app;
    this.session = page.session;
    this.stage = page.session.stage;
    this.element = byId("stage", HTMLElement);
    /** By the id of the figure. @type {Map<string, Note>} */
    this.notes = new Map();
    this.isDescriptionDue = pacer(1000);
    /** The coordinates on the axes of the configuration space, where it has more than two. */
    this.axes = "";
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

  /** Shows some figures, in this order. @param {Named[]} wanted */
  show(wanted) {
    const { stage, element } = this;
    for (const { id, kind, lane } of stage.places.values()) {
      if (wanted.some((one) => one.id === id && one.kind === kind && one.lane === lane)) continue;
      stage.remove(id);
      this.notes.delete(id);
    }
    for (const [at, named] of wanted.entries()) {
      const { id, caption, note = "" } = named;
      const { figure } = stage.at(id) ?? this.add(named);
      write(figure.caption, caption);
      this.notes.set(id, { usual: note, standing: this.notes.get(id)?.standing ?? "" });
      // Moving an element would release a captured pointer.
      if (element.children[at] !== figure.element) element.insertBefore(figure.element, element.children[at] ?? null);
    }
    this.writeNotes();
    element.classList.toggle("single", wanted.length === 1);
    element.dataset.figures = String(wanted.length);
    measure(Array.from(stage.places.values(), ({ figure }) => figure));
  }

  /** @param {Named} named */
  add(named) {
    const place = this.stage.add(this.app, this.element, named, () => this.session.markDirty());
    this.listen(place.figure.canvas, named.id);
    return place;
  }

  /** Shows the standing of a lane in a race. @param {number} lane @param {string} text */
  setStanding(lane, text) {
    for (const place of this.stage.places.values()) {
      const note = this.notes.get(place.id);
      if (note && place.lane === lane) note.standing = text;
    }
    this.writeNotes();
  }

  /** Notes the coordinates of the configuration space. @param {State} state @param {SceneFacts | null} facts */
  showAxes({ view }, facts) {
    const [across, up] = view.axes;
    const { dimension = 0, coordinates = [] } = facts ?? {};
    this.axes =
      dimension > 2 && across < dimension && up < dimension
        ? `${coordinates[across].name} across, ${coordinates[up].name} up${view.slice ? "; slice at the robot\u2019s configuration" : ""}`
        : "";
    this.writeNotes();
  }

  writeNotes() {
    for (const { id, kind, figure } of this.stage.places.values()) {
      const { usual = "", standing = "" } = this.notes.get(id) ?? {};
      const axes = kind === "cspace" ? this.axes : "";
      write(figure.note, standing && axes ? `${standing}; ${axes}` : standing || axes || usual);
    }
  }

  /** Describes the canvases for screen readers, at rest and about once a second. @param {State} state */
  describe({ settled, summary }) {
    if (!this.isDescriptionDue(settled)) return;
    for (const { kind, lane, figure } of this.stage.places.values()) {
      const what = kind === "cspace" ? "Configuration space" : "Workspace";
      const { textContent: caption } = figure.caption;
      figure.describe(`${what}${caption === what ? "" : ` of ${caption}`}: ${summary[lane] ?? ""}`);
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
