import { PAST } from "./columns.js";

/** @import { RunLog } from "./run-log.js" */

/** The connected components of a roadmap at the iteration shown, by union-find (Tarjan 1975). @param {RunLog} run */
export function componentsOf(run) {
  const { past, edges, roots } = run;
  const count = past[PAST.vertices];
  const parent = Uint32Array.from({ length: count }, (_, vertex) => vertex);
  /** @param {number} vertex */
  const find = (vertex) => {
    let at = vertex;
    while (parent[at] !== at) at = parent[at] = parent[parent[at]];
    return at;
  };
  let pieces = count;
  for (let e = 0; e < past[PAST.edges]; e++) {
    const a = find(edges.data[2 * e]);
    const b = find(edges.data[2 * e + 1]);
    if (a === b) continue;
    parent[Math.max(a, b)] = Math.min(a, b);
    pieces--;
  }
  /** The vertices, without the roots, in the components of some vertices. @param {number[]} vertices */
  const around = (vertices) => {
    const pieces = new Set(vertices.map(find));
    /** @type {number[]} */
    const members = [];
    for (let other = roots; other < count; other++) if (pieces.has(find(other))) members.push(other);
    return members;
  };
  return { count: pieces, start: around([0]), goal: around(Array.from({ length: roots - 1 }, (_, i) => 1 + i)) };
}
