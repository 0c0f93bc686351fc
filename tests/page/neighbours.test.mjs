/**
 * The page of nearest neighbours: asked, dragged, measured, fed with lists, linked and taken away, on a desk and on a
 * phone.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import { encodeState } from "../../www/app/link.js";
import { writeNpy } from "../../www/formats/npy.js";
import { ROBOTS } from "../../www/neighbours/robots.js";
import {
  DESK,
  PHONE,
  download,
  dropFile,
  fill,
  isDeep,
  linkOf,
  onPage,
  pickFile,
  pixelsOf,
  reveal,
  useBrowser,
} from "./browser.mjs";
import { drag, plane } from "./editing.mjs";
import { open as openScene, sceneOf, textOf } from "./library.mjs";
import { fixture } from "./npy.mjs";
import { roomOf } from "./reach.mjs";
import { allOf, readXml } from "./xml.mjs";

/** @import { NeighboursOptions } from "planarium" */
/** @import { Options, Page } from "./browser.mjs" */

useBrowser();

const {
  onRoom: onNeighbours,
  rest,
  click,
  press,
  choose,
  put,
} = roomOf("neighbours", "body[data-state=ready][data-settled=true][data-found]", "robot");

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

/** @param {string} id */
const robotOf = (id) => ROBOTS.find((entry) => entry.id === id) ?? assert.fail(id);

/** @param {Page} page @param {string} id @param {string} value */
async function select(page, id, value) {
  await page.selectOption(`#${id}`, value);
  await rest(page);
}

/** What the page says of itself. @param {Page} page */
const stateOf = async (page) =>
  /** @type {Record<string, string>} */ (await page.evaluate(() => ({ ...document.body.dataset })));

/** @param {string} [text] */
const numbers = (text = "") => (text === "" ? [] : text.split(",").map(Number));

/**
 * What the package finds for what the page shows.
 * @param {Record<string, string>} state
 * @param {NeighboursOptions} [options]
 * @param {Float64Array | number[][]} [list]
 */
function foundBy({ robot, n, q, k }, options = { index: "linear" }, list) {
  const scenario = Scenario.parse(robotOf(robot).document);
  const index = scenario.neighbours(options);
  index.add(list ?? scenario.sampleConfigurations(Number(n), { seed: 0, free: true }));
  const found = index.nearest(numbers(q), Number(k));
  index.free();
  scenario.free();
  return found;
}

/**
 * Where a point of the world is, in pixels of the window.
 * @param {Page} page
 * @param {string} id
 * @param {number[]} point
 */
const windowOf = async (page, id, [x, y]) => (await plane(page, Scenario.parse(robotOf(id).document).extent()))(x, y);

test("every preset of a robot shows what a scan finds; an arm opens where the naive metric is wrong", () =>
  onNeighbours(async (page) => {
    for (const { id, presets, q, k, document } of ROBOTS) {
      await choose(page, id);
      const first = await stateOf(page);
      const scenario = Scenario.parse(document);
      assert.ok(scenario.distance(numbers(first.q), q) < 1e-9 && first.k === String(k), id);
      if (document.robot.type === "arm") {
        await select(page, "option-metric", "naive");
        assert.ok(Number((await stateOf(page)).missed) > 0, id);
        assert.match(await page.innerText("#story"), /(is|are) wrong/);
        await select(page, "option-metric", "sum");
      }
      for (const i of presets.keys()) {
        await select(page, "preset", String(i));
        const state = await stateOf(page);
        assert.equal(state.k, String(presets[i][1]));
        assert.ok(scenario.distance(numbers(state.q), presets[i][0]) < 1e-9);
        const expected = foundBy(state);
        assert.deepEqual(numbers(state.found), [...expected.indices], `${id}, question ${i}`);
        assert.equal(state.missed, "0");
        const rows = await page
          .locator("#neighbours tbody tr")
          .evaluateAll((all) => all.map((row) => /** @type {HTMLElement} */ (row).dataset.distance));
        assert.deepEqual(rows.map(Number), [...expected.distances]);
        assert.equal(await page.inputValue("#preset"), String(i));
      }
      scenario.free();
    }
  }));

