/** The counters of the run, as text and as data attributes. */
import { byId, grouped, write } from "../app/dom.js";
import { endText } from "../domain/names.js";
import { duration, percent } from "../widgets/format.js";

/** @import { LaneState } from "./run-log/lane-state.js" */

export class Counters {
  constructor() {
    this.element = byId("counters", HTMLElement);
    // On a desktop all counters are in one line; on a phone some are folded away.
    const more = byId("more-counters", HTMLDetailsElement);
    const desktop = matchMedia("(min-width: 77.5rem)");
    const unfold = () => {
      more.open = desktop.matches;
    };
    desktop.addEventListener("change", unfold);
    unfold();
  }

  /** Shows a run. @param {LaneState} lane @param {boolean} settled */
  show(
    {
      status,
      reason,
      phase,
      iteration,
      vertices,
      edges,
      checks,
      rejected,
      motions,
      evaluations,
      visited,
      stats,
      length,
      gap,
      optimum,
      unit,
      waypoints,
      fingerprint,
    },
    settled,
  ) {
    this.mark({
      status,
      phase,
      iterations: iteration,
      vertices,
      edges,
      settled,
      fingerprint: fingerprint || null,
      length,
    });
    byId("gap", HTMLElement).hidden = optimum === null;
    this.write({
      phase:
        status === "running"
          ? phase
          : status === "none"
            ? "not started"
            : status === "exhausted"
              ? endText(reason)
              : status,
      iterations: grouped(iteration),
      vertices: grouped(vertices),
      edges: grouped(edges),
      length: length === null ? "" : `${length.toFixed(2)} ${unit}`,
      gap: gap === null ? "" : percent(gap),
      waypoints: waypoints === null ? "" : grouped(waypoints),
      checks: short(checks),
      rejected: short(rejected),
      motions: short(motions),
      evaluations: short(evaluations),
      nearest: stats ? short(stats.nearest) : "",
      visited: visited === null ? "" : short(visited),
      build: stats ? duration(stats.build) : "",
      search: stats ? duration(stats.search) : "",
      rate: stats && stats.rate < Infinity ? short(stats.rate) : "",
      fingerprint,
    });
  }

  /** Writes texts into cells; an empty one becomes a dash. @param {Record<string, string>} words */
  write(words) {
    for (const [name, word] of Object.entries(words)) write(byId(`count-${name}`, HTMLElement), word || "\u2013");
  }

  /** Sets data attributes; null removes one. @param {Record<string, string | number | boolean | null>} values */
  mark(values) {
    for (const [name, value] of Object.entries(values)) {
      if (value === null) this.element.removeAttribute(`data-${name}`);
      else this.element.dataset[name] = String(value);
    }
  }

  /** Declares the counters out of date. */
  unsettle() {
    this.mark({ settled: false, fingerprint: null, length: null });
  }

  /** Shows that the page could not start. */
  fail() {
    this.mark({ status: "failed" });
    this.write({ phase: "failed" });
  }
}

/** A number, compact from 100,000: "1.23M". @param {number} count */
function short(count) {
  if (count < 100_000) return grouped(Math.round(count));
  const [unit, name] = count < 999_500 ? [1e3, "K"] : count < 999_500_000 ? [1e6, "M"] : [1e9, "B"];
  return `${Number((count / unit).toPrecision(3))}${name}`;
}
