/** What a lane says of its run in a frame: numbers, texts and flags. */

/** @import { Status } from "../../domain/types.js" */
/** @typedef {typeof NO_RUN & { algorithm: string }} LaneState */

/** Without a run. */
export const NO_RUN = {
  status: /** @type {Status | "none"} */ ("none"),
  phase: "",
  iteration: 0,
  /** Why it ended without a path. @type {string | null} */
  reason: null,
  made: 0,
  vertices: 0,
  edges: 0,
  checks: 0,
  motions: 0,
  evaluations: 0,
  /** Of the best path so far, Infinity without a path. */
  cost: Infinity,
  /** Once solved and at rest. @type {number | null} */
  length: null,
  /**
   * By how much the best path so far is longer than the shortest one, in percent, if that is shown and known.
   * @type {number | null}
   */
  gap: null,
  /**
   * Whether the shortest path is shown and known: no free path is shorter, or a reference.
   * @type {"shortest" | "reference" | null}
   */
  optimum: null,
  unit: "",
  /** At rest at the newest iteration. */
  fingerprint: "",
  kind: /** @type {"roadmap" | "tree" | "trees"} */ ("roadmap"),
  isProven: true,
  isMiss: false,
  hasGuards: false,
  isSearched: false,
  isApart: false,
  isInformed: false,
  hasRejected: false,
  hasRefused: false,
  /** Vertices that the search has reached and not expanded. */
  waiting: 0,
  /** The length before shortcutting, where it was longer. @type {number | null} */
  raw: null,
  /** Vertices of the path, with its ends. @type {number | null} */
  waypoints: null,
  /** Vertices that the search of a roadmap has visited; null of a tree. @type {number | null} */
  visited: null,
  /** Samples drawn that were in collision. */
  rejected: 0,
  /**
   * Known of the newest iteration only.
   * @type {{ nearest: number, build: number, search: number, rate: number } | null}
   */
  stats: null,
  /** The iteration's marks on the pseudocode. @type {string[]} */
  marks: [],
};
