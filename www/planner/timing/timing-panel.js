/**
 * The fold "Timing": limits of speed and acceleration, the duration, a time axis, and charts of speed and acceleration
 * with a cursor. While it is open the robot on the stage moves as its path is timed.
 *
 * For tests: `#timing` carries `data-state` ("none", "busy", "timed" or "fault"), and `data-duration` once timed.
 */
import { byId, counted, make, makeSvg, write } from "../../app/dom.js";
import { watchKeys } from "../../app/keys.js";
import { coordinatesOf } from "../../domain/coordinates.js";
import { Chart } from "../../widgets/chart.js";
import { button, labelled, press, row, select } from "../../widgets/elements.js";
import { Field } from "../../widgets/field.js";
import { num, secondsText } from "../../widgets/format.js";
import { Slider } from "../../widgets/slider.js";
import { letter } from "../race/standings.js";
import { legendOf, linesOf, quantitiesOf, styleOf } from "./quantities.js";
import { Timing } from "./timing.js";

/** @import { Experiment } from "../link/codec.js" */
/** @import { Timeline } from "../timeline/playback.js" */
/** @import { Limit, LimitName } from "./limits.js" */
/** @import { Quantity } from "./quantities.js" */
/** @import { Host as TimingHost, Session as TimingSession } from "./timing.js" */
/**
 * @typedef {object} State
 * @property {{ time: number, end: number } | null} timed
 * @property {boolean} playing
 * @property {boolean} growing
 */
/**
 * @typedef {object} Own
 * @property {TimingSession & { timeline: Timeline }} session
 * @property {State | null} state
 * @property {string[]} names
 * @property {(patch: { timing: Experiment["timing"] }) => void} change
 * @property {(action: (session: { timeline: Timeline }) => unknown) => void} act
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: State) => void) => void} onState
 */
/** @typedef {TimingHost & Own} Page */

/** How many times a limit's slider goes below what the page chooses, and above it. */
const REACH = 20;
/** What a limit may be. */
const ALLOWED = /** @type {const} */ ([1e-6, 1e9]);
/** Height of a chart, CSS pixels. */
const HEIGHT = 150;
/** @type {[number, string][]} */
const PACES = [
  [0.5, "0.5\u00d7"],
  [1, "1\u00d7"],
  [2, "2\u00d7"],
];

/** How a disc moves. @type {[string, string][]} */
const MOVES = [
  ["plane", "Moves in any direction"],
  ["differential", "Turns and drives"],
];

