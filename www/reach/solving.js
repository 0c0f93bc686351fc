/**
 * Inverse kinematics to watch: each step is an iterate, each start leads to a solution or nowhere, and the solutions stay as ghosts.
 *
 * What tests may rely on: `#solve` carries `data-status`, `data-iterations`, `data-restarts`, `data-solutions`, `data-free`,
 * `data-error`, `data-verdict` (empty while it runs) and `data-fingerprint` (while it is not played).
 */
import { grouped, write } from "../planner/counters.js";
import { byId, make } from "../app/dom.js";
import { withSeed } from "../planner/settings/panel.js";
import { Options } from "../room/options.js";
import { Plot } from "../room/plot.js";
import { Transport } from "../room/transport.js";
import { Search } from "./search.js";
import { planLink } from "./plan-link.js";
import { MOST } from "./solving-picture.js";
import { small, solvingSentence } from "./solving-words.js";

/** @import { Library, ParameterInfo } from "../domain/types.js" */
/** @import { Bench, Change } from "./bench.js" */
/** @import { Settings } from "./search.js" */

/** Starts drawn in the chart at most: the first ones and the last. */
const CURVES = 40;
/** Points of each, about. */
const POINTS = 240;
/** Milliseconds between two drawings of the chart while it is played. */
const CHART = 120;
/** What a page wants that the core's defaults do not. */
const GIVEN = { solutions: 8, restarts: 40 };
const FIRST = new Set(["solutions", "free_only", "seed"]);

export class Solving {
  /** @param {Bench} bench @param {Library} library */
  constructor(bench, library) {
    this.bench = bench;
    this.methods = library.reachMethods();
    this.planners = library.planners();
    this.host = byId("solve", HTMLElement);
    /** @type {Search | null} */
    this.search = null;
    /** The pose that it starts from. @type {Float64Array} */
    this.start = new Float64Array();
    /** What differs from the defaults. @type {Settings} */
    this.given = { ...GIVEN };
    /** The arm that there was a run for, or would have been but for a refusal. @type {import("./arm.js").Arm | null} */
    this.of = null;
    /** What the link to the planner's page was made for. */
    this.linked = "";
    /** Does the notice say why there is no run? */
    this.isRefused = false;
    /** Its own poses are not taken for the reader's. */
    this.isOwn = false;
    this.drawn = -Infinity;
    /** The solution that the arm shows, -1: none. */
    this.chosen = -1;
    /** The sentence over the stage. @type {{ text: string, isBad: boolean } | null} */
    this.said = null;
    /** How near it can come, where the target is out of reach. @type {import("planarium").ReachVerdict["nearest"]} */
    this.nearest = null;
    /** @type {Options | null} */
    this.options = null;
    this.method = make("select", { id: "method", ariaLabel: "Method" });
    this.method.append(...this.methods.map(({ id, title }) => make("option", { value: id }, title)));
    this.method.value = "damped-least-squares";
    this.method.addEventListener("change", () => this.choose(this.method.value));
    this.summary = make("p", { className: "hint" });
    this.fields = make("div", {});
    this.listed = make("div", { className: "buttons", id: "solutions" });
    this.listed.setAttribute("role", "group");
    this.listed.setAttribute("aria-label", "Solutions");
    this.plan = make("a", { className: "plan-link", id: "plan", href: "./" }, "Plan to this target");
    byId("solve-settings", HTMLElement).append(this.method, this.summary, this.listed, make("p", {}, this.plan), this.fields);
    this.transport = new Transport(bench.room, this.host, {
      name: "solve", label: "Inverse kinematics", unit: "iterations", steps: [1, 10], slowest: 1, fastest: 2000, pace: 12,
      advance: (count) => this.advance(count), reset: () => this.begin(), canFinish: true,
    }, []);
    this.facts = make("dl", { className: "facts", id: "solve-facts" });
    this.cells = Object.fromEntries(["iterations", "starts", "error", "solutions"].map((name) => {
      const cell = make("dd", {});
      this.facts.append(make("div", {}, make("dt", {}, name), cell));
      return [name, cell];
    }));
    byId("facts", HTMLElement).before(this.facts);
    this.plot = new Plot("errors", "Error, m and rad", 150);
    byId("charts", HTMLElement).append(this.plot.element);
    bench.onChange((change) => this.hear(change));
    this.offer();
  }