test("the naive metric misleads: what it misses and what it finds wrongly is said and marked", () =>
  onNeighbours(async (page) => {
    await put(page, "q0-number", 0.02);
    await put(page, "q1-number", -0.03);
    await put(page, "k-number", 12);
    await select(page, "option-metric", "naive");
    const state = await stateOf(page);
    const [naive, meant] = /** @type {const} */ (["naive", "sum"]).map(
      (metric) => foundBy(state, { index: "linear", metric }).indices,
    );
    assert.deepEqual(numbers(state.found), [...naive]);
    const missed = [...meant].filter((one) => !naive.includes(one)).length;
    assert.ok(missed > 0, "the target is at the cut");
    assert.equal(state.missed, String(missed));
    assert.match(await page.innerText("#story"), /naive metric .* cuts each circle at 0/);
    assert.equal(await page.locator("#neighbours tr[data-right=false]").count(), missed);
    assert.equal(await page.innerText("#fact-recall"), `${12 - missed} of 12`);
    for (const pane of ["workspace", "cspace"]) assert.ok((await pixelsOf(page, pane, "top", "rejected")) > 10, pane);
    await select(page, "option-metric", "euclidean");
    const euclidean = await stateOf(page);
    assert.deepEqual(numbers(euclidean.found), [...foundBy(state, { metric: "euclidean" }).indices]);
    assert.equal(euclidean.missed, "0");
    assert.equal(await pixelsOf(page, "cspace", "top", "rejected"), 0);
  }));

test("a kd-tree without wrap-around misses what lies across pi: said, marked, drawn up to the border, and in a link", () =>
  onNeighbours(
    async (page) => {
      await put(page, "q0-number", 3.1);
      await put(page, "q1-number", 1);
      await put(page, "k-number", 12);
      const right = await stateOf(page);
      assert.equal(right.missed, "0");
      await select(page, "index", "kd-tree-unwrapped");
      const state = await stateOf(page);
      const [plain, meant] = /** @type {const} */ (["kd-tree-unwrapped", "linear"]).map(
        (index) => foundBy(state, { index }).indices,
      );
      assert.deepEqual([numbers(state.found), numbers(right.found)], [[...plain], [...meant]]);
      const missed = [...meant].filter((one) => !plain.includes(one)).length;
      assert.ok(missed > 0, "the target is at the seam");
      assert.equal(state.missed, String(missed));
      assert.match(
        await page.innerText("#story"),
        new RegExp(`This kd-tree .* cuts each circle at \u03c0\\. Of its 12 neighbours ${missed} `),
      );
      assert.equal(await page.locator("#neighbours tr[data-right=false]").count(), missed);
      assert.equal(await page.innerText("#fact-recall"), `${12 - missed} of 12`);
      for (const pane of ["workspace", "cspace"]) assert.ok((await pixelsOf(page, pane, "top", "rejected")) > 10, pane);
      await onNeighbours(async (other) => assert.deepEqual(await stateOf(other), state), DESK, {
        path: `neighbours.html${await linkOf(page)}`,
      });
      await select(page, "option-metric", "naive");
      assert.match(await page.innerText("#story"), /The naive metric .* cuts each circle at 0/);
      await select(page, "option-metric", "sum");
      await put(page, "q0-number", 1.5);
      assert.match(
        await page.innerText("#story"),
        /Here it happens to be right\. Move a joint near \u03c0 to see it fail\./,
      );
      await choose(page, "point");
      assert.deepEqual([(await stateOf(page)).index, (await stateOf(page)).missed], ["kd-tree-unwrapped", "0"]);
      assert.match(await page.innerText("#story"), /^The kd-tree visited .* to find the 8 nearest\.$/);
    },
    { ...DESK, permissions: ["clipboard-read", "clipboard-write"] },
  ));

