/** The page in a real browser: it opens, grows, obeys and refuses. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { planners } from "planarium";
import {
  PHONE,
  alphaOf,
  atRest,
  choosePlanner,
  chooseScene,
  click,
  counters,
  dropFile,
  finish,
  frames,
  growthHash,
  isDeep,
  onPage,
  onPausedPage,
  passes,
  pickFile,
  pixelsOf,
  reveal,
  setParameter,
  thumbnails,
  useBrowser,
  valueWithin,
} from "./browser.mjs";
import { overhang } from "./looks.mjs";
import { open, ran, sceneOf, textOf } from "./library.mjs";
import { encodeLink } from "../../www/planner/link/codec.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";

/**
 * Scenes that differ from others in their world alone: all end in scenes.test.mjs, and here where all cases are tried.
 */
const ALIKE = ["open", "slot", "trap", "maze", "shelf", "tentacle", "corner", "turn", "lanes"];

useBrowser();

test("a printed page has scene, settings and iteration, no buttons, and panes side by side", () =>
  onPausedPage(async (page) => {
    const { iterations } = await finish(page);
    await page.waitForSelector("body[data-complete=true]");
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      await page.emulateMedia({ media: "screen", colorScheme });
      assert.equal(await page.isVisible("#printed"), false);
      await page.pdf();
      await page.emulateMedia({ media: "print" });
      await page.setViewportSize({ width: 794, height: 1123 });
      assert.equal(
        await page.innerText("#printed"),
        `Two links among stones \u00b7 PRM, k 9, samples 260, sampler uniform, seed 0 \u00b7 iteration ${iterations}`,
      );
      for (const button of await page.locator("button, input, select").all())
        assert.equal(await button.isVisible(), false);
      const sheets = await page
        .locator(".sheet, .sheet canvas")
        .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
      const [left, right] = [0, sheets.length / 2].map((first) => sheets.slice(first, first + sheets.length / 2));
      assert.ok(Math.max(...left.map((box) => box.right)) <= Math.min(...right.map((box) => box.left)));
      assert.ok(sheets.every(({ width, height }) => width > 300 && Math.abs(width - height) < 1));
    }
    assert.equal(await page.locator("#printed-link svg").count(), 1);
    // A link that is too long for a code.
    await pickFile(page, "rings.json", textOf("rings"));
    await page.waitForSelector("body[data-scene=file]");
    await page.waitForFunction(() =>
      /has [2-9],\d{3} characters, too many/.test(document.getElementById("printed-link")?.textContent ?? ""),
    );
    assert.equal(await page.locator("#printed-link svg").count(), 0);
    await page.emulateMedia({ media: "screen" });
  }));

test("on a phone the transport is low but can be reached, and the rest is folded away", () =>
  onPausedPage(async (page) => {
    const covered = () => page.locator("#transport").evaluate((bar) => innerHeight - bar.getBoundingClientRect().top);
    assert.ok((await covered()) <= 100, `${await covered()} px`);
    assert.ok(await page.locator("#play").evaluate((button) => button.getBoundingClientRect().bottom <= innerHeight));
    await page.locator("#numbers").scrollIntoViewIfNeeded();
    assert.ok(await page.locator("#reset").evaluate((button) => button.getBoundingClientRect().bottom <= innerHeight));
    assert.equal(await page.getAttribute("#pseudocode details", "open"), null);
    assert.deepEqual([await page.isVisible("#count-checks"), await page.isVisible("#count-vertices")], [false, true]);
    await page.click("#more-counters summary");
    assert.ok(await page.isVisible("#count-checks"));
    assert.equal(await overhang(page), 0);
  }, PHONE));

test("a roadmap grows by itself; then the path draws itself and the robot drives along it until paused", () =>
  onPage({}, async (page) => {
    await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.vertices) > 4);
    await passes(page, (await counters(page)).iterations);
    await finish(page);
    await valueWithin(page, "along", 0.05);
    for (const pane of ["workspace", "cspace"]) assert.ok((await pixelsOf(page, pane, "top", "path")) > 200, pane);
    await page.click("#play");
    await page.waitForSelector("#play[data-playing=false]");
    await atRest(page);
    const place = await page.inputValue("#along");
    await frames(page);
    assert.equal(await page.inputValue("#along"), place);
  }));

