/**
 * The planner's page for everyone: keyboard and touch, colours, less motion, a projector. What holds for all pages is in
 * pages.test.mjs.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addressOf,
  PHONE,
  atRest,
  chooseScene,
  click,
  coloursOf,
  finish,
  isDeep,
  keys,
  onPausedPage,
  pixelsOf,
  pressUntil,
  reveal,
  textMatches,
  unfold,
  useBrowser,
  violations,
  linkOf,
  offered,
  setParameter,
} from "./browser.mjs";
import { plane, swipe } from "./editing.mjs";
import { assertFaultless, assertForced, assertTargets } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";

useBrowser();

test("the planner's page under a finger", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a finger drags the robot, and the page scrolls beneath one that does not": async (page) => {
          await page.click("#your-turn");
          const before = await page.inputValue("#pose-0-number");
          const canvas = page.locator("#workspace canvas[data-layer=top]");
          const [x, y] = (await plane(page, 1.2))(0, 0);
          await swipe(page, [
            [x + 40, y],
            [x + 30, y - 40],
          ]);
          await page.waitForFunction(
            (value) => /** @type {HTMLInputElement} */ (document.getElementById("pose-0-number")).value !== value,
            before,
          );
          assert.equal(
            await canvas.evaluate((element) => getComputedStyle(element).touchAction),
            "none",
            "while it is moved by hand",
          );
          await page.click("#your-turn");
          await page.waitForFunction(() => !document.getElementById("stage")?.classList.contains("in-hand"));
          assert.match(await canvas.evaluate((element) => getComputedStyle(element).touchAction), /pan-y/);
          assert.doesNotMatch(
            (await page.getAttribute("meta[name=viewport]", "content")) ?? "",
            /user-scalable|maximum-scale/,
          );
        },

        "every control is at least 24 pixels high and wide, and in the transport 44 for a finger": async (page) => {
          for (const id of ["race", "view", "lessons", "export"]) await unfold(page, id);
          await reveal(page, "#more-parameters");
          await assertTargets(page);
          const transport = await page
            .locator("#transport button")
            .evaluateAll((buttons) => buttons.map((button) => button.getBoundingClientRect().height));
          assert.ok(
            transport.every((height) => height >= 44),
            `${transport}`,
          );
        },
      },
      restage,
    ),
    PHONE,
  ));

