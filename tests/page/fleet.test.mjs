/** The page of several robots: it plans and plays, and shows who waits. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Fleet, fleetGenerators, fleetPlanners } from "planarium/full";
import { Trajectory, straightOf } from "../../www/fleet/trajectory.js";
import { download, dropFile, fill, linkOf, pickFile, pictureOf, pixelsOf, pressUntil, useBrowser } from "./browser.mjs";
import { inTurn } from "./turns.mjs";
import { onFleet, replanned, chooseFleet, fleetOf, planned, putBack } from "./fleet.mjs";
import { CALM, rest, told } from "./stage.mjs";

/** @typedef {import("playwright-core").Page} Page */

useBrowser();

/**
 * Robots that stand at a time between two rows of the same place, and go on later, from 1.
 * @param {import("planarium/full").FleetResult} result
 * @param {number} time
 */
function waitingAt({ robots }, time) {
  return robots.flatMap(({ times, path }, i) => {
    const row = times.findLastIndex((one) => one <= time);
    const isLater = path.slice(row + 1).some((q) => String(q) !== String(path[row]));
    return isLater && String(path[row]) === String(path[row + 1]) ? [i + 1] : [];
  });
}

/** Shows a time. @param {Page} page @param {number} time */
async function seek(page, time) {
  await page.fill("#time", String(time));
  await rest(page, `[data-time='${time.toFixed(3)}']`);
}

test("poses, waits and arrivals equal the core's, and straight trajectories meet where it says", () => {
  for (const id of ["crossroads", "bodies"]) {
    const fleet = fleetOf(id);
    const { planner, result } = planned(fleet);
    const ways = result.robots.map((_, i) => new Trajectory(planner.trajectory(i)));
    for (let time = 0; time < result.makespan + 1; time += 0.37) {
      const poses = planner.posesAt(time);
      ways.forEach((way, i) =>
        way
          .at(time)
          .forEach((value, j) =>
            assert.ok(Math.abs(Math.sin((value - poses[3 * i + j]) / 2)) < 1e-9, `${id}, robot ${i} at ${time}`),
          ),
      );
      assert.deepEqual(
        ways.flatMap((way, i) => (way.isWaiting(time) ? [i + 1] : [])),
        waitingAt(result, time),
      );
    }
    assert.ok(Math.abs(ways.reduce((sum, { waits }) => sum + waits, 0) - result.waits) < 1e-9);
    assert.equal(Math.max(...ways.map(({ arrival }) => arrival)), result.makespan);
    const straight = fleet.toJSON().robots.map(straightOf);
    const conflicts = fleet.straightConflicts();
    assert.ok(conflicts.length > 0);
    for (const { robots, places, from } of conflicts) {
      robots.forEach((robot, k) =>
        straight[robot]
          .at(from)
          .forEach((value, j) => assert.ok(Math.abs(value - places[k][j]) < 1e-9, `${id}: ${robots} at ${from}`)),
      );
    }
  }
});

test("at first a fleet is planned for and plays by itself; with reduced motion its plan is shown", async () => {
  await onFleet(async (page) => {
    await page.waitForSelector("#course-play[data-playing=true]");
    await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.time) > 0.2);
  }, {});
  await onFleet(async (page) => {
    const { status, fingerprint, verified, robots, order, end } = await told(page);
    const { result } = planned(fleetOf("ring"));
    assert.deepEqual([status, fingerprint, verified, robots], ["solved", result.fingerprint, "true", "12"]);
    assert.deepEqual(
      [result.order, order],
      [
        undefined,
        fleetOf("ring")
          .toJSON()
          .robots.map(({ name }) => name)
          .join(),
      ],
    );
    assert.equal(end, result.makespan.toFixed(3));
    assert.match(await page.innerText("#story"), /All 12 robots reach their goals in 7\.4 s, and no two of them touch/);
    assert.equal(await page.innerText("#fact-waits"), `${result.waits.toFixed(1)} s`);
    assert.match(await page.innerText("#fact-verified"), /no conflict/);
    assert.equal(await page.getAttribute("#course-play", "data-playing"), "false");
  });
});

