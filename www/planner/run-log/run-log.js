/**
 * A run: the log of the worker's planner, and the iteration that is shown. The log only grows, and each iteration adds
 * a row of counts to the history. The graph at an earlier iteration is therefore the beginning of the log: going back
 * needs no planning.
 */
import { grownSince } from "../../../dist/package/planner-host.js";
import { planned } from "../../domain/page-defaults.js";
import { withOptions } from "../../domain/option-names.js";
import { firstIndex } from "../../domain/search.js";
import { Frontier } from "./frontier.js";
import { Adjacency } from "./adjacency.js";
import { componentsOf } from "./components.js";
import { EVENT, PAST, SIDE } from "./columns.js";
import { Rows } from "./rows.js";

/** @import { Growth } from "../worker/stepper.js" */
/** @import { PlannerInfo, ResultDocument, Scenario, Settings, Stats, Status } from "../../domain/types.js" */

/** @typedef {{ phases: readonly string[], planners: PlannerInfo[] }} Catalogue   of the package */

export class RunLog {
  /**
   * @param {Scenario} scenario
   * @param {string} algorithm
   * @param {Settings} settings  the query's name, the seed and the planner's parameters
   * @param {Catalogue} catalogue
   * @throws {Error} with `code` and `pointer`: a start in collision, a parameter out of range
   */
  constructor(scenario, algorithm, settings, { phases, planners }) {
    this.scenario = scenario;
    this.algorithm = algorithm;
    this.settings = settings;
    this.phases = phases;
    /** A planner like the worker's, before its first iteration. */
    this.planner = withOptions({ ...planned(algorithm, settings), algorithm }, (options) => scenario.planner(options));
    const { dimension } = this.planner;
    this.dimension = dimension;
    this.vertices = new Rows((n) => new Float64Array(n), dimension);
    this.edges = new Rows((n) => new Uint32Array(n), 2);
    this.events = new Rows((n) => new Float64Array(n), this.planner.eventWidth);
    /** Row i holds the counts after iteration i. */
    this.history = new Rows((n) => new Float64Array(n), this.planner.historyWidth);
    /** For each vertex its root, of `SIDE`. */
    this.sides = new Rows((n) => new Uint8Array(n), 1);
    /**
     * Configurations on curved edges, and controls along driven edges: rows that begin with the number of the edge; and
     * for each such edge its first row.
     */
    this.traces = new Rows((n) => new Float64Array(n), 1 + dimension);
    /** @type {Map<number, number>} */
    this.traced = new Map();
    this.motions = new Rows((n) => new Float64Array(n), 4);
    /** @type {Map<number, number>} */
    this.driven = new Map();
    /** For each removed vertex the index of the event. @type {Map<number, number>} */
    this.gone = new Map();
    /** For each kind of event the indices of its events. @type {number[][]} */
    this.kinds = Object.values(EVENT).map(() => []);
    this.adjacency = new Adjacency(this);
    this.frontier = new Frontier(this, this.adjacency);
    const info = planners.find(({ id }) => id === algorithm);
    /** The kind of graph. @type {"roadmap" | "tree" | "trees"} */
    this.kind = info?.grows ?? "roadmap";
    /** Whether edges are motions under controls; refused ones are then not straight. */
    this.isDriven = info?.driven ?? false;
    /** Whether the planner goes on after its first path, to shorter ones. */
    this.goesOn = info?.parameters.some(({ name }) => name === "improve_iterations") ?? false;
    /** The goals; a target may have several. */
    this.goals = rowsIn(this.planner.goals(), scenario.dimension);
    /** The number of roots: the first vertices are the start and the goals, but under controls the goal is a region. */
    this.roots = this.isDriven ? 1 : 1 + this.goals.length;
    this.isTree = this.kind !== "roadmap";
    this.isProven = (settings.edge_check ?? "proven") === "proven" && settings.integration !== "euler";
    /** The coordinates that wrap around; none under the naive metric. */
    this.circles = settings.metric === "naive" ? scenario.circles().fill(false) : scenario.circles();
    /** The iteration shown, 0 to `made`. */
    this.shown = 0;
    /** The state at the newest iteration. @type {{ status: Status, phase: string, stats: Stats }} */
    this.now = { status: "running", phase: "", stats: this.planner.stats() };
    /** @type {{ made: number, result: ResultDocument } | null} */
    this.known = null;
    /** Once it has ended. @type {Float64Array} */
    this.path = new Float64Array(0);
    /** Once it has ended, before shortcutting. @type {Float64Array} */
    this.rawPath = new Float64Array(0);
    /** @type {ReturnType<typeof componentsOf> | null} */
    this.components = null;
    const { planner } = this;
    this.take({
      iterations: 0,
      ...grownSince(planner, { vertices: 0, edges: 0, events: 0, history: 0 }),
      history: Float64Array.of(
        planner.vertexCount,
        planner.edgeCount,
        planner.eventCount,
        Math.max(0, phases.indexOf(planner.phase)),
        0,
        0,
        0,
        Infinity,
      ),
      status: planner.status,
      phase: planner.phase,
      stats: planner.stats(),
      result: planner.result(),
      path: null,
      rawPath: null,
    });
  }

