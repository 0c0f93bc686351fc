/** The page of nearest neighbours: lists and scenarios that it is given, and what is measured, taken away and linked. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import { encodeState } from "../../www/app/link.js";
import { writeNpy } from "../../www/formats/npy.js";
import { DESK, download, dropFile, linkOf, onPage, pickFile, pixelsOf, reveal, useBrowser } from "./browser.mjs";
import { open as openScene, sceneOf, textOf } from "./library.mjs";
import { fixture } from "./npy.mjs";
import { allOf, readXml } from "./xml.mjs";
import { inTurn } from "./turns.mjs";
import { onNeighbours, rest, click, choose, put, putBack, select, stateOf, numbers, foundBy } from "./neighbours.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/** A body in a world that one obstacle fills, for five configurations. */
const FULL = await encodeState(
  {
    document: {
      ...JSON.parse(textOf("corner")),
      queries: [],
      world: {
        bounds: { min: [0, 0], max: [1, 1] },
        obstacles: [
          {
            type: "polygon",
            vertices: [
              [0, 0],
              [1, 0],
              [1, 1],
              [0, 1],
            ],
          },
        ],
      },
    },
    draw: { n: 5, seed: 0, free: true },
  },
  () => {},
);

const LIST = [
  [3, 0],
  [-3, 0.5],
  [0, 0],
  [-3, 0],
  [3, 0],
];

test("lists of one's own", (t) =>
  onNeighbours(
    inTurn(
      t,
      {
        "JSON and arrays of NumPy's are taken, picked or dropped, in their order": async (page) => {
          await pickFile(page, "mine.json", JSON.stringify(LIST));
          await page.waitForSelector("body[data-source=file][data-n='5']");
          await rest(page);
          const state = await stateOf(page);
          assert.deepEqual(numbers(state.found), [...foundBy(state, {}, LIST).indices]);
          assert.match(await page.innerText("#list-told"), /mine\.json: 5 configurations/);
          await dropFile(page, "mine.txt", JSON.stringify(LIST.slice(2)));
          await page.waitForSelector("body[data-source=file][data-n='3']");
          await rest(page);
          await dropFile(page, "mine.npy", writeNpy(Float64Array.from(LIST.slice(1).flat()), [4, 2]));
          await page.waitForSelector("body[data-source=file][data-n='4']");
          await rest(page);
          const dropped = await stateOf(page);
          assert.deepEqual(numbers(dropped.found), [...foundBy(dropped, {}, LIST.slice(1)).indices]);
          await pickFile(page, "one.npy", fixture("numpy1-one"));
          await page.waitForSelector("body[data-n='3']");
          await rest(page);
          await choose(page, "four");
          assert.equal((await stateOf(page)).source, "drawn");
          await pickFile(page, "third.npy", fixture("numpy1-third"));
          await page.waitForSelector("body[data-source=file][data-n='3']");
          await put(page, "count-number", 300);
          assert.deepEqual([(await stateOf(page)).source, (await stateOf(page)).n], ["drawn", "300"]);
        },

        "whatever else is refused with a reason, and the list of before stays": async (page) => {
          const was = await stateOf(page);
          for (const [name, content, code, words] of /** @type {[string, Uint8Array | string, string, RegExp][]} */ ([
            ["objects.npy", fixture("numpy1-objects"), "invalid-npy", /./],
            ["complex.npy", fixture("numpy1-complex"), "invalid-npy", /./],
            ["solid.npy", fixture("numpy1-c"), "wrong-dimension", /two dimensions/],
            ["scalar.npy", fixture("numpy1-scalar"), "wrong-dimension", /two dimensions/],
            ["third.npy", fixture("numpy1-third"), "wrong-dimension", /2 numbers; the rows of this array have 4/],
            ["none.npy", writeNpy(new Float64Array(), [0, 2]), "out-of-range", /no configuration/],
            ["nan.npy", writeNpy(Float64Array.of(0, 0, NaN, 0), [2, 2]), "not-finite", /./],
            ["huge.npy", writeNpy(Float64Array.of(0, 0, 1e7, 0), [2, 2]), "out-of-range", /./],
            ["cut.npy", fixture("numpy1-one").subarray(0, 90), "invalid-npy", /./],
            ["text.json", "hello", "invalid-json", /neither JSON nor/],
            ["object.json", "{}", "wrong-type", /array of arrays/],
            ["row.json", "[[0, 0], 3]", "wrong-type", /Configuration 1/],
            ["short.json", "[[0, 0], [1]]", "wrong-dimension", /configuration 1 has 1/],
            ["word.json", '[[0, 0], [1, "2"]]', "wrong-type", /Number 1 of configuration 1/],
            ["many.json", `[${"[0,0],".repeat(100_000)}[0,0]]`, "too-large", /100001/],
          ])) {
            await pickFile(page, name, content);
            await page.waitForFunction(
              (file) => document.querySelector("#notice:not([hidden])")?.textContent?.includes(file),
              name,
            );
            assert.equal(await page.getAttribute("#notice", "data-code"), code, name);
            assert.match(await page.innerText("#notice"), words, name);
            await rest(page);
            const { n, source, found } = await stateOf(page);
            assert.deepEqual([n, source, found], [was.n, "drawn", was.found], name);
          }
          await put(page, "k-number", 3);
          assert.deepEqual(
            numbers((await stateOf(page)).found),
            [...foundBy({ ...was, k: "3" }).indices],
            "and it goes on",
          );
        },
      },
      putBack,
    ),
  ));

