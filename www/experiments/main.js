/**
 * The page of experiments: it makes the session, the form, the chart and the table of trials.
 *
 * For tests, beside what app.js says: `body` carries `data-phase` (a phase of session.js), `data-done` and `data-count`
 * (trials), `data-fingerprint` (of the experiment), `data-chart` (its kind, once it is drawn) and `data-drawn` (trials
 * in the chart).
 */
import { Experiment } from "planarium/full";
import { App } from "../app/app.js";
import { watchEscape } from "../app/escape.js";
import { byId, counted, grouped, make } from "../app/dom.js";
import { watchFiles } from "../app/drop.js";
import { json } from "../app/files.js";
import { watchKeys } from "../app/keys.js";
import { useLink } from "../app/link.js";
import { once } from "../app/once.js";
import { pngPicture, svgPicture } from "../draw/picture.js";
import { csvFile } from "../formats/csv.js";
import { showFiles } from "../widgets/downloads.js";
import { capital } from "../widgets/format.js";
import { chartOf, completed, remarkOf } from "./charts.js";
import { comparisons } from "./comparisons.js";
import { watchControls } from "./controls.js";
import { plannerTitle } from "./factors.js";
import { enoughSeeds, watchForm } from "./form.js";
import { stateRule } from "./link.js";
import { SOLVED } from "./measures.js";
import { READY, loadReady, readyOf } from "./ready.js";
import { ExperimentSession } from "./session.js";
import { sampleOf } from "./tables.js";
import { openTrial, watchTrials } from "./trials.js";

/** @import { ChartData } from "./charts.js" */
/** @import { LinkedDocument } from "../domain/types.js" */
/** @import { ExperimentState } from "./link.js" */
/** @import { ExperimentWorker } from "./pool.js" */
/** @import { Change } from "./session.js" */

/**
 * Milliseconds between two drawings while trials end: at least this number, and this many times as long as a drawing
 * takes.
 */
const PAUSE = 400;
const REST = 8;
/** Rows of the table of the chart, at most. */
const MOST_ROWS = 400;
/**
 * Trials that run as they are opened, at most: of an experiment that the reader chose here or in a file, and of a link,
 * which may come from anyone.
 */
const AT_ONCE = { here: 5000, link: 400 };
/** Image pixels a CSS pixel. */
const SCALE = 2;

const app = new App();
watchEscape();

