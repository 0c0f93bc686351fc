/** The page in a real browser: it opens, grows, obeys, refuses and is readable. */
import { withOptions } from "../../www/domain/option-names.js";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { gzipSync } from "node:zlib";
import { Scenario } from "planarium";
import {
  PHONE, atRest, chooseScene, counters, dropFile, finish, frames, growthHash, isDeep, onPage, onPausedPage, pickFile, pixelsOf, root, setParameter, start, stop, thumbnails,
} from "./browser.mjs";
import { assertFits } from "./looks.mjs";
import { SCENES } from "../../www/planner/scenes/scenes.js";

/** Scenes that differ from others in their world alone: all end in scenes.test.mjs, and here where all cases are tried. */
const ALIKE = ["open", "slot", "trap", "maze", "shelf", "tentacle", "corner", "turn", "lanes"];

before(start);
after(stop);

/** @import { Page } from "./browser.mjs" */

/** One of the page's scenes, read or made by the package. @param {import("../../www/domain/types.js").SceneEntry} entry */
const scenarioOf = ({ id, generate }) => (generate ? Scenario.generate(generate.kind, generate.options) : Scenario.parse(scene(id)));

const scene = (/** @type {string} */ id) => readFileSync(join(root, "www", "scenes", `${id}.json`), "utf8");

describe("opening", () => {
  test("a roadmap grows by itself", async () => {
    await onPage({}, async (page) => {
      await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.vertices) > 4);
      const { iterations } = await counters(page);
      await page.waitForFunction((before) => Number(document.getElementById("counters")?.dataset.iterations) > before, iterations);
    });
  });

  test("on paper are the scene, the planner, its settings and the iteration; nothing to press, and panes beside each other", async () => {
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      await onPausedPage(async (page) => {
        const { iterations } = await finish(page);
        assert.equal(await page.locator("#printed").isVisible(), false);
        await page.pdf();
        await page.emulateMedia({ media: "print" });
        await page.setViewportSize({ width: 794, height: 1123 });
        assert.equal(await page.innerText("#printed"), `Two links among stones \u00b7 PRM, k 9, samples 260, sampler uniform, seed 0 \u00b7 iteration ${iterations}`);
        for (const button of await page.locator("button, input, select").all()) assert.equal(await button.isVisible(), false);
        const sheets = await page.locator(".sheet, .sheet canvas").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
        const [left, right] = [0, sheets.length / 2].map((first) => sheets.slice(first, first + sheets.length / 2));
        assert.ok(Math.max(...left.map((box) => box.right)) <= Math.min(...right.map((box) => box.left)));
        assert.ok(sheets.every(({ width, height }) => width > 300 && Math.abs(width - height) < 1));
        await page.emulateMedia({ media: "screen" });
      }, { colorScheme });
    }
  });

  test("on a phone the transport leaves most of the screen to the stage, and all of it can be reached", async () => {
    await onPausedPage(async (page) => {
      const covered = () => page.locator("#transport").evaluate((bar) => innerHeight - bar.getBoundingClientRect().top);
      assert.ok(await covered() <= 100, `${await covered()} px`);
      assert.ok(await page.locator("#play").evaluate((button) => button.getBoundingClientRect().bottom <= innerHeight));
      await page.locator("#numbers").scrollIntoViewIfNeeded();
      assert.ok(await page.locator("#reset").evaluate((button) => button.getBoundingClientRect().bottom <= innerHeight));
    }, PHONE);
  });

  test("whoever asks for less motion finds it paused, with one button to start it", async () => {
    await onPausedPage(async (page) => {
      assert.equal((await counters(page)).iterations, 0);
      assert.equal(await page.getAttribute("#play", "data-playing"), "false");
      assert.equal(await page.locator("#play").innerText(), "Play");
      await page.click("#play");
      await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.iterations) > 5);
    });
  });

  test("solved, the path draws itself and the robot drives along it until it is paused", async () => {
    await onPage({}, async (page) => {
      await finish(page);
      await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.getElementById("along")).value) > 0.05);
      assert.ok(await pixelsOf(page, "workspace", "top", "path") > 200);
      assert.ok(await pixelsOf(page, "cspace", "top", "path") > 200);
      await page.click("#play");
      await page.waitForSelector("#play[data-playing=false]");
      await atRest(page);
      const place = await page.inputValue("#along");
      await frames(page);
      assert.equal(await page.inputValue("#along"), place);
    });
  });

  test("without its WebAssembly it says so and stays a page", async () => {
    await onPage({}, async (page) => {
      await page.waitForSelector("#notice:not([hidden])");
      assert.match(await page.innerText("#notice"), /WebAssembly/);
      assert.equal((await counters(page)).status, "failed");
    }, { before: async (page) => { await page.route(/\.wasm$/, (route) => route.abort()); }, expectErrors: true });
  });
});

