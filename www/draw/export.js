/** Figures as one PNG, SVG or film: each at its place, with its caption. The figures themselves do not change. */
import { SvgContext } from "../formats/svg.js";
import { contextOf, even } from "./film.js";
import { decoded } from "./picture.js";
import { Sheet } from "./sheet.js";
import { IMAGES, SvgLayer, svgFile } from "./svg-layer.js";

/** @import { Palette } from "../app/palette.js" */
/** @import { Figure } from "./figure.js" */
/** @import { Film } from "./film.js" */
/** @import { Canvas } from "./layer.js" */
/** @import { Drawing, SheetLook } from "./sheet.js" */

/** A caption, wrapped to its width. @typedef {{ x: number, y: number, width: number, name: string, note: string }} Caption */
/**
 * @typedef {{ drawing: Drawing, x: number, y: number, width: number, height: number, caption: Caption }} Place   of a
 *   copy of a figure's drawing
 */
/**
 * @typedef {{ width: number, height: number, look: SheetLook, places: Place[], foot?: SVGSVGElement }} Layout   lengths
 *   are CSS pixels; `foot`: below the figures of an image, which is as much higher
 */
/** @typedef {"png" | "svg"} ImageKind */
/** Yields the progress, 0 to 1. @typedef {Generator<number, () => Promise<Blob>>} Slices */

/** Space around and between figures, CSS pixels. */
const SPACE = 16;
/** Captions, CSS pixels. */
const FONT = "13px system-ui, sans-serif";
const LINE = 18;
const GAP = 9;
/** Pixels of an image at most: browsers limit the size of canvases. */
const MOST_PIXELS = 48e6;
/** Milliseconds of a slice. */
const SLICE = 12;

/** The figures that are shown, side by side. @param {Figure<any>[]} figures @returns {Layout} */
export function rowOf(figures) {
  const shown = figures.filter(({ element }) => !element.hidden);
  let right = SPACE;
  const places = shown.map(({ drawing, caption, width, height }) => {
    const x = right;
    right += width + SPACE;
    const name = caption.textContent ?? "";
    return {
      drawing: Object.create(drawing),
      x,
      y: SPACE + LINE,
      width,
      height,
      caption: { x, y: SPACE - 3, width, name, note: "" },
    };
  });
  const height = Math.max(...shown.map((figure) => figure.height)) + 2 * SPACE + LINE;
  return { places, width: Math.ceil(right), height: Math.ceil(height), look: shown[0].app.look };
}

/** Figures at another resolution, and at another time where their drawings are changed. */
class Picture {
  /** @param {Layout} layout @param {number} ratio  pixels a CSS pixel @param {(place: Place) => Canvas} canvasOf */
  constructor({ look, places }, ratio, canvasOf) {
    this.ratio = ratio;
    this.palette = look.palette;
    this.sheets = places.map((place) => {
      const sheet = new Sheet(place.drawing, () => canvasOf(place), false);
      sheet.fit(place, { ...look, ratio });
      return { place, sheet };
    });
  }

  /** Draws in slices what has changed. @returns {Generator<void>} */
  *draw() {
    for (const {
      sheet,
      place: { drawing },
    } of this.sheets) {
      sheet.redraw();
      for (;;) {
        drawing.refine?.();
        sheet.draw({ until: performance.now() + SLICE });
        if (sheet.caughtUp && drawing.isRefined !== false) break;
        yield;
      }
    }
  }

  /** @param {OffscreenCanvasRenderingContext2D} context  of the whole picture */
  compose(context) {
    const { ratio, palette } = this;
    for (const { place, sheet } of this.sheets) {
      for (const canvas of sheet.canvases)
        context.drawImage(canvas, Math.round(place.x * ratio), Math.round(place.y * ratio));
      context.save();
      context.scale(ratio, ratio);
      writeCaption(context, place.caption, palette);
      context.restore();
    }
  }
}

/** @param {Layout} layout @param {number} ratio @param {string} advice @throws {Error} `too-large` */
function requireSize({ width, height }, ratio, advice) {
  if (width * height * ratio * ratio <= MOST_PIXELS) return;
  const message = `An image of ${Math.round(width * ratio)} x ${Math.round(height * ratio)} pixels is too large; ${advice}.`;
  throw Object.assign(new Error(message), { code: "too-large" });
}