test("play makes iterations until it is paused; step 1, 10 and 100 make exactly as many", () =>
  onPausedPage(async (page) => {
    // Slow enough that it does not end meanwhile.
    await page.fill("#speed", "25");
    await page.click("#play");
    await passes(page, 10);
    let { iterations } = await click(page, "#play");
    for (const count of [1, 10, 100, 10, 1, 100]) {
      iterations += count;
      assert.equal((await click(page, `#step-${count}`)).iterations, iterations);
    }
  }));

test("a run is the same whatever its slices, and a slider moves the robot along its path", () =>
  onPausedPage(async (page) => {
    const fast = await finish(page);
    assert.equal(fast.status, "solved");
    assert.ok(fast.length > 0);
    assert.equal((await click(page, "#reset")).iterations, 0);
    for (const count of [1, 100, 10, 100]) await page.click(`#step-${count}`);
    await page.fill("#speed", "90");
    await page.click("#play");
    await page.waitForSelector("#counters[data-status=solved]", { state: "attached" });
    assert.deepEqual(await atRest(page), fast);
    await page.fill("#along", "1");
    const [goal] = JSON.parse(textOf("stones")).queries[0].goal;
    await valueWithin(page, "pose-0-number", goal - 2e-3, goal + 2e-3);
  }));

test("the page's run is the package's run, bit for bit, and ends as it should", () =>
  onPausedPage(async (page) => {
    for (const entry of SCENES) {
      const { id, algorithm, settings } = entry;
      if (!isDeep && ALIKE.includes(id)) continue;
      await chooseScene(page, id);
      const shown = await finish(page);
      const scenario = open(entry);
      const { result, iterations, edges } = ran(scenario, algorithm, settings);
      assert.deepEqual(
        [shown.fingerprint, shown.iterations, shown.edges],
        [result.fingerprint, iterations, edges.length],
        id,
      );
      assert.equal(shown.status, id === "locked" ? "exhausted" : "solved", id);
      assert.match(
        await page.innerText("#story"),
        shown.status === "solved" ? /^Path found/ : /^No path\. With k = 9 the roadmap has /,
      );
      assert.equal(await page.isVisible("#notice"), false);
      assert.equal(await page.isVisible("#cspace"), scenario.robot !== "disc");
      const inked = (await growthHash(page, "workspace")).split(",").map((layer) => Number(layer.split(" ")[2]));
      assert.ok(Math.max(...inked) > 100, `${id}: ${inked}`);
      if (scenario.robot === "arm" || scenario.robot === "disc") continue;
      for (const pane of ["workspace", "cspace"])
        assert.ok((await pixelsOf(page, pane, "top", "path")) > 50, `${id}: ${pane}`);
    }
  }));

test("planner, k, samples and seed make another run; the same ones the same run", () =>
  onPausedPage(async (page) => {
    const runs = [await finish(page)];
    for (const [name, value] of [
      ["k", "5"],
      ["samples", "150"],
      ["seed", "77"],
    ]) {
      await setParameter(page, name, value);
      runs.push(await finish(page));
    }
    assert.equal(runs[2].vertices, 152);
    await choosePlanner(page, "rrt-connect", "step");
    runs.push(await finish(page));
    assert.equal(runs[4].status, "solved");
    await setParameter(page, "step", "0.2");
    runs.push(await finish(page));
    assert.equal(new Set(runs.map(({ fingerprint }) => fingerprint)).size, runs.length);
    await page.selectOption("#planner", "prm");
    assert.equal(await page.inputValue("#parameter-samples"), "150", "what was given is kept");
    assert.equal((await finish(page)).fingerprint, runs[3].fingerprint);
  }));

