/** The page for everyone: axe in every state, keyboard and touch, widths from 320 to 2560, forced colours, less motion, a projector. */
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { PHONE, atRest, chooseScene, finish, onPage, onPausedPage, pixelsOf, start, stop, unfold, violations } from "./browser.mjs";
import { assertFaultless, assertFits, assertForced, assertTargets } from "./looks.mjs";

/** @import { Page } from "playwright-core" */

before(start);
after(stop);

/** How the page comes into each state. @type {Record<string, (page: Page) => Promise<unknown>>} */
const STATES = {
  "solved, all numbers and parameters open": async (page) => {
    await finish(page);
    await page.click("#more summary");
    await unfold(page, "view");
    await unfold(page, "curves");
  },
  "a race": async (page) => {
    await unfold(page, "race");
    await page.click("#add-rival");
    await page.waitForSelector("#lane-B");
    await finish(page);
    await page.click(".rival summary");
  },
  "the editor, with something selected": async (page) => {
    await page.click("#edit");
    await page.waitForSelector("#edit-tools");
    await page.focus("#stage");
    await page.keyboard.press("]");
    await atRest(page);
  },
  "a lesson": async (page) => {
    await unfold(page, "lessons");
    await page.click("#lessons button");
    await page.waitForSelector("#lesson:not([hidden])");
    await atRest(page);
  },
  "take away": (page) => unfold(page, "take"),
  "the robot in the hand, in collision": async (page) => {
    await page.click("#your-turn");
    await page.locator("#pose-0-number").fill("0.7");
    await page.locator("#pose-0-number").blur();
    await page.locator("#pose-1-number").fill("0");
    await page.locator("#pose-1-number").blur();
    await page.waitForSelector("#touching[data-free=false]");
  },
  "bad news": async (page) => {
    await page.setInputFiles("#file", { name: "mine.json", mimeType: "application/json", buffer: Buffer.from("{") });
    await page.waitForSelector("#notice[data-code=invalid-json]");
  },
};

describe("every state", () => {
  for (const [state, enter] of Object.entries(STATES)) {
    test(`${state}: axe finds nothing, and nothing hangs over`, async () => {
      await onPausedPage(async (page) => {
        await enter(page);
        await assertFaultless(page, state);
        if (/race|editor/.test(state)) await assertFits(page, state, 120);
      });
    });
  }

  test("inside another page, and on a projector", async () => {
    await onPausedPage(async (page, url) => {
      await page.click("#projector");
      assert.deepEqual(await violations(page), []);
      await page.goto(`${url}?embed=1`);
      await page.waitForSelector("#counters[data-settled=true]", { state: "attached" });
      // The heading is the parent's to give.
      assert.deepEqual((await violations(page)).filter((found) => !/^page-has-heading-one/.test(found)), []);
    });
  });

  test("every control is at least 24 pixels high and wide, those of the transport 44 where a finger uses them", async () => {
    await onPausedPage(async (page) => {
      for (const id of ["race", "view", "lessons", "take"]) await unfold(page, id);
      await page.click("#more summary");
      await assertTargets(page);
      const transport = await page.locator("#transport button").evaluateAll((buttons) => buttons.map((button) => button.getBoundingClientRect().height));
      assert.ok(transport.every((height) => height >= 44), `${transport}`);
    }, PHONE);
  });
});

describe("colours", () => {
  test("forced colours are honoured: the stage is drawn in them, and what is chosen shows", async () => {
    await onPausedPage(async (page) => {
      await finish(page);
      await assertForced(page);
      assert.ok(await pixelsOf(page, "workspace", "top", "path") > 100);
      const border = await page.locator(".card:has(input:checked)").evaluate((card) => getComputedStyle(card).borderTopWidth);
      assert.equal(border, "2px");
    }, { forcedColors: "active" });
  });

  test("text and marks stand out of their ground, and what means different things stays apart for eyes that see fewer", async () => {
    // Viénot, Brettel, Mollon 1999, "Digital video colourmaps for checking the legibility of displays by dichromats": linear RGB.
    const SEEN = {
      protan: [[0.11238, 0.88762, 0], [0.11238, 0.88762, 0], [0.00401, -0.00401, 1]],
      deutan: [[0.29275, 0.70725, 0], [0.29275, 0.70725, 0], [-0.02234, 0.02234, 1]],
    };
    const PAIRS = [
      ["ink", "page"], ["quiet", "page"], ["quiet", "stage"], ["collision", "page"],
      ["obstacle-edge", "stage"], ["robot", "stage"], ["start", "stage"], ["goal", "stage"], ["growth", "stage"],
      ["newest", "stage"], ["path", "stage"], ["unproven", "stage"], ["rejected", "stage"], ["collision", "stage"], ["control", "page"],
    ];
    await onPausedPage(async (page) => {
      for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
        await page.emulateMedia({ colorScheme });
        const colours = await page.evaluate((names) => Object.fromEntries(names.map((name) => {
          const probe = document.createElement("span");
          probe.style.color = `var(--${name})`;
          document.body.append(probe);
          return [name, (getComputedStyle(probe).color.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number)];
        })), [...new Set(PAIRS.flat())]);
        const linear = (/** @type {string} */ name) => colours[name].map((byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4));
        for (const [mark, ground] of PAIRS) {
          const [dark, light] = [mark, ground].map((name) => linear(name).reduce((sum, part, i) => sum + [0.2126, 0.7152, 0.0722][i] * part, 0)).sort((x, y) => x - y);
          const ratio = (light + 0.05) / (dark + 0.05);
          assert.ok(ratio >= (/^(ink|quiet|collision)/.test(mark) ? 4.5 : 3), `${mark} on ${ground}, ${colorScheme}: ${ratio.toFixed(2)}`);
        }
        for (const [eyes, rows] of Object.entries(SEEN)) {
          const seen = (/** @type {string} */ name) => rows.map((row) => Math.cbrt(Math.max(0, row.reduce((sum, weight, i) => sum + weight * linear(name)[i], 0))));
          for (const [a, b] of [["start", "goal"], ["path", "growth"], ["path", "start"], ["collision", "start"]]) {
            const apart = Math.hypot(...seen(a).map((value, i) => value - seen(b)[i]));
            assert.ok(apart > 0.1, `${a} and ${b} for ${eyes} eyes, ${colorScheme}: ${apart.toFixed(3)}`);
          }
        }
      }
    });
  });
});

