/**
 * A roadmap that stands is asked for another path: the page says and draws what the package says, and the run stays as
 * it is.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  atRest,
  choosePlanner,
  chooseScene,
  click,
  counters,
  download,
  fill,
  finish,
  linkOf,
  offered,
  onPausedPage,
  openScenario,
  pixelsOf,
  setParameter,
  textMatches,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { readNpy } from "../../www/formats/npy.js";
import { openEditor, press, until } from "./editing.mjs";
import { load, planned } from "./library.mjs";
import { assertFaultless, assertTargets } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/** The page's roadmap of a scene, with the ends of its first query. @param {string} id */
function roadmap(id) {
  const { scenario, planner } = planned(id);
  const [{ start, goal }] = scenario.document().queries;
  assert.ok(goal);
  return { planner, start, goal };
}

/**
 * What the package says of a query: its result, and the number of vertices that it visits.
 * @param {import("planarium").Planner} planner
 * @param {number[]} start
 * @param {number[]} goal
 */
function answerOf(planner, start, goal) {
  const before = planner.stats().visited;
  const result = planner.query(start, goal);
  return { ...result, visited: planner.stats().visited - before };
}

/** Poses the robot by hand. @param {Page} page @param {number[]} pose */
async function hold(page, pose) {
  if ((await page.innerText("#your-turn")) !== "Watch again") await click(page, "#your-turn");
  for (const [i, value] of pose.entries()) await fill(page, `#pose-${i}-number`, String(value));
  await atRest(page);
}

/** Asks, and waits for an answer. @param {Page} page @param {() => Promise<unknown>} act @param {RegExp} answer */
async function ask(page, act, answer) {
  await act();
  await textMatches(page, "#story", answer);
  return atRest(page);
}

const HAS_PATH =
  /^The roadmap has a path, (\d+) vertices visited in [\d.]+ m?s: length ([\d.]+) rad, proven to be collision-free\.$/;

/**
 * Checks that the page says what the package says of a query.
 * @param {Page} page
 * @param {ReturnType<typeof answerOf>} answer
 */
async function assertTold(page, { visited, length, path }) {
  const [, ...numbers] = HAS_PATH.exec(await page.innerText("#story")) ?? assert.fail(await page.innerText("#story"));
  assert.deepEqual(numbers, [String(visited), length.toFixed(2)]);
  const told = await Promise.all(
    ["phase", "visited", "length", "waypoints"].map((name) => page.innerText(`#count-${name}`)),
  );
  assert.deepEqual(told, ["solved", String(visited), `${length.toFixed(2)} rad`, String(path.length)]);
  assert.match(await page.innerText("#count-search"), /^[\d.]+ ms$/);
}

