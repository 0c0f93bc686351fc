/** The HTML of the gallery, written when the site is built: it can be read, linked and printed without a script. */
import { HOLDS, PAGES } from "../format.js";
import { byTopic } from "../topics.js";

/** @import { Entry, Holds, Report, Row } from "../format.js" */

/**
 * An entry with its link and the size of its picture, pixels.
 * @typedef {{ entry: Entry, address: string, width: number, height: number }} Shown
 */

/** Text for HTML, with `code` between backticks. @param {string} text */
function html(text) {
  return text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`).replace(/`([^`]*)`/g, "<code>$1</code>");
}

/** @param {Holds} verdict */
function holdsMark(verdict) {
  return `<span class="holds" data-holds="${verdict}">${HOLDS[verdict]}</span>`;
}

/** The planners of an entry, by their ids. @param {Entry} entry @returns {string[]} */
function plannersOf(entry) {
  return entry.page === "planner" ? [...new Set(entry.state.lanes.map(({ algorithm = "" }) => algorithm))] : [];
}

/**
 * The entries by topic; then the reports, to which the page's script moves their entries, and the table of rows.
 * @param {Report[]} reports @param {Map<string, Shown>} shown  by the id of the entry @returns {string}
 */
export function galleryHtml(reports, shown) {
  const topics = byTopic([...shown.values()].map(({ entry }) => entry));
  const ids = topics.flatMap(({ entries }) => entries.map(({ id }) => id));
  const numbers = new Map(reports.flatMap(({ number, entries }) => entries.map(({ id }) => [id, number])));
  const links = topics.map(
    ({ id, title, entries }) => `<a href="#${id}" data-topic="${id}">${title} <span>${entries.length}</span></a>`,
  );
  const sections = topics.map(({ id, title, about, entries }) =>
    section(
      id,
      title,
      about,
      "topic",
      entries.map((entry) => card(/** @type {Shown} */ (shown.get(entry.id)), numbers.get(entry.id), ids)).join("\n"),
    ),
  );
  return `<div class="find"><nav class="views" aria-label="Views"><a href="#topics" data-view="topics">By topic</a><a href="#reports" data-view="reports">Course reports</a></nav></div>
<nav class="topics" id="topics" aria-label="Topics"><a href="#topics" data-topic="">All topics <span>${ids.length}</span></a>${links.join("")}</nav>
${sections.join("\n")}
<div id="reports">
<h2>Course reports</h2>
<p>Five students of a course wrote motion planners in Python, for arms, bodies, cars and particles, and each wrote a report; this project ran every figure, table and claim of the five reports again. The texts name most settings, but not the worlds and not all limits, so each entry says what was chosen here. A claim is tested with hundreds of runs where the students had time for five.</p>
<dl class="meanings" aria-label="Verdicts">
${[
  ["yes", "shown again here, or proven"],
  ["partly", "right with a condition that the report lacks"],
  ["no", "contradicted by the run or by the field"],
  ["unclear", "the text leaves out what decides it, such as the world; the entry says what happens in a world of ours"],
]
  .map(([verdict, meaning]) => `<div><dt>${holdsMark(/** @type {Holds} */ (verdict))}</dt><dd>${meaning}</dd></div>`)
  .join("\n")}
</dl>
${reports
  .map(({ number, about, entries }) => section(`report-${number}`, `Report ${number}`, about, "report", "", entries))
  .join("\n")}
${table(reports)}
</div>`;
}

/**
 * A group of entries.
 * @param {string} id @param {string} title @param {string} about @param {"topic" | "report"} kind @param {string} cards
 * @param {Entry[]} [order]  of the entries that belong here, too
 */
function section(id, title, about, kind, cards, order = []) {
  const own = order.length > 0 ? ` data-order="${order.map((entry) => entry.id).join(" ")}"` : "";
  return `<section class="chapter ${kind}" id="${id}" aria-labelledby="${id}-title"${own}>
<h2 id="${id}-title">${title}</h2>
<p>${html(about)}</p>
<div class="entries">
${cards}
</div>
</section>`;
}

/** @param {Shown} shown @param {number | undefined} report @param {string[]} ids  of all entries, in their order */
function card({ entry, address, width, height }, report, ids) {
  const { id, title, topic, name = "", kind = "", robot, page, holds, see, report: says, why, chosen } = entry;
  const at = ids.indexOf(id);
  const source = report && `<a href="#report-${report}">Report ${report}</a>${name ? `, ${html(name)}` : ""}`;
  const texts = [
    html(see),
    entry.try && `<b>Try:</b> ${html(entry.try)}`,
    source && `<b>${source}${says ? ":" : ""}</b> ${says ? html(says) : ""}`,
    holds && `${holdsMark(holds)}${why ? `. ${html(why)}` : ""}`,
    page === "experiments" &&
      `<span class="hint">The picture shows the first trials${entry.state.view?.reported?.length ? "; crosses are numbers of the report" : ""}. The page makes all of them.</span>`,
    chosen && `<span class="hint"><b>Not in the report:</b> ${html(chosen)}</span>`,
  ].filter(Boolean);
  const beside = [
    ["previous", at - 1],
    ["next", at + 1],
  ].map(([word, i]) => {
    const other = ids[Number(i)];
    return other ? `<a class="${word}" href="#${other}">${word === "next" ? "Next" : "Previous"}</a>` : "";
  });
  const reported = [html(name), kind === "other" ? "" : kind].filter(Boolean).join(" &#183; ");
  return `<article class="entry" id="${id}" aria-labelledby="at-${id}" data-topic="${topic}" data-report="${report ?? ""}" data-robot="${robot}" data-kind="${kind}" data-page="${page}" data-planner="${plannersOf(entry).join(" ")}" data-holds="${holds ?? ""}">
<h3 id="at-${id}"><a href="#${id}"><img src="gallery/${id}.svg" width="${width}" height="${height}" alt="" loading="lazy"><span>${html(title)}</span></a></h3>
<p class="tag"><span class="page">${PAGES[page]}</span>${holds ? `<span class="reported">${reported}</span> ${holdsMark(holds)}` : ""}</p>
<div class="detail">
${texts.map((text) => `<p>${text}</p>`).join("\n")}
<p class="go"><a class="open" href="${address}">Open in ${PAGES[page]}</a><span>${beside.join("")}<a class="close" href="#at-${id}">Close</a></span></p>
</div>
</article>`;
}

/** @param {Report[]} reports */
function table(reports) {
  const titles = new Map(reports.flatMap(({ entries }) => entries.map(({ id, title }) => [id, title])));
  const rows = reports.reduce((sum, report) => sum + report.rows.length, 0);
  const head = ["No.", "Kind", "What the report has", "Here", "Where", "The report"]
    .map((title) => `<th scope="col">${title}</th>`)
    .join("");
  return `<div id="rows">
<h2 id="rows-title">All ${rows} rows</h2>
<p>Everything that the reports define, show or claim, in their order. &#8220;Here&#8221; says whether Planarium has it.</p>
<div class="scroll" tabindex="0" role="region" aria-labelledby="rows-title">
<table><thead><tr>${head}</tr></thead>
${reports.map(({ number, rows: own }) => `<tbody><tr><th colspan="6" scope="colgroup">Report ${number}</th></tr>\n${own.map((row) => line(row, number, titles)).join("\n")}</tbody>`).join("\n")}
</table></div></div>`;
}

/** @param {Row} row @param {number} report @param {Map<string, string>} titles  of entries, by their ids */
function line({ row, kind, name, shows, verdict, where, entries, holds, why }, report, titles) {
  const links = entries.map((id) => `<a href="#${id}">${html(titles.get(id) ?? id)}</a>`).join("; ");
  const cells = [
    String(row),
    kind,
    `${name ? `<b>${html(name)}</b> ` : ""}${html(shows)}`,
    `<span class="here" data-here="${verdict}">${verdict}</span>`,
    [html(where), links].filter(Boolean).join("<br>"),
    `${holdsMark(holds)}${why ? `. ${html(why)}` : ""}`,
  ];
  return `<tr id="row-${row}" data-report="${report}" data-kind="${kind}" data-holds="${holds}">${cells.map((cell) => `<td>${cell}</td>`).join("")}</tr>`;
}
