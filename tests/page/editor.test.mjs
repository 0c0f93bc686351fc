/** The editor in a real browser: pointer, finger and keyboard; what is refused, undone, saved and opened again. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  MOBILE,
  alphaOf,
  atRest,
  choosePlanner,
  chooseScene,
  counters,
  finish,
  keys,
  onPage,
  onPausedPage,
  openScenario,
  passes,
  pickFile,
  pixelsOf,
  setParameter,
  textMatches,
  useBrowser,
} from "./browser.mjs";
import { drag, enter, near, openEditor, plane, press, saved, swipe, told, until } from "./editing.mjs";
import { endsOf, textOf } from "./library.mjs";
import { assertFaultless } from "./looks.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

useBrowser();

/** A square world with one disc and one triangle, for a disc robot: pixels differ clearly. @type {ScenarioDocument} */
const PLAIN = {
  format: "planarium-scenario-1",
  name: "plain",
  title: "Plain",
  world: {
    bounds: { min: [-1, -1], max: [1, 1] },
    obstacles: [
      { type: "disc", center: [0.5, 0.5], radius: 0.15 },
      {
        type: "polygon",
        vertices: [
          [-0.6, -0.2],
          [0, -0.2],
          [-0.3, 0.3],
        ],
      },
    ],
  },
  robot: { type: "disc", radius: 0.05 },
  queries: [{ name: "across", start: [-0.8, 0.7], goal: [0.8, -0.7] }],
};

/** @typedef {(page: Page, at: Awaited<ReturnType<typeof plane>>) => Promise<void>} Act */

/** The editor on the plain scenario. @param {Act} act @param {ScenarioDocument} [document] */
const onPlain = (act, document = PLAIN) =>
  onPausedPage(async (page) => {
    await openEditor(page, document);
    await act(page, await plane(page, 1));
  });

/** The editor on the scene that the page opens with. @param {Act} act */
const onStones = (act) =>
  onPausedPage(async (page) => {
    await openEditor(page, null);
    await act(page, await plane(page, 1.2));
  });

/**
 * Does the picture of the configuration space show an obstacle at two angles?
 * @param {Page} page
 * @param {number} across
 * @param {number} up
 */
async function isBlocked(page, across, up) {
  const { width, height, alpha } = await alphaOf(page, "cspace", "ground");
  const ratio = await page.evaluate(() => devicePixelRatio);
  const x = 34 * ratio + ((across + Math.PI) / (2 * Math.PI)) * (width - 46 * ratio);
  const y = 12 * ratio + ((Math.PI - up) / (2 * Math.PI)) * (height - 44 * ratio);
  return alpha[Math.round(y) * width + Math.round(x)] > 128;
}

test("the roadmap of a lazy planner is repaired while an obstacle is dragged, and when that is undone", () =>
  onPausedPage(async (page) => {
    await openScenario(page, PLAIN);
    await choosePlanner(page, "lazy-prm", "samples");
    await setParameter(page, "samples", "300");
    const before = await finish(page);
    await openEditor(page, null);
    const at = await plane(page, 1);
    await drag(page, [at(0.5, 0.5), at(0.2, 0.2), at(0, 0.05)], 1);
    const after = await atRest(page);
    assert.deepEqual([after.status, after.vertices, after.phase], ["solved", before.vertices, "done"]);
    assert.ok(after.length > before.length, "the disc is in the way now");
    await drag(page, [at(0, 0.05), at(-0.8, 0.7)], 2);
    await textMatches(page, "#story", /start is in collision/);
    await press(page, ["Control+z"], "undo", 1);
    const undone = await atRest(page);
    assert.deepEqual([undone.status, undone.length], ["solved", after.length]);
  }));

