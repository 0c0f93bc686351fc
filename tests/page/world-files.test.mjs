/** Maps and pictures of other programs: read in the panel, opened, changed, undone and planned in. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import {
  atRest,
  click,
  dropFile,
  finish,
  onPage,
  onPausedPage,
  pickFile,
  pickFiles,
  pixelsOf,
  reveal,
  take,
  textMatches,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { rectangleBetween } from "../../www/domain/obstacles.js";
import { jpegSize } from "../../www/worlds/photo.js";
import { placesIn } from "../../www/worlds/places.js";
import { drag, plane } from "./editing.mjs";
import { isFree } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { BUILDING, DRAWING, MAP, SCEN, noise, pgm, yaml } from "./worlds.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/** Waits until the panel is in a state. @param {Page} page @param {string} state */
const panel = (page, state = "ready") => page.waitForSelector(`#world[data-state=${state}]`);

/** Uses the world in the panel, and waits until it is on the stage. @param {Page} page */
async function use(page) {
  await page.click("#world-use:enabled");
  await page.waitForSelector("#world", { state: "hidden" });
  await page.waitForSelector("body[data-scene=file]");
  return atRest(page);
}

/** The scenario on the stage, as it is saved. @param {Page} page */
async function saved(page) {
  await unfold(page, "export");
  return JSON.parse((await take(page, "scenario")).text);
}

/** Whether every motion of the path on the stage is proven in the scenario on it. @param {Page} page */
async function isVerified(page) {
  const scenario = Scenario.parse(await saved(page));
  /** @type {number[][]} */
  const path = JSON.parse((await take(page, "result")).text).path;
  const isProven = path.length > 1 && isFree(scenario, path);
  scenario.free();
  return isProven;
}

