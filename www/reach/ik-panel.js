/**
 * Inverse kinematics step by step: its settings, transport, numbers and chart.
 *
 * For tests: `#solve` carries `data-status`, `data-iterations`, `data-solutions`, `data-free`, `data-verdict` (empty
 * while it runs) and `data-fingerprint` (while it does not play).
 */
import { withSeed } from "../widgets/field.js";
import { planners, reachMethods } from "planarium/full";
import { Chart } from "../widgets/chart.js";
import { byId, grouped, make } from "../app/dom.js";
import { pacer } from "../app/paced.js";
import { encodeLink } from "../planner/link/codec.js";
import { button, press } from "../widgets/elements.js";
import { small } from "../widgets/format.js";
import { Options } from "../widgets/options.js";
import { Course } from "../widgets/course.js";
import { DEFAULTS, IkRun } from "./ik-run.js";

/** @import { ParameterInfo, Settings } from "../domain/types.js" */
/** @import { ReachSession } from "./session.js" */

/** Curves of the chart, at most: the first and the last. */
const CURVES = 40;
/** Milliseconds between two drawings of the chart while it plays. */
const CHART_PAUSE = 120;

export class IkPanel {
  /** @param {ReachSession} session */
  constructor(session) {
    this.session = session;
    this.methods = reachMethods();
    this.host = byId("solve", HTMLElement);
    /** The configuration at which the run starts. */
    this.start = session.robot.q;
    /** The configuration that this panel has set: with another one the run starts again. @type {unknown} */
    this.shown = null;
    /** The settings that differ from the defaults. @type {Settings} */
    this.given = {};
    this.isChartDue = pacer(CHART_PAUSE);
    this.select = byId("method", HTMLSelectElement);
    this.select.append(...this.methods.map(({ id, title }) => make("option", { value: id }, title)));
    this.select.value = "damped-least-squares";
    this.select.addEventListener("change", () => this.choose(this.select.value));
    this.list = byId("solutions", HTMLElement);
    this.options = this.form();
    this.course = new Course(session.app, this.host, {
      name: "solve",
      label: "Inverse kinematics",
      unit: "iterations",
      steps: [1, 10],
      slowest: 1,
      fastest: 2000,
      pace: 12,
      advance: (count) => this.advance(count),
      reset: () => this.begin(),
      canFinish: true,
    });
    this.chart = new Chart("errors", "Error, m and rad", { height: 150 });
    byId("charts", HTMLElement).append(this.chart.element);
    session.app.onShow(() => this.show());
  }

  get isOn() {
    return this.session.mode === "solve";
  }

  get method() {
    return this.methods.find(({ id }) => id === this.select.value) ?? this.methods[0];
  }

  /** Follows the mode and the arm: where the user has moved or changed it, the run starts there. */
  follow() {
    const { robot } = this.session;
    if (!this.isOn) {
      if (this.course.isPlaying) this.course.pause();
      this.drop();
      this.shown = null;
    } else if (this.shown !== robot.q) {
      this.start = robot.q;
      this.begin();
    }
  }

  /** @param {string} method @param {Settings} [given] */
  choose(method, given = this.given) {
    if (this.methods.some(({ id }) => id === method)) this.select.value = method;
    this.given = given;
    this.options = this.form();
    if (this.isOn) this.begin();
  }

  /** The options of the method as a form. */
  form() {
    const { summary, parameters } = this.method;
    const { app } = this.session;
    app.write({ "method-summary": summary });
    const table = /** @type {ParameterInfo[]} */ (
      withSeed(parameters).map((row) => ({ ...row, default: DEFAULTS[row.name] ?? row.default }))
    );
    return new Options(
      byId("method-options", HTMLElement),
      table,
      this.given,
      () => {
        this.given = this.options.given;
        this.begin();
      },
      { prefix: "solve", first: ["solutions", "free_only", "seed"] },
    );
  }

  drop() {
    this.session.run?.free();
    Object.assign(this.session, { run: null, chosen: -1 });
  }

  /** Starts a run. */
  begin() {
    const { session, start } = this;
    const { robot, target, orientation } = session;
    const { notice } = session.app;
    const { settings } = this.options;
    this.drop();
    if (!settings) return;
    try {
      session.run = new IkRun(robot, { target, orientation, start, method: this.method, settings });
      notice.hide();
    } catch (error) {
      const { pointer = "", message = String(error) } = /** @type {{ pointer?: string, message?: string }} */ (error);
      if (!this.options.refuse(pointer, message)) notice.show("Inverse kinematics cannot run.", error);
    }
    if (session.run) session.moveTo(start);
    this.shown = session.robot.q;
    void this.link();
    session.app.changed();
  }