test("things, their handles and vertices are dragged; each gesture is one edit", () =>
  onPlain(async (page, at) => {
    for (const [i, [from, to]] of /** @type {[number, number][][]} */ ([
      [
        [0.5, 0.5],
        [0.2, 0.6],
      ],
      [
        [0.35, 0.6],
        [0.45, 0.6],
      ],
      [
        [-0.3, 0],
        [-0.4, -0.3],
      ],
      [
        [-0.4, 0],
        [-0.4, 0.2],
      ],
      [
        [-0.4, -0.5],
        [-0.4, -0.7],
      ],
      [
        [-0.8, 0.7],
        [-0.7, 0.8],
      ],
      [
        [0.8, -0.7],
        [0.6, -0.7],
      ],
    ]).entries()) {
      await drag(page, [at(...from), at(...to)], i + 1);
    }
    const {
      document: { world, queries },
      text,
    } = await saved(page);
    const [disc, polygon] = world.obstacles;
    assert.ok(disc.type === "disc" && polygon.type === "polygon");
    disc.center.forEach((value, k) => near(value, [0.2, 0.6][k]));
    near(disc.radius, 0.25);
    assert.equal(polygon.vertices.length, 4, "a middle that is dragged becomes a vertex");
    [
      [-0.7, -0.5],
      [-0.4, -0.7],
      [-0.1, -0.5],
      [-0.4, 0.2],
    ].forEach((point, i) => point.forEach((value, k) => near(polygon.vertices[i][k], value, 0.02)));
    near(queries[0].start[0], -0.7);
    near(endsOf(queries[0])[1][0], 0.6);
    for (const number of text.match(/-?\d+\.\d+/g) ?? [])
      assert.ok(number.replace(/^.*\./, "").length <= 4, `${number} is readable`);
    assert.deepEqual(
      { ...(await counters(page)), fingerprint: "", length: 0 },
      { status: "running", phase: "sampling", iterations: 0, vertices: 2, edges: 0, fingerprint: "", length: 0 },
    );
  }));

test("discs, rectangles and polygons are drawn; Shift snaps", () =>
  onPlain(async (page, at) => {
    await page.click("#edit-tools >> text=Disc");
    await drag(page, [at(0.1, -0.6), at(0.3, -0.6)], 1);
    await until(page, "tool", "select");
    await page.click("#edit-tools >> text=Rectangle");
    await drag(page, [at(0.3, 0), at(0.6, -0.15)], 2);
    await page.click("#edit-tools >> text=Rectangle");
    await drag(page, [at(-0.9, -0.4), at(-0.7, -0.5)], 3, "Shift");
    for (const [i, close] of [
      [4, "first"],
      [5, "double"],
      [6, "Enter"],
    ]) {
      await page.click("#edit-tools >> text=Polygon");
      const y = 0.45 + 0.15 * (Number(i) - 4);
      for (const point of [at(-0.6, y), at(-0.4, y), at(-0.5, y + 0.1)]) await page.mouse.click(...point);
      if (close === "first") await page.mouse.click(...at(-0.6, y));
      else if (close === "double") await page.mouse.click(...at(-0.5, y + 0.1));
      else await page.keyboard.press("Enter");
      await until(page, "undo", i);
    }
    // The dots of this sheet are half a metre apart.
    await drag(page, [at(0.1, -0.6), at(0.17, -0.63)], 7, "Shift");
    const {
      document: {
        world: { obstacles },
      },
    } = await saved(page);
    assert.deepEqual(
      obstacles.map(({ type }) => type),
      ["disc", "polygon", "disc", "polygon", "polygon", "polygon", "polygon", "polygon"],
    );
    const [, , disc, wide, square, ...drawn] = obstacles;
    assert.ok(disc.type === "disc" && wide.type === "polygon" && square.type === "polygon");
    near(disc.radius, 0.2);
    for (const value of disc.center)
      assert.ok(Math.abs(value / 0.1 - Math.round(value / 0.1)) < 1e-9, `${value} is on the grid`);
    const side = (/** @type {[number, number][]} */ [[ax, ay], , [cx, cy]]) => [cx - ax, cy - ay];
    near(side(wide.vertices)[0], 0.3);
    near(side(wide.vertices)[1], 0.15);
    near(side(square.vertices)[0], 0.2);
    assert.ok(Math.abs(side(square.vertices)[0] - side(square.vertices)[1]) < 1e-9, "Shift makes a square");
    for (const polygon of drawn) assert.equal(polygon.type === "polygon" && polygon.vertices.length, 3);
  }));

