/**
 * The transport: back, play, steps, run to the end, reset, speed, the timeline, and once solved the position along the
 * path.
 */
import { byId, grouped, write } from "../../app/dom.js";
import { endText } from "../../domain/names.js";
import { capital, secondsText } from "../../widgets/format.js";

/** @import { LaneState } from "../run-log/lane-state.js" */
/** @import { Clock } from "./clock.js" */
/** @import { Timeline } from "./playback.js" */
/** @typedef {{ timeline: Timeline, clock: Clock, reset: () => void }} Session */
/**
 * @typedef {object} State
 * @property {{ now: number, head: number, unit: number, isRace: boolean }} clock
 * @property {boolean} playing
 * @property {boolean} growing
 * @property {boolean} travelling
 * @property {number} along
 * @property {{ time: number, end: number } | null} timed
 * @property {LaneState[]} lanes
 */
/**
 * @typedef {object} Page   what the transport takes of the page
 * @property {Session} session
 * @property {number} [pace]
 * @property {(action: (session: Session) => unknown) => void} act
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: State) => void) => void} onState
 */

/** Iterations per second at the last position of the slider before "max"; at the first it is 1. */
const FASTEST = 10000;

export class Transport {
  /** @param {Page} page */
  constructor(page) {
    /** @param {string} id @param {(session: Session) => unknown} action */
    const buttonOf = (id, action) => {
      const button = byId(id, HTMLButtonElement);
      button.addEventListener("click", () => page.act(action));
      return button;
    };
    this.bar = byId("transport", HTMLElement);
    this.play = buttonOf("play", ({ timeline }) => timeline.toggle());
    this.steps = [1, 10, 100].map((count) => buttonOf(`step-${count}`, ({ timeline }) => timeline.step(count)));
    this.finish = buttonOf("finish", ({ timeline }) => timeline.finish());
    this.reset = buttonOf("reset", (session) => session.reset());
    this.back = buttonOf("back", ({ timeline }) => timeline.step(-1));
    this.speed = byId("speed", HTMLInputElement);
    this.speedValue = byId("speed-value", HTMLOutputElement);
    this.along = byId("along", HTMLInputElement);
    this.timeline = byId("timeline", HTMLInputElement);
    this.time = byId("time", HTMLInputElement);
    /** Time in a step. */
    this.unit = 1;
    /** Whether the field holds a time that was not entered yet. */
    this.isTyping = false;
    this.timeline.addEventListener("input", () =>
      page.act(({ timeline }) => timeline.seek(Number(this.timeline.value))),
    );
    this.along.addEventListener("input", () => page.act(({ timeline }) => timeline.along(Number(this.along.value))));
    this.time.addEventListener("input", () => {
      this.isTyping = true;
    });
    this.time.addEventListener("blur", () => {
      this.isTyping = false;
    });
    this.time.addEventListener("change", () => {
      this.isTyping = false;
      const time = Number(this.time.value);
      if (this.time.value.trim() !== "" && Number.isSafeInteger(time) && time >= 0)
        page.act(({ timeline }) => timeline.seek(time));
    });
    this.speed.addEventListener("input", () => {
      this.showSpeed();
      page.session.clock.pace = this.pace;
    });
    this.showSpeed();
    page.onState((state) => this.show(state));
    page.onOpen(() => {
      this.pace = page.session.clock.pace;
    });
  }

  /** Iterations a second; Infinity at the right end. */
  get pace() {
    const value = Number(this.speed.value);
    const last = Number(this.speed.max);
    return value >= last ? Infinity : FASTEST ** (value / (last - 1));
  }

  set pace(pace) {
    const last = Number(this.speed.max);
    const part = Math.log(pace) / Math.log(FASTEST);
    this.speed.value =
      pace === Infinity ? this.speed.max : String(Math.round(Math.min(1, Math.max(0, part)) * (last - 1)));
    this.showSpeed();
  }

  showSpeed() {
    const pace = this.pace;
    const speed = pace * this.unit;
    const text = pace === Infinity ? "max" : `${speed < 10 ? speed.toFixed(1) : grouped(Math.round(speed))}/s`;
    this.speedValue.textContent = text;
    this.speed.setAttribute(
      "aria-valuetext",
      pace === Infinity ? "as fast as possible" : `${text.replace("/s", "")} ${this.name} a second`,
    );
  }

  /** The name of the unit of time. */
  get name() {
    return this.unit > 1 ? "clearance evaluations" : "iterations";
  }

  /** Changes the unit of time. @param {State["clock"]} clock */
  setUnit({ unit }) {
    this.unit = unit;
    const { name } = this;
    this.timeline.setAttribute(
      "aria-label",
      unit > 1 ? "Timeline: clearance evaluations shown" : "Timeline: iteration shown",
    );
    byId("time-name", HTMLElement).textContent = unit > 1 ? "Clearance evaluations" : "Iteration";
    this.back.setAttribute("aria-label", unit > 1 ? `Back ${unit} ${name}` : "Step back");
    this.steps.forEach((button, i) => {
      const count = grouped(unit * 10 ** i);
      button.textContent = count;
      button.setAttribute("aria-label", unit > 1 ? `Step ${count} ${name}` : `Step ${count}`);
    });
    this.showSpeed();
  }

  /** @param {State} state */
  show({ clock, playing, growing, travelling, along, timed, lanes }) {
    if (clock.unit !== this.unit) this.setUnit(clock);
    const ready = lanes.some(({ status }) => status !== "none");
    this.play.disabled = !ready || (!growing && !travelling && clock.head === 0);
    this.play.dataset.playing = String(playing);
    write(byId("play-label", HTMLElement), playing ? "Pause" : "Play");
    for (const button of [...this.steps, this.finish]) button.disabled = !ready || !growing;
    this.back.disabled = !ready || clock.now === 0;
    this.reset.disabled = !ready;
    this.speed.disabled = !ready;
    byId("speed-row", HTMLElement).hidden = travelling;
    byId("along-row", HTMLElement).hidden = !travelling;
    if (!this.along.matches(":active")) this.along.value = String(along);
    write(byId("along-name", HTMLElement), timed ? "Time" : "Path");
    this.along.setAttribute(
      "aria-valuetext",
      timed ? secondsText(timed.time, timed.end) : `${Math.round(100 * along)} percent of the path`,
    );
    this.timeline.disabled = this.time.disabled = !ready;
    const head = String(clock.head);
    if (this.timeline.max !== head) this.timeline.max = head;
    if (!this.timeline.matches(":active")) this.timeline.value = String(clock.now);
    this.timeline.setAttribute(
      "aria-valuetext",
      `${grouped(clock.now)} of ${grouped(clock.head)}${clock.isRace ? " clearance evaluations" : ""}`,
    );
    if (!this.isTyping) this.time.value = String(clock.now);
    write(byId("brief", HTMLElement), brief(lanes));
    write(byId("time-head", HTMLElement), `of ${grouped(clock.head)}${clock.isRace ? " evaluations" : ""}`);
  }
}

/** The status in a few words, for small screens. @param {State["lanes"]} lanes */
function brief(lanes) {
  const [{ status, reason, phase, length, unit, iteration }] = lanes;
  if (lanes.length > 1 || status === "none") return "";
  if (status === "solved") return length === null ? "Path found" : `Path found: ${length.toFixed(2)} ${unit}`;
  return `${status === "exhausted" ? capital(endText(reason)) : phase} \u00b7 ${grouped(iteration)}`;
}
