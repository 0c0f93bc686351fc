/** A form that makes any scene that the core can make. */
import { make } from "../../app/dom.js";
import { Field, withSeed } from "../../widgets/field.js";

/** @import { GeneratorInfo, Settings } from "../../domain/types.js" */

/** @param {GeneratorInfo[]} generators @param {(kind: GeneratorInfo["id"], options: Settings) => void} onMake */
export function makeForm(generators, onMake) {
  const kind = make("select", { id: "make-kind" }, ...generators.map(({ id, title }) => make("option", { value: id }, title)));
  const summary = make("p", { className: "hint" });
  const rows = make("div", {});
  /** @type {Field[]} */
  let fields = [];
  const build = () => {
    const info = generators[kind.selectedIndex];
    summary.textContent = info.summary;
    fields = withSeed(info.options, "scene").map((option) => new Field(option, option.default, () => {}, "make"));
    rows.replaceChildren(...fields.map(({ element }) => element));
  };
  kind.addEventListener("change", build);
  build();
  const form = make("form", { id: "make", noValidate: true }, make("label", { className: "row", htmlFor: "make-kind" }, make("span", { className: "name" }, "Kind"), kind), summary, rows, make("button", { type: "submit" }, "Generate"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const good = fields.map((field) => field.validate()).every(Boolean);
    if (!good) return;
    /** @type {Settings} */
    const options = {};
    // What is as usual is left out: some options go with others only.
    for (const { info, value } of fields) if (value !== undefined && value !== info.default) options[info.name] = value;
    onMake(generators[kind.selectedIndex].id, options);
  });
  return form;
}