test("an arm's start follows its links, by fifteen degrees with Shift, and in the square its point", () =>
  onStones(async (page, at) => {
    const {
      queries: [{ start: pose }],
    } = JSON.parse(textOf("stones"));
    const elbow = [0.62 * Math.cos(pose[0]), 0.62 * Math.sin(pose[0])];
    const on = (/** @type {number} */ angle) => at(elbow[0] + 0.4 * Math.cos(angle), elbow[1] + 0.4 * Math.sin(angle));
    await drag(page, [on(pose[0] + pose[1]), on(pose[0] + pose[1] + 0.2)], 1);
    assert.equal((await told(page)).title, "Start, joint 2");
    let { document } = await saved(page);
    assert.equal(document.queries[0].start[0], pose[0]);
    near(document.queries[0].start[1], pose[1] + 0.2, 0.02);
    await drag(page, [on(pose[0] + pose[1] + 0.2), on(pose[0] - 0.3)], 2, "Shift");
    near(Number(await page.inputValue("#edit-joint-2")), -Math.PI / 12, 1e-4);
    const square = await page.locator("#cspace canvas[data-layer=top]").boundingBox();
    assert.ok(square);
    const point = (/** @type {number} */ a, /** @type {number} */ b) =>
      /** @type {[number, number]} */ ([
        square.x + 34 + ((a + Math.PI) / (2 * Math.PI)) * (square.width - 46),
        square.y + 12 + ((Math.PI - b) / (2 * Math.PI)) * (square.height - 44),
      ]);
    await drag(page, [point(.../** @type {[number, number]} */ (endsOf(document.queries[0])[1])), point(-2, 1)], 3);
    ({ document } = await saved(page));
    near(endsOf(document.queries[0])[1][0], -2, 0.03);
    near(endsOf(document.queries[0])[1][1], 1, 0.03);
  }));

/** @type {ScenarioDocument["world"]["obstacles"][number]} */
const BOX = {
  type: "polygon",
  vertices: [
    [-0.6, -0.2],
    [0, -0.2],
    [0, 0.3],
    [-0.6, 0.3],
  ],
};

test("what the core refuses is shown with its reason while it is held, and returns when let go", () =>
  onPlain(
    async (page, at) => {
      await page.mouse.click(...at(-0.3, 0));
      await until(page, "kind", "polygon");
      await page.mouse.move(...at(0, 0.3));
      await page.mouse.down();
      // Across the opposite edge, at once.
      await page.mouse.move(...at(-0.3, -0.6));
      await until(page, "code", "degenerate-polygon");
      await textMatches(page, "#story", /cross/);
      assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 20, "the refused shape is drawn");
      await page.mouse.up();
      await until(page, "busy", "false");
      assert.equal((await told(page)).undo, "0");
      assert.match(await page.innerText("#edit-reason"), /cross/);
      // A polygon whose sides cross is not closed, and its corners stay for correction.
      await page.click("#edit-tools >> text=Polygon");
      for (const point of [at(0.2, 0.2), at(0.6, 0), at(0.6, 0.2), at(0.2, 0)]) await page.mouse.click(...point);
      await page.keyboard.press("Enter");
      await textMatches(page, "#story", /cross/);
      assert.equal((await told(page)).code, "degenerate-polygon");
      assert.equal((await told(page)).undo, "0");
      await press(page, ["Backspace", "Enter"], "undo", 1);
      const {
        document: { world },
      } = await saved(page);
      assert.equal(world.obstacles.length, 3);
      assert.deepEqual(world.obstacles[1], BOX);
    },
    { ...PLAIN, world: { ...PLAIN.world, obstacles: [PLAIN.world.obstacles[0], BOX] } },
  ));