test("the roadmap grows in view, and can be hidden", () =>
  onFleet(async (page) => {
    await page.waitForSelector("#course-play[data-playing=true]");
    const seen = await page.evaluate(
      () =>
        new Promise((/** @type {(seen: { vertices: number[], story: string }) => void} */ resolve) => {
          const stage = document.getElementById("stage") ?? document.body;
          /** @type {Set<number>} */
          const vertices = new Set();
          let story = "";
          const watch = new MutationObserver(() => {
            const { status, robots } = stage.dataset;
            if (robots !== "8") return;
            if (status === "running") {
              vertices.add(Number(stage.dataset.vertices));
              story ||= document.getElementById("story")?.textContent ?? "";
            }
            if (status !== "solved") return;
            watch.disconnect();
            resolve({ vertices: [...vertices], story });
          });
          watch.observe(stage, { attributes: true });
          /** @type {HTMLInputElement | null} */ (document.querySelector("input[value=crossroads]"))?.click();
        }),
    );
    assert.match(seen.story, /^A roadmap grows, which all 8 robots share: \d+ vert/);
    assert.ok(seen.vertices.length > 5, `${seen.vertices}`);
    const {
      result: { stats },
    } = planned(fleetOf("crossroads"));
    assert.ok(
      seen.vertices.every((count, i) => count <= stats.vertices && (i === 0 || count > seen.vertices[i - 1])),
      `${seen.vertices}`,
    );
    await page.waitForSelector("#course-play[data-playing=true]");
    await page.click("#course-play");
    await rest(page);
    const inked = async () => Number((await pictureOf(page, "#floor canvas[data-layer=roadmaps]"))[0].split(" ")[2]);
    const before = await inked();
    await page.click("#roadmap");
    await rest(page);
    assert.ok((await inked()) < before);
  }, {}));

