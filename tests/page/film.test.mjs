/**
 * Films: what was filmed is at its start in the first frame and at its end in the last, and both formats can be read
 * and played.
 */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import {
  chooseScene,
  click,
  download,
  fill,
  finish,
  onPage,
  onPausedPage,
  pageRoot,
  root,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { readGif } from "./gif.mjs";
import { click as clickRoom, onReach, poseOf, putBack, rest } from "./reach.mjs";
import { readWebm } from "./webm.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */
/** @typedef {ReturnType<typeof readGif>} Gif */

useBrowser();

/** A window in which films are small. */
const SMALL = { viewport: { width: 1000, height: 560 } };

/** Makes a film. @param {Page} page @param {"gif" | "webm"} format */
async function film(page, format) {
  const file = await download(page, `#export-${format}`);
  await page.waitForSelector("#export-progress", { state: "hidden" });
  return file;
}

/**
 * Mean difference of a frame of a film and a picture of the same figures, 0 to 255.
 * @param {Page} page
 * @param {Gif} gif
 * @param {number} frame
 * @param {Buffer} png
 */
async function difference(page, { width, height, frames }, frame, png) {
  return page.evaluate(
    async ({ base64, size, rgb }) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const context = new OffscreenCanvas(size[0], size[1]).getContext("2d");
      if (!context) throw new Error("no canvas");
      context.imageSmoothingQuality = "high";
      context.drawImage(image, 0, 0, size[0], size[1]);
      const { data } = context.getImageData(0, 0, size[0], size[1]);
      const film = Uint8Array.from(atob(rgb), (c) => c.charCodeAt(0));
      return (
        film.reduce((sum, value, i) => sum + Math.abs(value - data[4 * Math.floor(i / 3) + (i % 3)]), 0) / film.length
      );
    },
    { base64: png.toString("base64"), size: [width, height], rgb: Buffer.from(frames[frame].rgb).toString("base64") },
  );
}

/**
 * The first frame is like the first picture, and the last like the second, and not the other way round.
 * @param {Page} page
 * @param {Gif} gif
 * @param {Buffer} first
 * @param {Buffer} last
 */
async function assertEnds(page, gif, first, last) {
  const end = gif.frames.length - 1;
  const [a, b, c, d] = await Promise.all([
    difference(page, gif, 0, first),
    difference(page, gif, end, last),
    difference(page, gif, 0, last),
    difference(page, gif, end, first),
  ]);
  assert.ok(
    Math.max(a, b) < 6 && Math.min(c, d) > 1.15 * Math.max(a, b),
    `same ends: ${a}, ${b}; other ends: ${c}, ${d}`,
  );
}

/** Plays a video to its end, faster than it would be. @param {Page} page @param {Buffer} bytes */
async function played(page, bytes) {
  // The page's policy allows no video of its own.
  const other = await page.context().newPage();
  return other.evaluate(async (base64) => {
    const video = document.createElement("video");
    Object.assign(video, {
      muted: true,
      src: URL.createObjectURL(
        new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type: "video/webm" }),
      ),
    });
    video.playbackRate = 8;
    await video.play();
    await new Promise((resolve) => video.addEventListener("ended", resolve, { once: true }));
    return { duration: video.duration, width: video.videoWidth, height: video.videoHeight, at: video.currentTime };
  }, bytes.toString("base64"));
}

