/**
 * The page of many trajectories: settings, transport, figures and numbers.
 *
 * For tests, beside what app.js says: `#stage` carries `data-status` ("running", "solved", "exhausted", or "refused"
 * while the settings are not valid), `data-accepted`, `data-tried`, `data-drawn` (trajectories on the canvas),
 * `data-last` ("accepted", "refused" or "none"), `data-begun` (another number for each experiment), and
 * `data-fingerprint`. Each frame leaves a measure "trajectories-frame".
 */
import { withSeed } from "../widgets/field.js";
import { trajectoryOptions } from "planarium/full";
import { openRoom } from "../app/room.js";
import { byId, grouped } from "../app/dom.js";
import { Figure } from "../draw/figure.js";
import { csvFile } from "../formats/csv.js";
import { showDownloads } from "../widgets/downloads.js";
import { button, press } from "../widgets/elements.js";
import { Options } from "../widgets/options.js";
import { Course } from "../widgets/course.js";
import { makeCharts } from "./charts.js";
import { Experiment, WINDOW, movingAverage } from "./experiment.js";
import { filmsOf } from "./films.js";
import { Particle } from "./particle.js";
import { Plane } from "./plane.js";
import { stateRule } from "./state.js";

/** @import { ParameterInfo, TrajectoryOptions } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Commands } from "./commands.js" */
/** @import { State } from "./state.js" */

/** Settings that are not folded away. */
const SHOWN = ["seed", "model", "count", "fastest", "greatest_turn_rate", "least_turn_rate"];
/** Tries of each call on the way to the end. */
const AT_ONCE = 5000;
const COLUMNS = ["x", "y", "theta", "v", "w", "duration", "tries", "milliseconds", "average"];

