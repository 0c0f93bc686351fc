/** Images of the stage, made in slices so that planning, playing and cancelling continue meanwhile. */
import { GifWriter, paletteOf } from "../../formats/gif.js";
import { SvgContext } from "../../formats/svg.js";
import { requireSize } from "../../draw/export.js";
import { IMAGES, SvgLayer, stripes, svgFile } from "../../draw/svg-layer.js";
import { Picture, writeCaption } from "./picture.js";

/** @import { Session } from "../session.js" */
/** @import { Layout } from "./layout.js" */
/** @typedef {Generator<number, () => Blob | Promise<Blob>>} Slices   yields the progress, 0 to 1 */

/**
 * @typedef {object} ImageRequest
 * @property {"png" | "svg" | "gif"} kind
 * @property {Layout} layout
 * @property {string} title
 * @property {number} ratio    of a PNG: pixels a CSS pixel
 * @property {number} width    of a GIF: pixels
 * @property {number} frames   of a GIF, at least 2
 */

/** Milliseconds that an animation lasts, and that its last frame lasts longer. */
const DURATION = 6000;
const PAUSE = 2000;
/** Milliseconds of a slice. */
const SLICE = 12;

/** @param {string} code @param {string} message */
function fault(code, message) { return Object.assign(new Error(message), { code }); }

/**
 * Makes an image of the stage.
 * @param {Session} session
 * @param {ImageRequest} request
 * @param {(progress: number) => boolean} onProgress   0 to 1; returns whether to continue
 * @returns {Promise<Blob | null>} null where it was cancelled
 * @throws {Error} `too-large`, `run-replaced`, `no-canvas`
 */
export async function makeImage(session, request, onProgress) {
  const { kind, layout: { width, height } } = request;
  const ratio = kind === "gif" ? request.width / width : request.ratio;
  requireSize(width, height, ratio, "choose a smaller size");
  const { plannings } = session;
  const slices = { png: pngOf, svg: svgOf, gif: gifOf }[kind](session, request);
  for (;;) {
    await new Promise((resolve) => setTimeout(resolve));
    if (session.plannings !== plannings) throw fault("run-replaced", "Another run started during the export.");
    const until = performance.now() + SLICE;
    let slice = slices.next();
    while (!slice.done && performance.now() < until) slice = slices.next();
    if (!onProgress(slice.done ? 1 : slice.value)) return null;
    if (slice.done) return slice.value();
  }
}

/** @param {Session} session @param {ImageRequest} request @returns {Slices} */
function* pngOf(session, { layout: { width, height, sheets }, ratio }) {
  const canvas = new OffscreenCanvas(Math.round(width * ratio), Math.round(height * ratio));
  const context = contextOf(canvas);
  // One figure after the other: the layers of all at once take too much memory on some machines.
  for (let i = 0; i < Math.max(1, sheets.length); i++) {
    const picture = new Picture(session, sheets.slice(i, i + 1), ratio, () => new OffscreenCanvas(1, 1));
    for (const _ of picture.draw()) yield i / sheets.length;
    picture.compose(context, i === 0);
  }
  return () => canvas.convertToBlob({ type: "image/png" });
}

/** @param {Session} session @param {ImageRequest} request @returns {Slices} */
function* svgOf(session, { layout: { width, height, sheets }, title }) {
  const picture = new Picture(session, sheets, IMAGES, (wide, high) => /** @type {OffscreenCanvas} */ (/** @type {unknown} */ (new SvgLayer(wide, high))));
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
      return /** @type {SvgLayer} */ (/** @type {unknown} */ (layer)).element(`s${s}${l}`, Math.round(x), Math.round(y));
    })));
    return svgFile(whole, layers, { background: palette.stage, title });
  };
}

/** Frames, evenly spaced in the time of the run. @param {Session} session @param {ImageRequest} request @returns {Slices} */
function* gifOf(session, { layout, width, frames }) {
  const last = session.clock.now;
  const ratio = width / layout.width;
  const canvas = new OffscreenCanvas(width, Math.round(layout.height * ratio));
  const context = contextOf(canvas, true);
  const picture = new Picture(session, layout.sheets, ratio, () => {
    const layer = new OffscreenCanvas(1, 1);
    contextOf(layer, true);
    return layer;
  }, true);
  /** @param {number} time @param {number} progress @returns {Generator<number, Uint8ClampedArray>} */
  const frame = function* (time, progress) {
    for (const _ of picture.draw(time)) yield progress;
    picture.compose(context);
    return context.getImageData(0, 0, canvas.width, canvas.height).data;
  };
  // The last frame has all colours but those of a search in progress.
  const ends = [];
  for (const time of [Math.round(last / 2), last]) {
    ends.push(yield* frame(time, 0));
    yield 0;
  }
  const writer = new GifWriter(canvas.width, canvas.height, paletteOf(ends));
  yield 0;
  for (let i = 0; i < frames; i++) {
    const pixels = yield* frame(Math.round((last * i) / (frames - 1)), i / frames);
    writer.add(pixels, DURATION / frames + (i === frames - 1 ? PAUSE : 0));
    yield (i + 1) / frames;
  }
  return () => new Blob([writer.finish()], { type: "image/gif" });
}

/** @param {OffscreenCanvas} canvas @param {boolean} [willReadFrequently] @returns {OffscreenCanvasRenderingContext2D} */
function contextOf(canvas, willReadFrequently = false) {
  const context = canvas.getContext("2d", { willReadFrequently });
  if (!context) throw fault("no-canvas", "The browser cannot create another canvas.");
  return context;
}
