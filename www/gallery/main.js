/**
 * The gallery: views, search, filters, keys and downloads for the HTML that the build has written. The address has the
 * open entry as its fragment, and in its query whatever differs from all entries by topic: `view=reports`, `topic`, `q`
 * (the search) and the filters.
 *
 * For tests: `body` carries `data-state` and `data-settled`, `data-view`, and `data-shown`, the number of entries that
 * search, topic and filters leave.
 */
import { byId, counted, make } from "../app/dom.js";
import { makeShare, setAddress } from "../app/link.js";
import { Notice } from "../app/notice.js";
import { watchTheme } from "../app/theme.js";
import { button } from "../widgets/elements.js";
import { HOLDS, PAGES } from "./format.js";

/** @import { App } from "../app/app.js" */
/** @typedef {"topics" | "reports"} View */

/**
 * The filters: the attribute of an entry, the title, and values that are not called by their own names.
 * @type {[key: string, title: string, names: Record<string, string>][]}
 */
const FILTERS = [
  ["report", "Report", {}],
  ["holds", "Verdict", HOLDS],
  ["robot", "Robot", { drive: "differential drive" }],
  ["planner", "Planner", { "": "without a planner" }],
  ["kind", "Kind", {}],
  ["page", "Page", PAGES],
];
/** Rows of the reports have no values of the other filters. */
const OF_ROWS = ["report", "holds", "kind"];

const notice = new Notice();
const topics = byId("topics", HTMLElement);
const reports = byId("reports", HTMLElement);
/** Sections with their entries in order. @type {Record<View, Map<HTMLElement, HTMLElement[]>>} */
const groups = {
  topics: new Map(elements(".chapter.topic").map((group) => [group, elements(".entry", group)])),
  reports: new Map(
    elements(".chapter.report").map((group) => [
      group,
      (group.dataset.order ?? "").split(" ").map((id) => byId(id, HTMLElement)),
    ]),
  ),
};
const rows = elements("#rows tr[id]");
/** What is searched: all texts of an element, without the marks that differ between keyboards. */
const texts = new Map([...elements(".entry"), ...rows].map((one) => [one, plain(textOf(one))]));
/** @type {View} */
let view = "topics";
let topic = "";

const topicLinks = elements("a", topics);
const search = make("input", {
  type: "search",
  id: "search",
  placeholder: "Search",
  ariaLabel: "Search",
  oninput: refine,
});
const views = elements(".views a");
const selects = FILTERS.map(([key, title, names]) => {
  const values = [...new Set(elements(".entry").flatMap((entry) => valuesOf(entry, key)))].sort();
  const select = make(
    "select",
    { id: `filter-${key}`, onchange: refine },
    make("option", { value: "any" }, "any"),
    ...values.map((value) => make("option", { value }, names[value] ?? value)),
  );
  return { key, title, select };
});
const all = button("all", "Show all", () => {
  showAll();
  search.focus();
});
const summary = make("summary", {}, "More filters");
const filters = make(
  "details",
  { id: "filters" },
  summary,
  make(
    "div",
    {},
    ...selects.map(({ title, select }) => make("label", { htmlFor: select.id }, make("span", {}, title), select)),
  ),
);

watchTheme(() => {});
const share = makeShare(
  /** @type {App} */ ({ fail: (error, title) => notice.show(title ?? "", error) }),
  async () => location.hash.slice(1),
  () => (location.hash ? "the open entry" : location.search ? "this selection" : "the gallery"),
);
byId("link", HTMLElement).addEventListener("click", () => void share());
document.querySelector(".find")?.append(search, filters, all);
for (const link of [...views, ...topicLinks])
  link.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    if (link.dataset.view) setView(/** @type {View} */ (link.dataset.view));
    else topic = link.dataset.topic ?? "";
    refine();
  });
byId("export", HTMLElement).append(
  ...[
    ["CSV", "rows.csv", "All rows of the reports with their verdicts"],
    ["JSON", "reports.json", "All entries with their links, and the rows"],
  ].map(([format, file, meaning]) =>
    make(
      "p",
      { className: "row" },
      make("span", { className: "name hint" }, meaning),
      make("a", { href: `gallery/${file}`, download: file }, format),
    ),
  ),
);

