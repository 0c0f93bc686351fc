/**
 * The page of many trajectories: settings, transport, figures and numbers.
 *
 * For tests, beside what app.js says: `#stage` carries `data-status` ("running", "solved", "exhausted", or "refused"
 * while the settings are not valid), `data-accepted`, `data-tried`, `data-drawn` (trajectories on the canvas),
 * `data-last` ("accepted", "refused" or "none"), `data-begun` (another number for each experiment), and
 * `data-fingerprint`. Each frame leaves a measure "trajectories-frame".
 */
import { withSeed } from "../widgets/field.js";
import { randomSeed, trajectoryOptions } from "planarium/full";
import { App } from "../app/app.js";
import { useLink } from "../app/link.js";
import { byId, grouped } from "../app/dom.js";
import { Figure } from "../draw/figure.js";
import { csvFile } from "../formats/csv.js";
import { showDownloads } from "../widgets/downloads.js";
import { button, press } from "../widgets/elements.js";
import { Options } from "../widgets/options.js";
import { Transport } from "../widgets/transport.js";
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
/** New seeds are below this: short enough to say aloud. */
const SEEDS = 100_000;
const COLUMNS = ["x", "y", "theta", "v", "w", "duration", "tries", "milliseconds", "average"];

const app = new App();

await app.open("trajectories", async (/** @type {Remote<Commands>} */ worker) => {
  const stage = byId("stage", HTMLElement);
  const experiment = new Experiment(worker);
  const plane = new Plane(experiment);
  const figure = new Figure(app, stage, { id: "plane", kind: "workspace", caption: "Trajectories" }, plane);
  const drawCharts = makeCharts(experiment);
  const particle = new Particle(app, byId("single", HTMLElement));
  const table = /** @type {ParameterInfo[]} */ ([...withSeed([], "experiment"), ...trajectoryOptions()]);
  let options = form({});
  let frameStart = 0;
  let animationStart = 0;
  let wasMoving = false;

  const transport = new Transport(
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
      advance: (count) => experiment.advance(transport.isFinishing ? Math.max(count, AT_ONCE) : count, showProgress),
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
      figure.redraw(["top"]);
    },
    { className: "quiet", ariaPressed: "false" },
  );
  transport.bar.append(animate);
  const newSeed = byId("new-seed", HTMLButtonElement);
  newSeed.disabled = false;
  newSeed.addEventListener("click", async () => {
    options = form({ ...options.given, seed: randomSeed() % SEEDS });
    if (await restart()) transport.setPlaying(true);
  });

  app.onFrame((now) => {
    frameStart = performance.now();
    plane.now = now;
    if (plane.moment !== null) plane.moment = (Math.max(0, now - animationStart) / 1000) % plane.round;
    plane.isStill = app.reducedMotion || !transport.isPlaying;
    const isMoving = plane.isMoving(now);
    if (isMoving || wasMoving) figure.redraw(["top"]);
    wasMoving = isMoving;
    return isMoving;
  });
  app.onDraw(() => {
    drawCharts(!transport.isPlaying && app.pending === 0);
    show();
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
  app.rebuild = restart;
  await app.track(
    useLink(app, stateRule, {
      save: () => ({ given: options.given, tried: experiment.result?.iterations ?? 0, one: particle.movement }),
      open,
      contents: "the settings, the seed and the number of tries",
    }),
  );

  /** The settings as a form. @param {Settings} given */
  function form(given) {
    return new Options(byId("settings", HTMLElement), table, given, () => void restart(), { first: SHOWN });
  }

  function showProgress() {
    figure.redraw(["top"]);
    if (!experiment.isRunning) app.announcer.say(sentence(""));
  }

  /** Starts an experiment with the settings of the form. @returns {Promise<boolean>} */
  async function restart() {
    transport.pause();
    if (!options.settings) return refuse();
    app.notice.hide();
    const isBegun = await app.track(
      experiment.begin(/** @type {TrajectoryOptions} */ (options.settings)).catch((error) => {
        if (error.code !== "internal" && options.refuse(error.pointer, error.message)) return refuse();
        throw error;
      }),
    );
    if (!isBegun) return false;
    transport.enable(true);
    animationStart = performance.now();
    Object.assign(stage.dataset, { status: "running", begun: experiment.epoch });
    figure.redraw();
    return true;
  }

  /** The settings are not valid: the experiment stays on the page but stops. */
  function refuse() {
    experiment.epoch++;
    transport.enable(false);
    stage.dataset.status = "refused";
    return false;
  }

  /** @param {State | null} state */
  async function open(state) {
    const { given, tried, one } = state ?? stateRule.defaults;
    options = form(given);
    const unknown = Object.keys(given).find((name) => !options.field(name));
    if (unknown) throw new Error(`There is no setting "${unknown}".`);
    particle.set(one);
    if (await restart()) {
      if (state || app.reducedMotion) await experiment.advance(state ? tried : Infinity, showProgress);
      else transport.setPlaying(true);
      figure.redraw(["top"]);
    } else if (state) throw new Error("Its settings are not valid.");
  }

  /** Shows the numbers. */
  function show() {
    const {
      result,
      accepted,
      isLastRejected,
      options: { count = 1000, model, seed = 0 },
    } = experiment;
    if (!result) return;
    const last = result.iterations === 0 ? "none" : isLastRejected ? "refused" : "accepted";
    const status = stage.dataset.status === "refused" ? "refused" : result.status;
    Object.assign(stage.dataset, {
      status,
      accepted: accepted.length,
      tried: result.iterations,
      drawn: figure.sheet.rowsOf("growth"),
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
      "fact-fingerprint": transport.isPlaying ? "\u2013" : result.fingerprint,
      where: `${model === "spiral" ? "Spirals" : "Arcs"} \u00b7 seed ${seed}`,
    });
    app.say(sentence(last), { isSilent: true });
    figure.describe(`${accepted.length} trajectories, no two of which cross, after ${result.iterations} tries.`);
  }

  /** @param {string} last  the outcome of the last try */
  function sentence(last) {
    const { result, rejected, accepted } = experiment;
    if (stage.dataset.status === "refused") return "These settings are not valid; see the message in the panel.";
    const total = grouped(result?.iterations ?? 0);
    if (result?.status === "solved") {
      const found = `${grouped(accepted.length)} trajectories, no two of which cross, after ${total} tries.`;
      return `${found} The last ${Math.min(WINDOW, accepted.length)} took ${grouped(sumOfLast("tries"))} tries.`;
    }
    if (result?.status === "exhausted")
      return `Stopped after ${total} tries with ${grouped(accepted.length)} accepted: hardly anything fits between them.`;
    if (!transport.isPlaying && last === "refused" && rejected)
      return `The last trajectory was rejected: it crosses number ${grouped(rejected.other + 1)}.`;
    return "Random trajectories are added one by one; those that cross an earlier one are rejected.";
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