describe("transport", () => {
  test("play and pause", async () => {
    await onPausedPage(async (page) => {
      // Slow enough that it does not end meanwhile.
      await page.locator("#speed").fill("25");
      await page.click("#play");
      await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.iterations) > 10);
      await page.click("#play");
      const { iterations } = await atRest(page);
      await page.click("#step-1");
      assert.equal((await atRest(page)).iterations, iterations + 1, "it has stood still meanwhile");
    });
  });

  test("step 1, 10 and 100 make exactly that many iterations", async () => {
    await onPausedPage(async (page) => {
      let wanted = 0;
      for (const count of [1, 10, 100, 10, 1, 100]) {
        wanted += count;
        await page.click(`#step-${count}`);
        assert.equal((await atRest(page)).iterations, wanted);
      }
    });
  });

  test("run to the end, reset, and the same run again, whatever its slices", async () => {
    await onPausedPage(async (page) => {
      const fast = await finish(page);
      assert.equal(fast.status, "solved");
      assert.ok(fast.length > 0);
      await page.click("#reset");
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "0");
      for (const count of [1, 100, 10, 100]) await page.click(`#step-${count}`);
      await page.locator("#speed").fill("90");
      await page.click("#play");
      await page.waitForSelector("#counters[data-status=solved]", { state: "attached" });
      assert.deepEqual(await atRest(page), fast);
    });
  });

  test("the slider follows the path with the robot", async () => {
    await onPausedPage(async (page) => {
      await finish(page);
      await page.locator("#along").fill("1");
      const goal = JSON.parse(scene("stones")).queries[0].goal;
      await page.waitForFunction((wanted) => Math.abs(Number(/** @type {HTMLInputElement} */ (document.getElementById("pose-0-number")).value) - wanted) < 2e-3, goal[0]);
    });
  });
});

