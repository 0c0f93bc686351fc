/**
 * The options of scenes that the core makes: sliders beneath the gallery for those of the page's own scenes, and a fold for any
 * scene that the core can make.
 */
import { byId, make } from "../../app/dom.js";
import { Part } from "../../app/feature.js";
import { optionsAt } from "./scenes.js";

/** @import { Page } from "../page.js" */
/** @import { GeneratorInfo, SceneEntry, Settings, Slider, Source } from "../../domain/types.js" */
/** @typedef {{ source: Source, entry: SceneEntry | undefined }} Wish */

/** @param {Page} page @param {GeneratorInfo[]} generators */
export function showSceneOptions(page, generators) {
  const sliders = make("div", { className: "sliders" });
  const fold = byId("make-fold", HTMLDetailsElement);
  fold.before(sliders);
  new Part(page.notice, async () => {
    const { makeForm } = await import("./make-scene.js");
    fold.append(makeForm(generators, (kind, options) => wish({ generate: { kind, options } })));
  }).inFold("make-fold");
  /** @type {SceneEntry | null} */
  let shown = null;
  /** @type {Settings} */
  let options = {};
  /** What is to be opened next: of several only the newest. @type {Wish | null} */
  let next = null;
  let busy = false;

  page.onOpen((_, entry) => adopt(entry));
  adopt(page.entry);

  /** Another scene is on the stage, or the same with other options. @param {SceneEntry | null} entry */
  function adopt(entry) {
    const { source } = page;
    const generate = source && "generate" in source ? source.generate : null;
    const offers = entry?.generate && generate ? entry.sliders ?? [] : [];
    // The slider that is being moved knows better than what was opened for it.
    if (!next) options = { ...generate?.options };
    if (entry !== shown) sliders.replaceChildren(...offers.map(row));
    shown = entry;
    for (const slider of offers) show(slider);
  }

  /** @param {Slider} slider */
  function row(slider) {
    const { option, title, min, max, step } = slider;
    const id = `option-${option}`;
    const input = make("input", { type: "range", id, min: String(min), max: String(max), step: String(step) });
    input.addEventListener("input", () => {
      if (!shown?.generate) return;
      options = { ...options, ...optionsAt({ ...shown, generate: undefined }, { [option]: Number(input.value) }) };
      show(slider);
      wish({ generate: { kind: shown.generate.kind, options } }, shown);
    });
    return make("label", { className: "row", htmlFor: id }, make("span", { className: "name" }, title), input, make("output", { id: `${id}-value` }));
  }

  /** @param {Slider} slider */
  function show({ option, unit, words }) {
    const input = byId(`option-${option}`, HTMLInputElement);
    input.value = String(words ? words.indexOf(String(options[option])) : options[option]);
    const text = `${options[option]}${unit && ` ${unit}`}`;
    byId(`option-${option}-value`, HTMLOutputElement).value = text;
    input.setAttribute("aria-valuetext", text);
  }

  /** @param {Source} source @param {SceneEntry} [entry] */
  function wish(source, entry) {
    next = { source, entry };
    // What is on the stage is old news from now on, not only from the frame in which it is replaced.
    page.session.markDirty();
    if (!busy) requestAnimationFrame(() => void obey());
    busy = true;
  }

  /** Opens what is wished for, and what was wished for meanwhile, with the settings of the planner as they are. */
  async function obey() {
    while (next) {
      const { source, entry } = next;
      next = null;
      try {
        await page.open(source, { entry, plans: page.plans ?? undefined, query: page.panel.query.value, play: page.autoplay });
      } catch (error) {
        page.notice.show("This scene cannot be generated.", error);
      }
    }
    busy = false;
  }
}
