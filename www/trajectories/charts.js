/**
 * Charts of tries and time for each accepted trajectory, with their moving averages. The tries depend on the seed, the
 * time on the machine.
 */
import { Chart } from "../widgets/chart.js";
import { byId } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { WINDOW, movingAverage } from "./experiment.js";

/** @import { Experiment } from "./experiment.js" */

/** Milliseconds between two drawings while it grows. */
const PAUSE = 500;

/**
 * @param {Experiment} experiment
 * @returns {(isAtRest: boolean) => void} draws the charts if they have changed, at rest or after a pause
 */
export function makeCharts(experiment) {
  const counts = new Chart("tries", "Tries per accepted trajectory");
  const time = new Chart("time", "Time per accepted trajectory, microseconds on this machine");
  byId("charts", HTMLElement).append(counts.element, time.element);
  const isDue = pacer(PAUSE);
  let drawn = "";
  return (isAtRest) => {
    const { epoch, accepted } = experiment;
    const key = `${epoch} ${accepted.length}`;
    if (key === drawn || !isDue(isAtRest)) return;
    drawn = key;
    drawCurve(
      counts,
      accepted.map(({ tries }) => tries),
      "tries",
      false,
    );
    // Clocks of browsers are coarse and some times are outliers: dots, on a logarithmic scale.
    drawCurve(
      time,
      accepted.map(({ milliseconds }) => 1000 * milliseconds),
      "microseconds",
      true,
    );
  };
}

/** @param {Chart} chart @param {number[]} values @param {string} unit @param {boolean} isTime */
function drawCurve(chart, values, unit, isTime) {
  const average = movingAverage(values);
  const means =
    average.length === 0
      ? ""
      : `, ${average[0][1].toFixed(1)} ${unit} on average over the first ${WINDOW}, ${average[average.length - 1][1].toFixed(1)} over the last`;
  const summary = `${chart.title.textContent}: ${values.length === 0 ? "none yet" : `${values.length} accepted${means}`}.`;
  chart.draw(
    [
      { label: "", points: values.map((value, i) => [i + 1, value]), className: "each", isDots: isTime },
      { label: average.length === 0 ? "" : `mean of ${WINDOW}`, points: average, className: "average" },
    ],
    { title: "accepted", low: 0, high: 1 },
    isTime ? { title: unit, isLog: true } : { title: unit, low: 0 },
    summary,
  );
}