describe("settings", () => {
  test("the page's run is the package's run, bit for bit, and ends as it should", async () => {
    await onPausedPage(async (page) => {
      for (const entry of SCENES) {
        const { id, algorithm, settings } = entry;
        if (!isDeep && ALIKE.includes(id)) continue;
        await chooseScene(page, id);
        const shown = await finish(page);
        const scenario = scenarioOf(entry);
        const planner = withOptions({ ...settings, algorithm }, (options) => scenario.planner(options));
        while (planner.step(1000) === "running");
        assert.deepEqual([shown.fingerprint, shown.iterations, shown.edges], [planner.fingerprint(), planner.iterations, planner.edgeCount], id);
        assert.equal(shown.status, id === "locked" ? "exhausted" : "solved", id);
        assert.match(await page.innerText("#story"), shown.status === "solved" ? /^Path found/ : /^No path/);
        assert.equal(await page.locator("#notice").isVisible(), false);
        assert.equal(await page.locator("#cspace").isVisible(), scenario.robot !== "disc");
        const inked = (await growthHash(page, "workspace")).split(",").map((layer) => Number(layer.split(" ")[2]));
        assert.ok(Math.max(...inked) > 100, `${id}: ${inked}`);
        if (scenario.robot === "arm" || scenario.robot === "disc") continue;
        for (const pane of ["workspace", "cspace"]) assert.ok(await pixelsOf(page, pane, "top", "path") > 50, `${id}: ${pane}`);
      }
    });
  });

  test("planner, k, samples and seed make another run; the same ones the same run", async () => {
    await onPausedPage(async (page) => {
      const fingerprints = [(await finish(page)).fingerprint];
      await setParameter(page, "k", "5");
      fingerprints.push((await finish(page)).fingerprint);
      await setParameter(page, "samples", "150");
      const few = await finish(page);
      assert.equal(few.vertices, 152);
      fingerprints.push(few.fingerprint);
      await setParameter(page, "seed", "77");
      fingerprints.push((await finish(page)).fingerprint);
      await page.selectOption("#planner", "rrt-connect");
      await page.waitForSelector("#parameter-step");
      const trees = await finish(page);
      assert.equal(trees.status, "solved");
      fingerprints.push(trees.fingerprint);
      await setParameter(page, "step", "0.2");
      fingerprints.push((await finish(page)).fingerprint);
      assert.equal(new Set(fingerprints).size, fingerprints.length);
      await page.selectOption("#planner", "prm");
      assert.equal(await page.inputValue("#parameter-samples"), "150", "what was given is kept");
      assert.equal((await finish(page)).fingerprint, fingerprints[3]);
    });
  });

  test("a new seed is shown and makes a new run", async () => {
    await onPausedPage(async (page) => {
      const { fingerprint } = await finish(page);
      const old = await page.inputValue("#parameter-seed");
      await page.click("#new-seed");
      await page.waitForFunction((before) => /** @type {HTMLInputElement} */ (document.getElementById("parameter-seed")).value !== before, old);
      for (let i = 0; i < 4; i++) {
        assert.match(await page.inputValue("#parameter-seed"), /^\d{1,6}$/);
        await page.click("#new-seed");
      }
      assert.notEqual((await finish(page)).fingerprint, fingerprint);
      const largest = String(Number.MAX_SAFE_INTEGER);
      await setParameter(page, "seed", largest);
      await finish(page);
      assert.equal(await page.inputValue("#parameter-seed"), largest);
      assert.equal(await page.locator("#parameter-seed-reason").isHidden(), true);
    });
  });

  test("a refused value says why beside its field and leaves the run alone", async () => {
    await onPausedPage(async (page) => {
      await page.click("#step-10");
      const { fingerprint } = await atRest(page);
      for (const [name, value, reason] of [["k", "0", "below 1"], ["samples", "2.5", "whole number"], ["seed", "-1", "below 0"], ["samples", "", "whole number"]]) {
        await setParameter(page, name, value);
        assert.match(await page.innerText(`#parameter-${name}-reason`), new RegExp(reason));
        assert.equal(await page.locator(`#parameter-${name}`).getAttribute("aria-invalid"), "true");
        assert.equal((await counters(page)).fingerprint, fingerprint);
        await setParameter(page, name, "9");
        assert.equal(await page.locator(`#parameter-${name}-reason`).isHidden(), true);
        await page.click("#step-10");
        await atRest(page);
        await setParameter(page, "k", "9");
        await setParameter(page, "samples", "260");
        await setParameter(page, "seed", "0");
        await page.click("#reset");
        await page.click("#step-10");
        assert.equal((await atRest(page)).fingerprint, fingerprint);
      }
    });
  });
});