test("a robot is filmed on its path, and a drive", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "from the start to the goal, as a GIF and as a WebM that plays; the stage stays as it is": async (page) => {
          await finish(page);
          await unfold(page, "export");
          // A film has no words below its figures.
          await page.uncheck("#export-words");
          await page.selectOption("#export-scale", "1");
          const pictures = [];
          for (const along of ["0", "1", "0.3"]) {
            await page.fill("#along", along);
            pictures.push((await download(page, "#export-png")).bytes);
          }
          await page.selectOption("#export-film", "path");
          await page.selectOption("#export-width", "480");
          const gif = await film(page, "gif");
          assert.match(gif.name, /^stones-prm-seed0-\d+-path\.gif$/);
          const read = readGif(gif.bytes);
          assert.equal(read.width, 480);
          assert.equal(read.loops, 0);
          assert.ok(
            read.frames.length > 30 && gif.bytes.length < 1e6,
            `${read.frames.length} frames, ${gif.bytes.length} bytes`,
          );
          await assertEnds(page, read, pictures[0], pictures[1]);
          assert.equal(await page.inputValue("#along"), "0.3");
          assert.deepEqual((await download(page, "#export-png")).bytes, pictures[2]);
          const webm = await film(page, "webm");
          const { kind, codec, tracks, ...video } = readWebm(webm.bytes);
          assert.deepEqual(
            [kind, codec, tracks, video.width, video.height],
            ["webm", "V_VP9", 1, read.width, read.height],
          );
          const seconds = read.frames.reduce((sum, { delay }) => sum + delay, 0) / 100;
          assert.ok(Math.abs(video.duration - seconds) < 0.1, `${video.duration} s and ${seconds} s`);
          // 30 frames a second and 20, and a rest of two seconds.
          assert.ok(
            Math.abs(video.frames - 1.5 * read.frames.length) <= 1,
            `${video.frames} and ${read.frames.length} frames`,
          );
          const shown = await played(page, webm.bytes);
          assert.deepEqual([shown.width, shown.height], [read.width, read.height]);
          assert.ok(
            Math.abs(shown.duration - video.duration) < 0.01 && shown.at === shown.duration,
            JSON.stringify(shown),
          );
        },

        "from the start to where the car is, and one control from there": async (page) => {
          await chooseScene(page, "parking");
          await unfold(page, "export");
          await page.uncheck("#export-words");
          await page.selectOption("#export-scale", "1");
          await page.selectOption("#export-width", "480");
          await page.selectOption("#export-film", "drive");
          assert.deepEqual(
            [await page.isDisabled("#export-gif"), await page.innerText("#export-gif-hint")],
            [true, "Nothing has been driven."],
          );
          await page.click("#your-turn");
          await page.waitForSelector("#drive:not([hidden])");
          const first = (await download(page, "#export-png")).bytes;
          await page.focus("#stage");
          for (const key of ["w", "w", "w", "a", "c", "c", "c", "c"]) await page.keyboard.press(key);
          await page.waitForSelector("#drive[data-keys='8']");
          const last = (await download(page, "#export-png")).bytes;
          const read = readGif((await film(page, "gif")).bytes);
          await assertEnds(page, read, first, last);
          assert.equal(read.frames.length, 40, "two seconds of driving");
          await page.selectOption("#export-film", "control");
          assert.equal(await page.isDisabled("#export-webm"), true);
          await page.click("#drive .more summary");
          await page.fill("#roll-v", "0.5");
          await page.click("#drive .roll button");
          await page.waitForSelector("#export-webm:enabled");
          const { bytes } = await film(page, "webm");
          assert.ok(readWebm(bytes).frames >= 30);
          await page.evaluate(() => {
            VideoEncoder.isConfigSupported = async () => ({ supported: false });
          });
          await page.click("#export-webm");
          await page.waitForSelector("#notice[data-code=no-encoder]");
          assert.equal(await page.isVisible("#export-progress"), false);
        },
      },
      restage,
    ),
    SMALL,
  ));

