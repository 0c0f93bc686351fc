import { Scenario } from "planarium";
import { SIDE, makeGallery } from "./gallery.js";
import { drawThumbnail } from "../draw/thumbnail.js";

/** @import { App } from "../app/app.js" */
/** @import { ScenarioDocument } from "../domain/types.js" */

/**
 * The gallery of the pages beside the planner's: scenes with thumbnails that follow the theme. A scene that cannot be
 * loaded has none.
 * @template {{ id: string, title: string }} E
 * @param {App} app
 * @param {E[]} entries
 * @param {(entry: E) => ScenarioDocument | Promise<ScenarioDocument>} documentOf  for the thumbnail
 * @param {(entry: E) => void} onChoose
 */
export function makeSceneGallery(app, entries, documentOf, onChoose) {
  const gallery = makeGallery(entries, onChoose);
  const draw = (/** @type {string} */ id, /** @type {ScenarioDocument} */ document) => {
    const scenario = Scenario.parse(document);
    gallery.draw(id, drawThumbnail(scenario, SIDE, app.look));
    scenario.free();
  };
  const drawAll = () => {
    for (const entry of entries) {
      const document = documentOf(entry);
      if (document instanceof Promise)
        void document.then(
          (loaded) => draw(entry.id, loaded),
          () => {},
        );
      else draw(entry.id, document);
    }
  };
  app.onTheme(drawAll);
  drawAll();
  return gallery;
}
