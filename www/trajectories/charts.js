/**
 * How hard it gets: for each accepted trajectory how many were tried, which the seed decides, and how long that took, which the
 * machine decides; each with its moving average. Drawn a few times a second while it grows, and once at rest.
 */
import { byId } from "../app/dom.js";
import { Plot } from "../room/plot.js";
import { movingAverage } from "./growth.js";

/** @import { Growth } from "./growth.js" */

/** The moving average is taken over so many. */
export const WINDOW = 20;
/** Milliseconds between two drawings while it grows. */
const EVERY = 500;
/** Points of a curve at most. */
const MOST = 1000;

export class Charts {
  /** @param {Growth} growth */
  constructor(growth) {
    this.growth = growth;
    this.tries = new Plot("tries", "Tries for each accepted trajectory");
    this.time = new Plot("time", "Microseconds for each accepted trajectory, by the clock of this machine");
    byId("charts", HTMLElement).append(this.tries.element, this.time.element);
    this.drawn = -Infinity;
    this.count = -1;
    this.epoch = -1;
  }

  /** @param {number} now @param {boolean} isAtRest */
  draw(now, isAtRest) {
    const { growth } = this;
    const isOther = growth.epoch !== this.epoch || growth.tries.length !== this.count;
    if (!isOther || (!isAtRest && now - this.drawn < EVERY)) return;
    [this.drawn, this.count, this.epoch] = [now, growth.tries.length, growth.epoch];
    curve(this.tries, growth.tries, "tries", (value) => value.toFixed(1));
    curve(this.time, growth.milliseconds.map((value) => 1000 * value), "microseconds", (value) => value.toFixed(1), true);
  }
}

/**
 * Times are told on a logarithmic scale, each by a dot: clocks of browsers count in coarse steps, and now and then the machine is
 * busy with something else. Those too short for the clock have no dot, but count in the mean.
 * @param {Plot} plot @param {number[]} values @param {string} unit @param {(value: number) => string} told @param {boolean} [isLog]
 */
function curve(plot, values, unit, told, isLog = false) {
  const every = Math.max(1, Math.ceil(values.length / MOST));
  const thin = (/** @type {[number, number][]} */ points) => points.filter((_, i) => i % every === 0 || i === points.length - 1);
  const average = movingAverage(values, WINDOW);
  const last = average[average.length - 1]?.[1];
  const summary = values.length === 0 ? `${plot.title.textContent}: none yet.`
    : `${plot.title.textContent}: ${values.length} accepted${last === undefined ? "" : `, ${told(average[0][1])} ${unit} on average over the first ${WINDOW}, ${told(last)} over the last`}.`;
  plot.draw([
    { label: "", points: thin(values.map((value, i) => [i + 1, value])), className: "each", dots: isLog },
    { label: last === undefined ? "" : `mean of ${WINDOW}`, points: thin(average), className: "average" },
  ], { title: "accepted", low: 0, high: 1 }, isLog ? { title: unit, isLog } : { title: unit, low: 0 }, summary);
}
