/**
 * A picture of the stage at another time and resolution: panes of the same kinds and sizes on their own canvases, with
 * light copies of the lanes. The stage itself does not change.
 */
import { LAYERS } from "../../draw/layer.js";
import { KINDS } from "../stage/stage.js";
import { Frontier } from "../run-log/frontier.js";

/** @import { LayerName } from "../../draw/layer.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { PathPlayback } from "../../domain/path-playback.js" */
/** @import { Look } from "../../domain/types.js" */
/** @import { Layout } from "./layout.js" */
/** @import { Lane, Shown } from "../lane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @import { Session } from "../session.js" */
/** @typedef {{ layout: Layout["sheets"][number], pane: Pane, layers: OffscreenCanvas[], lane: Lane }} Drawn */

/** Milliseconds of drawing in a slice. */
const SLICE = 8;
/** Captions, in CSS pixels. */
const FONT = "13px system-ui, sans-serif";
const LINE = 18;
const GAP = 9;

export class Picture {
  /**
   * @param {Session} session
   * @param {Layout["sheets"]} sheets   to draw
   * @param {number} ratio           pixels a CSS pixel
   * @param {(width: number, height: number) => OffscreenCanvas} makeCanvas   in CSS pixels; the layers set its size
   * @param {boolean} [whole]        with the whole path and without a pose by hand
   */
  constructor(session, sheets, ratio, makeCanvas, whole = false) {
    this.clock = { column: session.clock.column };
    const look = /** @type {Look} */ (session.stage.look);
    this.palette = look.palette;
    this.ratio = ratio;
    const shown = /** @type {Shown} */ (session.shown);
    /** The state that its lanes share. @type {Shown} */
    this.shown = {
      ...shown,
      view: { ...shown.view },
      hover: null,
      overlay: null,
      rough: false,
      ...(whole ? { hand: null, check: null, driven: null } : {}),
    };
    const lanes = session.lanes.map((lane) => standIn(lane, this.shown, whole));
    /** @type {Drawn[]} */
    this.drawn = sheets.flatMap((layout) => {
      const place = session.stage.at(layout.id);
      const lane = place && lanes[place.lane];
      if (!lane) return [];
      const { width, height } = place.pane;
      const layers = LAYERS.map(() => makeCanvas(width, height));
      const pane = new KINDS[place.kind](
        /** @type {Record<LayerName, OffscreenCanvas>} */ (
          Object.fromEntries(LAYERS.map((name, i) => [name, layers[i]]))
        ),
      );
      Object.assign(pane, { width, height });
      if (pane instanceof KINDS.cspace) pane.painter = session.stage.painter;
      pane.glow.enabled = false;
      pane.layout(lane, { ...look, ratio });
      // Snapshots are not needed.
      for (const keeps of Object.values(pane.growth.snapshots)) keeps.spacing = Infinity;
      return [{ layout, pane, layers, lane }];
    });
  }

  /** Puts the robots on their paths. @param {number} part  0 to 1 */
  place(part) {
    for (const {
      lane: { playback },
    } of this.drawn)
      if (playback) playback.at = part;
  }

  /** Draws a time, by default that of the stage, in slices. @param {number} [time] @returns {Generator<void>} */
  *draw(time) {
    const {
      clock: { column },
    } = this;
    for (const { pane, lane } of this.drawn) {
      const { run } = lane;
      if (run && time !== undefined) run.shown = run.iterationAt(column, time);
      for (;;) {
        const until = performance.now() + SLICE;
        pane.refine(lane);
        pane.grow(0, until);
        if (pane.caughtUp && pane.isRefined) break;
        yield;
      }
      run?.frontier.follow();
      pane.glow.clear();
      pane.drawTop(0);
    }
  }

  /**
   * Draws the panes and captions on a canvas of the whole stage.
   * @param {OffscreenCanvasRenderingContext2D} context
   * @param {boolean} [blank]  clears it first
   */
  compose(context, blank = true) {
    const { ratio, palette } = this;
    if (blank) {
      context.fillStyle = palette.stage;
      context.fillRect(0, 0, context.canvas.width, context.canvas.height);
    }
    for (const { layout, layers } of this.drawn) {
      for (const layer of layers) context.drawImage(layer, Math.round(layout.x * ratio), Math.round(layout.y * ratio));
      context.save();
      context.scale(ratio, ratio);
      writeCaption(context, layout, palette);
      context.restore();
    }
  }
}

/**
 * A copy of a lane that does not follow the stage.
 * @param {Lane} lane
 * @param {Shown} shown
 * @param {boolean} whole
 * @returns {Lane}
 */
function standIn(lane, shown, whole) {
  const { run, end, asked } = lane;
  const still = (/** @type {PathPlayback} */ playback) =>
    Object.create(playback, {
      drawn: { value: whole ? 1 : playback.drawn },
      at: { value: playback.at, writable: true },
    });
  /** @type {(RunLog & { shown: number }) | null} */
  const its = run && Object.create(run, { shown: { value: run.shown, writable: true } });
  if (run && its) Object.defineProperty(its, "frontier", { value: new Frontier(its, run.adjacency) });
  return Object.create(lane, {
    shown: { value: shown },
    run: { value: its },
    end: { value: end && still(end) },
    asked: { value: asked?.playback ? { ...asked, playback: still(asked.playback) } : asked },
  });
}

/**
 * Draws a caption, wrapped to its width.
 * @param {Pick<CanvasRenderingContext2D, "font" | "fillStyle" | "textBaseline" | "textAlign" | "fillText">} context
 * @param {Layout["sheets"][number]} layout
 * @param {Palette} palette
 */
export function writeCaption(context, { caption: { x, y, width, name, note } }, palette) {
  const ruler = new OffscreenCanvas(1, 1).getContext("2d");
  if (!ruler) return;
  context.font = ruler.font = FONT;
  context.textBaseline = "middle";
  context.textAlign = "left";
  let left = 0;
  let line = 0;
  for (const [words, colour] of [
    [name, palette.ink],
    [note, palette.quiet],
  ]) {
    context.fillStyle = colour;
    let text = "";
    const write = () => {
      context.fillText(text, x + left, y + LINE * (line + 0.5));
      left += ruler.measureText(text).width + GAP;
      text = "";
    };
    for (const word of words.split(/\s+/).filter(Boolean)) {
      const longer = `${text} ${word}`.trimStart();
      if (left + ruler.measureText(longer).width <= width || left + text.length === 0) text = longer;
      else {
        write();
        left = 0;
        line++;
        text = word;
      }
    }
    if (text) write();
  }
}
