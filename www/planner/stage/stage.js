/**
 * The panes of the planner's page: the lane of each, its size and colours. It draws one frame at a time: a bounded
 * slice of growth, and the top.
 */
import { Figure } from "../../draw/figure.js";
import { CSpace } from "./cspace-pane.js";
import { Workspace } from "./workspace-pane.js";

/** @import { Lane } from "./lane.js" */
/** @import { Painter } from "./cspace-pane.js" */
/** @import { Look } from "../../app/app.js" */
/** @import { PaneKind } from "../../domain/types.js" */
/** @import { App } from "../../app/app.js" */
/** @import { Pane } from "./pane.js" */
/**
 * @typedef {{ id: string, kind: PaneKind, lane: number, pane: Pane, figure: Figure<Pane> }} Place
 */

/** Rows drawn in a frame while it plays: at first, at least and at most. */
const RATION = { first: 240, least: 48, most: 960 };
/** A frame is short below this number of milliseconds, and long above. */
const GAP = { short: 18, long: 25 };

const KINDS = { workspace: Workspace, cspace: CSpace };

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
    /** Whether the view is being dragged: then rows are limited as while a run plays. */
    this.isDragged = false;
  }

  /**
   * Adds a figure of a lane.
   * @param {App} app
   * @param {HTMLElement} host
   * @param {{ id: string, kind: PaneKind, lane: number, caption: string }} names
   * @param {() => void} onSize  what is drawn is out of date until the next frame
   * @returns {Place}
   */
  add(app, host, { id, kind, lane, caption }, onSize) {
    const pane = this.paneOf(kind);
    pane.glow.enabled = !this.look?.calm;
    const figure = new Figure(app, host, { id, kind, caption }, pane, () => {
      this.stale.add(id);
      onSize();
    });
    const place = { id, kind, lane, pane, figure };
    this.places.set(id, place);
    return place;
  }

  /** @param {PaneKind} kind @returns {Pane} */
  paneOf(kind) {
    const pane = new KINDS[kind]();
    if (pane instanceof CSpace) pane.painter = this.painter;
    return pane;
  }

  /** @param {string} id */
  remove(id) {
    this.places.get(id)?.figure.remove();
    this.places.delete(id);
    this.stale.delete(id);
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
    for (const { figure } of this.places.values()) figure.sheet.prepare();
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
    return !this.caughtUp || this.panes.some((pane) => !pane.isRefined || pane.glow.alive);
  }

  /** Whether everything that is shown has been drawn. */
  get caughtUp() {
    return this.stale.size === 0 && [...this.places.values()].every(isCaughtUp);
  }

  /** Whether all grounds are complete. */
  get isRefined() {
    return this.panes.every((pane) => pane.isRefined);
  }

  /**
   * Draws one frame. While it plays or is dragged, the rows drawn are limited by the time that frames take: a script only records
   * drawing that the browser rasterizes later.
   * @param {Lane[]} lanes
   * @param {number} now
   * @param {number} until  end of drawing growth, on the clock of performance.now()
   * @param {boolean} isPlaying
   */
  frame(lanes, now, until, isPlaying) {
    if (!this.look) return;
    const places = [...this.places.values()];
    for (const { id, lane, pane, figure } of places) {
      const isStale = this.stale.has(id);
      if (!lanes[lane] || (pane.lane === lanes[lane] && !isStale)) continue;
      if (pane.view && lanes[lane].shown.rough && !isStale) pane.refresh(lanes[lane]);
      else {
        pane.lane = lanes[lane];
        figure.sheet.fit(figure, this.look);
      }
    }
    this.stale.clear();
    const began = performance.now();
    for (const { pane } of places) pane.refine();
    const most = isPlaying || this.isDragged ? this.share(now) : Infinity;
    const behind = places.filter((place) => !isCaughtUp(place));
    this.isBehind = behind.length > 0;
    // When frames are long, panes are drawn in turn.
    const drawn = most < RATION.first && behind.length > 1 ? [behind[this.turn++ % behind.length]] : places;
    let hasCopied = false;
    for (const [i, { pane, figure }] of drawn.entries()) {
      pane.follow(now);
      figure.sheet.redraw();
      // A frame makes one copy.
      const share = { until: began + ((until - began) * (i + 1)) / drawn.length, most: most / drawn.length };
      hasCopied = figure.sheet.draw(hasCopied ? { most: 0 } : share) || hasCopied;
    }
  }
}

/** @param {Place} place */
function isCaughtUp({ pane, figure }) {
  return !pane.view || figure.sheet.caughtUp;
}
