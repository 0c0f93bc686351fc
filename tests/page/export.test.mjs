/** What is taken away is what the stage shows. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { readNpy, writeNpy } from "../../www/formats/npy.js";
import {
  PHONE,
  addressOf,
  click,
  counters,
  fill,
  finish,
  growthHash,
  onPausedPage,
  pickFile,
  unfold,
  useBrowser,
  take,
} from "./browser.mjs";
import { inTurn, restage } from "./turns.mjs";
import { allOf, readXml } from "./xml.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/**
 * Makes pictures as a browser decodes them: `names` of variables in the page.
 * @param {Page} page
 * @param {Record<string, { bytes: Buffer, type: string }>} files
 */
async function decode(page, files) {
  await page.evaluate(
    async (given) => {
      for (const [name, { base64, type }] of Object.entries(given)) {
        const image = new Image();
        image.src = `data:${type};base64,${base64}`;
        await image.decode();
        document.getElementById(`decoded-${name}`)?.remove();
        image.id = `decoded-${name}`;
        image.hidden = true;
        document.body.append(image);
      }
    },
    Object.fromEntries(
      Object.entries(files).map(([name, { bytes, type }]) => [name, { base64: bytes.toString("base64"), type }]),
    ),
  );
}

/**
 * Mean difference of two decoded pictures' colours, 0 to 255, both drawn as large as the second.
 * @param {Page} page
 * @param {string} one
 * @param {string} other
 */
async function difference(page, one, other) {
  return page.evaluate(
    ([a, b]) => {
      const [first, second] = [a, b].map(
        (name) => /** @type {HTMLImageElement} */ (document.getElementById(`decoded-${name}`)),
      );
      const { width, height } = second;
      const [left, right] = [first, second].map((image) => {
        const context = new OffscreenCanvas(width, height).getContext("2d");
        context?.drawImage(image, 0, 0, width, height);
        return /** @type {ImageData} */ (context?.getImageData(0, 0, width, height)).data;
      });
      return left.reduce((sum, value, i) => sum + Math.abs(value - right[i]), 0) / left.length;
    },
    [one, other],
  );
}

/**
 * How many pixels of a sheet differ from the same place in a decoded picture of the stage, and how many are not
 * ground.
 * @param {Page} page
 * @param {string} id
 * @param {string} picture
 */
async function unlike(page, id, picture) {
  return page.evaluate(
    ([pane, name]) => {
      const figure = /** @type {HTMLElement} */ (document.getElementById(pane));
      const stage = /** @type {HTMLElement} */ (document.getElementById("stage")).getBoundingClientRect();
      const sheet = /** @type {HTMLElement} */ (figure.querySelector(".sheet")).getBoundingClientRect();
      const canvases = [...figure.querySelectorAll("canvas")];
      const { width, height } = canvases[0];
      const ratio = devicePixelRatio;
      const shown = new OffscreenCanvas(width, height).getContext("2d");
      const taken = new OffscreenCanvas(width, height).getContext("2d");
      if (!shown || !taken) throw new Error("no canvas");
      shown.fillStyle = getComputedStyle(/** @type {HTMLElement} */ (document.getElementById("stage"))).backgroundColor;
      shown.fillRect(0, 0, width, height);
      for (const canvas of canvases) shown.drawImage(canvas, 0, 0);
      const at = [sheet.left - stage.left, sheet.top - stage.top].map((place) => Math.round(place * ratio));
      taken.drawImage(/** @type {HTMLImageElement} */ (document.getElementById(`decoded-${name}`)), -at[0], -at[1]);
      const [a, b] = [shown, taken].map(
        (context) => new Uint32Array(context.getImageData(0, 0, width, height).data.buffer),
      );
      return {
        pixels: a.length,
        unlike: a.filter((pixel, i) => pixel !== b[i]).length,
        ink: a.filter((pixel) => pixel !== a[0]).length,
      };
    },
    [id, picture],
  );
}

/** Width and height of a PNG. @param {Buffer} bytes */
function sizeOfPng(bytes) {
  assert.equal(bytes.subarray(0, 8).toString("latin1"), "\x89PNG\r\n\x1a\n");
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
}

