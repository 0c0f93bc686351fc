/**
 * The frontier of a search on a roadmap at the iteration shown: the vertices reached and not yet expanded. It follows
 * from the log: an expanded vertex has reached its neighbours.
 */
import { EVENT, PAST } from "./columns.js";

/** @import { Adjacency } from "./adjacency.js" */
/** @import { RunLog } from "./run-log.js" */

const WAITING = 1;
const EXPANDED = 2;

export class Frontier {
  /** @param {RunLog} run @param {Adjacency} adjacency */
  constructor(run, adjacency) {
    this.run = run;
    this.adjacency = adjacency;
    /** For each vertex 0 (not reached), `WAITING` or `EXPANDED`. */
    this.states = new Uint8Array(0);
    /** Events processed. */
    this.events = 0;
    /** The number of waiting vertices. */
    this.count = 0;
  }

  /** Follows the run to the iteration shown; outside of the search no vertex waits. */
  follow() {
    const { run } = this;
    if (run.phase !== "searching") {
      this.count = 0;
      this.events = 0;
      return;
    }
    const { past } = run;
    if (this.events > past[PAST.events] || this.events === 0) this.begin(past[PAST.vertices]);
    this.adjacency.follow();
    const { data, width } = run.events;
    for (; this.events < past[PAST.events]; this.events++) {
      if (data[this.events * width] === EVENT.expanded) this.expand(data[this.events * width + 2], past[PAST.edges]);
    }
  }

  /** Begins with the roots. @param {number} vertices */
  begin(vertices) {
    this.states = new Uint8Array(vertices);
    this.events = 0;
    this.count = 0;
    this.reach(0);
    if (String(this.run.settings.search).startsWith("bidirectional")) this.reach(1);
  }

  /** @param {number} vertex */
  reach(vertex) {
    if (this.states[vertex] !== 0) return;
    this.states[vertex] = WAITING;
    this.count++;
  }

  /** @param {number} vertex @param {number} edges */
  expand(vertex, edges) {
    if (this.states[vertex] === WAITING) this.count--;
    this.states[vertex] = EXPANDED;
    this.adjacency.neighbours(vertex, edges, (other) => this.reach(other));
  }

  /** Calls back with each waiting vertex, in order. @param {(vertex: number) => void} then */
  each(then) {
    if (this.count > 0) this.states.forEach((state, vertex) => state === WAITING && then(vertex));
  }
}
