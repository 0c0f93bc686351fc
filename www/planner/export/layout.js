/** The layout of the figures on the stage, for images of it. */
import { byId } from "../../app/dom.js";

/** @typedef {ReturnType<typeof layoutOfStage>} Layout   in CSS pixels from the corner of the stage */

export function layoutOfStage() {
  const stage = byId("stage", HTMLElement);
  const { left, top, width, height } = stage.getBoundingClientRect();
  return {
    width,
    height,
    sheets: [...stage.querySelectorAll("figure")].map((figure) => {
      const [sheet, caption] = [".sheet", "figcaption"].map(
        (part) => /** @type {HTMLElement} */ (figure.querySelector(part)),
      );
      const [at, above] = [sheet.getBoundingClientRect(), caption.getBoundingClientRect()];
      const padding = parseFloat(getComputedStyle(caption).paddingLeft);
      return {
        id: figure.id,
        x: at.left - left,
        y: at.top - top,
        caption: {
          x: above.left - left + padding,
          y: above.top - top,
          width: above.width - 2 * padding,
          name: caption.querySelector("span")?.innerText ?? "",
          note: caption.querySelector("small")?.innerText ?? "",
        },
      };
    }),
  };
}
