/**
 * The state of the page: a robot, a list of its configurations, a target and a query. Lists and results come from the
 * worker; only the newest query counts.
 */
import { Scenario } from "planarium";
import { wrap } from "planarium/draw";
import { coalesced, latest } from "../app/work.js";
import { coordinatesOf, fitted } from "../domain/coordinates.js";
import { isPlaced } from "../domain/names.js";

/** @import { App } from "../app/app.js" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { IndexId, NeighboursFound } from "planarium" */
/** @import { Part, ScenarioDocument, Settings } from "../domain/types.js" */
/** @import { Commands, List } from "./commands.js" */
/** @import { RobotEntry } from "./robots.js" */

/** @typedef {{ name: string, rows: number[][] }} OwnList   from a file: its name, and configurations */
/**
 * @typedef {[translation: number, rotation: number]} Weights   of a metre and of a radian in the distance of two
 *   placements
 */

/** Robots drawn, at most; and up to how many each has its outline and its reference point. */
export const DRAWN = 400;
export const FEW = 20;
/** The core's weights of a body without a metric. @type {Weights} */
const USUAL = [0.7, 0.3];

/** @type {List} */
const EMPTY = { rows: new Float64Array(), tips: new Float64Array() };
/** @type {NeighboursFound} */
const NOTHING = { indices: new Uint32Array(), distances: new Float64Array(), visited: 0 };

export class NeighbourSession {
  /** @param {App} app @param {Remote<Commands>} worker @param {RobotEntry} entry */
  constructor(app, worker, entry) {
    this.app = app;
    this.worker = worker;
    this.entry = entry;
    /** The entry's document, with the weights below. */
    this.document = entry.document;
    /** Weights of the metric of a body or a car, in place of the scenario's. @type {Weights | null} */
    this.ownWeights = null;
    this.scenario = Scenario.parse(entry.document);
    this.coordinates = coordinatesOf(this);
    this.sampling = { n: 500, seed: 0, free: true };
    /** The name of the file, if the list was not sampled. @type {string | null} */
    this.file = null;
    /** @type {List} */
    this.list = EMPTY;
    /** Whether a list is awaited. */
    this.isLoading = false;
    /** The parts of the first robots of the list. @type {Part[][]} */
    this.footprints = [];
    this.q = this.fitted(entry.q);
    this.k = entry.k;
    /** @type {IndexId} */
    this.index = "kd-tree";
    /** Options of the indexes. @type {Settings} */
    this.given = {};
    /** Whether the target and its neighbours are shown, or the list alone. */
    this.isAsking = true;
    this.found = NOTHING;
    /** The true neighbours. @type {Set<number>} */
    this.exact = new Set();
    /** Whether these are the neighbours for the query. */
    this.isFound = false;
  }

  get dimension() {
    return this.coordinates.length;
  }
  get count() {
    return this.list.rows.length / this.dimension;
  }
  get isArm() {
    return this.document.robot.type === "arm";
  }
  get isPlanar() {
    return this.isArm && this.dimension === 2;
  }
  /**
   * The angle at which the query cuts circles open: 0 in the naive metric, pi in a kd-tree that does not wrap; null if
   * angles wrap.
   * @returns {number | null}
   */
  get cut() {
    if (this.given.metric === "naive") return 0;
    return this.index === "kd-tree-unwrapped" && this.coordinates.some(({ isCircle }) => isCircle) ? Math.PI : null;
  }
  get isPlaced() {
    return isPlaced(this.scenario.robot);
  }

  /** The weights of the metric of a body or a car. @returns {Weights} */
  get weights() {
    return this.ownWeights ?? weightsOf(this.document) ?? USUAL;
  }

  /** The list, if it is from a file. @returns {OwnList | null} */
  get ownList() {
    return this.file === null
      ? null
      : { name: this.file, rows: Array.from({ length: this.count }, (_, i) => [...this.row(i)]) };
  }

  /** A configuration of the list. @param {number} i */
  row(i) {
    return this.list.rows.subarray(i * this.dimension, (i + 1) * this.dimension);
  }

  /** True neighbours that were not found. @returns {number[]} */
  get missed() {
    const found = new Set(this.found.indices);
    return [...this.exact].filter((i) => !found.has(i));
  }

  /**
   * @param {RobotEntry} entry
   * @param {{ q?: ArrayLike<number>, k?: number, weights?: Weights | null, list?: OwnList | null }} [query]
   * @returns {Promise<void>}
   * @throws {Error} the core refuses the scenario or the weights
   */
  open(entry, { q = entry.q, k = entry.k, weights = null, list = null } = {}) {
    this.setWorld(entry, weights);
    Object.assign(this, { k, coordinates: coordinatesOf(this) });
    this.setList(EMPTY);
    if (!this.isArm) delete this.given.metric;
    this.q = this.fitted(q.length > 0 ? q : this.coordinates.map(({ low, high }) => (low + high) / 2));
    this.file = null;
    return list ? this.readOrSample(list) : this.sample();
  }

