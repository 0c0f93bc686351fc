/** The counters of the run, as text and as data attributes. */
import { byId, grouped, write } from "../app/dom.js";

/** @import { LaneState } from "../domain/types.js" */

export class Counters {
  constructor() {
    this.element = byId("counters", HTMLElement);
    // On a desktop all counters are in one line; on a phone some are folded away.
    const more = byId("more-counters", HTMLDetailsElement);
    const desktop = matchMedia("(min-width: 77.5rem)");
    const unfold = () => { more.open = desktop.matches; };
    desktop.addEventListener("change", unfold);
    unfold();
  }

  /** Shows a run. @param {LaneState} lane @param {boolean} settled */
  show(lane, settled) {
    const { dataset } = this.element;
    const { status, phase, iteration, vertices, edges, fingerprint, length } = lane;
    Object.assign(dataset, { status, phase, iterations: iteration, vertices, edges, settled });
    if (fingerprint) dataset.fingerprint = fingerprint;
    else delete dataset.fingerprint;
    if (length !== null) dataset.length = String(length);
    else delete dataset.length;
    this.write({
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

  /** Writes texts into cells; an empty one becomes a dash. @param {Record<string, string>} words */
  write(words) {
    for (const [name, word] of Object.entries(words)) write(byId(`count-${name}`, HTMLElement), word || "\u2013");
  }

  /** Declares the counters out of date. */
  unsettle() {
    const { dataset } = this.element;
    dataset.settled = "false";
    delete dataset.fingerprint;
    delete dataset.length;
  }

  /** Shows that the page could not start. */
  fail() {
    this.element.dataset.status = "failed";
    this.write({ phase: "failed" });
  }
}

/** A number, compact from 100,000: "1.23M". @param {number} count */
function short(count) {
  if (count < 100_000) return grouped(Math.round(count));
  const [unit, name] = count < 999_500 ? [1e3, "K"] : count < 999_500_000 ? [1e6, "M"] : [1e9, "B"];
  return `${Number((count / unit).toPrecision(3))}${name}`;
}

/** @param {number} seconds */
function duration(seconds) { return seconds < 1 ? `${Math.round(1000 * seconds)} ms` : `${seconds.toFixed(seconds < 10 ? 2 : 1)} s`; }
