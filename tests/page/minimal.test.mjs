/** The smallest page: it loads the package, grows a tree a step per frame, and draws it. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { onPage, root, useBrowser } from "./browser.mjs";

useBrowser(root);

test("examples/minimal.html solves and draws, in at most 60 lines, and growth streams in a browser", () =>
  onPage(
    {},
    async (page) => {
      assert.ok(
        readFileSync(join(root, "examples", "minimal.html"), "utf8")
          .trimEnd()
          .split("\n").length <= 60,
      );
      await page.waitForFunction(() => document.querySelector("#status")?.textContent?.startsWith("solved"));
      const [edges, iterations] = (await page.locator("#status").innerText()).match(/\d+/g)?.map(Number) ?? [];
      assert.ok(edges > 20 && iterations >= edges, `${edges} edges, ${iterations} iterations`);
      // Pixels of the obstacles, the tree and the path, by what each of their colours has most of.
      const counts = await page.locator("#picture").evaluate((/** @type {HTMLCanvasElement} */ canvas) => {
        const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(
          0,
          0,
          canvas.width,
          canvas.height,
        );
        const counts = { gray: 0, blue: 0, red: 0 };
        for (let i = 0; i < data.length; i += 4) {
          const [r, g, b, a] = data.subarray(i, i + 4);
          if (a === 0) continue;
          if (r > 180 && g < 100) counts.red += 1;
          else if (b > r + 60) counts.blue += 1;
          else if (Math.max(r, g, b) - Math.min(r, g, b) < 8) counts.gray += 1;
        }
        return counts;
      });
      assert.ok(counts.gray > 20_000 && counts.blue > 500 && counts.red > 300, JSON.stringify(counts));
      // The same package as a stream: other tasks run between its slices here, too.
      const { status, vertices, count, ticks } =
        await page.evaluate(`import("/dist/package/planarium.js").then(async ({ Scenario }) => {
    const planner = Scenario.generate("maze", { seed: 1 }).planner({ algorithm: "prm", samples: 3000 });
    let [ticks, vertices, status] = [0, 0, "running"];
    const timer = setInterval(() => { ticks += 1; }, 0);
    for await (const growth of planner.growth({ budget: 1 })) {
      vertices += growth.vertices.length / planner.dimension;
      status = growth.status;
    }
    clearInterval(timer);
    return { status, vertices, count: planner.vertexCount, ticks };
  })`);
      assert.deepEqual([status, vertices], ["solved", count]);
      assert.ok(ticks > 0, `${ticks} ticks`);
    },
    { path: "examples/minimal.html" },
  ));
