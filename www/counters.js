/** The numbers of the run in one line, and the same numbers as data attributes for whoever watches the page. */
import { byId } from "./dom.js";

/** @import { Run } from "./run.js" */

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

  /** The numbers of a moving run; the text follows a few times a second, as fast as it can be read. @param {Run} run */
  show(run) {
    const { planner } = run;
    const { dataset } = this.element;
    dataset.status = planner.status;
    dataset.phase = planner.phase;
    dataset.iterations = String(planner.iterations);
    dataset.vertices = String(planner.vertexCount);
    dataset.edges = String(planner.edgeCount);
    const now = performance.now();
    if (now - this.written < READABLE) return;
    this.written = now;
    this.write(run);
  }

  /** @param {Run} run */
  write({ planner }) {
    write(this.phase, planner.status === "running" ? planner.phase : planner.status);
    write(this.iterations, grouped(planner.iterations));
    write(this.vertices, grouped(planner.vertexCount));
    write(this.edges, grouped(planner.edgeCount));
    write(this.motions, grouped(planner.stats().motion_checks));
  }

  /** What is only told of a run at rest: it says the whole run in sixteen digits. @param {Run} run */
  settle(run) {
    this.write(run);
    const solved = run.status === "solved";
    const fingerprint = run.planner.fingerprint();
    this.element.dataset.fingerprint = fingerprint;
    write(this.fingerprint, fingerprint);
    this.fingerprintRow.hidden = false;
    this.lengthRow.hidden = !solved;
    if (solved) {
      const unit = run.scenario.robot === "arm" ? "rad" : "m";
      const { length } = run.planner.result();
      this.element.dataset.length = String(length);
      write(this.length, `${length.toFixed(2)} ${unit}`);
    } else {
      delete this.element.dataset.length;
    }
  }

  /** The run moves again: what was told of it at rest no longer holds. */
  unsettle() {
    delete this.element.dataset.fingerprint;
    delete this.element.dataset.length;
    this.fingerprintRow.hidden = true;
    this.lengthRow.hidden = true;
  }

  /** There is no run. @param {"loading" | "failed" | "none"} status */
  none(status) {
    this.unsettle();
    Object.assign(this.element.dataset, { status, phase: "", iterations: "0", vertices: "0", edges: "0" });
    write(this.phase, status === "none" ? "no plan" : status);
    for (const cell of [this.iterations, this.vertices, this.edges, this.motions]) write(cell, "0");
  }
}

const digits = new Intl.NumberFormat("en");

/** @param {number} count */
function grouped(count) { return digits.format(count); }

/** @param {HTMLElement} element @param {string} text */
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