addEventListener("keydown", (event) => {
  const { key, altKey, ctrlKey, metaKey, target } = event;
  // Arrows also choose, move the cursor, and scroll the table.
  if (altKey || ctrlKey || metaKey || (target instanceof Element && target.closest("select, input, .scroll"))) return;
  if (key === "/") {
    event.preventDefault();
    search.focus();
    return;
  }
  const kind = { ArrowRight: "next", ArrowLeft: "previous", Escape: "close" }[key];
  const link = kind && document.querySelector(`.entry:target .${kind}:not([hidden])`);
  if (link instanceof HTMLAnchorElement) link.click();
});
for (const event of ["hashchange", "popstate"]) addEventListener(event, openAddress);
openAddress();
Object.assign(document.body.dataset, { state: "ready", settled: "true" });
if (location.protocol.startsWith("http")) navigator.serviceWorker?.register("offline.js").catch(() => {});

/** @param {string} selector @param {ParentNode} [root] @returns {HTMLElement[]} */
function elements(selector, root = document) {
  return [...root.querySelectorAll(selector)].filter((one) => one instanceof HTMLElement);
}

/** An entry's values of a filter; it has none of a report if it is in none. @param {HTMLElement} entry @param {string} key */
function valuesOf({ dataset }, key) {
  const values = (dataset[key] ?? "").split(" ");
  return key === "planner" ? values : values.filter(Boolean);
}

/** All that an element says and that its filters know, without links. @param {HTMLElement} element */
function textOf(element) {
  const parts = [...element.querySelectorAll("h3, .reported, .detail > :not(.go), td")].map((one) => one.textContent);
  return [element.id, ...parts, ...Object.values(element.dataset)].join(" ");
}

/** @param {string} text */
function plain(text) {
  return text
    .toLowerCase()
    .replace(/[\u2018\u2019]/g, "'")
    .replace(/\u2212/g, "-");
}

/** Takes over the address: what it selects, and the place that its fragment names. */
function openAddress() {
  const query = new URLSearchParams(location.search);
  topic = query.get("topic") ?? "";
  if (!topicLinks.some(({ dataset }) => dataset.topic === topic)) topic = "";
  search.value = query.get("q") ?? "";
  for (const { key, select } of selects) {
    const value = query.get(key) ?? "any";
    select.value = [...select.options].some((option) => option.value === value) ? value : "any";
  }
  if (selects.some(({ select }) => select.value !== "any")) filters.open = true;
  const place = document.getElementById(location.hash.slice(1));
  const isReports = place && reports.contains(place) && !place.matches(".entry, .entry *");
  const isTopics = place?.matches(".topic, #topics");
  setView(isReports || (query.get("view") === "reports" && !isTopics) ? "reports" : "topics");
  show();
  if (place?.matches(".entry")) {
    // An address shows its entry, whatever the rest of it says.
    if (place.hidden || place.closest("[hidden]")) showAll();
    place.querySelector("a")?.focus({ preventScroll: true });
    place.scrollIntoView({ block: "nearest" });
  } else if (place && !place.closest(".entry")) {
    if (place.closest("[hidden]")) showAll();
    place.scrollIntoView();
  }
}

/** Moves the entries to the sections of a view. @param {View} wanted */
function setView(wanted) {
  if (wanted === view && document.body.dataset.view) return;
  view = wanted;
  document.body.dataset.view = view;
  const open = document.querySelector(".entry:target");
  for (const [group, own] of groups[view]) group.querySelector(".entries")?.append(...own);
  reports.hidden = view !== "reports";
  for (const [group] of groups.topics) group.hidden = view !== "topics";
  for (const link of views) link.ariaCurrent = link.dataset.view === view ? "true" : null;
  // An element that is moved is no longer the target of the address.
  if (open && !open.matches(":target")) location.replace(location.hash);
}