test("Escape cancels a gesture, an obstacle stays on the sheet, nothing covers the arm's base", () =>
  onStones(async (page, at) => {
    await page.mouse.move(...at(0.62, 0.5));
    await page.mouse.down();
    await page.mouse.move(...at(0.8, -0.8), { steps: 4 });
    await press(page, ["Escape"], "busy", "false");
    await page.mouse.up();
    assert.equal((await told(page)).undo, "0");
    assert.equal(await page.getAttribute("body", "data-scene"), "stones");
    await page.click("#edit-tools >> text=Disc");
    await page.mouse.click(...at(0, 0));
    await until(page, "code", "base-in-collision");
    await page.click("#edit-tools >> text=Select");
    await drag(page, [at(0.62, 0.5), [5, 5]], 1);
    const {
      document: {
        world: {
          obstacles: [stone],
        },
      },
    } = await saved(page);
    assert.ok(stone.type === "polygon" && stone.vertices.every(([x, y]) => Math.abs(x) < 1.8 && Math.abs(y) < 1.8));
  }));

test("a start in collision is marked and named, planning is refused, and continues once it is moved", () =>
  onPlain(async (page, at) => {
    await drag(page, [at(0.5, 0.5), at(-0.75, 0.7)]);
    await until(page, "touching", "The start is in collision: the disc touches obstacle 0.");
    await textMatches(page, "#story", /start is in collision: the disc touches obstacle 0/);
    assert.equal((await counters(page)).status, "none");
    assert.ok(await page.isDisabled("#play"));
    assert.ok(await page.isHidden("#notice"), "said where the hand is, not above the stage");
    assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 150);
    // With the editor closed the page shows a notice; with the editor open again the start can be moved.
    await page.click("#edit[aria-pressed=true]");
    await page.waitForSelector("#notice[data-code=start-in-collision]");
    await page.click("#edit[aria-pressed=false]");
    await until(page, "touching", "The start is in collision: the disc touches obstacle 0.");
    const again = await plane(page, 1);
    await drag(page, [again(-0.8, 0.7), again(-0.3, 0.7)]);
    await until(page, "touching", "");
    await page.waitForSelector("#notice", { state: "hidden" });
    assert.equal((await finish(page)).status, "solved");
  }));

test("planning restarts and waits until someone plays; the configuration space follows the hand", () =>
  onPage({}, async (page) => {
    await passes(page, 5);
    await openEditor(page, null);
    await page.waitForSelector("#play[data-playing=false]");
    const at = await plane(page, 1.2);
    // Both links stretched out towards the stone.
    const blocked = () => isBlocked(page, Math.atan2(0.5, 0.62), 0);
    assert.ok(await blocked());
    await page.mouse.move(...at(0.62, 0.5));
    await page.mouse.down();
    await page.mouse.move(...at(1.1, 1.1), { steps: 6 });
    await page.waitForSelector("#counters[data-iterations='0'][data-settled=true]", { state: "attached" });
    assert.ok(!(await blocked()), "free while the stone is held elsewhere");
    await page.mouse.up();
    await until(page, "undo", 1);
    assert.ok(!(await blocked()));
    assert.equal((await atRest(page)).iterations, 0, "it waits");
    assert.equal(await page.getAttribute("#play", "data-playing"), "false");
    assert.equal(await page.getAttribute("body", "data-scene"), "file");
    await page.click("#play");
    await passes(page, 5);
  }));

