/** Code that embeds the page with its current state in a web page, in slides or in a notebook. */
import { make } from "./dom.js";

/** @import { App } from "./app.js" */

/** @type {[string, string, (address: string) => string][]} */
const KINDS = [
  [
    "page",
    "A web page",
    (address) => `<iframe src="${address}" title="Planarium" width="100%" height="640" style="border: 0"></iframe>`,
  ],
  [
    "slides",
    "Reveal.js slides",
    (address) =>
      `<section>\n  <iframe data-src="${address}" title="Planarium" width="100%" height="640" data-preload></iframe>\n</section>`,
  ],
  [
    "notebook",
    "A Jupyter notebook",
    (address) => `from IPython.display import IFrame\nIFrame("${address}", width="100%", height=640)`,
  ],
];

/**
 * @param {Pick<App, "fail">} app
 * @param {HTMLElement} host
 * @param {() => Promise<string>} encode  the fragment of what is shown, without `#`
 */
export function showEmbedCode(app, host, encode) {
  const kind = make(
    "select",
    { id: "embed-kind", ariaLabel: "Embed as" },
    ...KINDS.map(([value, title]) => make("option", { value }, title)),
  );
  const text = make("textarea", {
    id: "embed-text",
    readOnly: true,
    rows: 5,
    ariaLabel: "Embed code",
    spellcheck: false,
  });
  const copy = make("button", { type: "button", id: "embed-copy", onclick: () => void save() }, "Copy");
  const result = make("p", { className: "hint", role: "status" });
  const details = make(
    "details",
    { id: "embed-fold" },
    make("summary", {}, "Embed"),
    make("div", { className: "parts" }, kind, copy),
    text,
    result,
  );
  host.append(details);
  kind.addEventListener("change", () => void update());
  details.addEventListener("toggle", () => void update());

  async function update() {
    if (!details.open) return;
    try {
      const { origin, pathname, protocol } = location;
      const fragment = await encode();
      const [, , codeOf] = KINDS[kind.selectedIndex];
      text.value = codeOf(`${protocol === "file:" ? `file://${pathname}` : origin + pathname}?embed=1#${fragment}`);
      result.textContent =
        protocol === "file:" ? "This page was opened from a file: publish it, and change the address in the code." : "";
    } catch (error) {
      text.value = "";
      app.fail(error, "No link can be made.");
    }
  }

  async function save() {
    await update();
    try {
      await navigator.clipboard.writeText(text.value);
      result.textContent = "Copied.";
    } catch {
      text.select();
      result.textContent = "The code is selected; copy it from the field.";
    }
  }
}