  /** Takes a list; where the core refuses it, one is sampled. @param {OwnList} list */
  async readOrSample({ name, rows }) {
    await this.read(name, new TextEncoder().encode(JSON.stringify(rows)));
    if (this.count === 0 && !this.isLoading) await this.sample();
  }

  /**
   * @param {RobotEntry} entry
   * @param {Weights | null} weights
   * @throws {Error} the core refuses them, and nothing changes
   */
  setWorld(entry, weights) {
    const document = weights ? weighted(entry.document, weights) : entry.document;
    const scenario = Scenario.parse(document);
    this.scenario.free();
    Object.assign(this, { scenario, entry, document, ownWeights: weights });
  }

  /**
   * Weighs metres and radians, for the same list.
   * @param {Weights} weights
   * @throws {Error} the core refuses them, and nothing changes
   */
  weigh(weights) {
    this.setWorld(this.entry, weights);
    if (this.count === 0 || (this.isLoading && this.file === null)) return this.sample();
    return this.receive((signal) => this.worker.reopen(this.document, signal), this.file);
  }

  /** @param {Partial<NeighbourSession["sampling"]>} [changes] */
  sample(changes = {}) {
    this.sampling = { ...this.sampling, ...changes };
    this.file = null;
    const from = (/** @type {AbortSignal} */ signal) => this.worker.sample(this.document, this.sampling, signal);
    return this.receive(from, null, "No configurations could be sampled.");
  }

  /** Reads a list from a file. @param {string} name @param {Uint8Array} bytes */
  read(name, bytes) {
    return this.receive(
      (signal) => this.worker.read(this.document, name, bytes, signal),
      name,
      `${name} could not be read as a list of configurations.`,
    );
  }

  /**
   * Receives a list, unless another one is asked for meanwhile, and finds the neighbours.
   * @param {(signal: AbortSignal) => Promise<List>} from
   * @param {string | null} file
   * @param {string} [title]  of an error
   */
  async receive(from, file, title) {
    await this.app.track(this.load(from, file), title);
    await this.search();
  }

  /** Where a list is refused, the one before stays. */
  load = latest(
    async (signal, /** @type {(signal: AbortSignal) => Promise<List>} */ from, /** @type {string | null} */ file) => {
      this.isLoading = true;
      this.isFound = false;
      this.app.changed();
      try {
        const list = await from(signal);
        this.file = file;
        this.setList(list);
      } finally {
        if (!signal.aborted) this.isLoading = false;
        this.app.changed();
      }
    },
  );

  /** @param {List} list */
  setList(list) {
    this.list = list;
    this.found = NOTHING;
    this.exact = new Set();
    this.footprints = Array.from({ length: Math.min(DRAWN, this.count) }, (_, i) =>
      this.scenario.footprint(this.row(i)),
    );
  }

  /** @param {ArrayLike<number>} q */
  fitted(q) {
    return fitted(q, this.coordinates);
  }

  /** Moves the target. @param {ArrayLike<number>} q */
  moveTo(q) {
    this.setQuery({ q: this.fitted(q) });
  }

  /** Changes one coordinate of the target. @param {number} i @param {number} value */
  setCoordinate(i, value) {
    this.moveTo(this.q.map((old, j) => (j !== i ? old : this.coordinates[i].isCircle ? wrap(value) : value)));
  }

  /** @param {Partial<Pick<NeighbourSession, "q" | "k" | "index" | "given" | "isAsking">>} changes */
  setQuery(changes) {
    Object.assign(this, changes);
    this.isFound = false;
    this.app.changed();
    void this.search();
  }

  /** Finds the neighbours of the list that the worker has, too. */
  search = coalesced(async () => {
    if (this.isLoading || this.count === 0) return;
    const { list, q, k, index, given } = this;
    // Only a forest has options beside the metric.
    const options = index === "forest" ? given : given.metric === undefined ? {} : { metric: given.metric };
    const result = await this.app.track(this.worker.search({ q, k, index, given: options }));
    if (!result || this.isLoading || list !== this.list) return;
    this.found = result.found;
    this.exact = new Set(result.exact.indices);
    this.isFound = q === this.q && k === this.k && index === this.index && given === this.given;
    this.app.changed();
  });
}

/** The weights that a document gives, if any. @param {ScenarioDocument} document @returns {Weights | null} */
function weightsOf({ robot }) {
  return "metric" in robot && robot.metric ? [robot.metric.translation, robot.metric.rotation] : null;
}

/** @param {ScenarioDocument} document  of a body or a car @param {Weights} weights @returns {ScenarioDocument} */
export function weighted({ robot, ...rest }, [translation, rotation]) {
  return /** @type {ScenarioDocument} */ ({ ...rest, robot: { ...robot, metric: { translation, rotation } } });
}
