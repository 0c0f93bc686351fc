/**
 * Inverse kinematics step by step: its settings, transport, numbers and chart.
 *
 * For tests: `#solve` carries `data-status`, `data-iterations`, `data-restarts`, `data-solutions`, `data-free`, `data-error`,
 * `data-verdict` (empty while it runs) and `data-fingerprint` (while it does not play).
 */
import { withSeed } from "../widgets/field.js";
import { planners, reachMethods } from "planarium";
import { Chart } from "../widgets/chart.js";
import { byId, grouped, make } from "../app/dom.js";
import { encodeLink } from "../planner/link/codec.js";
import { button, press } from "../widgets/elements.js";
import { small } from "../widgets/format.js";
import { Options } from "../widgets/options.js";
import { Transport } from "../widgets/transport.js";
import { IkRun } from "./ik-run.js";
import { ikSentence } from "./words.js";

/** @import { ParameterInfo } from "../domain/types.js" */
/** @import { ArmSession, Change } from "./session.js" */
/** @import { Settings } from "./ik-run.js" */
/** @import { Sentence } from "./words.js" */

/** Curves of the chart, at most: the first and the last. */
const CURVES = 40;
/** Milliseconds between two drawings of the chart while it plays. */
const CHART_PAUSE = 120;
/** The page's defaults where the core's are others. @type {Settings} */
const DEFAULTS = { solutions: 8, restarts: 40 };

export class IkPanel {
  /** @param {ArmSession} session */
  constructor(session) {
    this.session = session;
    this.methods = reachMethods();
    /** The planner of the link: one that grows two trees. */
    this.planner = (planners().find(({ grows }) => grows === "trees") ?? planners()[0]).id;
    this.host = byId("solve", HTMLElement);
    /** @type {IkRun | null} */
    this.run = null;
    /** Where the run starts. @type {Float64Array} */
    this.start = new Float64Array();
    /** Was a run begun, or refused, since the mode was chosen? */
    this.isBegun = false;
    /** What differs from the defaults. @type {Settings} */
    this.given = {};
    /** The index of the solution that the arm shows, or -1. */
    this.chosen = -1;
    /** @type {Sentence | null} */
    this.sentence = null;
    /** The nearest point, if the target is out of reach. @type {import("planarium").ReachVerdict["nearest"]} */
    this.nearest = null;
    this.charted = -Infinity;
    this.select = byId("method", HTMLSelectElement);
    this.select.append(...this.methods.map(({ id, title }) => make("option", { value: id }, title)));
    this.select.value = "damped-least-squares";
    this.select.addEventListener("change", () => this.choose(this.select.value));
    this.list = byId("solutions", HTMLElement);
    this.plan = byId("plan", HTMLAnchorElement);
    this.options = new Options(byId("method-options", HTMLElement), [], {}, () => {});
    this.transport = new Transport(session.app, this.host, {
      name: "solve", label: "Inverse kinematics", unit: "iterations", steps: [1, 10], slowest: 1, fastest: 2000, pace: 12,
      advance: (count) => this.advance(count), reset: () => this.begin(), canFinish: true,
    });
    this.chart = new Chart("errors", "Error, m and rad", { height: 150 });
    byId("charts", HTMLElement).append(this.chart.element);
    session.onChange((change) => this.follow(change));
    this.buildOptions();
  }

  get isOn() { return this.session.mode === "solve"; }

  get method() { return this.methods.find(({ id }) => id === this.select.value) ?? this.methods[0]; }

  /** @param {Change} change */
  follow(change) {
    if (!this.isOn) {
      if (this.transport.isPlaying) this.transport.pause();
      this.run?.free();
      this.run = this.sentence = null;
      this.isBegun = false;
    } else if (change === "arm" || change === "pose" || !this.isBegun) {
      // The user moved the arm, or changed it: the run starts there.
      this.isBegun = true;
      this.start = Float64Array.from(this.session.arm.q);
      this.begin();
    }
  }

  /** @param {string} method @param {Settings} [given] */
  choose(method, given = this.given) {
    if (this.methods.some(({ id }) => id === method)) this.select.value = method;
    this.given = given;
    this.buildOptions();
    if (this.isOn) this.begin();
  }

  buildOptions() {
    const { method: { summary, parameters }, session: { app } } = this;
    app.write({ "method-summary": summary });
    const table = withSeed(parameters).map((row) => ({ ...row, default: DEFAULTS[row.name] ?? row.default }));
    this.options = new Options(byId("method-options", HTMLElement), /** @type {ParameterInfo[]} */ (table), this.given, () => {
      this.given = this.options.given;
      this.begin();
    }, { prefix: "solve", first: ["solutions", "free_only", "seed"] });
  }

