/** The start page: it is light, its picture grows by a run of the planner, and old links open the planner's page. */
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Scenario } from "planarium";
import { printedCode } from "./printed.mjs";
import { classPlan } from "../../scripts/front.mjs";
import { codeWarning } from "../../www/app/qr-code.js";
import { encodeLink } from "../../www/planner/link/codec.js";
import { beginRun, bestPath } from "../../www/start/growth.js";
import { RUN } from "../../www/start/run.js";
import { DESK, isDeep, onPage, pageRoot, useBrowser, violations } from "./browser.mjs";

useBrowser();

const START = { path: "index.html" };
const CALM = /** @type {const} */ ({ ...DESK, reducedMotion: "reduce" });

test("its script has at most 60 KB, and asks for the core only after the first paint", () =>
  onPage(
    DESK,
    async (page) => {
      await page.waitForSelector("#grown[data-state=running], #grown[data-state=solved]");
      const { painted, core } = await page.evaluate(() => ({
        painted: performance.getEntriesByName("first-contentful-paint")[0].startTime,
        core: performance.getEntriesByType("resource").find(({ name }) => name.endsWith(".wasm"))?.startTime ?? NaN,
      }));
      assert.ok(core > painted, `${core} after ${painted}`);
      const html = readFileSync(join(pageRoot, "index.html"), "utf8");
      assert.doesNotMatch(html, /<link[^>]*planarium\//);
      const scripts = Array.from(html.matchAll(/<script[^>]*src="([^"]+)"/g), ([, path]) => path);
      assert.deepEqual(scripts, ["start/forward.js", "start/main.js"]);
      const bytes = scripts.reduce((sum, path) => sum + statSync(join(pageRoot, path)).size, 0);
      assert.ok(bytes <= 60 * 1024, `${bytes}`);
    },
    START,
  ));

test("its picture is the end of a run of the planner, which grows again and opens on the planner's page", () => {
  const { planner } = beginRun({ Scenario });
  /** Paths found on the way. @type {number[][][]} */
  const paths = [];
  while (planner.step(100) === "running") paths.push(bestPath(planner));
  const { iterations } = planner;
  const { fingerprint, path, length } = planner.result();
  assert.deepEqual(bestPath(planner), path);
  assert.ok(
    paths[0].length === 0 && new Set(paths.map((one) => JSON.stringify(one))).size > 4,
    "the path gets shorter",
  );
  return onPage(
    CALM,
    async (page, url) => {
      await page.waitForSelector("#grow:enabled");
      assert.equal(await page.getAttribute("#grown", "data-state"), "picture");
      assert.equal(await page.isVisible("#grown img"), true);
      await page.click("#grow");
      await page.waitForSelector("#grown[data-state=running]");
      assert.equal(await page.isVisible("#grown img"), false);
      await page.click("#grow");
      await page.waitForSelector("#grown[data-state=paused]");
      const paused = Number(await page.getAttribute("#grown", "data-iterations"));
      assert.ok(paused > 0 && paused < iterations, `${paused}`);
      await page.click("#grow");
      await page.waitForSelector(`#grown[data-state=solved][data-iterations="${iterations}"]`);
      assert.equal(await page.innerText("#count"), `Iteration ${iterations}, a path of ${Number(length).toFixed(3)} m`);
      await page.click("text=Open this run");
      await page.waitForSelector(`#counters[data-settled=true][data-iterations="${iterations}"]`, {
        state: "attached",
      });
      assert.ok(page.url().startsWith(`${url}plan.html#1`));
      assert.equal(await page.getAttribute("#counters", "data-fingerprint"), fingerprint);
      assert.equal(await page.inputValue("#planner"), RUN.algorithm);
    },
    START,
  );
});

test("without its core it keeps the picture and says so", () =>
  onPage(
    DESK,
    async (page) => {
      await page.waitForSelector("#grown[data-state=failed]");
      assert.equal(await page.isVisible("#grown img"), true);
      assert.match(await page.innerText("#count"), /could not be loaded/);
    },
    {
      ...START,
      expectErrors: true,
      before: async (page) => void (await page.route(/\.wasm$/, (route) => route.abort())),
    },
  ));

test("links of the planner's page, made when it was index.html, open that page with the same fragment and query", async () => {
  const lanes = [{ algorithm: "rrt", settings: { seed: 3 } }];
  const link = `#${await encodeLink({ version: 1, view: {}, scene: "firs", lanes, iteration: 20 })}`;
  for (const path of [`index.html${link}`, `./${link}`, "index.html#lesson=neighbours.2", `index.html?embed=1${link}`])
    await onPage(
      CALM,
      async (page, url) => {
        await page.waitForSelector("#counters[data-settled=true]", { state: "attached" });
        assert.equal(page.url(), url + path.replace(/^(index\.html|\.\/)/, "plan.html"));
        assert.equal(await page.isHidden("#notice"), true);
        if (path.includes("embed")) assert.equal(await page.isVisible(".masthead"), false);
        if (!path.includes("lesson")) assert.equal(await page.getAttribute("#counters", "data-iterations"), "20");
      },
      { path },
    );
  // A link that is typed while the page is open, and a broken one.
  await onPage(
    CALM,
    async (page, url) => {
      await page.evaluate(() => void (location.hash = "#1broken"));
      await page.waitForSelector("#notice:not([hidden])");
      assert.equal(page.url(), `${url}plan.html#1broken`);
    },
    START,
  );
  await onPage(CALM, async (page, url) => assert.equal(page.url(), `${url}index.html#class`), {
    path: "index.html#class",
  });
});

test("it breaks no rule that axe checks, light and dark, and fits a phone", () =>
  onPage(
    CALM,
    async (page) => {
      for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
        await page.emulateMedia({ colorScheme });
        assert.deepEqual(await violations(page), [], colorScheme);
      }
      await page.setViewportSize({ width: 320, height: 640 });
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
    },
    START,
  ));

