/** The controls of the chart: its kind, what is measured, and what is across. */
import { byId, make } from "../app/dom.js";
import { press, toggle } from "../widgets/elements.js";
import { CHARTS } from "./charts.js";
import { OF_PATHS, isShare, measureInfo, titled } from "./measures.js";

/** @import { ExperimentSession } from "./session.js" */

/** @param {ExperimentSession} session @returns {() => void}  shows the view */
export function watchControls(session) {
  const kinds = CHARTS.map((kind) => ({
    kind,
    element: make(
      "button",
      { type: "button", dataset: { kind: kind.id }, onclick: () => session.show({ chart: kind.id }) },
      kind.title,
    ),
  }));
  byId("kinds", HTMLElement).append(...kinds.map(({ element }) => element));
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
  const [log, common] = /** @type {const} */ ([
    ["isLog", "view-log", "Logarithmic"],
    ["isCommon", "view-common", "Only what all settings solved"],
  ]).map(([name, id, title]) => {
    const input = toggle(id, (isOn) => session.show({ [name]: isOn || undefined }));
    return { input, row: make("label", { htmlFor: id }, title, input) };
  });
  byId("view", HTMLElement).append(...Object.values(selects).map(({ row }) => row), log.row, common.row);
  return show;

  function show() {
    const { factors, measures, unit } = session;
    const { kind, axis, second, measure, work, isLog, canBeCommon, isCommon } = session.shown;
    const has = (/** @type {typeof kind.controls[number]} */ control) => kind.controls.includes(control);
    for (const { kind: one, element } of kinds) {
      press(element, one === kind);
      // Factors are known once the core has accepted the document.
      element.disabled = one.controls.includes("second") && session.info !== null && !second;
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
    const fitting = measures.filter(kind.fits);
    offer(
      "measure",
      fitting.map((id) => [id, title(id)]),
      measure,
      has("measure") && fitting.length > 1,
    );
    offer(
      "work",
      measures.filter((id) => !isShare(id) && !OF_PATHS.includes(id)).map((id) => [id, title(id)]),
      work,
      has("work"),
    );
    // Some charts put only numbers across.
    const columns = factors
      .filter((factor) => !kind.groupedBy || kind.groupedBy(factor) === factor)
      .map((factor) => /** @type {[string, string]} */ ([factor.column, factor.title]));
    offer("axis", columns, axis?.column, has("axis") && columns.length > 1);
    offer(
      "second",
      columns.filter(([column]) => column !== axis?.column),
      second?.column,
      has("second"),
    );
    log.row.hidden = !has("log") || isShare(measure);
    log.input.checked = isLog;
    common.row.hidden = !canBeCommon;
    common.input.checked = isCommon;
  }
}
