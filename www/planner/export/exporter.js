/** Images of the stage, made in slices so that planning, playing and cancelling continue meanwhile. */
import { SvgContext } from "../../formats/svg.js";
import { requireSize } from "../../draw/export.js";
import { contextOf } from "../../draw/film.js";
import { IMAGES, SvgLayer, stripes, svgFile } from "../../draw/svg-layer.js";
import { Picture, writeCaption } from "./picture.js";

/** @import { Session } from "../session.js" */
/** @import { Layout } from "./layout.js" */
/** @typedef {Generator<number, () => Blob | Promise<Blob>>} Slices   yields the progress, 0 to 1 */

/**
 * @typedef {object} ImageRequest
 * @property {"png" | "svg"} kind
 * @property {Layout} layout
 * @property {string} title
 * @property {number} ratio    of a PNG: pixels a CSS pixel
 */

/** Milliseconds of a slice. */
const SLICE = 12;

/**
 * What holds as long as no other run begins.
 * @param {Session} session
 * @returns {() => void} to be called after every pause
 * @throws {Error} `run-replaced`
 */
export function sameRun(session) {
  const { plannings } = session;
  return () => {
    if (session.plannings !== plannings)
      throw Object.assign(new Error("Another run started during the export."), { code: "run-replaced" });
  };
}

/**
 * Makes an image of the stage.
 * @param {Session} session
 * @param {ImageRequest} request
 * @param {(progress: number) => boolean} onProgress   0 to 1; returns whether to continue
 * @returns {Promise<Blob | null>} null where it was cancelled
 * @throws {Error} `too-large`, `run-replaced`, `no-canvas`
 */
export async function makeImage(session, request, onProgress) {
  const {
    kind,
    layout: { width, height },
    ratio,
  } = request;
  requireSize(width, height, ratio, "choose a smaller size");
  const requireSameRun = sameRun(session);
  const slices = { png: pngOf, svg: svgOf }[kind](session, request);
  for (;;) {
    await new Promise((resolve) => setTimeout(resolve));
    requireSameRun();
    const until = performance.now() + SLICE;
    let slice = slices.next();
    while (!slice.done && performance.now() < until) slice = slices.next();
    if (!onProgress(slice.done ? 1 : slice.value)) return null;
    if (slice.done) return slice.value();
  }
}

/** @param {Session} session @param {ImageRequest} request @returns {Slices} */
function* pngOf(session, { layout: { width, height, sheets }, ratio }) {
  const context = contextOf(Math.round(width * ratio), Math.round(height * ratio));
  // One figure after the other: the layers of all at once take too much memory on some machines.
  for (let i = 0; i < Math.max(1, sheets.length); i++) {
    const picture = new Picture(session, sheets.slice(i, i + 1), ratio, () => new OffscreenCanvas(1, 1));
    for (const _ of picture.draw()) yield i / sheets.length;
    picture.compose(context, i === 0);
  }
  return () => context.canvas.convertToBlob({ type: "image/png" });
}

/** @param {Session} session @param {ImageRequest} request @returns {Slices} */
function* svgOf(session, { layout: { width, height, sheets }, title }) {
  const picture = new Picture(
    session,
    sheets,
    IMAGES,
    (wide, high) => /** @type {OffscreenCanvas} */ (/** @type {unknown} */ (new SvgLayer(wide, high))),
  );
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
    const layers = await Promise.all(
      drawn.flatMap(({ layout: { x, y }, layers: own }, s) =>
        own.map((layer, l) => {
          return /** @type {SvgLayer} */ (/** @type {unknown} */ (layer)).element(
            `s${s}${l}`,
            Math.round(x),
            Math.round(y),
          );
        }),
      ),
    );
    return svgFile(whole, layers, { background: palette.stage, title });
  };
}