export class TimingPanel {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.fold = byId("timing-fold", HTMLDetailsElement);
    this.host = byId("timing", HTMLElement);
    this.timing = new Timing(page, () => this.show());
    this.line = make("p", { id: "timing-line", role: "status" });
    this.hint = make("p", { className: "hint", id: "timing-hint" });
    this.fields = make("div", { className: "limits" });
    this.moves = select("timing-moves", "How the robot moves", MOVES);
    this.moves.addEventListener("change", () => this.change({ differential: this.moves.value === "differential" }));
    this.moving = row("The robot", this.moves);
    this.play = button("timing-play", "Play", () => page.act(({ timeline }) => timeline.toggle()));
    this.slider = make("input", {
      type: "range",
      id: "timing-time",
      min: "0",
      step: "any",
      className: "timeline",
      ariaLabel: "Time",
    });
    this.slider.addEventListener("input", () => this.seek(Number(this.slider.value)));
    this.readout = make("output", { id: "timing-now" });
    this.paces = PACES.map(([pace, text]) =>
      button(`timing-pace-${String(pace).replace(".", "-")}`, text, () => this.change({ pace })),
    );
    this.legend = make("p", { id: "timing-legend", className: "legend", ariaHidden: "true" });
    this.charts = make("div", { className: "charts" });
    /** Each chart with what it shows. @type {{ chart: Chart, quantity: Quantity }[]} */
    this.shown = [];
    /** The paths that the charts show. @type {unknown} */
    this.drawn = null;
    /** Charts that are not drawn yet. @type {(() => void)[]} */
    this.due = [];
    this.bar = labelled(
      "group",
      "Time",
      make(
        "div",
        { className: "clock" },
        this.slider,
        this.play,
        labelled("group", "Speed of playback", make("div", { className: "segments" }, ...this.paces)),
        this.readout,
      ),
    );
    this.body = make("div", { className: "timed" }, this.bar, this.legend, this.charts);
    this.host.append(this.moving, this.fields, this.line, this.hint, this.body);
    watchKeys([this.bar], {
      " ": () => page.act(({ timeline }) => timeline.toggle()),
      home: () => this.seek(0),
      end: () => this.seek(this.timing.period),
    });
    this.scrub();
    /** The fields of the limits, by their names. @type {Map<LimitName, Slider | Field>} */
    this.inputs = new Map();
    page.app.onFrame(() => {
      this.due.shift()?.();
      return this.due.length > 0;
    });
    this.fold.addEventListener("toggle", () => this.turn());
    this.turn();
    page.onOpen(() => this.build());
    page.onState((state) => this.reflect(state));
  }

  /** The fold was opened or closed: a link stores which. */
  turn() {
    const isOn = this.page.record.timing !== undefined;
    if (isOn !== this.fold.open) this.page.change({ timing: this.fold.open ? {} : undefined });
    this.follow();
  }

  /** The state of the page has another timing, or another scene. */
  follow() {
    const { timing } = this.page.record;
    this.timing.isOn = timing !== undefined;
    if (this.fold.open !== this.timing.isOn) this.fold.open = this.timing.isOn;
    this.moving.hidden = !this.timing.isDisc;
    this.moves.value = this.timing.isDifferential ? "differential" : "plane";
    if (this.timing.limits.length !== this.inputs.size) this.fill();
    for (const { name, usual } of this.timing.limits) {
      const [input, value] = [this.inputs.get(name), this.timing.given[name] ?? usual];
      if (input instanceof Slider && value !== null) {
        this.widen(input, value);
        input.show(value);
      } else if (input instanceof Field && input.value !== (value ?? undefined)) input.set(value ?? "");
    }
    this.timing.update();
    this.show();
  }

  /** Changes limits or the pace; what the page chooses itself is not stored. @param {Record<string, number | boolean | undefined>} patch */
  change(patch) {
    const { timing = {} } = this.page.record;
    const next = /** @type {Record<string, number | boolean | undefined>} */ ({ ...timing, ...patch });
    for (const { name, usual } of this.timing.limits) if (next[name] === usual) delete next[name];
    if (next.pace === 1) delete next.pace;
    if (!next.differential) delete next.differential;
    this.page.change({ timing: /** @type {Experiment["timing"]} */ (next) });
  }

  /** @param {number} time */
  seek(time) {
    const { period } = this.timing;
    if (period > 0) this.page.act(({ timeline }) => timeline.along(time / period));
  }

  /** The fields and the charts of a robot. */
  build() {
    const { shown } = this.page.session;
    if (!shown) return;
    this.fill();
    this.shown = this.due = [];
    this.follow();
  }

  /** The fields of the limits. */
  fill() {
    this.inputs = new Map(this.timing.limits.map((limit) => [limit.name, this.inputOf(limit)]));
    this.fields.replaceChildren(...[...this.inputs.values()].map(({ element }) => element));
  }

  /** @param {Limit} limit @returns {Slider | Field} */
  inputOf({ name, title, unit, usual }) {
    const give = (/** @type {number | undefined} */ value) => this.change({ [name]: value });
    if (usual === null) {
      const info = {
        ...{
          name,
          title,
          unit,
          kind: /** @type {const} */ ("number"),
          min: ALLOWED[0],
          max: ALLOWED[1],
          choices: null,
          robots: [],
        },
        ...{ meaning: "", default: null, default_meaning: "none: the car may turn at any speed" },
      };
      const field = new Field(info, null, () => give(/** @type {number | undefined} */ (field.value)), "limit");
      return field;
    }
    const reach = { min: usual / REACH, max: usual * REACH, allowed: ALLOWED, isLog: true };
    const info = { name: `limit-${name}`, title, unit, ...reach };
    const slider = new Slider(info, usual, give);
    // The charts follow while it is dragged.
    slider.range.addEventListener("input", () => slider.give(slider.rangeValue));
    return slider;
  }

  /** Lets a slider reach a value. @param {Slider} slider @param {number} value */
  widen(slider, value) {
    const { min, max } = slider.info;
    slider.current = value;
    if (value < min || value > max) slider.setLimits(Math.min(min, value), Math.max(max, value));
  }

  /** Shows what is timed, or why nothing is. */
  show() {
    const { timing, page } = this;
    const { paths, fault, isBusy, period } = timing;
    const state = fault ? "fault" : paths.length > 0 ? "timed" : isBusy ? "busy" : "none";
    this.host.dataset.state = isBusy && state === "timed" ? "busy" : state;
    if (state === "timed") this.host.dataset.duration = String(period);
    else delete this.host.dataset.duration;
    this.body.hidden = state !== "timed" || period === 0;
    this.line.classList.toggle("reason", fault !== null);
    if (fault) this.host.dataset.code = fault.code;
    else delete this.host.dataset.code;
    write(this.line, this.sentence());
    write(this.hint, this.advice());
    this.hint.hidden = this.hint.textContent === "";
    this.paces.forEach((one, i) => press(one, PACES[i][0] === timing.pace));
    if (state === "timed" && period > 0 && !isBusy && this.fold.open) this.draw();
    if (page.state) this.reflect(page.state);
  }

  /** What is timed, in words. */
  sentence() {
    const { timing, page } = this;
    const { paths, fault, isBusy, period } = timing;
    if (fault) return `This path cannot be timed: ${fault.message.replace(/\.?$/, "")} (${fault.code}).`;
    if (paths.length === 0)
      return isBusy
        ? "The path is being timed."
        : "There is no path yet. Run the planner to its end: then its path is timed.";
    if (period === 0) return "The start is the goal: there is nothing to time.";
    const texts = paths.map(({ timed: { duration, rests } }) => {
      const stops = rests === 0 ? "without a rest on the way" : `with ${counted(rests, "rest")} on the way`;
      return `${num(duration, 3)}\u00a0s, ${stops}`;
    });
    if (page.names.length === 1) return `The fastest motion along the path takes ${texts[0]}.`;
    return `The fastest motions take: ${paths.map(({ lane }, i) => `${letter(lane)} ${texts[i]}`).join("; ")}.`;
  }

  /** How the path gets faster. */
  advice() {
    const { paths } = this.timing;
    const isCar = this.page.session.shown?.scenario.robot === "car";
    const rests = paths.some(({ timed }) => timed.rests > 0);
    if (!rests) return "";
    if (this.timing.isDifferential) return "The robot turns on the spot at each corner, and drives forward in between.";
    return isCar
      ? "The car rests where it changes its direction."
      : "The robot rests at each corner. Round the corners, by \u201cRounded corners\u201d among the parameters, and it does not.";
  }

  /** Prepares the charts of what is timed, where it differs: a frame draws one of them. */
  draw() {
    const { timing, page } = this;
    const { shown } = page.session;
    if (!shown || (this.drawn === timing.paths && this.shown.length > 0)) return;
    this.drawn = timing.paths;
    const quantities = quantitiesOf(shown.document.robot, coordinatesOf(shown), timing.used);
    if (this.shown.length !== quantities.length) {
      this.shown = quantities.map((quantity) => ({
        quantity,
        chart: new Chart(`timing-${quantity.id}`, "", { height: HEIGHT, isTimeline: true, isSmooth: true }),
      }));
      this.charts.replaceChildren(...this.shown.map(({ chart }) => chart.element));
    }
    const letters = page.names.length > 1 ? timing.paths.map(({ lane }) => letter(lane)) : [];
    const paths = timing.paths.map(({ timed }) => timed);
    this.due = quantities.map((quantity, i) => () => {
      const { chart } = this.shown[i];
      this.shown[i].quantity = quantity;
      const lines = linesOf(quantity, paths);
      const title = `${quantity.title}, ${quantity.unit}`;
      write(chart.title, title);
      const levels = quantity.limits.map(([label, value]) => `${label} ${num(value)}`).join(", ");
      chart.draw(
        lines,
        { title: "seconds", low: 0, high: timing.period, isExact: true },
        { title, low: quantity.isSigned ? -Math.max(...quantity.limits.map(([, value]) => value)) : 0 },
        `${title}, against time, over ${num(timing.period)} seconds. ${extremes(lines, legendOf(quantities, letters))} ${levels}.`,
      );
    });
    this.showLegend(legendOf(quantities, letters));
    page.app.requestFrame();
  }

  /** The names of the curves and of their limits, each with a piece of its line. @param {string[]} names */
  showLegend(names) {
    /** @type {[string, string][]} */
    const curves = names.length > 1 ? names.map((name, i) => [name, styleOf(i)]) : [];
    this.legend.replaceChildren(
      ...[...curves, ["limit", "limit"]].map(([name, style]) => {
        const line = makeSvg("line", { class: `line ${style}`, x1: 0, x2: 28, y1: 5, y2: 5 });
        return make("span", {}, makeSvg("svg", { class: "chart", viewBox: "0 0 28 10" }, line), name);
      }),
    );
  }

  /** @param {State} state */
  reflect({ timed, playing, growing }) {
    this.timing.update();
    if (!timed || !this.fold.open) return;
    const { time, end } = timed;
    this.play.disabled = growing;
    this.play.dataset.playing = String(playing);
    write(this.play, playing ? "Pause" : "Play");
    this.slider.max = String(end);
    if (!this.slider.matches(":active")) this.slider.value = String(time);
    this.slider.setAttribute("aria-valuetext", secondsText(time, end));
    const [path] = this.timing.paths;
    for (const { chart } of this.shown) chart.show(time);
    if (!path) return;
    const state = path.timed.state(time);
    const values = this.shown.map(
      ({ quantity: { unit, curves } }) => `${curves.map(({ at }) => num(at(state))).join(", ")} ${unit}`,
    );
    write(this.readout, `${num(time)} of ${num(end)} s: ${values.join("; ")}`);
  }

  /** Lets a pointer on a chart choose the time. */
  scrub() {
    const move = (/** @type {PointerEvent} */ event) => {
      const picture = /** @type {Element} */ (event.target).closest("svg");
      const one = this.shown.find(({ chart }) => chart.picture === picture);
      if (!one || (event.type === "pointermove" && event.buttons === 0)) return;
      const time = one.chart.pointed(event, this.timing.period);
      if (time !== null) this.seek(time);
    };
    this.charts.addEventListener("pointerdown", move);
    this.charts.addEventListener("pointermove", move);
  }
}

/**
 * The greatest and least values of lines, in words.
 * @param {import("../../widgets/chart.js").Line[]} lines
 * @param {string[]} names
 */
function extremes(lines, names) {
  return lines
    .filter(({ isLevel }) => !isLevel)
    .map(({ points }, i) => {
      const values = points.map(([, value]) => value);
      const [least, most] = [Math.min(...values), Math.max(...values)];
      return `${names.length > 1 ? `${names[i]}: ` : ""}from ${num(least)} to ${num(most)}.`;
    })
    .join(" ");
}