for (const ratio of [1, 2]) {
  test(`a picture has the stage's pixels, ${ratio} a CSS pixel, and each size its own`, () =>
    onPausedPage(
      async (page) => {
        await click(page, "#step-100");
        await unfold(page, "export");
        const box = await page.locator("#stage").evaluate((stage) => stage.getBoundingClientRect().toJSON());
        await page.uncheck("#export-words");
        for (const scale of ratio === 1 ? [1, 4] : [2]) {
          await page.selectOption("#export-scale", String(scale));
          const { name, bytes } = await take(page, "png");
          assert.equal(name, "stones-prm-seed0-100.png");
          assert.deepEqual(sizeOfPng(bytes), [Math.round(box.width * scale), Math.round(box.height * scale)]);
          if (scale !== ratio) continue;
          await decode(page, { png: { bytes, type: "image/png" } });
          for (const pane of ["workspace", "cspace"]) {
            const found = await unlike(page, pane, "png");
            assert.ok(found.ink > found.pixels / 100, `${pane} shows something: ${found.ink}`);
            // With two pixels a CSS pixel the browser may place the glyphs of labels differently on canvases of
            // different sizes.
            const most = ratio === 1 ? 0 : found.pixels / 400;
            assert.ok(found.unlike <= most, `${pane}: ${found.unlike} of ${found.pixels} pixels`);
          }
        }
      },
      { deviceScaleFactor: ratio },
    ));
}

/**
 * Begins a moving picture and clicks a button as soon as it is being made: a click from outside may come after its end.
 * @param {import("playwright-core").Page} page @param {string} id
 */
const clickWhileMade = (page, id) =>
  page.evaluate(
    (button) =>
      new Promise((resolve) => {
        const progress = /** @type {HTMLElement} */ (document.getElementById("export-progress"));
        new MutationObserver((_, observer) => {
          if (progress.hidden) return;
          observer.disconnect();
          document.getElementById(button)?.click();
          resolve(undefined);
        }).observe(progress, { attributeFilter: ["hidden"] });
        document.getElementById("export-gif")?.click();
      }),
    id,
  );

