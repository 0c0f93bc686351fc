/** A form for the generators of scenes. */
import { make } from "../../app/dom.js";
import { withSeed } from "../../widgets/field.js";
import { Options } from "../../widgets/options.js";

/** @import { GeneratorInfo, Settings } from "../../domain/types.js" */

/** @param {GeneratorInfo[]} generators @param {(kind: GeneratorInfo["id"], options: Settings) => void} onMake */
export function makeForm(generators, onMake) {
  const kind = make("select", { id: "make-kind" }, ...generators.map(({ id, title }) => make("option", { value: id }, title)));
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
  const kindRow = make("label", { className: "row", htmlFor: "make-kind" }, make("span", { className: "name" }, "Kind"), kind);
  const form = make("form", { id: "make", noValidate: true }, kindRow, summary, rows, make("button", { type: "submit" }, "Generate"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    // Defaults are left out: some options go with certain others only.
    if (options.settings) onMake(generators[kind.selectedIndex].id, options.given);
  });
  return form;
}
