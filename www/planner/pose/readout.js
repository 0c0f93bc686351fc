/** A line below the stage about the element under the pointer. */
import { byId, write } from "../../app/dom.js";

/** @import { Page } from "../page.js" */

/** @param {Page} page */
export function watchReadout(page) {
  const readout = byId("readout", HTMLOutputElement);
  const hint = matchMedia("(hover: hover)").matches ? "Point at a vertex to see its details." : "";
  page.onState(({ hover }) => {
    write(readout, hover ? hover.text : hint);
    if (hover) Object.assign(readout.dataset, { vertex: String(hover.vertex), free: String(hover.free) });
    else {
      delete readout.dataset.vertex;
      delete readout.dataset.free;
    }
  });
}