test("an arm is filmed", (t) =>
  onReach(
    inTurn(
      t,
      {
        "the motion from A to B and a run of inverse kinematics are filmed, and the arm stays where it is": async (
          page,
        ) => {
          await unfold(page, "export");
          await page.uncheck("#export-words");
          await page.selectOption("#export-width", "480");
          assert.equal(await page.inputValue("#export-film"), "between");
          await page.click("#mode-between");
          await rest(page);
          const ends = [];
          for (const along of ["0", "1", "0.5"]) {
            await page.fill("#along", along);
            await rest(page);
            ends.push((await download(page, "#export-png")).bytes);
          }
          const before = await poseOf(page);
          const motion = await film(page, "gif");
          assert.match(motion.name, /-between\.gif$/);
          await assertEnds(page, readGif(motion.bytes), ends[0], ends[1]);
          assert.deepEqual(await poseOf(page), before);
          await page.click("#mode-solve");
          await rest(page);
          assert.match(await page.innerText("#export-gif-hint"), /let it run first/);
          const start = (await download(page, "#export-png")).bytes;
          for (const _ of [1, 2]) await clickRoom(page, "#solve-step-10");
          const told = await page
            .locator("#solve")
            .evaluate((host) => ({ .../** @type {HTMLElement} */ (host).dataset }));
          const end = (await download(page, "#export-png")).bytes;
          await assertEnds(page, readGif((await film(page, "gif")).bytes), start, end);
          assert.deepEqual(
            await page.locator("#solve").evaluate((host) => ({ .../** @type {HTMLElement} */ (host).dataset })),
            told,
          );
        },

        "another arm ends the film of the one before, in words": async (page) => {
          await unfold(page, "export");
          await page.click("#mode-between");
          await rest(page);
          await page.evaluate(
            () =>
              new Promise((resolve) => {
                const progress = /** @type {HTMLElement} */ (document.getElementById("export-progress"));
                new MutationObserver((_, observer) => {
                  if (progress.hidden) return;
                  observer.disconnect();
                  /** @type {HTMLElement} */ (document.querySelector("input[name=scene]:not(:checked)")).click();
                  resolve(undefined);
                }).observe(progress, { attributeFilter: ["hidden"] });
                document.getElementById("export-gif")?.click();
              }),
          );
          await page.waitForSelector("#notice[data-code=run-replaced]");
          assert.match(await page.innerText("#notice"), /The robot changed/);
          assert.match((await film(page, "gif")).name, /-between\.gif$/);
        },
      },
      putBack,
    ),
    SMALL,
  ));

test("trajectories are filmed as they appear, and their particles as they move", () =>
  onPage(
    { reducedMotion: "reduce", ...SMALL },
    async (page) => {
      await page.waitForSelector("body[data-settled=true] #stage[data-status=solved]");
      await fill(page, "#option-count", "200");
      await page.waitForSelector("body[data-settled=true] #stage[data-status=running]");
      await page.click("#course-finish");
      await page.waitForSelector("body[data-settled=true] #stage[data-status=solved]");
      await unfold(page, "export");
      await page.selectOption("#export-width", "480");
      /** Pixels that differ from the first frame. @param {Gif} gif @param {number} frame */
      const changed = ({ frames }, frame) =>
        frames[frame].rgb.filter((value, i) => value !== frames[0].rgb[i]).length / frames[0].rgb.length;
      const growth = readGif((await film(page, "gif")).bytes);
      assert.equal(growth.frames.length, 120);
      const [half, all] = [changed(growth, 60), changed(growth, 119)];
      assert.ok(half > 0.005 && all > 1.2 * half, `${half}, then ${all}`);
      await page.selectOption("#export-film", "particles");
      const particles = readGif((await film(page, "gif")).bytes);
      assert.ok(changed(particles, 30) > 0.005 && changed(particles, particles.frames.length - 1) > 0.005);
      assert.equal(await page.getAttribute("#course-move", "aria-pressed"), "false");
    },
    { path: "trajectories.html" },
  ));

test("where the browser has no video encoder there are GIFs alone, and the panel says why", () =>
  onPausedPage(
    async (page) => {
      await click(page, "#step-100");
      await unfold(page, "export");
      assert.equal(await page.isVisible("#export-webm"), false);
      assert.match(await page.innerText("#export-gif-hint"), /equal steps\. WebM needs a browser with WebCodecs\.$/);
      await page.selectOption("#export-frames", "24");
      assert.equal(readGif((await film(page, "gif")).bytes).frames.length, 24);
    },
    SMALL,
    {
      before: async (page) =>
        void (await page.addInitScript(() => {
          Reflect.deleteProperty(window, "VideoEncoder");
        })),
    },
  ));

test("what writes WebM is loaded with the first film only, and its licence is among the notices", () => {
  const parts = readdirSync(join(pageRoot, "parts")).filter((name) => /^webm-.*\.js$/.test(name));
  assert.ok(parts.length > 0);
  for (const name of ["index", "reach", "trajectories", "fleet", "prm-rl"])
    assert.doesNotMatch(readFileSync(join(pageRoot, `${name}.html`), "utf8"), /webm-/);
  const notice = /mediabunny \d[\d.]* \(MPL-2\.0\), https:\/\/\S+$/m;
  assert.match(readFileSync(join(pageRoot, "THIRD-PARTY-NOTICES.txt"), "utf8"), notice);
  assert.match(readFileSync(join(root, "dist", "planarium.html"), "utf8"), notice);
});
