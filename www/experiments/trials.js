/** The table of trials: some of those that have ended, each with a link to its run on the planner's page. */
import { byId, grouped, make } from "../app/dom.js";
import { errorInfo } from "../app/error-info.js";
import { button, tableHead } from "../widgets/elements.js";
import { capital } from "../widgets/format.js";
import { nameOfColumn } from "./factors.js";
import { measureInfo, scaleOf } from "./measures.js";
import { trialLink } from "./trial-link.js";

/** @import { ExperimentSession } from "./session.js" */
/** @import { Cell } from "./rows.js" */

/** Trials of a page. */
const PAGE = 20;

/** @param {ExperimentSession} session @returns {() => void}  writes the table if it has changed */
export function watchTrials(session) {
  const host = byId("trials", HTMLElement);
  const fold = byId("trials-fold", HTMLDetailsElement);
  const table = make("table", { className: "standings" });
  host.append(table);
  const turn = (/** @type {number} */ by) => session.show({ row: Math.max(0, first() + by * PAGE) || undefined });
  const back = button("trials-back", "Earlier", () => turn(-1));
  const on = button("trials-on", "Later", () => turn(1));
  byId("trial-pages", HTMLElement).append(back, on);
  let drawn = "";
  fold.addEventListener("toggle", draw);
  return draw;

  function first() {
    return Math.min(session.view.row ?? 0, Math.max(0, session.rows.count - 1));
  }

  function draw() {
    const { rows, factors, asked, unit, view, info } = session;
    const from = first();
    const trials = [];
    for (let trial = from; trial < Math.min(rows.count, from + PAGE); trial++)
      if (rows.isKnown[trial]) trials.push(trial);
    const key = `${info?.fingerprint} ${JSON.stringify(asked)} ${from} ${trials} ${rows.count} ${view.measure}`;
    if (!fold.open || key === drawn) return;
    drawn = key;
    back.disabled = from === 0;
    on.disabled = from + PAGE >= rows.count;
    const columns = [
      "seed",
      ...(rows.columns.includes("world_seed") ? ["world_seed"] : []),
      ...factors.map(({ column }) => column),
      "status",
    ];
    const named = (/** @type {string} */ column, /** @type {Cell} */ value) =>
      factors.find((factor) => factor.column === column)?.words?.get(value) ?? value;
    const heads = [
      ...columns.map(nameOfColumn),
      ...asked.map((id) => {
        const { title, unit: words } = measureInfo(id, unit);
        return `${title}${words && `, ${words}`}`;
      }),
    ];
    table.replaceChildren(
      make(
        "caption",
        {},
        rows.count === 0
          ? "No trials"
          : `Trials ${grouped(from)} to ${grouped(Math.min(rows.count, from + PAGE) - 1)} of ${grouped(rows.count)}`,
      ),
      tableHead(["trial", ...heads].map(capital)),
      make(
        "tbody",
        {},
        ...trials.map((trial) => {
          const values = [
            ...columns.map((column) => named(column, rows.cell(trial, column))),
            ...asked.map((id) => scaled(rows.cell(trial, id), scaleOf(id))),
          ];
          const link = make("a", { target: "_blank", rel: "noopener" }, String(trial));
          // A scenario may be too large for a link.
          address(trial).then(
            (href) => {
              link.href = href;
            },
            (error) => {
              link.title = errorInfo(error).message;
            },
          );
          return make(
            "tr",
            { dataset: { trial } },
            make("th", { scope: "row" }, link),
            ...values.map((value) => make("td", {}, value === null ? "\u2013" : String(value))),
          );
        }),
      ),
    );
  }

  /** @param {number} trial */
  async function address(trial) {
    const { document, resolved, rows } = session;
    return resolved ? trialLink(document, resolved, rows, trial) : "";
  }
}

/** A number with few digits. @param {Cell} value @param {number} scale */
function scaled(value, scale) {
  return typeof value === "number" && !Number.isInteger(value) ? Number((scale * value).toPrecision(4)) : value;
}

/** Opens the run of a trial on the planner's page. @param {ExperimentSession} session @param {number} trial */
export async function openTrial({ document, resolved, rows }, trial) {
  if (!resolved) return;
  make("a", { href: await trialLink(document, resolved, rows, trial), target: "_blank", rel: "noopener" }).click();
}