describe("planners", () => {
  test("every planner has a short panel, its rarer parameters under headings, switches for what is on or off", async () => {
    const { planners } = await import("planarium");
    await onPausedPage(async (page) => {
      const isArms = (/** @type {{ robots: string[] }} */ { robots }) => robots.includes("arm");
      for (const { id, parameters: all } of planners().filter(isArms)) {
        const parameters = all.filter(isArms);
        await page.selectOption("#planner", id);
        const first = await page.locator("#parameters .field").count();
        const groups = await page.locator("#more-parameters .group").evaluateAll((elements) => elements.map((element) => [element.querySelector("h3")?.textContent ?? "", element.querySelectorAll(".field").length]));
        assert.ok(first >= 3 && first <= 4, `${id}: ${first}`);
        assert.equal(first + groups.reduce((sum, [, count]) => sum + Number(count), 0), parameters.length + 1, `${id}: the seed and all of its table`);
        assert.deepEqual(groups.at(-1), ["Limits", 1], "nothing is left over but the iterations");
        assert.ok(groups.length >= 4 && groups.every(([, count]) => Number(count) <= 6), JSON.stringify(groups));
        for (const { name } of parameters.filter(({ kind }) => kind === "boolean")) {
          assert.equal(await page.locator(`#parameter-${name}`).getAttribute("role"), "switch");
        }
      }
      await page.selectOption("#planner", "prm");
      await setParameter(page, "k", "");
      assert.equal(await page.getAttribute("#parameter-k", "placeholder"), "automatic");
      assert.equal(await page.getAttribute("#parameter-radius", "placeholder"), "none");
      assert.match(await page.locator("#parameter-k-meaning").textContent() ?? "", /Automatic: 15/);
      assert.equal((await finish(page)).status, "solved");
    });
  });

  test("the guards of a visibility roadmap stand in rings, links do not", async () => {
    await onPausedPage(async (page) => {
      await page.evaluate(() => {
        const { arc } = CanvasRenderingContext2D.prototype;
        const seen = Object.assign(self, { rings: /** @type {string[]} */ ([]) });
        CanvasRenderingContext2D.prototype.arc = function (x, y, radius, ...angles) {
          if (radius > 3.6 && radius < 6 && this.lineWidth < 2 && this.canvas.height === this.canvas.width) seen.rings.push(`${x} ${y}`);
          arc.call(this, x, y, radius, ...angles);
        };
      });
      assert.equal(await page.locator("#legend-guard").isVisible(), false);
      await page.selectOption("#planner", "visibility-prm");
      await page.click("#step-100");
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "100");
      assert.equal((await atRest(page)).phase, "guarding");
      assert.match(await page.innerText("#story"), /guard/);
      const { vertices } = await finish(page);
      const rings = await page.evaluate(() => new Set(/** @type {{ rings?: string[] }} */ (self).rings).size);
      const planner = Scenario.parse(scene("stones")).planner({ algorithm: "visibility-prm" });
      while (planner.step(1000) === "running");
      const events = planner.eventsSince(0);
      const guards = events.filter((kind, i) => i % planner.eventWidth === 0 && kind === 5).length;
      assert.ok(guards > 2 && guards < vertices);
      assert.ok(rings >= guards, `${rings} rings, ${guards} guards`);
      assert.equal(await page.locator("#legend-guard").isVisible(), true);
      await page.selectOption("#planner", "prm");
      await atRest(page);
      assert.equal(await page.locator("#legend-guard").isVisible(), false);
    });
  });

  test("a path of sampled edges is marked as not proven, and where it collides that is said in red", async () => {
    await onPausedPage(async (page) => {
      await page.click("#more summary");
      await page.selectOption("#parameter-edge_check", "sampled");
      await setParameter(page, "edge_samples", "1");
      await atRest(page);
      assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);
      await finish(page);
      assert.match(await page.innerText("#story"), /not verified: link \d hits obstacle \d on the way\. To fix it, set “Collision checking” to proven\.$/);
      assert.equal(await page.locator("#story").getAttribute("data-tone"), "bad");
      assert.equal(await page.innerText("#legend-path"), "path, not proven");
      for (const pane of /** @type {const} */ (["workspace", "cspace"])) {
        assert.ok(await pixelsOf(page, pane, "top", "unproven") > 40);
        assert.ok(await pixelsOf(page, pane, "top", "collision") > 30);
        assert.equal(await pixelsOf(page, pane, "top", "path"), 0);
      }
      await page.selectOption("#parameter-edge_check", "proven");
      await finish(page);
      assert.equal(await page.locator("#story").getAttribute("data-tone"), "");
      assert.match(await page.innerText("#story"), /proven to be collision-free/);
      assert.equal(await page.innerText("#legend-path"), "path");
      assert.equal(await pixelsOf(page, "workspace", "top", "unproven"), 0);
    });
  });

  test("a tree that gives up shows its nearest miss, dashed, and the robot drives along it", async () => {
    await onPausedPage(async (page) => {
      await chooseScene(page, "firs");
      await page.selectOption("#planner", "rrt");
      await page.click("#more summary");
      await setParameter(page, "max_iterations", "300");
      assert.equal((await finish(page)).status, "exhausted");
      assert.match(await page.innerText("#story"), /^No path after 300 iterations. The closest approach, dashed, ends 0.84 rad from the goal.$/);
      assert.equal(await page.innerText("#legend-path"), "closest approach");
      await page.locator("#along").fill("0.5");
      await atRest(page);
      const dashed = await pixelsOf(page, "cspace", "top", "path");
      assert.ok(dashed > 100, `${dashed}`);
      // The same line without its dashes has much more of the colour.
      await page.evaluate(() => { CanvasRenderingContext2D.prototype.setLineDash = () => {}; });
      await page.locator("#along").fill("0.51");
      await atRest(page);
      const whole = await pixelsOf(page, "cspace", "top", "path");
      assert.ok(whole > 1.2 * dashed, `${whole} without dashes, ${dashed} with them`);
    });
  });

  test("a path that is being improved says so, and is shorter in the end", async () => {
    await onPausedPage(async (page) => {
      await chooseScene(page, "firs");
      const plain = await finish(page);
      await page.click("#more summary");
      await setParameter(page, "shortcut", "4000");
      for (let i = 0; i < 2; i++) await page.click("#step-100");
      await page.waitForSelector("#counters[data-phase=improving]", { state: "attached" });
      assert.match(await page.innerText("#story"), /being shortened/);
      const improved = await finish(page);
      assert.equal(improved.fingerprint, plain.fingerprint, "the same trees");
      assert.ok(improved.length < plain.length - 0.01, `${improved.length} after ${plain.length}`);
    });
  });

  test("the naive metric's roadmap is drawn on all of the square", async () => {
    await onPausedPage(async (page) => {
      await page.click("#more summary");
      await page.selectOption("#parameter-metric", "naive");
      await finish(page);
      const [left, right] = await page.evaluate(() => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector("#cspace canvas[data-layer=edges]"));
        const half = Math.floor(canvas.width / 2);
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
        copy?.drawImage(canvas, 0, 0);
        const ink = (/** @type {number} */ x) => (copy?.getImageData(x, 0, half, canvas.height).data ?? []).filter((v, i) => i % 4 === 3 && v > 120).length;
        return [ink(0), ink(half)];
      });
      assert.ok(left > 0.3 * right && right > 200, `${left} left, ${right} right`);
    });
  });
});

