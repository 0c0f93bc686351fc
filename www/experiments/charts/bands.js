/** The bands of bars and boxes: the factor across, and within it the series. */
import { acrossOptions, countMarks, DIGIT, IDENTITY, SIDES, ticksOf, upOptions } from "./parts.js";

/** @import { ChartData, Look, Plot } from "../charts.js" */

/**
 * @param {Plot} plot
 * @param {ChartData} chart
 * @param {Look} look
 * @param {boolean} isFromZero
 * @returns {{ at: { x: string, fx?: string }, counts: import("@observablehq/plot").Markish[], options:
 *   import("@observablehq/plot").PlotOptions }}  the channels of a bar, the numbers of trials above, and the axes
 */
export function bands(plot, chart, { width, styleOf }, isFromZero) {
  const { across, series, summaries } = chart;
  const isFaceted = series.length > 1 && across.title !== "";
  const axis = {
    ...acrossOptions(across),
    type: /** @type {const} */ ("band"),
    domain: across.title ? across.values : series,
    ...ticksOf(across.title ? across : { ...across, values: series }, width),
  };
  const at = isFaceted ? { fx: "x", x: "series" } : { x: across.title ? "x" : "series" };
  const y = upOptions(chart.up, isFromZero);
  const room = (0.8 * (width - SIDES)) / (Math.max(1, across.values.length) * Math.max(1, series.length));
  return {
    at,
    counts:
      room < DIGIT * String(chart.counts.most).length
        ? []
        : countMarks(plot, chart, summaries, {
            ...at,
            frameAnchor: "top",
            dy: -12,
            fill: (/** @type {{ series: string }} */ one) => styleOf(one.series).colour,
          }),
    options: isFaceted
      ? {
          fx: { ...axis, axis: /** @type {const} */ ("bottom"), type: undefined, padding: 0.15 },
          x: { axis: null, domain: series, padding: 0.1 },
          y,
          color: IDENTITY,
        }
      : { x: { ...axis, padding: 0.25 }, y, color: IDENTITY },
  };
}
