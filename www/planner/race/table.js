/** The table of a race. */
import { leaders } from "./standings.js";
import { grouped, make, write } from "../../app/dom.js";
import { endText } from "../../domain/names.js";
import { button, labelled, tableHead } from "../../widgets/elements.js";
import { duration, percent } from "../../widgets/format.js";

/** @import { LaneState } from "../run-log/lane-state.js" */
/** @import { Standing } from "./standings.js" */
/** @typedef {(lane: number, text: string) => void} SetStanding   shows the standing of a planner at its figure */
/** @typedef {LaneState & { standing: Standing }} Racer   a planner at the time shown */

const COLUMNS = [
  "Planner",
  "Vertices",
  "Edges",
  "Motions",
  "Clearance evaluations",
  "Iterations",
  "First path after",
  "Path length",
  "Path vertices",
];
/** Of roadmaps, which are searched. */
const OF_SEARCHES = ["Vertices visited", "Time to search"];

export class Table {
  /** @param {HTMLElement} host @param {(() => void) | null} onSeeds   runs over many seeds are wanted */
  constructor(host, onSeeds) {
    this.host = host;
    /** @type {HTMLTableRowElement[]} */
    this.rows = [];
    this.remark = make("p", { className: "hint" });
    this.caution = make("p", { className: "hint" }, "This is one seed: over many seeds the winner may differ.");
    if (onSeeds) this.caution.append(" ", button("race-over-seeds", "Over 100 seeds", onSeeds));
  }

  /** Makes a row for each planner. @param {string[]} names */
  build(names) {
    this.rows = names.map((name) =>
      make(
        "tr",
        {},
        make("th", { scope: "row" }, name),
        ...[...COLUMNS.slice(1), ...OF_SEARCHES].map(() => make("td", {})),
      ),
    );
    this.host.replaceChildren();
    if (names.length === 0) return;
    const table = make(
      "table",
      { className: "standings" },
      make("caption", {}, "Standings (one seed)"),
      tableHead([...COLUMNS, ...OF_SEARCHES]),
      make("tbody", {}, ...this.rows),
    );
    this.host.append(
      labelled("region", "Standings", make("div", { className: "scroll", tabIndex: 0 }, table)),
      this.remark,
      this.caution,
    );
  }

  /** @param {Racer[]} lanes @param {SetStanding} setStanding */
  show(lanes, setStanding) {
    lanes.forEach(({ status, fingerprint }, i) => Object.assign(this.rows[i].dataset, { status, fingerprint }));
    const isSearched = lanes.some(({ visited }) => visited !== null);
    for (const { cells } of this.host.querySelectorAll("tr"))
      for (const cell of [...cells].slice(COLUMNS.length)) cell.hidden = !isSearched;
    const { first, shortest, isOver, isAlike } = leaders(lanes.map(({ standing }) => standing));
    lanes.forEach((lane, i) => {
      const { found } = lane.standing;
      const texts = [
        ...[lane.vertices, lane.edges, lane.motions, lane.evaluations, lane.iteration].map(grouped),
        found === null
          ? nothing(lane)
          : noted(grouped(found), first.includes(i) && (first.length > 1 ? "tied for first" : "first")),
        found === null
          ? "\u2013"
          : noted(
              `${lane.cost.toFixed(2)} ${lane.unit}`.trim(),
              lane.gap !== null && `gap ${percent(lane.gap)}`,
              lane.standing.collides ? "it collides" : !lane.isProven && "not proven",
              shortest.includes(i) &&
                `${lane.standing.isCost ? "cheapest" : "shortest"} here${isOver ? "" : " so far"}`,
            ),
        lane.waypoints === null ? "\u2013" : grouped(lane.waypoints),
        lane.visited === null ? "\u2013" : grouped(lane.visited),
        lane.visited === null || !lane.stats ? "\u2013" : searchTime(lane.stats.search),
      ];
      setStanding(i, found === null ? `${nothing(lane)}, ${texts[0]} vertices` : texts[6]);
      texts.forEach((text, k) => write(this.rows[i].cells[k + 1], text));
    });
    const isCost = lanes.some(({ standing }) => standing.isCost);
    const remark = isCost
      ? "The planners keep away from obstacles differently, so their costs cannot be compared."
      : "The planners use different metrics, so their path lengths cannot be compared.";
    write(this.remark, isAlike ? "" : remark);
  }
}

/** A text with notes in parentheses. @param {string} text @param {...(string | false)} notes */
function noted(text, ...notes) {
  const note = notes.filter(Boolean).join(", ");
  return note ? `${text} (${note})` : text;
}

/** Browsers round their clocks to a tenth of a millisecond. @param {number} seconds */
function searchTime(seconds) {
  return seconds < 0.00005 ? "below 0.1 ms" : duration(seconds);
}

/** The text in place of a path. @param {LaneState} lane */
function nothing({ status, phase, reason }) {
  return status === "running" ? phase : status === "none" ? "not started" : endText(reason);
}
