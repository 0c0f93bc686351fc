/**
 * Times for building and querying scan, kd-tree and forest on more and more configurations. The clock of a browser is
 * coarse, so queries are timed in batches, and their median counts.
 */
import { Scenario } from "planarium";
import { rowsOf } from "../domain/coordinates.js";

/** @import { Neighbours, NeighboursOptions } from "planarium" */
/** @import { ScenarioDocument, Settings } from "../domain/types.js" */
/** @typedef {typeof KINDS[number]} Kind */
/** An index on n configurations. @typedef {ReturnType<Measurement["measure"]>[number]} Measured */

/** The indexes that are timed. */
export const KINDS = /** @type {const} */ (["linear", "kd-tree", "forest"]);
/** Targets queried in turn. */
const TARGETS = 40;
/** Milliseconds of a batch at least, and the number of batches. */
const BATCH = 1.5;
const BATCHES = 7;
/** Configurations added between two looks at the clock. */
const CHUNK = 2000;
/** Configurations measured at most. */
const MOST = 100_000;
const SEEDS = { rows: 1, targets: 2 };

export class Measurement {
  /** @param {ScenarioDocument} document @param {number} k @param {Settings} given */
  constructor(document, k, { metric, ...forest }) {
    this.scenario = Scenario.parse(document);
    this.k = k;
    this.rows = this.scenario.sampleConfigurations(MOST, { seed: SEEDS.rows });
    this.targets = rowsOf(
      this.scenario.sampleConfigurations(TARGETS, { seed: SEEDS.targets }),
      this.scenario.dimension,
    );
    /** The indexes, and the milliseconds that they took to build. */
    this.candidates = KINDS.map((kind) => {
      const options = {
        index: kind,
        ...(metric === undefined ? {} : { metric }),
        ...(kind === "forest" ? forest : {}),
      };
      return { kind, index: this.scenario.neighbours(/** @type {NeighboursOptions} */ (options)), build: 0 };
    });
  }

  /**
   * Times in seconds, the mean number of nodes visited, and the mean part of the true nearest neighbours that were
   * found.
   * @param {number} n  more than before @param {number} milliseconds  that may be spent
   */
  measure(n, milliseconds) {
    const { rows } = this;
    const { dimension } = this.scenario;
    const end = performance.now() + milliseconds;
    const measured = [];
    /** The true neighbours of each target. @type {Set<number>[]} */
    let truth = [];
    for (const candidate of this.candidates) {
      const { kind, index } = candidate;
      for (let began = performance.now(); index.size < n && began < end; began = performance.now()) {
        index.add(rows.subarray(index.size * dimension, Math.min(n, index.size + CHUNK) * dimension));
        candidate.build += performance.now() - began;
      }
      if (performance.now() > end) break;
      const results = this.targets.map((q) => index.nearest(q, this.k));
      if (kind === "kd-tree") truth = results.map(({ indices }) => new Set(indices));
      const recalls = results.map(({ indices }, i) =>
        truth[i]?.size ? indices.filter((one) => truth[i].has(one)).length / truth[i].size : 1,
      );
      measured.push({
        index: kind,
        n,
        build: candidate.build / 1000,
        query: this.time(index) / 1000,
        visited: mean(results.map(({ visited }) => visited)),
        recall: kind === "forest" ? mean(recalls) : 1,
      });
    }
    return measured;
  }

  /** Milliseconds of a query. @param {Neighbours} index */
  time(index) {
    let i = 0;
    const batches = Array.from({ length: BATCHES }, () => {
      const [began, first] = [performance.now(), i];
      let spent = 0;
      while (spent < BATCH) {
        for (let one = 0; one < 8; one++) index.nearest(this.targets[i++ % TARGETS], this.k);
        spent = performance.now() - began;
      }
      return spent / (i - first);
    });
    return batches.sort((a, b) => a - b)[BATCHES >> 1];
  }

  free() {
    for (const { index } of this.candidates) index.free();
    this.scenario.free();
  }
}

/** @param {number[]} values */
function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}
