/**
 * The fold "How much room": switches for the shortest path, the widest disc, the safest path and the route graph, what is known
 * of each, and a chart of the clearance along the path, on which a pointer moves the robot.
 *
 * For tests: `#room` carries `data-state` ("busy" or "ready"), and once they are known `data-radius`, `data-length`,
 * `data-nodes` and `data-clearance`.
 */
import { byId, make, write } from "../../app/dom.js";
import { VIEW } from "../../domain/page-defaults.js";
import { Chart } from "../../widgets/chart.js";
import { row, toggle } from "../../widgets/elements.js";
import { num } from "../../widgets/format.js";
import { Slider } from "../../widgets/slider.js";
import { hasOptimum } from "../stage/lane.js";
import { ClearanceAxis } from "./axis.js";
import { Room } from "./room.js";
import { MEANINGS, OTHERS, alongText, faultText, optimumText, routesText, safestText, widestText } from "./words.js";

/** @import { App } from "../../app/app.js" */
/** @import { ViewOptions } from "../../domain/types.js" */
/** @import { Line } from "../../widgets/chart.js" */
/** @import { Experiment } from "../link/codec.js" */
/** @import { Timeline } from "../timeline/playback.js" */
/** @import { Session as RoomSession } from "./room.js" */
/** @import { Fault } from "./question.js" */
/** @typedef {{ view: ViewOptions }} State */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {RoomSession} session
 * @property {(view: Experiment["view"]) => void} setView
 * @property {(action: (session: { timeline: Timeline }) => unknown) => void} act
 * @property {(listener: (state: State) => void) => void} onState
 */

/** Height of the chart, CSS pixels. */
const HEIGHT = 170;
/** What the slider of the detour reaches, and what its field takes. */
const DETOUR = /** @type {const} */ ({ min: 1, max: 3, step: 0.05, allowed: [1, 100] });

/** @typedef {"optimum" | "widest" | "safest" | "routes"} Option */

