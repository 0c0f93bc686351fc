/** What tests of the planner's links share. */
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { atRest, onPage, pictureOf } from "./browser.mjs";

/** @import { Page } from "playwright-core" */

/** Everything that a link is to bring back. @param {Page} page */
export async function shown(page) {
  // A stage whose size has changed knows of it by the second frame.
  await page.evaluate(
    () =>
      new Promise((resolve) => {
        requestAnimationFrame(() => requestAnimationFrame(resolve));
      }),
  );
  const numbers = await atRest(page);
  // The sliders of a scene are loaded when it is first opened.
  const scene = await page.getAttribute("body", "data-scene");
  const sliders = SCENES.find(({ id }) => id === scene)?.sliders?.length ?? 0;
  await page.waitForFunction((count) => document.querySelectorAll(".sliders input").length === count, sliders);
  const words = await page.evaluate(() => ({
    scene: document.body.dataset.scene,
    sentence: document.getElementById("story")?.textContent,
    head: /** @type {HTMLInputElement} */ (document.getElementById("time")).value,
    playing: document.getElementById("play")?.dataset.playing,
    fields: [
      ...document.querySelectorAll(
        "#planner, #query, #parameters input, #parameters select, #more-parameters input, #more-parameters select, .sliders input",
      ),
    ].map((element) => {
      const control = /** @type {HTMLInputElement} */ (element);
      return [control.id, control.type === "checkbox" ? control.checked : control.value];
    }),
  }));
  return { numbers, words, pictures: await pictureOf(page, "#stage canvas") };
}

/** Opens a fragment in a window of its own. @param {string} fragment @param {(fresh: Page) => Promise<void>} then */
export const afresh = (fragment, then) =>
  onPage(
    { reducedMotion: "reduce" },
    async (fresh) => {
      await fresh.waitForSelector("#counters[data-settled=true]", { state: "attached" });
      await then(fresh);
    },
    { path: fragment },
  );