describe("scenes and files", () => {
  test("the header has the name of the gallery, of drawn and of generated scenes alike", async () => {
    await onPausedPage(async (page) => {
      for (const { id, title } of SCENES.filter((entry) => ["stones", "blossom", "museum"].includes(entry.id))) {
        await chooseScene(page, id);
        assert.ok((await page.innerText("#where")).startsWith(`${title} \u00b7 `), title);
      }
    });
  });

  test("the gallery says how many of its scenes are in view, and shows all of them", async () => {
    await onPausedPage(async (page) => {
      const inView = () => page.locator(".card").evaluateAll((cards) => {
        const strip = /** @type {HTMLElement} */ (cards[0].parentElement).getBoundingClientRect();
        return cards.filter((card) => card.getBoundingClientRect().right <= strip.right + 1).length;
      });
      const few = await inView();
      assert.ok(few < SCENES.length);
      assert.equal(await page.innerText(".gallery-size .hint"), `${few} of ${SCENES.length} scenes`);
      await page.click("#all-scenes");
      assert.deepEqual([await inView(), await page.innerText(".gallery-size .hint"), await page.getAttribute("#all-scenes", "aria-expanded")], [SCENES.length, `${SCENES.length} scenes`, "true"]);
      await page.click("#all-scenes");
      assert.equal(await inView(), few);
    });
  });

  test("a bad file is refused with code and place, and the scene stays", async () => {
    await onPausedPage(async (page) => {
      await page.click("#step-100");
      const kept = await atRest(page);
      const good = JSON.parse(scene("stones"));
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
        assert.equal(await page.locator("#notice").getAttribute("data-pointer"), pointer);
        const words = await page.innerText("#notice");
        assert.ok(words.includes("mine.json") && words.includes(code) && words.includes(pointer), words);
        assert.deepEqual(await counters(page), kept);
        assert.equal(await page.locator("body").getAttribute("data-scene"), "stones");
      }
      await page.click("#notice button");
      assert.equal(await page.locator("#notice").isHidden(), true);
      await page.click("#step-1");
      await page.waitForFunction((n) => Number(document.getElementById("counters")?.dataset.iterations) === n, kept.iterations + 1);
    });
  });

  test("a good file is shown and planned, dropped or picked", async () => {
    await onPausedPage(async (page) => {
      const mine = { ...JSON.parse(scene("firs")), name: "mine", title: "My own" };
      await dropFile(page, "mine.json", JSON.stringify(mine));
      await page.waitForSelector("body[data-scene=file]");
      await page.selectOption("#planner", "rrt-connect");
      assert.equal((await finish(page)).status, "solved");
      await pickFile(page, "disc.json", scene("rings"));
      await page.waitForSelector("#cspace", { state: "hidden" });
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "0");
      await page.click("#step-10");
      assert.equal((await atRest(page)).iterations, 10);
    });
  });

  test("a start in collision is named, shown in red, and the page stays usable", async () => {
    await onPausedPage(async (page) => {
      const mine = JSON.parse(scene("stones"));
      mine.queries[0].start = [0.7, 0];
      await dropFile(page, "mine.json", JSON.stringify(mine));
      await page.waitForSelector("#notice[data-code=start-in-collision]");
      assert.match(await page.innerText("#notice"), /touches obstacle 0/);
      assert.match(await page.innerText("#touching"), /link \d touches obstacle 0/i);
      assert.equal((await atRest(page)).status, "none");
      assert.ok(await pixelsOf(page, "workspace", "top", "collision") > 100);
      await page.click(".card >> nth=0");
      await page.waitForSelector("body[data-scene=stones]");
      assert.equal(await page.locator("#notice").isHidden(), true);
      assert.equal((await finish(page)).status, "solved");
    });
  });
});

