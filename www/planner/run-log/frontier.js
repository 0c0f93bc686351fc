/**
 * The frontier of a search on a roadmap: the vertices that it has reached and not expanded yet, at the iteration that is
 * shown. Told from the log alone: what was expanded has reached its neighbours. Going forward costs what is new.
 */
import { EVENT, PAST } from "./run-log.js";

/** @import { Adjacency } from "./adjacency.js" */
/** @import { Run } from "./run-log.js" */

const WAITING = 1;
const EXPANDED = 2;

export class Frontier {
  /** @param {Run} run @param {Adjacency} adjacency */
  constructor(run, adjacency) {
    this.run = run;
    this.adjacency = adjacency;
    /** Of each vertex: not reached, waiting, expanded. */
    this.states = new Uint8Array(0);
    /** Events taken in. */
    this.events = 0;
    /** How many wait. */
    this.count = 0;
  }

  /** Comes to the iteration that is shown; while nothing is searched nobody waits. */
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

  /** Nothing is expanded: the roots wait. @param {number} vertices */
  begin(vertices) {
    this.states = new Uint8Array(vertices);
    this.events = 0;
    this.count = 0;
    this.reach(0);
    if (this.run.settings.search === "bidirectional") this.reach(1);
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

  /** The vertices that wait, in the order of their numbers. @param {(vertex: number) => void} then */
  each(then) {
    if (this.count > 0) this.states.forEach((state, vertex) => state === WAITING && then(vertex));
  }
}
