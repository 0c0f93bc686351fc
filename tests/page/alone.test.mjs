/** The page on its own: without a network, as one file, inside another page, and after its core was lost. */
import assert from "node:assert/strict";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import {
  TRAP,
  addressOf,
  atRest,
  choose,
  chooseScene,
  click,
  finish,
  isDeep,
  onPage,
  onPausedPage,
  root,
  thumbnails,
  useBrowser,
  worker,
} from "./browser.mjs";
import { ALIKE, open, ran, sceneOf } from "./library.mjs";
import { DONE, SMALL } from "./pages.mjs";
import { encodeExperiment } from "../../www/experiments/link.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";

useBrowser();

const oneFile = join(root, "dist", "planarium.html");
const experimentsFile = join(root, "dist", "planarium-experiments.html");

test("without a network a scene of each kind can be shown and planned, once the page is open", () =>
  onPausedPage(
    async (page) => {
      // The last thumbnail is drawn once all scenes are there.
      await thumbnails(page);
      // What some of them need is fetched a little later: the page's clock goes faster.
      await page.clock.fastForward(60_000);
      await page.waitForSelector("body[data-complete=true]");
      await page.context().setOffline(true);
      for (const { id } of SCENES) {
        if (!isDeep && ALIKE.includes(id)) continue;
        await chooseScene(page, id);
        assert.equal((await click(page, "#step-10")).iterations, 10, id);
      }
    },
    {},
    {
      before: async (page) => {
        await page.clock.install();
      },
    },
  ));

for (const [file, most] of /** @type {[string, number][]} */ ([
  [oneFile, 1374],
  [experimentsFile, 1794],
]))
  test(`${basename(file)} has at most ${most} KB and asks for nothing`, () => {
    assert.ok(statSync(file).size <= most * 1024, `${statSync(file).size}`);
    const html = readFileSync(file, "utf8");
    assert.match(html, /default-src 'none'/);
    assert.doesNotMatch(html, /<(script|link|img)[^>]*(src|href)="(?!data:)/);
    assert.match(html, /uqr \d[\d.]* \(MIT\), https:/);
  });

test("the page of experiments in one file opens from the disk, runs, and links to the planner's file", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page, url) => {
      /** @type {string[]} */
      const requests = [];
      page.on("request", (request) => requests.push(request.url()));
      const fragment = await encodeExperiment({ document: SMALL, run: true });
      await page.goto(pathToFileURL(experimentsFile).href + `#${fragment}`);
      await page.waitForSelector(`${DONE}[data-drawn='8']`);
      const there = await page.evaluate(() => ({ ...document.body.dataset }));
      await page.waitForSelector("#trials tbody a[href]");
      const trial = (await page.getAttribute("#trials tbody a", "href")) ?? "";
      assert.match(trial, /^planarium\.html#1/);
      // One whose worlds are files of the site.
      await page.selectOption("#ready", "arm-planners");
      await page.waitForSelector("body[data-phase=ready]:not([data-count='8'])");
      await page.goto(new URL(trial, page.url()).href);
      await page.waitForSelector("#counters[data-settled=true][data-status=solved]", { state: "attached" });
      assert.ok(
        requests.every((url) => /^(file|data|blob):/.test(url)),
        requests.join(" "),
      );
      await page.goto(addressOf(url, `experiments.html#${fragment}`));
      await page.waitForSelector(`${DONE}[data-drawn='8']`);
      assert.deepEqual(await page.evaluate(() => ({ ...document.body.dataset })), there);
    },
    { path: "icon.svg", expectErrors: true },
  ));

