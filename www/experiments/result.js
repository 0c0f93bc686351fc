/** The result in sentences: the settings of planners are compared, all with the first one or two with each other. */
import { byId, grouped, make } from "../app/dom.js";
import { comparisons } from "./comparisons.js";

/** @import { ChartData } from "./charts.js" */
/** @import { ExperimentSession } from "./session.js" */

/**
 * @param {ExperimentSession} session @param {() => ChartData | null} chart
 * @returns {() => void}  writes the sentences
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
    if (!fold.open) return;
    const { rows, factors, view, ceiling, units } = session;
    if (session.isBusy) {
      tell(["Settings are compared once the trials have ended, or pause."]);
      byId("pair", HTMLElement).hidden = true;
      return;
    }
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
    const isPart = rows.done > 0 && rows.done < rows.count;
    const part = isPart ? [`So far ${grouped(rows.done)} of ${grouped(rows.count)} trials have ended.`] : [];
    tell([...part, ...sentences, ...(ceiling ? [ceiling.words] : [])]);
  }

  /** @param {string[]} sentences */
  function tell(sentences) {
    const words = byId("words", HTMLElement);
    if (sentences.join("\n") === Array.from(words.children, ({ textContent }) => textContent).join("\n")) return;
    words.replaceChildren(...sentences.map((text) => make("li", {}, text)));
  }
}

/** @param {HTMLSelectElement} select @param {string[]} names @param {string} value */
function offer(select, names, value) {
  select.replaceChildren(...names.map((name) => make("option", { value: name }, name)));
  select.value = value;
}
