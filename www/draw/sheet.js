/**
 * A sheet: the layers of a drawing, each on a canvas. A layer is drawn whole, and again when its key differs; or it is
 * logs, which only grow: new rows are added, so that the picture does not depend on how drawing was divided into
 * frames.
 */
import { hatch } from "./hatch.js";
import { Layer } from "./layer.js";
import { Snapshots } from "./snapshots.js";

/** @import { Palette } from "../app/palette.js" */
/** @import { Canvas } from "./layer.js" */

/**
 * What a layer is drawn with; lengths are CSS pixels.
 * @typedef {object} Brush
 * @property {CanvasRenderingContext2D} context
 * @property {Palette} palette
 * @property {number} width
 * @property {number} height
 * @property {number} ratio   device pixels a CSS pixel
 * @property {number} bold   scale of strong lines and of words, for projectors
 * @property {(colour: string) => CanvasPattern | null} hatch   diagonal lines
 */

/**
 * @typedef {object} Log
 * @property {number} count   rows
 * @property {(brush: Brush, from: number, to: number) => void} append   draws rows on top of the earlier ones
 * @property {number} [batch]   rows drawn between two readings of the clock; all where absent
 */

/**
 * A layer has either `draw` or `logs`.
 * @typedef {object} Content
 * @property {unknown} [key]   with another key all is drawn again, logs from row 0; a list is compared item by item
 * @property {(brush: Brush) => void} [draw]   without a key it is drawn again where `redraw` asks for it
 * @property {Log[]} [logs]
 * @property {unknown} [revision]   with another one the logs are drawn again within a frame: half of them would flicker
 * @property {boolean} [jumps]   the only log also goes back, and from copies of it on
 * @property {(context: CanvasRenderingContext2D) => void} [clip]   of logs
 */

/**
 * The layers by their names, from the lowest to the highest.
 * @typedef {object} Drawing
 * @property {Record<string, Content>} layers
 * @property {(size: Size, look: any) => void} [layout]   prepares for a size and a look
 * @property {() => void} [refine]   asks for what is computed elsewhere
 * @property {boolean} [isRefined]   false until that is there
 */
/** @typedef {{ width: number, height: number }} Size   CSS pixels */
/** @typedef {{ palette: Palette, ratio: number, bold: number }} SheetLook */
/** How much to draw of logs: until a time of performance.now(), and rows at most. @typedef {{ until?: number, most?: number }} Share */

/** The key of what is not drawn. */
const NOTHING = Symbol("nothing");

/** What is drawn of a layer. */
class Drawn {
  /** @param {Canvas} canvas @param {boolean} keeps  copies */
  constructor(canvas, keeps) {
    this.layer = new Layer(canvas);
    this.copies = keeps ? new Snapshots(this.layer) : null;
    /** @type {unknown} */
    this.key = NOTHING;
    /** @type {unknown} */
    this.revision = undefined;
    /** Whether all of the logs is drawn within this frame. */
    this.isWhole = false;
    /** Rows drawn of each log. @type {number[]} */
    this.counts = [];
  }

  /** Whether it is up to date. @param {Content} content */
  shows({ key, revision, logs = [] }) {
    return (
      isSame(key, this.key) &&
      revision === this.revision &&
      logs.length >= this.counts.length &&
      logs.every(({ count }, i) => count === (this.counts[i] ?? 0))
    );
  }

  /** Empties logs that have another key, or starts them from the best copy. @param {Content} content */
  begin({ key, logs = [], revision, jumps }) {
    const { counts, copies } = this;
    const isOther = !isSame(key, this.key);
    const isBack = logs.length < counts.length || logs.some(({ count }, i) => count < (counts[i] ?? 0));
    this.isWhole = !isOther && revision !== this.revision;
    if (isOther || this.isWhole || (isBack && !copies)) this.empty();
    else if (jumps && copies) {
      const [{ count }] = logs;
      const best = copies.best(count)?.count ?? 0;
      if (isBack || best > (counts[0] ?? 0)) counts[0] = copies.restore(count);
    }
    Object.assign(this, { key, revision });
  }

  empty() {
    this.copies?.clear();
    this.layer.paste(null);
    this.counts = [];
  }

  /**
   * Adds rows, at least a batch of each log.
   * @param {Log[]} logs
   * @param {Brush} brush
   * @param {(rows: number) => boolean} goesOn   whether there is time after this number of rows
   */
  grow(logs, brush, goesOn) {
    logs.forEach(({ count, append, batch = count }, i) => {
      let from = this.counts[i] ?? 0;
      while (from < count) {
        const to = Math.min(count, from + batch);
        append(brush, from, to);
        this.counts[i] = to;
        if (!goesOn(to - from) && !this.isWhole) break;
        from = to;
      }
    });
  }
}