test("the page in one file runs from the disk and in a sandboxed frame, and plans the same bits as the package", () => {
  const { algorithm, settings } = sceneOf("stones");
  const { fingerprint } = ran(open(sceneOf("stones")), algorithm, settings).result;
  return onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      for (const where of ["disk", "frame"]) {
        /** @type {string[]} */
        const requests = [];
        page.on("request", (request) => requests.push(request.url()));
        let frame = page.mainFrame();
        if (where === "disk") {
          await page.goto(pathToFileURL(oneFile).href);
        } else {
          const outer = join(root, "dist", "one-file", "outer.html");
          writeFileSync(
            outer,
            `<!doctype html><title>outer</title><iframe sandbox="allow-scripts" src="../planarium.html" style="width: 1000px; height: 800px"></iframe>`,
          );
          await page.goto(pathToFileURL(outer).href);
          frame = (await (await page.waitForSelector("iframe")).contentFrame()) ?? frame;
        }
        await frame.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
        await frame.click("#finish");
        await frame.waitForSelector("#counters[data-settled=true][data-status=solved]", { state: "attached" });
        assert.equal(await frame.getAttribute("#counters", "data-fingerprint"), fingerprint);
        await choose(frame, "scene", "rings");
        await frame.waitForSelector("body[data-scene=rings]");
        await frame.setInputFiles("#file", {
          name: "map.yaml",
          mimeType: "text/yaml",
          buffer: Buffer.from("image: map.pgm"),
        });
        await frame.waitForSelector("#notice[data-code=unsupported]");
        await frame.evaluate(() => document.getElementById("notice")?.replaceChildren());
        await frame.setInputFiles("#file", {
          name: "path.csv",
          mimeType: "text/csv",
          buffer: Buffer.from("x,y\n0,0\n1,1\n"),
        });
        await frame.waitForFunction(() =>
          /maps, pictures, drawings and paths/.test(document.getElementById("notice")?.innerText ?? ""),
        );
        await frame.locator("#timing-fold > summary").click();
        await frame.waitForFunction(() =>
          /does not time paths/.test(document.getElementById("timing")?.innerText ?? ""),
        );
        assert.ok(
          requests.every((url) => /^(file|data|blob):/.test(url)),
          requests.join(" "),
        );
      }
    },
    { path: "icon.svg", expectErrors: true },
  );
});

/** A parent page that stores all messages from the frame. @param {string} url */
const parent = (url) => `<!doctype html><title>Parent</title><button id="before">before</button>
  <iframe id="frame" src="${addressOf(url, "?embed=1")}" style="width: 640px; height: 420px; border: 0"></iframe>
  <script>
    const told = [];
    const answers = new Map();
    addEventListener("message", ({ data }) => {
      told.push(data);
      if (data.planarium === "answer") answers.get(data.id)?.(data);
    });
    let count = 0;
    function order(message) {
      return new Promise((resolve) => {
        const id = count++;
        answers.set(id, resolve);
        frame.contentWindow.postMessage({ ...message, id }, "*");
      });
    }
  </script>`;

