/** Boxes: quartiles, smallest and largest value, and a dot for each trial. */
import { isShare } from "../measures.js";
import { points } from "../tables.js";
import { bands } from "./bands.js";
import { dotsOf } from "./parts.js";
import { bySettings } from "./summaries.js";

/** @type {import("../charts.js").Chart} */
export const box = {
  id: "box",
  title: "Boxes",
  fits: (measure) => !isShare(measure),
  controls: ["measure", "axis", "log"],
  swatch: "bar",
  data: (query) => ({ ...bySettings(query), points: points(query, query.axis, query.measure, "iterations") }),
  marks(plot, chart, look) {
    const { at, counts, options } = bands(plot, chart, look, false);
    const fill = (/** @type {{ series: string }} */ one) => look.styleOf(one.series).colour;
    return {
      marks: [
        ...[
          ["least", "low"],
          ["high", "most"],
        ].map(([y1, y2]) => plot.ruleX(chart.summaries, { ...at, y1, y2, stroke: fill, strokeWidth: 1.5 })),
        plot.barY(chart.summaries, {
          ...at,
          y1: "low",
          y2: "high",
          fill,
          fillOpacity: 0.3,
          stroke: fill,
          strokeWidth: 1.5,
        }),
        plot.tickY(chart.summaries, { ...at, y: "middle", stroke: fill, strokeWidth: 3 }),
        plot.dot(chart.points, { ...at, y: "value", r: 2.4, fill, fillOpacity: 0.55, className: "trials" }),
        ...counts,
      ],
      options,
    };
  },
  remark: (chart) => `Boxes: quartiles of trials with a path; lines: smallest and largest value.${dotsOf(chart)}`,
};