test("the planner's page is for everyone", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "with less motion the page is paused, nothing glows, a path is there at once and announced": async (page) => {
          assert.equal((await atRest(page)).iterations, 0);
          assert.equal(await page.innerText("#play"), "Play");
          await click(page, "#step-100");
          assert.equal(await pixelsOf(page, "workspace", "top", "halo"), 0);
          await finish(page);
          assert.equal(await page.getAttribute("#play", "data-playing"), "false");
          assert.ok((await pixelsOf(page, "workspace", "top", "path")) > 100);
          await textMatches(page, "#announcer", /^Path found/);
          assert.match(
            (await page.getAttribute("#workspace canvas[role=img]", "aria-label")) ?? "",
            /262 vertices.*solved/,
          );
        },

        "single keys work on stage and transport, and nowhere else": async (page) => {
          await page.focus("#stage");
          await pressUntil(page, ".", "#counters[data-iterations='1']");
          await pressUntil(page, "Space", "#play[data-playing=true]");
          await pressUntil(page, "Space", "#play[data-playing=false]");
          await pressUntil(page, "r", "#counters[data-iterations='0']");
          const seed = await page.inputValue("#parameter-seed");
          await page.keyboard.press("n");
          await page.waitForFunction(
            (old) => /** @type {HTMLInputElement} */ (document.getElementById("parameter-seed")).value !== old,
            seed,
          );
          await page.focus("#speed");
          await pressUntil(page, ".", "#counters[data-iterations='1']");
          await page.focus("#planner");
          await keys(page, ".", "r", "e");
          const { iterations } = await atRest(page);
          assert.equal(iterations, (await page.inputValue("#planner")) === "prm" ? 1 : 0);
          await page.focus("#stage");
          await page.keyboard.press(".");
          assert.equal((await atRest(page)).iterations, iterations + 1, "keys in the panel are the panel's");
          await page.focus("#stage");
          await pressUntil(page, "e", "#counters[data-status=solved], #counters[data-status=exhausted]");
        },

        "a scene is chosen, planned, gone back in and raced by keys alone": async (page) => {
          await page.focus("input[name=scene]:checked");
          await page.keyboard.press("ArrowRight");
          await page.waitForFunction(() => document.body.dataset.scene !== "stones");
          await atRest(page);
          await page.focus("#timeline");
          await keys(page, ".", ".");
          assert.equal((await atRest(page)).iterations, 2);
          await page.keyboard.press(",");
          assert.equal((await atRest(page)).iterations, 1);
          await page.focus("#race-fold > summary");
          await pressUntil(page, "Enter", "#add-rival");
          await page.focus("#add-rival");
          await pressUntil(page, "Enter", ".rival");
          await page.focus("#stage");
          await pressUntil(page, "e", "#counters[data-settled=true][data-status=solved]");
        },

        "on a projector words are larger and lines bolder; axe finds nothing": async (page) => {
          await chooseScene(page, "firs");
          await finish(page);
          const ink = async () =>
            (await pixelsOf(page, "workspace", "top", "path")) /
            (await page
              .locator("#workspace canvas[data-layer=top]")
              .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).width));
          const fontSize = () => page.evaluate(() => parseFloat(getComputedStyle(document.body).fontSize));
          const [size, thin] = [await fontSize(), await ink()];
          await click(page, "#projector");
          assert.equal(await page.isVisible(".panel"), false);
          assert.equal(await page.evaluate(() => document.activeElement?.id), "stage", "Space plays");
          const [obstacle, stage] = (await coloursOf(page, ["var(--obstacle)", "var(--stage)"])).map(luminance);
          assert.ok((stage + 0.05) / (obstacle + 0.05) >= 1.5);
          assert.ok((await fontSize()) > 1.3 * size);
          assert.ok((await ink()) > 1.25 * thin, `${await ink()} after ${thin}`);
          assert.deepEqual(await violations(page), []);
          await page.keyboard.press("Escape");
          assert.equal(await page.isVisible(".panel"), true);
        },

        "a disc has one figure, which fits any width": async (page) => {
          await chooseScene(page, "rings");
          await finish(page);
          await assertFaultless(page, "rings", 200);
        },

        "text and marks stand out, and different things differ for the colour-blind too": async (page) => {
          // Viénot, Brettel, Mollon 1999, "Digital video colourmaps for checking the legibility of displays by dichromats":
          // linear RGB.
          const SEEN = {
            protan: [
              [0.11238, 0.88762, 0],
              [0.11238, 0.88762, 0],
              [0.00401, -0.00401, 1],
            ],
            deutan: [
              [0.29275, 0.70725, 0],
              [0.29275, 0.70725, 0],
              [-0.02234, 0.02234, 1],
            ],
          };
          const PAIRS = [
            ["ink", "page"],
            ["quiet", "page"],
            ["quiet", "stage"],
            ["collision", "page"],
            ["obstacle", "stage"],
            ["obstacle-edge", "stage"],
            ["robot", "stage"],
            ["start", "stage"],
            ["goal", "stage"],
            ["growth", "stage"],
            ["newest", "stage"],
            ["path", "stage"],
            ["unproven", "stage"],
            ["rejected", "stage"],
            ["collision", "stage"],
            ["control", "page"],
          ];
          for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
            await page.emulateMedia({ colorScheme });
            // Pale obstacles have an edge; on a dark stage and on a projector they differ by themselves.
            const least = colorScheme === "dark" ? 1.5 : 1.35;
            const names = [...new Set(PAIRS.flat())];
            const colours = await coloursOf(
              page,
              names.map((name) => `var(--${name})`),
            );
            const linear = (/** @type {string} */ name) =>
              colours[names.indexOf(name)]
                .map((byte) => byte / 255)
                .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
            for (const [mark, ground] of PAIRS) {
              const [dark, light] = [mark, ground]
                .map((name) => linear(name).reduce((sum, part, i) => sum + [0.2126, 0.7152, 0.0722][i] * part, 0))
                .sort((x, y) => x - y);
              const ratio = (light + 0.05) / (dark + 0.05);
              assert.ok(
                ratio >= (/^(ink|quiet|collision)/.test(mark) ? 4.5 : mark === "obstacle" ? least : 3),
                `${mark} on ${ground}, ${colorScheme}: ${ratio.toFixed(2)}`,
              );
            }
            for (const [eyes, rows] of Object.entries(SEEN)) {
              const seen = (/** @type {string} */ name) =>
                rows.map((row) =>
                  Math.cbrt(
                    Math.max(
                      0,
                      row.reduce((sum, weight, i) => sum + weight * linear(name)[i], 0),
                    ),
                  ),
                );
              for (const [a, b] of [
                ["start", "goal"],
                ["path", "growth"],
                ["path", "start"],
                ["collision", "start"],
              ]) {
                const apart = Math.hypot(...seen(a).map((value, i) => value - seen(b)[i]));
                assert.ok(apart > 0.1, `${a} and ${b} for ${eyes} eyes, ${colorScheme}: ${apart.toFixed(3)}`);
              }
            }
          }
        },

        "forced colours are honoured: the stage is drawn in them, and what is chosen shows": async (page) => {
          await page.emulateMedia({ forcedColors: "active" });
          await finish(page);
          await assertForced(page);
          assert.ok((await pixelsOf(page, "workspace", "top", "path")) > 100);
          const border = await page
            .locator(".card:has(input:checked)")
            .evaluate((card) => getComputedStyle(card).borderTopWidth);
          assert.equal(border, "2px");
        },

        "a generated scene, with a link to be copied by hand: axe finds nothing, and nothing hangs over": async (
          page,
        ) => {
          await page.evaluate(() => {
            Object.defineProperty(navigator, "clipboard", {
              get() {
                throw new Error("closed");
              },
            });
          });
          await chooseScene(page, "maze");
          await click(page, "#step-10");
          await page.click("#link");
          await page.locator("#link-told input").waitFor();
          await assertFaultless(page, "a link to be copied");
        },
      },
      restage,
    ),
  ));

