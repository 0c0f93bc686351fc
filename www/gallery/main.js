/**
 * The gallery: filters, keys and downloads for the HTML that the build has written.
 *
 * For tests: `body` carries `data-state` and `data-settled`, and `data-shown`, the number of entries that the filters
 * leave.
 */
import { byId, make } from "../app/dom.js";
import { makeShare } from "../app/link.js";
import { Notice } from "../app/notice.js";
import { watchTheme } from "../app/theme.js";
import { HOLDS, PAGES } from "./format.js";

/** @import { App } from "../app/app.js" */

/**
 * The filters: the attribute of an entry, the title, and values that are not called by their own names.
 * @type {[key: string, title: string, names: Record<string, string>][]}
 */
const FILTERS = [
  ["report", "Report", {}],
  ["holds", "Holds", HOLDS],
  ["robot", "Robot", { drive: "differential drive" }],
  ["planner", "Planner", { "": "without a planner" }],
  ["kind", "Kind", {}],
  ["page", "Page", PAGES],
];

const notice = new Notice();
const entries = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(".entry")]);
const sections = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(".report")]);
const all = byId("all", HTMLButtonElement);

watchTheme(() => {});
const share = makeShare(
  /** @type {App} */ ({ fail: (error, title) => notice.show(title ?? "", error) }),
  async () => location.hash.slice(1),
  () => (location.hash ? "the open entry" : "the gallery"),
);
byId("link", HTMLElement).addEventListener("click", () => void share());

const selects = FILTERS.map(([key, title, names]) => {
  const values = [...new Set(entries.flatMap((entry) => valuesOf(entry, key)))].sort();
  const select = make(
    "select",
    { id: `filter-${key}`, onchange: show },
    make("option", { value: "any" }, "any"),
    ...values.map((value) => make("option", { value }, names[value] ?? value)),
  );
  byId("filters", HTMLElement).append(
    make("label", { className: "row", htmlFor: select.id }, make("span", { className: "name" }, title), select),
  );
  return { key, select };
});
all.addEventListener("click", () => {
  for (const { select } of selects) select.value = "any";
  show();
});
byId("export", HTMLElement).append(
  ...[
    ["CSV", "rows.csv", "All rows with their verdicts"],
    ["JSON", "reports.json", "Rows and entries with their links"],
  ].map(([format, file, meaning]) =>
    make(
      "p",
      { className: "row" },
      make("span", { className: "name hint" }, meaning),
      make("a", { href: `gallery/${file}`, download: file }, format),
    ),
  ),
);

addEventListener("keydown", ({ key, altKey, ctrlKey, metaKey, target }) => {
  // Arrows also choose, move the cursor, and scroll the table.
  if (altKey || ctrlKey || metaKey || (target instanceof Element && target.closest("select, input, .scroll"))) return;
  const kind = { ArrowRight: "next", ArrowLeft: "previous", Escape: "close" }[key];
  const link = kind && document.querySelector(`.entry:target .${kind}`);
  if (link instanceof HTMLAnchorElement) link.click();
});
addEventListener("hashchange", focusEntry);
show();
focusEntry();
Object.assign(document.body.dataset, { state: "ready", settled: "true" });
if (location.protocol.startsWith("http")) navigator.serviceWorker?.register("offline.js").catch(() => {});

/** An entry's values of a filter. @param {HTMLElement} entry @param {string} key */
function valuesOf({ dataset }, key) {
  return (dataset[key] ?? "").split(" ");
}

/** Shows the entries that the filters leave. */
function show() {
  let count = 0;
  for (const entry of entries) {
    entry.hidden = !selects.every(
      ({ key, select: { value } }) => value === "any" || valuesOf(entry, key).includes(value),
    );
    if (!entry.hidden) count++;
  }
  for (const section of sections) section.hidden = section.querySelector(".entry:not([hidden])") === null;
  all.disabled = selects.every(({ select }) => select.value === "any");
  byId("story", HTMLElement).textContent =
    count === entries.length
      ? `Every figure, table and animation of five course reports, as ${count} runs to open and change.`
      : `${count} of ${entries.length} entries.`;
  document.body.dataset.shown = String(count);
}

/** Shows the entry in the address, whatever the filters say, and moves the focus there. */
function focusEntry() {
  const entry = document.getElementById(location.hash.slice(1));
  if (!entry?.classList.contains("entry")) return;
  if (entry.hidden) all.click();
  entry.querySelector("a")?.focus({ preventScroll: true });
  entry.scrollIntoView({ block: "nearest" });
}