/** Waits until the worker has told of a pose. @param {Page} page @param {number} index @param {number} low @param {number} high */
async function poseReaches(page, index, low, high) {
  await page.waitForFunction(([i, least, most]) => {
    const value = Number(/** @type {HTMLInputElement} */ (document.getElementById(`pose-${i}-number`)).value);
    return value > least && value < most;
  }, [index, low, high]);
}

describe("the robot in the hand", () => {
  test("a touching pose turns red and names part and obstacle", async () => {
    await onPausedPage(async (page) => {
      await page.click("#your-turn");
      await atRest(page);
      assert.equal(await page.locator("#touching").getAttribute("data-free"), "true");
      assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);
      await page.locator("#pose-0-number").fill("0.7");
      await page.locator("#pose-0-number").blur();
      await page.locator("#pose-1-number").fill("0");
      await page.locator("#pose-1-number").blur();
      await page.waitForSelector("#touching[data-free=false]");
      assert.match(await page.innerText("#touching"), /link 2 touches obstacle 0/i);
      assert.ok(await pixelsOf(page, "workspace", "top", "collision") > 100);
      await page.click("#your-turn");
      await atRest(page);
      assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);
    });
  });

  test("a point of the configuration square is a pose, a link that is dragged turns its joint", async () => {
    await onPausedPage(async (page) => {
      const square = await page.locator("#cspace canvas[data-layer=top]").boundingBox();
      assert.ok(square);
      await page.mouse.click(square.x + square.width / 2, square.y + square.height / 3);
      await poseReaches(page, 1, 0.5, 1.6);
      await page.mouse.move(square.x + square.width / 2, square.y + square.height / 3);
      await page.mouse.down();
      await page.mouse.move(square.x + square.width * 0.7, square.y + square.height * 0.6, { steps: 5 });
      await page.mouse.up();
      await poseReaches(page, 0, 0.5, 7);
      for (const [i, value] of [[0, "0"], [1, "0"]]) {
        await page.locator(`#pose-${i}-number`).fill(String(value));
        await page.locator(`#pose-${i}-number`).blur();
      }
      await atRest(page);
      const box = await page.locator("#workspace canvas[data-layer=top]").boundingBox() ?? assert.fail();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      await page.mouse.move(x + 60, y);
      await page.mouse.down();
      await page.mouse.move(x + 40, y - 40, { steps: 6 });
      await page.mouse.up();
      await poseReaches(page, 0, Math.PI / 4 - 0.1, Math.PI / 4 + 0.1);
    });
  });

  test("who brings the robot to the goal is told so", async () => {
    await onPausedPage(async (page) => {
      await page.click("#your-turn");
      const { goal } = JSON.parse(scene("stones")).queries[0];
      for (const i of [0, 1]) {
        await page.locator(`#pose-${i}-number`).fill(String(goal[i]));
        await page.locator(`#pose-${i}-number`).blur();
      }
      await page.waitForFunction(() => /reached the goal/.test(document.getElementById("story")?.textContent ?? ""));
    });
  });
});

