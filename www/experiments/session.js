/**
 * The state of the page: a document, how its rows are shown, what the core says of it, and the rows so far. A changed
 * document is checked by the core before any trial, and begins without rows.
 */
import { grouped } from "../app/dom.js";
import { Observable } from "../app/observable.js";
import { Jobs, isLost } from "../app/pool.js";
import { errorInfo } from "../app/error-info.js";
import { planners, generators } from "planarium/full";
import { ceilingOf, tasksOf } from "./ceiling.js";
import { completed } from "./charts.js";
import { factorsOf, nameOfColumn } from "./factors.js";
import { USUAL, allMeasures, commonUnit } from "./measures.js";
import { MOST, Rows } from "./rows.js";
import { Queue, TrialPool } from "./pool.js";
import { retitled, shaped } from "./ready.js";
import { lengthUnits, resolved, robotsOf, titleOf, worldOfTrial } from "./worlds.js";

/** @import { App } from "../app/app.js" */
/** @import { ExperimentDocument } from "planarium/full" */
/** @import { ErrorInfo } from "../app/error-info.js" */
/** @import { Info } from "./commands.js" */
/** @import { LinkedDocument } from "../domain/types.js" */
/** @import { ExperimentState, View } from "./link.js" */
/** @import { ExperimentWorker } from "./pool.js" */

/** Worlds that are certified, at most. */
const MOST_CERTIFIED = 400;

/** @typedef {"document" | "checked" | "view" | "rows" | "phase"} Change */
/** @typedef {"checking" | "refused" | "ready" | "running" | "pausing" | "paused" | "failed" | "done"} Phase */

/** @extends {Observable<Change>} */
export class ExperimentSession extends Observable {
  /** @param {App} app @param {ExperimentWorker} worker */
  constructor(app, worker) {
    super(app);
    this.pool = new TrialPool(worker, () => /** @type {ExperimentWorker} */ (app.hire()));
    /** @type {LinkedDocument} */
    this.document = { format: "planarium-experiment-1", worlds: [], planners: [], seeds: [0] };
    /** @type {View} */
    this.view = {};
    /** The document as the core has read it. @type {ExperimentDocument | null} */
    this.resolved = null;
    /** @type {Info | null} */
    this.info = null;
    /** The trials that have ended, and the others. */
    this.queue = new Queue(null, new Rows([], 0), 1);
    /** @type {import("./factors.js").Factor[]} */
    this.factors = [];
    /** The units of lengths by the names of worlds. @type {Map<string, string>} */
    this.units = new Map();
    /** How many trials can be solved, once all have ended. @type {import("./ceiling.js").Ceiling | null} */
    this.ceiling = null;
    /** Worlds whose certificates are still to come. */
    this.uncertified = 0;
    /** The types of robots of the worlds; none where they are not known. @type {import("./worlds.js").Robot[]} */
    this.robots = [];
    /** @type {Phase} */
    this.phase = "checking";
    /** @type {ErrorInfo | null} */
    this.refusal = null;
    /** The run under way, and what pauses it. @type {Promise<void>} */
    this.running = Promise.resolve();
    this.pausing = new AbortController();
    /** Stops whatever is under way for this document: a check, a run, or certificates. */
    this.stopping = new AbortController();
    /** Milliseconds that trials have run, and when they were started or went on. */
    this.elapsed = 0;
    this.since = 0;
    const tables = {
      planner: planners().map(({ parameters }) => parameters),
      world: generators().map(({ options }) => options),
    };
    /** The title and the unit of a parameter, by its column. @type {import("./factors.js").Naming} */
    this.naming = (column) => {
      const [prefix, name] = column.split(".");
      const info = tables[/** @type {"planner" | "world"} */ (prefix)].flat().find((one) => one.name === name);
      const [title, own] = [info?.title ?? "", nameOfColumn(column)];
      return { title: title.toLowerCase() === own ? own : title ? `${title} (${own})` : own, unit: info?.unit ?? "" };
    };
  }

  get rows() {
    return this.queue.rows;
  }

  /** All measures, shares first. @returns {string[]} */
  get measures() {
    return allMeasures(this.info?.columns ?? []).filter((id) => id !== "cost" || this.hasCost);
  }

  /** The unit of lengths: empty where they have none, and where they have several. */
  get unit() {
    return commonUnit(this.units) ?? "";
  }

  /** Whether paths have a cost beside their length. */
  get hasCost() {
    return (this.resolved?.planners ?? []).some(({ set, vary }) => "clearance_weight" in { ...set, ...vary });
  }

  /** The measures that the document asks for. @returns {string[]} */
  get asked() {
    return this.document.measures ?? USUAL;
  }

  get isBusy() {
    return this.phase === "running" || this.phase === "pausing";
  }

  /** Opens an experiment. @param {ExperimentState} state @returns {Promise<boolean>}  whether it is accepted */
  open({ document, view }) {
    this.document = shaped(document);
    this.view = view;
    this.update("document");
    return this.check(document);
  }

  /**
   * Changes the document.
   * @param {LinkedDocument} document
   * @param {boolean} [isForm]  whether its form must be made again
   */
  edit(document, isForm = false) {
    // As it is in a file: without entries that are undefined.
    const text = JSON.stringify(document);
    const isChanged = text !== JSON.stringify(this.document);
    if (isChanged)
      this.document = JSON.parse(JSON.stringify({ ...JSON.parse(text), title: retitled(this.document, document) }));
    if (isForm) this.update("document");
    if (isChanged) void this.app.track(this.check());
  }

  /** @param {View} view  the changes */
  show(view) {
    this.view = { ...this.view, ...view };
    this.update("view");
  }

