/** A subdivision in the worker: it divides cells in blocks, and what is new is sent as rows that are transferred. */

/** @import { Certificate, CertifyOptions, Subdivision } from "planarium" */
/** @import { Scenario } from "../../domain/types.js" */

/**
 * @typedef {object} Division   what a block has divided
 * @property {Float64Array} cells   new rows: centre, half of each side, and 0 (mixed), 1 (free) or 2 (blocked)
 * @property {Certificate | null} certificate   once there is a verdict
 */

export class Certifier {
  /** @param {Scenario} scenario @param {CertifyOptions} options */
  constructor(scenario, options) {
    /** @type {Subdivision} */
    this.subdivision = scenario.certify(options);
    /** Rows that were sent. */
    this.sent = 0;
  }

  /**
   * Divides cells, as many as a part of those there are, for a limited time.
   * @param {number} part   Infinity: all in that time
   * @param {number} budget   milliseconds
   * @returns {Division}
   */
  advance(part, budget) {
    const { subdivision, sent } = this;
    const until = performance.now() + budget;
    for (
      let left = Math.ceil(part * subdivision.cellCount);
      left > 0 && subdivision.status === "running" && performance.now() < until;
      left--
    )
      subdivision.step(1);
    this.sent = subdivision.cellCount;
    return { cells: subdivision.cellsSince(sent), certificate: subdivision.verdict && subdivision.certificate() };
  }

  free() {
    this.subdivision.free();
  }
}
