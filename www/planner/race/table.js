/** How the planners of a race stand, in numbers and in words. */
import { leaders } from "./standings.js";
import { grouped, make, write } from "../../app/dom.js";

/** @import { Sheets } from "../sheets.js" */
/** @import { LaneState, State } from "../../domain/types.js" */

/** Milliseconds between two changes of the text. */
const READABLE = 80;

const COLUMNS = ["Planner", "Vertices", "Edges", "Motions", "Clearance evaluations", "Iterations", "First path after", "Path length"];

export class Table {
  /** @param {HTMLElement} room */
  constructor(room) {
    this.room = room;
    /** @type {{ row: HTMLTableRowElement, cells: HTMLElement[] }[]} */
    this.rows = [];
    this.remark = make("p", { className: "hint" });
    this.caution = make("p", { className: "hint" }, "Standings at equal cost (one seed): over many seeds the winner may differ.");
    this.written = -Infinity;
  }

  /** A row for each planner; none is no table. @param {string[]} names */
  build(names) {
    this.written = -Infinity;
    this.rows = names.map((name) => {
      const cells = COLUMNS.slice(1).map(() => make("td", {}));
      return { row: make("tr", {}, make("th", { scope: "row" }, name), ...cells), cells };
    });
    this.room.replaceChildren();
    if (names.length === 0) return;
    const table = make("table", { className: "standings" },
      make("caption", {}, "Standings at equal cost (one seed)"),
      make("thead", {}, make("tr", {}, ...COLUMNS.map((title) => make("th", { scope: "col" }, title)))),
      make("tbody", {}, ...this.rows.map(({ row }) => row)));
    const scroll = make("div", { className: "scroll", tabIndex: 0 }, table);
    scroll.setAttribute("role", "region");
    scroll.setAttribute("aria-label", "Standings");
    this.room.append(scroll, this.remark, this.caution);
  }

  /** @param {State} state @param {Sheets} sheets */
  show({ lanes, settled }, sheets) {
    lanes.forEach(({ status, fingerprint }, i) => Object.assign(this.rows[i].row.dataset, { status, fingerprint }));
    const now = performance.now();
    if (!settled && now - this.written < READABLE) return;
    this.written = now;
    const { first, shortest, isOver, isAlike } = leaders(lanes.map(({ standing }) => standing));
    lanes.forEach((lane, i) => {
      const { found } = lane.standing;
      const texts = [
        ...[lane.vertices, lane.edges, lane.motions, lane.evaluations, lane.iteration].map(grouped),
        found === null ? nothing(lane) : noted(grouped(found), first.includes(i) && (first.length > 1 ? "tied for first" : "first")),
        found === null ? "\u2013" : noted(`${lane.cost.toFixed(2)} ${lane.unit}`.trim(), !lane.isProven && "not proven", shortest.includes(i) && `shortest${isOver ? "" : " so far"}`),
      ];
      sheets.rank(i, found === null ? `${nothing(lane)}, ${texts[0]} vertices` : texts[6]);
      texts.forEach((text, k) => write(this.rows[i].cells[k], text));
    });
    write(this.remark, isAlike ? "" : "The planners use different metrics, so their path lengths cannot be compared.");
  }
}

/** A text with notes in parentheses. @param {string} text @param {...(string | false)} notes */
function noted(text, ...notes) {
  const told = notes.filter(Boolean).join(", ");
  return told ? `${text} (${told})` : text;
}

/** What is said where there is no path. @param {LaneState} lane */
function nothing({ status, phase }) { return status === "running" ? phase : status === "none" ? "not started" : "no path"; }
