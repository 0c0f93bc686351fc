/**
 * The panes of the planner's page: the lane of each, its size and colours. It draws one frame at a time: a bounded
 * slice of growth, and the top.
 */
import { CSpace } from "./cspace-pane.js";
import { Workspace } from "./workspace-pane.js";

/** @import { Lane } from "../lane.js" */
/** @import { Painter } from "./cspace-pane.js" */
/** @import { Look, PaneKind } from "../../domain/types.js" */
/** @import { LayerName } from "../../draw/layer.js" */
/** @import { Pane } from "./pane.js" */
/** @typedef {{ id: string, kind: PaneKind, lane: number, pane: Pane }} Place */

/** Rows drawn in a frame while it plays: at first, at least and at most. */
const RATION = { first: 240, least: 48, most: 960 };
/** A frame is short below this number of milliseconds, and long above. */
const GAP = { short: 18, long: 25 };

export const KINDS = { workspace: Workspace, cspace: CSpace };

export class Stage {
  /** @param {Painter} painter @param {() => void} wake   requests a frame */
  constructor(painter, wake) {
    this.painter = painter;
    this.wake = wake;
    /** @type {Map<string, Place>} */
    this.places = new Map();
    /** @type {Look | null} */
    this.look = null;
    /** Panes to be laid out in the next frame. @type {Set<string>} */
    this.stale = new Set();
    /** Rows that may be drawn in a frame; whether the last one drew any, and its time. */
    this.ration = RATION.first;
    this.isBehind = false;
    this.last = 0;
    this.turn = 0;
  }

  /**
   * @param {string} id
   * @param {PaneKind} kind
   * @param {number} lane
   * @param {Record<LayerName, HTMLCanvasElement>} canvases
   */
  add(id, kind, lane, canvases) {
    const pane = new KINDS[kind](canvases);
    if (pane instanceof CSpace) pane.painter = this.painter;
    pane.glow.enabled = !this.look?.calm;
    this.places.set(id, { id, kind, lane, pane });
  }

  /** @param {string} id */
  remove(id) {
    this.places.delete(id);
    this.stale.delete(id);
  }

  /**
   * @param {string} id
   * @param {number} width
   * @param {number} height  CSS pixels
   * @returns {boolean} whether it had another size
   */
  resize(id, width, height) {
    const place = this.places.get(id);
    if (!place || (place.pane.width === width && place.pane.height === height)) return false;
    place.pane.width = width;
    place.pane.height = height;
    this.stale.add(id);
    this.wake();
    return true;
  }

  /** Sets colours and pixel ratio. @param {Look} look */
  setTheme(look) {
    this.look = look;
    for (const { pane } of this.places.values()) pane.glow.enabled = !look.calm;
    this.invalidate();
  }

  /** Lays out all panes in the next frame. */
  invalidate() {
    for (const id of this.places.keys()) this.stale.add(id);
  }

  /** Sizes the layers on which nothing was drawn yet, so that a run does not wait for them. */
  prepare() {
    for (const { layers } of this.panes) for (const layer of Object.values(layers)) layer.prepare();
  }

  /** A new run on the same ground. @param {Lane[]} lanes */
  restart(lanes) {
    for (const { pane, lane } of this.places.values()) {
      if (!pane.lane || pane.lane !== lanes[lane]) continue;
      pane.restart();
    }
  }

  /** Rows that this frame may draw: fewer after a long frame, more after a short one. @param {number} now */
  share(now) {
    const gap = now - this.last;
    this.last = now;
    if (this.isBehind && gap > GAP.long) this.ration = Math.max(RATION.least, 0.75 * this.ration);
    else if (this.isBehind && gap < GAP.short) this.ration = Math.min(RATION.most, 1.1 * this.ration);
    return this.ration;
  }

  /** @param {string} id @returns {Place | undefined} */
  at(id) {
    return this.places.get(id);
  }

  get panes() {
    return [...this.places.values()].map(({ pane }) => pane);
  }

  /** Whether something remains to be drawn, or still glows. */
  get busy() {
    return this.stale.size > 0 || this.panes.some((pane) => !pane.caughtUp || !pane.isRefined || pane.glow.alive);
  }

  /** Whether everything that is shown has been drawn. */
  get caughtUp() {
    return this.stale.size === 0 && this.panes.every((pane) => pane.caughtUp);
  }

  /** Whether all grounds are complete. */
  get isRefined() {
    return this.panes.every((pane) => pane.isRefined);
  }

  /**
   * Draws one frame. While it plays, the rows drawn are limited by the time that frames take: a script only records
   * drawing that the browser rasterizes later.
   * @param {Lane[]} lanes
   * @param {number} now
   * @param {number} until  end of drawing growth, on the clock of performance.now()
   * @param {boolean} isPlaying
   */
  frame(lanes, now, until, isPlaying) {
    if (!this.look) return;
    for (const { id, lane, pane } of this.places.values()) {
      if (!lanes[lane] || (pane.lane === lanes[lane] && !this.stale.has(id))) continue;
      if (pane.view && lanes[lane].shown.rough && !this.stale.has(id)) pane.refresh(lanes[lane]);
      else pane.layout(lanes[lane], this.look);
    }
    this.stale.clear();
    const { panes } = this;
    const began = performance.now();
    for (const pane of panes) if (pane.lane) pane.refine(pane.lane);
    const most = isPlaying ? this.share(now) : Infinity;
    const behind = panes.filter((pane) => !pane.caughtUp);
    this.isBehind = behind.length > 0;
    // When frames are long, panes are drawn in turn.
    const drawn = most < RATION.first && behind.length > 1 ? [behind[this.turn++ % behind.length]] : panes;
    // A frame makes one snapshot.
    drawn.some((pane, i) => pane.grow(now, began + ((until - began) * (i + 1)) / drawn.length, most / drawn.length));
    for (const pane of drawn) pane.drawTop(now);
  }
}
