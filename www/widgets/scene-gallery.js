/** The gallery of the pages beside the planner's: scenes with thumbnails that follow the theme. */
import { Scenario } from "planarium";
import { Gallery, SIDE } from "./gallery.js";
import { drawThumbnail } from "../draw/thumbnail.js";

/** @import { App } from "../app/app.js" */
/** @import { ScenarioDocument } from "../domain/types.js" */

/** @template {{ id: string, title: string }} E */
export class SceneGallery extends Gallery {
  /** @param {App} app @param {E[]} entries @param {(entry: E) => ScenarioDocument} documentOf  for the thumbnail @param {(entry: E) => void} onChoose */
  constructor(app, entries, documentOf, onChoose) {
    super(/** @type {any[]} */ (entries), (entry) => onChoose(/** @type {E} */ (/** @type {unknown} */ (entry))));
    const drawAll = () => {
      const { look } = app;
      for (const entry of entries) {
        const scenario = Scenario.parse(documentOf(entry));
        this.draw(entry.id, drawThumbnail(scenario, SIDE, look));
        scenario.free();
      }
    };
    app.onTheme(drawAll);
    drawAll();
  }
}
