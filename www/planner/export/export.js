/**
 * The export panel: images of the stage, the scenario, and the data of the runs. Each row describes its file, or says
 * why there is none.
 */
import { json, save } from "../../app/files.js";
import { showEmbedCode } from "../../app/embed-code.js";
import { byId, make, write } from "../../app/dom.js";
import { imageOf } from "../../draw/export.js";
import { writeNpy } from "../../formats/npy.js";
import { downloadRow, failureOf } from "../../widgets/download-row.js";
import { row, select } from "../../widgets/elements.js";
import { filmRow } from "../../widgets/films.js";
import { ImageWords } from "../../widgets/image-words.js";
import { Progress } from "../../widgets/progress.js";
import { encodeLink } from "../link/codec.js";
import { experimentOf } from "../link/experiment.js";
import { PAST } from "../run-log/columns.js";
import { NONE } from "../timeline/playback.js";
import { countersCsv, nameOf } from "./files.js";
import { filmsOf } from "./films.js";
import { layoutOfStage, sameRun } from "./picture.js";

/** @import { App } from "../../app/app.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { Open } from "../link/experiment.js" */
/** @import { Timeline } from "../timeline/playback.js" */
/** @import { Drives } from "./films.js" */
/** @import { Session } from "./picture.js" */
/** @import { Timing } from "../timing/timing.js" */
/** @import { PathForm } from "planarium/import" */
/**
 * @typedef {object} State
 * @property {{ now: number }} clock
 * @property {string[]} summary
 * @property {{ status: string, made: number, iteration: number }[]} lanes
 */
/**
 * @typedef {object} Host   what is taken of the page
 * @property {App} app
 * @property {Session & Drives & { timeline: Timeline }} session
 * @property {State | null} state
 * @property {{ name: string, robot: string, document: ScenarioDocument } | null} facts
 * @property {string[]} names
 * @property {{ timing: Timing } | null} timing   the fold that times paths, once it was opened
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: State) => void) => void} onState
 */
/** @typedef {Open & Host} Page */
/** @import { ImageKind } from "../../draw/export.js" */
/**
 * @typedef {{ button: HTMLButtonElement, hint: HTMLElement, meaning: string, lack: (state: State) => string }}
 *   Offer   `lack`: why there is no file, or empty
 */

/**
 * The forms of a timed path; those with places are not for arms.
 * @type {{ id: PathForm, title: string, extension: string, type: string, isPlaced: boolean }[]}
 */
const FORMS = [
  { id: "csv", title: "CSV", extension: "csv", type: "text/csv", isPlaced: false },
  { id: "json", title: "JSON", extension: "json", type: "application/json", isPlaced: false },
  { id: "npy", title: "NPY", extension: "npy", type: "application/octet-stream", isPlaced: false },
  { id: "svg", title: "SVG", extension: "svg", type: "image/svg+xml", isPlaced: false },
  { id: "geojson", title: "GeoJSON", extension: "geojson", type: "application/geo+json", isPlaced: true },
  { id: "nav-path", title: "ROS path", extension: "yaml", type: "application/yaml", isPlaced: true },
  { id: "nav-waypoints", title: "ROS waypoints", extension: "yaml", type: "application/yaml", isPlaced: true },
];

/** @param {State} state */
const noRun = ({ lanes }) => (lanes.some(({ status }) => status === "none") ? "No planner has run." : "");
const always = () => "";

