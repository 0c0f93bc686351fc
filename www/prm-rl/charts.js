/** The curves of a training: returns, and the share of tasks solved, over the generations. */
import { byId } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { csvFile } from "../formats/csv.js";
import { Chart } from "../widgets/chart.js";

/** @import { NavigationSession } from "./session.js" */

/** Milliseconds between two drawings while it grows. */
const PAUSE = 400;

/**
 * @param {NavigationSession} session
 * @returns {() => void} draws the charts if they have changed, at rest or after a pause
 */
export function makeCharts(session) {
  const returns = new Chart("returns", "Return of the candidates of a generation");
  const solved = new Chart("solved", "Tasks solved by the candidates, in percent");
  byId("charts", HTMLElement).append(returns.element, solved.element);
  const isDue = pacer(PAUSE);
  /** @type {unknown[]} */
  let drawn = [];
  return () => {
    const { part } = session;
    const { history, status } = session.training;
    const isDrawn = drawn[0] === history && drawn[1] === history.length;
    if (part !== "train" || isDrawn || !isDue(status !== "running")) return;
    drawn = [history, history.length];
    const points = (/** @type {(row: { mean: number, best: number, reached: number }) => number} */ value) =>
      history.map((row, i) => /** @type {[number, number]} */ ([i + 1, value(row)]));
    const last = history.at(-1);
    const generations = { title: "generation", low: 1, high: Math.max(10, history.length) };
    returns.draw(
      [
        { label: "best", points: points(({ best }) => best), className: "best" },
        { label: "mean", points: points(({ mean }) => mean), className: "mean" },
      ],
      generations,
      { title: "return", low: 0, high: 1 },
      last
        ? `Returns over ${history.length} generations: of the last one ${last.mean.toFixed(2)} on average, ${last.best.toFixed(2)} at best.`
        : "No generation is over.",
    );
    solved.draw(
      [{ label: "", points: points(({ reached }) => 100 * reached), className: "share" }],
      generations,
      { title: "%", low: 0, high: 100 },
      last
        ? `Of the last of ${history.length} generations ${(100 * last.reached).toFixed(0)} % of the tasks were solved.`
        : "No generation is over.",
    );
  };
}

/** @param {NavigationSession} session */
export function trainingCsv({ training: { history } }) {
  return csvFile(
    ["generation", "mean_return", "best_return", "tasks_solved"],
    history.map(({ mean, best, reached }, i) => [i + 1, mean, best, reached]),
  );
}

/**
 * The swing of the load of the drive with the rays, over time, beside its limit.
 * @param {NavigationSession} session
 * @returns {() => void} draws it if it has changed
 */
export function makeSwingChart(session) {
  const chart = new Chart("swing", "Displacement of the load after each time step");
  const host = byId("swing-chart", HTMLElement);
  host.append(chart.element);
  /** @type {unknown} */
  let drawn = null;
  return () => {
    const { selected, document } = session;
    const { drives } = session.run;
    const drive = drives[selected];
    host.hidden = !drive || document?.robot.type !== "cargo";
    if (!drive || document?.robot.type !== "cargo" || drive === drawn) return;
    drawn = drive;
    const { time_step: step = 0.2, swing_limit: limit } = document.robot;
    const points = Array.from(
      { length: drive.swing.length / 2 },
      (_, i) => /** @type {[number, number]} */ ([i * step, Math.hypot(drive.swing[2 * i], drive.swing[2 * i + 1])]),
    );
    const most = Math.max(...points.map(([, swing]) => swing));
    chart.draw(
      [
        { label: "load", points, className: "best" },
        {
          label: "limit",
          points: [
            [0, limit],
            [drive.time, limit],
          ],
          className: "mean",
        },
      ],
      { title: "s", low: 0, high: Math.max(1, drive.time) },
      { title: "m", low: 0, high: 1.15 * limit },
      `At the ends of time steps the load is displaced by at most ${most.toFixed(2)} m; the limit is ${limit.toFixed(2)} m.`,
    );
  };
}
