/** The options of generated scenes: sliders for those of a built-in scene, and a form for any other. */
import { byId, make } from "../../app/dom.js";
import { MADE } from "../../domain/names.js";
import { withSeed } from "../../widgets/field.js";
import { Options } from "../../widgets/options.js";
import { optionsAt } from "./scenes.js";
import { row } from "../../widgets/elements.js";

/** @import { App } from "../../app/app.js" */
/** @import { Generation, GeneratorInfo, SceneEntry, Settings, Slider } from "../../domain/types.js" */
/** @typedef {{ scene?: string, options?: Settings }} Scene   a part of the page's state */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {{ markDirty: () => void }} session
 * @property {Generation | null} generation
 * @property {boolean} autoplay
 * @property {(patch: Scene, how: { play: boolean }) => Promise<unknown>} open
 * @property {(listener: (facts: object, entry: SceneEntry | null) => void) => void} onOpen
 */

/** @param {Page} page @param {GeneratorInfo[]} generators */
export function showSceneOptions(page, generators) {
  const sliders = make("div", { className: "sliders" });
  const fold = byId("make-fold", HTMLDetailsElement);
  byId("scene-options", HTMLElement).append(sliders);
  fold.append(makeForm(generators, (kind, options) => request({ scene: MADE + kind, options })));
  /** @type {SceneEntry | null} */
  let shown = null;
  /** @type {ReturnType<typeof makeRow>[]} */
  let rows = [];
  /** @type {Settings} */
  let options = {};
  /** The latest request that has not begun. @type {Scene | null} */
  let next = null;

  page.onOpen((_, entry) => adopt(entry));

  /** Shows the sliders of the open scene. @param {SceneEntry | null} entry */
  function adopt(entry) {
    const { generation } = page;
    // A slider that is being moved is ahead of the scene that was opened for it.
    if (!next) options = { ...generation?.options };
    if (entry !== shown) {
      rows = entry?.generate && generation ? (entry.sliders ?? []).map(makeRow) : [];
      sliders.replaceChildren(...rows.map(({ element }) => element));
    }
    shown = entry;
    for (const { show } of rows) show();
  }

  /** @param {Slider} slider */
  function makeRow({ option, title, min, max, step, unit, words }) {
    const id = `option-${option}`;
    const output = make("output", { id: `${id}-value` });
    const input = make("input", { type: "range", id, min: String(min), max: String(max), step: String(step) });
    input.addEventListener("input", () => {
      if (!shown?.generate) return;
      options = { ...options, ...optionsAt({ ...shown, generate: undefined }, { [option]: Number(input.value) }) };
      show();
      request({ options });
    });
    const show = () => {
      input.value = String(words ? words.indexOf(String(options[option])) : options[option]);
      output.value = `${options[option]}${unit && ` ${unit}`}`;
      input.setAttribute("aria-valuetext", output.value);
    };
    return {
      show,
      element: row(title, input, output),
    };
  }

  /** @param {Scene} patch */
  function request(patch) {
    if (!next) requestAnimationFrame(openNext);
    next = patch;
    // The state shown is out of date from now on, not only from the next frame.
    page.session.markDirty();
  }

  /** Opens the latest request with the current settings of the planner. */
  function openNext() {
    if (!next) return;
    const opening = page.open(next, { play: page.autoplay });
    next = null;
    void page.app.track(opening, "This scene cannot be generated.");
  }
}

/**
 * A form for the generators of scenes.
 * @param {GeneratorInfo[]} generators
 * @param {(kind: GeneratorInfo["id"], options: Settings) => void} onMake
 */
function makeForm(generators, onMake) {
  const kind = make(
    "select",
    { id: "make-kind" },
    ...generators.map(({ id, title }) => make("option", { value: id }, title)),
  );
  const summary = make("p", { className: "hint" });
  const rows = make("div", {});
  /** @type {Options} */
  let options;
  const build = () => {
    const info = generators[kind.selectedIndex];
    summary.textContent = info.summary;
    options = new Options(rows, withSeed(info.options, "scene"), {}, () => {}, { prefix: "make" });
  };
  kind.addEventListener("change", build);
  build();
  const form = make(
    "form",
    { id: "make", noValidate: true },
    row("Kind", kind),
    summary,
    rows,
    make("button", { type: "submit" }, "Generate"),
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    // Defaults are left out: some options go with certain others only.
    if (options.settings) onMake(generators[kind.selectedIndex].id, options.given);
  });
  return form;
}
