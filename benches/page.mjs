/**
 * `npm run bench:page`: the costs of the pages in Chromium, and of their readers and writers of files in Node.
 *
 * Each figure is the median of several rounds and has a bound; a figure above its bound fails the run. On a busy
 * machine figures of elapsed time are larger; those of processor time, marked "cpu", are not.
 *
 *   npm run bench:page [-- TEXT]                  only figures whose name contains the text
 *   npm run bench:page -- [TEXT] --beside FOLDER  those that compare, in turn with the page of another build
 *
 * It uses the existing build (`npm run build`), and Chromium from CHROMIUM or from Debian's path.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { deflateRawSync } from "node:zlib";
import { script } from "../scripts/run.mjs";
import {
  atRest,
  chooseScene,
  finish,
  onPage,
  reveal,
  root,
  setParameter,
  start,
  stop,
  unfold,
} from "../tests/page/browser.mjs";
import { openEditor, plane } from "../tests/page/editing.mjs";
import { seeded } from "../tests/page/seeded.mjs";
import { GifWriter, paletteOf } from "../www/formats/gif.js";
import { decodeLink } from "../www/planner/link/codec.js";
import { readNpyPolygons } from "../www/formats/npy.js";
import { SvgContext } from "../www/formats/svg.js";
import { VertexIndex } from "../www/planner/stage/vertex-index.js";

/** @import { Page } from "../tests/page/browser.mjs" */
/**
 * @typedef {{ name: string, bound: number, rounds: number, measure: () => Promise<number> | number, compares?: true }}
 *   Figure   milliseconds; `compares`: it measures any build in the same way
 */

/** @param {number[]} values */
const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

/** The processor time of some work in this process, in milliseconds. @param {() => unknown} work */
async function used(work) {
  const before = process.cpuUsage();
  await work();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

/**
 * The processor time of each task of the page's thread and of its worker's thread during some work, in milliseconds.
 * @param {Page} page
 * @param {() => Promise<unknown>} meanwhile
 */
async function tasks(page, meanwhile) {
  const browser = page.context().browser() ?? assert.fail("no browser");
  await browser.startTracing(page, { categories: ["disabled-by-default-devtools.timeline", "__metadata"] });
  await meanwhile();
  /** @type {{ traceEvents: { name: string, tid: number, pid: number, tdur?: number, args: { name?: string } }[] }} */
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const threads = new Map(
    traceEvents
      .filter(({ name }) => name === "thread_name")
      .map(({ pid, tid, args }) => [`${pid} ${tid}`, args.name ?? ""]),
  );
  const of = (/** @type {RegExp} */ thread) =>
    traceEvents
      .filter(
        ({ name, pid, tid, tdur }) =>
          name.endsWith("RunTask") && tdur !== undefined && thread.test(threads.get(`${pid} ${tid}`) ?? ""),
      )
      .map(({ tdur }) => (tdur ?? 0) / 1000);
  return { page: of(/^CrRendererMain$/), worker: of(/DedicatedWorker/) };
}

/**
 * @param {Page} page
 * @param {() => Promise<unknown>} meanwhile  returns the page's longest task: the longest delay of a click
 */
async function longest(page, meanwhile) {
  // The page before may have left garbage in the same process.
  await page.requestGC();
  const { page: all } = await tasks(page, meanwhile);
  assert.ok(all.length > 30, `${all.length} tasks`);
  return Math.max(...all);
}

/**
 * Measures on a new page.
 * @param {(page: Page) => Promise<number>} measure
 * @param {import("../tests/page/browser.mjs").Options} [options]
 * @param {string} [path]
 */
async function shown(measure, options = {}, path = "") {
  let figure = NaN;
  await onPage(
    { reducedMotion: "reduce", ...options },
    async (page) => {
      await page.waitForSelector("#counters[data-settled=true], body[data-state=ready][data-settled=true]", {
        state: "attached",
      });
      figure = await measure(page);
    },
    { path },
  );
  return figure;
}

/**
 * The median time of the frames in which something grew.
 * @param {Page} page
 * @param {() => Promise<unknown>} meanwhile
 */
async function frameOf(page, meanwhile) {
  await page.evaluate(() => performance.clearMeasures("planarium-frame"));
  await meanwhile();
  const times = await page.evaluate(() =>
    performance.getEntriesByName("planarium-frame").map(({ duration }) => duration),
  );
  assert.ok(times.length > 20, `${times.length} frames`);
  return median(times);
}

/** Makes the page's processor as slow as a phone's. @param {Page} page */
async function slow(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 4 });
}

