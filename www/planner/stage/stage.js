/**
 * The stage holds the panes: which there are, whose lane each shows, how large it is, in which colours. It draws a frame at a
 * time, a bounded slice of growth and the light top.
 */
import { CSpace } from "./cspace-pane.js";
import { Workspace } from "./workspace-pane.js";

/** @import { Lane } from "../lane.js" */
/** @import { Painter } from "./cspace-pane.js" */
/** @import { Look, PaneKind } from "../../domain/types.js" */
/** @import { LayerName } from "../../draw/layer.js" */
/** @import { Pane } from "./pane.js" */
/** @typedef {{ id: string, kind: PaneKind, lane: number, pane: Pane }} Place */

/** Rows inked in a frame that plays: at first, at least and at most. */
const RATION = { first: 240, least: 48, most: 960 };
/** A frame is short below so many milliseconds, and long above. */
const GAP = { short: 20, long: 34 };

export const KINDS = { workspace: Workspace, cspace: CSpace };

export class Stage {
  /** @param {Painter} painter @param {() => void} wake   has a frame drawn */
  constructor(painter, wake) {
    this.painter = painter;
    this.wake = wake;
    /** @type {Map<string, Place>} */
    this.places = new Map();
    /** @type {Look | null} */
    this.look = null;
    /** Panes that are to be drawn anew before the next frame. @type {Set<string>} */
    this.stale = new Set();
    /** Rows that may be inked in a frame; did the last one ink any, and when was it? */
    this.ration = RATION.first;
    this.isInking = false;
    this.last = 0;
    this.turn = 0;
  }

  /** @param {string} id @param {PaneKind} kind @param {number} lane @param {Record<LayerName, HTMLCanvasElement>} canvases */
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

  /** @param {string} id @param {number} width @param {number} height  CSS pixels */
  resize(id, width, height) {
    const place = this.places.get(id);
    if (!place || (place.pane.width === width && place.pane.height === height)) return;
    place.pane.width = width;
    place.pane.height = height;
    this.stale.add(id);
    this.wake();
  }

  /** Colours and pixels. @param {Look} look */
  setTheme(look) {
    this.look = look;
    for (const { pane } of this.places.values()) pane.glow.enabled = !look.calm;
    this.invalidate();
  }

  /** Everything is to be drawn anew before the next frame. */
  invalidate() {
    for (const id of this.places.keys()) this.stale.add(id);
  }

  /** A new run on the same ground. @param {Lane[]} lanes */
  restart(lanes) {
    for (const { pane, lane } of this.places.values()) {
      if (!pane.lane || pane.lane !== lanes[lane]) continue;
      pane.restart();
    }
  }

  /** How many rows this frame may ink: fewer after a long frame, more after a short one. @param {number} now */
  share(now) {
    const gap = now - this.last;
    this.last = now;
    if (this.isInking && gap > GAP.long) this.ration = Math.max(RATION.least, 0.75 * this.ration);
    else if (this.isInking && gap < GAP.short) this.ration = Math.min(RATION.most, 1.1 * this.ration);
    return this.ration;
  }

  /** @param {string} id @returns {Place | undefined} */
  at(id) { return this.places.get(id); }

  get panes() { return [...this.places.values()].map(({ pane }) => pane); }

  /** Is there something that is not inked yet, or a glow that has not settled? */
  get busy() { return this.stale.size > 0 || this.panes.some((pane) => !pane.caughtUp || !pane.isRefined || pane.glow.alive); }

  /** Has everything that is shown been inked? */
  get caughtUp() { return this.stale.size === 0 && this.panes.every((pane) => pane.caughtUp); }

  /** Are all grounds complete? */
  get isRefined() { return this.panes.every((pane) => pane.isRefined); }

  /**
   * Draws one frame. While it plays the rows inked in a frame are rationed by how long frames take: scripts only record what the
   * browser draws afterwards.
   * @param {Lane[]} lanes @param {number} now @param {number} until  when to stop inking, on the clock of performance.now()
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
    this.isInking = behind.length > 0;
    // Where frames are long, the panes take turns.
    const drawn = most < RATION.first && behind.length > 1 ? [behind[this.turn++ % behind.length]] : panes;
    drawn.forEach((pane, i) => pane.grow(now, began + ((until - began) * (i + 1)) / drawn.length, most / drawn.length));
    for (const pane of drawn) pane.drawTop(now);
  }
}
