/**
 * Exports, made in slices, so that planning, playing and cancelling go on in between. One export is made at a time.
 */
import { GifWriter, paletteOf } from "../../formats/gif.js";
import { SvgContext } from "../../formats/svg.js";
import { NONE } from "../timeline/playback.js";
import { Figure, stripes } from "../../draw/svg-layer.js";
import { Picture, writeCaption } from "./picture.js";
import { PAST } from "../run-log/run-log.js";

/** @import { LaneLog, TakeRequest } from "../../domain/types.js" */
/** @import { Session } from "../session.js" */
/** @typedef {Generator<number, () => Blob | Promise<Blob>>} Making   yields how far it is, 0 to 1 */

/** Pixels of a picture at most: more than this many layers of are more than a browser gives. */
const MOST_PIXELS = 48e6;
/** How long a moving picture lasts, and its last frame more, milliseconds. */
const LASTS = 6000;
const RESTS = 2000;
/** Milliseconds between two turns of others. */
const TURN = 12;
/** Pixels of an image within lines, a CSS pixel. */
const IMAGES = 2;

/** @param {string} code @param {string} message */
function fault(code, message) { return Object.assign(new Error(message), { code }); }

export class Exporter {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** @type {Making | null} */
    this.making = null;
    /** What it is made of: of other runs it cannot go on. */
    this.plannings = 0;
    /** @type {(() => Blob | Promise<Blob>) | null} */
    this.made = null;
  }

  /** Begins to make something; what was under way is dropped. @param {TakeRequest} request */
  begin(request) {
    const { layout: { width, height } } = request;
    const ratio = request.kind === "gif" ? request.width / width : request.ratio;
    if (width * height * ratio * ratio > MOST_PIXELS) {
      throw fault("too-large", `A picture of ${Math.round(width * ratio)} x ${Math.round(height * ratio)} pixels is too large; choose a smaller size.`);
    }
    this.drop();
    this.plannings = this.session.plannings;
    this.making = request.kind === "gif" ? this.gif(request) : request.kind === "svg" ? this.svg(request) : this.png(request);
  }

  /** The next slice, after others have had a turn. @returns {Promise<number>} how far it is, 0 to 1 */
  async step() {
    await new Promise((resolve) => setTimeout(resolve));
    const { making } = this;
    if (!making) throw fault("nothing-made", "No export is in progress.");
    if (this.plannings !== this.session.plannings) {
      this.drop();
      throw fault("run-replaced", "Another run started during the export.");
    }
    const until = performance.now() + TURN;
    for (;;) {
      const { done, value } = making.next();
      if (done) {
        this.made = value;
        this.making = null;
        return 1;
      }
      // It is whole only once nothing more comes.
      if (performance.now() > until) return Math.min(value, 0.999);
    }
  }

  /** What was made. @returns {Promise<Blob>} */
  async end() {
    const { made } = this;
    if (!made) throw fault("nothing-made", "No export is complete.");
    this.drop();
    return made();
  }

  /** Nothing is being made any more. */
  drop() { this.making = this.made = null; }

  /** Pixels. @param {TakeRequest} request @returns {Making} */
  *png({ layout: { width, height, sheets }, ratio }) {
    const canvas = new OffscreenCanvas(Math.round(width * ratio), Math.round(height * ratio));
    const context = contextOf(canvas);
    // One sheet after the other: the layers of all at once are more than some machines have room for.
    for (let i = 0; i < Math.max(1, sheets.length); i++) {
      const picture = new Picture(this.session, sheets.slice(i, i + 1), ratio, () => new OffscreenCanvas(1, 1));
      for (const _ of picture.draw()) yield i / sheets.length;
      picture.compose(context, i === 0);
    }
    return () => canvas.convertToBlob({ type: "image/png" });
  }

  /** Lines. @param {TakeRequest} request @returns {Making} */
  *svg({ layout: { width, height, sheets }, title }) {
    const figures = /** @type {Figure[]} */ ([]);
    const picture = new Picture(this.session, sheets, IMAGES, (wide, high) => {
      const figure = new Figure(wide, high);
      figures.push(figure);
      return /** @type {OffscreenCanvas} */ (/** @type {unknown} */ (figure));
    });
    const { palette, drawn } = picture;
    for (const { pane } of drawn) {
      Object.assign(pane, { hatchOnPart: stripes(palette.stage), hatchOnObstacle: stripes(palette.collision) });
    }
    for (const _ of picture.draw()) yield 0.5;
    const whole = new SvgContext(Math.round(width), Math.round(height));
    for (const { layout } of drawn) {
      writeCaption(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (whole)), layout, palette);
    }
    return async () => {
      const layers = await Promise.all(drawn.flatMap(({ layout: { x, y }, layers: own }, s) => own.map((layer, l) => {
        return /** @type {Figure} */ (/** @type {unknown} */ (layer)).element(`s${s}${l}`, Math.round(x), Math.round(y));
      })));
      const text = whole.toString({ background: palette.stage, title });
      return new Blob([text.replace("</svg>", () => `${layers.join("")}</svg>`)], { type: "image/svg+xml" });
    };
  }

  /** Frames, evenly spaced in the time of the run. @param {TakeRequest} request @returns {Making} */
  *gif({ layout, width, frames }) {
    const { session } = this;
    const last = session.clock.now;
    const ratio = width / layout.width;
    const canvas = new OffscreenCanvas(width, Math.round(layout.height * ratio));
    const context = contextOf(canvas, true);
    const picture = new Picture(session, layout.sheets, ratio, () => {
      const layer = new OffscreenCanvas(1, 1);
      contextOf(layer, true);
      return layer;
    }, true);
    /** @param {number} time @returns {Generator<void, Uint8ClampedArray>} */
    const frame = function* (time) {
      yield* picture.draw(time);
      picture.compose(context);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    /** @param {Generator<void, Uint8ClampedArray>} work @param {number} part @returns {Generator<number, Uint8ClampedArray>} */
    const telling = function* (work, part) {
      for (;;) {
        const { done, value } = work.next();
        if (done) return value;
        yield part;
      }
    };
    // The end has all the colours that there are, but for those of a search on its way.
    const ends = [];
    for (const time of [Math.round(last / 2), last]) {
      ends.push(yield* telling(frame(time), 0));
      yield 0;
    }
    const writer = new GifWriter(canvas.width, canvas.height, paletteOf(ends));
    yield 0;
    for (let i = 0; i < frames; i++) {
      const pixels = yield* telling(frame(Math.round((last * i) / (frames - 1))), i / frames);
      writer.add(pixels, LASTS / frames + (i === frames - 1 ? RESTS : 0));
      yield (i + 1) / frames;
    }
    return () => new Blob([writer.finish()], { type: "image/gif" });
  }

  /** The log of a lane. @param {number} lane @returns {Promise<LaneLog>} */
  async log(lane) {
    const run = this.session.lanes[lane]?.run;
    if (!run) throw fault("no-run", "There is no run.");
    if (!run.hasResult) await this.session.timeline.ask(NONE, true);
    const { history, dimension } = run;
    const isSolved = run.isNewest && run.status === "solved";
    return {
      phases: [...run.phases], width: history.width, history: history.slice(0, history.count).slice(), dimension,
      vertices: run.vertices.slice(0, run.past[PAST.vertices]).slice(),
      path: isSolved ? run.path : null,
      result: run.result,
    };
  }
}

/** @param {OffscreenCanvas} canvas @param {boolean} [willReadFrequently] @returns {OffscreenCanvasRenderingContext2D} */
function contextOf(canvas, willReadFrequently = false) {
  const context = canvas.getContext("2d", { willReadFrequently });
  if (!context) throw fault("no-canvas", "The browser cannot create another canvas.");
  return context;
}
