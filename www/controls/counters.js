/** The numbers of the run in one line, and the same numbers as data attributes for whoever watches the page. */
import { byId } from "./dom.js";

/** @import { LaneState } from "../types.js" */

/** Milliseconds between two changes of the text. */
const READABLE = 80;

export class Counters {
  constructor() {
    this.element = byId("counters", HTMLElement);
    this.phase = byId("count-phase", HTMLElement);
    this.iterations = byId("count-iterations", HTMLElement);
    this.vertices = byId("count-vertices", HTMLElement);
    this.edges = byId("count-edges", HTMLElement);
    this.motions = byId("count-motions", HTMLElement);
    this.length = byId("count-length", HTMLElement);
    this.lengthRow = byId("count-length-row", HTMLElement);
    this.fingerprint = byId("count-fingerprint", HTMLElement);
    this.fingerprintRow = byId("count-fingerprint-row", HTMLElement);
    this.written = -Infinity;
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
    write(this.phase, lane.status === "running" ? lane.phase : lane.status === "none" ? "no plan" : lane.status);
    write(this.iterations, grouped(lane.iteration));
    write(this.vertices, grouped(lane.vertices));
    write(this.edges, grouped(lane.edges));
    write(this.motions, grouped(lane.motions));
    this.fingerprintRow.hidden = lane.fingerprint === "";
    write(this.fingerprint, lane.fingerprint);
    this.lengthRow.hidden = lane.length === null;
    if (lane.length !== null) write(this.length, `${lane.length.toFixed(2)} ${lane.unit}`);
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
    write(this.phase, status);
  }
}

const digits = new Intl.NumberFormat("en");

/** @param {number} count */
export function grouped(count) { return digits.format(count); }

/** @param {HTMLElement} element @param {string} text */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
