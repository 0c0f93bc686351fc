/** One run is one seed: the same scene, query and planners as an experiment over many seeds, on the experiments page. */
import { encodeFragment } from "../formats/fragment.js";
import { make } from "../app/dom.js";
import { generationOf } from "./experiment.js";
import { changed } from "../domain/option-names.js";

/** @import { ExperimentDocument } from "planarium/full" */
/** @import { LinkedDocument, LinkedWorld, PlannerInfo } from "../domain/types.js" */
/** @import { Page } from "./page.js" */

const SEEDS = 100;
/** Those of a link of the experiments page. */
const LIMITS = { characters: 65_535, bytes: 1 << 20 };

/**
 * The experiment. Settings are written where they differ from the core's defaults, which are not all the page's.
 * @param {Page} page
 * @param {PlannerInfo[]} infos   of the core
 * @returns {LinkedDocument}
 */
export function experimentOver({ record, entry, name, plans, names, planners }, infos) {
  const [first, ...rivals] = plans;
  const title =
    rivals.length > 0
      ? `${name}: a race over ${SEEDS} seeds`
      : `${name}: ${planners.titleOf(first.algorithm)} over ${SEEDS} seeds`;
  return {
    format: "planarium-experiment-1",
    title,
    worlds: [worldOf(record, entry?.title)],
    planners: plans.map(({ algorithm, settings: { seed: _, ...settings } }, lane) => {
      const table = infos.find(({ id }) => id === algorithm)?.parameters ?? [];
      const usual = new Map(table.map(({ name: parameter, default: value }) => [parameter, value]));
      const set = changed(settings, (parameter) => usual.get(parameter));
      // In a race with its letter, since planners may differ in their seeds alone.
      return /** @type {ExperimentDocument["planners"][number]} */ ({
        ...(rivals.length > 0 ? { name: names[lane] } : {}),
        algorithm,
        set,
      });
    }),
    seeds: { from: 0, count: SEEDS },
  };
}

/**
 * The open scene as the world of an experiment: by its name, where it is a built-in one as it was opened.
 * @param {Page["record"]} record
 * @param {string} [title]
 * @returns {LinkedWorld}
 */
function worldOf({ scene, document, options = {}, query }, title) {
  const queries = query === undefined ? {} : { queries: [query] };
  if (document) return { scenario: /** @type {any} */ (document), ...queries };
  const generation = generationOf({ scene, options });
  if (!generation || (title && Object.keys(options).length === 0)) return { scene: String(scene), ...queries };
  const { kind } = generation;
  const { seed = 0, ...set } = generation.options;
  return /** @type {LinkedWorld} */ ({
    ...(title ? { name: title } : {}),
    generate: kind,
    set,
    seeds: [seed],
    ...queries,
  });
}

/** Opens the experiments page with the scene, the query and the planners of a page. @param {Page} page */
export function openOverSeeds(page) {
  void page.app.track(open(page), "The experiment cannot be opened.");
}

/** @param {Page} page */
async function open(page) {
  const document = experimentOver(page, page.session.library.planners());
  // Shares of solved trials and their work in one picture: where all are solved, the work tells them apart.
  const state = { document, view: { chart: "ecdf", work: "clearance_evaluations" }, run: true };
  const fragment = await encodeFragment(state, LIMITS).catch((error) => {
    if (!page.record.document) throw error;
    throw new Error(
      "The scene is too large for the link: save it as a scenario, under Export, and open that on the page Experiments.",
      { cause: error },
    );
  });
  make("a", { href: `experiments.html#${fragment}`, target: "_blank", rel: "noopener" }).click();
}