/** Shows what has been chosen. Only an entry that is left stays open, and nothing else stays in the address. */
function refine() {
  show();
  const open = document.getElementById(location.hash.slice(1));
  if (location.hash === "" || (open?.matches(".entry") && !open.hidden && !open.closest("[hidden]"))) return;
  location.replace("#");
  setAddress(location.pathname + location.search);
}

function showAll() {
  topic = search.value = "";
  for (const { select } of selects) select.value = "any";
  const open = document.getElementById(location.hash.slice(1));
  if (view === "reports" && open?.dataset.report === "") setView("topics");
  show();
}

/** Shows what search, topic and filters leave, and writes them into the address. */
function show() {
  const words = plain(search.value).split(/\s+/).filter(Boolean);
  const chosen = selects.filter(({ select }) => select.value !== "any");
  const isFound = (/** @type {HTMLElement} */ one) => words.every((word) => texts.get(one)?.includes(word));
  const isLeft = (/** @type {HTMLElement} */ one, /** @type {typeof selects} */ by) =>
    by.every(({ key, select }) => valuesOf(one, key).includes(select.value)) && isFound(one);
  /** @type {HTMLElement[]} */
  const shown = [];
  /** @type {Record<string, number>} */
  const counts = { "": 0 };
  let total = 0;
  for (const [group, entries] of groups[view]) {
    for (const entry of entries) {
      const { topic: own = "" } = entry.dataset;
      const isFit = isLeft(entry, chosen);
      entry.hidden = !isFit || (topic !== "" && own !== topic);
      if (isFit) for (const one of ["", own]) counts[one] = (counts[one] ?? 0) + 1;
      if (!entry.hidden) shown.push(entry);
      total++;
    }
    group.hidden = entries.every(({ hidden }) => hidden);
  }
  const ofRows = chosen.filter(({ key }) => OF_ROWS.includes(key));
  for (const row of rows) row.hidden = !isLeft(row, ofRows);
  for (const body of elements("#rows tbody")) body.hidden = elements("tr[id]:not([hidden])", body).length === 0;
  for (const link of topicLinks) {
    const { topic: own = "" } = link.dataset;
    link.ariaCurrent = own === topic ? "true" : null;
    link.lastElementChild?.replaceChildren(String(counts[own] ?? 0));
  }
  shown.forEach((entry, i) => {
    connect(entry, "previous", shown[i - 1]);
    connect(entry, "next", shown[i + 1]);
  });
  summary.textContent = chosen.length > 0 ? `More filters (${chosen.length})` : "More filters";
  all.hidden = chosen.length === 0 && words.length === 0 && topic === "";
  say(shown.length, total);
  document.body.dataset.shown = String(shown.length);
  write(chosen);
}

/** Leads from an entry to the one beside it. @param {HTMLElement} entry @param {string} side @param {HTMLElement} [other] */
function connect(entry, side, other) {
  const link = entry.querySelector(`.${side}`);
  if (!(link instanceof HTMLAnchorElement)) return;
  link.hidden = !other;
  // A hash alone: the rest of the address is what it is when the link is followed.
  if (other) link.setAttribute("href", `#${other.id}`);
}

/** @param {number} count @param {number} total */
function say(count, total) {
  const text =
    count < total
      ? `${count} of ${total} entries.`
      : view === "topics"
        ? `${counted(total, "run")} of motion planners by topic, to open and change.`
        : `Every figure, table and animation of five course reports, as ${counted(total, "run")} to open and change.`;
  byId("story", HTMLElement).textContent = text;
  if (document.body.dataset.state) byId("announcer", HTMLElement).textContent = text;
}

/** @param {typeof selects} chosen */
function write(chosen) {
  const query = new URLSearchParams(
    [
      ["view", view === "topics" ? "" : view],
      ["topic", topic],
      ["q", search.value.trim()],
      ...chosen.map(({ key, select }) => [key, select.value]),
    ].filter(([key, value]) => value !== "" || key === "planner"),
  ).toString();
  if (query !== location.search.slice(1)) setAddress(location.pathname + (query && `?${query}`) + location.hash);
}
