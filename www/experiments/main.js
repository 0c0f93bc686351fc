/**
 * The page of experiments: it makes the session, the form, the chart and the table of trials.
 *
 * For tests, beside what app.js says: `body` carries `data-phase` (a phase of session.js), `data-done` and `data-count`
 * (trials), `data-fingerprint` (of the experiment), `data-chart` (its kind, once it is drawn) and `data-drawn` (trials
 * in the chart).
 */
import { byId, counted, grouped, make } from "../app/dom.js";
import { openRoom } from "../app/room.js";
import { roomDoor } from "../worlds/room-door.js";
import { ChartView } from "./chart-view.js";
import { watchControls } from "./controls.js";
import { showExports } from "./exports.js";
import { watchForm } from "./form.js";
import { stateRule } from "./link.js";
import { Opener } from "./opener.js";
import { watchResult } from "./result.js";
import { ExperimentSession } from "./session.js";
import { openTrial, watchTrials } from "./trials.js";
import { progressOf, refusalText, sentenceOf } from "./words.js";

/** @import { ExperimentState } from "./link.js" */
/** @import { ExperimentWorker } from "./pool.js" */
/** @import { Change } from "./session.js" */

await openRoom("experiments", (room, /** @type {ExperimentWorker} */ worker) => {
  const { app } = room;
  const session = new ExperimentSession(app, worker);
  const [run, discard] = ["run", "discard"].map((id) => byId(id, HTMLButtonElement));
  const progress = byId("progress", HTMLProgressElement);
  const [title, caption] = [byId("title", HTMLInputElement), byId("own-caption", HTMLTextAreaElement)];
  const showControls = watchControls(session);
  watchForm(session);
  const opener = new Opener(session, (id) => void room.open((signal) => opener.openReady(id, signal)), start);
  session.onChange(show);
  const view = new ChartView(session, waiting);
  view.listeners.push(
    watchResult(session, () => view.chart),
    watchTrials(session),
  );
  showExports(session, view);
  title.addEventListener("change", () => session.rename(title.value.trim()));
  caption.addEventListener("input", () => (session.caption = caption.value));
  run.addEventListener("click", toggle);
  discard.addEventListener("click", () => session.discard());
  view.host.addEventListener("click", ({ target }) => {
    const trial = target instanceof Element ? target.getAttribute("data-trial") : null;
    if (trial !== null) void app.track(openTrial(session, Number(trial)));
  });
  watchPrint();
  return {
    // The core of a worker was lost, not the document: it is opened again with the next trial.
    rebuild: () => {},
    rule: stateRule,
    link: {
      save: () => ({ document: session.document, view: session.view }),
      contents: "the experiment and the chart. Its trials run again where it is opened, many of them after a click",
      // What had begun to run begins again, and what was paused or waited does not.
      leave: () => ({
        document: session.document,
        view: session.view,
        run: ["running", "pausing", "done"].includes(session.phase),
      }),
      open: (/** @type {ExperimentState | null} */ state, signal, isLeft) => opener.openLinked(state, signal, isLeft),
    },
    openFile: ({ name, text }) => opener.openFile(name, text),
    openWorld: roomDoor(app, (world) => opener.openWorld(world)),
    keys: { " ": toggle },
  };

  function start() {
    void app.track(session.start(), "A trial could not be run.");
  }

  function toggle() {
    if (run.disabled) return;
    if (session.phase === "running") void app.track(session.pause());
    else {
      if (session.phase === "done") session.discard();
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
    for (const button of view.host.getElementsByTagName("button")) button.disabled = run.disabled;
    discard.disabled = !["running", "paused", "failed"].includes(phase) && session.uncertified === 0;
    progress.value = rows.count > 0 ? rows.done / rows.count : 0;
    byId("progress-text", HTMLElement).textContent = progressOf(session);
    if (change === "checked" && phase === "refused" && refusal) {
      app.notice.show(
        "The experiment is refused.",
        Object.assign(new Error(), refusal, { message: refusalText(refusal.message) }),
      );
      app.notice.element.scrollIntoView({ block: "nearest" });
    } else if (change === "checked") app.notice.hide();
    if (document.activeElement !== title) title.value = session.document.title ?? "";
    if (document.activeElement !== caption) caption.value = session.caption;
    app.write({ where: info ? `${grouped(rows.count)} trials${pool.most > 1 ? ` on ${pool.most} workers` : ""}` : "" });
    app.say(sentenceOf(session), { isBad: phase === "refused" || phase === "failed", isSilent: change === "rows" });
    if (change === "checked" || change === "view" || change === "document") showControls();
  }

  /** What is in the place of the chart before the first trial ends. @returns {HTMLElement[]} */
  function waiting() {
    const { phase, info } = session;
    if (!info) return [];
    if (phase !== "ready") return [make("p", { className: "hint" }, "The chart grows as trials end.")];
    const why = app.reducedMotion
      ? "With reduced motion trials do not start by themselves."
      : info.trialCount > opener.most
        ? `More than ${grouped(opener.most)} trials${opener.isFromLink ? " of a link" : ""} do not start by themselves.`
        : "No trial has run.";
    return [
      make("p", { className: "hint" }, why),
      make("button", { type: "button", onclick: toggle }, `Run ${counted(info.trialCount, "trial")}`),
    ];
  }

  /** The printed page is light, and has the table and the sentences instead of controls. */
  function watchPrint() {
    const folds = ["table-fold", "words-fold"].map((id) => byId(id, HTMLDetailsElement));
    /** @type {HTMLDetailsElement[]} */
    let opened = [];
    let isPrinted = false;
    // Pages are counted after `beforeprint`, and before the media change.
    const prepare = (/** @type {boolean} */ isPrint) => {
      if (isPrint === isPrinted) return;
      isPrinted = isPrint;
      if (isPrint) opened = folds.filter(({ open }) => !open);
      for (const fold of opened) fold.open = isPrint;
      byId("main", HTMLElement).style.colorScheme = isPrint ? "light" : "";
      void app.track(view.draw());
    };
    addEventListener("beforeprint", () => prepare(true));
    addEventListener("afterprint", () => prepare(false));
    matchMedia("print").addEventListener("change", ({ matches: isPrint }) => prepare(isPrint));
  }
});
