/**
 * Films: frames drawn on one canvas, as a GIF or, where the browser has a video encoder, as a WebM. A film is made in
 * slices, so that the page can be used meanwhile.
 */
import { GifWriter, paletteOf } from "../formats/gif.js";

/** @typedef {"gif" | "webm"} FilmFormat */
/** @typedef {OffscreenCanvasRenderingContext2D} Context */

/**
 * @typedef {object} Film
 * @property {number} width     pixels, even
 * @property {number} height
 * @property {number} seconds   without the rest on the last frame
 * @property {number} [frames]  at least 2; where absent as many as fit the format
 * @property {(context: Context, part: number) => Iterable<unknown> | void} draw   draws all of the frame at a part, 0
 *   to 1; what it yields is ignored, it may be interrupted there
 * @property {() => void} [close]   called once the film is made, or not made
 */

/**
 * What takes the frames.
 * @typedef {{ add: (context: Context, seconds: number) => void | Promise<void>, finish: () => Blob | Promise<Blob>,
 *   close?: () => void }} Writer
 */

/** Frames a second. */
const RATES = { gif: 20, webm: 30 };
/** Seconds that the last frame rests. */
const REST = 2;
/** Milliseconds of a slice. */
const SLICE = 12;

/** Why this browser makes no WebM, or empty. */
export function whyNoWebm() {
  if (typeof VideoEncoder !== "undefined") return "";
  return isSecureContext ? "WebM needs a browser with WebCodecs." : "WebM needs an address that begins with https.";
}

/** Lengths as pixels that every encoder takes: even, and at least 2. @param {number} length */
export function even(length) {
  return Math.max(2, 2 * Math.round(length / 2));
}

/**
 * A canvas of a film or of a part of it.
 * @param {number} width
 * @param {number} height
 * @param {boolean} [isRead]  pixel by pixel
 * @returns {Context}
 * @throws {Error} `no-canvas`
 */
export function contextOf(width, height, isRead = false) {
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: isRead });
  if (!context) throw Object.assign(new Error("The browser cannot create another canvas."), { code: "no-canvas" });
  return context;
}

/**
 * @param {FilmFormat} format
 * @param {Film} film
 * @param {(progress: number) => boolean} onProgress   0 to 1; returns whether to continue
 * @returns {Promise<Blob | null>} null where it was cancelled
 * @throws {Error} `no-canvas`, `no-encoder`, and whatever drawing throws
 */
export async function makeFilm(
  format,
  { width, height, seconds, frames = Math.max(2, Math.round(seconds * RATES[format])), draw, close },
  onProgress,
) {
  const context = contextOf(width, height, format === "gif");
  /** @type {Writer | undefined} */
  let writer;
  let until = performance.now() + SLICE;

  /** @param {number} progress @returns {Promise<boolean>} whether to continue */
  const goOn = async (progress) => {
    if (performance.now() < until) return true;
    await new Promise((resolve) => setTimeout(resolve));
    until = performance.now() + SLICE;
    return onProgress(progress);
  };
  /** @param {number} part @param {number} progress @returns {Promise<boolean>} whether to continue */
  const show = async (part, progress) => {
    for (const _ of draw(context, part) ?? []) if (!(await goOn(progress))) return false;
    return goOn(progress);
  };

  try {
    if (format === "webm") writer = await (await import("../formats/webm.js")).webmWriter(width, height);
    else {
      /** @type {Uint8ClampedArray[]} */
      const seen = [];
      for (const part of [0, 0.5, 1]) {
        if (!(await show(part, 0))) return null;
        seen.push(pixelsOf(context));
      }
      writer = gifWriter(width, height, paletteOf(seen));
    }
    for (let i = 0; i < frames; i++) {
      if (!(await show(i / (frames - 1), i / frames))) return null;
      await writer.add(context, seconds / frames + (i === frames - 1 ? REST : 0));
      if (!onProgress((i + 1) / frames)) return null;
    }
    return await writer.finish();
  } finally {
    writer?.close?.();
    close?.();
  }
}

/** @param {Context} context */
function pixelsOf(context) {
  return context.getImageData(0, 0, context.canvas.width, context.canvas.height).data;
}

/** @param {number} width @param {number} height @param {Uint8Array} palette @returns {Writer} */
function gifWriter(width, height, palette) {
  const writer = new GifWriter(width, height, palette);
  return {
    add: (context, seconds) => writer.add(pixelsOf(context), 1000 * seconds),
    finish: () => new Blob([writer.finish()], { type: "image/gif" }),
  };
}