/** The luminance of a colour of bytes. @param {number[]} bytes */
const luminance = (bytes) =>
  bytes
    .map((byte) => byte / 255)
    .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
    .reduce((sum, part, i) => sum + [0.2126, 0.7152, 0.0722][i] * part, 0);

test("few controls are in view at first; More stays open, and opens for a link that sets something in it", () =>
  onPausedPage(
    async (page, url) => {
      const few = ["scenes", "open", "planner", "play", "parameter-k", "parameter-seed", "new-seed"];
      for (const id of few) assert.equal(await page.isVisible(`#${id}`), true, id);
      const rest = [
        "preset",
        "parameter-samples",
        "parameter-edge_check",
        "make-fold",
        "pose",
        "race-fold",
        "view-fold",
      ];
      for (const id of rest) assert.equal(await page.isVisible(`#${id}`), false, id);
      // What a report did wrong is a preset only where it is set.
      assert.ok((await offered(page, "preset")).includes("thirty-nearest"));
      assert.ok(!(await offered(page, "preset")).includes("unchecked-1000-4"));
      await page.click("#more > summary");
      await setParameter(page, "samples", "1000");
      await setParameter(page, "k", "4");
      await setParameter(page, "edge_check", "none");
      await page.locator("#parameter-direct").evaluate((input) => /** @type {HTMLElement} */ (input).click());
      await atRest(page);
      const link = await linkOf(page);
      await page.reload();
      await atRest(page);
      assert.equal(await page.isVisible("#preset"), true);
      await page.click("#more > summary");
      await page.goto("about:blank");
      await page.goto(addressOf(url, link));
      await atRest(page);
      assert.equal(await page.isVisible("#preset"), true);
      assert.equal(await page.inputValue("#preset"), "unchecked-1000-4");
    },
    {},
    { isFolded: true },
  ));

for (const deviceScaleFactor of isDeep ? [1, 3] : [3]) {
  test(`canvases are as sharp as the screen, with ${deviceScaleFactor} device pixels to a CSS pixel`, () =>
    onPausedPage(
      async (page) => {
        // A canvas is fitted when something is drawn on it; in a solved run every one has something.
        await finish(page);
        await page.waitForFunction(() => {
          const canvases = /** @type {HTMLCanvasElement[]} */ ([...document.querySelectorAll("canvas[data-layer]")]);
          return (
            canvases.length === 10 &&
            canvases.every((canvas) => {
              const { width, height } = canvas.getBoundingClientRect();
              return (
                Math.abs(canvas.width - width * devicePixelRatio) <= 1 &&
                Math.abs(canvas.height - height * devicePixelRatio) <= 1
              );
            })
          );
        });
      },
      { deviceScaleFactor, viewport: { width: 1000, height: 800 } },
    ));
}