describe("looks", () => {
  test("nothing hangs over at any width", async () => {
    await onPausedPage(async (page) => {
      for (const id of ["stones", "rings"]) {
        await chooseScene(page, id);
        await finish(page);
        await assertFits(page, id, 200);
      }
    });
  });

  test("as sharp as the screen", async () => {
    for (const deviceScaleFactor of [1, 3]) {
      await onPausedPage(async (page) => {
        await page.waitForFunction(() => [...document.querySelectorAll("canvas[data-layer]")].every((element) => {
          const canvas = /** @type {HTMLCanvasElement} */ (element);
          return Math.abs(canvas.width - canvas.getBoundingClientRect().width * devicePixelRatio) <= 1;
        }));
        const sizes = await page.evaluate(() => [...document.querySelectorAll("canvas[data-layer]")].map((element) => {
          const canvas = /** @type {HTMLCanvasElement} */ (element);
          const { width, height } = canvas.getBoundingClientRect();
          return { width: canvas.width - width * devicePixelRatio, height: canvas.height - height * devicePixelRatio };
        }));
        assert.equal(sizes.length, 10);
        for (const { width, height } of sizes) assert.ok(Math.abs(width) <= 1 && Math.abs(height) <= 1);
      }, { deviceScaleFactor, viewport: { width: 1000, height: 800 } });
    }
  });

  test("light and dark follow the system until the reader chooses", async () => {
    const background = (/** @type {import("playwright-core").Page} */ page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    await onPausedPage(async (page) => {
      const light = await background(page);
      await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
      const dark = await background(page);
      assert.notEqual(light, dark);
      await page.click("#theme");
      assert.equal(await background(page), light);
      await page.reload();
      await page.waitForSelector("#counters[data-status=running]");
      assert.equal(await background(page), light, "the choice is remembered");
    }, { colorScheme: "light" });
  });

  test("pictures for people", { skip: !isDeep }, async () => {
    const folder = join(root, "dist", "screenshots");
    for (const [device, width, height] of /** @type {const} */ ([["desk", 1440, 900], ["tablet", 820, 1180], ["phone", 360, 740]])) {
      for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
        await onPage({ viewport: { width, height }, colorScheme, deviceScaleFactor: device === "phone" ? 2 : 1 }, async (page) => {
          await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.edges) > 200);
          await page.screenshot({ path: join(folder, `${device}-${colorScheme}-growing.png`) });
          await finish(page);
          await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.getElementById("along")).value) > 0.3);
          await page.screenshot({ path: join(folder, `${device}-${colorScheme}-solved.png`) });
        });
      }
    }
  });
});

