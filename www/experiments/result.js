/** The result in sentences: the settings of planners are compared, all with the first one or two with each other. */
import { byId, make } from "../app/dom.js";
import { comparisons } from "./comparisons.js";

/** @import { ChartData } from "./charts.js" */
/** @import { ExperimentSession } from "./session.js" */

/**
 * @param {ExperimentSession} session @param {() => ChartData | null} chart
 * @returns {() => void}  writes the sentences, while no trial runs
 */
export function watchResult(session, chart) {
  const fold = byId("words-fold", HTMLDetailsElement);
  const [baselines, others] = ["baseline", "other"].map((id) => byId(id, HTMLSelectElement));
  // The two change places where one becomes the other.
  baselines.addEventListener("change", () =>
    session.show({
      baseline: baselines.value,
      other: baselines.value === others.value ? session.view.baseline : others.value,
    }),
  );
  others.addEventListener("change", () => session.show({ baseline: baselines.value, other: others.value }));
  fold.addEventListener("toggle", show);
  return show;

  function show() {
    if (!fold.open || session.isBusy) return;
    const { rows, factors, view, ceiling, units } = session;
    const { subject } = session.shown;
    const which = chart()?.common?.which;
    const { sentences, names, baseline, other } = comparisons(rows, factors, subject, {
      ...view,
      which,
      units,
    });
    byId("pair", HTMLElement).hidden = names.length < 2;
    offer(baselines, names, baseline);
    offer(
      others,
      names.filter((name) => name !== baseline),
      other,
    );
    byId("words", HTMLElement).replaceChildren(
      ...[...sentences, ...(ceiling ? [ceiling.words] : [])].map((text) => make("li", {}, text)),
    );
  }
}

/** @param {HTMLSelectElement} select @param {string[]} names @param {string} value */
function offer(select, names, value) {
  select.replaceChildren(...names.map((name) => make("option", { value: name }, name)));
  select.value = value;
}
