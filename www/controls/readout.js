/** What is pointed at, in one line beneath the stage, and the vertex by its number for those without a pointer. */
import { write } from "./counters.js";
import { byId, make } from "./dom.js";

/** @import { Page } from "../page.js" */

/** @param {Page} page */
export function watchReadout(page) {
  const readout = byId("readout", HTMLOutputElement);
  const hint = matchMedia("(hover: hover)").matches ? "Point at a vertex to read what it is." : "";
  const number = make("input", { type: "number", id: "inspect", min: "0", step: "1", autocomplete: "off", placeholder: "none" });
  byId("view", HTMLElement).append(make("div", { className: "field" },
    make("label", { className: "row" }, make("span", { className: "name" }, "Vertex to read"), number),
    make("p", { className: "hint" }, "Its number, or point at it: both panes show where it is, the line beneath the stage what it is.")));
  number.addEventListener("input", () => page.studio.tell("inspect", number.value === "" ? -1 : Math.max(0, Math.floor(Number(number.value)))));
  // Who moves from number to number hears what each is; who moves a pointer does not.
  number.addEventListener("focus", () => readout.setAttribute("aria-live", "polite"));
  number.addEventListener("blur", () => readout.setAttribute("aria-live", "off"));
  page.onState(({ hover, lanes }) => {
    const most = String(Math.max(0, lanes[0].vertices - 1));
    if (number.max !== most) number.max = most;
    write(readout, hover ? hover.text : hint);
    if (hover) Object.assign(readout.dataset, { vertex: String(hover.vertex), free: String(hover.free) });
    else {
      delete readout.dataset.vertex;
      delete readout.dataset.free;
    }
  });
}
