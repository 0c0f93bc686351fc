/** A link is an experiment: what it holds is put on the stage exactly. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { decodeLink, encodeLink } from "../../www/planner/link/codec.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { endsOf, load } from "./library.mjs";
import {
  atRest,
  choose,
  chooseScene,
  click,
  finish,
  isDeep,
  linkOf,
  onPage,
  onPausedPage,
  pixelsOf,
  openScenario,
  seek,
  setParameter,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { inTurn, restage } from "./turns.mjs";
import { shown, afresh } from "./links.mjs";

/** @import { Page } from "playwright-core" */
/** @import { Experiment } from "../../www/planner/link/codec.js" */

useBrowser();

/**
 * A page's link, opened elsewhere, shows the same.
 * @param {Page} page
 * @param {string} what
 * @returns {Promise<Experiment>}
 */
async function roundTrip(page, what) {
  const fragment = await linkOf(page);
  const here = await shown(page);
  await afresh(fragment, async (fresh) => {
    assert.deepEqual(await shown(fresh), here, what);
    assert.equal(await fresh.locator("#notice").isVisible(), false, `${what}: nothing is amiss`);
    assert.equal(await linkOf(fresh), fragment, `${what}: the link of a link is that link`);
  });
  const { experiment } = await decodeLink(fragment);
  return experiment ?? assert.fail(what);
}

