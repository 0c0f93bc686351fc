/**
 * The page of several robots: it makes the session, the figure, the list of robots and the panels.
 *
 * For tests, beside what app.js says: `#stage` carries `data-status` ("none", "running", "solved", "exhausted"),
 * `data-planner`, `data-robots`, `data-planned`, `data-order` and `data-blocked` (robots from 1), `data-plans` (plans
 * begun), `data-vertices`, `data-time`, `data-end`, `data-straight`, `data-waiting` and `data-touching` (robots from 1,
 * at the time shown); once a plan has ended `data-fingerprint`, and `data-verified` once it has been verified.
 */
import { byId, counted, grouped } from "../app/dom.js";
import { json } from "../app/files.js";
import { comparer } from "../app/once.js";
import { openRoom } from "../app/room.js";
import { roomDoor } from "../worlds/room-door.js";
import { watchArrows } from "../draw/drag.js";
import { Figure } from "../draw/figure.js";
import { Course } from "../widgets/course.js";
import { showDownloads } from "../widgets/downloads.js";
import { button } from "../widgets/elements.js";
import { num } from "../widgets/format.js";
import { showConflicts } from "./conflicts.js";
import { filmsOf } from "./films.js";
import { Floor } from "./floor.js";
import { showPanel } from "./panel.js";
import { RobotList } from "./robot-list.js";
import { SCENES } from "./scenes.js";
import { DEFAULT, FleetSession, noOptions } from "./session.js";
import { openState, stateOf, stateRule } from "./state.js";
import { nameOf, sentenceOf } from "./words.js";
import { fleetOf } from "./worlds.js";

/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands } from "./commands.js" */
/** @import { Refusal } from "../app/room.js" */
/** @import { Source } from "./session.js" */
/** @import { State } from "./state.js" */

/** Seconds of an arrow key. */
const STEP = 0.1;

await openRoom("fleet", (room, /** @type {Remote<Commands>} */ worker) => {
  const { app } = room;
  const stage = byId("stage", HTMLElement);
  const session = new FleetSession(app, worker);
  const floor = new Floor(session);
  const figure = new Figure(app, stage, { id: "floor", kind: "workspace", caption: "Floor" }, floor);
  stage.append(byId("offer", HTMLElement));
  const course = new Course(
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
      axis: {
        id: "time",
        label: "Time",
        end: () => session.end,
        time: () => session.time,
        seek: (time) => session.setTime(time),
        isReady: () => session.isStraight || session.run.status !== "running",
      },
      paceText: (pace) => `${pace.toFixed(1)}\u00d7`,
    },
    [stage],
  );
  watchArrows(stage, (coordinate, direction, factor) => {
    if (coordinate !== 0 || session.end === 0) return false;
    course.seek(session.time + direction * factor * STEP);
    return true;
  });
  figure.canvas.addEventListener("click", ({ offsetX, offsetY }) =>
    session.select(floor.robotAt(offsetX, offsetY, 16)),
  );

  const list = new RobotList(session, floor, {
    scrub: (time) => course.seek(time),
    reorder: (order) => void room.attempt(() => session.reorder(order)),
  });
  showPanel(session, {
    choose: (entry) => {
      // A ready fleet is planned for as its text says.
      Object.assign(session, { algorithm: DEFAULT, given: noOptions() });
      load(entry);
    },
    load,
    plan: (onRefused) => playing(() => session.plan(false), onRefused),
  });
  showConflicts(session, setStraight);
  const roadmap = byId("roadmap", HTMLInputElement);
  roadmap.addEventListener("change", () => {
    session.hasRoadmap = roadmap.checked;
    app.requestFrame();
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
  const differs = comparer();

  app.onTheme(recolour);
  return {
    show,
    rebuild: () => void app.track(session.load(session.source, { order: session.order, isQuick: true })),
    rule: stateRule,
    link: {
      save: () => stateOf(session),
      contents: "the fleet, the planner, the order of priorities and the time",
      open: async (/** @type {State | null} */ state, signal) => {
        course.pause();
        if (state) await openState(session, state, signal);
        else if (session.run.status === "none") {
          const begun = room.attempt(() => session.load(session.document ? session.source : SCENES[0]));
          if (app.reducedMotion) await begun;
          else void begun.then(playOnce);
        }
      },
    },
    openFile: async ({ name, text }) => playOnce(await session.load({ name, document: text })),
    openWorld: roomDoor(app, async (opened) => {
      const document = await fleetOf(opened);
      playOnce(await session.load({ name: document.name, document }));
    }),
    reseed: (seed) => {
      const { source } = session;
      if ("kind" in source) load({ kind: source.kind, options: { ...source.options, seed } });
    },
  };

  /** Plays a plan once it has been found. @param {() => Promise<boolean>} act @param {Refusal} [onRefused] */
  function playing(act, onRefused) {
    void room.attempt(act, onRefused).then(playOnce);
  }

  /** @param {Source} source @param {Refusal} [onRefused] */
  function load(source, onRefused) {
    app.notice.hide();
    room.opening.cancel();
    playing(() => session.load(source), onRefused);
  }

  /** Plays a plan that has just been found, unless less motion is wanted. @param {boolean | undefined} isDone */
  function playOnce(isDone) {
    if (isDone && session.end > 0 && !session.isStraight && session.run.status === "solved" && !app.reducedMotion)
      course.setPlaying(true);
  }

  /** @param {boolean} isStraight @param {number} [time] */
  function setStraight(isStraight, time) {
    course.pause();
    session.setStraight(isStraight, time);
    if (isStraight && time === undefined && !app.reducedMotion) course.setPlaying(true);
  }

  function recolour() {
    floor.recolour(app.look.palette);
    list.colour();
  }

  function show() {
    const { run, time, end, isStraight, shown, touching, robots, document } = session;
    if (!document) return;
    figure.redraw();
    list.show();
    if (differs("colours", document)) recolour();
    if (differs("offers", run, run.status, session.algorithm)) byId("offer", HTMLElement).replaceChildren(...offers());
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
      // The numbers of a plan that grows, or of a moment, are not announced.
      isSilent: !differs("news", document, run, run.status, isStraight),
    });
    figure.describe(`${counted(robots.length, "robot")} at ${num(time, 1)} s. ${text}`);
  }

  /** Buttons that may help where an order fails. */
  function offers() {
    const { canCompose, isOrdered } = session;
    const { status, order } = session.run;
    const [robot, ...others] = session.run.blocked;
    if (status !== "exhausted" || !isOrdered) return [];
    const offer = (
      /** @type {string} */ id,
      /** @type {string} */ text,
      /** @type {() => Promise<boolean>} */ act,
      className = "",
    ) => button(id, text, () => playing(act), { className });
    return [
      ...(session.algorithm !== DEFAULT
        ? [offer("try-default", "Let the planner decide", () => session.reorder(null), "primary")]
        : []),
      ...(canCompose ? [offer("try-composite", "Try the composite planner", () => session.use("composite"))] : []),
      ...(others.length > 0 && order[0] !== robot
        ? [
            offer("plan-first", `Plan ${nameOf(session, robot)} first`, () =>
              session.reorder([robot, ...order.filter((i) => i !== robot)]),
            ),
          ]
        : []),
    ];
  }
});

/** Robots as numbers from 1. @param {number[]} robots */
function numbers(robots) {
  return robots.map((i) => i + 1).join();
}