test("neighbours are measured, taken away and linked", (t) =>
  onNeighbours(
    inTurn(
      t,
      {
        "times, visits and recall, as table, chart and file": async (page) => {
          await choose(page, "four");
          await put(page, "k-number", 10);
          // On a machine with other things to do it stops earlier, and goes on when it is asked to.
          do {
            await page.click("#measure");
            await page.waitForSelector("#timing[data-timing=done]");
            await rest(page);
          } while ((await page.locator("#timings tr[data-n='2000'] td:not([data-value=''])").count()) < 9);
          assert.ok(Number(await page.getAttribute("#timing", "data-seconds")) > 0);
          const cells = await page.locator("#timings td").evaluateAll((all) =>
            all.map((cell) => {
              const { index, of, value } = /** @type {HTMLElement} */ (cell).dataset;
              return {
                n: Number(/** @type {HTMLElement} */ (cell.parentElement).dataset.n),
                index,
                of,
                value: Number(value),
                has: value !== "",
              };
            }),
          );
          const at = (/** @type {string} */ of, /** @type {string} */ index, /** @type {number} */ n) =>
            cells.find((cell) => cell.of === of && cell.index === index && cell.n === n);
          assert.deepEqual(
            [...new Set(cells.map(({ n }) => n))].slice(0, 4),
            [100, 500, 1000, 2000],
            "those of the reports first",
          );
          for (const { of, value, has } of cells.filter((cell) => cell.has)) {
            if (of === "recall") assert.ok(value > 0.3 && value <= 1);
            else assert.ok((has && value > 0) || (of === "build" && value >= 0), `${of} ${value}`);
          }
          assert.ok(Number(at("visited", "kd-tree", 2000)?.value) < 2000);
          assert.ok(Number(at("visited", "forest", 2000)?.value) >= 400);
          await page.waitForSelector(".chart .line");
          assert.equal(await page.locator(".chart .line").count(), 3);
          assert.match(
            (await page.getAttribute(".chart", "aria-label")) ?? "",
            /Query time with [\d,]+ configurations: /,
          );
          await page.click("#export-fold > summary");
          const lines = (await download(page, "#export-timings")).text.trim().split("\r\n");
          assert.equal(lines[0], "n,index,build_seconds,query_seconds,visited,recall");
          assert.equal(lines.length - 1, cells.filter(({ of, has }) => of === "query" && has).length);
          await put(page, "k-number", 11);
          assert.match(await page.innerText("#measured"), /other settings/);
        },

        "a link shows the same again": async (page) => {
          await choose(page, "three");
          await put(page, "count-number", 2345);
          await put(page, "seed-number", 12);
          await page.click("#free");
          await select(page, "index", "forest");
          await put(page, "option-candidates", 77);
          await select(page, "option-metric", "euclidean");
          await put(page, "q2-number", -1.5);
          await put(page, "k-number", 17);
          const [state, fragment] = [await stateOf(page), await linkOf(page)];
          await page.getByText(/It stores the scenario, the sampling, the target and the query\./).waitFor();
          await onNeighbours(
            async (other) => {
              assert.deepEqual(await stateOf(other), state);
              assert.equal(await other.inputValue("#option-candidates"), "77");
              assert.equal(await other.inputValue("#count-number"), "2345");
              assert.equal(await other.isChecked("#free"), false);
            },
            DESK,
            { path: `neighbours.html${fragment}` },
          );
        },

        "a link holds a short list from a file, and says that it leaves out a long one": async (page) => {
          const rows = Array.from({ length: 60 }, (_, i) => [Math.sin(i), Math.cos(3 * i)]);
          await pickFile(page, "own.json", JSON.stringify(rows));
          await page.waitForSelector("body[data-source=file]");
          await rest(page);
          await put(page, "k-number", 7);
          const [state, fragment] = [await stateOf(page), await linkOf(page)];
          await page.getByText(/It stores the scenario, your list, the target and the query\./).waitFor();
          assert.deepEqual(numbers(state.found), [...foundBy(state, undefined, rows).indices]);
          await onNeighbours(
            async (other) => {
              assert.deepEqual(await stateOf(other), state);
              assert.match(await other.innerText("#list-told"), /^own\.json: 60 configurations/);
              assert.equal(await linkOf(other), fragment);
            },
            DESK,
            { path: `neighbours.html${fragment}` },
          );
          await pickFile(
            page,
            "long.json",
            JSON.stringify(Array.from({ length: 400 }, (_, i) => [Math.sin(i), Math.cos(3 * i)])),
          );
          await page.waitForSelector("body[data-source=file][data-n='400']");
          await rest(page);
          const without = await linkOf(page);
          await page.getByText(/Your list is too long for a link and is not included/).waitFor();
          await onNeighbours(async (other) => assert.equal((await stateOf(other)).source, "drawn"), DESK, {
            path: `neighbours.html${without}`,
          });
        },

        "five free bodies alone; weights of a preset and by hand; a dropped scenario; all in the link": async (
          page,
        ) => {
          await dropFile(page, "corner.json", textOf("corner"));
          await page.waitForSelector("body[data-robot=file]");
          await rest(page);
          await put(page, "count-number", 5);
          assert.equal(await page.inputValue("#pairs"), "0.7,0.3", "the core's");
          const [first] = await page.locator("#neighbours td:last-child").allInnerTexts();
          await select(page, "pairs", "0.7,0.15");
          assert.equal(await page.inputValue("#radian-number"), "0.150");
          assert.notEqual((await page.locator("#neighbours td:last-child").allInnerTexts())[0], first);
          await put(page, "metre-number", "0.5");
          assert.equal(await page.inputValue("#pairs"), "");
          await click(page, "label[for=ask]");
          assert.equal(
            await page.innerText("#story"),
            "5 collision-free configurations, sampled uniformly with seed 0; each reference point is marked.",
          );
          assert.deepEqual(
            [
              await pixelsOf(page, "workspace", "top", "robot"),
              await page.isVisible("#neighbours"),
              await page.isVisible("#target"),
            ],
            [0, false, false],
          );
          assert.ok((await pixelsOf(page, "workspace", "ground", "growth")) > 200);
          const [state, fragment] = [await stateOf(page), await linkOf(page)];
          assert.deepEqual([state.weights, state.ask, state.n], ["0.5,0.15", "false", "5"]);
          await onNeighbours(async (other) => assert.deepEqual(await stateOf(other), state), DESK, {
            path: `neighbours.html${fragment}`,
          });
          await click(page, "label[for=ask]");
          assert.ok((await pixelsOf(page, "workspace", "top", "robot")) > 100);
          await pickFile(page, "bad.json", JSON.stringify({ format: "planarium-scenario-1", name: "bad" }));
          await page.waitForSelector("#notice[data-code=missing-field]");
          assert.equal((await stateOf(page)).robot, "file");
        },

        "picture, drawing and table hold what is shown": async (page) => {
          await page.click("#export-fold > summary");
          assert.equal((await download(page, "#export-png")).bytes.subarray(1, 4).toString(), "PNG");
          const svg = readXml((await download(page, "#export-svg")).text);
          assert.ok(allOf(svg, "path").length > 20);
          const entry = (await page.locator(".legend li:visible").first().innerText()).trim();
          assert.ok(allOf(svg, "text").some(({ children }) => children.join("") === entry));
          const state = await stateOf(page);
          const { indices, distances } = foundBy(state);
          const lines = (await download(page, "#export-csv")).text.trim().split("\r\n");
          assert.equal(lines[0], 'rank,number,distance,"joint 1","joint 2"');
          assert.deepEqual(
            lines.slice(1).map((line) => line.split(",").slice(0, 3).map(Number)),
            [...indices].map((one, i) => [i + 1, one, distances[i]]),
          );
        },
      },
      putBack,
    ),
  ));