test("a new seed is shown, short enough to say aloud, and makes a new run; the largest one is taken", () =>
  onPausedPage(async (page) => {
    const { fingerprint } = await finish(page);
    const seed = () => page.inputValue("#parameter-seed");
    const old = await seed();
    for (let i = 0; i < 4; i++) {
      await page.click("#new-seed");
      assert.match(await seed(), /^\d{1,6}$/);
    }
    assert.notEqual(await seed(), old);
    assert.notEqual((await finish(page)).fingerprint, fingerprint);
    const largest = String(Number.MAX_SAFE_INTEGER);
    await setParameter(page, "seed", largest);
    await finish(page);
    assert.equal(await seed(), largest);
    assert.equal(await page.isHidden("#parameter-seed-reason"), true);
  }));

test("a refused value says why beside its field and leaves the run alone", () =>
  onPausedPage(async (page) => {
    const { fingerprint } = await click(page, "#step-10");
    for (const [name, value, reason, right] of [
      ["k", "0", "below 1", "9"],
      ["samples", "2.5", "whole number", "260"],
      ["seed", "-1", "below 0", "0"],
      ["seed", "", "whole number", "0"],
    ]) {
      await setParameter(page, name, value);
      assert.match(await page.innerText(`#parameter-${name}-reason`), new RegExp(reason));
      assert.equal(await page.getAttribute(`#parameter-${name}`, "aria-invalid"), "true");
      assert.equal((await counters(page)).fingerprint, fingerprint);
      await setParameter(page, name, right);
      assert.equal(await page.isHidden(`#parameter-${name}-reason`), true);
      await page.click("#reset");
      assert.equal((await click(page, "#step-10")).fingerprint, fingerprint);
    }
  }));

test("every planner has its pseudo-code, a short panel, rarer parameters under headings, and switches", () =>
  onPausedPage(async (page) => {
    assert.equal(await page.getAttribute("#pseudocode details", "open"), "", "open on a desktop");
    const isArms = (/** @type {{ robots: string[] }} */ { robots }) => robots.includes("arm");
    for (const { id, pseudocode, parameters: all } of planners().filter(isArms)) {
      const parameters = all.filter(isArms);
      await page.selectOption("#planner", id);
      // Planners share lines, so all of them are compared.
      const lines = pseudocode.map(({ text }) => text).join("\n");
      await page.waitForFunction(
        (wanted) =>
          Array.from(document.querySelectorAll("#pseudocode li"), (line) => line.textContent).join("\n") === wanted,
        lines,
      );
      const first = await page.locator(":is(#main-parameters, #parameters) .field").count();
      const groups = await page
        .locator("#more-parameters .group")
        .evaluateAll((elements) =>
          elements.map((element) => [
            element.querySelector("h3")?.textContent ?? "",
            element.querySelectorAll(".field").length,
          ]),
        );
      assert.ok(first >= 2 && first <= 4, `${id}: ${first}`);
      assert.equal(
        first + groups.reduce((sum, [, count]) => sum + Number(count), 0),
        parameters.length + 1,
        `${id}: the seed and all of its table`,
      );
      assert.deepEqual(
        groups.at(-1),
        ["Limits", 3],
        "nothing is left over but the iterations, the work and how far ends may move",
      );
      assert.ok(groups.length >= 4 && groups.every(([, count]) => Number(count) <= 6), JSON.stringify(groups));
      for (const { name } of parameters.filter(({ kind }) => kind === "boolean")) {
        assert.equal(await page.getAttribute(`#parameter-${name}`, "role"), "switch");
      }
    }
    await page.selectOption("#planner", "prm");
    await setParameter(page, "k", "");
    assert.equal(await page.getAttribute("#parameter-k", "placeholder"), "automatic");
    assert.equal(await page.getAttribute("#parameter-radius", "placeholder"), "none");
    assert.match((await page.locator("#parameter-k-meaning").textContent()) ?? "", /Automatic: 15/);
    assert.equal((await finish(page)).status, "solved");
  }));

