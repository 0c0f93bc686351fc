/**
 * The page of several robots: it makes the session, the figure, the list of robots and the panels.
 *
 * For tests, beside what app.js says: `#stage` carries `data-status` ("none", "running", "solved", "exhausted"),
 * `data-planner`, `data-robots`, `data-planned`, `data-order` and `data-blocked` (robots from 1), `data-plans` (plans
 * begun), `data-vertices`, `data-time`, `data-end`, `data-straight`, `data-waiting` and `data-touching` (robots from 1,
 * at the time shown); once a plan has ended `data-fingerprint`, and `data-verified` once it has been verified.
 */
import { App } from "../app/app.js";
import { byId, counted, grouped, make } from "../app/dom.js";
import { watchFiles } from "../app/drop.js";
import { json } from "../app/files.js";
import { useLink } from "../app/link.js";
import { watchArrows } from "../draw/drag.js";
import { Figure } from "../draw/figure.js";
import { showDownloads } from "../widgets/downloads.js";
import { button } from "../widgets/elements.js";
import { num } from "../widgets/format.js";
import { Transport } from "../widgets/transport.js";
import { showConflicts } from "./conflicts.js";
import { filmsOf } from "./films.js";
import { Floor } from "./floor.js";
import { showPanel } from "./panel.js";
import { RobotList } from "./robot-list.js";
import { SCENES } from "./scenes.js";
import { DEFAULT, FleetSession, noOptions } from "./session.js";
import { openState, stateOf, stateRule } from "./state.js";
import { nameOf, sentenceOf } from "./words.js";

/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands } from "./commands.js" */
/** @import { Refusal } from "./panel.js" */
/** @import { Change, Source } from "./session.js" */
/** @import { State } from "./state.js" */

/** Seconds of an arrow key. */
const STEP = 0.1;

const app = new App();

