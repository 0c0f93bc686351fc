/** Reads the printed link of a page: by a reader of QR codes that shares nothing with what draws them. */
import assert from "node:assert/strict";
import { createRequire } from "node:module";

/** @import { Page } from "./browser.mjs" */
/** @type {typeof import("jsqr").default} */
const readCode = createRequire(import.meta.url)("jsqr");

/** Pixels of the picture that is read. */
const SIDE = 640;

/**
 * The text of a code on the page, as it is displayed.
 * @param {Page} page  in print
 * @param {import("playwright-core").Locator} [code]
 * @returns {Promise<string>}
 */
export async function printedCode(page, code = page.locator("#printed-link svg")) {
  await code.waitFor();
  // On paper it is as sharp.
  await code.evaluate((svg, side) => {
    svg.setAttribute("width", String(side));
    svg.setAttribute("height", String(side));
  }, SIDE);
  const picture = (await code.screenshot()).toString("base64");
  const { text, width, height } = await page.evaluate(async (source) => {
    const image = Object.assign(new Image(), { src: `data:image/png;base64,${source}` });
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.drawImage(image, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, image.width, image.height);
    // A text arrives at once; as many numbers take minutes.
    const text = Array.from(
      pixels.filter((_, i) => i % 4 === 0),
      (red) => (red > 127 ? "1" : "0"),
    ).join("");
    return { text, width: image.width, height: image.height };
  }, picture);
  const data = Uint8ClampedArray.from({ length: 4 * text.length }, (_, i) => 255 * Number(i % 4 === 3 || text[i >> 2]));
  const found = readCode(data, width, height, { inversionAttempts: "dontInvert" });
  assert.ok(found, "there is a code, black on white");
  return found.data;
}
