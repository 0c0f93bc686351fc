/** A line over a parameter: medians with quartiles, or shares with their interval; dots over words. */
import { bySettings, level } from "./summaries.js";
import {
  acrossOptions,
  countMarks,
  DIGIT,
  IDENTITY,
  intervalOf,
  shareOf,
  SIDES,
  strokeOf,
  ticksOf,
  upOptions,
} from "./parts.js";
import { isShare } from "../measures.js";

/** Series with a row of numbers of trials, at most, and the pixels of a row. */
const ROWS = 4;
const ROW = 12;

/** @type {import("../charts.js").Chart} */
export const line = {
  id: "line",
  title: "Line",
  fits: () => true,
  controls: ["measure", "axis", "log"],
  swatch: "line",
  data(query) {
    const table = bySettings(query);
    return query.axis?.isNumeric ? { ...table, summaries: level(table.summaries ?? [], query.axis) } : table;
  },
  marks(plot, chart, { width, styleOf }) {
    const { across, series, summaries } = chart;
    // Settings without a value have no place on the axis.
    const valued = across.values.filter((value) => summaries.some(({ x, middle }) => x === value && middle !== null));
    const few = valued.length <= 12 ? { ticks: /** @type {any} */ (valued.filter((value) => value !== null)) } : {};
    const place = across.isNumeric
      ? { ...few, tickFormat: /** @type {any} */ (String) }
      : { type: /** @type {const} */ ("point"), domain: across.values, padding: 0.5, ...ticksOf(across, width) };
    // Where there is no room for all numbers of trials, some are left out.
    const room = (width - SIDES) / Math.max(1, across.values.length);
    const each = Math.ceil((DIGIT * String(chart.counts.most).length + 5) / room);
    const hasCounts = series.length <= ROWS && chart.counts.least < chart.counts.most;
    const marks = series.flatMap((name, i) => {
      const some = summaries.filter((one) => one.series === name);
      const style = styleOf(name);
      const counts = hasCounts
        ? countMarks(
            plot,
            chart,
            some.filter((_, j) => j % each === 0),
            { x: "x", frameAnchor: "top", dy: -10 - ROW * (series.length - 1 - i), fill: style.colour },
          )
        : [];
      // No line joins categories; dots of one are side by side.
      const beside = { dx: 9 * (i - (series.length - 1) / 2) };
      if (!across.isNumeric)
        return [
          plot.ruleX(some, { x: "x", y1: "low", y2: "high", stroke: style.colour, strokeWidth: 2, ...beside }),
          plot.dot(some, { x: "x", y: "middle", symbol: style.symbol, fill: style.colour, r: 4.4, ...beside }),
          ...counts,
        ];
      return [
        plot.areaY(some, { x: "x", y1: "low", y2: "high", fill: style.colour, fillOpacity: 0.16 }),
        plot.lineY(some, { x: "x", y: "middle", ...strokeOf(style) }),
        plot.dot(some, { x: "x", y: "middle", symbol: style.symbol, fill: style.colour, r: 3.4 }),
        ...counts,
      ];
    });
    return {
      marks,
      above: hasCounts ? ROW * (series.length - 1) + 4 : 0,
      options: {
        x: { ...acrossOptions(across), ...place, ...(hasCounts ? { inset: 8 } : {}) },
        y: upOptions(chart.up, false),
        color: IDENTITY,
      },
    };
  },
  remark({ measure, across }) {
    const [marks, intervals] = across.isNumeric ? ["Line", "band"] : ["Dots", "lines"];
    return `${marks}: ${isShare(measure) ? shareOf(measure) : "median"}; ${intervals}: ${intervalOf(measure)}.`;
  },
};