test("a list in a link that is of another robot is refused in words, and one is sampled", async () => {
  const fragment = await encodeState(
    {
      robot: "two",
      q: [0, 0],
      k: 3,
      list: {
        name: "odd.json",
        rows: [
          [1, 2],
          [1, 2, 3],
        ],
      },
    },
    () => {},
  );
  await onNeighbours(
    async (page) => {
      assert.match(await page.innerText("#notice"), /odd\.json could not be read.*\n*.*configuration 1 has 3/);
      assert.deepEqual([(await stateOf(page)).source, (await stateOf(page)).n], ["drawn", "500"]);
    },
    DESK,
    { path: `neighbours.html#${fragment}` },
  );
});

/**
 * The state of a page that a fragment opens, and its stage's dots in the workspace.
 * @param {object} state
 * @param {(page: Page, state: Record<string, string>) => Promise<void>} check
 */
async function onState(state, check) {
  await onNeighbours(
    async (page) => {
      assert.equal(await page.isHidden("#notice"), true, await page.innerText("#notice"));
      await check(page, await stateOf(page));
    },
    DESK,
    { path: `neighbours.html#${await encodeState(state, () => {})}` },
  );
}

test("a few configurations of any scenario: of a scene by its name, of a document, of a file, with weights", async () => {
  const body = JSON.parse(textOf("corner"));
  const draw = { n: 5, seed: 3, free: true };
  for (const [state, robot, document] of /** @type {const} */ ([
    [{ scene: "corner", draw }, "corner", body],
    [{ scene: "museum", draw: { ...draw, n: 1 } }, "museum", JSON.parse(textOf("museum"))],
    [{ scene: "crates", draw }, "crates", openScene(sceneOf("crates")).document()],
    [
      { document: body, draw, weights: [0.7, 0.15] },
      "file",
      { ...body, robot: { ...body.robot, metric: { translation: 0.7, rotation: 0.15 } } },
    ],
  ])) {
    await onState(state, async (page, shown) => {
      assert.deepEqual([shown.robot, shown.n, shown.ask], [robot, String(state.draw.n), "true"]);
      const scenario = Scenario.parse(document);
      const index = scenario.neighbours();
      index.add(scenario.sampleConfigurations(state.draw.n, { seed: 3, free: true }));
      const found = index.nearest(numbers(shown.q), Number(shown.k));
      assert.deepEqual(numbers(shown.found), [...found.indices]);
      const rows = await page
        .locator("#neighbours tbody tr")
        .evaluateAll((all) => all.map((row) => /** @type {HTMLElement} */ (row).dataset.distance));
      assert.deepEqual(rows.map(Number), [...found.distances], robot);
      assert.equal(await page.isVisible("#weights"), scenario.dimension === 3);
    });
  }
});

test("a scenario without room is opened, and said to have no free configuration", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await page.waitForSelector("body[data-state=ready][data-settled=true] #notice[data-code=unsupported]");
      assert.match(await page.innerText("#notice"), /No configurations could be sampled[^]*none is free/);
      assert.equal(await page.innerText("#story"), "There are no configurations.");
      await reveal(page, "#free");
      await page.click("label[for=free]");
      await rest(page);
      assert.equal((await stateOf(page)).n, "5");
    },
    { path: `neighbours.html#${FULL}` },
  ));