test("sixty edits are undone and redone, one a gesture, and the scene is again the page's own", () =>
  onPausedPage(async (page) => {
    const text = async () => {
      const { text: whole } = await saved(page);
      await page.focus("#stage");
      return whole;
    };
    const header = (/** @type {string} */ title) =>
      page.locator("#where", { hasText: `${title} \u00b7 PRM` }).waitFor();
    await openEditor(page, null);
    await page.focus("#stage");
    await press(page, ["]", "]", "]"], "title", "Obstacle 0, a polygon");
    await header("Two links among stones");
    const before = await text();
    for (let i = 0; i < 60; i++) await page.keyboard.press(i % 3 === 0 ? "ArrowUp" : "ArrowRight");
    await until(page, "undo", 60);
    const changed = await text();
    assert.notEqual(changed, before);
    await header("Two links among stones (edited)");
    await press(page, Array(60).fill("Control+z"), "redo", 60);
    await header("Two links among stones");
    await page.waitForSelector("body[data-scene=stones]");
    assert.ok(await page.isChecked("input[name=scene][value=stones]"));
    assert.equal(await text(), before);
    await press(page, Array(60).fill("Control+Shift+Z"), "redo", 0);
    await page.waitForSelector("body[data-scene=file]");
    assert.equal(await text(), changed);
    await page.click("#editor >> text=Revert");
    await page.waitForSelector("body[data-scene=stones]");
    await header("Two links among stones");
    assert.equal(await text(), before);
    await page.click("#edit-tools >> text=Undo");
    await page.waitForSelector("body[data-scene=file]");
    assert.equal(await text(), changed);
  }));

test("by keys alone things are put, selected, moved, changed, copied and deleted, and announced", () =>
  onPlain(async (page) => {
    await page.focus("#edit-tools button:nth-child(2)");
    await press(page, ["Enter"], "tool", "disc");
    await page.focus("#stage");
    await press(page, ["Enter"], "title", "Obstacle 2, a disc");
    await textMatches(page, "#announcer", /^Obstacle 2, a disc: x /);
    const put = (await saved(page)).document.world.obstacles[2];
    assert.ok(put.type === "disc");
    await page.focus("#stage");
    await press(page, ["ArrowLeft", "Shift+ArrowDown"], "undo", 3);
    const moved = (await saved(page)).document.world.obstacles[2];
    assert.ok(moved.type === "disc");
    near(moved.center[0] - put.center[0], -0.01, 1e-9);
    near(moved.center[1] - put.center[1], -0.1, 1e-9);
    await enter(page, "#edit-radius", "0.07");
    await until(page, "undo", 4);
    await enter(page, "#edit-radius", "-1");
    await until(page, "code", "out-of-range");
    assert.equal(await page.getAttribute("#edit-radius", "aria-invalid"), "true");
    assert.match(await page.innerText("#edit-reason"), /radius/);
    await page.focus("#stage");
    await press(page, ["d"], "title", "Obstacle 3, a disc");
    await press(page, ["Delete"], "undo", 6);
    await press(page, ["[", "["], "title", "Obstacle 1, a polygon");
    await press(page, ["PageDown"], "title", "Obstacle 1, a polygon, vertex 0");
    await press(page, ["Insert"], "title", "Obstacle 1, a polygon, vertex 1");
    await press(page, ["Shift+ArrowDown"], "undo", 8);
    await assertFaultless(page, "a vertex selected");
    const {
      document: {
        world: { obstacles },
      },
    } = await saved(page);
    assert.equal(obstacles.length, 3);
    assert.ok(obstacles[1].type === "polygon" && obstacles[2].type === "disc");
    assert.deepEqual(obstacles[1].vertices, [
      [-0.6, -0.2],
      [-0.3, -0.3],
      [0, -0.2],
      [-0.3, 0.3],
    ]);
    assert.equal(obstacles[2].radius, 0.07);
    await page.focus("#stage");
    await press(page, ["Delete"], "undo", 9);
    await press(page, ["PageDown", "Delete"], "code", "degenerate-polygon");
    await press(page, ["Escape", "]", "]"], "title", "Start");
    await press(page, ["Delete"], "code", "not-deletable");
    await press(page, ["ArrowRight"], "undo", 10);
    const last = (await saved(page)).document;
    assert.deepEqual(last.queries[0].start, [-0.79, 0.7]);
    assert.deepEqual(last.world.obstacles[1], PLAIN.world.obstacles[1]);
  }));