/**
 * An image, made in slices.
 * @param {ImageKind} kind
 * @param {Layout} layout
 * @param {{ title: string, ratio: number, advice: string, check?: () => void }} style   `ratio`: pixels of a PNG a CSS
 *   pixel; `advice`: where it would be too large; `check`: throws where what is shown is no more
 * @param {(progress: number) => boolean} [onProgress]   0 to 1; returns whether to continue
 * @returns {Promise<Blob | null>} null where it was cancelled
 * @throws {Error} `too-large`, `no-canvas`, and what `check` throws
 */
export async function imageOf(kind, layout, { title, ratio, advice, check }, onProgress = () => true) {
  requireSize({ ...layout, height: heightOf(layout) }, ratio, advice);
  const slices = kind === "png" ? pngOf(layout, ratio) : svgOf(layout, title);
  for (;;) {
    await new Promise((resolve) => setTimeout(resolve));
    check?.();
    const until = performance.now() + SLICE;
    let slice = slices.next();
    while (!slice.done && performance.now() < until) slice = slices.next();
    if (!onProgress(slice.done ? 1 : slice.value)) return null;
    if (slice.done) return slice.value();
  }
}

/** @param {OffscreenCanvasRenderingContext2D} context @param {string} colour */
function fill(context, colour) {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.fillStyle = colour;
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
}

/** With its foot. @param {Layout} layout */
function heightOf({ height, foot }) {
  return height + Number(foot?.getAttribute("height") ?? 0);
}

/** @param {Layout} layout @param {number} ratio @returns {Slices} */
function* pngOf(layout, ratio) {
  const { width, height, foot } = layout;
  const context = contextOf(Math.round(width * ratio), Math.round(heightOf(layout) * ratio));
  fill(context, layout.look.palette.stage);
  // One figure after the other: the layers of all at once take too much memory on some machines.
  for (const [i, place] of layout.places.entries()) {
    const picture = new Picture({ ...layout, places: [place] }, ratio, () => new OffscreenCanvas(1, 1));
    for (const _ of picture.draw()) yield i / layout.places.length;
    picture.compose(context);
  }
  return async () => {
    if (foot) {
      const image = await decoded(new XMLSerializer().serializeToString(foot));
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.drawImage(image, 0, height, width, heightOf(layout) - height);
    }
    return context.canvas.convertToBlob({ type: "image/png" });
  };
}

/** @param {Layout} layout @param {string} title @returns {Slices} */
function* svgOf(layout, title) {
  const { foot, height, look } = layout;
  const { palette } = look;
  const picture = new Picture(
    layout,
    IMAGES,
    ({ width, height }) =>
      /** @type {Canvas} */ (/** @type {unknown} */ (new SvgLayer(Math.ceil(width), Math.ceil(height)))),
  );
  for (const _ of picture.draw()) yield 0.5;
  const whole = new SvgContext(Math.round(layout.width), Math.round(heightOf(layout)));
  for (const { caption } of layout.places)
    writeCaption(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (whole)), caption, palette);
  return async () => {
    const elements = await Promise.all(
      picture.sheets.flatMap(({ place: { x, y }, sheet }, s) =>
        sheet.canvases.map((layer, l) =>
          /** @type {SvgLayer} */ (/** @type {unknown} */ (layer)).element(`s${s}${l}`, Math.round(x), Math.round(y)),
        ),
      ),
    );
    if (foot) {
      foot.setAttribute("y", String(Math.round(height)));
      elements.push(new XMLSerializer().serializeToString(foot));
    }
    return svgFile(whole, elements, { background: palette.stage, title });
  };
}

/**
 * A film of figures, in the colours and sizes that they have now.
 * @param {Layout} layout
 * @param {number} width  pixels
 * @param {number} seconds
 * @param {(drawings: any[], part: number) => void} place   changes the drawings so that they show a part, 0 to 1
 * @param {() => void} [check]   throws where what is shown is no more; called after every pause
 * @returns {Film}
 * @throws {Error} `too-large`
 */
export function filmOf(layout, width, seconds, place, check = () => {}) {
  const ratio = width / layout.width;
  requireSize(layout, ratio, "choose a smaller size");
  const drawings = layout.places.map(({ drawing }) => drawing);
  const picture = new Picture(layout, ratio, () => contextOf(1, 1, true).canvas);
  return {
    width,
    height: even(layout.height * ratio),
    seconds,
    *draw(context, part) {
      check();
      place(drawings, part);
      for (const _ of picture.draw()) {
        yield;
        check();
      }
      fill(context, picture.palette.stage);
      picture.compose(context);
    },
  };
}

/**
 * Draws a caption.
 * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} context
 * @param {Caption} caption
 * @param {Palette} palette
 */
function writeCaption(context, { x, y, width, name, note }, palette) {
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