test("the guards of a visibility roadmap stand in rings, links do not", () =>
  onPausedPage(async (page) => {
    await page.evaluate(() => {
      const { arc } = OffscreenCanvasRenderingContext2D.prototype;
      const seen = Object.assign(self, { rings: /** @type {string[]} */ ([]) });
      OffscreenCanvasRenderingContext2D.prototype.arc = function (x, y, radius, ...angles) {
        if (radius > 3.6 && radius < 6 && this.lineWidth < 2 && this.canvas.height === this.canvas.width)
          seen.rings.push(`${x} ${y}`);
        arc.call(this, x, y, radius, ...angles);
      };
    });
    assert.equal(await page.isVisible("#legend-guard"), false);
    await page.selectOption("#planner", "visibility-prm");
    const { phase, iterations } = await click(page, "#step-100");
    assert.deepEqual([phase, iterations], ["guarding", 100]);
    assert.match(await page.innerText("#story"), /guard/);
    const { vertices } = await finish(page);
    const rings = await page.evaluate(() => new Set(/** @type {{ rings?: string[] }} */ (self).rings).size);
    const guards = ran(open(sceneOf("stones")), "visibility-prm", {}).events.filter(([kind]) => kind === 5).length;
    assert.ok(guards > 2 && guards < vertices);
    assert.ok(rings >= guards, `${rings} rings, ${guards} guards`);
    assert.equal(await page.isVisible("#legend-guard"), true);
    await page.selectOption("#planner", "prm");
    await atRest(page);
    assert.equal(await page.isVisible("#legend-guard"), false);
  }));

test("a tree that goes on after its first path shows its best path so far, in the legend, too", async () => {
  const planner = open(sceneOf("pillar")).planner({ algorithm: "rrt-star", seed: 1 });
  while (planner.phase !== "improving") planner.step(1);
  const first = planner.iterations;
  planner.free();
  assert.ok(first > 1 && first < 5000, `${first}`);
  for (const [iteration, isFound] of /** @type {const} */ ([
    [first - 1, false],
    [first, true],
  ])) {
    const fragment = await encodeLink({
      version: 1,
      scene: "pillar",
      lanes: [{ algorithm: "rrt-star", settings: { seed: 1 } }],
      iteration,
      view: {},
    });
    await onPage(
      { reducedMotion: "reduce" },
      async (page) => {
        await page.waitForSelector("#counters[data-settled=true]", { state: "attached" });
        const { iterations, status } = await counters(page);
        assert.deepEqual([iterations, status], [iteration, "running"]);
        assert.equal(await page.isVisible("#legend-path"), isFound);
        for (const pane of ["workspace", "cspace"])
          assert.equal((await pixelsOf(page, pane, "top", "path")) > 40, isFound, `${pane}, ${iteration}`);
      },
      { path: `#${fragment}` },
    );
  }
});

test("a sampled path is marked as not proven, its collision in red; a naive roadmap fills the square", () =>
  onPausedPage(async (page) => {
    await reveal(page, "#more-parameters");
    await page.selectOption("#parameter-edge_check", "sampled");
    await setParameter(page, "edge_samples", "1");
    await atRest(page);
    assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);
    await finish(page);
    assert.match(
      await page.innerText("#story"),
      /not verified: link \d hits obstacle \d on the way\. To fix it, set “Collision checking” to proven\.$/,
    );
    assert.equal(await page.getAttribute("#story", "data-tone"), "bad");
    assert.equal(await page.innerText("#legend-path"), "path, not proven");
    for (const pane of ["workspace", "cspace"]) {
      assert.ok((await pixelsOf(page, pane, "top", "unproven")) > 40);
      assert.ok((await pixelsOf(page, pane, "top", "collision")) > 30);
      assert.equal(await pixelsOf(page, pane, "top", "path"), 0);
    }
    await page.selectOption("#parameter-edge_check", "proven");
    await finish(page);
    assert.equal(await page.getAttribute("#story", "data-tone"), "");
    assert.match(await page.innerText("#story"), /proven to be collision-free/);
    assert.equal(await page.innerText("#legend-path"), "path");
    assert.equal(await pixelsOf(page, "workspace", "top", "unproven"), 0);
    await page.selectOption("#parameter-metric", "naive");
    await finish(page);
    const { width, alpha } = await alphaOf(page, "cspace", "edges");
    const [left, right] = [true, false].map(
      (isLeft) => alpha.filter((dense, i) => dense > 120 && i % width < width / 2 === isLeft).length,
    );
    assert.ok(left > 0.3 * right && right > 200, `${left} left, ${right} right`);
  }));

