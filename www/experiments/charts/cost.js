/** A measure against work: a dot for each trial, and median and quartiles of trials with about the same work. */
import { grouped } from "../../app/dom.js";
import { isShare } from "../measures.js";
import { bins, points } from "../tables.js";
import { acrossOptions, countMarks, dotsOf, IDENTITY, strokeOf, upOptions, WHOLE_RUN } from "./parts.js";

/** @type {import("../charts.js").Chart} */
export const cost = {
  id: "cost",
  title: "Cost and work",
  fits: (measure) => !isShare(measure),
  controls: ["measure", "work", "axis", "log"],
  swatch: "line",
  groupedBy: (axis) => (axis?.isNumeric ? axis : undefined),
  data(query) {
    const { rows, by, measure, work, continuous } = query;
    const [across, up] = [continuous(work, true), continuous(measure, false)];
    const all = bins(query, by, measure, work);
    return {
      title: `${up.title} against ${across.title}`,
      across,
      up,
      points: points(query, by, measure, work),
      bins: all,
      counted: all.map(({ n }) => n),
      columns: ["series", "trials", work, "lower_quartile", "median", "upper_quartile"],
      rows: () => all.map(({ series, n, work: at, low, middle, high }) => [series, n, at, low, middle, high]),
      words: `${grouped(rows.done)} trials`,
    };
  },
  marks(plot, chart, { styleOf }) {
    const fill = (/** @type {{ series: string }} */ one) => styleOf(one.series).colour;
    const lines = chart.series.flatMap((name) => {
      const some = chart.bins.filter((bin) => bin.series === name);
      const style = styleOf(name);
      return [
        plot.areaY(some, { x: "work", y1: "low", y2: "high", fill: style.colour, fillOpacity: 0.22 }),
        plot.lineY(some, { x: "work", y: "middle", ...strokeOf(style) }),
        ...countMarks(plot, chart, some, { x: "work", y: "high", dy: -7, fill: style.colour }),
      ];
    });
    const dots = { x: "work", y: "value", r: 2.6, fill, fillOpacity: 0.5, className: "trials" };
    return {
      marks: [plot.dot(chart.points, dots), ...lines],
      options: {
        x: { ...acrossOptions(chart.across), nice: true, zero: false },
        y: upOptions(chart.up, false),
        color: IDENTITY,
      },
    };
  },
  remark: (chart) =>
    `Line and band: median and quartiles of trials with a path and about the same work. ${WHOLE_RUN}${dotsOf(chart)}`,
};
