/**
 * The page of several robots, in Chromium: it plans and plays, shows who waits and who is in the way, and is put into
 * another order.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Fleet, fleetGenerators, fleetPlanners } from "planarium/full";
import { Trajectory, straightOf } from "../../www/fleet/trajectory.js";
import { SCENES } from "../../www/fleet/scenes.js";
import {
  choose,
  download,
  dropFile,
  fill,
  linkOf,
  onPage,
  pickFile,
  pictureOf,
  pixelsOf,
  pressUntil,
  useBrowser,
} from "./browser.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./browser.mjs").Options} Options */
/** @typedef {import("planarium/full").FleetOptions} FleetOptions */

useBrowser();

const CALM = /** @type {Options} */ ({ reducedMotion: "reduce" });

/**
 * Waits until nothing moves, nothing is computed and all is drawn.
 * @param {Page} page
 * @param {string} [stage]  what the stage says then
 */
const rest = (page, stage = "") => page.waitForSelector(`body[data-state=ready][data-settled=true] #stage${stage}`);

/** What the stage says of itself. @param {Page} page @returns {Promise<Record<string, string>>} */
const told = (page) =>
  page
    .locator("#stage")
    .evaluate((element) => /** @type {Record<string, string>} */ ({ .../** @type {HTMLElement} */ (element).dataset }));

/**
 * The page, opened; with reduced motion it has planned.
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {Options} [options]
 * @param {string} [fragment]
 */
const onFleet = (act, options = CALM, fragment = "") =>
  onPage(
    options,
    async (page, url) => {
      if (options.reducedMotion === "reduce") await rest(page, ":is([data-status=solved], [data-status=exhausted])");
      await act(page, url);
    },
    { path: `fleet.html${fragment}` },
  );

/**
 * Does something that begins a plan, and waits for its end.
 * @param {Page} page
 * @param {() => Promise<unknown>} act
 * @param {string} [status]
 */
async function replanned(page, act, status = "solved") {
  const { plans } = await told(page);
  await act();
  await page.waitForSelector(`#stage:not([data-plans='${plans}'])`);
  await rest(page, `[data-status=${status}]`);
  return told(page);
}

/** Chooses a ready fleet. @param {Page} page @param {string} id @param {string} [status] */
const chooseFleet = (page, id, status) => replanned(page, () => choose(page, "scene", id), status);

/** A ready fleet of the page. @param {string} id */
function fleetOf(id) {
  const { kind, options } = SCENES.find((entry) => entry.id === id) ?? assert.fail(id);
  return Fleet.generate(kind, options);
}

/** What the package plans. @param {Fleet} fleet @param {FleetOptions} [options] */
function planned(fleet, options) {
  const planner = fleet.planner(options);
  planner.step(1e9);
  return { result: planner.result(), planner };
}

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

test("a time is shown by slider, keys and the robots' times; who waits then is said", () =>
  onFleet(async (page) => {
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
    assert.equal(await page.getAttribute("#time", "aria-valuetext"), `3.0 of ${result.makespan.toFixed(1)} seconds`);
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
  }));