test("a fleet is shown at any time, made, opened and exported", (t) =>
  onFleet(
    inTurn(
      t,
      {
        "a time is shown by slider, keys and the robots' times; who waits then is said": async (page) => {
          await chooseFleet(page, "crossroads");
          const { result } = planned(fleetOf("crossroads"));
          const picture = () => page.locator("#floor canvas[data-layer=top]").getAttribute("aria-label");
          const before = await picture();
          await seek(page, 3);
          assert.notEqual(await picture(), before);
          const waiting = waitingAt(result, 3);
          assert.ok(waiting.length > 0);
          assert.equal((await told(page)).waiting, waiting.join());
          assert.equal(await page.innerText("#fact-waiting"), waiting.join(", "));
          assert.equal(
            await page.getAttribute("#time", "aria-valuetext"),
            `3.0 of ${result.makespan.toFixed(1)} seconds`,
          );
          await page.focus("#stage");
          await pressUntil(page, "ArrowRight", "#stage[data-time='3.100']");
          await pressUntil(page, "Shift+ArrowLeft", "#stage[data-time='2.100']");
          await pressUntil(page, "r", "#stage[data-time='0.000']");
          const bar = (await page.locator("#robot-2 .bar").boundingBox()) ?? assert.fail();
          await page.mouse.click(bar.x + bar.width / 2, bar.y + bar.height / 2);
          await rest(page);
          assert.ok(Math.abs(Number((await told(page)).time) - result.makespan / 2) < 0.1);
          assert.equal(await page.getAttribute("#robot-2", "aria-selected"), "true");
          const second = result.robots[1].times.at(-1) ?? 0;
          assert.match(
            await page.innerText("#robot-2 .visually-hidden"),
            new RegExp(`^robot 2: arrives at ${second.toFixed(1)} s`),
          );
          await page.click("#course-play");
          await page.waitForFunction(
            (time) => Number(document.getElementById("stage")?.dataset.time) > time,
            result.makespan / 2 + 0.3,
          );
          await page.click("#course-play");
        },

        "how all would drive straight at once is shown, with the pairs that touch and when": async (page) => {
          await chooseFleet(page, "crossroads");
          const conflicts = fleetOf("crossroads").straightConflicts();
          const {
            robots: [a, b],
            from,
          } = conflicts[0];
          assert.equal(await page.locator("#conflicts button").count(), conflicts.length);
          await page.click("#straight");
          await rest(page, "[data-straight=true]");
          assert.match(await page.innerText("#story"), new RegExp(`${conflicts.length} pairs would touch`));
          await page.locator("#conflicts button").first().click();
          await rest(page, `[data-time='${from.toFixed(3)}']`);
          const touching = (await told(page)).touching.split(",");
          assert.ok(
            [a, b].every((robot) => touching.includes(String(robot + 1))),
            `${touching}`,
          );
          assert.ok((await pixelsOf(page, "floor", "top", "collision")) > 100);
          await page.click("#straight");
          await rest(page, "[data-straight=false][data-touching='']");
        },

        "every generator and planner has its options as fields; what is refused is said beside its field, and the fleet stays":
          async (page) => {
            await page.click("#make > summary");
            for (const { id, options } of fleetGenerators()) {
              if ((await page.inputValue("#kind")) !== id) await replanned(page, () => fill(page, "#kind", id));
              for (const { name, meaning } of options)
                assert.equal(
                  await page
                    .locator(`#fleet-${name}-meaning`)
                    .textContent()
                    .then((text) => text?.startsWith(meaning)),
                  true,
                  `${id} ${name}`,
                );
            }
            for (const { name } of fleetPlanners()[0].parameters)
              assert.equal(await page.locator(`#plan-${name}`).count(), 1, name);
            await replanned(page, () => fill(page, "#kind", "corridor"));
            const { plans } = await told(page);
            await fill(page, "#fleet-radius", "0.5");
            await rest(page);
            await fill(page, "#fleet-count", "16");
            await page.waitForSelector("#fleet-count-reason:not([hidden])");
            assert.match(await page.innerText("#fleet-count-reason"), /robots could be placed/);
            await rest(page);
            assert.equal((await told(page)).plans, String(Number(plans) + 1));
            const { fingerprint } = await replanned(page, () => fill(page, "#fleet-count", "4"));
            assert.equal(
              fingerprint,
              planned(Fleet.generate("corridor", { radius: 0.5, count: 4 })).result.fingerprint,
            );
            assert.equal(
              (await replanned(page, () => fill(page, "#plan-seed", "5"))).fingerprint,
              planned(Fleet.generate("corridor", { radius: 0.5, count: 4 }), { seed: 5 }).result.fingerprint,
            );
          },

        "a hundred robots have a row each; the list scrolls to the chosen one, and its way is shown": async (page) => {
          const { robots } = await chooseFleet(page, "crowd");
          assert.equal(robots, "100");
          assert.equal(await page.locator("#order > li").count(), 100);
          await seek(page, 5);
          const isInView = () =>
            page.locator("#robot-100").evaluate((row) => {
              const [inner, outer] = [row, row.closest("#lanes") ?? row].map((element) =>
                element.getBoundingClientRect(),
              );
              return inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1;
            });
          assert.equal(await isInView(), false);
          const before = await pictureOf(page, "#floor canvas[data-layer=top]");
          await page.focus("#order");
          await page.keyboard.press("End");
          await rest(page);
          assert.equal(await isInView(), true);
          assert.notDeepEqual(await pictureOf(page, "#floor canvas[data-layer=top]"), before);
        },

        "a fleet from a file is opened, linked and exported with its plan; a bad one is refused by code and pointer":
          async (page, url) => {
            const own = Fleet.generate("crossroads", { count: 3, seed: 9 });
            const document = own.toJSON();
            document.robots[0].name = "cart";
            const opened = await replanned(page, () => pickFile(page, "own.json", JSON.stringify(document)));
            const fleet = Fleet.parse(document);
            const { result } = planned(fleet);
            assert.equal(opened.fingerprint, result.fingerprint);
            assert.match(await page.innerText("#robot-1 .visually-hidden"), /^robot 1 \(cart\)/);
            await page.click("#export-fold > summary");
            assert.deepEqual(
              JSON.parse((await download(page, "#export-document")).text),
              JSON.parse(JSON.stringify(fleet)),
            );
            const saved = JSON.parse((await download(page, "#export-result")).text);
            assert.equal(fleet.verify(saved).valid, true);
            assert.match((await download(page, "#export-svg")).text, /<svg/);
            const touching = {
              ...document,
              robots: document.robots.map((robot, i) =>
                i === 1 ? { ...robot, start: document.robots[0].start } : robot,
              ),
            };
            await dropFile(page, "bad.json", JSON.stringify(touching));
            await page.waitForSelector("#notice[data-code=start-in-collision][data-pointer='/robots/1/start']");
            await dropFile(page, "text.json", "{");
            await page.waitForSelector("#notice[data-code=invalid-json]");
            await rest(page, "[data-status=solved]");
            assert.equal((await told(page)).fingerprint, result.fingerprint, "the fleet before stays");
            const fragment = await linkOf(page);
            await page.goto("about:blank");
            await page.goto(`${url}fleet.html${fragment}`);
            await rest(page, "[data-status=solved]");
            assert.equal((await told(page)).fingerprint, result.fingerprint);
          },
      },
      putBack,
    ),
  ));

test("a link holds the fleet, the planner, the order and the time", async () => {
  let fragment = "";
  /** @type {Record<string, string>} */
  let before = {};
  const reached = (/** @type {Record<string, string>} */ data) =>
    ["fingerprint", "order", "time", "planner", "straight", "verified"].map((name) => data[name]);
  await onFleet(async (page) => {
    await chooseFleet(page, "corridor");
    await page.click("#robot-4 .chip");
    await replanned(page, () => page.click("#up"));
    await seek(page, 2.5);
    fragment = await linkOf(page);
    before = await told(page);
  });
  await onFleet(
    async (page) => {
      await rest(page, "[data-time='2.500']");
      assert.deepEqual(reached(await told(page)), reached(before));
      assert.equal(await page.isHidden("#notice"), true);
    },
    {},
    fragment,
  );
  await onFleet(async (page) => {
    await chooseFleet(page, "swap");
    await replanned(page, () => fill(page, "#planner", "composite"));
    await replanned(page, () => fill(page, "#plan-seed", "3"));
    fragment = await linkOf(page);
    before = await told(page);
  });
  await onFleet(async (page) => assert.deepEqual(reached(await told(page)), reached(before)), CALM, fragment);
});