test("what is taken away is what the stage shows", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "what is missing says why; files hold the numbers of the run; the exported scene plans the same": async (
          page,
        ) => {
          await unfold(page, "export");
          const off = () => Promise.all(["gif", "path", "png"].map((id) => page.isDisabled(`#export-${id}`)));
          assert.deepEqual(await off(), [true, true, false]);
          assert.match(await page.innerText("#export-gif-hint"), /Nothing has happened/);
          assert.match(await page.innerText("#export-path-hint"), /No path/);
          const run = await finish(page);
          assert.deepEqual(await off(), [false, false, false]);
          const csv = (await take(page, "counters")).text
            .trimEnd()
            .split("\r\n")
            .map((row) => row.split(","));
          assert.deepEqual(csv[0], [
            "iteration",
            "vertices",
            "edges",
            "events",
            "phase",
            "configuration_checks",
            "motion_checks",
            "clearance_evaluations",
            "cost",
          ]);
          assert.equal(csv.length - 1, run.iterations + 1);
          assert.deepEqual(csv[1].slice(0, 5), ["0", "2", "0", "0", "sampling"]);
          const last = csv[csv.length - 1];
          assert.deepEqual(last.slice(0, 3), [run.iterations, run.vertices, run.edges].map(String));
          assert.equal(last[5], (await page.innerText("#count-checks")).replace(",", ""));

          const result = await take(page, "result");
          const { path, fingerprint, length, stats } = JSON.parse(result.text);
          assert.deepEqual([fingerprint, length, stats.vertices], [run.fingerprint, run.length, run.vertices]);

          const taken = await take(page, "path");
          assert.equal(taken.name, `stones-prm-seed0-${run.iterations}-path.npy`);
          assert.deepEqual(readNpy(taken.bytes), { shape: [path.length, 2], data: Float64Array.from(path.flat()) });
          const vertices = readNpy((await take(page, "vertices")).bytes);
          assert.deepEqual(vertices.shape, [run.vertices, 2]);
          assert.deepEqual(
            vertices.data.slice(0, 4),
            Float64Array.from([...path[0], ...path[path.length - 1]]),
            "start and goal come first",
          );
          await fill(page, "#time", "50");
          await page.waitForSelector("#counters[data-iterations='50'][data-settled=true]", { state: "attached" });
          assert.equal(
            readNpy((await take(page, "vertices")).bytes).shape[0],
            (await counters(page)).vertices,
            "those that are shown",
          );

          const scene = await take(page, "scenario");
          assert.equal(scene.name, "stones.json");
          await pickFile(page, scene.name, scene.text);
          await page.waitForSelector("body[data-scene=file]");
          assert.equal((await finish(page)).fingerprint, run.fingerprint);
        },

        "an SVG is well formed, looks like the picture, and asks for nothing from elsewhere": async (page) => {
          await finish(page);
          await unfold(page, "export");
          await page.selectOption("#export-scale", "1");
          const png = await take(page, "png");
          const { bytes: svg, text } = await take(page, "svg");
          assert.ok(text.split("<path").length > 500, "its lines are paths");
          assert.match(text, /<title>[^<]*roadmap[^<]*<\/title>/);
          assert.doesNotMatch(text, /color-mix|oklab|image:\d|href="(?!data:image\/png)/);
          // Below the figures is what was run, what came of it, and the legend.
          const words = allOf(readXml(text), "text").map(({ children }) => children.join(""));
          for (const part of [
            "Two links among stones",
            "PRM",
            "seed 0",
            "Path found",
            "start",
            "goal",
            "roadmap",
            "path",
          ])
            assert.ok(
              words.some((line) => line.includes(part)),
              `${part}: ${words.join(" | ")}`,
            );
          // An image that is not well formed cannot be decoded.
          await decode(page, {
            png: { bytes: png.bytes, type: "image/png" },
            svg: { bytes: svg, type: "image/svg+xml" },
          });
          const mean = await difference(page, "svg", "png");
          assert.ok(mean > 0 && mean < 3, `the mean difference is ${mean}`);
          const blank = Buffer.from(text.replace(/<path[^>]*>/g, ""));
          await decode(page, { blank: { bytes: blank, type: "image/svg+xml" } });
          assert.ok((await difference(page, "blank", "png")) > 2 * mean, "without its lines it would not look like it");
        },

        "a moving picture has its frames and ends with what the stage shows, which stands still": async (page) => {
          await click(page, "#step-100");
          await unfold(page, "export");
          await page.uncheck("#export-words");
          await page.selectOption("#export-scale", "1");
          const png = await take(page, "png");
          await page.selectOption("#export-frames", "24");
          await page.selectOption("#export-width", "480");
          const before = [
            await growthHash(page, "workspace"),
            await growthHash(page, "cspace"),
            JSON.stringify(await counters(page)),
            await page.inputValue("#time"),
          ];
          await page.evaluate(() => {
            /** @type {Set<string>} */
            const seen = new Set();
            const look = () => {
              seen.add(
                `${document.getElementById("counters")?.dataset.iterations} ${document.getElementById("counters")?.dataset.settled}`,
              );
              if (document.body.dataset.looking !== "no") requestAnimationFrame(look);
              else document.body.dataset.seen = [...seen].join("|");
            };
            look();
          });
          const gif = await take(page, "gif");
          await page.evaluate(() => {
            document.body.dataset.looking = "no";
          });
          await page.waitForSelector("body[data-seen]");
          assert.equal(
            await page.getAttribute("body", "data-seen"),
            "100 true",
            "no other iteration was told of meanwhile",
          );
          assert.deepEqual(
            [
              await growthHash(page, "workspace"),
              await growthHash(page, "cspace"),
              JSON.stringify(await counters(page)),
              await page.inputValue("#time"),
            ],
            before,
          );
          assert.equal(gif.name, "stones-prm-seed0-100-growth.gif");
          assert.equal(gif.bytes.subarray(0, 6).toString("latin1"), "GIF89a");
          assert.equal(gif.bytes.readUInt16LE(6), 480);
          await decode(page, { png: { bytes: png.bytes, type: "image/png" } });
          const durations = await page.evaluate(async (base64) => {
            const decoder = new ImageDecoder({
              data: Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)),
              type: "image/gif",
            });
            await decoder.tracks.ready;
            await decoder.completed;
            return Promise.all(
              Array.from({ length: decoder.tracks.selectedTrack?.frameCount ?? 0 }, async (_, frameIndex) => {
                const { image } = await decoder.decode({ frameIndex });
                const canvas = document.createElement("canvas");
                Object.assign(canvas, {
                  id: `decoded-${frameIndex}`,
                  width: image.displayWidth,
                  height: image.displayHeight,
                  hidden: true,
                });
                canvas.getContext("2d")?.drawImage(image, 0, 0);
                document.body.append(canvas);
                const { duration } = image;
                image.close();
                return duration ?? 0;
              }),
            );
          }, gif.bytes.toString("base64"));
          assert.equal(durations.length, 24);
          assert.ok(durations[23] >= 2e6, `the last frame rests for ${durations[23]} us`);
          const [first, middle, last] = await Promise.all(
            ["0", "12", "23"].map((frame) => difference(page, "png", frame)),
          );
          assert.ok(
            last < 3 && last < middle && middle < first,
            `the mean differences to the picture are ${first}, ${middle}, ${last}`,
          );
        },

        "a moving picture can be cancelled, and is not gone on with when another run begins": async (page) => {
          await finish(page);
          await unfold(page, "export");
          await page.selectOption("#export-frames", "96");
          await clickWhileMade(page, "export-cancel");
          await page.waitForFunction(() => document.getElementById("export-told")?.textContent === "Cancelled.");
          assert.equal(await page.isVisible("#export-progress"), false);
          await clickWhileMade(page, "reset");
          await page.waitForSelector("#notice[data-code=run-replaced]");
          assert.equal((await click(page, "#step-10")).iterations, 10);
          assert.match((await take(page, "gif")).name, /-10-growth\.gif$/);
        },

        "a race is exported with each planner in one table, and by choice in a separate file": async (page) => {
          await page.locator("#race-fold > summary").click();
          await page.click("#add-rival");
          await page.waitForSelector("#lane-B");
          await page.click("#finish");
          await page.waitForFunction(
            () =>
              [...document.querySelectorAll("#standings tbody tr")].length === 2 &&
              document.getElementById("counters")?.dataset.settled === "true",
          );
          await unfold(page, "export");
          const rows = (await take(page, "counters")).text
            .trimEnd()
            .split("\r\n")
            .map((row) => row.split(","));
          assert.deepEqual(rows[0].slice(0, 2), ["planner", "iteration"]);
          assert.equal(new Set(rows.slice(1).map(([planner]) => planner)).size, 2);
          await page.selectOption("#export-lane", "1");
          const { planner } = JSON.parse((await take(page, "result")).text);
          assert.ok(
            rows.some(([name]) => name === `"B ${planner}"`),
            planner,
          );
          const { name, bytes } = await take(page, "png");
          assert.match(name, /^stones-race-/);
          assert.ok(sizeOfPng(bytes)[0] > 100);
        },

        "what is copied to embed the stage opens it there": async (page, url) => {
          await page.selectOption("#planner", "rrt");
          await click(page, "#step-100");
          await unfold(page, "export");
          await page.locator("#embed-fold > summary").click();
          for (const [kind, sign] of [
            ["page", /^<iframe src="([^"]+)"/],
            ["slides", /data-src="([^"]+)"/],
            ["notebook", /IFrame\("([^"]+)"/],
          ]) {
            await page.selectOption("#embed-kind", String(kind));
            await page.waitForFunction(
              ([source]) =>
                new RegExp(source).test(
                  /** @type {HTMLTextAreaElement} */ (document.getElementById("embed-text")).value,
                ),
              [/** @type {RegExp} */ (sign).source],
            );
            const [, address] = /** @type {RegExp} */ (sign).exec(await page.inputValue("#embed-text")) ?? [];
            assert.ok(address.startsWith(`${addressOf(url, "?embed=1")}#`), address);
            if (kind !== "notebook") continue;
            await page.goto(address);
            await page.waitForSelector("#counters[data-settled=true][data-iterations='100']", { state: "attached" });
            assert.equal(await page.inputValue("#planner"), "rrt");
          }
        },
      },
      restage,
    ),
  ));

test("on a phone all of it is at hand, and the picture is as tall as the stage", () =>
  onPausedPage(
    async (page) => {
      await click(page, "#step-100");
      await unfold(page, "export");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
      for (const button of await page.locator("#export button:visible, #export select:visible").all()) {
        const box = await button.boundingBox();
        assert.ok(box && box.height >= 24 && box.x >= 0 && box.x + box.width <= 390, await button.innerText());
      }
      await page.selectOption("#export-scale", "2");
      const [width, height] = sizeOfPng((await take(page, "png")).bytes);
      assert.ok(height > 1.5 * width, `${width} x ${height}: one sheet below the other`);
      await pickFile(page, "poses.npy", writeNpy(new Float64Array(4), [2, 2]));
      await page.waitForSelector("#marked:not([hidden])");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    },
    { ...PHONE, colorScheme: "dark" },
  ));
