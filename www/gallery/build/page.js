/** The HTML of the gallery, written when the site is built: it can be read, linked and printed without a script. */
import { HOLDS, PAGES } from "../format.js";

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
export function plannersOf(entry) {
  return entry.page === "planner" ? [...new Set(entry.state.lanes.map(({ algorithm = "" }) => algorithm))] : [];
}

/**
 * The entries and the table of rows.
 * @param {Report[]} reports @param {Map<string, Shown>} shown  by the id of the entry @returns {string}
 */
export function galleryHtml(reports, shown) {
  const ids = [...shown.keys()];
  const sections = reports.map(
    ({ number, about, entries }) => `
<section class="report" id="report-${number}" aria-labelledby="report-${number}-title">
<h2 id="report-${number}-title">Report ${number}</h2>
<p>${html(about)}</p>
<div class="entries">
${entries.map(({ id }) => card(number, /** @type {Shown} */ (shown.get(id)), ids)).join("\n")}
</div>
</section>`,
  );
  return `${sections.join("\n")}\n${table(reports)}`;
}

/** @param {number} report @param {Shown} shown @param {string[]} ids  of all entries, in their order */
function card(report, { entry, address, width, height }, ids) {
  const { id, title, name, kind, robot, page, holds, see, report: says, why, chosen } = entry;
  const at = ids.indexOf(id);
  const texts = [
    html(see),
    entry.try && `<b>Try:</b> ${html(entry.try)}`,
    says && `<b>The report:</b> ${html(says)}`,
    `${holdsMark(holds)}${why ? `. ${html(why)}` : ""}`,
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
  return `<article class="entry" id="${id}" aria-labelledby="at-${id}" data-report="${report}" data-robot="${robot}" data-kind="${kind}" data-page="${page}" data-planner="${plannersOf(entry).join(" ")}" data-holds="${holds}">
<h3 id="at-${id}"><a href="#${id}"><img src="gallery/${id}.svg" width="${width}" height="${height}" alt="" loading="lazy"><span>${html(title)}</span></a></h3>
<p class="tag">${[html(name), kind === "other" ? "" : kind].filter(Boolean).join(" &#183; ")} ${holdsMark(holds)}</p>
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
${reports.map(({ number, rows: own }) => `<tbody><tr><th colspan="6" scope="colgroup">Report ${number}</th></tr>\n${own.map((row) => line(row, titles)).join("\n")}</tbody>`).join("\n")}
</table></div></div>`;
}

/** @param {Row} row @param {Map<string, string>} titles  of entries, by their ids */
function line({ row, kind, name, shows, verdict, where, entries, holds, why }, titles) {
  const links = entries.map((id) => `<a href="#${id}">${html(titles.get(id) ?? id)}</a>`).join("; ");
  const cells = [
    String(row),
    kind,
    `${name ? `<b>${html(name)}</b> ` : ""}${html(shows)}`,
    `<span class="here" data-here="${verdict}">${verdict}</span>`,
    [html(where), links].filter(Boolean).join("<br>"),
    `${holdsMark(holds)}${why ? `. ${html(why)}` : ""}`,
  ];
  return `<tr id="row-${row}">${cells.map((cell) => `<td>${cell}</td>`).join("")}</tr>`;
}
