/** The numbers of the run in one line, and the same numbers as data attributes for whoever watches the page. */
import { READABLE, byId, grouped, write } from "../app/dom.js";

/** @import { LaneState } from "../domain/types.js" */

const NUMBERS = /** @type {const} */ ([
  "phase", "iterations", "vertices", "edges", "length", "segments", "checks", "motions", "evaluations", "nearest", "time", "rate", "fingerprint",
]);

export class Counters {
  constructor() {
    this.element = byId("counters", HTMLElement);
    this.cells = Object.fromEntries(NUMBERS.map((name) => [name, byId(`count-${name}`, HTMLElement)]));
    this.written = -Infinity;
    // On a desktop all numbers stand in one line; on a phone the rest is folded away.
    const more = byId("more-counters", HTMLDetailsElement);
    const desktop = matchMedia("(min-width: 77.5rem)");
    const unfold = () => { more.open = desktop.matches; };
    desktop.addEventListener("change", unfold);
    unfold();
  }

  /** The numbers of a run; while it moves the text follows a few times a second, as fast as it can be read. @param {LaneState} lane @param {boolean} settled */
  show(lane, settled) {
    const { dataset } = this.element;
    Object.assign(dataset, {
      status: lane.status, phase: lane.phase, iterations: String(lane.iteration), vertices: String(lane.vertices), edges: String(lane.edges),
      settled: String(settled),
    });
    if (lane.fingerprint) dataset.fingerprint = lane.fingerprint;
    else delete dataset.fingerprint;
    if (lane.length !== null) dataset.length = String(lane.length);
    else delete dataset.length;
    const now = performance.now();
    if (!settled && now - this.written < READABLE) return;
    this.written = now;
    this.tell({
      phase: lane.status === "running" ? lane.phase : lane.status === "none" ? "not started" : lane.status === "exhausted" ? "no path" : lane.status,
      iterations: grouped(lane.iteration), vertices: grouped(lane.vertices), edges: grouped(lane.edges),
      length: lane.length === null ? "" : `${lane.length.toFixed(2)} ${lane.unit}`,
      segments: lane.segments === null ? "" : grouped(lane.segments),
      checks: short(lane.checks), motions: short(lane.motions), evaluations: short(lane.evaluations),
      nearest: lane.stats ? short(lane.stats.nearest) : "",
      time: lane.stats ? duration(lane.stats.seconds) : "",
      rate: lane.stats && lane.stats.seconds > 0 ? short(lane.iteration / lane.stats.seconds) : "",
      fingerprint: lane.fingerprint,
    });
  }

  /** Puts words in their places; a dash where nothing is known. @param {Partial<Record<typeof NUMBERS[number], string>>} words */
  tell(words) {
    for (const [name, word] of Object.entries(words)) write(this.cells[name], word || "\u2013");
  }

  /** Something was ordered: what was told at rest no longer holds. */
  unsettle() {
    const { dataset } = this.element;
    dataset.settled = "false";
    delete dataset.fingerprint;
    delete dataset.length;
  }

  /** There is no run at all. @param {"loading" | "failed"} status */
  none(status) {
    Object.assign(this.element.dataset, { status, phase: "", iterations: "0", vertices: "0", edges: "0" });
    this.tell({ phase: status });
  }
}

/** A number in at most five characters where it is large. @param {number} count */
function short(count) {
  return count < 100_000 ? grouped(Math.round(count)) : count.toLocaleString("en", { notation: "compact", maximumSignificantDigits: 3 });
}

/** @param {number} seconds */
function duration(seconds) { return seconds < 1 ? `${Math.round(1000 * seconds)} ms` : `${seconds.toFixed(seconds < 10 ? 2 : 1)} s`; }