  /** @param {number} count @returns {boolean} whether there is more */
  advance(count) {
    this.follow();
    const { run } = this.session;
    if (!run?.isRunning) return false;
    run.step(count);
    const { index, q } = run.pose;
    this.choosePose(index, q);
    return run.isRunning;
  }

  /** Moves the arm to a solution, or with the index -1 to an iterate. @param {number} index @param {Float64Array} q */
  choosePose(index, q) {
    const { session } = this;
    session.chosen = index;
    session.moveTo(q);
    this.shown = session.robot.q;
  }

  /** Shows the state of the run. */
  show() {
    this.follow();
    if (!this.isOn) return;
    const { host, session, course } = this;
    const { run } = session;
    const isRunning = run?.isRunning ?? false;
    const [count, free, iterations, restarts] = run
      ? [run.solutions.length, run.freeCount, run.run.iterations, run.run.restarts]
      : [0, 0, 0, 0];
    course.enable(isRunning);
    session.app.write({
      "fact-iterations": grouped(iterations),
      "fact-starts": grouped(restarts + 1),
      "fact-error": run ? small(run.last.error) : "\u2013",
      "fact-solutions": count === 0 ? "none" : `${count} (${free} free)`,
    });
    Object.assign(host.dataset, {
      status: run?.run.status ?? "refused",
      iterations,
      solutions: count,
      free,
      verdict: isRunning ? "" : (run?.verdict?.verdict ?? ""),
    });
    if (run && !course.isPlaying) host.dataset.fingerprint = run.run.fingerprint();
    else delete host.dataset.fingerprint;
    this.listSolutions();
    if (this.isChartDue(!course.isPlaying)) this.drawChart();
  }

  /** A button for each solution. */
  listSolutions() {
    const { run, chosen } = this.session;
    const solutions = run?.shown ?? [];
    const titles = solutions.map(({ isFree }, i) => `${i + 1}${isFree ? "" : " \u2715"}`);
    // Buttons are rebuilt only if they differ, so that the focus stays.
    if (titles.join() !== [...this.list.children].map(({ textContent }) => textContent).join()) {
      this.list.replaceChildren(
        ...solutions.map(({ isFree, q }, i) =>
          button(
            "",
            titles[i],
            () => {
              this.course.pause();
              this.choosePose(i, q);
            },
            { ariaLabel: `Solution ${i + 1}${isFree ? "" : ", in collision"}` },
          ),
        ),
      );
    }
    [...this.list.children].forEach((element, i) => press(element, i === chosen));
    this.list.hidden = solutions.length === 0;
  }

  drawChart() {
    const { chart } = this;
    const { run } = this.session;
    const all = run?.curves() ?? [];
    const shown = all.length > CURVES ? [...all.slice(0, CURVES / 2), ...all.slice(-CURVES / 2)] : all;
    const lines = shown.map((points) => ({
      label: "",
      points,
      className: points === all[all.length - 1] ? "" : "faint",
    }));
    const summary = run
      ? `Error against iterations, logarithmic: ${grouped(run.iterates.length - 1)} iterations from ${all.length} ${all.length === 1 ? "start" : "starts"}; the last error is ${small(run.last.error)}.`
      : "No run.";
    chart.draw(
      lines,
      { title: "iterations", low: 0, high: 10 },
      { title: "error", isLog: true, low: 1e-3, high: 1 },
      summary,
    );
  }

  /**
   * Links the planner's page with this target, for a planner that grows two trees; a world too large for a link has
   * none.
   */
  async link() {
    const { session, start } = this;
    const { run } = session;
    const algorithm = planners().find(({ grows }) => grows === "trees")?.id ?? "";
    const document = /** @type {Record<string, unknown>} */ ({
      ...session.robot.document,
      queries: [session.targetQuery(start)],
    });
    const href = await encodeLink({
      version: 1,
      document,
      lanes: [{ algorithm, settings: {} }],
      iteration: 0,
      view: {},
    }).then(
      (fragment) => `plan.html#${fragment}`,
      () => "",
    );
    if (run === session.run) Object.assign(byId("plan", HTMLAnchorElement), { href, hidden: href === "" });
  }
}