test("scan, tree and forest: how many they visit, and what a forest misses", () =>
  onNeighbours(async (page) => {
    await choose(page, "four");
    await put(page, "count-number", 5000);
    await put(page, "k-number", 40);
    const tree = await stateOf(page);
    assert.ok(Number(tree.visited) < 5000);
    await select(page, "index", "linear");
    const scan = await stateOf(page);
    assert.deepEqual([scan.visited, scan.found], ["5000", tree.found]);
    await select(page, "index", "forest");
    await put(page, "option-candidates", 45);
    await put(page, "option-trees", 2);
    const forest = await stateOf(page);
    const expected = foundBy(forest, { index: "forest", trees: 2, candidates: 45 });
    assert.deepEqual([numbers(forest.found), Number(forest.visited)], [[...expected.indices], expected.visited]);
    assert.equal(Number(forest.missed), numbers(tree.found).filter((one) => !expected.indices.includes(one)).length);
    assert.ok(Number(forest.missed) > 0);
    assert.match(await page.innerText("#story"), new RegExp(`missed ${forest.missed} of the 40 nearest`));
    await select(page, "index", "kd-tree");
    assert.equal((await stateOf(page)).found, tree.found, "what only a forest takes is no trouble to a tree");
    await select(page, "index", "forest");
    assert.equal((await stateOf(page)).found, forest.found, "and is there again");
    await fill(page, "#option-trees", "65");
    assert.match(await page.innerText("#option-trees-reason"), /65 is above 64/);
    assert.equal((await stateOf(page)).found, forest.found);
  }));

test("lists are drawn by number and seed, free or not, up to 100,000, which stay in hand", () =>
  onNeighbours(async (page) => {
    const first = await stateOf(page);
    await put(page, "seed-number", 7);
    assert.notEqual((await stateOf(page)).found, first.found);
    await click(page, "#free");
    const scenario = Scenario.parse(robotOf("two").document);
    assert.deepEqual(numbers((await stateOf(page)).found), [
      ...foundBy(first, {}, scenario.sampleConfigurations(500, { seed: 7 })).indices,
    ]);
    await page.press("#count", "End");
    await page.waitForSelector("body[data-n='100000']");
    await rest(page);
    const many = await stateOf(page);
    assert.deepEqual(numbers(many.found), [
      ...foundBy(many, {}, scenario.sampleConfigurations(100_000, { seed: 7 })).indices,
    ]);
    assert.ok(Number(many.visited) < 1000);
    for (const value of ["0", "100001", "1.5", ""]) {
      await fill(page, "#count-number", value);
      assert.notEqual(await page.innerText("#count-reason"), "", value);
    }
    assert.equal((await stateOf(page)).n, "100000");
    scenario.free();
  }));

for (const [name, options] of /** @type {[string, Options][]} */ ([
  ["on a desktop", DESK],
  ["on a phone", PHONE],
])) {
  test(`${name}, the target is dragged in the workspace, and the neighbours follow`, () =>
    onNeighbours(async (page) => {
      for (const [id, handle, to] of /** @type {[string, (q: number[]) => number[], number[]][]} */ ([
        ["two", (q) => Scenario.parse(robotOf("two").document).endEffector(q), [-0.3, 0.9]],
        ["body", (q) => q.slice(0, 2), [0.6, 0.7]],
        ["point", (q) => q, [1.7, 0.3]],
      ])) {
        await choose(page, id);
        const was = await stateOf(page);
        await drag(page, [await windowOf(page, id, handle(numbers(was.q))), await windowOf(page, id, to)]);
        await rest(page);
        const state = await stateOf(page);
        const q = numbers(state.q);
        if (id === "two")
          assert.ok(q[0] === numbers(was.q)[0] && q[1] !== numbers(was.q)[1], "a link's end turns its own joint");
        else assert.ok(Math.hypot(q[0] - to[0], q[1] - to[1]) < 0.02, `${id}: ${state.q}`);
        assert.deepEqual(numbers(state.found), [...foundBy(state).indices], id);
      }
    }, options));

  test(
    `${name}, the target is put anywhere on the square, moved by keys, by sliders and by numbers`,
    { skip: options === PHONE && !isDeep },
    () =>
      onNeighbours(async (page) => {
        const canvas = page.locator("#cspace canvas[data-layer=top]");
        await canvas.scrollIntoViewIfNeeded();
        const box = (await canvas.boundingBox()) ?? assert.fail("no canvas");
        await page.mouse.click(box.x + 34 + (box.width - 46) / 2, box.y + 12 + (box.height - 44) / 2);
        await rest(page);
        const middle = await stateOf(page);
        assert.ok(
          numbers(middle.q).every((angle) => Math.abs(angle) < 0.03),
          middle.q,
        );
        assert.deepEqual(numbers(middle.found), [...foundBy(middle).indices]);
        await press(page, "#stage", "ArrowRight", "Shift+ArrowUp");
        const moved = numbers((await stateOf(page)).q).map((angle, i) => angle - numbers(middle.q)[i]);
        assert.ok(
          Math.abs(moved[0] - 0.01 * Math.PI) < 1e-9 && Math.abs(moved[1] - 0.1 * Math.PI) < 1e-9,
          moved.join(),
        );
        await press(page, "#q0", "Home");
        assert.ok(Math.abs(Math.abs(numbers((await stateOf(page)).q)[0]) - Math.PI) < 1e-9);
        await put(page, "q1-number", -1.25);
        const state = await stateOf(page);
        assert.equal(numbers(state.q)[1], -1.25);
        assert.deepEqual(numbers(state.found), [...foundBy(state).indices]);
        await fill(page, "#q1-number", "4");
        assert.match(await page.innerText("#q1-reason"), /4 is above/);
      }, options),
  );
}

