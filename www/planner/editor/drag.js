/** The pointer in the editor, as a state machine over pointer events. */
import { drawGesture, moveGesture, pointAt, pointFrom } from "./gestures.js";
import { REACH, hitAt } from "./handles.js";
import { simple, wall } from "./additions.js";
import { gridOf } from "../../draw/ground.js";

/** @import { CSpace } from "../stage/cspace-pane.js" */
/** @import { Obstacle, Point, Pointer } from "../../domain/types.js" */
/** @import { Editor } from "./editor.js" */
/** @import { Gesture } from "./gestures.js" */
/** @import { EditorObject } from "./objects.js" */

/**
 * @typedef {object} Drag
 * @property {Gesture} change
 * @property {Pointer} from         its first event
 * @property {EditorObject | null} drawn   the new obstacle
 * @property {boolean} moved        whether it has left the slack
 * @property {boolean} isWide       whether it goes on beyond the pane
 */

/** Distance that a pointer moves before it drags, CSS pixels. */
const SLACK = { mouse: 3, touch: 8 };

export class Hand {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    /** @type {Drag | null} */
    this.drag = null;
    /** The latest move, handled in the next frame. @type {Pointer | null} */
    this.pending = null;
    /** Vertices of the polygon or wall being drawn. @type {Point[]} */
    this.draft = [];
    /** The next vertex, under the pointer. @type {Point | null} */
    this.loose = null;
  }

  get isBusy() {
    return this.drag !== null || this.draft.length > 0;
  }

  /** @param {Pointer} pointer */
  handle(pointer) {
    if (pointer.type === "move" || pointer.type === "hover") {
      this.pending = pointer;
      return;
    }
    this.pass();
    switch (pointer.type) {
      case "down":
        this.down(pointer);
        break;
      case "up":
        this.up();
        break;
      case "cancel":
        this.editor.abandon();
        break;
      default:
        this.loose = null;
    }
  }

  /** Handles the latest move, once a frame. */
  pass() {
    const { pending, drag, editor } = this;
    this.pending = null;
    const place = pending && this.at(pending, drag?.isWide);
    if (!pending || !place) return;
    const { x, y, scale, square } = place;
    if (drag) {
      drag.moved ||=
        Math.hypot(pending.x - drag.from.x, pending.y - drag.from.y) > (pending.touch ? SLACK.touch : SLACK.mouse);
      if (drag.moved) editor.attempt(drag.change(x, y, pending.shift), true, drag.drawn ?? editor.selected);
    } else if (this.draft.length > 0 && !square) this.loose = pointFrom(scale, this.draft.at(-1), x, y, pending.shift);
  }

  /**
   * The pane of a pointer and the nearest point on it.
   * @param {Pointer} pointer
   * @param {boolean} [isWide]  whether the point may be beyond the pane
   */
  at({ pane: id, x: px, y: py }, isWide = false) {
    const found = this.editor.session.stage.at(id);
    const { view } = found?.pane ?? {};
    if (!found || !view) return null;
    const inside = (/** @type {number} */ value, /** @type {number} */ size) =>
      isWide ? value : Math.min(size, Math.max(0, value));
    const [x, y] = view.toPlane(inside(px, view.width), inside(py, view.height));
    return {
      pane: found.pane,
      x,
      y,
      scale: { unit: this.editor.unit, grid: gridOf(view) / 5, pixels: view.scaleX },
      square: found.kind === "cspace" ? /** @type {CSpace} */ (found.pane) : null,
    };
  }

  /** @param {Pointer} pointer */
  down(pointer) {
    const place = this.at(pointer);
    if (!place || this.drag) return;
    const { editor } = this;
    const { shown, tool } = editor;
    const { pane, x, y, scale, square } = place;
    const reach = pointer.touch ? REACH.touch : REACH.mouse;
    editor.refusal = null;
    editor.session.byHand.release();
    if ((tool === "polygon" || tool === "wall") && !square) {
      this.corner(pointFrom(scale, this.draft.at(-1), x, y, pointer.shift), reach / scale.pixels);
    } else if ((tool === "disc" || tool === "rectangle") && !square) {
      const drawn = { kind: /** @type {const} */ ("obstacle"), index: shown.document.world.obstacles.length };
      this.drag = {
        change: drawGesture(tool, shown.document, scale, [x, y], pointer.shift),
        from: pointer,
        drawn,
        moved: false,
        isWide: false,
      };
    } else {
      const hit = hitAt(pane, square !== null, shown, shown.query, editor.selected, pointer.x, pointer.y, reach);
      editor.choose(hit?.object ?? null, hit?.part ?? null);
      if (hit)
        this.drag = {
          change: moveGesture(shown, hit, scale, square, [x, y], () => editor.shown.scenario),
          from: pointer,
          drawn: null,
          moved: false,
          isWide: hit.object.kind === "bounds",
        };
    }
  }

  /**
   * Adds a vertex to the polygon or wall. A click on the first or the last one closes a polygon; a wall ends at its
   * last point, and is closed by a click on its first one.
   * @param {Point} point
   * @param {number} reach  metres
   */
  corner(point, reach) {
    const { draft } = this;
    const isNear = (/** @type {Point | undefined} */ other) =>
      other !== undefined && Math.hypot(other[0] - point[0], other[1] - point[1]) <= reach;
    const isLast = isNear(draft.at(-1));
    this.loose = null;
    const least = this.editor.tool === "wall" && isLast ? 2 : 3;
    if (draft.length >= least && (isLast || isNear(draft[0]))) this.close(!isLast);
    else if (!isLast) draft.push(point);
  }

  /** Ends the polygon or wall, if the core accepts it. @param {boolean} [isRing]  whether a wall is closed */
  close(isRing = false) {
    const { editor, draft } = this;
    /** @type {Obstacle} */
    const drawn = editor.tool === "wall" ? wall(draft, isRing, editor.size) : { type: "polygon", vertices: [...draft] };
    if (editor.add([drawn])) this.draft = [];
  }

  up() {
    const { drag, editor } = this;
    this.drag = null;
    if (!drag) return;
    if (drag.moved) {
      if (drag.drawn && editor.isDifferent) editor.put(drag.drawn);
      editor.end();
      return;
    }
    const place = drag.drawn && this.at(drag.from);
    if (place)
      editor.add([
        simple(editor.tool, pointAt(place.scale, place.x, place.y, drag.from.shift), editor.size, editor.unit),
      ]);
  }

  /** Ends all gestures. @returns {boolean} whether something was dragged */
  release() {
    const { drag } = this;
    this.drag = this.pending = this.loose = null;
    this.draft = [];
    return drag !== null;
  }
}