describe("without a pointer", () => {
  test("a scene is chosen, planned, gone back in and raced by keys alone", async () => {
    await onPausedPage(async (page) => {
      await page.focus("input[name=scene]:checked");
      await page.keyboard.press("ArrowRight");
      await page.waitForFunction(() => document.body.dataset.scene !== "stones");
      await atRest(page);
      await page.focus("#timeline");
      await page.keyboard.press(".");
      await page.keyboard.press(".");
      assert.equal((await atRest(page)).iterations, 2);
      await page.keyboard.press(",");
      assert.equal((await atRest(page)).iterations, 1);
      await page.focus("#race-fold > summary");
      await page.keyboard.press("Enter");
      await page.waitForSelector("#add-rival");
      await page.focus("#add-rival");
      await page.keyboard.press("Enter");
      await page.waitForSelector(".rival");
      await page.focus("#stage");
      await page.keyboard.press("e");
      await page.waitForSelector("#counters[data-settled=true][data-status=solved]", { state: "attached" });
    });
  });

  test("a finger drags the robot, and the page scrolls beneath one that does not", async () => {
    await onPausedPage(async (page) => {
      await page.click("#your-turn");
      const before = await page.inputValue("#pose-0-number");
      const canvas = page.locator("#workspace canvas[data-layer=top]");
      await canvas.scrollIntoViewIfNeeded();
      await canvas.evaluate((element) => {
        const { left, top, width, height } = element.getBoundingClientRect();
        const at = (/** @type {string} */ type, /** @type {number} */ x, /** @type {number} */ y) => element.dispatchEvent(new PointerEvent(type, {
          pointerId: 7, pointerType: "touch", isPrimary: true, button: 0, bubbles: true, clientX: left + x, clientY: top + y,
        }));
        Object.assign(element, { setPointerCapture() {} });
        at("pointerdown", width / 2 + 40, height / 2);
        at("pointermove", width / 2 + 30, height / 2 - 40);
        at("pointerup", width / 2 + 30, height / 2 - 40);
      });
      await page.waitForFunction((value) => /** @type {HTMLInputElement} */ (document.getElementById("pose-0-number")).value !== value, before);
      assert.equal(await canvas.evaluate((element) => getComputedStyle(element).touchAction), "none", "while it is in the hand");
      await page.click("#your-turn");
      await page.waitForFunction(() => !document.getElementById("stage")?.classList.contains("in-hand"));
      assert.match(await canvas.evaluate((element) => getComputedStyle(element).touchAction), /pan-y/);
      assert.doesNotMatch(await page.locator("meta[name=viewport]").getAttribute("content") ?? "", /user-scalable|maximum-scale/);
    }, PHONE);
  });
});

describe("less motion", () => {
  test("nothing plays by itself, nothing glows, and a path is there at once", async () => {
    await onPausedPage(async (page) => {
      await page.click("#step-100");
      await atRest(page);
      assert.equal(await pixelsOf(page, "workspace", "top", "halo"), 0);
      await finish(page);
      assert.equal(await page.getAttribute("#play", "data-playing"), "false");
      assert.ok(await pixelsOf(page, "workspace", "top", "path") > 100);
    });
  });
});

test("on a projector words are larger and lines bolder; Escape leaves", async () => {
  await onPage({ reducedMotion: "reduce" }, async (page) => {
    await page.waitForSelector("#counters[data-settled=true]", { state: "attached" });
    await chooseScene(page, "firs");
    await finish(page);
    const ink = async () => (await pixelsOf(page, "workspace", "top", "path")) / (await page.locator("#workspace canvas[data-layer=top]").evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).width));
    const [size, thin] = [await page.evaluate(() => parseFloat(getComputedStyle(document.body).fontSize)), await ink()];
    await page.click("#projector");
    await atRest(page);
    assert.equal(await page.locator(".panel").isVisible(), false);
    assert.ok(await page.evaluate(() => parseFloat(getComputedStyle(document.body).fontSize)) > 1.3 * size);
    assert.ok(await ink() > 1.25 * thin, `${await ink()} after ${thin}`);
    await page.keyboard.press("Escape");
    assert.equal(await page.locator(".panel").isVisible(), true);
  });
});