  /** The number of iterations in the log. */
  get made() {
    return this.history.count - 1;
  }

  /** The counts at the iteration shown. @returns {Float64Array} */
  get past() {
    return this.history.row(this.shown);
  }

  get isNewest() {
    return this.shown === this.made;
  }

  /** The status at the iteration shown. */
  get status() {
    return this.isNewest ? this.now.status : "running";
  }

  get ended() {
    return this.now.status !== "running";
  }

  /** The phase at the iteration shown. @returns {string} */
  get phase() {
    return this.isNewest ? this.now.phase : this.phases[this.past[PAST.phase]];
  }

  /**
   * The last iteration at which a clock of the log is at most a value. Column -1 counts iterations.
   * @param {number} column
   * @param {number} value
   */
  iterationAt(column, value) {
    if (column < 0) return Math.min(this.made, Math.max(0, Math.floor(value)));
    // Time 0 is before the first iteration, even if that costs nothing.
    if (value < 1) return 0;
    const { data, width, count } = this.history;
    return firstIndex(1, count, (i) => data[i * width + column] > value) - 1;
  }

  /** A clock of the log at an iteration. @param {number} column @param {number} iteration */
  clockAt(column, iteration) {
    if (column < 0 || iteration === 0) return iteration;
    return Math.max(1, this.history.data[iteration * this.history.width + column]);
  }

  /** A clock of the log at the newest iteration. @param {number} column */
  clock(column) {
    return this.clockAt(column, this.made);
  }

  /** The latest time that is completely in the log; Infinity once the run has ended. @param {number} column */
  reached(column) {
    if (this.ended) return Infinity;
    return column < 0 ? this.made : Math.max(0, this.clock(column) - 1);
  }

  /** The first iteration with a path, up to a last one; -1 without a path. @param {number} [last] */
  foundBy(last = this.shown) {
    const { data, width } = this.history;
    const hasPath = (/** @type {number} */ i) => data[i * width + PAST.length] < Infinity;
    return hasPath(last) ? firstIndex(0, last, hasPath) : -1;
  }

