/** The controls of the chart: its kind, what is measured, and what is across. */
import { byId, make } from "../app/dom.js";
import { press } from "../widgets/elements.js";
import { KINDS, completed } from "./charts.js";
import { CHARTS } from "./link.js";
import { OF_PATHS, isShare, measureInfo, titled } from "./measures.js";

/** @import { ExperimentSession } from "./session.js" */

/** @param {ExperimentSession} session @returns {() => void}  shows the view */
export function watchControls(session) {
  const kinds = CHARTS.map((kind) =>
    make("button", { type: "button", dataset: { kind }, onclick: () => session.show({ chart: kind }) }, KINDS[kind]),
  );
  byId("kinds", HTMLElement).append(...kinds);
  const selects = Object.fromEntries(
    /** @type {const} */ ([
      ["measure", "Measure"],
      ["work", "Work"],
      ["axis", "Across"],
      ["second", "Up"],
    ]).map(([name, title]) => {
      const select = make("select", { id: `view-${name}`, onchange: () => session.show({ [name]: select.value }) });
      return [name, { select, row: make("label", { htmlFor: select.id }, title, select) }];
    }),
  );
  const log = make("input", {
    type: "checkbox",
    role: "switch",
    id: "view-log",
    onchange: () => session.show({ isLog: log.checked || undefined }),
  });
  const logRow = make("label", { htmlFor: log.id }, "Logarithmic", log);
  byId("view", HTMLElement).append(...Object.values(selects).map(({ row }) => row), logRow);
  return show;

  function show() {
    const { view, factors, asked, measures, unit } = session;
    const { kind, axis, second, measure, work, isLog } = completed(view, factors, asked, measures);
    for (const element of kinds) {
      press(element, element.dataset.kind === kind);
      // Factors are known once the core has accepted the document.
      element.disabled = element.dataset.kind === "heat" && session.info !== null && !second;
      element.title = element.ariaDescription = element.disabled
        ? "A heat map needs two of these: planners, worlds and parameters that vary."
        : "";
    }
    const title = (/** @type {string} */ id) => titled(measureInfo(id, unit));
    /**
     * @param {string} name
     * @param {[string, string][]} choices
     * @param {string | undefined} value
     * @param {boolean} isShown
     */
    const offer = (name, choices, value, isShown) => {
      const { select, row } = selects[name];
      row.hidden = !isShown || choices.length === 0;
      const key = choices.join();
      if (select.dataset.offered !== key)
        select.replaceChildren(...choices.map(([id, words]) => make("option", { value: id }, words)));
      select.dataset.offered = key;
      select.value = value ?? "";
    };
    const isMixed = kind === "line" || kind === "heat";
    const fitting = measures.filter((id) => isMixed || isShare(id) === (kind === "success"));
    offer(
      "measure",
      fitting.map((id) => [id, title(id)]),
      measure,
      kind !== "ecdf" && fitting.length > 1,
    );
    offer(
      "work",
      measures.filter((id) => !isShare(id) && !OF_PATHS.includes(id)).map((id) => [id, title(id)]),
      work,
      kind === "ecdf" || kind === "cost",
    );
    const columns = /** @type {[string, string][]} */ (factors.map((factor) => [factor.column, factor.title]));
    const across = kind === "cost" ? columns.filter((_, i) => factors[i].isNumeric) : columns;
    offer("axis", across, axis?.column, kind !== "ecdf" && (kind !== "cost" || across.length > 1));
    offer(
      "second",
      columns.filter(([column]) => column !== axis?.column),
      second?.column,
      kind === "heat",
    );
    logRow.hidden = kind === "success" || kind === "heat" || (kind === "line" && isShare(measure));
    log.checked = isLog;
  }
}