await app.open("fleet", async (/** @type {Remote<Commands>} */ worker) => {
  const stage = byId("stage", HTMLElement);
  const session = new FleetSession(app, worker);
  const floor = new Floor(session);
  const figure = new Figure(app, stage, { id: "floor", kind: "workspace", caption: "Floor" }, floor);
  stage.append(byId("offer", HTMLElement));
  const slider = make("input", {
    type: "range",
    id: "time",
    className: "timeline",
    min: "0",
    max: "1",
    step: "any",
    value: "0",
    ariaLabel: "Time",
  });
  slider.addEventListener("input", () => scrub(Number(slider.value)));
  const transport = new Transport(
    app,
    byId("course", HTMLElement),
    {
      name: "course",
      label: "Transport",
      unit: "seconds",
      steps: [0.1, 1],
      slowest: 0.1,
      fastest: 20,
      pace: 1.5,
      isWhole: false,
      advance: (seconds) => {
        session.setTime(session.time + seconds);
        return session.time < session.end;
      },
      reset: () => session.setTime(0),
      paceText: (pace) => `${pace.toFixed(1)}\u00d7`,
    },
    [stage],
  );
  transport.bar.prepend(slider);
  // From its end it starts again.
  const rewind = () => {
    if (transport.isPlaying && session.time >= session.end) session.setTime(0);
  };
  transport.play.addEventListener("click", rewind);
  stage.addEventListener("keydown", ({ key }) => {
    if (key === " ") rewind();
  });
  watchArrows(stage, (coordinate, direction, factor) => {
    if (coordinate !== 0 || session.end === 0) return false;
    scrub(session.time + direction * factor * STEP);
    return true;
  });
  figure.canvas.addEventListener("click", ({ offsetX, offsetY }) =>
    session.select(floor.robotAt(offsetX, offsetY, 16)),
  );

  const list = new RobotList(session, floor, { scrub, reorder: (order) => void attempt(session.reorder(order)) });
  showPanel(session, {
    choose: (entry) => {
      // A ready fleet is planned for as its text says.
      Object.assign(session, { algorithm: DEFAULT, given: noOptions() });
      load(entry);
    },
    load,
    plan: (onRefused) => void attempt(session.plan(false), onRefused).then(playOnce),
  });
  showConflicts(session, setStraight);
  const roadmap = byId("roadmap", HTMLInputElement);
  roadmap.addEventListener("change", () => {
    session.hasRoadmap = roadmap.checked;
    figure.redraw(["ground"]);
  });
  watchFiles(app, (name, bytes) => {
    app.notice.hide();
    void app
      .track(session.load({ name, document: new TextDecoder().decode(bytes) }), `${name} could not be opened.`)
      .then(playOnce);
  });
  const names = { name: () => `fleet-${session.document?.name ?? ""}`, title: () => session.title };
  showDownloads(
    app,
    [figure],
    names,
    [
      {
        id: "document",
        title: "Fleet",
        format: "JSON",
        meaning: "The world and the robots, as the command line reads them.",
        content: () => json(session.document ?? {}),
      },
      {
        id: "result",
        title: "Plan",
        format: "JSON",
        meaning: "The result: the trajectory of every robot.",
        content: () => json(session.run.result ?? {}),
        name: () => `${names.name()}-${session.algorithm}`,
      },
    ],
    filmsOf(session, figure),
  );
  const exportResult = byId("export-result", HTMLButtonElement);

  session.onChange(show);
  app.onTheme(recolour);
  app.rebuild = () => void app.track(session.load(session.source, { order: session.order, isQuick: true }));
  await useLink(app, stateRule, {
    save: () => stateOf(session),
    contents: "the fleet, the planner, the order of priorities and the time",
    open: async (/** @type {State | null} */ state) => {
      transport.pause();
      if (state) await openState(session, state);
      else if (session.run.status === "none") {
        const begun = attempt(session.load(session.document ? session.source : SCENES[0]));
        if (app.reducedMotion) await begun;
        else void begun.then(playOnce);
      }
    },
  });

  /**
   * Awaits a plan; what is refused is said beside its field, or above the figure.
   * @param {Promise<boolean>} promise
   * @param {Refusal} [onRefused]
   */
  function attempt(promise, onRefused = () => false) {
    return app.track(
      promise.catch((error) => {
        if (error.code === "internal" || !onRefused(error.pointer ?? "", error.message)) throw error;
        return false;
      }),
    );
  }

  /** @param {Source} source @param {Refusal} [onRefused] */
  function load(source, onRefused) {
    app.notice.hide();
    void attempt(session.load(source), onRefused).then(playOnce);
  }

  /** Plays a plan that has just been found, unless less motion is wanted. @param {boolean | undefined} isDone */
  function playOnce(isDone) {
    if (isDone && session.end > 0 && !session.isStraight && session.run.status === "solved" && !app.reducedMotion)
      transport.setPlaying(true);
  }

  /** @param {number} time */
  function scrub(time) {
    transport.pause();
    session.setTime(time);
  }

  /** @param {boolean} isStraight @param {number} [time] */
  function setStraight(isStraight, time) {
    transport.pause();
    session.setStraight(isStraight, time);
    if (isStraight && time === undefined && !app.reducedMotion) transport.setPlaying(true);
  }

  function recolour() {
    floor.recolour(app.look.palette);
    list.colour();
  }

  /** @param {Change} change */
  function show(change) {
    const { run, time, end, isStraight, shown, touching, robots, document } = session;
    if (!document) return;
    const isGround = change === "fleet" || change === "plan" || change === "shown";
    figure.redraw(isGround ? undefined : ["top"]);
    list.show(change);
    if (change === "fleet") recolour();
    if (change === "fleet" || change === "plan") offer();
    if (change === "plan" && run.status === "running") transport.pause();
    const isReady = end > 0 && (isStraight || run.status !== "running");
    transport.enable(isReady);
    Object.assign(slider, { disabled: !isReady, max: String(end || 1), value: String(time) });
    slider.setAttribute("aria-valuetext", `${num(time, 1)} of ${num(end, 1)} seconds`);
    const waiting = shown.flatMap((way, i) => (way && time < end && way.isWaiting(time) ? [i + 1] : []));
    const { result, verification } = run;
    Object.assign(stage.dataset, {
      status: run.status,
      planner: session.algorithm,
      robots: robots.length,
      planned: run.planned,
      order: numbers(run.order),
      blocked: numbers(run.blocked),
      plans: session.plans,
      vertices: run.roadmaps.reduce((sum, { vertices }) => sum + vertices.length / 3, 0),
      time: time.toFixed(3),
      end: end.toFixed(3),
      straight: isStraight,
      waiting: waiting.join(),
      touching: [...new Set(touching.flatMap((one) => one.robots))].map((i) => i + 1).join(),
      fingerprint: result?.fingerprint ?? "",
      verified: verification ? verification.valid : "",
    });
    exportResult.disabled = !result;
    const isSolved = run.status === "solved" && result !== null;
    const waits = shown.reduce((sum, way) => sum + (way?.waits ?? 0), 0);
    const sum = shown.reduce((all, way) => all + (way?.arrival ?? 0), 0);
    app.write({
      where: `${session.title} \u00b7 ${counted(robots.length, "robot")}`,
      "fact-time": `${num(time, 1)} s`,
      "fact-makespan": isSolved || isStraight ? `${num(end, 2)} s` : "\u2013",
      "fact-sum": isSolved || isStraight ? `${num(sum, 1)} s` : "\u2013",
      "fact-waits": isSolved || isStraight ? `${num(waits, 1)} s` : "\u2013",
      "fact-waiting": waiting.length > 6 ? grouped(waiting.length) : waiting.join(", ") || "none",
      "fact-iterations": grouped(run.iterations),
      "fact-fingerprint": result?.fingerprint ?? "\u2013",
      "fact-verified": isStraight
        ? "not a plan"
        : !verification
          ? "\u2013"
          : verification.valid
            ? "\u2713 no conflict"
            : "\u2717 refused",
    });
    byId("fact-verified", HTMLElement).dataset.valid = String(isStraight ? "" : (verification?.valid ?? ""));
    const text = sentenceOf(session);
    app.say(text, {
      isBad: !isStraight && run.status === "exhausted",
      isSilent: change === "growth" || change === "time",
    });
    figure.describe(`${counted(robots.length, "robot")} at ${num(time, 1)} s. ${text}`);
  }

  /** Offers what may help where an order fails. */
  function offer() {
    const {
      run: {
        status,
        blocked: [robot, ...others],
        order,
      },
      canCompose,
      isOrdered,
    } = session;
    const isFailed = status === "exhausted";
    const buttons = [];
    if (isFailed && isOrdered && session.algorithm !== DEFAULT)
      buttons.push(
        button("try-default", "Let the planner decide", () => void attempt(session.reorder(null)).then(playOnce), {
          className: "primary",
        }),
      );
    if (isFailed && isOrdered && canCompose)
      buttons.push(
        button(
          "try-composite",
          "Try the composite planner",
          () => void attempt(session.use("composite")).then(playOnce),
        ),
      );
    if (isFailed && isOrdered && others.length > 0 && order[0] !== robot) {
      buttons.push(
        button(
          "plan-first",
          `Plan ${nameOf(session, robot)} first`,
          () => void attempt(session.reorder([robot, ...order.filter((i) => i !== robot)])).then(playOnce),
        ),
      );
    }
    byId("offer", HTMLElement).replaceChildren(...buttons);
  }
});

/** Robots as numbers from 1. @param {number[]} robots */
function numbers(robots) {
  return robots.map((i) => i + 1).join();
}