test("worlds of other programs", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a map and its picture, picked together: one press, and a path is found and verified": async (page) => {
          await pickFiles(page, { "rooms.yaml": yaml(), "rooms.pgm": pgm() });
          await panel(page);
          assert.equal(await page.innerText("#world-title"), "ROS map");
          assert.match(await page.innerText("#world-report"), /48 × 30 cells of 0.1 m: 4.8 × 3 m/);
          assert.match(await page.innerText("#world-robot"), /disc/);
          await use(page);
          assert.equal(await page.inputValue("#planner"), "rrt-connect");
          assert.equal(await page.inputValue("#parameter-shortcut"), "200", "its path is made shorter");
          assert.equal((await finish(page)).status, "solved");
          assert.ok(await isVerified(page));
          assert.ok((await pixelsOf(page, "workspace", "ground", "obstacle-edge")) > 500, "its cells are drawn");
          assert.ok(await page.isVisible("#legend-map"));
          assert.ok(await page.isVisible("#legend-unknown"));
          assert.ok(await page.isHidden("#legend-obstacle"));
          assert.ok(await page.isVisible("#legend-robot"), "on its path");
          const { world, queries, robot } = await saved(page);
          assert.deepEqual(world.bounds, { min: [-1, -2], max: [-1 + 48 * 0.1, 1] });
          assert.equal(queries.length, 1);
          assert.equal(robot.type, "disc");
        },

        "a map whose picture is missing says which, and waits for it; the other way round too": async (page) => {
          await dropFile(page, "rooms.yaml", yaml());
          await panel(page, "fault");
          assert.equal(await page.getAttribute("#world", "data-code"), "missing-file");
          assert.match(await page.innerText("#world-fault"), /rooms\.yaml needs rooms\.pgm/);
          assert.match(await page.innerText("#world-add"), /rooms\.pgm/);
          await dropFile(page, "rooms.pgm", pgm());
          await panel(page);
          assert.equal(await page.innerText("#world-title"), "ROS map");
          await page.keyboard.press("Escape");
          await page.waitForSelector("#world", { state: "hidden" });
          assert.equal(await page.getAttribute("body", "data-scene"), "stones", "nothing was opened");
          await dropFile(page, "rooms.pgm", pgm());
          await panel(page);
          assert.equal(await page.innerText("#world-title"), "Picture");
          await dropFile(page, "rooms.yaml", yaml());
          await textMatches(page, "#world-title", /ROS map/);
          await use(page);
          assert.equal((await finish(page)).status, "solved");
        },

        "what is refused is named with file and place, and the open scene stays": async (page) => {
          const { iterations } = await click(page, "#step-10");
          for (const [files, code, words] of /** @type {[Record<string, string | Uint8Array>, string, RegExp][]} */ ([
            [{ "rooms.pgm": pgm().subarray(0, 500) }, "truncated", /rooms\.pgm, byte/],
            [
              { "rooms.yaml": yaml().replace("image: rooms.pgm\n", ""), "rooms.pgm": pgm() },
              "invalid-file",
              /rooms\.yaml/,
            ],
            [{ "notes.txt": "nothing of use" }, "unknown-world", /notes\.txt/],
          ])) {
            await pickFiles(page, files);
            await page.waitForSelector(`#world[data-state=fault][data-code=${code}]`);
            assert.match(await page.innerText("#world-fault"), words);
            assert.ok(await page.isDisabled("#world-use"));
            await page.click("#world-close");
            assert.equal((await atRest(page)).iterations, iterations);
            assert.equal(await page.getAttribute("body", "data-scene"), "stones");
          }
          await pickFiles(page, { "rooms.pgm": pgm(), "rooms.yaml": yaml() });
          await panel(page);
          await page.fill("#world-radius", "-1");
          assert.ok(await page.isVisible("#world-radius-reason"));
          await page.fill("#world-radius", "5");
          await page.waitForSelector("#world[data-code=no-place]");
          assert.match(await page.innerText("#world-fault"), /fits nowhere/);
          await page.click("#world-close");
        },

        "choices are read again, and what was chosen can be changed afterwards and undone": async (page) => {
          await pickFiles(page, { "rooms.yaml": yaml(), "rooms.pgm": pgm() });
          await panel(page);
          const before = await page.innerText("#world-report");
          await page.selectOption("#world-unknown", "free");
          await textMatches(page, "#world-report", new RegExp(`^(?!${before.split("\n")[2]})`));
          await page.selectOption("#world-robot", "footprint");
          await page.fill("#world-length", "0.5");
          await page.fill("#world-width", "0.3");
          await panel(page);
          await use(page);
          const body = await saved(page);
          assert.equal(body.robot.type, "rigid_body");
          const [x, y] = [0, 1].map((i) =>
            Math.max(...body.robot.shape.vertices.map((/** @type {number[]} */ v) => v[i])),
          );
          assert.deepEqual([x, y], [0.25, 0.15]);
          assert.equal((await finish(page)).status, "solved");
          assert.ok(await isVerified(page));
          await page.click("#world-change");
          await panel(page);
          assert.equal(await page.inputValue("#world-length"), "0.5", "it is as it was chosen");
          await reveal(page, "#world-min_island");
          assert.equal(await page.isVisible("#world-margin"), true);
          await page.selectOption("#world-robot", "car");
          await panel(page);
          await use(page);
          assert.equal((await saved(page)).robot.type, "car");
          await page.click("#world-undo");
          await page.waitForFunction(() => document.querySelector("#your-turn")?.textContent === "Your turn");
          assert.deepEqual(await saved(page), body);
          assert.ok(await page.isVisible("#legend-map"), "with its cells");
        },

        "opening is undone in one step, to the scene that was open, and done again": async (page) => {
          await pickFiles(page, { "rooms.yaml": yaml(), "rooms.pgm": pgm() });
          await panel(page);
          await use(page);
          const opened = await saved(page);
          const cells = await pixelsOf(page, "workspace", "ground", "obstacle-edge");
          await page.click("#world-undo");
          await page.waitForSelector("body[data-scene=stones]");
          assert.equal(await page.inputValue("#planner"), "prm");
          await page.waitForSelector("#legend-map", { state: "hidden" });
          await page.waitForSelector("#legend-obstacle");
          await page.click("#world-undo");
          await page.waitForSelector("body[data-scene=file]");
          await atRest(page);
          assert.deepEqual(await saved(page), opened);
          assert.equal(await pixelsOf(page, "workspace", "ground", "obstacle-edge"), cells, "with its cells");
        },

        "start and goal are dragged in the panel or typed, and a collision is reported": async (page) => {
          await pickFiles(page, { "rooms.yaml": yaml(), "rooms.pgm": pgm() });
          await panel(page);
          await use(page);
          const [{ start }] = (await saved(page)).queries;
          await page.click("#world-change");
          await panel(page);
          const at = await plane(page, { min: [-1, -2], max: [3.8, 1] }, "#world-preview");
          await drag(page, [at(start[0], start[1]), at(1.45, -1.8)]);
          await page.waitForSelector("#world-hint[data-bad=true]");
          assert.match(await page.innerText("#world-hint"), /start is in collision/i);
          await drag(page, [at(1.45, -1.8), at(0.5, 0)]);
          await page.waitForSelector("#world-hint[data-bad=false]");
          const dragged = Number(await page.inputValue("#world-start-y"));
          await page.fill("#world-start-x", "99");
          assert.match(await page.innerText("#world-start-x-reason"), /x: 99 is above 3\.8/);
          await page.focus("#world-start-y");
          assert.ok(await page.isHidden("#world-start-x-reason"), "the place is shown again");
          assert.ok(Math.abs(Number(await page.inputValue("#world-start-x")) - 0.5) < 0.1);
          await page.fill("#world-start-x", "1.45");
          await page.fill("#world-start-y", "-1.8");
          await page.waitForSelector("#world-hint[data-bad=true]");
          await page.fill("#world-start-x", "0.52");
          await page.fill("#world-start-y", String(dragged));
          await page.waitForSelector("#world-hint[data-bad=false]");
          await use(page);
          const [moved] = (await saved(page)).queries;
          assert.deepEqual(moved.start, [0.52, dragged]);
          assert.ok(Math.abs(dragged) < 0.1, `${dragged}`);
        },

        "a picture without metadata gets its scale from two clicks and a length": async (page) => {
          await pickFile(page, "rooms.pgm", pgm());
          await panel(page);
          await page.click("#world-measure");
          const at = await plane(page, { min: [-24, -15], max: [24, 15] }, "#world-preview");
          for (const x of [-20, 20]) await page.mouse.click(...at(x, 0));
          await page.fill("#world-distance", "8");
          await textMatches(page, "#world-report", /cells of 0\.(19|2)\d* m/);
          await panel(page);
          await page.fill("#world-threshold", "0.9");
          await panel(page);
          await use(page);
          assert.equal((await finish(page)).status, "solved");
        },

        "areas of a plan are obstacles, or where the robot may be": async (page) => {
          const ring = [...rectangleBetween([0, 0], [8, 6]).vertices, [0, 0]];
          await pickFile(page, "hall.geojson", JSON.stringify({ type: "Polygon", coordinates: [ring] }));
          await panel(page);
          assert.equal(await page.innerText("#world-title"), "GeoJSON");
          await textMatches(page, "#world-report", /1 polygon/);
          await page.selectOption("#world-walkable", "true");
          await textMatches(page, "#world-report", /where the robot may be/);
          await panel(page);
          await use(page);
          const [{ start, goal }] = (await saved(page)).queries;
          for (const [x, y] of [start, goal]) assert.ok(x > 0 && x < 8 && y > 0 && y < 6, `${x}, ${y}`);
        },

        "a level of a building is chosen, and features by their properties": async (page) => {
          await pickFile(page, "house.building.yaml", BUILDING);
          await panel(page);
          await textMatches(page, "#world-report", /Level "ground" of 2/);
          await page.selectOption("#world-level", "upper");
          await textMatches(page, "#world-report", /Level "upper" of 2/);
          await panel(page);
          assert.equal(await page.inputValue("#world-level"), "upper");
          await page.click("#world-close");
          const feature = (/** @type {string} */ kind, /** @type {number} */ x) => ({
            type: "Feature",
            properties: { kind },
            geometry: {
              type: "Polygon",
              coordinates: [[...rectangleBetween([x, 0], [x + 4, 3]).vertices, [x, 0]]],
            },
          });
          const features = [feature("wall", 0), feature("wall", 8), feature("tree", 16)];
          await pickFile(page, "yard.geojson", JSON.stringify({ type: "FeatureCollection", features }));
          await panel(page);
          assert.ok(await page.isHidden("#world-level"));
          await textMatches(page, "#world-report", /3 polygons/);
          await reveal(page, "#world-filters");
          await page.fill("#world-filters", "kind");
          assert.ok(await page.isVisible("#world-filters-reason"));
          await page.fill("#world-filters", "kind != tree");
          assert.ok(await page.isHidden("#world-filters-reason"));
          await textMatches(page, "#world-report", /2 polygons/);
          await page.click("#world-close");
        },

        "closed lines of a drawing are walls, or filled, and curves grow by as much as is chosen": async (page) => {
          await pickFile(page, "room.dxf", DRAWING);
          await panel(page);
          await textMatches(page, "#world-report", /3 walls/);
          await reveal(page, "#world-filled");
          await page.fill("#world-tolerance", "0.1");
          await textMatches(page, "#world-report", /by at most 0\.0[1-9]/);
          await page.check("#world-layers [value=walls]");
          await page.uncheck("#world-layers [value=walls]");
          await page.check("#world-filled");
          await textMatches(page, "#world-report", /1 polygon, 1 disc/);
          await panel(page);
          await use(page);
          const { world } = await saved(page);
          assert.deepEqual(
            world.obstacles.map((/** @type {{ type: string }} */ { type }) => type),
            ["polygon", "disc"],
          );
        },

        "a JPEG is decoded by the browser, a damaged one is refused": async (page) => {
          const bytes = Uint8Array.from(
            await page.evaluate(async () => {
              const canvas = new OffscreenCanvas(60, 40);
              const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
              context.fillStyle = "white";
              context.fillRect(0, 0, 60, 40);
              context.fillStyle = "black";
              context.fillRect(24, 0, 8, 24);
              const blob = await canvas.convertToBlob({ type: "image/jpeg", quality: 0.95 });
              return [...new Uint8Array(await blob.arrayBuffer())];
            }),
          );
          assert.deepEqual(jpegSize(bytes), { width: 60, height: 40 });
          await pickFile(page, "hall.jpg", bytes);
          await panel(page);
          assert.match(await page.innerText("#world-report"), /60 × 40 cells/);
          assert.match(await page.innerText("#world-report"), /1 rectangle/);
          await page.click("#world-close");
          await pickFile(page, "hall.jpg", bytes.subarray(0, 30));
          await page.waitForSelector("#world[data-state=fault][data-code=invalid-file]");
          assert.match(await page.innerText("#world-fault"), /hall\.jpg/);
          await page.click("#world-close");
        },

        "queries of the file are offered, and planned": async (page) => {
          await pickFiles(page, { "small.map.scen": SCEN, "small.map": MAP });
          await panel(page);
          assert.equal(await page.innerText("#world-title"), "MovingAI map");
          assert.equal(await page.locator("#world-query option").count(), 2);
          await page.selectOption("#world-query", { index: 1 });
          await use(page);
          assert.equal(await page.locator("#query option").count(), 2);
          const [, second] = (await saved(page)).queries;
          assert.equal(await page.inputValue("#query"), second.name);
          assert.equal((await finish(page)).status, "solved");
          assert.ok(await isVerified(page));
        },

        "a large world is zoomed, and its link is refused in words": async (page) => {
          await pickFiles(page, { "noise.yaml": yaml("noise.pgm", 0.4137), "noise.pgm": noise() });
          await panel(page);
          await use(page);
          const dark = () => pixelsOf(page, "workspace", "ground", "obstacle-edge");
          const whole = await dark();
          for (let i = 0; i < 3; i++) await click(page, "#zoom-in");
          const near = await dark();
          assert.ok(near > 2 * whole, `${near} pixels are dark, ${whole} were`);
          await page.focus("#zoom-in");
          for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowRight");
          await atRest(page);
          assert.notEqual(await dark(), near);
          await click(page, "#zoom-whole");
          assert.equal(await dark(), whole);
          await page.click("#link");
          await page.waitForSelector("#notice:not([hidden])");
          assert.match(
            await page.innerText("#notice"),
            /too large for it, with [\d,]+ obstacles: save it as a scenario/,
          );
        },
      },
      restage,
    ),
  ));