/**
 * When the first roadmap of the page grows, milliseconds since the page was asked for.
 * @param {(page: Page) => Promise<void>} before
 */
async function firstIteration(before) {
  let time = NaN;
  await onPage(
    {},
    async (page) => {
      await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.vertices) > 4, undefined, {
        polling: 10,
        timeout: 60_000,
      });
      time = await page.evaluate(() => performance.now());
    },
    { before },
  );
  return time;
}

/** When something was first drawn on the stage, milliseconds since the page was asked for. @param {boolean} isSlow */
async function firstPicture(isSlow) {
  let time = NaN;
  await onPage(
    {},
    async (page) => {
      time = await page.evaluate(
        () =>
          new Promise((/** @type {(at: number) => void} */ resolve) => {
            const context = new OffscreenCanvas(24, 24).getContext("2d", { willReadFrequently: true });
            const look = () => {
              const canvas = /** @type {HTMLCanvasElement | null} */ (
                document.querySelector("#workspace canvas[data-layer=ground]")
              );
              if (context && canvas && canvas.width > 0) {
                context.drawImage(canvas, 0, 0, 24, 24);
                if (context.getImageData(0, 0, 24, 24).data.some((value) => value > 0))
                  return resolve(performance.now());
              }
              requestAnimationFrame(look);
            };
            look();
          }),
      );
    },
    {
      before: async (page) => {
        if (isSlow) await slow(page);
      },
    },
  );
  return time;
}

/** Prepares a roadmap; the function returned grows it to 20,000 edges. @param {Page} page */
async function growMany(page) {
  await chooseScene(page, "thicket");
  await page.selectOption("#planner", "prm");
  await setParameter(page, "samples", "3200");
  await setParameter(page, "k", "16");
  await page.locator("#speed").fill("100");
  return async () => {
    await page.click("#play");
    await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.edges) >= 20_000);
  };
}