test("a tree that gives up shows its nearest miss, dashed, and the robot drives along it", () =>
  onPausedPage(async (page) => {
    await chooseScene(page, "firs");
    await page.selectOption("#planner", "rrt");
    await reveal(page, "#more-parameters");
    await setParameter(page, "max_iterations", "300");
    assert.equal((await finish(page)).status, "exhausted");
    assert.match(
      await page.innerText("#story"),
      /^Gave up after 300 iterations without a path \(max_iterations\). The closest approach, dashed, ends 0.84 rad from the goal.$/,
    );
    assert.equal(await page.innerText("#legend-path"), "closest approach");
    await page.fill("#along", "0.5");
    await atRest(page);
    const dashed = await pixelsOf(page, "cspace", "top", "path");
    assert.ok(dashed > 100, `${dashed}`);
    // The same line without its dashes has much more of the colour.
    await page.evaluate(() => {
      OffscreenCanvasRenderingContext2D.prototype.setLineDash = () => {};
    });
    await page.fill("#along", "0.51");
    await atRest(page);
    const whole = await pixelsOf(page, "cspace", "top", "path");
    assert.ok(whole > 1.2 * dashed, `${whole} without dashes, ${dashed} with them`);
  }));

test("a path that is being improved says so, and is shorter in the end", () =>
  onPausedPage(async (page) => {
    await chooseScene(page, "firs");
    const plain = await finish(page);
    await reveal(page, "#more-parameters");
    await setParameter(page, "shortcut", "4000");
    for (let i = 0; i < 2; i++) await page.click("#step-100");
    await page.waitForSelector("#counters[data-phase=improving]", { state: "attached" });
    assert.match(await page.innerText("#story"), /being shortened/);
    const improved = await finish(page);
    assert.equal(improved.fingerprint, plain.fingerprint, "the same trees");
    assert.ok(improved.length < plain.length - 0.01, `${improved.length} after ${plain.length}`);
  }));

test("the gallery counts its scenes in view, shows all of them, and the header names the chosen one", () =>
  onPausedPage(async (page) => {
    const inView = () =>
      page.locator(".card").evaluateAll((cards) => {
        const strip = /** @type {HTMLElement} */ (cards[0].parentElement).getBoundingClientRect();
        return cards.filter((card) => card.getBoundingClientRect().right <= strip.right + 1).length;
      });
    const shown = async () => [
      await inView(),
      await page.innerText(".gallery-size .hint"),
      await page.getAttribute("#all-scenes", "aria-expanded"),
    ];
    const few = await inView();
    assert.ok(few < SCENES.length);
    assert.deepEqual(await shown(), [few, `${few} of ${SCENES.length} scenes`, "false"]);
    await page.click("#all-scenes");
    assert.deepEqual(await shown(), [SCENES.length, `${SCENES.length} scenes`, "true"]);
    await page.click("#all-scenes");
    assert.equal(await inView(), few);
    for (const id of ["stones", "blossom", "museum"]) {
      await chooseScene(page, id);
      assert.ok((await page.innerText("#where")).startsWith(`${sceneOf(id).title} \u00b7 `), id);
    }
  }));