  /** What is shown. */
  get shown() {
    return completed(this.view, this.factors, this.asked, this.measures);
  }

  /** The reader's caption of what is shown, or empty. */
  get caption() {
    return this.view.captions?.find(({ measure }) => measure === this.shown.subject)?.text ?? "";
  }

  set caption(text) {
    const { subject: measure } = this.shown;
    const others = (this.view.captions ?? []).filter((one) => one.measure !== measure);
    const captions = text ? [...others, { measure, text }] : others;
    this.show({ captions: captions.length > 0 ? captions : undefined });
  }

  /** Stops what is under way. @returns {AbortSignal}  of what comes next */
  begin() {
    this.stopping.abort();
    this.pausing.abort();
    this.stopping = new AbortController();
    return this.stopping.signal;
  }

  /**
   * Lets the core check the document; rows are dropped.
   * @param {LinkedDocument} [given]  as it was opened
   * @returns {Promise<boolean>}
   */
  async check(given = this.document) {
    const signal = this.begin();
    this.refusal = this.info = this.resolved = this.ceiling = null;
    this.queue = new Queue(null, new Rows([], 0), 1);
    this.factors = [];
    this.setPhase("checking");
    try {
      const document = await resolved(given);
      if (signal.aborted) return false;
      this.robots = robotsOf(shaped(document));
      const info = await this.pool.open(document);
      if (signal.aborted) return false;
      if (info.trialCount > MOST) {
        const message = `these are ${grouped(info.trialCount)} trials; the page runs ${grouped(MOST)} at most, and \u201cplanarium sweep\u201d any number`;
        throw Object.assign(new Error(message), { code: "too-large" });
      }
      Object.assign(this, {
        resolved: document,
        info,
        units: lengthUnits(document),
        // Files of the site are known by their names.
        factors: factorsOf(
          document,
          this.naming,
          this.document.worlds.map((world) => ("scene" in world ? titleOf(world) : undefined)),
        ),
      });
      this.clear();
      this.update("checked");
      return true;
    } catch (error) {
      if (signal.aborted) return false;
      this.refusal = errorInfo(error);
      this.setPhase("refused");
      this.update("checked");
      return false;
    }
  }

  /** Begins without rows. */
  clear() {
    const { columns = [], trialCount = 0, fingerprint } = this.info ?? {};
    this.queue = new Queue(this.resolved, new Rows(columns, trialCount, fingerprint), this.pool.most);
    this.elapsed = this.uncertified = 0;
    this.refusal = this.ceiling = null;
    this.setPhase("ready");
  }

  /** @param {Phase} phase */
  setPhase(phase) {
    this.phase = phase;
    this.update("phase");
  }

  /** Runs the trials that have not ended. @returns {Promise<void>} */
  async start() {
    if (!["ready", "paused", "failed"].includes(this.phase)) return;
    const { signal } = this.stopping;
    this.refusal = null;
    this.since = performance.now();
    this.pausing = new AbortController();
    this.setPhase("running");
    this.running = this.pool.runTrials(this.queue, this.pausing.signal, () => {
      if (!signal.aborted) this.update("rows");
    });
    try {
      await this.running;
      if (signal.aborted) return;
      this.halt(this.rows.done === this.rows.count ? "done" : "paused");
      if (this.phase === "done") await this.certify(signal);
    } catch (error) {
      if (signal.aborted) return;
      this.refusal = errorInfo(error);
      this.halt("failed");
      throw error;
    }
  }

  /** Asks for a certificate of each world in which no trial found a path. @param {AbortSignal} signal */
  async certify(signal) {
    const { resolved: document, rows } = this;
    if (!document) return;
    const tasks = tasksOf(rows, document);
    /** @type {Map<number, import("./ceiling.js").Verdict>} */
    const verdicts = new Map();
    const open = tasks.filter(({ hasPath }) => !hasPath).slice(0, MOST_CERTIFIED);
    this.uncertified = open.length;
    await this.pool.run(new Jobs(open), signal, async (worker, { key, trials: [trial] }) => {
      const query = String(rows.cell(trial, "query"));
      const verdict = await worker.certify(worldOfTrial(document, rows, trial), query).catch(unknown);
      if (signal.aborted) return;
      verdicts.set(key, verdict);
      this.uncertified--;
      this.update("phase");
    });
    if (signal.aborted) return;
    this.ceiling = ceilingOf(tasks, verdicts);
    this.update("rows");
  }

  /** Another title, which is no part of the trials: they stay. @param {string} title */
  rename(title) {
    const { title: _, ...rest } = this.document;
    this.document = title ? { ...rest, title } : rest;
    if (this.resolved) Object.assign(this.resolved, { title: title || "Experiment" });
    if (this.info) this.info.title = title;
    this.update("view");
  }

  /** @param {Phase} phase */
  halt(phase) {
    this.elapsed += performance.now() - this.since;
    this.setPhase(phase);
    this.update("rows");
  }

  /** Pauses; trials that run now are continued later. */
  async pause() {
    if (this.phase !== "running") return;
    this.pausing.abort();
    this.setPhase("pausing");
    await this.running.catch(() => {});
  }

  /** Stops, and drops the rows. */
  discard() {
    if (!this.info) return;
    this.begin();
    this.clear();
    this.update("rows");
  }

  /** Milliseconds that trials have run. */
  get runtime() {
    return this.elapsed + (this.isBusy ? performance.now() - this.since : 0);
  }
}

/** The verdict where the core fails. @param {unknown} error @returns {"unknown"} */
function unknown(error) {
  if (isLost(error)) throw error;
  return "unknown";
}
