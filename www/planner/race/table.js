/** The table of a race. */
import { leaders } from "./standings.js";
import { grouped, make, write } from "../../app/dom.js";
import { endText } from "../../domain/names.js";
import { labelled } from "../../widgets/elements.js";
import { percent } from "../../widgets/format.js";

/** @import { Sheets } from "../sheets.js" */
/** @import { LaneState, State } from "../../domain/types.js" */

const COLUMNS = ["Planner", "Vertices", "Edges", "Motions", "Clearance evaluations", "Iterations", "First path after", "Path length"];

export class Table {
  /** @param {HTMLElement} host */
  constructor(host) {
    this.host = host;
    /** @type {HTMLTableRowElement[]} */
    this.rows = [];
    this.remark = make("p", { className: "hint" });
    this.caution = make("p", { className: "hint" }, "Standings at equal cost (one seed): over many seeds the winner may differ.");
  }

  /** Makes a row for each planner. @param {string[]} names */
  build(names) {
    this.rows = names.map((name) => make("tr", {}, make("th", { scope: "row" }, name), ...COLUMNS.slice(1).map(() => make("td", {}))));
    this.host.replaceChildren();
    if (names.length === 0) return;
    const table = make("table", { className: "standings" },
      make("caption", {}, "Standings at equal cost (one seed)"),
      make("thead", {}, make("tr", {}, ...COLUMNS.map((title) => make("th", { scope: "col" }, title)))),
      make("tbody", {}, ...this.rows));
    this.host.append(labelled("region", "Standings", make("div", { className: "scroll", tabIndex: 0 }, table)), this.remark, this.caution);
  }

  /** @param {State} state @param {Sheets} sheets */
  show({ lanes }, sheets) {
    lanes.forEach(({ status, fingerprint }, i) => Object.assign(this.rows[i].dataset, { status, fingerprint }));
    const { first, shortest, isOver, isAlike } = leaders(lanes.map(({ standing }) => standing));
    lanes.forEach((lane, i) => {
      const { found } = lane.standing;
      const texts = [
        ...[lane.vertices, lane.edges, lane.motions, lane.evaluations, lane.iteration].map(grouped),
        found === null ? nothing(lane) : noted(grouped(found), first.includes(i) && (first.length > 1 ? "tied for first" : "first")),
        found === null ? "\u2013" : noted(`${lane.cost.toFixed(2)} ${lane.unit}`.trim(), lane.gap !== null && `gap ${percent(lane.gap)}`, lane.standing.collides ? "it collides" : !lane.isProven && "not proven", shortest.includes(i) && `shortest${isOver ? "" : " so far"}`),
      ];
      sheets.setStanding(i, found === null ? `${nothing(lane)}, ${texts[0]} vertices` : texts[6]);
      texts.forEach((text, k) => write(this.rows[i].cells[k + 1], text));
    });
    write(this.remark, isAlike ? "" : "The planners use different metrics, so their path lengths cannot be compared.");
  }
}

/** A text with notes in parentheses. @param {string} text @param {...(string | false)} notes */
function noted(text, ...notes) {
  const note = notes.filter(Boolean).join(", ");
  return note ? `${text} (${note})` : text;
}

/** The text in place of a path. @param {LaneState} lane */
function nothing({ status, phase, reason }) { return status === "running" ? phase : status === "none" ? "not started" : endText(reason); }