test("embedded it shows the stage only, takes no focus and obeys orders", () =>
  onPage({ reducedMotion: "reduce" }, async (page, url) => {
    await page.route("**/parent.html", (route) => route.fulfill({ contentType: "text/html", body: parent(url) }));
    await page.goto(`${url}parent.html`);
    await page.waitForFunction("told.some(({ planarium }) => planarium === 'state')");
    const frame = page.frames()[1];
    for (const hidden of [".masthead", ".panel", ".legend"])
      assert.equal(await frame.locator(hidden).isVisible(), false, hidden);
    assert.equal(await frame.locator("#transport").isVisible(), true);
    assert.equal(await page.evaluate(() => document.activeElement?.tagName), "BODY", "the focus stays where it was");
    const over = await frame.evaluate(() => [
      document.documentElement.scrollWidth - innerWidth,
      document.documentElement.scrollHeight - innerHeight,
    ]);
    assert.deepEqual(
      over.map((pixels) => Math.max(0, pixels)),
      [0, 0],
      "nothing hangs over",
    );
    const order = (/** @type {object} */ message) =>
      page.evaluate((sent) => /** @type {any} */ (window).order(sent), message);
    const ask = async () => {
      await frame.waitForSelector("#counters[data-settled=true]", { state: "attached" });
      return (await order({ planarium: "state" })).value;
    };
    const loaded = await order({
      planarium: "load",
      scene: "firs",
      algorithm: "rrt",
      settings: { seed: 5, step: 0.35 },
      iteration: 40,
    });
    assert.ok(!loaded.fault, JSON.stringify(loaded));
    assert.deepEqual(
      [loaded.value.settled, loaded.value.iteration, loaded.value.lanes[0].algorithm, loaded.value.lanes[0].iteration],
      [true, 40, "rrt", 40],
    );
    assert.equal((await ask()).iteration, 40);
    // The answer tells of the run that was loaded, not of the one before, whether it rests or plays.
    const again = (await order({ planarium: "load", scene: "rings", iteration: 7 })).value;
    assert.deepEqual([again.iteration, again.lanes[0].algorithm, again.lanes[0].unit], [7, "prm", "m"]);
    const playing = (await order({ planarium: "load", scene: "stones", algorithm: "rrt-connect", play: true })).value;
    assert.deepEqual(
      [playing.playing, playing.lanes[0].algorithm, playing.lanes[0].unit],
      [true, "rrt-connect", "rad"],
    );
    await order({
      planarium: "load",
      scene: "firs",
      algorithm: "rrt",
      settings: { seed: 5, step: 0.35 },
      iteration: 40,
    });
    for (const [message, iteration] of /** @type {[object, number][]} */ ([
      [{ planarium: "step", count: 10 }, 50],
      [{ planarium: "step", count: -3 }, 47],
      [{ planarium: "seek", iteration: 12 }, 12],
    ])) {
      await order(message);
      assert.equal((await ask()).iteration, iteration);
    }
    const { lanes, sentence } = await ask();
    assert.deepEqual([lanes[0].iteration, lanes[0].algorithm], [12, "rrt"]);
    assert.ok(sentence.length > 10);
    await order({ planarium: "play" });
    await page.waitForFunction("told.at(-1).state?.playing && told.at(-1).state.iteration > 20");
    await order({ planarium: "pause" });
    assert.equal((await ask()).playing, false);
    for (const [message, code, pointer] of /** @type {[object, string, string][]} */ ([
      [{ planarium: "load", scene: "nowhere" }, "unknown-scene", "/scene"],
      [{ planarium: "load", document: { format: "planarium-scenario-1" } }, "missing-field", "/name"],
      [{ planarium: "seek", iteration: "soon" }, "wrong-type", "/iteration"],
      [{ planarium: "dance" }, "unknown-order", "/planarium"],
      [{ planarium: "toString" }, "unknown-order", "/planarium"],
      [{ planarium: "load", scene: "firs", algorithm: "rtr" }, "unknown-planner", "/algorithm"],
      [{ planarium: "load", scene: "firs", algorithm: 7 }, "wrong-type", "/algorithm"],
      [
        { planarium: "load", scene: "firs", algorithm: "rrt", settings: { setp: 1 } },
        "unknown-parameter",
        "/settings/setp",
      ],
      [{ planarium: "load", scene: "firs", algorithm: "rrt", settings: [1] }, "wrong-type", "/settings"],
      [{ planarium: "load", scene: "firs", query: "nowhere" }, "unknown-query", "/query"],
      [{ planarium: "load", scene: "firs", iteration: -1 }, "out-of-range", "/iteration"],
      [{ planarium: "load", scene: "firs", play: 1 }, "wrong-type", "/play"],
      [{ planarium: "load", scene: "firs", seting: {} }, "unknown-field", "/seting"],
      [{ planarium: "load", scene: "firs", document: {} }, "duplicate-field", "/document"],
      [{ planarium: "load" }, "unknown-scene", "/scene"],
      [{ planarium: "load", document: "{}" }, "wrong-type", "/document"],
      [{ planarium: "seek" }, "missing-field", "/iteration"],
      [{ planarium: "step", count: 0.5 }, "wrong-type", "/count"],
    ])) {
      const { fault } = await order(message);
      assert.deepEqual([fault?.code, fault?.pointer], [code, pointer], JSON.stringify(fault));
    }
    assert.deepEqual(
      (({ iteration, lanes: [{ algorithm }] }) => [algorithm, iteration > 12])(await ask()),
      ["rrt", true],
      "what was open is open",
    );
    // What only the core can refuse has left the open scene.
    for (const [message, code, pointer] of /** @type {[object, string, string][]} */ ([
      [
        { planarium: "load", scene: "firs", algorithm: "rrt", settings: { step: -1 } },
        "out-of-range",
        "/settings/step",
      ],
      [{ planarium: "load", scene: "firs", algorithm: "sst" }, "unsupported", "/algorithm"],
      [{ planarium: "play" }, "unsupported", "/algorithm"],
      [{ planarium: "seek", iteration: 3 }, "unsupported", "/algorithm"],
    ])) {
      const { fault } = await order(message);
      assert.deepEqual([fault?.code, fault?.pointer], [code, pointer], JSON.stringify(fault));
    }
    assert.equal((await ask()).refusal.code, "unsupported");
    const settled = (await order({ planarium: "load", scene: "rings", settings: { seed: 9 }, iteration: 5 })).value;
    assert.deepEqual(
      [settled.lanes[0].algorithm, settled.iteration, settled.refusal],
      ["prm", 5, null],
      "settings alone are those of the scene's planner",
    );
    // Both are sent at once: the second arrives before the first can have been answered.
    const [first, second] = await page.evaluate(() =>
      Promise.all(
        [{ scene: "firs" }, { scene: "rings", iteration: 3 }].map((message) =>
          /** @type {any} */ (window).order({ planarium: "load", ...message }),
        ),
      ),
    );
    assert.deepEqual([first.fault?.code, second.value?.iteration], ["superseded", 3]);
    await frame.focus("#stage");
    await page.keyboard.press("Escape");
    await page.waitForFunction("told.some(({ planarium }) => planarium === 'escape')");
    assert.equal(await frame.evaluate(() => document.activeElement?.tagName), "BODY");
  }));

