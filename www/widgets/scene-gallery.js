import { Scenario } from "planarium";
import { SIDE, makeGallery } from "./gallery.js";
import { drawThumbnail } from "../draw/thumbnail.js";

/** @import { App } from "../app/app.js" */
/** @import { ScenarioDocument } from "../domain/types.js" */

/**
 * The gallery of the pages beside the planner's: scenes with thumbnails that follow the theme.
 * @template {{ id: string, title: string }} E
 * @param {App} app @param {E[]} entries @param {(entry: E) => ScenarioDocument} documentOf  for the thumbnail @param {(entry: E) => void} onChoose
 */
export function makeSceneGallery(app, entries, documentOf, onChoose) {
  const gallery = makeGallery(entries, onChoose);
  const drawAll = () => {
    const { look } = app;
    for (const entry of entries) {
      const scenario = Scenario.parse(documentOf(entry));
      gallery.draw(entry.id, drawThumbnail(scenario, SIDE, look));
      scenario.free();
    }
  };
  app.onTheme(drawAll);
  drawAll();
  return gallery;
}
