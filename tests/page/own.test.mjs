/** The pages with custom robots: each plans in the browser and draws, in light and dark. */
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { onPage, root, useBrowser } from "./browser.mjs";

useBrowser(root);

const pictures = join(root, "target", "own");

test("examples/own: each page solves and draws", async (t) => {
  for (const [name, colorScheme] of /** @type {const} */ ([
    ["two-discs", "light"],
    ["six-joints", "dark"],
    ["drone", "light"],
  ])) {
    await t.test(name, () => {
      /** @type {string[]} */
      const faults = [];
      // Chromium without a graphics processor warns of the time that a screenshot of WebGL takes: such words are no
      // errors.
      const before = async (/** @type {import("playwright-core").Page} */ page) => {
        page.on("pageerror", ({ message }) => faults.push(message));
      };
      return onPage(
        { viewport: { width: 640, height: 480 }, colorScheme },
        async (page) => {
          await page.waitForFunction(
            () => document.querySelector("#status")?.textContent?.startsWith("solved"),
            undefined,
            { timeout: 60_000 },
          );
          assert.match(
            await page.locator("#status").innerText(),
            /^solved: [1-9]\d* vertices, a path of [1-9]\d* waypoints, every edge proven$/,
          );
          await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
          const picture = await page.screenshot();
          const colours = await page.evaluate(async (text) => {
            const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob());
            const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
              new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")
            );
            context.drawImage(bitmap, 0, 0);
            const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
            return new Set(Array.from({ length: data.length / 4 }, (_, i) => data.slice(4 * i, 4 * i + 3).join())).size;
          }, picture.toString("base64"));
          assert.ok(colours > 100, `${colours} colours`);
          mkdirSync(pictures, { recursive: true });
          writeFileSync(join(pictures, `${name}-${colorScheme}.png`), picture);
          assert.deepEqual(faults, []);
        },
        { path: `examples/own/${name}.html`, before, expectErrors: true },
      );
    });
  }
});
