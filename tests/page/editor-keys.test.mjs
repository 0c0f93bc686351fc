/** The editor by keys; what is undone, saved and opened again. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { atRest, chooseScene, finish, keys, onPausedPage, pickFile, textMatches, useBrowser } from "./browser.mjs";
import { drag, enter, near, openEditor, press, saved, told, until } from "./editing.mjs";
import { assertFaultless } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";
import { PLAIN, onPlain, onStones } from "./editing-scenes.mjs";

useBrowser();

test("the editor by keys; what is undone and saved", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "twelve edits are undone and redone, one a gesture, and the scene is again the page's own": async (page) => {
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
          for (let i = 0; i < 12; i++) await page.keyboard.press(i % 3 === 0 ? "ArrowUp" : "ArrowRight");
          await until(page, "undo", 12);
          const changed = await text();
          assert.notEqual(changed, before);
          await header("Two links among stones (edited)");
          await press(page, Array(12).fill("Control+z"), "redo", 12);
          await header("Two links among stones");
          await page.waitForSelector("body[data-scene=stones]");
          assert.ok(await page.isChecked("input[name=scene][value=stones]"));
          assert.equal(await text(), before);
          await press(page, Array(12).fill("Control+Shift+Z"), "redo", 0);
          await page.waitForSelector("body[data-scene=file]");
          assert.equal(await text(), changed);
          await page.click("#editor >> text=Revert");
          await page.waitForSelector("body[data-scene=stones]");
          await header("Two links among stones");
          assert.equal(await text(), before);
          await page.click("#edit-tools >> text=Undo");
          await page.waitForSelector("body[data-scene=file]");
          assert.equal(await text(), changed);
        },

        "by keys alone things are put, selected, moved, changed, copied and deleted, and announced": onPlain(
          async (page) => {
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
            await press(page, ["[", "[", "["], "title", "Obstacle 1, a polygon");
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
            await press(page, ["Escape", "]", "]", "]"], "title", "Start");
            await press(page, ["Delete"], "code", "not-deletable");
            await press(page, ["ArrowRight"], "undo", 10);
            const last = (await saved(page)).document;
            assert.deepEqual(last.queries[0].start, [-0.79, 0.7]);
            assert.deepEqual(last.world.obstacles[1], PLAIN.world.obstacles[1]);
          },
        ),

        "in the open editor keys turn an arm's joints by degrees; a number out of range is refused": async (page) => {
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
        },

        "a saved scenario opened again has the same fingerprint, and another scene forgets its edits": onStones(
          async (page, at) => {
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
          },
        ),
      },
      restage,
    ),
  ));
