/** What to copy so that what is on the stage stands in a page, in slides, in a notebook. */
import { experimentOf } from "../link/experiment.js";
import { make } from "../../app/dom.js";
import { encodeLink } from "../link/codec.js";

/** @import { Page } from "../page.js" */

/** @type {Record<string, { title: string, text: (address: string) => string }>} */
const KINDS = {
  page: {
    title: "A web page",
    text: (address) => `<iframe src="${address}" title="Planarium" width="100%" height="640" style="border: 0"></iframe>`,
  },
  slides: {
    title: "Reveal.js slides",
    text: (address) => `<section>\n  <iframe data-src="${address}" title="Planarium" width="100%" height="640" data-preload></iframe>\n</section>`,
  },
  notebook: {
    title: "A Jupyter notebook",
    text: (address) => `from IPython.display import IFrame\nIFrame("${address}", width="100%", height=640)`,
  },
};

/** @param {Page} page @param {HTMLElement} host */
export function showSnippets(page, host) {
  const kind = make("select", { id: "embed-kind", ariaLabel: "Embed as" }, ...Object.entries(KINDS).map(([value, { title }]) => make("option", { value }, title)));
  const text = make("textarea", { id: "embed-text", readOnly: true, rows: 5, ariaLabel: "Embed code", spellcheck: false });
  const copy = make("button", { type: "button", id: "embed-copy" }, "Copy");
  const told = make("p", { className: "hint", role: "status" });
  const details = make("details", { id: "embed-fold" }, make("summary", {}, "Embed"), make("div", { className: "parts" }, kind, copy), text, told);
  host.append(details);
  copy.addEventListener("click", async () => {
    await renew();
    try {
      await navigator.clipboard.writeText(text.value);
      told.textContent = "Copied.";
    } catch {
      text.select();
      told.textContent = "The code is selected; copy it from the field.";
    }
  });
  for (const [element, type] of /** @type {[HTMLElement, string][]} */ ([[kind, "change"], [details, "toggle"]])) {
    element.addEventListener(type, () => void renew());
  }

  /** What is on the stage now, at the time that it shows. */
  async function renew() {
    if (!details.open || !page.state) return;
    try {
      const { origin, pathname, protocol } = location;
      const fragment = await encodeLink(experimentOf(page));
      text.value = KINDS[kind.value].text(`${protocol === "file:" ? `file://${pathname}` : origin + pathname}?embed=1#${fragment}`);
      told.textContent = protocol === "file:" ? "This page was opened from a file: publish it, and change the address in the code." : "";
    } catch (error) {
      text.value = "";
      page.notice.show("No link can be made.", error);
    }
  }
}