const LIST = [
  [3, 0],
  [-3, 0.5],
  [0, 0],
  [-3, 0],
  [3, 0],
];

test("JSON and arrays of NumPy's are taken, picked or dropped, in their order", () =>
  onNeighbours(async (page) => {
    await pickFile(page, "mine.json", JSON.stringify(LIST));
    await page.waitForSelector("body[data-source=file][data-n='5']");
    await rest(page);
    const state = await stateOf(page);
    assert.deepEqual(numbers(state.found), [...foundBy(state, {}, LIST).indices]);
    assert.match(await page.innerText("#list-told"), /mine\.json: 5 configurations/);
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
  }));

test("whatever else is refused with a reason, and the list of before stays", () =>
  onNeighbours(async (page) => {
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
    assert.deepEqual(numbers((await stateOf(page)).found), [...foundBy({ ...was, k: "3" }).indices], "and it goes on");
  }));

test("times, visits and recall, as table, chart and file", () =>
  onNeighbours(async (page) => {
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
    assert.match((await page.getAttribute(".chart", "aria-label")) ?? "", /Query time with [\d,]+ configurations: /);
    await page.click("#export-fold > summary");
    const lines = (await download(page, "#export-timings")).text.trim().split("\r\n");
    assert.equal(lines[0], "n,index,build_seconds,query_seconds,visited,recall");
    assert.equal(lines.length - 1, cells.filter(({ of, has }) => of === "query" && has).length);
    await put(page, "k-number", 11);
    assert.match(await page.innerText("#measured"), /other settings/);
  }));

test("a link shows the same again", () =>
  onNeighbours(
    async (page) => {
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
    { ...DESK, permissions: ["clipboard-read", "clipboard-write"] },
  ));

test("a link holds a short list from a file, and says that it leaves out a long one", () =>
  onNeighbours(
    async (page) => {
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
    { ...DESK, permissions: ["clipboard-read", "clipboard-write"] },
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

test("five free bodies alone; weights of a preset and by hand; a dropped scenario; all in the link", () =>
  onNeighbours(
    async (page) => {
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
    { ...DESK, permissions: ["clipboard-read", "clipboard-write"] },
  ));

test("picture, drawing and table hold what is shown", () =>
  onNeighbours(async (page) => {
    await page.click("#export-fold > summary");
    assert.equal((await download(page, "#export-png")).bytes.subarray(1, 4).toString(), "PNG");
    assert.ok(allOf(readXml((await download(page, "#export-svg")).text), "path").length > 20);
    const state = await stateOf(page);
    const { indices, distances } = foundBy(state);
    const lines = (await download(page, "#export-csv")).text.trim().split("\r\n");
    assert.equal(lines[0], 'rank,number,distance,"joint 1","joint 2"');
    assert.deepEqual(
      lines.slice(1).map((line) => line.split(",").slice(0, 3).map(Number)),
      [...indices].map((one, i) => [i + 1, one, distances[i]]),
    );
  }));