await app.open("experiments", async (/** @type {ExperimentWorker} */ worker) => {
  const session = new ExperimentSession(app, worker);
  const [chartHost, tableHost, stage] = ["chart", "table", "stage"].map((id) => byId(id, HTMLElement));
  const [tableFold, wordsFold] = ["table-fold", "words-fold"].map((id) => byId(id, HTMLDetailsElement));
  const [run, cancel] = ["run", "cancel"].map((id) => byId(id, HTMLButtonElement));
  const progress = byId("progress", HTMLProgressElement);
  const showControls = watchControls(session);
  const showTrials = watchTrials(session);
  const drawing = once(() => import("./draw.js"));
  watchForm(session);
  /** @type {ChartData | null} */
  let chart = null;
  /** @type {SVGSVGElement | null} */
  let picture = null;
  /** The picture with title and caption. @type {() => SVGSVGElement | null} */
  let framed = () => null;
  /** Whether the chart is out of date, when it was last drawn, and for how long. */
  let isStale = true;
  let [drawnAt, took] = [-Infinity, 0];
  let isDrawing = false;
  /** Trials that run without a click, at most. */
  let atOnce = AT_ONCE.here;
  /** The document that was opened last: another one is an edited one. @type {LinkedDocument | null} */
  let opened = null;

  session.onChange((change) => {
    if (change !== "phase" || !chart) isStale = true;
    show(change);
  });
  new ResizeObserver(() => redraw()).observe(chartHost);
  app.onTheme(redraw);
  tableFold.addEventListener("toggle", () => showTable());
  wordsFold.addEventListener("toggle", () => showWords());
  const [baselines, others] = ["baseline", "other"].map((id) => byId(id, HTMLSelectElement));
  // The two change places where one becomes the other.
  baselines.addEventListener("change", () =>
    session.show({
      baseline: baselines.value,
      other: baselines.value === others.value ? session.view.baseline : others.value,
    }),
  );
  others.addEventListener("change", () => session.show({ baseline: baselines.value, other: others.value }));
  const [title, caption] = [byId("title", HTMLInputElement), byId("own-caption", HTMLTextAreaElement)];
  title.addEventListener("change", () => session.rename(title.value.trim()));
  caption.addEventListener("input", () => session.show({ caption: caption.value || undefined }));
  watchPrint();
  app.onFrame(animate);
  // The core of a worker was lost, not the document: it is opened again with the next trial.
  app.rebuild = () => {};

  run.addEventListener("click", toggle);
  cancel.addEventListener("click", () => session.cancel());
  watchKeys([stage], { " ": toggle });
  chartHost.addEventListener("click", ({ target }) => {
    const trial = target instanceof Element ? target.getAttribute("data-trial") : null;
    if (trial !== null) void app.track(openTrial(session, Number(trial)));
  });

  const ready = byId("ready", HTMLSelectElement);
  ready.append(
    make("option", { value: "", disabled: true }, "custom"),
    ...READY.map(({ id, title }) => make("option", { value: id }, title)),
  );
  ready.addEventListener("change", () => void app.track(openReady(ready.value)));
  watchFiles(app, (name, bytes) => void app.track(openFile(name, bytes), `${name} could not be opened.`));

  const name = () =>
    (session.info?.title || "experiment")
      .toLowerCase()
      .replace(/[^a-z0-9]+/g, "-")
      .replace(/^-+|-+$/g, "")
      .slice(0, 40);
  const chartName = () => `${name()}-${chart?.kind.id ?? "chart"}`;
  const shown = () => {
    const whole = framed();
    if (!whole || !chart) throw new Error("There is no chart yet.");
    return { picture: whole, chart, ground: app.look.palette.stage };
  };
  showFiles(app, name, [
    {
      id: "png",
      title: "Chart",
      format: "PNG",
      meaning: "The chart with its title and caption.",
      name: chartName,
      content: () => pngPicture(shown().picture, shown().ground, shown().chart.title, SCALE),
    },
    {
      id: "svg",
      title: "Vector graphic",
      format: "SVG",
      meaning: "The same, sharp at any size.",
      name: chartName,
      content: () => svgPicture(shown().picture, shown().ground, shown().chart.title),
    },
    {
      id: "table",
      title: "Table of the chart",
      format: "CSV",
      meaning: "The numbers behind the chart.",
      name: chartName,
      content: () =>
        csvFile(
          shown().chart.columns,
          shown()
            .chart.rows()
            .map((row) => row.map((cell) => (typeof cell === "boolean" ? String(cell) : cell))),
        ),
    },
    {
      id: "rows",
      title: "Rows of all trials",
      format: "CSV",
      meaning: "The rows of \u201cplanarium sweep\u201d.",
      content: () => session.rows.csv(),
    },
    {
      id: "times",
      title: "Times of all trials",
      format: "CSV",
      meaning: "Seconds on this machine.",
      name: () => `${name()}.times`,
      content: () => session.rows.timesCsv(),
    },
    {
      id: "summary",
      title: "Summary",
      format: "JSON",
      meaning: "Statistics and comparisons, as \u201cplanarium sweep\u201d prints them.",
      name: () => `${name()}.summary`,
      content: summary,
    },
    {
      id: "document",
      title: "Experiment",
      format: "JSON",
      meaning: "The document, for this page and for \u201cplanarium sweep\u201d.",
      content: () => json(session.resolved ?? session.document),
    },
  ]);

  await useLink(app, stateRule, {
    save: () => ({ document: session.document, view: session.view }),
    contents: "the experiment and the chart. The trials run again where it is opened",
    open: async (/** @type {ExperimentState | null} */ state) => {
      if (!state) {
        if (!session.info) await openReady(READY[0].id);
        return;
      }
      const { id, isKnown } = await readyOf(state.document);
      await open(state, id, isKnown ? AT_ONCE.here : AT_ONCE.link);
    },
  });

  /** The statistics of the rows, by the core. */
  function summary() {
    if (!session.resolved) throw new Error("There is no experiment.");
    const experiment = Experiment.parse(session.resolved);
    try {
      return json(experiment.summary(session.rows.records()));
    } finally {
      experiment.free();
    }
  }

  /** @param {string} id */
  async function openReady(id) {
    await open(await loadReady(id), id);
  }

  /**
   * Opens an experiment, and runs it if it is short. One that asks to run does so with reduced motion, too.
   * @param {ExperimentState} state
   * @param {string} id  of a ready one, or empty
   * @param {number} [most]  trials that run without a click
   */
  async function open(state, id, most = AT_ONCE.here) {
    app.notice.hide();
    ready.value = id;
    opened = state.document;
    atOnce = most;
    const isAccepted = await session.open(state);
    const isAsked = state.run ?? !app.reducedMotion;
    if (isAccepted && isAsked && (session.info?.trialCount ?? Infinity) <= most) start();
  }

  /** @param {string} fileName @param {Uint8Array} bytes */
  async function openFile(fileName, bytes) {
    // The core says what is wrong with anything that is not an experiment.
    const read = JSON.parse(new TextDecoder().decode(bytes)) ?? {};
    const isScenario = read.format === "planarium-scenario-1";
    const { document } = session;
    const title = fileName.replace(/\.json$/, "");
    await open(
      isScenario
        ? { document: enoughSeeds({ ...document, title, worlds: [{ scenario: read }] }), view: {} }
        : { document: read, view: {} },
      "",
    );
  }

  function start() {
    void app.track(session.start(), "A trial could not be run.");
  }

  function toggle() {
    if (run.disabled) return;
    if (session.phase === "running") void app.track(session.pause());
    else {
      if (session.phase === "done") session.cancel();
      start();
    }
  }

  /** @param {Change} change */
  function show(change) {
    const { phase, rows, info, refusal, pool } = session;
    Object.assign(document.body.dataset, {
      phase,
      done: rows.done,
      count: rows.count,
      fingerprint: info?.fingerprint ?? "",
    });
    run.textContent =
      phase === "running" || phase === "pausing"
        ? "Pause"
        : phase === "done"
          ? "Run again"
          : rows.done > 0
            ? "Go on"
            : "Run";
    // What cannot be read in the form does not run.
    run.disabled =
      !["ready", "running", "paused", "failed", "done"].includes(phase) ||
      (phase !== "running" && byId("form", HTMLElement).querySelector("[aria-invalid=true]") !== null);
    cancel.disabled = !["running", "paused", "failed"].includes(phase) && session.uncertified === 0;
    progress.value = rows.count > 0 ? rows.done / rows.count : 0;
    byId("progress-text", HTMLElement).textContent = progressText();
    if (change === "checked" && phase === "refused" && refusal) {
      app.notice.show(
        "The experiment is refused.",
        Object.assign(new Error(), refusal, { message: sentenceOf(refusal.message) }),
      );
      app.notice.element.scrollIntoView({ block: "nearest" });
    } else if (change === "checked") app.notice.hide();
    if (session.document !== opened) ready.value = "";
    if (document.activeElement !== title) title.value = session.document.title ?? "";
    if (document.activeElement !== caption) caption.value = session.view.caption ?? "";
    app.write({ where: info ? `${grouped(rows.count)} trials${pool.most > 1 ? ` on ${pool.most} workers` : ""}` : "" });
    app.say(sentence(), { isBad: phase === "refused" || phase === "failed", isSilent: change === "rows" });
    if (change === "checked" || change === "view" || change === "document") showControls();
  }

  function sentence() {
    const {
      phase,
      info,
      rows,
      document: { title },
      refusal,
    } = session;
    const about = (/** @type {string} */ end) =>
      title ? `${title.replace(/[.:]$/, "")}${/[?!]$/.test(title) ? "" : end} ` : "";
    const begin = about(":");
    if (phase === "refused" || phase === "failed")
      return `${about(".")}${phase === "refused" ? "The experiment is refused" : "The trials stopped"}: ${refusal?.message ?? ""}.`;
    if (!info) return `${begin}Checking the experiment\u2026`;
    const { worlds, planners } = session.document;
    if (rows.done === 0 && phase === "ready")
      return `${begin}${grouped(info.trialCount)} trials of ${counted(planners.length, "planner")} in ${counted(worlds.length, "kind of world", "kinds of worlds")}. Press Run.`;
    if (phase !== "done")
      return `${begin}${grouped(info.trialCount)} trials ${phase === "running" ? "are running" : "wait"}\u2026`;
    const solved = sampleOf(rows, Array.from(rows.ended()), SOLVED).reduce((sum, one) => sum + one, 0);
    const { ceiling } = session;
    const limit = ceiling && ceiling.most < 100 ? ` At most ${Number(ceiling.most.toFixed(1))} % can be solved.` : "";
    return `${begin}${grouped(solved)} of ${grouped(rows.count)} trials found a path.${limit}`;
  }

  function progressText() {
    const { rows, phase, runtime } = session;
    if (rows.count === 0) return "";
    if (session.uncertified > 0) return `${counted(session.uncertified, "world")} left to examine for a path`;
    const left = rows.done > 0 && session.isBusy ? (runtime / rows.done) * (rows.count - rows.done) : 0;
    const seconds =
      phase === "done" ? `, ${(runtime / 1000).toFixed(1)} s` : left > 0 ? `, ${timeText(left)} left` : "";
    return `${grouped(rows.done)} of ${grouped(rows.count)}${seconds}`;
  }

  function redraw() {
    isStale = true;
    app.requestFrame();
  }

  /** Draws what is out of date, at rest or after a pause. @param {number} now */
  function animate(now) {
    if (!isStale || isDrawing) return false;
    if (session.isBusy && now - drawnAt < Math.max(PAUSE, REST * took)) return true;
    isDrawing = true;
    isStale = false;
    void app.track(draw()).then(() => {
      isDrawing = false;
      if (isStale) app.requestFrame();
    });
    return false;
  }

  async function draw() {
    const { drawChart, captioned } = await drawing();
    const began = performance.now();
    const { rows, factors, view, asked, unit } = session;
    const { look } = app;
    chart = rows.done > 0 ? chartOf(rows, factors, view, asked, unit, session.ceiling) : null;
    const width = Math.max(280, Math.floor(chartHost.clientWidth));
    picture =
      chart &&
      drawChart(chart, {
        width,
        height: Math.round(Math.min(480, Math.max(300, 0.55 * width))),
        palette: look.palette,
        bold: look.bold,
      });
    framed = () =>
      picture &&
      captioned(picture, { title: session.document.title ?? "", caption: captionText(), palette: look.palette });
    if (picture) chartHost.replaceChildren(picture);
    else chartHost.replaceChildren(...waiting());
    byId("caption", HTMLElement).textContent = chart ? `${chart.kind.title}: ${chart.title}` : "";
    byId("remark", HTMLElement).textContent = captionText();
    showTable();
    showWords();
    showTrials();
    Object.assign(document.body.dataset, { chart: chart?.kind.id ?? "", drawn: rows.done });
    drawnAt = performance.now();
    took = drawnAt - began;
  }

  /** What is in the place of the chart before the first trial ends. @returns {HTMLElement[]} */
  function waiting() {
    const { phase, info } = session;
    if (!info) return [];
    if (phase !== "ready") return [make("p", { className: "hint" }, "The chart grows as trials end.")];
    const why = app.reducedMotion
      ? "With reduced motion trials do not start by themselves."
      : info.trialCount > atOnce
        ? `More than ${grouped(atOnce)} trials${atOnce === AT_ONCE.link ? " of a link" : ""} do not start by themselves.`
        : "No trial has run.";
    return [
      make("p", { className: "hint" }, why),
      make("button", { type: "button", onclick: toggle }, `Run ${counted(info.trialCount, "trial")}`),
    ];
  }

  /** The result in sentences, while no trial runs. */
  function showWords() {
    if (!wordsFold.open || session.isBusy) return;
    const { rows, factors, view, asked, measures, ceiling } = session;
    const { kind, measure, work } = completed(view, factors, asked, measures);
    const of = kind.controls.includes("measure") ? measure : work;
    const { sentences, names, baseline, other } = comparisons(rows, factors, of, {
      ...view,
      which: chart?.common?.which,
    });
    byId("pair", HTMLElement).hidden = names.length < 2;
    const offer = (
      /** @type {HTMLSelectElement} */ select,
      /** @type {string[]} */ all,
      /** @type {string} */ value,
    ) => {
      select.replaceChildren(...all.map((name) => make("option", { value: name }, name)));
      select.value = value;
    };
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

  /** What is under the chart, in its exports too: the reader's caption, or what the marks mean. */
  function captionText() {
    if (!chart) return "";
    const { view, ceiling } = session;
    const isOfPaths = chart.measure === SOLVED || chart.kind.isOfAll;
    return view.caption ?? [remarkOf(chart), ...(ceiling && isOfPaths ? [ceiling.words] : [])].join(" ");
  }

  /** The printed page is light, and has the table and the sentences instead of controls. */
  function watchPrint() {
    /** @type {HTMLDetailsElement[]} */
    let opened = [];
    const prepare = (/** @type {boolean} */ isPrint) => {
      if (isPrint) opened = [tableFold, wordsFold].filter(({ open }) => !open);
      for (const fold of opened) fold.open = isPrint;
      byId("main", HTMLElement).style.colorScheme = isPrint ? "light" : "";
      void app.track(draw());
    };
    const printing = matchMedia("print");
    printing.addEventListener("change", () => prepare(printing.matches));
  }

  function showTable() {
    if (!tableFold.open || !chart) return;
    const [{ columns }, rows] = [chart, chart.rows()];
    const cut = rows.slice(0, MOST_ROWS);
    tableHost.replaceChildren(
      make(
        "table",
        { className: "standings" },
        make(
          "caption",
          {},
          `${chart.title}${cut.length < rows.length ? `: ${cut.length} of ${grouped(rows.length)} rows; the export has all` : ""}`,
        ),
        make(
          "thead",
          {},
          make("tr", {}, ...columns.map((column) => make("th", { scope: "col" }, column.replaceAll("_", " ")))),
        ),
        make(
          "tbody",
          {},
          ...cut.map((row) =>
            make("tr", {}, ...row.map((cell) => make("td", { dataset: { value: cell } }, cellText(cell)))),
          ),
        ),
      ),
    );
  }
});

/** @param {import("./rows.js").Cell} cell */
function cellText(cell) {
  return cell === null
    ? "\u2013"
    : typeof cell === "number" && !Number.isInteger(cell)
      ? String(Number(cell.toPrecision(5)))
      : String(cell);
}

/**
 * A message as a sentence, with the title of the planner that it begins with; names of parameters stay as they are.
 * @param {string} message
 */
function sentenceOf(message) {
  const named = message.replace(/^[a-z-]+/, (algorithm) => plannerTitle({ algorithm }));
  return /^(?:these|this|there|the|another|unknown|an?|no|it) /.test(named) ? capital(named) : named;
}

/** @param {number} milliseconds */
function timeText(milliseconds) {
  const seconds = Math.ceil(milliseconds / 1000);
  return seconds < 60
    ? `${seconds} s`
    : seconds < 3600
      ? `${Math.round(seconds / 60)} min`
      : `${(seconds / 3600).toFixed(1)} h`;
}