  /** Adds a block to the log. @param {Growth} growth */
  take({ history, vertices, edges, events, traces, motions, status, phase, stats, result, path, rawPath }) {
    this.history.add(history);
    this.vertices.add(vertices);
    // The samples of a tree may join it later; a goal has no side until it is reached.
    const known = this.sides.count;
    this.sides.add(new Uint8Array(this.vertices.count - known).fill(SIDE.none));
    if (this.kind === "tree") this.sides.data.fill(SIDE.start, Math.max(known, this.roots), this.vertices.count);
    const [firstEdge, firstEvent] = [this.edges.count, this.events.count];
    this.edges.add(edges);
    if (this.isTree && edges.length > 0) this.inheritSides(firstEdge);
    take(traces, this.traces, this.traced);
    take(motions, this.motions, this.driven);
    this.events.add(events);
    const { data, width, count } = this.events;
    for (let i = firstEvent; i < count; i++) {
      this.kinds[data[i * width]].push(i);
      if (data[i * width] === EVENT.removed) this.gone.set(data[i * width + 2], i);
    }
    this.now = { status, phase, stats };
    if (result) this.known = { made: this.made, result };
    if (path) this.path = path;
    if (rawPath) this.rawPath = rawPath;
  }

  /**
   * The configurations along an edge, as rows; between them it is nearly straight.
   * @param {number} edge
   * @returns {Float64Array}
   */
  along(edge) {
    const places = rowsOf(edge, this.traces, this.traced);
    const [from, to] = this.edges.row(edge);
    return places.length > 0 ? places : Float64Array.of(...this.vertices.row(from), ...this.vertices.row(to));
  }

  /** A car's controls along an edge: rows of speed, steering angle and seconds. @param {number} edge */
  motionsOf(edge) {
    return rowsOf(edge, this.motions, this.driven);
  }

  /** The edge of a tree to a vertex; -1 without one. @param {number} vertex */
  edgeTo(vertex) {
    this.adjacency.follow();
    return this.isTree ? this.adjacency.edgeTo(vertex, this.past[PAST.edges]) : -1;
  }

  /**
   * The length of an edge as it counts for a path: of a car the metres driven, else in the metric of the run.
   * @param {number} edge
   */
  lengthOf(edge) {
    if (this.scenario.robot !== "car")
      return this.adjacency.distance(this.edges.data[2 * edge], this.edges.data[2 * edge + 1]);
    const rows = this.motionsOf(edge);
    let sum = 0;
    for (let at = 0; at < rows.length; at += 3) sum += Math.abs(rows[at] * rows[at + 2]);
    return sum;
  }

  /**
   * The number of events of a kind among the first of the log.
   * @param {number} kind  of `EVENT`
   * @param {number} [events]  those up to the iteration shown
   */
  countOf(kind, events = this.past[PAST.events]) {
    const indices = this.kinds[kind];
    return firstIndex(0, indices.length, (i) => indices[i] >= events);
  }

  /** The number of vertices that the search of a roadmap has visited: those expanded, and the goal. */
  get visited() {
    return this.isTree ? 0 : this.countOf(EVENT.expanded) + this.countOf(EVENT.solved);
  }

  /** Whether a vertex is in the graph shown, and not removed. @param {number} vertex @param {number} [events] */
  isThere(vertex, events = this.past[PAST.events]) {
    return !((this.gone.get(vertex) ?? Infinity) < events);
  }

  /**
   * Whether an edge is in the graph shown: its ends are not removed, and the second has no other parent.
   * @param {number} edge
   * @param {Readonly<{ edges: number, events: number }>} [counts]
   */
  isEdgeThere(edge, { edges, events } = { edges: this.past[PAST.edges], events: this.past[PAST.events] }) {
    return (
      this.isThere(this.edges.data[2 * edge], events) &&
      this.isThere(this.edges.data[2 * edge + 1], events) &&
      !this.adjacency.isReplaced(edge, edges)
    );
  }

  /** Gives new vertices of trees the roots of their parents. An edge is (parent, child). @param {number} first */
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

  /** Whether an event of a kind happened up to the iteration shown. @param {number} kind  of `EVENT` */
  has(kind) {
    return this.countOf(kind) > 0;
  }

  /** The cost of the path before shortcutting; Infinity without a path. It is the length unless obstacles add to it. */
  get rawLength() {
    const found = this.foundBy(this.made);
    return found < 0 ? Infinity : this.history.row(found)[PAST.length];
  }

