/**
 * One run of one planner as the page holds it: the log of all it has grown in the worker, and the iteration that is shown.
 * The log is only ever added to, and each iteration has left a row of counts in it. So what an earlier iteration showed is
 * the beginning of the log up to its counts: going back costs no planning, and shows what a fresh run to there would.
 */
import { withOptions } from "../../domain/option-names.js";
import { Frontier } from "./frontier.js";
import { Adjacency } from "./adjacency.js";
import { componentsOf } from "./components.js";
import { Rows } from "./rows.js";
import { grownSince } from "../worker/stepper.js";

/** @import { Growth } from "../worker/stepper.js" */
/** @import { ResultDocument, Scenario, Settings, Stats, Status } from "../../domain/types.js" */

/** Kinds of event, as the package numbers them. */
export const EVENT = { rejected: 0, refused: 1, expanded: 2, solved: 3, discarded: 4, guard: 5, removed: 6 };

/** Columns of a row of history, as the package orders them. */
export const PAST = { vertices: 0, edges: 1, events: 2, phase: 3, checks: 4, motions: 5, evaluations: 6, cost: 7 };

/** Which root a vertex hangs from: none yet (a roadmap), the start, the goal. */
export const SIDE = { none: 0, start: 1, goal: 2 };

export class Run {
  /**
   * @param {Scenario} scenario
   * @param {string} algorithm
   * @param {Settings} settings  the query's name, the seed and the planner's parameters
   * @param {Pick<typeof import("planarium"), "phases" | "planners">} library  names of the phases, as the package numbers them, and what planners grow
   * @throws {Error} with `code` and `pointer`: a start in collision, a parameter out of range, ...
   */
  constructor(scenario, algorithm, settings, { phases, planners }) {
    this.scenario = scenario;
    this.algorithm = algorithm;
    this.settings = settings;
    this.phases = phases;
    /** The same planner as the worker's, before its first iteration: it tells what no iteration changes. */
    this.planner = withOptions({ ...settings, algorithm }, (options) => scenario.planner(options));
    const dimension = this.planner.dimension;
    this.dimension = dimension;
    this.vertices = new Rows((n) => new Float64Array(n), dimension);
    this.edges = new Rows((n) => new Uint32Array(n), 2);
    this.events = new Rows((n) => new Float64Array(n), this.planner.eventWidth);
    /** Row i: the counts after iteration i, from the state before the first on. */
    this.history = new Rows((n) => new Float64Array(n), this.planner.historyWidth);
    /** For each vertex the root it hangs from; all `SIDE.none` in a roadmap. */
    this.sides = new Rows((n) => new Uint8Array(n), 1);
    /** VertexIndex on edges that are no straight lines, and what a car does along edges: rows that begin with the number of the edge; of each such edge its first row. */
    this.traces = new Rows((n) => new Float64Array(n), 1 + dimension);
    /** @type {Map<number, number>} */
    this.traced = new Map();
    this.motions = new Rows((n) => new Float64Array(n), 4);
    /** @type {Map<number, number>} */
    this.driven = new Map();
    /** What was removed again: vertices, by the place of the event in the log, and these places. @type {Map<number, number>} */
    this.gone = new Map();
    /** @type {number[]} */
    this.removals = [];
    /** How many vertices the search has expanded, how many are guards. */
    this.expanded = 0;
    this.guards = 0;
    /** For each kind of event the place of the first in the log. @type {number[]} */
    this.firsts = [];
    this.adjacency = new Adjacency(this);
    this.frontier = new Frontier(this, this.adjacency);
    const info = planners().find(({ id }) => id === algorithm);
    /** What grows. @type {"roadmap" | "tree" | "trees"} */
    this.kind = info?.grows ?? "roadmap";
    /** Is it driven by controls, so that what was refused has no straight motion to be looked at again? */
    this.isDriven = info?.driven ?? false;
    /** Where it may end: several poses where its query has a target. */
    this.goals = rowsIn(this.planner.goals(), scenario.dimension);
    /** Its first vertices are the start and the goals; where it is driven by controls the goal is a region, and no vertex. */
    this.roots = this.isDriven ? 1 : 1 + this.goals.length;
    this.isTree = this.kind !== "roadmap";
    /** Are its edges proven free, or only looked at in places? */
    this.isProven = settings.edge_check !== "sampled" && settings.integration !== "euler";
    /** Coordinates whose motions go the short way round. The naive metric knows none: its motions may go the long way. */
    this.circles = settings.metric === "naive" ? scenario.circles().fill(false) : scenario.circles();
    /** The iteration that is shown, 0 to `made`. */
    this.shown = 0;
    /** How it stands at the newest iteration. @type {{ status: Status, phase: string, stats: Stats }} */
    this.now = { status: "running", phase: "", stats: this.planner.stats() };
    /** @type {{ made: number, result: ResultDocument } | null} */
    this.known = null;
    /** Once it has ended. @type {Float64Array} */
    this.path = new Float64Array(0);
    /** Once it has ended, and before it was shortened. @type {Float64Array} */
    this.rawPath = new Float64Array(0);
    /** @type {ReturnType<typeof componentsOf> | null} */
    this.fallen = null;
    const { planner } = this;
    this.take({
      history: Float64Array.of(planner.vertexCount, planner.edgeCount, planner.eventCount, Math.max(0, phases.indexOf(planner.phase)), 0, 0, 0, Infinity),
      ...grownSince(planner, { vertices: 0, edges: 0, events: 0 }), status: planner.status, phase: planner.phase, stats: planner.stats(), result: planner.result(),
      path: null, rawPath: null,
    });
  }

