/** The link is copied, or can be; a broken one is said and does no harm. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { decodeLink, encodeLink } from "../../www/planner/link/codec.js";
import { PHONE, atRest, click, counters, isDeep, onPage, onPausedPage, seek, useBrowser } from "./browser.mjs";
import { inTurn, openState, restage } from "./turns.mjs";
import { shown, afresh } from "./links.mjs";

/** @import { Experiment } from "../../www/planner/link/codec.js" */

useBrowser();

test("the link is copied; a broken one is refused", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the button copies the link, says what it did, and leaves the link in the address bar": async (page) => {
          await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
          await seek(page, 137);
          await page.click("#link");
          await page
            .getByText("Link copied. It stores the scene, the settings and iteration 137.", { exact: true })
            .waitFor();
          assert.equal(await page.evaluate(() => navigator.clipboard.readText()), page.url());
          assert.match(page.url(), /#1[\w-]+$/);
        },

        "a broken link is refused and changes nothing; a good address is obeyed": async (page) => {
          const good = await encodeLink({
            version: 1,
            scene: "shelf",
            lanes: [{ algorithm: "rrt", settings: { seed: 4 } }],
            iteration: 40,
            view: {},
          });
          // The decoder alone is tried with hundreds of others in exchange-link.test.mjs.
          const broken = [
            "1",
            "0",
            "nonsense",
            "stage",
            "%",
            "%F0%9F",
            "1====",
            `2${good.slice(1)}`,
            good.slice(1),
            `${good}.`,
            "1AAAA",
            "javascript:alert(1)",
            `1${"A".repeat(70000)}`,
            good.slice(0, 20),
            good.slice(0, -8),
            `${good.slice(0, 9)}xxxx${good.slice(13)}`,
          ];
          const usual = await shown(page);
          // That a fresh page opens as ever is shown for every page in pages.test.mjs.
          for (const fragment of broken) {
            if (isDeep) {
              await afresh(`#${fragment}`, async (fresh) => {
                await fresh.waitForSelector("#notice:not([hidden])");
                assert.match(await fresh.innerText("#notice strong"), /^This link does not work: .+\.$/, fragment);
                assert.deepEqual((await shown(fresh)).numbers, usual.numbers, fragment);
                assert.equal(await fresh.getAttribute("body", "data-scene"), "stones");
              });
            } else {
              await page.evaluate((hash) => {
                const notice = /** @type {HTMLElement} */ (document.getElementById("notice"));
                notice.hidden = true;
                location.hash = hash;
              }, fragment);
              await page.waitForSelector("#notice:not([hidden])");
              assert.match(await page.innerText("#notice strong"), /^This link does not work: .+\.$/, fragment);
            }
          }
          await click(page, "#notice button");
          assert.deepEqual(await shown(page), usual, "the stage is as it was");
          const fragment = await encodeLink({
            version: 1,
            scene: "rings",
            lanes: [{ algorithm: "prm", settings: { seed: 2 } }],
            iteration: 12,
            view: {},
          });
          await page.evaluate((hash) => {
            location.hash = hash;
          }, fragment);
          await page.waitForSelector("body[data-scene=rings]");
          assert.equal((await atRest(page)).iterations, 12);
          assert.equal(await page.inputValue("#parameter-seed"), "2");
        },

        "what the page cannot restore is said in a notice, beside what is restored": async (page) => {
          const unreadable = {
            format: "planarium-scenario-1",
            name: "x",
            world: { obstacles: [{ type: "disc", center: [0, 0], radius: -1 }] },
            robot: { type: "disc", radius: 1 },
            queries: [],
          };
          /** @type {[Partial<Experiment>, RegExp, Record<string, string>][]} */
          const cases = [
            [
              { scene: "atlantis", lanes: [{ algorithm: "rrt", settings: { seed: 5 } }] },
              /There is no scene "atlantis"; the first scene is shown instead/,
              { scene: "stones", planner: "rrt", "parameter-seed": "5" },
            ],
            [
              { lanes: [{ algorithm: "prm", settings: { samples: 20 } }], iteration: 987654 },
              /The run ends at iteration \d+, before 987,654/,
              { planner: "prm", "parameter-samples": "20" },
            ],
            [
              { scene: undefined, document: unreadable, iteration: 0 },
              /^The link cannot be opened\.[^]*radius/,
              { scene: "stones" },
            ],
            [{ scene: "parking", drive: { start: [0, 0, 0] } }, /start/, { scene: "parking" }],
            [{ scene: "parking", roll: [9, 0, 1] }, /v must lie within/, { scene: "parking" }],
            [
              { scene: "passage", options: { width: 99, thickness: 0.2 } },
              /99 is above/,
              { scene: "passage", "option-width": "0.2" },
            ],
          ];
          for (const [given, sentence, restored] of cases) {
            const experiment = {
              version: /** @type {const} */ (1),
              scene: "firs",
              lanes: [{ algorithm: "prm", settings: {} }],
              iteration: 3,
              view: {},
              ...given,
            };
            await restage(page);
            await openState(page, await encodeLink(experiment));
            await page.waitForSelector("#notice:not([hidden])");
            assert.match(await page.innerText("#notice"), sentence);
            if ((given.iteration ?? 3) === 3) assert.equal((await counters(page)).iterations, 3, String(sentence));
            for (const [id, value] of Object.entries(restored)) {
              if (id === "scene") assert.equal(await page.getAttribute("body", "data-scene"), value);
              else assert.equal(await page.inputValue(`#${id}`), value, `${sentence}: ${id}`);
            }
          }
        },
      },
      restage,
    ),
  ));

test("where the clipboard is closed, the link is selected in a field", () =>
  onPage(
    { reducedMotion: "reduce", viewport: PHONE.viewport },
    async (page) => {
      await page.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
      await click(page, "#step-10");
      await page.click("#link");
      const field = page.locator("#link-told input");
      await field.waitFor();
      const link = await field.inputValue();
      assert.equal(await page.evaluate(() => getSelection()?.toString()), link);
      assert.match(
        await page.innerText("#link-told"),
        /^Copy this link\. It stores the scene, the settings and iteration 10\./,
      );
      const { experiment } = await decodeLink(new URL(link).hash);
      assert.deepEqual([experiment?.scene, experiment?.iteration], ["stones", 10]);
      const box = await page.locator("#link-told").boundingBox();
      assert.ok(box && box.x >= 0 && box.x + box.width <= 390, "it is within the page");
      await page.keyboard.press("Escape");
      assert.equal(await field.isVisible(), false);
      assert.equal(await page.evaluate(() => document.activeElement?.id), "link");
    },
    {
      before: async (page) => {
        await page.addInitScript(() => {
          const closed = () => {
            throw new DOMException("closed", "SecurityError");
          };
          Object.defineProperty(window, "localStorage", { get: closed });
          Object.defineProperty(navigator, "clipboard", { get: closed });
          history.replaceState = closed;
        });
      },
    },
  ));
