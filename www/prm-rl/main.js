/**
 * The page of learned edges (PRM-RL): it makes the session, the figures, the panels and the lesson.
 *
 * For tests, beside what app.js says: `body` carries `data-part`; `#stage` carries `data-status` of the plan ("none",
 * "running", "solved", "exhausted", or "refused" while start or goal is in collision), `data-way`, `data-edges` of the
 * path, `data-fingerprint` of the plan, `data-reached` of `data-drives`, `data-time`, `data-start`, `data-goal`,
 * `data-policy` ("shipped", "trained", "file"), `data-edge` (the step that is marked, from 0); of the training
 * `data-training` ("none", "beginning", "ready", "running", "over", "refused"), `data-generation` and `data-trained`,
 * its fingerprint; of the comparison `data-compared` ("none", "running", "paused", "over") and `data-executions`.
 */
import { byId, grouped } from "../app/dom.js";
import { json, save } from "../app/files.js";
import { comparer } from "../app/once.js";
import { openRoom } from "../app/room.js";
import { isAbort } from "../app/work.js";
import { Figure } from "../draw/figure.js";
import { parsed } from "../formats/json.js";
import { Course } from "../widgets/course.js";
import { showDownloads } from "../widgets/downloads.js";
import { button, press } from "../widgets/elements.js";
import { num } from "../widgets/format.js";
import { makeCharts, makeSwingChart, trainingCsv } from "./charts.js";
import { Demonstrations } from "./demonstrations.js";
import { filmsOf } from "./films.js";
import { Floor } from "./floor.js";
import { watchHandles } from "./handles.js";
import { Lesson } from "./lesson.js";
import { showPanel } from "./panel.js";
import { FIRST, NavigationSession, WAYS, countsOf, swingAt } from "./session.js";
import cargo from "./policy-cargo.json" with { type: "json" };
import wheeled from "./policy.json" with { type: "json" };
import { openState, stateOf, stateRule } from "./state.js";
import { comparedCsv, showCompared, showDriven, showEdges } from "./tables.js";
import { WAY_WORDS, sentenceOf } from "./words.js";

/** @import { PolicyDocument } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands } from "./commands.js" */
/** @import { Part } from "./session.js" */
/** @import { State } from "./state.js" */

/** @type {[Part, string][]} */
const PARTS = [
  ["train", "Train"],
  ["plan", "Plan"],
  ["compare", "Compare"],
];