  /** Iterations made. */
  get made() { return this.history.count - 1; }

  /** The counts at the iteration that is shown. @returns {Float64Array} */
  get past() { return this.history.row(this.shown); }

  /** Is the newest iteration shown? */
  get isNewest() { return this.shown === this.made; }

  /** The status at the iteration that is shown. */
  get status() { return this.isNewest ? this.now.status : "running"; }

  /** Has the planner ended? */
  get ended() { return this.now.status !== "running"; }

  /** The phase at the iteration that is shown. @returns {string} */
  get phase() { return this.isNewest ? this.now.phase : this.phases[this.past[PAST.phase]]; }

  /** The last iteration made until a clock of the log has passed a value: column -1 counts iterations. @param {number} column @param {number} value */
  iterationAt(column, value) {
    if (column < 0) return Math.min(this.made, Math.max(0, Math.floor(value)));
    // Time 0 is before the first iteration, even before one that costs nothing.
    if (value < 1) return 0;
    const { data, width, count } = this.history;
    let low = 0;
    let high = count;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (data[middle * width + column] <= value) low = middle; else high = middle;
    }
    return low;
  }

  /** What a clock of the log shows at an iteration. Time 0 is before the first one. @param {number} column @param {number} iteration */
  clockAt(column, iteration) {
    if (column < 0 || iteration === 0) return iteration;
    return Math.max(1, this.history.data[iteration * this.history.width + column]);
  }

  /** What a clock of the log shows at the newest iteration made. @param {number} column */
  clock(column) { return this.clockAt(column, this.made); }

  /** The latest time of which everything is known to be made; Infinity once it has ended. @param {number} column */
  reached(column) {
    if (this.ended) return Infinity;
    return column < 0 ? this.made : Math.max(0, this.clock(column) - 1);
  }

  /** The iteration that first had a path, of those up to one; -1 where none had. @param {number} [last] */
  foundBy(last = this.shown) {
    const { data, width } = this.history;
    const hasPath = (/** @type {number} */ i) => data[i * width + PAST.cost] < Infinity;
    if (!hasPath(last)) return -1;
    let low = 0;
    let high = last;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (hasPath(middle)) high = middle; else low = middle;
    }
    return high;
  }

  /** Takes in what has grown. @param {Growth} growth */
  take({ history, vertices, edges, events, traces, motions, status, phase, stats, result, path, rawPath }) {
    this.history.add(history);
    this.vertices.add(vertices);
    this.sides.add(new Uint8Array(this.vertices.count - this.sides.count));
    const [firstEdge, firstEvent] = [this.edges.count, this.events.count];
    this.edges.add(edges);
    if (this.isTree && edges.length > 0) this.inheritSides(firstEdge);
    take(traces, this.traces, this.traced);
    take(motions, this.motions, this.driven);
    this.events.add(events);
    const { data, width, count } = this.events;
    for (let i = firstEvent; i < count; i++) {
      this.firsts[data[i * width]] ??= i;
      if (data[i * width] === EVENT.expanded) this.expanded++;
      else if (data[i * width] === EVENT.guard) this.guards++;
      else if (data[i * width] === EVENT.removed) {
        this.gone.set(data[i * width + 2], i);
        this.removals.push(i);
      }
    }
    this.now = { status, phase, stats };
    if (result) this.known = { made: this.made, result };
    if (path) this.path = path;
    if (rawPath) this.rawPath = rawPath;
  }

  /** An edge from end to end: rows of configurations, between which it is as good as straight. @param {number} edge @returns {Float64Array} */
  along(edge) {
    const places = rowsOf(edge, this.traces, this.traced);
    const [from, to] = this.edges.row(edge);
    return places.length > 0 ? places : Float64Array.of(...this.vertices.row(from), ...this.vertices.row(to));
  }

  /** What a car does along an edge: rows of speed, steering angle, seconds. @param {number} edge */
  motionsOf(edge) { return rowsOf(edge, this.motions, this.driven); }

  /** The edge of a tree that leads to a vertex, -1 where none does. @param {number} vertex */
  edgeTo(vertex) {
    this.adjacency.follow();
    const edge = this.adjacency.upward[vertex] ?? -1;
    return this.isTree && edge < this.past[PAST.edges] ? edge : -1;
  }

  /** How long an edge is; one that is no straight line by its places, which are close. @param {number} edge */
  lengthOf(edge) {
    if (!this.traced.has(edge)) return this.adjacency.distance(this.edges.data[2 * edge], this.edges.data[2 * edge + 1]);
    const rows = this.along(edge);
    const n = this.dimension;
    let sum = 0;
    for (let at = 0; at + n < rows.length; at += n) sum += this.scenario.distance(rows.subarray(at, at + n), rows.subarray(at + n, at + 2 * n));
    return sum;
  }

  /** How many vertices were removed by an event. @param {number} events  how many of the log count */
  removedBy(events) {
    let low = 0;
    let high = this.removals.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.removals[middle] < events) low = middle + 1; else high = middle;
    }
    return low;
  }

  /** Is a vertex in the graph that is shown, or was it removed? @param {number} vertex @param {number} [events] */
  isThere(vertex, events = this.past[PAST.events]) { return !((this.gone.get(vertex) ?? Infinity) < events); }

  /** Tree edges are (parent, child): a new child hangs from its parent's root. A lone tree has the goal only once it is reached. @param {number} first */
  inheritSides(first) {
    const sides = this.sides.data;
    sides[0] = SIDE.start;
    if (this.kind === "trees") sides.fill(SIDE.goal, 1, this.roots);
    for (let i = first; i < this.edges.count; i++) {
      const parent = this.edges.data[2 * i];
      const child = this.edges.data[2 * i + 1];
      if (sides[child] === SIDE.none) sides[child] = sides[parent];
    }
  }

  /** Has an event of a kind happened by the iteration that is shown? @param {number} kind  of `EVENT` */
  has(kind) { return (this.firsts[kind] ?? Infinity) < this.past[PAST.events]; }

  /** The length of the path as it was found, before it was made shorter; Infinity while there is none. */
  get rawLength() {
    const { data, width, count } = this.history;
    for (let i = 0; i < count; i++) if (data[i * width + PAST.cost] < Infinity) return data[i * width + PAST.cost];
    return Infinity;
  }

  /** The pieces that a roadmap without a path has fallen into; of others null. */
  get pieces() {
    if (this.isTree || this.status !== "exhausted" || this.expanded === 0) return null;
    this.fallen ??= componentsOf(this);
    return this.fallen;
  }

  /** Is the result at the newest iteration known? */
  get hasResult() { return this.known?.made === this.made; }

  /** The result at the newest iteration, where it is known: at its end always. @returns {ResultDocument} */
  get result() {
    if (!this.known || !this.hasResult) throw new Error("The result of this iteration has not been asked for.");
    return this.known.result;
  }

  /** What the newest iteration that is shown did, in the words of the pseudo-code's marks; before the first, none. @returns {Set<string>} */
  marks() {
    /** @type {Set<string>} */
    const marks = new Set();
    if (this.shown === 0) return marks;
    const now = this.past;
    const before = this.history.row(this.shown - 1);
    // The phase that it began in: the last iteration of a phase was still of that phase.
    marks.add(this.phases[before[PAST.phase]]);
    if (this.status !== "running") marks.add("done");
    if (now[PAST.vertices] > before[PAST.vertices]) marks.add("vertex");
    if (now[PAST.edges] > before[PAST.edges]) marks.add("edge");
    const words = Object.keys(EVENT);
    for (let i = before[PAST.events]; i < now[PAST.events]; i++) marks.add(words[this.events.data[i * this.events.width]]);
    return marks;
  }

  free() { this.planner.free(); }
}

/** Rows of numbers, each by itself. @param {Float64Array} numbers @param {number} width @returns {number[][]} */
function rowsIn(numbers, width) {
  return Array.from({ length: numbers.length / width }, (_, i) => Array.from(numbers.subarray(i * width, (i + 1) * width)));
}

/** Takes in new rows that begin with the number of their edge. @param {Float64Array} fresh @param {Rows<Float64Array>} rows @param {Map<number, number>} firsts */
function take(fresh, rows, firsts) {
  const { width, count } = rows;
  if (fresh.length > 0) rows.add(fresh);
  for (let i = count; i < rows.count; i++) if (!firsts.has(rows.data[i * width])) firsts.set(rows.data[i * width], i);
}

/** The rows of an edge, without its number. @param {number} edge @param {Rows<Float64Array>} rows @param {Map<number, number>} firsts */
function rowsOf(edge, { data, width, count }, firsts) {
  const first = firsts.get(edge) ?? count;
  let end = first;
  while (end < count && data[end * width] === edge) end++;
  return data.slice(first * width, end * width).filter((_, i) => i % width > 0);
}