  /** Starts a run. */
  begin() {
    const { session, options, method: { id }, start } = this;
    const { target, orientation, app: { notice } } = session;
    this.run?.free();
    this.run = null;
    this.chosen = -1;
    const { settings } = options;
    if (!settings) return;
    try {
      this.run = new IkRun(session.arm, { target, orientation, start, method: id, settings });
      notice.hide();
    } catch (error) {
      const { pointer = "", message = String(error) } = /** @type {{ pointer?: string, message?: string }} */ (error);
      if (!options.refuse(pointer, message)) notice.show("Inverse kinematics cannot run.", error);
    }
    if (this.run) session.moveTo(start, "iterate");
    void this.link();
    this.update();
  }

  /** Iterations made, and what a link stores of the settings. */
  get state() {
    return { steps: this.run?.run.iterations ?? 0, settings: { method: this.method.id, ...this.given } };
  }

  /** @param {number} count @returns {boolean} whether there is more */
  advance(count) {
    const { run, session } = this;
    if (!run?.isRunning) return false;
    run.step(count);
    // At the end a solution is shown, a collision-free one if there is any.
    this.chosen = run.isRunning || run.solutions.length === 0 ? -1 : Math.max(0, run.solutions.findIndex(({ isFree }) => isFree));
    session.moveTo(run.solutions[this.chosen]?.q ?? run.last.q, "iterate");
    this.update();
    return run.isRunning;
  }

  /** Shows a solution. @param {number} index */
  show(index) {
    if (!this.run) return;
    this.transport.pause();
    this.chosen = index;
    this.session.moveTo(this.run.solutions[index].q, "iterate");
    this.update();
  }

  /** Shows the state of the run. */
  update() {
    const { run, host, session, transport } = this;
    const isRunning = run?.isRunning ?? false;
    const [count, free, iterations, restarts] = run ? [run.solutions.length, run.freeCount, run.run.iterations, run.run.restarts] : [0, 0, 0, 0];
    const verdict = run && (!isRunning || count > 0) ? run.run.verdict() : null;
    transport.enable(isRunning);
    session.app.write({
      "fact-iterations": grouped(iterations), "fact-starts": grouped(restarts + 1), "fact-error": run ? small(run.last.error) : "\u2013",
      "fact-solutions": count === 0 ? "none" : `${count} (${free} free)`,
    });
    this.sentence = run && ikSentence(session, run, verdict, this.method);
    this.nearest = verdict?.nearest ?? null;
    Object.assign(host.dataset, {
      status: run?.status ?? "refused", iterations, restarts, solutions: count, free, error: run?.last.error ?? "", verdict: isRunning ? "" : verdict?.verdict ?? "",
    });
    if (run && !transport.isPlaying) host.dataset.fingerprint = run.run.fingerprint();
    else delete host.dataset.fingerprint;
    this.listSolutions();
    const now = performance.now();
    if (!transport.isPlaying || now - this.charted > CHART_PAUSE) {
      this.charted = now;
      this.drawChart();
    }
    session.update("rest");
  }

  /** A button for each solution. */
  listSolutions() {
    const solutions = this.run?.shown ?? [];
    // Buttons are rebuilt only if they differ, so that the focus stays.
    const key = solutions.map(({ isFree }) => Number(isFree)).join("");
    if (this.list.dataset.key !== key) {
      this.list.dataset.key = key;
      this.list.replaceChildren(...solutions.map(({ isFree }, i) => Object.assign(button("", `${i + 1}${isFree ? "" : " \u2715"}`, () => this.show(i)), {
        ariaLabel: `Solution ${i + 1}${isFree ? "" : ", in collision"}`,
      })));
    }
    [...this.list.children].forEach((element, i) => press(element, i === this.chosen));
    this.list.hidden = solutions.length === 0;
  }

  drawChart() {
    const { run, chart } = this;
    const all = run?.curves() ?? [];
    const shown = all.length > CURVES ? [...all.slice(0, CURVES / 2), ...all.slice(-CURVES / 2)] : all;
    const lines = shown.map((points) => ({ label: "", points, className: points === all[all.length - 1] ? "" : "faint" }));
    const summary = run ? `Error against iterations, logarithmic: ${grouped(run.iterates.length - 1)} iterations from ${all.length} ${all.length === 1 ? "start" : "starts"}; the last error is ${small(run.last.error)}.` : "No run.";
    chart.draw(lines, { title: "iterations", low: 0, high: 10 }, { title: "error", isLog: true, low: 1e-3, high: 1 }, summary);
  }

  /** Links the planner's page with this target; a world too large for a link has none. */
  async link() {
    const { session, start, plan, planner: algorithm, run } = this;
    const document = /** @type {Record<string, unknown>} */ ({ ...session.arm.document, queries: [session.targetQuery(start)] });
    const href = await encodeLink({ version: 1, document, lanes: [{ algorithm, settings: {} }], iteration: 0, view: {} }).then((fragment) => `./#${fragment}`, () => "");
    if (run !== this.run) return;
    plan.hidden = href === "";
    plan.href = href;
  }
}