test("start and goal are in a closed building rather than around it, and around what is filled", () => {
  const filled = rectangleBetween([2, 2], [10, 8]);
  for (const [obstacle, isInside] of /** @type {const} */ ([
    [{ type: "wall", closed: true, width: 0.1, points: filled.vertices }, true],
    [filled, false],
  ])) {
    const text = JSON.stringify({
      format: "planarium-scenario-1",
      name: "building",
      world: { bounds: { min: [0, 0], max: [12, 10] }, obstacles: [obstacle] },
      robot: { type: "disc", radius: 0.2 },
      queries: [],
    });
    const scenario = Scenario.parse(text);
    const places = placesIn(scenario);
    scenario.free();
    assert.ok(places);
    for (const [x, y] of [places.start, places.goal])
      assert.equal(x > 2 && x < 10 && y > 2 && y < 8, isInside, `${x}, ${y}`);
  }
});

test("other pages read a map as their world, or say where one is opened", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await page.waitForSelector("body[data-state=ready][data-settled=true]");
      await reveal(page, "#file");
      await pickFiles(page, { "small.map.scen": SCEN, "small.map": MAP });
      await panel(page);
      await page.click("#world-use:enabled");
      await page.waitForSelector("#world", { state: "hidden" });
      await page.waitForSelector("body[data-phase=ready]");
      assert.match(await page.inputValue("#title"), /small/);
      await page.goto(page.url().replace("experiments", "fleet"));
      await page.waitForSelector("body[data-state=ready][data-settled=true]");
      await pickFiles(page, { "rooms.yaml": yaml(), "rooms.pgm": pgm() });
      await panel(page);
      await page.fill("#world-radius", "0.5");
      await page.waitForSelector("#world[data-state=ready] #world-use:enabled");
      await page.click("#world-use");
      await page.waitForSelector("#world #notice[data-code=no-place]");
      assert.match(await page.innerText("#notice"), /no room for two robots/);
      await page.fill("#world-radius", "0.1");
      await page.waitForSelector("#world[data-state=ready] #world-use:enabled");
      await page.click("#world-use");
      await page.waitForSelector("#world", { state: "hidden" });
      await textMatches(page, "#where", /rooms/);
      await page.waitForSelector("#stage[data-status=solved]");
      await page.goto(page.url().replace("fleet", "reach"));
      await page.waitForSelector("body[data-state=ready][data-settled=true]");
      await pickFiles(page, { "rooms.yaml": yaml() });
      await page.waitForSelector("#notice[data-code=unknown-file]");
      assert.match(await page.innerText("#notice"), /opened on the page Planners/);
    },
    { path: "experiments.html" },
  ));
