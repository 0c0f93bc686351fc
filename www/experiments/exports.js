/** The files that the page saves: the chart, its table, the rows and their summary, and the document. */
import { Experiment } from "planarium/full";
import { json } from "../app/files.js";
import { pngPicture, svgPicture } from "../draw/picture.js";
import { csvFile } from "../formats/csv.js";
import { showFiles } from "../widgets/downloads.js";
import { measureInfo } from "./measures.js";

/** @import { ChartView } from "./chart-view.js" */
/** @import { ExperimentSession } from "./session.js" */

/** Image pixels a CSS pixel. */
const SCALE = 2;

/** @param {ExperimentSession} session @param {ChartView} view */
export function showExports(session, view) {
  const title = () =>
    (session.info?.title || "experiment")
      .toLowerCase()
      .replace(/[^a-z0-9]+/g, "-")
      .replace(/^-+|-+$/g, "")
      .slice(0, 40);
  // A file that has not all trials says so in its name.
  const name = () => {
    const { done, count } = session.rows;
    return done < count ? `${title()}-${done}-of-${count}-trials` : title();
  };
  const chartName = () => {
    const { chart } = view;
    return chart ? `${name()}-${chart.kind.id}-${chart.measure.replaceAll("_", "-")}` : `${name()}-chart`;
  };
  showFiles(session.app, name, [
    {
      id: "png",
      title: "Chart",
      format: "PNG",
      meaning: "The chart with its title and caption.",
      name: chartName,
      content: () => {
        const { picture, chart, ground } = view.shown;
        return pngPicture(picture, ground, chart.title, SCALE);
      },
    },
    {
      id: "svg",
      title: "Vector graphic",
      format: "SVG",
      meaning: "The same, sharp at any size.",
      name: chartName,
      content: () => {
        const { picture, chart, ground } = view.shown;
        return svgPicture(picture, ground, chart.title);
      },
    },
    {
      id: "table",
      title: "Table of the chart",
      format: "CSV",
      meaning: "The numbers behind the chart.",
      name: chartName,
      content: () => {
        const { chart } = view.shown;
        // A file lies apart from the chart: each row says what is measured.
        const { title, unit } = measureInfo(chart.measure, session.unit);
        const texts = chart
          .rows()
          .map((row) => [...row.map((cell) => (typeof cell === "boolean" ? String(cell) : cell)), title, unit]);
        return csvFile([...chart.columns, "measure", "unit"], texts);
      },
    },
    {
      id: "rows",
      title: "Rows of all trials",
      format: "CSV",
      meaning: "The rows of \u201cplanarium sweep\u201d.",
      content: () => session.rows.csv(),
    },
    {
      id: "times",
      title: "Times of all trials",
      format: "CSV",
      meaning: "Seconds on this machine.",
      name: () => `${name()}.times`,
      content: () => session.rows.timesCsv(),
    },
    {
      id: "summary",
      title: "Summary",
      format: "JSON",
      meaning: "Statistics and comparisons, as \u201cplanarium sweep\u201d prints them.",
      name: () => `${name()}.summary`,
      content: () => summaryOf(session),
    },
    {
      id: "document",
      title: "Experiment",
      format: "JSON",
      meaning: "The document, for this page and for \u201cplanarium sweep\u201d.",
      name: title,
      content: () => json(session.resolved ?? session.document),
    },
  ]);
}

/** The statistics of the rows, by the core. @param {ExperimentSession} session */
function summaryOf({ resolved, rows }) {
  if (!resolved) throw new Error("There is no experiment.");
  const experiment = Experiment.parse(resolved);
  try {
    return json(experiment.summary(rows.records()));
  } finally {
    experiment.free();
  }
}
