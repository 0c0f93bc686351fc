/**
 * The transport: back, play and pause, steps, run to the end, reset, speed, the timeline, and once solved the way along the path.
 * It passes on what was asked, and shows how things stand.
 */
import { byId, grouped, READABLE, write } from "../../app/dom.js";

/** @import { Page } from "../page.js" */
/** @import { State } from "../../domain/types.js" */

/** Iterations a second at the left end of the slider and one notch before its right end, which means as fast as it goes. */
const SLOWEST = 1;
const FASTEST = 10000;

export class Transport {
  /** @param {Page} page */
  constructor(page) {
    this.bar = byId("transport", HTMLElement);
    this.play = byId("play", HTMLButtonElement);
    this.playLabel = byId("play-label", HTMLElement);
    this.steps = [1, 10, 100].map((count) => {
      const button = byId(`step-${count}`, HTMLButtonElement);
      button.addEventListener("click", () => page.act(({ timeline }) => timeline.step(count)));
      return button;
    });
    this.finish = byId("finish", HTMLButtonElement);
    this.reset = byId("reset", HTMLButtonElement);
    this.speed = byId("speed", HTMLInputElement);
    this.speedValue = byId("speed-value", HTMLOutputElement);
    this.speedRow = byId("speed-row", HTMLElement);
    this.along = byId("along", HTMLInputElement);
    this.alongRow = byId("along-row", HTMLElement);
    this.back = byId("back", HTMLButtonElement);
    this.timeline = byId("timeline", HTMLInputElement);
    this.time = byId("time", HTMLInputElement);
    this.head = byId("time-head", HTMLElement);
    this.timeName = byId("time-name", HTMLElement);
    this.brief = byId("brief", HTMLElement);
    /** Time in a step, and that passes for an iteration of the pace. */
    this.unit = 1;
    /** Is something in the field that was not asked for yet? */
    this.isTyping = false;
    this.written = -Infinity;
    this.back.addEventListener("click", () => page.act(({ timeline }) => timeline.step(-1)));
    this.timeline.addEventListener("input", () => page.act(({ timeline }) => timeline.seek(Number(this.timeline.value))));
    this.time.addEventListener("input", () => { this.isTyping = true; });
    this.time.addEventListener("blur", () => { this.isTyping = false; });
    this.time.addEventListener("change", () => {
      this.isTyping = false;
      const time = Number(this.time.value);
      if (this.time.value.trim() !== "" && Number.isSafeInteger(time) && time >= 0) page.act(({ timeline }) => timeline.seek(time));
    });
    this.play.addEventListener("click", () => page.act(({ timeline }) => timeline.toggle()));
    this.finish.addEventListener("click", () => page.act(({ timeline }) => timeline.finish()));
    this.reset.addEventListener("click", () => page.act((session) => session.reset()));
    this.speed.addEventListener("input", () => {
      this.tellSpeed();
      page.session.clock.pace = this.pace;
    });
    this.along.addEventListener("input", () => page.act(({ timeline }) => timeline.along(Number(this.along.value))));
    this.tellSpeed();
    page.onState((state) => this.show(state));
    page.onOpen(() => {
      if (page.pace !== undefined) this.pace = page.pace;
    });
  }

  /** Iterations a second; Infinity at the right end. */
  get pace() {
    const value = Number(this.speed.value);
    const last = Number(this.speed.max);
    if (value >= last) return Infinity;
    return SLOWEST * (FASTEST / SLOWEST) ** (value / (last - 1));
  }

  set pace(pace) {
    const last = Number(this.speed.max);
    const part = Math.log(pace / SLOWEST) / Math.log(FASTEST / SLOWEST);
    this.speed.value = pace === Infinity ? this.speed.max : String(Math.round(Math.min(1, Math.max(0, part)) * (last - 1)));
    this.tellSpeed();
  }

  tellSpeed() {
    const pace = this.pace;
    const speed = pace * this.unit;
    const text = pace === Infinity ? "max" : `${speed < 10 ? speed.toFixed(1) : Math.round(speed).toLocaleString("en")}/s`;
    this.speedValue.textContent = text;
    this.speed.setAttribute("aria-valuetext", pace === Infinity ? "as fast as possible" : `${text.replace("/s", "")} ${this.name} a second`);
  }

  /** What time is counted in. */
  get name() { return this.unit > 1 ? "clearance evaluations" : "iterations"; }

  /** Time is counted in this from now on. @param {State["clock"]} clock */
  count({ unit }) {
    this.unit = unit;
    const { name } = this;
    this.timeline.setAttribute("aria-label", unit > 1 ? "Timeline: clearance evaluations shown" : "Timeline: iteration shown");
    this.timeName.textContent = unit > 1 ? "Clearance evaluations" : "Iteration";
    this.back.setAttribute("aria-label", unit > 1 ? `Back ${unit} ${name}` : "Step back");
    this.steps.forEach((button, i) => {
      const count = grouped(unit * 10 ** i);
      button.textContent = count;
      button.setAttribute("aria-label", unit > 1 ? `Step ${count} ${name}` : `Step ${count}`);
    });
    this.tellSpeed();
  }

  /** @param {State} state */
  show({ clock, playing, growing, travelling, along, lanes, settled }) {
    if (clock.unit !== this.unit) this.count(clock);
    const ready = lanes.some(({ status }) => status !== "none");
    this.play.disabled = !ready || (!growing && !travelling && clock.head === 0);
    this.play.dataset.playing = String(playing);
    write(this.playLabel, playing ? "Pause" : "Play");
    for (const button of [...this.steps, this.finish]) button.disabled = !ready || !growing;
    this.back.disabled = !ready || clock.now === 0;
    this.reset.disabled = !ready;
    this.speed.disabled = !ready;
    this.speedRow.hidden = travelling;
    this.alongRow.hidden = !travelling;
    if (!this.along.matches(":active")) this.along.value = String(along);
    this.along.setAttribute("aria-valuetext", `${Math.round(100 * along)} percent of the path`);
    this.timeline.disabled = this.time.disabled = !ready;
    const head = String(clock.head);
    if (this.timeline.max !== head) this.timeline.max = head;
    if (!this.timeline.matches(":active")) this.timeline.value = String(clock.now);
    this.timeline.setAttribute("aria-valuetext", `${grouped(clock.now)} of ${grouped(clock.head)}${clock.isRace ? " clearance evaluations" : ""}`);
    // As often as the numbers below are written, so that they agree.
    const now = performance.now();
    if (!settled && now - this.written < READABLE) return;
    this.written = now;
    if (!this.isTyping) this.time.value = String(clock.now);
    write(this.brief, brief(lanes));
    write(this.head, `of ${grouped(clock.head)}${clock.isRace ? " evaluations" : ""}`);
  }
}

/** How the run stands, in a few words: for those who see the controls and not the stage. @param {State["lanes"]} lanes */
function brief(lanes) {
  const [{ status, phase, length, unit, iteration }] = lanes;
  if (lanes.length > 1 || status === "none") return "";
  if (status === "solved") return length === null ? "Path found" : `Path found: ${length.toFixed(2)} ${unit}`;
  return `${status === "exhausted" ? "No path" : phase} \u00b7 ${grouped(iteration)}`;
}
