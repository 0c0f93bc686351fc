/**
 * One run of one planner, as the page holds it: the planner, what it has grown so far, and how far it was asked to go.
 * Vertices and edges are fetched by cursor, so a frame costs what is new.
 */
import { Rows } from "./rows.js";

/** @import { Scenario, Settings } from "./types.js" */

/** Kinds of event, as the package numbers them. */
export const EVENT = { rejected: 0, refused: 1, expanded: 2, solved: 3, discarded: 4, guard: 5 };

/** Which root a vertex hangs from: none yet (a roadmap), the start, the goal. */
export const SIDE = { none: 0, start: 1, goal: 2 };

/** Iterations in one slice at most. */
const LONGEST = 64;

/** What one call of `advance` may grow at most, so that it can be drawn within the frame. */
const BURST = { vertices: 400, edges: 240 };

export class Run {
  /**
   * @param {Scenario} scenario
   * @param {string} algorithm
   * @param {Settings} settings  the query's name, the seed and the planner's parameters
   * @throws {Error} with `code` and `pointer`: a start in collision, a parameter out of range, ...
   */
  constructor(scenario, algorithm, settings) {
    this.scenario = scenario;
    this.algorithm = algorithm;
    this.planner = scenario.planner({ ...settings, algorithm });
    const dimension = this.planner.dimension;
    this.dimension = dimension;
    this.vertices = new Rows((n) => new Float64Array(n), dimension);
    this.edges = new Rows((n) => new Uint32Array(n), 2);
    /** For each vertex the root it hangs from; all `SIDE.none` in a roadmap. */
    this.sides = new Rows((n) => new Uint8Array(n), 1);
    /** Vertices that the search has expanded, in order. */
    this.expanded = new Rows((n) => new Uint32Array(n), 1);
    /** Vertices that are guards of a visibility roadmap, in order. */
    this.guards = new Rows((n) => new Uint32Array(n), 1);
    /** The newest event rows, those of the last `fetch`. @type {Float64Array} */
    this.fresh = new Float64Array(0);
    this.events = 0;
    /** What grows. @type {"roadmap" | "tree" | "trees"} */
    this.kind = algorithm === "rrt-connect" ? "trees" : algorithm.startsWith("rrt") ? "tree" : "roadmap";
    this.isTree = this.kind !== "roadmap";
    /** Are its edges proven free, or only looked at in places? */
    this.isProven = settings.edge_check !== "sampled";
    /** Coordinates whose motions go the short way round. The naive metric knows none: its motions may go the long way. */
    this.circles = settings.metric === "naive" ? scenario.circles().fill(false) : scenario.circles();
    this.fetch();
  }

  get status() { return this.planner.status; }
  get iterations() { return this.planner.iterations; }

  /**
   * Steps until `wanted` iterations are made, the run ends, the clock passes `until`, or as much has grown as a frame can draw.
   * Slices are small at first and grow as long as they prove cheap, so that one slice never takes a frame.
   * @param {number} wanted  iterations; may be Infinity
   * @param {number} until   on the clock of performance.now(), milliseconds
   * @returns {number} iterations made
   */
  advance(wanted, until) {
    const planner = this.planner;
    const first = planner.iterations;
    const most = { vertices: planner.vertexCount + BURST.vertices, edges: planner.edgeCount + BURST.edges };
    let slice = 1;
    while (planner.status === "running" && planner.vertexCount < most.vertices && planner.edgeCount < most.edges) {
      const left = wanted - (planner.iterations - first);
      if (left <= 0) break;
      const began = performance.now();
      if (began >= until) break;
      const made = planner.iterations;
      planner.step(Math.min(slice, left));
      if (planner.iterations === made) break;
      const ended = performance.now();
      const perIteration = (ended - began) / (planner.iterations - made);
      const room = (until - ended) / (2 * Math.max(perIteration, 1e-4));
      slice = Math.max(1, Math.min(2 * slice, LONGEST, Math.floor(room)));
    }
    return planner.iterations - first;
  }

  /** Fetches what has grown since the last call. */
  fetch() {
    const planner = this.planner;
    if (planner.vertexCount > this.vertices.count) {
      this.vertices.add(planner.verticesSince(this.vertices.count));
      this.sides.add(new Uint8Array(this.vertices.count - this.sides.count));
    }
    if (planner.edgeCount > this.edges.count) {
      const first = this.edges.count;
      this.edges.add(planner.edgesSince(first));
      if (this.isTree) this.inheritSides(first);
    }
    this.fresh = planner.eventsSince(this.events);
    this.events = planner.eventCount;
    const width = planner.eventWidth;
    /** @type {number[]} */
    const expanded = [];
    /** @type {number[]} */
    const guards = [];
    for (let i = 0; i < this.fresh.length; i += width) {
      if (this.fresh[i] === EVENT.expanded) expanded.push(this.fresh[i + 2]);
      else if (this.fresh[i] === EVENT.guard) guards.push(this.fresh[i + 2]);
    }
    if (expanded.length > 0) this.expanded.add(expanded);
    if (guards.length > 0) this.guards.add(guards);
  }

  /** Tree edges are (parent, child): a new child hangs from its parent's root. A lone tree has the goal only once it is reached. @param {number} first */
  inheritSides(first) {
    const sides = this.sides.data;
    sides[0] = SIDE.start;
    if (this.kind === "trees") sides[1] = SIDE.goal;
    for (let i = first; i < this.edges.count; i++) {
      const parent = this.edges.data[2 * i];
      const child = this.edges.data[2 * i + 1];
      if (sides[child] === SIDE.none) sides[child] = sides[parent];
    }
  }

  free() { this.planner.free(); }
}
