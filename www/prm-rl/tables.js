/**
 * The tables of this page: the methods that drive to one goal, the edges of a path, and the comparison with its intervals
 * drawn.
 */
import { byId, grouped, make, makeSvg } from "../app/dom.js";
import { endText } from "../domain/names.js";
import { csvFile } from "../formats/csv.js";
import { num } from "../widgets/format.js";
import { WAYS, countsOf } from "./session.js";
import { COMPARED, WAY_WORDS, percentText } from "./words.js";

/** @import { MethodSummary } from "planarium/full" */
/** @import { NavigationSession } from "./session.js" */

/** The drawn interval, CSS pixels. */
const SIZE = { width: 150, height: 18, margin: 6 };
const NONE = "\u2013";

/** A row of a table. @param {string} head @param {(string | Node)[]} cells @param {Record<string, unknown>} dataset */
function row(head, cells, dataset) {
  return make("tr", { dataset }, make("th", { scope: "row" }, head), ...cells.map((cell) => make("td", {}, cell)));
}

/** The mean of some numbers as text. @param {number[]} values @param {string} unit */
function meanText(values, unit) {
  return values.length === 0
    ? NONE
    : `${num(values.reduce((sum, value) => sum + value, 0) / values.length, 1)} ${unit}`;
}

/** What each way has come to for this start and goal. @param {NavigationSession} session */
export function showDriven({ runs, way, hasLoad }) {
  const rows = WAYS.map((one) => {
    const { status, path, result, rollouts, drives } = runs[one];
    const { reached, collision, swing, timeout } = countsOf(drives);
    const own = hasLoad ? [collision, swing, timeout] : [collision, timeout];
    const counts =
      drives.length === 0 ? [NONE, ...own.map(() => NONE)] : [`${reached} of ${drives.length}`, ...own.map(String)];
    const least =
      rollouts && rollouts.length > 0
        ? `${Math.min(...rollouts.flatMap(({ forward, backward }) => [forward, backward]))} of ${rollouts[0].of}`
        : NONE;
    const edges =
      one === "policy" || path.length === 0
        ? status === "exhausted"
          ? endText(result?.reason)
          : NONE
        : grouped(path.length - 1);
    const times = drives.filter(({ outcome }) => outcome === "reached").map(({ time }) => time);
    return row(WAY_WORDS[one].title, [edges, least, ...counts, meanText(times, "s")], {
      way: one,
      reached: drives.length > 0 ? reached : "",
      chosen: one === way,
    });
  });
  byId("driven", HTMLTableElement).tBodies[0].replaceChildren(...rows);
}

/** The edges of the path: each can be marked on the stage. @param {NavigationSession} session */
export function showEdges(session) {
  const { path, rollouts } = session.run;
  byId("path", HTMLElement).hidden = !rollouts || session.part !== "plan";
  const mark = (/** @type {number | null} */ edge) => () => session.select({ edge });
  byId("edges", HTMLElement).replaceChildren(
    ...(rollouts ?? []).map(({ of, forward, backward }, i) => {
      const length = Math.hypot(path[i + 1][0] - path[i][0], path[i + 1][1] - path[i][1]);
      const text = make("span", {}, `rollouts: ${forward} of ${of} there, ${backward} of ${of} back`);
      const edge = make(
        "button",
        {
          type: "button",
          id: `edge-${i + 1}`,
          onfocus: mark(i),
          onblur: mark(null),
          onpointerenter: mark(i),
          onpointerleave: mark(null),
        },
        text,
        make("span", { className: "hint" }, `${num(length, 1)} m`),
      );
      return make("li", {}, edge);
    }),
  );
}

/** The comparison so far. @param {NavigationSession} session */
export function showCompared({ comparison: { summary }, hasLoad }) {
  const rows = COMPARED.map((way) => {
    const found = summary.find(({ method }) => method === way);
    if (!found || found.reached.n === 0)
      return row(WAY_WORDS[way].title, [NONE, intervalOf(null), ...(hasLoad ? [NONE] : []), NONE, NONE, NONE, NONE], {
        way,
        reached: "",
      });
    const { reached, collisions, swings, planned, length, time } = found;
    return row(
      WAY_WORDS[way].title,
      [
        shareText(reached),
        intervalOf(reached),
        shareText(collisions),
        ...(hasLoad ? [shareText(swings)] : []),
        way === "policy" ? "no plan" : `${countOf(planned)} of ${planned.n}`,
        meanOf(length, "m"),
        meanOf(time, "s"),
      ],
      { way, reached: countOf(reached) },
    );
  });
  byId("compared", HTMLTableElement).tBodies[0].replaceChildren(...rows);
}

/** @param {MethodSummary["reached"]} share */
function countOf({ n, share }) {
  return Math.round(n * (share ?? 0));
}

/** @param {MethodSummary["reached"]} share */
function shareText(share) {
  return `${countOf(share)} of ${share.n} (${percentText(share.low).replace(" %", "")}\u2013${percentText(share.high)})`;
}

/** @param {MethodSummary["length"]} mean @param {string} unit */
function meanOf({ mean }, unit) {
  return mean === null ? NONE : `${num(mean, 1)} ${unit}`;
}

/** A dot for a share and a line for its interval, from 0 to 100 %. @param {MethodSummary["reached"] | null} share */
function intervalOf(share) {
  const { width, height, margin } = SIZE;
  const x = (/** @type {number | null} */ value) => margin + (width - 2 * margin) * (value ?? 0);
  const middle = height / 2;
  const line = (
    /** @type {string} */ name,
    /** @type {number} */ x1,
    /** @type {number} */ x2,
    y1 = middle,
    y2 = middle,
  ) => makeSvg("line", { class: name, x1, x2, y1, y2 });
  const axis = [
    line("axis", x(0), x(1)),
    ...[0, 0.5, 1].map((value) => line("axis", x(value), x(value), middle - 3, middle + 3)),
  ];
  const marks = share
    ? [line("interval", x(share.low), x(share.high)), makeSvg("circle", { cx: x(share.share), cy: middle, r: 4.5 })]
    : [];
  return makeSvg(
    "svg",
    { class: "share", viewBox: `0 0 ${width} ${height}`, width, height, "aria-hidden": "true" },
    ...axis,
    ...marks,
  );
}

/** The comparison as a table: a row for each drive. @param {NavigationSession} session */
export function comparedCsv({ comparison: { executions, queries } }) {
  const columns = [
    "query",
    "way",
    "outcome",
    "length",
    "time",
    "start_x",
    "start_y",
    "start_theta",
    "goal_x",
    "goal_y",
  ];
  return csvFile(
    columns,
    executions.map(({ query, method, outcome, length, time }) => [
      query + 1,
      method,
      outcome ?? "no path",
      outcome ? length : null,
      outcome ? time : null,
      ...queries[query].start,
      ...queries[query].goal,
    ]),
  );
}
