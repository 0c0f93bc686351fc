/** Bars: the share of trials with a path, or of valid paths, with its interval. */
import { isShare } from "../measures.js";
import { bySettings } from "./summaries.js";
import { bands } from "./bands.js";
import { intervalOf, shareOf } from "./parts.js";

/** @type {import("../charts.js").Chart} */
export const success = {
  id: "success",
  title: "Success",
  fits: isShare,
  controls: ["measure", "axis"],
  swatch: "bar",
  data: (query) => bySettings(query),
  marks(plot, chart, look) {
    const { at, counts, options } = bands(plot, chart, look, true);
    const fill = (/** @type {{ series: string }} */ one) => look.styleOf(one.series).colour;
    return {
      marks: [
        plot.barY(chart.summaries, { ...at, y: "middle", fill, fillOpacity: 0.75 }),
        plot.ruleX(chart.summaries, { ...at, y1: "low", y2: "high", stroke: look.palette.ink, strokeWidth: 1.5 }),
        ...counts,
      ],
      options,
    };
  },
  remark: ({ measure }) => `Bars: ${shareOf(measure)}. Lines: ${intervalOf(measure)}.`,
};
