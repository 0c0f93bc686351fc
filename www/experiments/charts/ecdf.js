/** The empirical distribution function: the share of all trials with a path within an amount of work. */
import { isShare } from "../measures.js";
import { distributions } from "../tables.js";
import { acrossOptions, countMarks, IDENTITY, strokeOf, upOptions, WHOLE_RUN } from "./parts.js";
import { inWords } from "./summaries.js";
import { grouped } from "../../app/dom.js";

/** @import { Distribution } from "../tables.js" */

/** Steps of a line drawn, about. */
const MOST_STEPS = 400;

/** @type {import("../charts.js").Chart} */
export const ecdf = {
  id: "ecdf",
  title: "Distribution",
  fits: (measure) => !isShare(measure),
  controls: ["work", "log"],
  swatch: "line",
  groupedBy: () => undefined,
  isOfAll: true,
  data(query) {
    const { work, continuous } = query;
    const all = distributions(query, work);
    const across = continuous(work, true);
    return {
      title: `Share of trials solved, by ${across.title}`,
      across,
      up: { ...continuous("solved", false), title: "share of trials solved, %" },
      distributions: all,
      counted: all.map(({ n, missing }) => n + missing),
      columns: ["series", work, "share_percent"],
      rows: () => all.flatMap(({ series, values, shares }) => values.map((value, i) => [series, value, shares[i]])),
      words: inWords(
        all,
        ({ series, n, missing }) => `${series || "all trials"}: ${grouped(n)} of ${grouped(n + missing)} solved`,
      ),
    };
  },
  marks(plot, chart, { styleOf }) {
    const { across, up, distributions: all } = chart;
    const end = Math.max(...all.map(({ values }) => values[values.length - 1] ?? -Infinity));
    return {
      marks: all.flatMap((one) => {
        const style = styleOf(one.series);
        const steps = stairs(one, end);
        const last = steps.slice(-1).map((step) => ({ ...step, n: one.n + one.missing }));
        return [
          plot.lineY(steps, { x: "value", y: "share", curve: "step-after", ...strokeOf(style) }),
          ...countMarks(plot, chart, last, { x: "value", y: "share", dx: -10, dy: -7, fill: style.colour }),
        ];
      }),
      options: {
        x: { ...acrossOptions(across), nice: true, zero: !across.isLog },
        y: upOptions(up),
        color: IDENTITY,
      },
    };
  },
  remark: () =>
    `Share of all trials that had found a path, by work. Trials without a path stay in the denominator. ${WHOLE_RUN}`,
};

/**
 * A distribution function as a line: it begins at 0, and holds to the end.
 * @param {Distribution} distribution
 * @param {number} end
 */
function stairs({ values, shares }, end) {
  if (values.length === 0) return [];
  const each = Math.ceil(values.length / MOST_STEPS);
  const some = values.flatMap((value, i) =>
    i % each === 0 || i === values.length - 1 ? [{ value, share: shares[i] }] : [],
  );
  return [{ value: values[0], share: 0 }, ...some, { value: end, share: shares[shares.length - 1] }];
}