  get isOn() { return this.bench.mode === "solve"; }

  /** @param {Change} change */
  hear(change) {
    const { isOn } = this;
    this.host.hidden = this.facts.hidden = byId("charts", HTMLElement).hidden = !isOn;
    if (!isOn) {
      if (this.transport.isPlaying) this.transport.pause();
      this.search?.free();
      this.search = this.of = null;
      return;
    }
    const { arm } = this.bench;
    // The reader has moved the arm, or it is another: it starts from there.
    if (this.isOwn || (this.of === arm && change !== "pose")) return;
    this.of = arm;
    this.start = Float64Array.from(arm.q);
    this.begin();
  }

  /** @param {string} method @param {Settings} [given] */
  choose(method, given) {
    if (this.methods.some(({ id }) => id === method)) this.method.value = method;
    if (given) this.given = given;
    this.offer();
    if (this.isOn) this.begin();
  }

  /** The fields of the method. */
  offer() {
    const info = this.methods.find(({ id }) => id === this.method.value) ?? this.methods[0];
    write(this.summary, info.summary);
    const table = withSeed(info.parameters).map((row) => (row.name in GIVEN ? { ...row, default: GIVEN[/** @type {keyof typeof GIVEN} */ (row.name)] } : row));
    this.options = new Options(this.fields, /** @type {ParameterInfo[]} */ (table), this.given, () => {
      this.given = this.options?.given ?? this.given;
      this.begin();
    }, "solve", (name) => FIRST.has(name));
  }

  /** A new run from the same pose. */
  begin() {
    const { bench, options } = this;
    this.search?.free();
    this.search = null;
    this.chosen = -1;
    const settings = options?.settings;
    if (!settings) return;
    try {
      this.search = new Search(bench.arm, { target: bench.target, orientation: bench.lock, start: this.start, method: this.method.value, settings });
      if (this.isRefused) bench.room.notice.hide();
      this.isRefused = false;
    } catch (error) {
      const { pointer = "", message = String(error) } = /** @type {{ pointer?: string, message?: string }} */ (error);
      this.isRefused = !options.refuse(pointer, message);
      if (this.isRefused) bench.room.notice.show("This cannot be solved.", error);
      this.tell();
      return;
    }
    this.pose(this.start);
    this.tell();
  }

  /** What a link need know: the pose that the run starts from, how far it has come, how it is asked. */
  get told() {
    return { start: this.start, steps: this.search?.run.iterations ?? 0, settings: { method: this.method.value, ...this.given } };
  }

  /** @param {number} count @returns {boolean} */
  advance(count) {
    const { search } = this;
    if (!search || search.status !== "running") return false;
    const goesOn = search.step(count);
    // At the end one of the solutions is shown, one that is free if there is any.
    this.chosen = goesOn || search.solutions.length === 0 ? -1 : Math.max(0, search.solutions.findIndex(({ isFree }) => isFree));
    this.pose(search.solutions[this.chosen]?.q ?? search.last.q);
    this.tell();
    return goesOn;
  }

  /** Shows one of the solutions. @param {number} index */
  look(index) {
    const solution = this.search?.solutions[index];
    if (!solution) return;
    this.transport.pause();
    this.chosen = index;
    this.pose(solution.q);
    this.tell();
  }

  /** @param {ArrayLike<number>} q */
  pose(q) {
    this.isOwn = true;
    this.bench.pose(q);
    this.isOwn = false;
  }