describe("keyboard and ears", () => {
  test("single keys work on stage and transport, and nowhere else", async () => {
    await onPausedPage(async (page) => {
      await page.focus("#stage");
      await page.keyboard.press(".");
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "1");
      await page.keyboard.press("Space");
      await page.waitForSelector("#play[data-playing=true]");
      await page.keyboard.press("Space");
      await page.waitForSelector("#play[data-playing=false]");
      await page.keyboard.press("r");
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "0");
      const seed = await page.inputValue("#parameter-seed");
      await page.keyboard.press("n");
      await page.waitForFunction((old) => /** @type {HTMLInputElement} */ (document.getElementById("parameter-seed")).value !== old, seed);
      assert.notEqual(await page.inputValue("#parameter-seed"), seed);
      await page.focus("#speed");
      await page.keyboard.press(".");
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "1");
      await page.focus("#planner");
      for (const key of [".", "r", "e"]) await page.keyboard.press(key);
      const { iterations } = await atRest(page);
      assert.equal(iterations, (await page.inputValue("#planner")) === "prm" ? 1 : 0);
      await page.focus("#stage");
      await page.keyboard.press(".");
      assert.equal((await atRest(page)).iterations, iterations + 1, "keys in the panel are the panel's");
      await page.focus("#stage");
      await page.keyboard.press("e");
      await page.waitForSelector("#counters[data-status=solved], #counters[data-status=exhausted]", { state: "attached" });
    });
  });

  test("everything is reached by Tab, with a focus that shows", async () => {
    await onPausedPage(async (page) => {
      const reached = new Set();
      for (let i = 0; i < 60; i++) {
        await page.keyboard.press("Tab");
        const { id, outline } = await page.evaluate(() => {
          const element = document.activeElement ?? document.body;
          const shown = element.matches(".card input") ? element.parentElement ?? element : element;
          return { id: element.id || element.getAttribute("name") || element.tagName, outline: getComputedStyle(shown).outlineStyle };
        });
        if (id === "BODY") break;
        reached.add(id);
        assert.notEqual(outline, "none", id);
      }
      for (const id of ["theme", "your-turn", "stage", "play", "step-1", "step-10", "step-100", "finish", "reset", "speed", "scene", "open", "planner", "parameter-k", "parameter-samples", "parameter-seed", "new-seed", "pose-0", "pose-0-number", "pose-1"]) {
        assert.ok(reached.has(id), `${id} is not reached`);
      }
    });
  });

  test("milestones are announced and the pictures described", async () => {
    await onPausedPage(async (page) => {
      await finish(page);
      await page.waitForFunction(() => document.getElementById("announcer")?.textContent?.startsWith("Path found"));
      const label = await page.locator("#workspace canvas[role=img]").getAttribute("aria-label");
      assert.match(label ?? "", /262 vertices.*solved/);
    });
  });

});

describe("cost", () => {
  test("growth is only ever added to: nothing is cleared while it grows", async () => {
    await onPausedPage(async (page) => {
      await thumbnails(page);
      await atRest(page);
      await page.evaluate(() => {
        const { clearRect } = CanvasRenderingContext2D.prototype;
        const seen = Object.assign(self, { cleared: /** @type {Map<HTMLCanvasElement, number>} */ (new Map()) });
        CanvasRenderingContext2D.prototype.clearRect = function (...box) {
          seen.cleared.set(this.canvas, (seen.cleared.get(this.canvas) ?? 0) + 1);
          clearRect.apply(this, box);
        };
      });
      await page.click("#step-100");
      await atRest(page);
      const some = await pixelsOf(page, "cspace", "vertices", "growth");
      await finish(page);
      assert.ok(await pixelsOf(page, "cspace", "vertices", "growth") > some);
      const cleared = await page.evaluate(() => [.../** @type {{ cleared?: Map<HTMLCanvasElement, number> }} */ (self).cleared?.values() ?? []]);
      assert.equal(cleared.length, 2, `only the top of each pane is cleared: ${cleared}`);
    });
  });

  test("the page's own script has at most 60 KB gzip all together, its style at most 8 KB", async () => {
    /** @type {Record<string, Promise<Buffer>[]>} */
    const fetched = { script: [], stylesheet: [] };
    const size = async (/** @type {string} */ kind) => gzipSync(Buffer.concat(await Promise.all(fetched[kind]))).length;
    await onPausedPage(async (page) => {
      await thumbnails(page);
      const [script, style] = [await size("script"), await size("stylesheet")];
      assert.ok(script > 5000 && script <= 60 * 1024, `script ${script}`);
      assert.ok(style > 500 && style <= 8 * 1024, `style ${style}`);
    }, {}, { before: async (page) => {
      page.on("response", (response) => {
        const kind = response.request().resourceType();
        if (kind in fetched && !response.url().includes("/planarium/")) fetched[kind].push(response.body());
      });
    } });
  });
});
