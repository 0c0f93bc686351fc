/** The scenes in which tests of the editor draw. */
import { openEditor, plane } from "./editing.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */
/** @typedef {(page: Page, at: Awaited<ReturnType<typeof plane>>) => Promise<void>} Act */

/** A square world with one disc and one triangle, for a disc robot: pixels differ clearly. @type {ScenarioDocument} */
export const PLAIN = {
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

/** The editor on the plain scenario. @param {Act} act @param {ScenarioDocument} [document] */
export const onPlain =
  (act, document = PLAIN) =>
  async (/** @type {Page} */ page) => {
    await openEditor(page, document);
    await act(page, await plane(page, 1));
  };

/** The editor on the scene that the page opens with. @param {Act} act */
export const onStones = (act) => async (/** @type {Page} */ page) => {
  await openEditor(page, null);
  await act(page, await plane(page, 1.2));
};