test("a link brings back what the page shows", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a scene of every kind, in 2 kB, at an iteration on the way": async (page) => {
          // A disc has one figure, a car two that are planes; an arm is in the tests below.
          const kinds = ["rings", "blossom"];
          for (const [i, { id }] of SCENES.entries()) {
            if (!isDeep && !kinds.includes(id)) continue;
            if (i > 0) await chooseScene(page, id);
            await seek(page, 11 + 3 * i);
            const experiment = await roundTrip(page, id);
            assert.equal(experiment.scene, id);
            assert.equal(experiment.document, undefined);
            const link = page.url();
            assert.ok(link.length <= 2048, `${id}: ${link.length} characters`);
            assert.ok(
              Object.keys(experiment.lanes[0].settings).length <= Object.keys(SCENES[i].settings).length,
              "what is the planner's default is left out",
            );
          }
        },

        "an rrt at iteration 137, and at its end with its path": async (page) => {
          await chooseScene(page, "pillar");
          await setParameter(page, "seed", "9007199254740991");
          await setParameter(page, "goal_bias", "0.125");
          await seek(page, 137);
          const { experiment } = await decodeLink(await linkOf(page));
          assert.ok(experiment);
          assert.equal(experiment.iteration, 137);
          assert.deepEqual(experiment.lanes, [
            { algorithm: "rrt", settings: { step: 0.3, goal_bias: 0.125, seed: 9007199254740991 } },
          ]);
          await finish(page);
          await roundTrip(page, "at the end");
        },

        "a link holds a moved slider, a generated scene, and a scenario from a file with its query": async (page) => {
          await chooseScene(page, "passage");
          await page.fill("#option-width", "0.44");
          await atRest(page);
          await seek(page, 30);
          const moved = await roundTrip(page, "slider");
          assert.deepEqual(moved.options, { width: 0.44 });

          await page.click("#make-fold > summary");
          await page.selectOption("#make-kind", "maze");
          await page.fill("#make-seed", "12");
          await page.click("#make button");
          await page.waitForSelector("body[data-scene=file]");
          await atRest(page);
          await seek(page, 25);
          const made = await roundTrip(page, "made");
          assert.equal(made.scene, "make-maze");
          assert.equal(made.document, undefined);

          const document = {
            format: "planarium-scenario-1",
            name: "own",
            world: {
              bounds: { min: [0, 0], max: [4, 3] },
              obstacles: [{ type: "disc", center: [2, 1.5], radius: 0.5 }],
            },
            robot: { type: "disc", radius: 0.1 },
            queries: [
              { name: "across", start: [0.5, 1.5], goal: [3.5, 1.5] },
              { name: "up \u2191", start: [0.5, 0.5], goal: [0.5, 2.5] },
            ],
          };
          await openScenario(page, document);
          await page.waitForSelector("#query-row:not([hidden])");
          await page.selectOption("#query", "up \u2191");
          await atRest(page);
          await seek(page, 9);
          const own = await roundTrip(page, "own");
          assert.deepEqual([own.scene, own.query, own.document?.name], [undefined, "up \u2191", "own"]);
        },

        "the configuration in hand comes back, free or in collision": async (page) => {
          await seek(page, 40);
          await page.click("#your-turn");
          const stones = load("stones");
          const [, second] = endsOf(stones.document().queries[0])[0];
          const angles = Array.from({ length: 60 }, (_, i) => Number((i / 10 - 3).toFixed(1)));
          for (const free of [false, true]) {
            const value = String(angles.find((angle) => stones.check([angle, second]).free === free));
            await page.fill("#pose-0-number", value);
            await page.press("#pose-0-number", "Enter");
            await page.waitForSelector(`#touching[data-free=${free}]:not(:empty)`);
            // Whether it is free is not in the link: the page says it of either.
            if (free && !isDeep) continue;
            const { pose, iteration } = await roundTrip(page, `in hand, ${free}`);
            assert.deepEqual([pose?.[0], pose?.length, iteration], [Number(value), 2, 40]);
            assert.match(await page.innerText("#link-told"), /iteration 40 and the configuration in hand/);
          }
          assert.equal(await page.innerText("#your-turn"), "Watch again");
        },

        "a drive comes back: it is replayed at once to the same place": async (page) => {
          await chooseScene(page, "parking");
          await page.click("#your-turn");
          await page.waitForSelector("#drive:not([hidden])");
          for (const key of ["w", "w", "a", "c", "d", "d"]) await page.keyboard.press(key);
          await page.waitForSelector("#drive[data-keys='6']");
          const { drive, roll } = await roundTrip(page, "a drive");
          assert.deepEqual([drive, roll], [{ keys: "0w25w25a25c25d25d", steps: 150 }, undefined]);
          const there = await dash(page);
          await onPage(
            {},
            async (fresh) => {
              await fresh.waitForSelector("#drive[data-replaying=true]", { state: "attached" });
              await fresh.waitForSelector("#drive[data-replaying=false][data-paused=true]", { state: "attached" });
              assert.deepEqual(await dash(fresh), there);
            },
            { path: await drivenOn({ drive }) },
          );
        },

        "a race comes back with its rivals and its picture, and rests at its own time": async (page) => {
          await unfold(page, "race");
          for (const [algorithm, lens] of [
            ["rrt", "workspace"],
            ["prm-star", "cspace"],
          ]) {
            await page.selectOption("#rival", algorithm);
            await page.click("#add-rival");
            await choose(page, "lens", lens);
            await click(page, "#step-100");
            if (!isDeep && algorithm === "rrt") continue;
            const race = await roundTrip(page, `against ${algorithm}`);
            assert.equal(race.lanes[race.lanes.length - 1].algorithm, algorithm);
            assert.equal(race.view.lens, lens === "workspace" ? undefined : lens);
          }
          /** @type {Experiment["lanes"]} */
          const lanes = [
            { algorithm: "prm", settings: { samples: 80 } },
            { algorithm: "rrt", settings: { seed: 3 } },
          ];
          const fragment = `#${await encodeLink({ version: 1, scene: "stones", lanes, iteration: 900, view: { strobe: true } })}`;
          await afresh(fragment, async (fresh) => {
            assert.equal(await fresh.inputValue("#time"), "900");
            assert.equal(await fresh.inputValue("#parameter-samples"), "80");
            const { experiment } = await decodeLink(await linkOf(fresh));
            assert.deepEqual(experiment?.lanes, lanes);
            assert.equal(experiment?.iteration, 900);
          });
        },
      },
      restage,
    ),
  ));