await openRoom("trajectories", (room, /** @type {Remote<Commands>} */ worker) => {
  const { app } = room;
  const stage = byId("stage", HTMLElement);
  const experiment = new Experiment(worker);
  const plane = new Plane(experiment);
  const figure = new Figure(app, stage, { id: "plane", kind: "workspace", caption: "Trajectories" }, plane);
  const drawCharts = makeCharts(experiment);
  const particle = new Particle(app, byId("single", HTMLElement));
  const table = /** @type {ParameterInfo[]} */ ([...withSeed([], "experiment"), ...trajectoryOptions()]);
  let options = form({});
  /** Whether the settings are not valid. */
  let isRefused = false;
  let frameStart = 0;
  let animationStart = 0;
  let wasMoving = false;

  const course = new Course(
    app,
    byId("course", HTMLElement),
    {
      name: "course",
      label: "Transport",
      unit: "tries",
      steps: [1, 10, 100],
      slowest: 1,
      fastest: 20_000,
      pace: 120,
      advance: (count) => experiment.advance(course.isFinishing ? Math.max(count, AT_ONCE) : count, showProgress),
      reset: () => void restart(),
      canFinish: true,
    },
    [stage],
  );
  const animate = button(
    "course-move",
    "Animate",
    () => {
      plane.moment = plane.moment === null ? 0 : null;
      animationStart = performance.now();
      press(animate, plane.moment !== null);
      figure.redraw();
    },
    { className: "quiet", ariaPressed: "false" },
  );
  course.bar.append(animate);
  app.onFrame((now) => {
    frameStart = performance.now();
    plane.now = now;
    if (plane.moment !== null) plane.moment = (Math.max(0, now - animationStart) / 1000) % plane.round;
    plane.isStill = app.reducedMotion || !course.isPlaying;
    const isMoving = plane.isMoving(now);
    if (isMoving || wasMoving) figure.redraw();
    wasMoving = isMoving;
    return isMoving;
  });
  app.onDraw(() => {
    stage.dataset.drawn = String(figure.sheet.rowsOf("growth"));
    drawCharts(!course.isPlaying && app.pending === 0);
    performance.measure("trajectories-frame", { start: frameStart });
  });

  showDownloads(
    app,
    [figure],
    {
      name: () => `trajectories-seed${experiment.options.seed ?? 0}-${experiment.accepted.length}`,
      title: () => "Trajectories that do not cross",
    },
    [
      {
        id: "csv",
        title: "Table",
        format: "CSV",
        meaning: `A row for each trajectory: its parameters, tries, time, and the mean time of the last ${WINDOW}.`,
        content: tableOf,
      },
    ],
    filmsOf(experiment, figure),
  );
  return {
    show,
    rebuild: restart,
    rule: stateRule,
    link: {
      save: () => ({ given: options.given, tried: experiment.result?.iterations ?? 0, one: particle.movement }),
      open,
      contents: "the settings, the seed and the number of tries",
    },
    reseed: async (seed) => {
      options = form({ ...options.given, seed });
      if (await restart()) course.setPlaying(true);
    },
  };

  /** The settings as a form. @param {Settings} given */
  function form(given) {
    return new Options(byId("settings", HTMLElement), table, given, () => void restart(), { first: SHOWN });
  }

  function showProgress() {
    figure.redraw();
    app.changed();
    if (!experiment.isRunning) app.announcer.say(sentence(""));
  }

  /** Starts an experiment with the settings of the form. @returns {Promise<boolean>} */
  async function restart() {
    const { settings } = options;
    course.pause();
    if (!settings) return refuse();
    isRefused = false;
    app.notice.hide();
    const isBegun = await room.attempt(
      async () => {
        await experiment.begin(/** @type {TrajectoryOptions} */ (settings));
        return true;
      },
      (pointer, message) => {
        const isKnown = options.refuse(pointer, message);
        refuse();
        return isKnown;
      },
    );
    if (!isBegun) return false;
    course.enable(true);
    animationStart = performance.now();
    app.changed();
    figure.redraw();
    return true;
  }

  /** The settings are not valid: the experiment stays on the page but stops. */
  function refuse() {
    experiment.begin.cancel();
    course.enable(false);
    isRefused = true;
    app.changed();
    return false;
  }

  /** @param {State | null} state */
  async function open(state) {
    // A link that cannot be read leaves the open experiment in place.
    if (!state && experiment.result) return;
    const { given, tried, one } = state ?? stateRule.defaults;
    options = form(given);
    const unknown = Object.keys(given).find((name) => !options.field(name));
    if (unknown) throw new Error(`There is no setting "${unknown}".`);
    particle.set(one);
    if (await restart()) {
      if (state || app.reducedMotion) await experiment.advance(state ? tried : Infinity, showProgress);
      else course.setPlaying(true);
      figure.redraw();
    } else if (state && isRefused) throw new Error("Its settings are not valid.");
  }

  /** Shows the numbers. */
  function show() {
    const { result, accepted, isLastRejected } = experiment;
    const { count = 1000, model, seed = 0 } = experiment.options;
    if (isRefused || result) stage.dataset.status = isRefused ? "refused" : result?.status;
    if (!result) return;
    const last = result.iterations === 0 ? "none" : isLastRejected ? "refused" : "accepted";
    Object.assign(stage.dataset, {
      begun: experiment.epoch,
      accepted: accepted.length,
      tried: result.iterations,
      last,
      fingerprint: result.fingerprint,
    });
    const [tries, milliseconds] = /** @type {const} */ (["tries", "milliseconds"]).map(
      (key) => sumOfLast(key) / Math.min(WINDOW, accepted.length),
    );
    const microseconds = 1000 * milliseconds;
    app.write({
      "fact-accepted": `${grouped(accepted.length)} of ${grouped(count)}`,
      "fact-tried": grouped(result.iterations),
      "fact-tries": accepted.length === 0 ? "\u2013" : tries.toFixed(1),
      "fact-time":
        accepted.length === 0 ? "\u2013" : microseconds === 0 ? "too short" : `${microseconds.toFixed(0)} \u00b5s`,
      "fact-pairs": grouped(result.pairs),
      "fact-fingerprint": course.isPlaying ? "\u2013" : result.fingerprint,
      where: `${model === "spiral" ? "Spirals" : "Arcs"} \u00b7 seed ${seed}`,
    });
    app.say(sentence(last), { isSilent: true });
    figure.describe(`${accepted.length} trajectories, no two of which cross, after ${result.iterations} tries.`);
  }

  /** @param {string} last  the outcome of the last try */
  function sentence(last) {
    const { result, rejected, accepted } = experiment;
    if (isRefused) return "These settings are not valid; see the message in the panel.";
    const total = grouped(result?.iterations ?? 0);
    if (result?.status === "solved") {
      const found = `${grouped(accepted.length)} trajectories, no two of which cross, after ${total} tries.`;
      return `${found} The last ${Math.min(WINDOW, accepted.length)} took ${grouped(sumOfLast("tries"))} tries.`;
    }
    if (result?.status === "exhausted")
      return `Stopped after ${total} tries with ${grouped(accepted.length)} accepted: hardly anything fits between them.`;
    if (!course.isPlaying && last === "refused" && rejected)
      return `The last trajectory was rejected: it crosses number ${grouped(rejected.other + 1)}.`;
    return "Rejection sampling: random trajectories are added one by one, and each one that crosses an earlier one is rejected.";
  }

  /** The sum over the last accepted trajectories. @param {"tries" | "milliseconds"} key */
  function sumOfLast(key) {
    return experiment.accepted.slice(-WINDOW).reduce((sum, one) => sum + one[key], 0);
  }

  function tableOf() {
    const { accepted } = experiment;
    const average = new Map(movingAverage(accepted.map(({ milliseconds }) => milliseconds)));
    return csvFile(
      COLUMNS,
      accepted.map(({ row, tries, milliseconds }, i) => [...row, tries, milliseconds, average.get(i + 1) ?? null]),
    );
  }
});