/** @template {Drawing} [D=Drawing] */
export class Sheet {
  /**
   * @param {D} drawing
   * @param {(name: string) => Canvas} canvasOf   of each layer
   * @param {boolean} [keeps]   copies of logs that jump
   */
  constructor(drawing, canvasOf, keeps = true) {
    this.drawing = drawing;
    this.drawn = Object.fromEntries(
      Object.entries(drawing.layers).map(([name, { jumps }]) => [name, new Drawn(canvasOf(name), keeps && !!jumps)]),
    );
    this.width = 0;
    this.height = 0;
    this.ratio = 1;
    this.bold = 1;
    /** @type {Palette | null} */
    this.palette = null;
    /** Patterns by their colours. @type {Map<string, CanvasPattern | null>} */
    this.hatches = new Map();
  }

  /** Sets size and colours; everything is to be drawn again. @param {Size} size @param {SheetLook} look */
  fit(size, look) {
    const { width, height } = size;
    const { palette, ratio, bold } = look;
    Object.assign(this, { width, height, palette, ratio, bold });
    this.hatches.clear();
    for (const one of Object.values(this.drawn)) {
      one.layer.fit(width, height, ratio);
      one.empty();
      one.key = NOTHING;
    }
    this.drawing.layout?.(size, look);
  }

  /** The canvases, from the lowest to the highest. */
  get canvases() {
    return Object.values(this.drawn).map(({ layer }) => layer.canvas);
  }

  /** Rows drawn of the logs of a layer. @param {string} name */
  rowsOf(name) {
    return this.drawn[name].counts.reduce((sum, count) => sum + count, 0);
  }

  /** Sizes the canvases on which nothing was drawn yet, so that drawing does not wait for them later. */
  prepare() {
    for (const { layer } of Object.values(this.drawn)) layer.prepare();
  }

  /** Draws layers again that have no key. */
  redraw() {
    for (const [name, { key, draw }] of Object.entries(this.drawing.layers))
      if (key === undefined && draw) this.drawn[name].key = NOTHING;
  }

  /** Whether all logs, and all layers with a key, are drawn as they are now. */
  get caughtUp() {
    return Object.entries(this.drawing.layers).every(
      ([name, content]) => (content.draw && content.key === undefined) || this.drawn[name].shows(content),
    );
  }

  /**
   * Draws what is out of date.
   * @param {Share} [share]
   * @returns {boolean} whether it made a copy: then no log has grown but one that was emptied, as the browser
   *   rasterizes all pending drawing before it copies
   */
  draw({ until = Infinity, most = Infinity } = {}) {
    if (!this.palette || this.width === 0) return false;
    const all = Object.entries(this.drawing.layers).map(([name, content]) => ({ content, drawn: this.drawn[name] }));
    const growing = most > 0 ? all.filter(({ content }) => content.logs) : [];
    for (const { content, drawn } of growing) drawn.begin(content);
    const due = growing.find(({ drawn: { copies, counts } }) => copies?.isDue(counts[0] ?? 0))?.drawn;
    due?.copies?.copy(due.counts[0]);
    let rows = 0;
    const goesOn = (/** @type {number} */ more) => (rows += more) < most && performance.now() < until;
    for (const { content, drawn } of all) {
      const { key, draw, logs = [], clip } = content;
      const { layer } = drawn;
      if (draw ? isSame(key, drawn.key) : (due && !drawn.isWhole) || most <= 0 || drawn.shows(content)) continue;
      if (clip && !layer.clip) layer.enclose(clip);
      if (draw) layer.clear();
      const { context } = layer;
      context.save();
      if (draw) {
        draw(this.brush(context));
        drawn.key = key;
      } else drawn.grow(logs, this.brush(context), goesOn);
      context.restore();
    }
    return due !== undefined;
  }

  /** @param {CanvasRenderingContext2D} context @returns {Brush} */
  brush(context) {
    const { width, height, ratio, bold, hatches } = this;
    const palette = /** @type {Palette} */ (this.palette);
    return {
      context,
      palette,
      width,
      height,
      ratio,
      bold,
      hatch(colour) {
        const known = hatches.get(colour);
        if (known !== undefined) return known;
        const made = hatch(context, colour, ratio);
        hatches.set(colour, made);
        return made;
      },
    };
  }
}

/** @param {unknown} one @param {unknown} other */
function isSame(one, other) {
  return Array.isArray(one) && Array.isArray(other)
    ? one.length === other.length && one.every((item, i) => Object.is(item, other[i]))
    : Object.is(one, other);
}

/** Draws all of a drawing with one brush. @param {Drawing} drawing @param {Brush} brush */
export function drawWhole({ layers }, brush) {
  const { context } = brush;
  for (const { draw, logs = [], clip } of Object.values(layers)) {
    context.save();
    if (clip) clip(context);
    draw?.(brush);
    for (const { count, append } of logs) if (count > 0) append(brush, 0, count);
    context.restore();
  }
}
