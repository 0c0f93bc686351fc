/** How the planner's page draws a run. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  alphaOf,
  atRest,
  chooseScene,
  click,
  counters,
  finish,
  onPage,
  onPausedPage,
  pixelsOf,
  reveal,
  setParameter,
  thumbnails,
  useBrowser,
} from "./browser.mjs";
import { open, ran, sceneOf } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { encodeLink } from "../../www/planner/link/codec.js";

useBrowser();

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

test("a run is drawn", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "growth is only ever added to: nothing is cleared while it grows": async (page) => {
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
        },

        "a path that is being improved says so, and is shorter in the end": async (page) => {
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
        },

        "a sampled path is marked as not proven, its collision in red; a naive roadmap fills the square": async (
          page,
        ) => {
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
        },

        "the guards of a visibility roadmap stand in rings, links do not": async (page) => {
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
          const guards = ran(open(sceneOf("stones")), "visibility-prm", {}).events.filter(
            ([kind]) => kind === 5,
          ).length;
          assert.ok(guards > 2 && guards < vertices);
          assert.ok(rings >= guards, `${rings} rings, ${guards} guards`);
          assert.equal(await page.isVisible("#legend-guard"), true);
          await page.selectOption("#planner", "prm");
          await atRest(page);
          assert.equal(await page.isVisible("#legend-guard"), false);
        },

        "a tree that gives up shows its nearest miss, dashed, and the robot drives along it": async (page) => {
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
        },
      },
      restage,
    ),
  ));