  /** What has come of it. */
  tell() {
    const { search, host, bench } = this;
    const { dataset } = host;
    const isRunning = search?.status === "running";
    this.transport.enable(isRunning);
    const free = search?.solutions.filter(({ isFree }) => isFree).length ?? 0;
    const count = search?.solutions.length ?? 0;
    const iterations = search?.run.iterations ?? 0;
    write(this.cells.iterations, grouped(iterations));
    write(this.cells.starts, grouped((search?.run.restarts ?? 0) + 1));
    write(this.cells.error, search ? small(search.last.error) : "\u2013");
    write(this.cells.solutions, count === 0 ? "none" : `${count}, ${free} free`);
    const verdict = search && (!isRunning || count > 0) ? search.run.verdict() : null;
    this.said = search ? solvingSentence(bench, search, verdict, {
      title: this.methods.find(({ id }) => id === this.method.value)?.title ?? "", wanted: Number(this.options?.settings?.solutions ?? count),
    }) : null;
    this.nearest = verdict?.nearest ?? null;
    Object.assign(dataset, {
      status: search?.status ?? "refused", iterations: String(iterations), restarts: String(search?.run.restarts ?? 0), solutions: String(count),
      free: String(free), error: String(search?.last.error ?? ""), verdict: isRunning ? "" : verdict?.verdict ?? "",
    });
    if (search && !this.transport.isPlaying) dataset.fingerprint = search.run.fingerprint();
    else delete dataset.fingerprint;
    this.list();
    const now = performance.now();
    if (!isRunning || !this.transport.isPlaying || now - this.drawn > CHART) {
      this.drawn = now;
      this.chart();
    }
    bench.tell("rest");
    void this.link();
  }

  /** Where the planner's page plans to this; a world that is too large for an address has no such link. */
  async link() {
    const { bench, start, plan } = this;
    const key = [bench.arm.version, start.join(), bench.target.join(), bench.lock].join(" ");
    if (this.linked === key) return;
    this.linked = key;
    const href = await planLink(bench, start, this.planners).catch(() => "");
    if (this.linked !== key) return;
    plan.hidden = href === "";
    plan.href = href;
  }

  /** A button for each solution. */
  list() {
    const { search } = this;
    const solutions = search?.solutions.slice(0, MOST) ?? [];
    while (this.listed.children.length > solutions.length) this.listed.lastElementChild?.remove();
    solutions.forEach(({ isFree }, i) => {
      let button = this.listed.children[i];
      if (!button) {
        button = make("button", { type: "button" });
        button.addEventListener("click", () => this.look(i));
        this.listed.append(button);
      }
      const text = `${i + 1}${isFree ? "" : " \u2715"}`;
      if (button.textContent !== text) button.textContent = text;
      button.setAttribute("aria-label", `Solution ${i + 1}${isFree ? "" : ", in collision"}`);
      button.setAttribute("aria-pressed", String(i === this.chosen));
    });
    this.listed.hidden = solutions.length === 0;
  }

  chart() {
    const { search, plot } = this;
    /** @type {Map<number, [number, number][]>} */
    const starts = new Map();
    search?.iterates.forEach(({ restart, error }, i) => {
      const points = starts.get(restart) ?? [];
      points.push([i, error]);
      starts.set(restart, points);
    });
    const all = [...starts.entries()];
    const shown = all.length > CURVES ? [...all.slice(0, CURVES / 2), ...all.slice(-CURVES / 2)] : all;
    const last = all.length - 1;
    const curves = shown.map(([restart, points]) => ({ label: "", points: thinned(points), className: restart === last ? "" : "faint" }));
    const summary = search ? `Error against iterations, logarithmic: ${grouped(search.iterates.length - 1)} iterations from ${all.length} ${all.length === 1 ? "start" : "starts"}; the last error is ${small(search.last.error)}.` : "No run.";
    plot.draw(curves, { title: "iterations", low: 0, high: 10 }, { title: "error", isLog: true, low: 1e-3, high: 1 }, summary);
  }
}

/** Some of many points, the last among them. @param {[number, number][]} points */
function thinned(points) {
  const each = Math.ceil(points.length / POINTS);
  return points.filter((_, i) => i % each === 0 || i === points.length - 1);
}
