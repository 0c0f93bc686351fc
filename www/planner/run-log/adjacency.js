/**
 * The adjacency of a run's graph at any iteration: the neighbours of a vertex, and in a tree its parent and the cost
 * from its root. It takes O(1) for each new edge.
 */
import { difference } from "planarium/draw";

/** @import { RunLog } from "./run-log.js" */

export class Adjacency {
  /** @param {RunLog} run */
  constructor(run) {
    this.run = run;
    /** Edges added so far. */
    this.count = 0;
    /** The newest half-edge of each vertex; half-edges 2e and 2e + 1 are the two ends of edge e. @type {number[]} */
    this.heads = [];
    /** The next older half-edge of the same vertex, -1 after the last. @type {number[]} */
    this.next = [];
    /** In trees the newest edge to the parent. @type {number[]} */
    this.upward = [];
    /**
     * In a tree whose vertices change their parents: for each edge the one before it to the same vertex, and the one
     * after it.
     * @type {Map<number, number>}
     */
    this.before = new Map();
    /** @type {Map<number, number>} */
    this.after = new Map();
  }

  /** Adds the new edges. */
  follow() {
    const { run, heads, next, upward } = this;
    const { data, count } = run.edges;
    const roots = run.kind === "trees" ? run.roots : 1;
    for (; this.count < count; this.count++) {
      const e = this.count;
      for (const half of [2 * e, 2 * e + 1]) {
        next.push(heads[data[half]] ?? -1);
        heads[data[half]] = half;
      }
      const child = run.edges.data[2 * e + 1];
      if (!run.isTree || child < roots) continue;
      const former = upward[child];
      if (former !== undefined) {
        // The edge between two trees is none to a parent.
        if (run.kind === "trees") continue;
        this.before.set(e, former);
        this.after.set(former, e);
      }
      upward[child] = e;
    }
  }

  /**
   * The neighbours of a vertex along the first edges of the log.
   * @param {number} vertex
   * @param {number} edges  their number
   * @param {(other: number) => void} then
   */
  neighbours(vertex, edges, then) {
    const { data } = this.run.edges;
    for (let half = this.heads[vertex] ?? -1; half >= 0; half = this.next[half])
      if (half >> 1 < edges) then(data[half ^ 1]);
  }

  /**
   * The edge to the parent of a vertex of a tree among the first edges of the log, -1 without one.
   * @param {number} vertex
   * @param {number} edges  their number
   */
  edgeTo(vertex, edges) {
    let edge = this.upward[vertex] ?? -1;
    while (edge >= edges) edge = this.before.get(edge) ?? -1;
    return edge;
  }

  /**
   * The newest edge between two vertices among the first edges of the log, -1 without one.
   * @param {number} a
   * @param {number} b
   * @param {number} edges  their number
   */
  edgeBetween(a, b, edges) {
    let half = this.heads[a] ?? -1;
    while (half >= 0 && (half >> 1 >= edges || this.run.edges.data[half ^ 1] !== b)) half = this.next[half];
    return half >> 1;
  }

  /**
   * The parent of a vertex along the first edges of the log, -1 without one.
   * @param {number} vertex
   * @param {number} edges  their number
   */
  parent(vertex, edges) {
    const edge = this.edgeTo(vertex, edges);
    return edge < 0 ? -1 : this.run.edges.data[2 * edge];
  }

  /**
   * The length of the way from the root to a vertex along the first edges of the log.
   * @param {number} vertex
   * @param {number} edges  their number
   */
  cost(vertex, edges) {
    let sum = 0;
    for (let edge = this.edgeTo(vertex, edges); edge >= 0; edge = this.edgeTo(this.run.edges.data[2 * edge], edges))
      sum += this.run.lengthOf(edge);
    return sum;
  }

  /**
   * Whether another one of the first edges of the log has replaced this one.
   * @param {number} edge
   * @param {number} edges  their number
   */
  isReplaced(edge, edges) {
    this.follow();
    return (this.after.get(edge) ?? Infinity) < edges;
  }

  /** The distance of two vertices in the metric of the run. @param {number} from @param {number} to */
  distance(from, to) {
    const { run } = this;
    const { metric = "" } = run.settings;
    const [a, b] = [run.vertices.row(from), run.vertices.row(to)];
    if (metric !== "euclidean" && metric !== "naive") return run.scenario.distance(a, b);
    return Math.hypot(...run.circles.map((circle, j) => difference(a[j], b[j], circle)));
  }
}