/** @type {Figure[]} */
const FIGURES = [
  {
    name: "opening, until a roadmap grows",
    bound: 1000,
    rounds: 7,
    compares: true,
    measure: () => firstIteration(async () => {}),
  },
  {
    name: "the same on a line of 1.6 Mb/s, four times slower",
    bound: 5000,
    rounds: 3,
    compares: true,
    measure: () =>
      firstIteration(async (page) => {
        const session = await page.context().newCDPSession(page);
        await session.send("Network.emulateNetworkConditions", {
          offline: false,
          latency: 150,
          downloadThroughput: 200_000,
          uploadThroughput: 94_000,
        });
        await slow(page);
      }),
  },
  {
    name: "a frame while 20,000 edges grow",
    bound: 8,
    rounds: 3,
    measure: () => shown(async (page) => frameOf(page, await growMany(page)), { deviceScaleFactor: 2 }),
  },
  {
    name: "the same with what the browser makes of it, cpu",
    bound: 16,
    rounds: 3,
    measure: () =>
      shown(
        async (page) => {
          const grow = await growMany(page);
          await page.evaluate(() => performance.clearMeasures("planarium-frame"));
          const worked = await tasks(page, grow);
          const count = await page.evaluate(() => performance.getEntriesByName("planarium-frame").length);
          // Between the frames that grow lie small tasks: the hardest ones are taken for those that grow.
          return median(worked.page.sort((a, b) => a - b).slice(-count));
        },
        { deviceScaleFactor: 2 },
      ),
  },
  { name: "the first picture", bound: 1000, rounds: 7, compares: true, measure: () => firstPicture(false) },
  {
    name: "the first picture, on a processor four times slower",
    bound: 3000,
    rounds: 7,
    compares: true,
    measure: () => firstPicture(true),
  },
  {
    name: "the page's longest task while 20,000 edges grow, four times slower",
    bound: 50,
    rounds: 5,
    compares: true,
    measure: () =>
      shown(
        async (page) => {
          const grow = await growMany(page);
          await slow(page);
          return longest(page, grow);
        },
        { deviceScaleFactor: 2 },
      ),
  },
  {
    name: "the page's longest task meanwhile, cpu",
    bound: 50,
    rounds: 5,
    compares: true,
    measure: () => shown(async (page) => longest(page, await growMany(page)), { deviceScaleFactor: 2 }),
  },
  {
    name: "a frame of a race of four",
    bound: 8,
    rounds: 3,
    measure: () =>
      shown(async (page) => {
        await setParameter(page, "samples", "4000");
        await unfold(page, "race");
        for (const algorithm of ["prm-star", "rrt", "prm"]) {
          await page.selectOption("#rival", algorithm);
          await page.click("#add-rival");
        }
        await atRest(page);
        return frameOf(page, () => finish(page));
      }),
  },
  {
    name: "a frame while a stone is dragged",
    bound: 30,
    rounds: 5,
    measure: () =>
      shown(async (page) => {
        await openEditor(page, null);
        const at = await plane(page, 1.2);
        await page.evaluate(() => {
          const scope = /** @type {{ works: number[], requestAnimationFrame: typeof requestAnimationFrame }} */ (
            /** @type {unknown} */ (globalThis)
          );
          scope.works = [];
          const original = scope.requestAnimationFrame.bind(globalThis);
          scope.requestAnimationFrame = (then) =>
            original((now) => {
              const began = performance.now();
              then(now);
              scope.works.push(performance.now() - began);
            });
        });
        await page.mouse.move(...at(0.62, 0.5));
        await page.mouse.down();
        for (let i = 0; i < 60; i++)
          await page.mouse.move(...at(0.62 + 0.3 * Math.sin(i / 5), 0.5 + 0.3 * Math.cos(i / 7)));
        const works = await page.evaluate(
          () => /** @type {{ works: number[] }} */ (/** @type {unknown} */ (globalThis)).works,
        );
        await page.mouse.up();
        assert.ok(works.length > 10);
        return median(works);
      }),
  },
  {
    name: "any iteration of a tree of 10,000 vertices",
    bound: 100,
    rounds: 1,
    measure: () =>
      shown(async (page) => {
        await chooseScene(page, "locked");
        await page.selectOption("#planner", "rrt");
        await page.evaluate(() => {
          for (const more of document.querySelectorAll("details")) more.open = true;
        });
        await setParameter(page, "step", "0.1");
        await setParameter(page, "max_iterations", "32000");
        const { iterations, vertices } = await finish(page);
        assert.ok(vertices >= 10_000, `${vertices} vertices`);
        const times = [];
        for (const part of [0.9, 0.35, 0.99, 0.6, 0.02, 0.8, 0.5, 0.97, 0.2, 0.7, 0.45]) {
          times.push(
            await page.evaluate(
              (wanted) =>
                new Promise((/** @type {(ms: number) => void} */ resolve) => {
                  const counters = /** @type {HTMLElement} */ (document.getElementById("counters"));
                  const field = /** @type {HTMLInputElement} */ (document.getElementById("time"));
                  const began = performance.now();
                  const watch = new MutationObserver(() => {
                    if (counters.dataset.settled !== "true" || Number(counters.dataset.iterations) !== wanted) return;
                    watch.disconnect();
                    resolve(performance.now() - began);
                  });
                  watch.observe(counters, { attributes: true });
                  field.value = String(wanted);
                  field.dispatchEvent(new Event("change", { bubbles: true }));
                }),
              Math.floor(part * iterations),
            ),
          );
        }
        return median(times);
      }),
  },
  {
    name: "a frame while 1,000 trajectories are accepted",
    bound: 8,
    rounds: 3,
    measure: () =>
      shown(
        async (page) => {
          await page.click("#course-reset");
          await page.waitForSelector("body[data-settled=true] #stage[data-tried='0']");
          await page.evaluate(() => performance.clearMeasures("trajectories-frame"));
          await page.fill("#course-speed", "70");
          await page.click("#course-play");
          await page.waitForSelector("body[data-settled=true] #stage[data-status=solved]");
          const times = await page.evaluate(() =>
            performance.getEntriesByName("trajectories-frame").map(({ duration }) => duration),
          );
          assert.ok(times.length > 20);
          return median(times);
        },
        {},
        "trajectories.html",
      ),
  },
  {
    name: "neighbours of 100,000: the page's longest task, cpu",
    bound: 50,
    rounds: 3,
    measure: () =>
      shown(
        async (page) => {
          const rest = () => page.waitForSelector("body[data-settled=true][data-found]");
          for (const field of ["count", "seed-number", "option-metric", "measure"]) await reveal(page, `#${field}`);
          await page.press("#count", "End");
          await page.waitForSelector("body[data-n='100000']");
          await rest();
          return longest(page, async () => {
            await page.fill("#seed-number", "8");
            await page.locator("#seed-number").blur();
            await rest();
            await page.focus("#stage");
            for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowLeft");
            await rest();
            await page.selectOption("#index", "forest");
            await page.selectOption("#option-metric", "naive");
            await page.click("#measure");
            await page.waitForSelector("#timing[data-timing=done]");
            await rest();
          });
        },
        {},
        "neighbours.html",
      ),
  },
  {
    name: "neighbours: what is measured by one press, cpu",
    bound: 2000,
    rounds: 3,
    measure: () =>
      shown(
        async (page) => {
          const { worker: all } = await tasks(page, async () => {
            await page.click("#measure");
            await page.waitForSelector("#timing[data-timing=done]");
          });
          return all.reduce((a, b) => a + b, 0);
        },
        {},
        "neighbours.html",
      ),
  },
  {
    name: "reach: the page's longest task while an arm is dragged and solved, cpu",
    bound: 50,
    rounds: 3,
    measure: () =>
      shown(
        async (page) => {
          const box =
            (await page.locator("#workspace canvas[data-layer=top]").boundingBox()) ?? assert.fail("no canvas");
          const [x, y] = [box.x + 0.7 * box.width, box.y + 0.4 * box.height];
          return longest(page, async () => {
            await page.mouse.move(x, y);
            await page.mouse.down();
            for (let i = 0; i < 60; i++) await page.mouse.move(x - 2 * i, y + 60 * Math.sin(i / 6));
            await page.mouse.up();
            await page.locator("#link-0").focus();
            for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowRight");
            await page.waitForSelector("#stage[data-cells=true]");
            await page.click("#mode-solve");
            await page.click("#solve-finish");
            await page.waitForSelector("#solve:not([data-status=running])", { state: "attached" });
          });
        },
        { deviceScaleFactor: 2 },
        "reach.html",
      ),
  },
  {
    name: "a GIF of 100 frames, cpu",
    bound: 8000,
    rounds: 3,
    measure: () => {
      const frames = [0, 25, 50, 75].map((n) =>
        Uint8ClampedArray.from({ length: 4 * 640 * 400 }, (_, i) => {
          const [x, y] = [(i >> 2) % 640, Math.floor((i >> 2) / 640)];
          const colour =
            Math.hypot(x - 6 * n, y - 200 - 80 * Math.sin(n / 9)) < 14
              ? [n, 90, 200]
              : x % 50 === 0 || y % 50 === 0
                ? [220, 220, 224]
                : [250, 250, 250];
          return [...colour, 255][i % 4];
        }),
      );
      const writer = new GifWriter(640, 400, paletteOf(frames));
      return used(() => {
        for (let i = 0; i < 100; i++) writer.add(frames[i % 4], 40);
        writer.finish();
      });
    },
  },
  {
    name: "an SVG of 10,000 edges, cpu",
    bound: 2000,
    rounds: 5,
    measure: () =>
      used(() => {
        const random = seeded(11);
        const context = new SvgContext(800, 600);
        context.globalAlpha = 0.42;
        for (let i = 0; i < 10_000; i++) {
          context.beginPath();
          context.moveTo(800 * random.next(), 600 * random.next());
          context.lineTo(800 * random.next(), 600 * random.next());
          context.stroke();
        }
        context.toString({ background: "white" });
      }),
  },
  {
    name: "a pickle of 10 MB is refused, cpu",
    bound: 5000,
    rounds: 3,
    measure: () => {
      const head = readFileSync(join(root, "tests", "page", "fixtures", "numpy1-objects.npy"));
      const bytes = new Uint8Array(10 * 2 ** 20).fill(0x28);
      const body = 10 + head.readUInt16LE(8);
      bytes.set(head.subarray(0, body));
      bytes.set([0x80, 2, 0x5d, 0x71, 0], body);
      return used(() => assert.throws(() => readNpyPolygons(bytes)));
    },
  },
  {
    name: "a link that unpacks to 45 MB is refused, cpu",
    bound: 200,
    rounds: 9,
    measure: () => {
      const bomb = `1${deflateRawSync(" ".repeat(45e6)).toString("base64url")}`;
      return used(async () => assert.equal((await decodeLink(bomb)).experiment, null));
    },
  },
  {
    name: "the nearest of 20,000 vertices to a pointer, a thousand times, cpu",
    bound: 500,
    rounds: 9,
    measure: () => {
      const random = seeded(7);
      const points = Float64Array.from({ length: 40_000 }, () => 700 * random.next() - 20);
      const pane = { pixels: (/** @type {Float64Array} */ rows) => rows };
      const run = {
        vertices: {
          count: 20_000,
          slice: (/** @type {number} */ first, /** @type {number} */ end) => points.subarray(2 * first, 2 * end),
        },
      };
      const places = new VertexIndex(/** @type {never} */ (pane), /** @type {never} */ (run));
      places.nearest(0, 0, 1);
      return used(() => {
        for (let i = 0; i < 1000; i++) places.nearest(660 * random.next(), 660 * random.next(), 20_000);
      });
    },
  },
];

await script(async () => {
  const {
    values: { beside },
    positionals: [wanted = ""],
  } = parseArgs({ allowPositionals: true, options: { beside: { type: "string" } } });
  const figures = FIGURES.filter(({ name, compares }) => name.includes(wanted) && (compares || !beside));
  await start();
  try {
    for (const { name, bound, rounds, measure } of figures) {
      const values = [];
      const others = [];
      for (let i = 0; i < rounds; i++) {
        values.push(await measure());
        if (!beside) continue;
        await stop();
        await start(resolve(beside));
        others.push(await measure());
        await stop();
        await start();
      }
      if (beside) console.log(`${name.padEnd(72)} ${median(others).toFixed(1).padStart(8)} ms in the other build`);
      const isBeyond = !(median(values) < bound);
      console.log(
        `${name.padEnd(72)} ${median(values).toFixed(1).padStart(8)} ms, below ${bound}${isBeyond ? ": BEYOND" : ""}  (${values.map((value) => value.toFixed(1)).join(", ")})`,
      );
      if (isBeyond) process.exitCode = 1;
    }
  } finally {
    await stop();
  }
});