test("a robot is moved in the order by keys, by buttons and by dragging; each time the plan is that of the order", () =>
  onFleet(async (page) => {
    const fleet = fleetOf("ring");
    const names = fleet.toJSON().robots.map(({ name }) => name);
    const shown = () => page.locator("#order .chip").allInnerTexts();
    const { fingerprint: first } = await told(page);
    await page.focus("#order");
    await page.keyboard.press("Home");
    await page.waitForSelector("#order[aria-activedescendant=robot-1]");
    const swapped = ["2", "1", ...names.slice(2)];
    const moved = await replanned(page, () => page.keyboard.press("Alt+ArrowDown"));
    assert.deepEqual(await shown(), swapped);
    assert.deepEqual(
      [moved.order, moved.fingerprint],
      [swapped.join(), planned(fleet, { order: swapped }).result.fingerprint],
    );
    await page.click("#robot-3 .chip");
    assert.equal((await replanned(page, () => page.click("#first"))).order, ["3", "2", "1", ...names.slice(3)].join());
    const [from, to] = await Promise.all(
      [5, 3].map(async (robot) => (await page.locator(`#robot-${robot} .chip`).boundingBox()) ?? assert.fail()),
    );
    const drag = async () => {
      await page.mouse.move(from.x + 8, from.y + 8);
      await page.mouse.down();
      await page.mouse.move(to.x + 8, to.y + 8, { steps: 4 });
    };
    await drag();
    await page.keyboard.press("Escape");
    await page.mouse.up();
    assert.deepEqual(await shown(), ["3", "2", "1", ...names.slice(3)], "Escape puts it back");
    const dragged = await replanned(page, async () => {
      await drag();
      await page.mouse.up();
    });
    const order = ["5", "3", "2", "1", "4", ...names.slice(5)];
    assert.deepEqual(
      [dragged.order, dragged.fingerprint],
      [order.join(), planned(fleet, { order }).result.fingerprint],
    );
    assert.equal((await replanned(page, () => page.click("#any-order"))).fingerprint, first);
    assert.ok(await page.isDisabled("#any-order"));
  }));

test("a swap is planned for; put into an order it has no plan, and the page shows who is in the way; other planners are offered", () =>
  onFleet(async (page) => {
    const fleet = fleetOf("swap");
    const { planner, fingerprint } = await chooseFleet(page, "swap");
    assert.deepEqual([planner, fingerprint], ["pbs", planned(fleet).result.fingerprint]);
    /** @param {string} robot */
    const putFirst = async (robot) => {
      await page.click(`#robot-${robot} .chip`);
      return replanned(page, () => page.click("#first"), "exhausted");
    };
    const failed = await putFirst("2");
    const { result } = planned(fleet, { order: ["2", "1"] });
    assert.deepEqual(
      [failed.planner, failed.order, failed.blocked],
      ["prioritized", "2,1", [result.blocked?.robot, ...(result.blocked?.by ?? [])].join()],
    );
    assert.equal(result.reason, "order-limit");
    assert.match(
      await page.innerText("#story"),
      /No plan was found in this order. At last robot 2 found no path, because robot 1 was in its way/,
    );
    assert.equal(await page.innerText("#robot-1 .when"), "in the way");
    assert.equal(await page.getAttribute("#robot-2", "data-state"), "blocked");
    assert.ok((await pixelsOf(page, "floor", "top", "collision")) > 100);
    const opposite = await putFirst("1");
    assert.deepEqual([opposite.order, opposite.blocked], ["1,2", "1,2"], "the other order fails, too");
    const decided = await replanned(page, () => page.click("#try-default"));
    assert.deepEqual([decided.planner, decided.fingerprint], ["pbs", fingerprint]);
    assert.equal(await page.locator("#offer button").count(), 0);
    const exchanged = await chooseFleet(page, "exchange");
    assert.deepEqual(
      [exchanged.planner, exchanged.robots, exchanged.fingerprint],
      ["pbs", "8", planned(fleetOf("exchange")).result.fingerprint],
    );
    await page.waitForSelector("#stage[data-verified=true]");
    await chooseFleet(page, "swap");
    await putFirst("2");
    const composed = await replanned(page, () => page.click("#try-composite"));
    assert.equal(composed.planner, "composite");
    assert.equal(composed.fingerprint, planned(fleet, { algorithm: "composite" }).result.fingerprint);
    await page.waitForSelector("#stage[data-verified=true]");
    assert.equal(await page.locator("#try-composite").count(), 0);
    assert.equal(await page.inputValue("#planner"), "composite");
    await replanned(page, () => fill(page, "#planner", "prioritized"), "exhausted");
    await replanned(page, () => fill(page, "#planner", "composite"));
    await page.click("#make > summary");
    assert.equal(
      (await replanned(page, () => fill(page, "#kind", "hall"))).planner,
      "pbs",
      "twenty robots are too many for it",
    );
    assert.match(await page.innerText("#no-composite"), /two or three robots/);
  }));