await openRoom("prm-rl", (room, /** @type {Remote<Commands>} */ worker) => {
  const { app } = room;
  const stage = byId("stage", HTMLElement);
  const session = new NavigationSession(app, worker, {
    differential_drive: /** @type {PolicyDocument} */ (wheeled),
    cargo: /** @type {PolicyDocument} */ (cargo),
  });
  const { training, comparison } = session;
  const floor = new Floor(session);
  const demonstrations = new Demonstrations(session);
  const figures = {
    floor: new Figure(app, stage, { id: "floor", kind: "workspace", caption: "Floor" }, floor),
    demonstrations: new Figure(
      app,
      stage,
      {
        id: "demonstrations",
        kind: "workspace",
        caption: "Twelve short tasks",
        note: "the same in every generation, driven by the policy so far",
      },
      demonstrations,
    ),
  };
  const all = Object.values(figures);
  const drawCharts = makeCharts(session);
  const drawSwing = makeSwingChart(session);
  const course = new Course(app, byId("course", HTMLElement), {
    name: "course",
    label: "Transport of the drives",
    unit: "seconds",
    steps: [0.1, 1],
    slowest: 0.25,
    fastest: 25,
    pace: 4,
    isWhole: false,
    axis: {
      id: "time",
      label: "Time of the drives",
      end: () => session.end,
      time: () => session.time,
      seek: (time) => session.setTime(time),
    },
    paceText: (pace) => `${pace.toFixed(1)}\u00d7`,
  });
  const lesson = new Lesson(app, session, play);

  byId("parts", HTMLElement).append(
    ...PARTS.map(([part, title]) => button(`part-${part}`, title, () => session.setPart(part))),
  );
  byId("ways", HTMLElement).append(
    ...WAYS.map((way) =>
      button(`way-${way}`, WAY_WORDS[way].title, () => {
        course.pause();
        session.setWay(way);
      }),
    ),
  );
  const { refuseComparison } = showPanel(session, {
    open: (source, onRefused) => {
      app.notice.hide();
      void room.attempt(() => session.open(source), onRefused);
    },
    plan: (onRefused) => void room.attempt(() => session.plan(), onRefused),
    train: (onRefused) => void room.attempt(() => training.begin(), onRefused),
    compare: () => comparison.clear(),
  });
  watchHandles(session, stage, figures, (ends) => {
    course.pause();
    session.setEnds(ends);
  });
  const click = (/** @type {string} */ id, /** @type {() => unknown} */ act) =>
    byId(id, HTMLButtonElement).addEventListener("click", act);
  click("plan", () => room.attempt(() => session.plan()));
  click("drive", () => room.attempt(drive));
  click("train", toggleTraining);
  click("train-again", () => room.attempt(() => training.begin()));
  click("use-trained", () => {
    const { policy } = training;
    if (policy) app.guard(() => session.usePolicy(policy, "trained"));
  });
  click("compare", toggleComparison);
  click("compare-again", () => comparison.clear());
  click("ship", () => app.guard(() => session.usePolicy(session.shipped, "shipped")));
  click("save-policy", () => save(json(session.policy), `${session.policy.name}.json`));
  const names = {
    name: () => `prm-rl-${session.document?.name ?? ""}`,
    title: () => session.document?.title ?? session.document?.name ?? "",
  };
  showDownloads(
    app,
    all,
    names,
    [
      {
        id: "task",
        title: "Navigation task",
        format: "JSON",
        meaning: "The floor, the robot, and the query from start to goal, as the command line reads them.",
        content: () => json(session.asked),
      },
      {
        id: "result",
        title: "Plan",
        format: "JSON",
        meaning: "The path, and the rollouts along its edges.",
        content: () => json({ ...session.run.result, rollouts: session.run.rollouts }),
        name: () => `${names.name()}-${session.way}`,
      },
      {
        id: "generations",
        title: "Generations",
        format: "CSV",
        meaning: "Mean and best return, and the share of tasks solved.",
        content: () => trainingCsv(session),
        name: () => "prm-rl-training",
      },
      {
        id: "comparison",
        title: "Comparison",
        format: "CSV",
        meaning: "A row for each drive.",
        content: () => comparedCsv(session),
        name: () => `${names.name()}-comparison`,
      },
      {
        id: "summary",
        title: "Comparison",
        format: "JSON",
        meaning: "The statistics of the methods.",
        content: () => json({ summary: comparison.summary, queries: comparison.queries }),
        name: () => `${names.name()}-comparison`,
      },
    ],
    filmsOf(session, figures.floor),
  );

  let began = 0;
  app.onFrame((now) => {
    const { part } = session;
    const { length } = session.training.demonstrations;
    if (part !== "train" || length === 0 || app.reducedMotion || training.status !== "running") {
      if (demonstrations.time !== Infinity) {
        demonstrations.time = Infinity;
        figures.demonstrations.redraw();
      }
      began = now;
      return false;
    }
    // Drives of the policy so far are played over and over.
    demonstrations.time = ((PLAYED * Math.max(0, now - began)) / 1000) % demonstrations.round;
    figures.demonstrations.redraw();
    return true;
  });
  app.onDraw(() => {
    drawCharts();
    drawSwing();
  });
  const differs = comparer();
  return {
    show,
    rebuild: () => {
      session.task = null;
      session.open(session.source, { start: session.start, goal: session.goal });
      Object.assign(training, { tasks: [], floors: [], demonstrations: [], status: "none" });
    },
    rule: stateRule,
    link: {
      save: () => stateOf(session, lesson),
      spare: "document",
      contents: (isWhole) =>
        `${isWhole ? "the floor, start and goal, the settings, and what was trained, planned and driven" : "the settings, but not your floor: it is too long"}${session.origin === "file" ? "; your policy is too long and is not included" : ""}`,
      open: async (/** @type {State | null} */ state, signal) => {
        course.pause();
        const isFirst = !session.document;
        if (state) {
          try {
            return await openState(session, lesson, state, signal);
          } catch (error) {
            if (isFirst && !isAbort(error)) session.forget();
            throw error;
          }
        }
        if (!isFirst) return;
        session.open(FIRST);
        const begun = drive();
        if (app.reducedMotion) await begun;
        else void app.track(begun);
      },
    },
    openFile: ({ text }) => {
      if (/"format"\s*:\s*"planarium-policy-/.test(text))
        session.usePolicy(/** @type {PolicyDocument} */ (parsed(text)), "file");
      else session.open({ document: text });
    },
    reseed: (seed) => {
      const { source } = session;
      const { kind, options } = "kind" in source ? source : { ...FIRST, options: {} };
      app.notice.hide();
      void room.attempt(() => session.open({ kind, options: { ...options, seed } }));
    },
    keys: {
      " ": () => {
        if (session.part === "train") toggleTraining();
        else if (session.part === "compare") toggleComparison();
        else course.toggle();
      },
      r: () => course.restart(),
      ".": () => course.step(0.1),
    },
  };

  /** Plans unless that is done, drives, and plays it. */
  async function drive() {
    course.pause();
    if (await session.drive()) play();
  }

  /** Plays the drives from their start, or shows them whole. */
  function play() {
    session.setTime(app.reducedMotion ? Infinity : 0);
    course.setPlaying(!app.reducedMotion);
  }

  function toggleTraining() {
    if (training.status === "running") training.pause();
    else
      void room.attempt(async () => {
        if (training.status === "none") await training.begin();
        await training.run();
      });
  }

  function toggleComparison() {
    if (comparison.status === "running") comparison.pause();
    else void room.attempt(() => comparison.run(), refuseComparison);
  }

  /** Shows what belongs to a part. @param {Part} part @param {boolean} hasLoad */
  function showPart(part, hasLoad) {
    document.body.dataset.part = part;
    for (const element of document.querySelectorAll("main [data-part], .with-load")) {
      if (!(element instanceof HTMLElement)) continue;
      const parts = element.dataset.part?.split(" ") ?? [part];
      element.hidden = !parts.includes(part) || (element.classList.contains("with-load") && !hasLoad);
    }
    figures.demonstrations.element.hidden = part !== "train";
    figures.floor.element.hidden = part === "train";
    for (const [one] of PARTS) press(byId(`part-${one}`, HTMLElement), one === part);
  }

  function show() {
    const { part, source, document: task, run, runs, way, time, start, goal, refusal, policy, origin, edge } = session;
    if (!task) return;
    if (differs("training", part, source) && part === "train" && training.status === "none")
      void room.attempt(() => training.begin());
    if (differs("part", part, session.hasLoad)) showPart(part, session.hasLoad);
    for (const one of WAYS) press(byId(`way-${one}`, HTMLElement), one === way);
    for (const figure of all) figure.redraw();
    const counts = countsOf(run.drives);
    Object.assign(stage.dataset, {
      status: refusal ? "refused" : run.status,
      way,
      edges: Math.max(0, run.path.length - 1),
      fingerprint: run.result?.fingerprint ?? "",
      reached: counts.reached,
      drives: run.drives.length,
      time: time.toFixed(3),
      start: start.join(),
      goal: goal.join(),
      policy: origin,
      edge: edge ?? "",
      training: training.status,
      generation: training.generation,
      trained: training.fingerprint,
      compared: comparison.status,
      executions: comparison.executions.length,
    });
    showControls();
    const shownRuns = WAYS.flatMap((one) => [runs[one], runs[one].status, runs[one].rollouts, runs[one].drives]);
    if (differs("driven", way, session.hasLoad, ...shownRuns)) showDriven(session);
    if (differs("edges", part, run, run.rollouts)) showEdges(session);
    if (differs("compared", comparison.summary, session.hasLoad)) showCompared(session);
    const last = training.history.at(-1);
    app.write({
      where: `${task.title ?? task.name} \u00b7 ${policy.name}`,
      "way-does": WAY_WORDS[way].does,
      "policy-name": policy.name,
      "policy-about": `${{ shipped: "Shipped with this page", trained: "Trained on this page", file: "From a file" }[origin]}: a perceptron with ${grouped(policy.hidden)} hidden units and ${grouped(policy.weights.length)} weights, for ${policy.sensor.rays} rays.`,
      "fact-generation": `${grouped(training.generation)} of ${grouped(training.generations)}`,
      "fact-best": last ? num(last.best, 3) : "\u2013",
      "fact-mean": last ? num(last.mean, 3) : "\u2013",
      "fact-solved": last ? `${num(100 * last.reached, 0)} %` : "\u2013",
      "fact-workers": grouped(training.pool.workers.length),
      "fact-trained": training.fingerprint || "\u2013",
      "fact-time": `${num(time, 1)} s`,
      "fact-swing": swingText(session),
      "fact-vertices": grouped(run.vertices.length / 2),
      "fact-edges": grouped(run.edges.length / 2),
      "fact-checked": way === "prm-rl" ? grouped((run.edges.length + run.refused.length) / 2) : "none",
      "fact-length": run.result && run.path.length > 0 ? `${num(run.result.length ?? 0, 1)} m` : "\u2013",
      "fact-planned": run.result?.fingerprint ?? "\u2013",
      "compare-text":
        comparison.count === 0 ? "" : `${grouped(comparison.executions.length)} of ${grouped(comparison.count)} drives`,
    });
    const text = sentenceOf(session);
    app.say(text, {
      isBad: part === "plan" && (refusal !== null || run.status === "exhausted"),
      // The numbers of what grows or is trained are not announced.
      isSilent: !differs(
        "news",
        part,
        task,
        policy,
        refusal,
        way,
        run,
        run.status,
        run.drives,
        training.status,
        comparison.status,
      ),
    });
    figures.floor.describe(`${task.title ?? task.name}. ${text}`);
    figures.demonstrations.describe(`Twelve drives of the policy in training. ${text}`);
  }

  /** Enables and names what can be done now. */
  function showControls() {
    const { run, refusal, origin } = session;
    const enable = (/** @type {string} */ id, /** @type {boolean} */ isReady) => {
      byId(id, HTMLButtonElement).disabled = !isReady;
    };
    enable("plan", !refusal && run.status !== "running" && session.way !== "policy");
    enable("drive", !refusal && run.status !== "running" && run.status !== "exhausted");
    const isTraining = training.status === "running";
    enable("train", !["over", "refused", "beginning"].includes(training.status));
    byId("train", HTMLElement).textContent = isTraining ? "Pause" : training.generation > 0 ? "Go on" : "Train";
    enable("train-again", training.generation > 0);
    enable("use-trained", training.generation > 0);
    enable("ship", origin !== "shipped");
    enable("save-policy", true);
    const isComparing = comparison.status === "running";
    enable("compare", comparison.status !== "over");
    byId("compare", HTMLElement).textContent = isComparing ? "Pause" : comparison.status === "paused" ? "Go on" : "Run";
    enable("compare-again", comparison.status !== "none" && !isComparing);
    byId("train-progress", HTMLProgressElement).value =
      training.generations > 0 ? training.generation / training.generations : 0;
    byId("compare-progress", HTMLProgressElement).value =
      comparison.count > 0 ? comparison.executions.length / comparison.count : 0;
    byId("export-result", HTMLButtonElement).disabled = !run.result;
    for (const id of ["export-comparison", "export-summary"])
      byId(id, HTMLButtonElement).disabled = comparison.executions.length === 0;
    byId("export-generations", HTMLButtonElement).disabled = training.history.length === 0;
  }
});

/** How far the load of the drive with the rays is displaced, and may be. @param {NavigationSession} session */
function swingText({ document, run, selected, time }) {
  if (document?.robot.type !== "cargo") return "\u2013";
  const drive = run.drives[selected];
  const [x, y] = drive ? swingAt(drive, time, document.robot.time_step ?? 0.2) : [0, 0];
  return `${num(Math.hypot(x, y), 2)} of ${num(document.robot.swing_limit, 2)} m`;
}

/** Seconds of the demonstrations in one. */
const PLAYED = 4;