export class RoomPanel {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.fold = byId("room-fold", HTMLDetailsElement);
    this.host = byId("room", HTMLElement);
    this.room = new Room(page, () => this.show());
    this.rows = {
      optimum: this.option("optimum", "Shortest path"),
      safest: this.option("safest", "Safest path"),
      widest: this.option("widest", "Widest disc"),
      routes: this.option("routes", "Route graph"),
    };
    this.detour = new Slider(
      { name: "room-detour", title: "Detour", unit: "times", ...DETOUR },
      VIEW.detour,
      (detour) => page.setView({ detour }),
    );
    this.rows.routes.element.append(this.detour.element);
    this.chart = new Chart("room-clearance", "", {
      height: HEIGHT,
      isTimeline: true,
      isSmooth: true,
      isEven: true,
    });
    this.line = make("p", { className: "hint", id: "room-along", role: "status" });
    /** The axis of the path that the chart shows. @type {ClearanceAxis | null} */
    this.axis = null;
    /** What the chart shows. @type {unknown[]} */
    this.drawn = [];
    this.host.append(
      make("div", { className: "room" }, ...Object.values(this.rows).map(({ element }) => element)),
      make("div", { className: "charts timed" }, this.chart.element),
      this.line,
    );
    this.scrub();
    this.fold.addEventListener("toggle", () => this.update());
    page.onState(() => this.update());
  }

  /** A switch with what is known. @param {Option} name @param {string} title */
  option(name, title) {
    const input = toggle(`room-${name}`, (isOn) => this.page.setView({ [name]: isOn }));
    const text = make("p", { className: "hint", id: `room-${name}-text`, ariaLive: "polite" });
    return { input, text, element: make("div", { className: "field" }, row(title, input), text) };
  }

  update() {
    this.room.isMeasuring = this.fold.open;
    this.room.update();
    this.show();
  }

  /** Shows what is known. */
  show() {
    const { room, rows, page, host, detour } = this;
    const { shown, lanes } = page.session;
    if (!shown) return;
    const { scenario, view, document } = shown;
    const { discs, routes } = room.serves;
    const shortest = lanes[0]?.optimum ?? null;
    for (const name of /** @type {Option[]} */ (Object.keys(rows))) rows[name].input.checked = view[name];
    rows.optimum.input.disabled = !hasOptimum(scenario);
    rows.widest.input.disabled = rows.safest.input.disabled = !discs;
    rows.routes.input.disabled = !routes;
    detour.element.hidden = !routes || !view.routes;
    detour.show(view.detour);
    write(rows.optimum.text, hasOptimum(scenario) ? optimumText(shortest, scenario.robot) : OTHERS.optimum);
    const widest = textOf(room.widest, (found) => widestText(found, document.robot), MEANINGS.widest);
    const safest = textOf(room.safest, (found) => safestText(found, shortest?.length ?? null), MEANINGS.safest);
    write(rows.widest.text, discs ? widest : OTHERS.discs);
    write(rows.safest.text, discs ? safest : OTHERS.discs);
    write(rows.routes.text, routes ? textOf(room.routes, routesText, MEANINGS.routes) : OTHERS.routes);
    this.showAlong();
    const questions = [room.widest, room.safest, room.routes, room.along, room.alongSafest];
    const found = {
      radius: room.widest.answer?.radius ?? room.safest.answer?.radius,
      length: room.safest.answer?.length,
      nodes: room.routes.answer?.nodes.length,
      clearance: room.along.answer?.least?.distance,
    };
    host.dataset.state = questions.some(({ isBusy }) => isBusy) ? "busy" : "ready";
    for (const [name, value] of Object.entries(found))
      if (value === undefined || value === null) delete host.dataset[name];
      else host.dataset[name] = String(value);
    byId("legend-widest", HTMLElement).hidden = !room.widest.answer?.bottleneck;
    byId("legend-safest", HTMLElement).hidden = !room.safest.answer?.path.length;
    byId("legend-routes", HTMLElement).hidden = !room.routes.answer?.nodes.length;
  }

  /** The clearance along the path. */
  showAlong() {
    const { room, chart, line } = this;
    const { along, alongSafest, playback } = room;
    const { shown } = this.page.session;
    const answer = along.answer;
    const isThere = answer !== null && answer.least !== null && playback !== null && shown !== null;
    chart.element.hidden = !isThere;
    if (!playback)
      write(line, "There is no path yet. Once the planner has found one, the clearance along it is shown here.");
    else if (along.fault) write(line, faultText(along.fault));
    else if (!answer) write(line, "The clearance along the path is being measured.");
    else if (!isThere) write(line, alongText(answer, 0));
    if (!isThere) {
      this.axis = null;
      this.drawn = [];
      return;
    }
    const about = [answer, playback, alongSafest.answer];
    if (about.some((one, i) => one !== this.drawn[i])) {
      this.drawn = about;
      this.draw();
    }
    chart.show(this.axis?.now() ?? 0);
  }

  /** Draws the chart. */
  draw() {
    const { room, chart, line } = this;
    const { answer, about } = room.along;
    const { shown } = this.page.session;
    if (!answer?.least || !about || !shown) return;
    const axis = (this.axis = new ClearanceAxis(shown.scenario, about[1]));
    const { least, distances } = answer;
    const at = axis.at(least.index);
    const text = alongText(answer, at);
    write(line, text);
    /** @type {Line[]} */
    const lines = [
      { label: "", points: axis.points(distances), className: "series-1" },
      { label: "", points: [[at, least.distance]], isDots: true, className: "series-1 least" },
    ];
    const safest = room.alongSafest.answer;
    const path = room.alongSafest.about?.[1] ?? [];
    let end = axis.length;
    if (safest?.least) {
      const other = ClearanceAxis.ofPoints(path);
      lines.push({ label: "", points: other.map((x, i) => [x, safest.distances[i]]), className: "series-3" });
      end = Math.max(end, other[other.length - 1]);
    }
    write(
      chart.title,
      `Clearance from obstacles and bounds along the path, m${safest?.least ? "; dotted: along the safest path" : ""}`,
    );
    chart.draw(
      lines,
      { title: "metres along the path", low: 0, high: end, isExact: true },
      { title: "clearance, m", low: 0 },
      `Clearance against metres along the path, which is ${num(axis.length)} metres long. ${text}`,
    );
  }

  /** Lets a pointer on the chart move the robot. */
  scrub() {
    const { picture } = this.chart;
    const move = (/** @type {PointerEvent} */ event) => {
      const { axis, chart, page } = this;
      if (!axis || (event.type === "pointermove" && event.buttons === 0)) return;
      const metres = chart.pointed(event, axis.length);
      if (metres !== null) page.act(({ timeline }) => timeline.along(axis.part(metres)));
    };
    picture.addEventListener("pointerdown", move);
    picture.addEventListener("pointermove", move);
  }
}

/**
 * What is known, in words; why nothing is; what it would be.
 * @template T
 * @param {{ answer: T | null, fault: Fault | null, isBusy: boolean }} question
 * @param {(answer: T) => string} words
 * @param {string} meaning
 */
function textOf({ answer, fault, isBusy }, words, meaning) {
  if (answer !== null) return words(answer);
  if (fault) return faultText(fault);
  return isBusy ? "Being computed." : meaning;
}