test("codes on paper are warned about where only this computer can open them", () => {
  const isWarned = (/** @type {string} */ address) => codeWarning(new URL(address)) !== "";
  const [here, elsewhere] = [
    ["file:///home/planarium.html", "http://localhost:8000/", "http://127.0.0.1/", "http://[::1]:80/class.html"],
    ["https://example.org/localhost/", "http://192.168.0.7:8000/", "https://localhost.example.org/"],
  ];
  assert.deepEqual([here.filter(isWarned), elsewhere.filter(isWarned)], [here, []]);
});

test("slides turn while a page is being loaded, whose document has no element yet", () =>
  onPage(
    CALM,
    async (page) => {
      await page.waitForSelector("body[data-settled=true]");
      await page.$eval("iframe:not(.past)", (frame) =>
        /** @type {HTMLIFrameElement} */ (frame).contentDocument?.documentElement.remove(),
      );
      for (const key of ["a", "End"]) await page.keyboard.press(key);
      await page.waitForSelector(`#deck[data-slide="${classPlan().length}"]`);
      await page.click("#theme");
      assert.equal(await page.isVisible(".slide:not([hidden]) h1"), true);
    },
    { path: "class.html" },
  ));

test("each slide of the class has its question, its answer on demand, and its page, which opens", () =>
  onPage(
    CALM,
    async (page, url) => {
      const count = await page.locator(".slide").count();
      assert.equal(count, classPlan().length);
      for (const [i, { page: address, question, answer }] of classPlan().entries()) {
        if (!isDeep && i > 1 && i < count - 1) continue;
        // To the last one by its address.
        if (!isDeep && i > 1) await page.evaluate((slide) => void (location.hash = `#${slide}`), count);
        await page.waitForSelector(`#deck[data-slide="${i + 1}"]`);
        assert.equal(await page.innerText("h1:visible"), question);
        assert.equal(await page.locator(".answer:visible").count(), 0);
        const frame = (await (await page.waitForSelector("iframe:not(.past)")).contentFrame()) ?? assert.fail();
        await frame.waitForSelector("body[data-settled=true]");
        assert.equal(frame.url(), url + address.replace("#", "?embed=1&projector=1#"));
        assert.equal(await frame.isHidden("#notice"), true, question);
        assert.equal(await frame.evaluate(() => document.documentElement.className), "embed projector");
        await page.keyboard.press("a");
        assert.equal(await page.innerText(".answer:visible"), answer);
        if (i === 1) assert.deepEqual(await violations(page), []);
        if (i < 2) assert.equal(await page.innerText("#guides"), "About PRM");
        await page.keyboard.press("ArrowRight");
      }
      assert.equal(await page.isDisabled("#next"), true);
      await page.keyboard.press("PageUp");
      await page.waitForSelector(`#deck[data-slide="${count - 1}"]`);
      assert.equal(new URL(page.url()).hash, `#${count - 1}`);
      // Space plays; a remote control also turns the slides after a click into the live page.
      // It may be pressed before the page can play.
      await page.keyboard.press(" ");
      const live = (await (await page.waitForSelector("iframe:not(.past)")).contentFrame()) ?? assert.fail();
      await live.waitForSelector("#counters:not([data-iterations='0'])", { state: "attached" });
      await live.click("#play");
      // So do the other keys that the page does not use.
      for (const isShown of [true, false]) {
        await page.keyboard.press("a");
        await page.waitForSelector(".slide:not([hidden]) .answer", { state: isShown ? "visible" : "hidden" });
        await live.waitForSelector(`html[data-quiet="${!isShown}"]`);
      }
      await page.keyboard.press("PageUp");
      await page.waitForSelector(`#deck[data-slide="${count - 2}"]`);
      // The keys belong to the slides again.
      await page.keyboard.press("a");
      assert.equal(await page.locator(".answer:visible").count(), 1);
      // Back at a slide its run is as it was left; each page that stays has a core, so there are few.
      await live.waitForSelector("#play:enabled");
      const left = await live.getAttribute("#counters", "data-iterations");
      await page.keyboard.press("PageDown");
      assert.equal(await (await page.waitForSelector("iframe:not(.past)")).contentFrame(), live);
      assert.equal(await live.getAttribute("#counters", "data-iterations"), left);
      assert.equal(await page.locator("iframe").count(), 4);
      await page.click("#previous");
      // A link in an answer replaces the page of the slide, and returns to it as it was left.
      const linked = classPlan().findIndex((row) => row.linked !== row.answer);
      await page.evaluate((slide) => void (location.hash = `#${slide}`), linked + 1);
      await page.waitForSelector(`#deck[data-slide="${linked + 1}"]`);
      const shown = async () => await (await page.waitForSelector("iframe:not(.past)")).contentFrame();
      const first = (await shown()) ?? assert.fail();
      await page.keyboard.press("a");
      const link = page.locator(".answer:visible a").first();
      await link.click();
      const second = (await shown()) ?? assert.fail();
      await second.waitForSelector("body[data-phase=ready], body[data-phase=done]");
      assert.equal(second.url(), url + (await link.getAttribute("href"))?.replace("#", "?embed=1&projector=1#"));
      assert.equal(await link.getAttribute("aria-current"), "page");
      await link.click();
      assert.equal(await shown(), first);
      assert.equal(await link.getAttribute("aria-current"), null);
      await page.emulateMedia({ media: "print" });
      await page.waitForSelector("#answers li");
      assert.match(await page.innerText("#deck .warning"), /do not work on a phone/);
      assert.equal(await page.locator(".answer:visible").count(), 0);
      assert.deepEqual(
        await page.locator("#answers li").allInnerTexts(),
        classPlan().map(({ answer }) => answer),
      );
      for (const [i, { page: address }] of classPlan().entries())
        if (isDeep || i === 1 || i === count - 1)
          assert.equal(await printedCode(page, page.locator(".slide svg").nth(i)), url + address);
      await page.emulateMedia({ media: "screen" });
      assert.equal(await page.locator(".slide svg:visible, #answers:visible").count(), 0);
      for (const [key, slide] of /** @type {const} */ ([
        ["Home", 1],
        ["End", count],
      ])) {
        await page.keyboard.press(key);
        await page.waitForSelector(`#deck[data-slide="${slide}"]`);
      }
    },
    { path: "class.html" },
  ));