test("in the open editor keys turn an arm's joints by degrees; a number out of range is refused", () =>
  onPausedPage(async (page) => {
    await page.focus("#stage");
    await keys(page, "]", "Delete", "ArrowUp", "Control+z");
    assert.equal((await atRest(page)).status, "running");
    assert.equal(
      await page.getAttribute("body", "data-scene"),
      "stones",
      "while the editor is closed its keys do nothing",
    );
    await openEditor(page, null);
    await page.focus("#stage");
    await press(page, ["]", "PageUp"], "title", "Start, end effector");
    await press(page, ["PageUp"], "title", "Start, joint 2");
    const before = Number(await page.inputValue("#edit-joint-2"));
    await press(page, ["Shift+ArrowUp"], "undo", 1);
    near(Number(await page.inputValue("#edit-joint-2")) - before, Math.PI / 18, 1e-4);
    await enter(page, "#edit-joint-1", "9");
    assert.equal(await page.getAttribute("#edit-joint-1", "aria-invalid"), "true");
    assert.equal((await told(page)).undo, "1");
  }));

test("a saved scenario opened again has the same fingerprint, and another scene forgets its edits", () =>
  onStones(async (page, at) => {
    await drag(page, [at(0.62, 0.5), at(0.7, 0.62)], 1);
    await page.waitForSelector("body[data-scene=file]");
    const ended = await finish(page);
    assert.equal(await page.textContent("#where"), "Two links among stones (edited) \u00b7 PRM");
    const { text, name } = await saved(page);
    assert.equal(name, "stones.json");
    assert.match(text, /"vertices": \[\[-?\d/);
    await pickFile(page, name, text);
    await page.waitForFunction(() => document.getElementById("editor")?.dataset.undo === "0");
    await atRest(page);
    const again = await finish(page);
    assert.equal(again.fingerprint, ended.fingerprint);
    assert.equal(again.length, ended.length);
    assert.equal(await page.textContent("#where"), "Two links among stones \u00b7 PRM");
    await page.focus("#stage");
    await press(page, ["]", "ArrowUp"], "undo", 1);
    await chooseScene(page, "firs");
    await until(page, "undo", 0);
    assert.equal((await saved(page)).name, "firs.json");
    assert.equal(await page.innerText("#where"), "A forest of triangles \u00b7 RRT-Connect");
  }));

test("a finger draws and drags, the tools stand above the stage and are large enough", () =>
  onPausedPage(async (page) => {
    await openEditor(page, PLAIN);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing sticks out");
    const above = await page.evaluate(() => document.getElementById("stage")?.previousElementSibling?.id);
    assert.equal(above, "edit-tools");
    for (const box of await page
      .locator("#edit-tools button")
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height)))
      assert.ok(box >= 44);
    const at = await plane(page, 1);
    // A finger that is 12 px off the disc's radius handle still takes it.
    await page.touchscreen.tap(...at(0.5, 0.5));
    await until(page, "title", "Obstacle 0, a disc");
    const [x, y] = at(0.65, 0.5);
    await swipe(page, [[x + 12, y], at(0.8, 0.5)], 1);
    near(Number(await page.inputValue("#edit-radius")), 0.3, 0.02);
    await page.tap("#edit-tools >> text=Rectangle");
    const now = await plane(page, 1);
    await swipe(page, [now(0, -0.5), now(0.3, -0.8)], 2);
    await page.tap("#edit-tools >> text=Polygon");
    const then = await plane(page, 1);
    for (const point of [then(-0.8, -0.8), then(-0.3, -0.8), then(-0.3, -0.4), then(-0.8, -0.8)])
      await page.touchscreen.tap(...point);
    await until(page, "undo", 3);
    assert.ok((await pixelsOf(page, "workspace", "top", "ink")) > 100, "what is selected shows its handles");
    const { document: kept } = await saved(page);
    assert.deepEqual(
      kept.world.obstacles.map((one) => (one.type === "polygon" ? one.vertices.length : 1)),
      [1, 3, 4, 3],
    );
    await page.tap("#editor-fold > summary");
    await page.waitForFunction(() => document.getElementById("edit-tools")?.parentElement?.id === "editor");
  }, MOBILE));