test("a roadmap is asked", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a roadmap that stands is asked from and to the robot in hand; the run stays, and a step back returns to it":
          async (page) => {
            const { planner, goal } = roadmap("stones");
            const own = await finish(page);
            const story = await page.innerText("#story");
            assert.equal(await page.isVisible("#ask"), false);
            const here = [1.55, 1.2];
            await hold(page, here);
            const first = answerOf(planner, here, goal);
            const asked = await ask(page, () => page.click("#ask-from"), HAS_PATH);
            await assertTold(page, first);
            assert.deepEqual({ ...asked, length: own.length }, own);
            assert.ok(Math.abs(asked.length - first.length) < 1e-9 && asked.length !== own.length);
            assert.equal(await page.evaluate(() => document.activeElement?.id), "ask-own");
            assert.ok((await pixelsOf(page, "cspace", "top", "path")) > 100);
            await page.locator("#along").fill("0");
            assert.deepEqual(
              await Promise.all([0, 1].map((i) => page.inputValue(`#pose-${i}-number`))),
              here.map((value) => value.toFixed(3)),
            );
            // Another goal: the start is the one that was asked for.
            const there = [0.4, 2.9];
            await hold(page, there);
            const second = answerOf(planner, here, there);
            await ask(page, () => page.click("#ask-to"), new RegExp(`length ${second.length.toFixed(2)} rad`));
            await assertTold(page, second);
            // Files hold what is shown.
            await unfold(page, "export");
            assert.deepEqual(readNpy((await download(page, "#export-path")).bytes), {
              shape: [second.path.length, 2],
              data: Float64Array.from(second.path.flat()),
            });
            const result = JSON.parse((await download(page, "#export-result")).text);
            assert.deepEqual([result.query, result.path], [second.query, second.path]);
            await click(page, "#back");
            assert.equal(await page.isVisible("#ask"), false);
            assert.deepEqual(await finish(page), own);
            assert.equal(await page.innerText("#story"), story);
            // The same by the button.
            await hold(page, here);
            await ask(page, () => page.click("#ask-from"), HAS_PATH);
            await assertTold(page, first);
            await click(page, "#ask-own");
            assert.deepEqual([await counters(page), await page.innerText("#story")], [own, story]);
          },

        "a start in collision is reported, and nothing changes": async (page) => {
          const own = await finish(page);
          await hold(page, [2.2, -1.3]);
          await page.click("#ask-from");
          await page.waitForSelector("#notice[data-code=start-in-collision][data-pointer='/start']");
          assert.match(await page.innerText("#notice"), /^This roadmap cannot be asked\. /);
          await page.click("#ask-to");
          await page.waitForSelector("#notice[data-code=goal-in-collision][data-pointer='/goal']");
          assert.deepEqual(await atRest(page), own);
          await hold(page, [1.55, 1.2]);
          await ask(page, () => page.click("#ask-from"), HAS_PATH);
          assert.equal(await page.isVisible("#notice"), false);
        },

        "a further query of the scene is asked of the roadmap; the link holds the run's own": async (page) => {
          await chooseScene(page, "shelf");
          assert.equal(await page.isVisible("#ask-row"), false);
          await choosePlanner(page, "prm", "samples");
          await setParameter(page, "samples", "1500");
          await atRest(page);
          assert.deepEqual([await page.isVisible("#ask-row"), await page.isEnabled("#ask-query")], [true, false]);
          const own = await finish(page);
          const [mine, other] = load("shelf").document().queries;
          assert.deepEqual(await offered(page, "ask-query"), ["", mine.name, other.name]);
          const hash = await linkOf(page);
          const planner = load("shelf").planner({
            algorithm: "prm",
            samples: 1500,
            seed: Number(await page.inputValue("#parameter-seed")),
          });
          while (planner.step(1000) === "running");
          assert.equal(planner.fingerprint(), own.fingerprint);
          const answer = answerOf(planner, other.start, other.goal ?? assert.fail());
          await ask(page, () => page.selectOption("#ask-query", other.name), HAS_PATH);
          await assertTold(page, answer);
          assert.deepEqual(
            [await page.inputValue("#ask-query"), await page.inputValue("#query")],
            [other.name, mine.name],
          );
          assert.equal(await linkOf(page), hash);
          await page.selectOption("#ask-query", "");
          assert.deepEqual(await atRest(page), own);
          // Planning the other query anew remains what it was.
          await page.selectOption("#query", other.name);
          assert.equal((await atRest(page)).iterations, 0);
        },

        "a roadmap that has no path between two configurations says so; trees and races are not asked": async (
          page,
        ) => {
          await chooseScene(page, "locked");
          const { planner, start, goal } = roadmap("locked");
          assert.equal(planner.status, "exhausted");
          const own = await finish(page);
          assert.equal(own.status, "exhausted");
          const near = goal.map((value) => Number((value + 0.02).toFixed(2)));
          await hold(page, near);
          const none = answerOf(planner, near, goal);
          const solved = await ask(page, () => page.click("#ask-from"), HAS_PATH);
          assert.equal(none.status, "solved");
          assert.equal(solved.status, "solved");
          await page.click("#ask-own");
          await hold(
            page,
            start.map((value) => Number((value + 0.02).toFixed(2))),
          );
          const asked = await ask(
            page,
            () => page.click("#ask-from"),
            /^The roadmap has no path from this start to this goal: \d+ vertices visited in /,
          );
          assert.equal(asked.status, "exhausted");
          assert.equal(await page.innerText("#count-phase"), "not connected");
          await choosePlanner(page, "rrt", "step");
          await finish(page);
          await click(page, "#your-turn");
          assert.equal(await page.isVisible("#ask"), false);
        },

        "the stage stays where it is, axe finds nothing once a roadmap was asked, and fingers find the buttons": async (
          page,
        ) => {
          await finish(page);
          const place = () => page.locator("#stage").boundingBox();
          const before = await place();
          await hold(page, [1.55, 1.2]);
          assert.deepEqual(await place(), before);
          await assertTargets(page);
          await ask(page, () => page.click("#ask-from"), HAS_PATH);
          assert.deepEqual(await place(), before);
          await assertFaultless(page, "a roadmap that was asked");
          await assertTargets(page);
        },

        "queries whose start or goal is in collision are named as such, and follow the editor": async (page) => {
          const document = load("stones").document();
          const [{ start, goal }] = document.queries;
          assert.ok(goal);
          const hit = [2.2, -1.3];
          const touched = load("stones")
            .check(hit)
            .touching.map(({ obstacle }) => obstacle);
          assert.equal(new Set(touched).size, 1);
          const queries = [
            { name: "free", start, goal },
            { name: "from", start: hit, goal },
            { name: "to", start, goal: hit },
            { name: "both", start: hit, goal: hit },
            { name: "point", start: hit, target: { point: [1, 0] } },
          ];
          await openScenario(page, { ...document, queries });
          const texts = (/** @type {string} */ id) => page.locator(`#${id} option`).allInnerTexts();
          const named = [
            "free",
            "from (start in collision)",
            "to (goal in collision)",
            "both (start and goal in collision)",
            "point (start in collision)",
          ];
          assert.deepEqual(await texts("query"), named);
          assert.deepEqual(await texts("ask-query"), ["choose a query", ...named]);
          // A roadmap is not asked for what has no one goal.
          await choosePlanner(page, "prm", "samples");
          await finish(page);
          await page.selectOption("#ask-query", "from");
          await page.waitForSelector("#notice[data-code=start-in-collision]");
          await page.selectOption("#ask-query", "point");
          await page.waitForSelector("#notice[data-code=unsupported]");
          assert.equal(await page.inputValue("#ask-query"), "");
          // Without the obstacle all are free.
          await openEditor(page, null);
          await page.focus("#stage");
          for (let i = 0; i < 3 + Number(touched[0]); i++) await page.keyboard.press("]");
          await press(page, ["Delete"], "undo", 1);
          await atRest(page);
          assert.deepEqual(
            await texts("query"),
            queries.map(({ name }) => name),
          );
          await page.click("#edit-tools >> text=Undo");
          await until(page, "undo", 0);
          await atRest(page);
          assert.deepEqual(await texts("query"), named);
        },
      },
      restage,
    ),
  ));
