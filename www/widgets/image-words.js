/** The switch of the words in images: what was run, the sentence of the page, and the legend. */
import { byId } from "../app/dom.js";
import { footOf } from "../draw/foot.js";
import { row, toggle } from "./elements.js";

/** @import { Layout } from "../draw/export.js" */

export class ImageWords {
  #input = toggle("export-words", () => {}, true);
  element = row("Title and legend in images", this.#input);

  /** @param {Layout} layout @param {string} head   what was run @returns {Layout} */
  addTo(layout, head) {
    if (!this.#input.checked) return layout;
    const [legend] = document.getElementsByClassName("legend");
    const sentence = byId("story", HTMLElement).innerText;
    return { ...layout, foot: footOf(layout.width, { head, sentence, legend, palette: layout.look.palette }) };
  }
}