test("a page that is not a parent is not obeyed", () =>
  onPausedPage(async (page) => {
    await page.evaluate(
      () =>
        new Promise((resolve) => {
          addEventListener("message", () => setTimeout(resolve));
          window.postMessage({ planarium: "step", count: 10 }, "*");
        }),
    );
    assert.equal((await click(page, "#step-1")).iterations, 1);
  }));

/** Puts the trap into the page and its worker. @param {import("playwright-core").Page} page */
const wire = async (page) =>
  void (await page.route(/\/(main|worker)\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: TRAP + (await response.text()) });
  }));

test("a trap while it plans, draws or is asked is said, and the page stays usable", () =>
  onPausedPage(
    async (page) => {
      for (const [call, button, place] of /** @type {const} */ ([
        ["planner_step", "#step-100", "worker"],
        ["scenario_endEffectors", "#step-100", "page"],
        ["scenario_check", "#your-turn", "page"],
        ["scenario_extent", "#theme", "worker"],
      ])) {
        await page.click("#reset");
        await click(page, "#step-10");
        const set = (/** @type {string} */ name) => {
          /** @type {any} */ (self).trap = name;
        };
        await (place === "page" ? page.evaluate(set, call) : worker(page).evaluate(set, call));
        await page.click(button);
        await page.waitForSelector("#notice[data-code=internal]");
        assert.match(await page.innerText("#notice"), /internal error/);
        await atRest(page);
        await page.click("#notice button");
        assert.equal((await finish(page)).status, "solved", call);
      }
      await chooseScene(page, "firs");
      assert.equal((await finish(page)).status, "solved");
    },
    {},
    { before: wire },
  ));
