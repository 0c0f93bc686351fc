/** The chart on the stage, its caption, and the table of what it shows. It is drawn again while trials end. */
import { byId, grouped, make } from "../app/dom.js";
import { once } from "../app/once.js";
import { chartOf, remarkOf } from "./charts.js";
import { SOLVED, commonUnit } from "./measures.js";
import { subjectOf } from "./words.js";

/** @import { ChartData } from "./charts.js" */
/** @import { Cell } from "./rows.js" */
/** @import { ExperimentSession } from "./session.js" */

/**
 * Milliseconds between two drawings while trials end: at least this number, and this many times as long as a drawing
 * takes.
 */
const PAUSE = 400;
const REST = 8;
/** Rows of the table, at most. */
const MOST_ROWS = 400;

const drawing = once(() => import("./draw.js"));

/** The height of a chart: a part of the window's and of its own width, at most, and pixels, at least. */
const TALL = { ofWindow: 0.605, ofWidth: 0.75, pixels: 300, least: 220 };
/** What is below a chart that fills a screen, in letters of the page. */
const BELOW = 2;

export class ChartView {
  /**
   * @param {ExperimentSession} session
   * @param {() => HTMLElement[]} waiting   what is in the place of the chart before a trial has ended
   */
  constructor(session, waiting) {
    this.session = session;
    this.app = session.app;
    this.waiting = waiting;
    this.host = byId("chart", HTMLElement);
    this.fold = byId("table-fold", HTMLDetailsElement);
    /** @type {ChartData | null} */
    this.chart = null;
    /** @type {SVGSVGElement | null} */
    this.picture = null;
    /** The picture with title and caption. @type {() => SVGSVGElement | null} */
    this.framed = () => null;
    /** Whether the chart is out of date, when it was last drawn, and for how long, milliseconds. */
    this.isStale = true;
    this.drawnAt = -Infinity;
    this.took = 0;
    this.isDrawing = false;
    /** Called once it is drawn. @type {(() => void)[]} */
    this.listeners = [];
    session.onChange((change) => {
      if (change !== "phase" || !this.chart) this.isStale = true;
    });
    new ResizeObserver(() => this.redraw()).observe(this.host);
    addEventListener("resize", () => this.redraw());
    this.app.onTheme(() => this.redraw());
    this.app.onFrame((now) => this.animate(now));
    this.fold.addEventListener("toggle", () => this.showTable());
  }

  redraw() {
    this.isStale = true;
    this.app.requestFrame();
  }

  /** Draws what is out of date, at rest or after a pause. @param {number} now */
  animate(now) {
    if (!this.isStale || this.isDrawing) return false;
    if (this.session.isBusy && now - this.drawnAt < Math.max(PAUSE, REST * this.took)) return true;
    this.isDrawing = true;
    this.isStale = false;
    void this.app.track(this.draw()).then(() => {
      this.isDrawing = false;
      if (this.isStale) this.app.requestFrame();
    });
    return false;
  }

  async draw() {
    const { session, host } = this;
    const { drawChart, captioned } = await drawing();
    const began = performance.now();
    const { rows, factors, view, asked, units, ceiling, measures } = session;
    const unit = commonUnit(units) ?? "units differ";
    const { palette } = this.app.look;
    const chart = rows.done > 0 ? chartOf(rows, factors, view, asked, unit, ceiling, measures) : null;
    const width = Math.max(280, Math.floor(host.clientWidth));
    // In a frame and on a projector it takes what is left of the screen.
    const isWhole = document.documentElement.matches(".embed, .projector");
    const letter = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const top = host.getBoundingClientRect().top + (host.closest(".stage-column")?.scrollTop ?? 0);
    const room = isWhole ? innerHeight - top - BELOW * letter : TALL.ofWindow * innerHeight;
    const least = isWhole ? TALL.least : TALL.pixels;
    const height = Math.round(Math.max(least, Math.min(room, TALL.ofWidth * width)));
    // Letters are as large as the page's, and everything with them.
    const zoom = letter / 16;
    const picture = chart && drawChart(chart, { width: width / zoom, height: height / zoom, isWhole, palette });
    if (picture) picture.style.width = `${width}px`;
    this.chart = chart;
    this.picture = picture;
    this.framed = () =>
      picture && captioned(picture, { title: session.document.title ?? "", caption: this.caption, palette });
    host.replaceChildren(...(picture ? [picture] : this.waiting()));
    byId("caption", HTMLElement).textContent = chart ? `${chart.kind.title}: ${chart.title}` : "";
    const hint = chart && chart.points.length > 0 ? " Click a dot to watch its run." : "";
    byId("remark", HTMLElement).textContent = this.caption + hint;
    this.showTable();
    for (const listener of this.listeners) listener();
    Object.assign(document.body.dataset, { chart: chart?.kind.id ?? "", drawn: rows.done });
    this.drawnAt = performance.now();
    this.took = this.drawnAt - began;
  }

  get caption() {
    return this.chart ? captionOf(this.chart, this.session) : "";
  }

  /** What is shown, to export it. @throws {Error} there is no chart yet */
  get shown() {
    const picture = this.framed();
    if (!picture || !this.chart) throw new Error("There is no chart yet.");
    return { picture, chart: this.chart, ground: this.app.look.palette.stage };
  }

  showTable() {
    const { fold, chart } = this;
    if (!fold.open || !chart) return;
    const [{ columns }, rows] = [chart, chart.rows()];
    const cut = rows.slice(0, MOST_ROWS);
    byId("table", HTMLElement).replaceChildren(
      make(
        "table",
        { className: "standings" },
        make(
          "caption",
          {},
          `${chart.title}${cut.length < rows.length ? `: ${cut.length} of ${grouped(rows.length)} rows; the export has all` : ""}`,
        ),
        make(
          "thead",
          {},
          make("tr", {}, ...columns.map((column) => make("th", { scope: "col" }, column.replaceAll("_", " ")))),
        ),
        make(
          "tbody",
          {},
          ...cut.map((row) =>
            make("tr", {}, ...row.map((cell) => make("td", { dataset: { value: cell } }, cellText(cell)))),
          ),
        ),
      ),
    );
  }
}

/**
 * What is under the chart, in its exports too: the reader's caption, what was run, what the marks mean, and what is still
 * to come.
 * @param {ChartData} chart
 * @param {Pick<ExperimentSession, "document" | "caption" | "ceiling" | "rows" | "uncertified">} session
 */
export function captionOf(chart, session) {
  const { caption, ceiling, rows, uncertified } = session;
  const isOfPaths = chart.measure === SOLVED || chart.kind.isOfAll;
  const words = ceiling && isOfPaths ? [ceiling.words] : [];
  const left = rows.done < rows.count ? [`${grouped(rows.done)} of ${grouped(rows.count)} trials.`] : [];
  if (isOfPaths && uncertified > 0) left.push("Worlds without a path are still being examined.");
  return [caption, subjectOf(session), remarkOf(chart), ...words, ...left].filter(Boolean).join(" ");
}

/** @param {Cell} cell */
function cellText(cell) {
  return cell === null
    ? "\u2013"
    : typeof cell === "number" && !Number.isInteger(cell)
      ? String(Number(cell.toPrecision(5)))
      : String(cell);
}