/** @param {Page} page @param {() => string} head   what was run, above the legend of images */
export function showExport(page, head) {
  const { session } = page;
  const host = byId("export", HTMLElement);
  /** @type {Offer[]} */
  const offers = [];
  const progress = new Progress(() => {
    if (page.state) reflect(page.state);
  });
  const scale = select(
    "export-scale",
    "Size",
    [
      ["1", "1\u00d7"],
      ["2", "2\u00d7"],
      ["4", "4\u00d7"],
    ],
    "2",
  );
  const words = new ImageWords();
  const lane = select("export-lane", "Planner", []);
  const form = select(
    "export-form",
    "Form",
    FORMS.map(({ id, title }) => [id, title]),
  );
  const laneRow = row("Planner", lane);
  laneRow.hidden = true;
  const films = filmRow(page.app, progress, { subjects: filmsOf(page), name });

  host.append(
    offer("png", "Image", "PNG", "The stage as shown.", always, () => draw("png"), scale),
    offer("svg", "Vector graphic", "SVG", "The stage as shown, sharp at any size.", always, () => draw("svg")),
    words.element,
    films.element,
    offer("scenario", "Scenario", "JSON", "For this page, the package and the command line.", always, async () => {
      const { facts } = page;
      if (facts) save(json(facts.document), `${facts.name}.json`);
    }),
    laneRow,
    offer("result", "Result", "JSON", "Path, length, counts and fingerprint.", noRun, async () => {
      const run = await runOf(lane.value);
      save(json(asked() ?? run.result), `${nameOfLane(run.made)}-result.json`);
    }),
    offer(
      "path",
      "Path",
      "NPY",
      "For NumPy: one row per waypoint.",
      (state) =>
        state.lanes[Number(lane.value)]?.status === "solved"
          ? ""
          : "No path yet: it can be saved once the run has ended.",
      async () => {
        const { path, dimension } = await runOf(lane.value);
        save(npy(Float64Array.from(asked()?.path.flat() ?? path), dimension), `${nameOfLane()}-path.npy`);
      },
    ),
    offer("trajectory", "Trajectory", "JSON", "The path with its timing, for planarium verify.", untimed, async () => {
      const trajectory = await page.timing?.timing.document(Number(lane.value));
      if (trajectory) save(json(trajectory), `${nameOfLane()}-trajectory.json`);
    }),
    offer(
      "timed",
      "Timed path",
      "Save",
      "For other programs, in the coordinates of the map.",
      untimed,
      async () => {
        const { id, extension, type } = FORMS.find(({ id }) => id === form.value) ?? FORMS[0];
        const bytes = await page.timing?.timing.write(Number(lane.value), id);
        const what = id.startsWith("nav") ? id : "timed";
        if (bytes)
          save(
            new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)], { type }),
            `${nameOfLane()}-${what}.${extension}`,
          );
      },
      form,
    ),
    offer("vertices", "Vertices", "NPY", "For NumPy: one row per vertex shown.", noRun, async () => {
      const { vertices, past, dimension } = await runOf(lane.value);
      save(npy(vertices.slice(0, past[PAST.vertices]), dimension), `${nameOfLane()}-vertices.npy`);
    }),
    offer("counters", "Counters", "CSV", "For a spreadsheet: one row per iteration.", noRun, async () => {
      const runs = await Promise.all(page.plans.map((_, i) => runOf(i)));
      save(countersCsv(runs), `${name(page.state?.lanes[0].made)}.csv`);
    }),
  );
  showEmbedCode(page.app, host, async () => encodeLink(experimentOf(page)));
  page.onOpen(() => progress.cancel());
  page.onState(reflect);

  /**
   * @param {string} id @param {string} title @param {string} format @param {string} meaning @param {Offer["lack"]} lack
   * @param {() => Promise<void>} saveFile @param {...HTMLElement} choices
   */
  function offer(id, title, format, meaning, lack, saveFile, ...choices) {
    const { element, ...one } = downloadRow(
      { id, title, format, meaning },
      () => void page.app.track(saveFile(), failureOf(title)),
      ...choices,
    );
    offers.push({ ...one, meaning, lack });
    return element;
  }

  /** Why the path has no trajectory. */
  function untimed() {
    const { timing = null } = page.timing ?? {};
    return timing && timing.indexOf(Number(lane.value)) >= 0 ? "" : "The path is not timed: open \u201cTiming\u201d.";
  }

  /** @param {State} state */
  function reflect(state) {
    const { names } = page;
    const isArm = page.facts?.robot === "arm";
    for (const [i, option] of Array.from(form.options).entries()) option.disabled = isArm && FORMS[i].isPlaced;
    if (form.selectedOptions[0]?.disabled) form.value = FORMS[0].id;
    laneRow.hidden = names.length === 1;
    if (lane.dataset.names !== names.join("|")) {
      lane.dataset.names = names.join("|");
      lane.replaceChildren(...names.map((text, i) => make("option", { value: String(i) }, text)));
    }
    for (const one of offers) {
      const reason = one.lack(state);
      one.button.disabled = reason !== "" || (progress.isBusy && /export-(png|svg)/.test(one.button.id));
      write(one.hint, reason || one.meaning);
    }
    films.reflect();
  }

  /** The run of a lane, with its result. @param {number | string} index */
  async function runOf(index) {
    const run = session.lanes[Number(index)]?.run;
    if (!run) throw Object.assign(new Error("There is no run."), { code: "no-run" });
    if (!run.hasResult) await session.timeline.request(NONE, true);
    return run;
  }

  /** The result shown where the roadmap was asked for another path. */
  function asked() {
    return session.lanes[Number(lane.value)]?.asked?.result;
  }

  /** The name of a file, at the time shown. @param {number} [time] */
  function name(time = page.state?.clock.now ?? 0) {
    return nameOf(page.facts?.name ?? "", page.plans, time);
  }

  /** The same for the chosen planner. @param {number} [time] */
  function nameOfLane(time = page.state?.lanes[Number(lane.value)].iteration ?? 0) {
    return nameOf(page.facts?.name ?? "", [page.plans[Number(lane.value)]], time);
  }

  /** Makes and saves an image. @param {ImageKind} kind */
  async function draw(kind) {
    const style = {
      title: page.state?.summary[0] ?? "",
      ratio: Number(scale.value),
      advice: "choose a smaller size",
      check: sameRun(session),
    };
    const layout = words.addTo(layoutOfStage(session), head());
    await progress.save(`${name()}.${kind}`, (onProgress) => imageOf(kind, layout, style, onProgress));
  }
}

/** @param {Float64Array} rows @param {number} dimension */
function npy(rows, dimension) {
  return new Blob([writeNpy(rows, [rows.length / dimension, dimension])]);
}
