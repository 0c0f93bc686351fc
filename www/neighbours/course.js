/**
 * How long it takes to build an index and to ask it, as configurations become more: scan, tree and forest grow by the same
 * configurations. The clock of a browser is coarse, so questions are asked in batches, and the batch in the middle counts.
 */
import { Scenario } from "planarium";

/** @import { Neighbours, NeighboursOptions } from "planarium" */
/** @import { IndexId, Measured, ScenarioDocument, Settings } from "./types.js" */

/** @type {IndexId[]} */
export const KINDS = ["linear", "kd-tree", "forest"];

/** Targets that are asked for, one after the other. */
const TARGETS = 40;
/** A batch lasts at least so long, milliseconds, and there are so many of them. */
const BATCH = 1.5;
const BATCHES = 7;
/** Configurations added at once: between them the clock is looked at. */
const CHUNK = 2000;
/** The most that are measured. */
export const MOST = 100_000;
/** Seeds of the configurations and of the targets. */
const SEEDS = { rows: 1, targets: 2 };

export class Course {
  /** @param {ScenarioDocument} document @param {number} k @param {Settings} given */
  constructor(document, k, given) {
    this.scenario = Scenario.parse(document);
    this.k = k;
    const { metric, ...forest } = given;
    const measured = metric === undefined ? {} : { metric };
    this.rows = this.scenario.sampleConfigurations(MOST, { seed: SEEDS.rows });
    const { dimension } = this.scenario;
    const targets = this.scenario.sampleConfigurations(TARGETS, { seed: SEEDS.targets });
    this.targets = Array.from({ length: TARGETS }, (_, i) => targets.subarray(i * dimension, (i + 1) * dimension));
    /** @type {Map<IndexId, { index: Neighbours, build: number }>} */
    this.held = new Map(KINDS.map((kind) => [kind, { index: this.scenario.neighbours(/** @type {NeighboursOptions} */ ({ index: kind, ...measured, ...(kind === "forest" ? forest : {}) })), build: 0 }]));
  }

  /** @param {number} n  more than before @param {number} milliseconds  that may be spent @returns {Measured[]} */
  measure(n, milliseconds) {
    const end = performance.now() + milliseconds;
    /** @type {Measured[]} */
    const measured = [];
    /** The true neighbours of each target. @type {Set<number>[]} */
    let truth = [];
    for (const [kind, held] of this.held) {
      if (!this.grow(held, n, end) || performance.now() > end) {
        // What is behind cannot catch up.
        if (held.index.size < n) this.drop(kind);
        continue;
      }
      const answers = this.targets.map((q) => held.index.nearest(q, this.k));
      if (kind === "kd-tree") truth = answers.map(({ indices }) => new Set(indices));
      const hits = answers.map(({ indices }, i) => (truth.length === 0 || truth[i].size === 0 ? 1 : indices.filter((one) => truth[i].has(one)).length / truth[i].size));
      measured.push({
        index: kind, n, build: held.build / 1000, query: this.time(held.index) / 1000,
        visited: mean(answers.map(({ visited }) => visited)), recall: kind === "forest" ? mean(hits) : 1,
      });
    }
    return measured;
  }

  /** Adds configurations until there are so many. @param {{ index: Neighbours, build: number }} held @param {number} n @param {number} end @returns {boolean} whether there was time */
  grow(held, n, end) {
    const { dimension } = this.scenario;
    while (held.index.size < n) {
      const began = performance.now();
      if (began > end) return false;
      const from = held.index.size;
      held.index.add(this.rows.subarray(from * dimension, Math.min(n, from + CHUNK) * dimension));
      held.build += performance.now() - began;
    }
    return true;
  }

  /** Milliseconds a question. @param {Neighbours} index */
  time(index) {
    let i = 0;
    const batches = Array.from({ length: BATCHES }, () => {
      const began = performance.now();
      let count = 0;
      let now = began;
      while (now - began < BATCH) {
        for (let one = 0; one < 8; one++) index.nearest(this.targets[i++ % TARGETS], this.k);
        count += 8;
        now = performance.now();
      }
      return (now - began) / count;
    });
    return batches.sort((a, b) => a - b)[BATCHES >> 1];
  }

  /** @param {IndexId} kind */
  drop(kind) {
    this.held.get(kind)?.index.free();
    this.held.delete(kind);
  }

  free() {
    for (const kind of [...this.held.keys()]) this.drop(kind);
    this.scenario.free();
  }
}

/** @param {number[]} values */
function mean(values) { return values.reduce((sum, value) => sum + value, 0) / values.length; }
