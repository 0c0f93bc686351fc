/** Several robots are put into another order; who is in the way is shown. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { fill, pixelsOf, useBrowser } from "./browser.mjs";
import { inTurn } from "./turns.mjs";
import { onFleet, replanned, chooseFleet, fleetOf, planned, putBack } from "./fleet.mjs";
import { told } from "./stage.mjs";

useBrowser();

test("a fleet is put into an order", (t) =>
  onFleet(
    inTurn(
      t,
      {
        "a robot is moved in the order by keys, by buttons and by dragging; each time the plan is that of the order":
          async (page) => {
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
            assert.equal(
              (await replanned(page, () => page.click("#first"))).order,
              ["3", "2", "1", ...names.slice(3)].join(),
            );
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
          },

        "a swap is planned for; put into an order it has no plan, and the page shows who is in the way; other planners are offered":
          async (page) => {
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
          },

        "another order is faster, or fails; then the robot that found no way can be planned first": async (page) => {
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
        },
      },
      putBack,
    ),
  ));