test("a bad file is refused with code and place; a good one is planned, dropped or picked", () =>
  onPausedPage(async (page) => {
    const kept = await click(page, "#step-100");
    const good = JSON.parse(textOf("stones"));
    const negative = structuredClone(good);
    negative.robot.links[1] = -0.5;
    for (const [text, code, pointer] of [
      ["{ not json", "invalid-json", ""],
      [JSON.stringify({ ...good, colour: "red" }), "unknown-field", "/colour"],
      [JSON.stringify(negative), "out-of-range", "/robot/links/1"],
    ]) {
      await dropFile(page, "mine.json", text);
      await page.waitForSelector(`#notice[data-code="${code}"]`);
      await atRest(page);
      assert.equal(await page.getAttribute("#notice", "data-pointer"), pointer);
      const words = await page.innerText("#notice");
      assert.ok(words.includes("mine.json") && words.includes(code) && words.includes(pointer), words);
      assert.deepEqual(await counters(page), kept);
      assert.equal(await page.getAttribute("body", "data-scene"), "stones");
    }
    await page.click("#notice button");
    assert.equal(await page.isHidden("#notice"), true);
    assert.equal((await click(page, "#step-1")).iterations, kept.iterations + 1);
    const mine = { ...JSON.parse(textOf("firs")), name: "mine", title: "My own" };
    await dropFile(page, "mine.json", JSON.stringify(mine));
    await page.waitForSelector("body[data-scene=file]");
    await page.selectOption("#planner", "rrt-connect");
    assert.equal((await finish(page)).status, "solved");
    await pickFile(page, "disc.json", textOf("rings"));
    await page.waitForSelector("#cspace", { state: "hidden" });
    await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "0");
    assert.equal((await click(page, "#step-10")).iterations, 10);
  }));

test("a start in collision is named, shown in red, and the page stays usable", () =>
  onPausedPage(async (page) => {
    const mine = JSON.parse(textOf("stones"));
    mine.queries[0].start = [0.7, 0];
    await dropFile(page, "mine.json", JSON.stringify(mine));
    await page.waitForSelector("#notice[data-code=start-in-collision]");
    assert.match(await page.innerText("#notice"), /touches obstacle 0/);
    assert.match(await page.innerText("#touching"), /link \d touches obstacle 0/i);
    assert.equal((await atRest(page)).status, "none");
    assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 100);
    await page.click(".card >> nth=0");
    await page.waitForSelector("body[data-scene=stones]");
    assert.equal(await page.isHidden("#notice"), true);
    assert.equal((await finish(page)).status, "solved");
  }));

test("growth is only ever added to: nothing is cleared while it grows", () =>
  onPausedPage(async (page) => {
    await thumbnails(page);
    await atRest(page);
    await page.evaluate(() => {
      const { clearRect } = OffscreenCanvasRenderingContext2D.prototype;
      const seen = Object.assign(self, { cleared: /** @type {Map<OffscreenCanvas, number>} */ (new Map()) });
      OffscreenCanvasRenderingContext2D.prototype.clearRect = function (...box) {
        seen.cleared.set(this.canvas, (seen.cleared.get(this.canvas) ?? 0) + 1);
        clearRect.apply(this, box);
      };
    });
    await click(page, "#step-100");
    const some = await pixelsOf(page, "cspace", "vertices", "growth");
    await finish(page);
    assert.ok((await pixelsOf(page, "cspace", "vertices", "growth")) > some);
    const cleared = await page.evaluate(() => [
      ...(/** @type {{ cleared?: Map<OffscreenCanvas, number> }} */ (self).cleared?.values() ?? []),
    ]);
    assert.equal(cleared.length, 2, `only the top of each pane is cleared: ${cleared}`);
  }));

test("the page's own script has at most 60 KB gzip all together, its style at most 8 KB", async () => {
  /** @type {Record<string, Promise<Buffer>[]>} */
  const fetched = { script: [], stylesheet: [] };
  const size = async (/** @type {string} */ kind) => gzipSync(Buffer.concat(await Promise.all(fetched[kind]))).length;
  await onPausedPage(
    async (page) => {
      await thumbnails(page);
      const [script, style] = [await size("script"), await size("stylesheet")];
      assert.ok(script > 5000 && script <= 60 * 1024, `script ${script}`);
      assert.ok(style > 500 && style <= 8 * 1024, `style ${style}`);
    },
    {},
    {
      before: async (page) => {
        page.on("response", (response) => {
          const kind = response.request().resourceType();
          if (kind in fetched && !response.url().includes("/planarium/")) fetched[kind].push(response.body());
        });
      },
    },
  );
});