  /**
   * The edges of the best path so far of trees that go on to shorter ones, in no order; of the iteration shown.
   * @returns {number[]}
   */
  get bestEdges() {
    const found = this.countOf(EVENT.solved);
    if (!this.isTree || found === 0) return [];
    const { data, width } = this.events;
    const [vertex, other] = data.subarray(this.kinds[EVENT.solved][found - 1] * width + 2);
    const edges = this.edgesUp(vertex);
    // Two trees meet along an edge.
    if (this.kind === "trees")
      edges.push(this.adjacency.edgeBetween(vertex, other, this.past[PAST.edges]), ...this.edgesUp(other));
    return edges;
  }

  /** The edges from a vertex of a tree to its root. @param {number} vertex @returns {number[]} */
  edgesUp(vertex) {
    const edges = [];
    for (let edge = this.edgeTo(vertex); edge >= 0; edge = this.edgeTo(this.edges.data[2 * edge])) edges.push(edge);
    return edges;
  }

  /** Whether edges of its roadmap are tested only once a path wants them. */
  get isLazy() {
    return this.algorithm.startsWith("lazy-");
  }

  /** The components of a roadmap without a path, or else null. */
  get pieces() {
    if (this.isTree || this.isLazy || this.status !== "exhausted" || this.visited === 0) return null;
    // A faulty search may miss a path within one component.
    if (this.known?.result.reason === "search-failed") return null;
    return (this.components ??= componentsOf(this));
  }

  /** Whether the result at the newest iteration is known. */
  get hasResult() {
    return this.known?.made === this.made;
  }

  /** The result at the newest iteration. @throws {Error} it is unknown @returns {ResultDocument} */
  get result() {
    if (!this.known || !this.hasResult) throw new Error("The result of this iteration is unknown.");
    return this.known.result;
  }

  /** The marks on the pseudocode of the iteration shown. @returns {Set<string>} */
  marks() {
    /** @type {Set<string>} */
    const marks = new Set();
    if (this.shown === 0) return marks;
    const now = this.past;
    const before = this.history.row(this.shown - 1);
    // The phase in which the iteration began.
    marks.add(this.phases[before[PAST.phase]]);
    if (this.status !== "running") marks.add("done");
    if (now[PAST.vertices] > before[PAST.vertices]) marks.add("vertex");
    if (now[PAST.edges] > before[PAST.edges]) marks.add("edge");
    const words = Object.keys(EVENT);
    for (let i = before[PAST.events]; i < now[PAST.events]; i++)
      marks.add(words[this.events.data[i * this.events.width]]);
    return marks;
  }

  free() {
    this.planner.free();
  }
}

/** Rows of numbers as arrays. @param {Float64Array} numbers @param {number} width @returns {number[][]} */
function rowsIn(numbers, width) {
  return Array.from({ length: numbers.length / width }, (_, i) =>
    Array.from(numbers.subarray(i * width, (i + 1) * width)),
  );
}

/**
 * Adds rows that begin with the number of their edge.
 * @param {Float64Array} fresh
 * @param {Rows<Float64Array>} rows
 * @param {Map<number, number>} firsts
 */
function take(fresh, rows, firsts) {
  const { width, count } = rows;
  if (fresh.length > 0) rows.add(fresh);
  for (let i = count; i < rows.count; i++) if (!firsts.has(rows.data[i * width])) firsts.set(rows.data[i * width], i);
}

/**
 * The rows of an edge, without its number.
 * @param {number} edge
 * @param {Rows<Float64Array>} rows
 * @param {Map<number, number>} firsts
 */
function rowsOf(edge, { data, width, count }, firsts) {
  const first = firsts.get(edge) ?? count;
  let end = first;
  while (end < count && data[end * width] === edge) end++;
  return data.slice(first * width, end * width).filter((_, i) => i % width > 0);
}