test("what is to be seen comes back: axes, crosses, poses, the path as it was found", async () => {
  /** @type {Experiment} */
  const wanted = {
    version: 1,
    scene: "tentacle",
    lanes: [{ algorithm: "rrt", settings: {} }],
    iteration: 20,
    view: { axes: [4, 1], refused: true, strobe: true, poses: 5, raw: true, slice: true, projector: true },
  };
  await afresh(`#${await encodeLink(wanted)}`, async (fresh) => {
    await unfold(fresh, "view");
    await fresh.waitForSelector("#view-across", { state: "attached" });
    assert.deepEqual(
      [
        await fresh.inputValue("#view-across"),
        await fresh.inputValue("#view-up"),
        await fresh.inputValue("#view-poses"),
      ],
      ["4", "1", "5"],
    );
    assert.equal(await fresh.getAttribute("#projector", "aria-pressed"), "true");
    const { experiment } = await decodeLink(await linkOf(fresh));
    assert.deepEqual(experiment, wanted);
  });
});

test("a link of a scene with many obstacles opens it with its zoom", async () => {
  const disc = (/** @type {number} */ i) => ({
    type: "disc",
    center: [1 + (i % 20), 1 + Math.floor(i / 20)],
    radius: 0.2,
  });
  const document = {
    format: "planarium-scenario-1",
    name: "pegs",
    world: { bounds: { min: [0, 0], max: [21, 11] }, obstacles: Array.from({ length: 200 }, (_, i) => disc(i)) },
    robot: { type: "disc", radius: 0.1 },
    queries: [{ name: "across", start: [0.5, 0.5], goal: [20.5, 10.5] }],
  };
  const lanes = [{ algorithm: "rrt", settings: {} }];
  const wanted = /** @type {Experiment} */ (/** @type {unknown} */ ({ document, lanes, iteration: 0, view: {} }));
  await afresh(`#${await encodeLink(wanted)}`, async (fresh) => {
    await fresh.waitForSelector("#zoom-in");
    const fine = () => pixelsOf(fresh, "workspace", "ground", "obstacle-edge");
    const whole = await fine();
    await click(fresh, "#zoom-in");
    assert.notEqual(await fine(), whole);
    await chooseScene(fresh, "stones");
    assert.ok(await fresh.isHidden("#zoom-in"));
  });
});

/** @param {Partial<Experiment>} hand @returns {Promise<string>} */
const drivenOn = async (hand) =>
  `#${await encodeLink({ version: 1, scene: "parking", lanes: [{ algorithm: "rrt", settings: {} }], iteration: 0, view: {}, ...hand })}`;

/** The state of the drive that the page shows. @param {Page} page */
const dash = (page) =>
  page
    .locator("#drive")
    .evaluate((bar) => ({ .../** @type {HTMLElement} */ (bar).dataset, replaying: "", paused: "" }));

test("the motion of one control comes back, from the start and from the end of a drive", async () => {
  for (const hand of /** @type {Partial<Experiment>[]} */ ([
    { roll: [0.3, 0.4, 1.5] },
    { drive: { start: [1.2, 0.62, 0.2], keys: "0w25c", steps: 50 }, roll: [-0.2, -0.3, 1], euler: 0.25 },
  ])) {
    await afresh(await drivenOn(hand), async (fresh) => {
      await fresh.waitForSelector("#drive:not([hidden])");
      assert.match(await fresh.innerText("#drive .roll .hint"), /^Free for/);
      assert.deepEqual(
        await Promise.all(["v", "phi", "duration"].map(async (id) => Number(await fresh.inputValue(`#roll-${id}`)))),
        hand.roll,
      );
      assert.equal(await fresh.isVisible("#notice"), false);
      const { experiment } = await decodeLink(await linkOf(fresh));
      assert.deepEqual([{ keys: "", steps: 0, ...hand.drive }, experiment?.roll], [experiment?.drive, hand.roll]);
      assert.equal(experiment?.euler, hand.euler);
      assert.equal(await fresh.isChecked("#drive-euler"), hand.euler !== undefined);
      if (hand.euler) assert.equal(await fresh.inputValue("#drive-dt"), String(hand.euler));
      assert.match(await fresh.innerText("#link-told"), /the drive with its control/);
    });
  }
});