test("another order is faster, or fails; then the robot that found no way can be planned first", () =>
  onFleet(async (page) => {
    await chooseFleet(page, "crossroads");
    const fleet = fleetOf("crossroads");
    const names = fleet.toJSON().robots.map(({ name }) => name);
    const orderOf = (/** @type {string} */ first) => [first, ...names.filter((name) => name !== first)];
    /** @param {string} robot @param {string} [status] */
    const planFirst = async (robot, status) => {
      if (await page.isEnabled("#any-order")) await replanned(page, () => page.click("#any-order"));
      await page.click(`#robot-${robot} .chip`);
      return replanned(page, () => page.click("#first"), status);
    };
    const { end } = await told(page);
    assert.ok(Number((await planFirst("3")).end) < Number(end), "as the text beside the fleet says");
    const {
      result: { blocked },
    } = planned(fleet, { order: orderOf("8") });
    const failed = await planFirst("8", "exhausted");
    assert.equal(failed.blocked, [blocked?.robot, ...(blocked?.by ?? [])].join());
    await replanned(
      page,
      () => page.click("#plan-first"),
      planned(fleet, { order: [blocked?.robot ?? "", ...orderOf("8").filter((name) => name !== blocked?.robot)] })
        .result.status,
    );
    assert.match((await told(page)).order, new RegExp(`^${blocked?.robot},8,`));
  }));

test("how all would drive straight at once is shown, with the pairs that touch and when", () =>
  onFleet(async (page) => {
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
  }));

test("every generator and planner has its options as fields; what is refused is said beside its field, and the fleet stays", () =>
  onFleet(async (page) => {
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
    assert.equal(fingerprint, planned(Fleet.generate("corridor", { radius: 0.5, count: 4 })).result.fingerprint);
    assert.equal(
      (await replanned(page, () => fill(page, "#plan-seed", "5"))).fingerprint,
      planned(Fleet.generate("corridor", { radius: 0.5, count: 4 }), { seed: 5 }).result.fingerprint,
    );
  }));

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

test("a fleet from a file is opened, linked and exported with its plan; a bad one is refused by code and pointer", () =>
  onFleet(async (page, url) => {
    const own = Fleet.generate("crossroads", { count: 3, seed: 9 });
    const document = own.toJSON();
    document.robots[0].name = "cart";
    const opened = await replanned(page, () => pickFile(page, "own.json", JSON.stringify(document)));
    const fleet = Fleet.parse(document);
    const { result } = planned(fleet);
    assert.equal(opened.fingerprint, result.fingerprint);
    assert.match(await page.innerText("#robot-1 .visually-hidden"), /^robot 1 \(cart\)/);
    await page.click("#export-fold > summary");
    assert.deepEqual(JSON.parse((await download(page, "#export-document")).text), JSON.parse(JSON.stringify(fleet)));
    const saved = JSON.parse((await download(page, "#export-result")).text);
    assert.equal(fleet.verify(saved).valid, true);
    assert.match((await download(page, "#export-svg")).text, /<svg/);
    const touching = {
      ...document,
      robots: document.robots.map((robot, i) => (i === 1 ? { ...robot, start: document.robots[0].start } : robot)),
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
  }));

test("a hundred robots have a row each; the list scrolls to the chosen one, and its way is shown", () =>
  onFleet(async (page) => {
    const { robots } = await chooseFleet(page, "crowd");
    assert.equal(robots, "100");
    assert.equal(await page.locator("#order > li").count(), 100);
    await seek(page, 5);
    const isInView = () =>
      page.locator("#robot-100").evaluate((row) => {
        const [inner, outer] = [row, row.closest("#lanes") ?? row].map((element) => element.getBoundingClientRect());
        return inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1;
      });
    assert.equal(await isInView(), false);
    const before = await pictureOf(page, "#floor canvas[data-layer=top]");
    await page.focus("#order");
    await page.keyboard.press("End");
    await rest(page);
    assert.equal(await isInView(), true);
    assert.notDeepEqual(await pictureOf(page, "#floor canvas[data-layer=top]"), before);
  }));
