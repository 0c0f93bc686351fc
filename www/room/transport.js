/**
 * Play, pause, step, speed: the bar under a stage on which something goes on by itself. It counts in whatever the room counts in,
 * and asks for as much as is due; whether the answer comes at once or later is the room's own business.
 *
 * What tests may rely on: its play button carries `data-playing`.
 */
import { grouped } from "../planner/counters.js";
import { make } from "../app/dom.js";
import { watchKeys } from "../app/keys.js";

/** @import { Room } from "./room.js" */

/**
 * @typedef {object} Course   what goes on
 * @property {string} name       begins the ids of its buttons
 * @property {string} label
 * @property {string} unit       what is counted, in the plural
 * @property {number[]} steps    as many are made at the press of a button
 * @property {number} slowest    a second
 * @property {number} fastest
 * @property {number} pace
 * @property {(count: number) => boolean | Promise<boolean>} advance   goes on by so many, more than 0; whether there is more to come
 * @property {() => void} reset
 * @property {boolean} [canFinish]   is there a button that goes on to the end, as fast as it goes?
 * @property {boolean} [isWhole]   are they counted whole? true where absent
 * @property {(pace: number) => string} [told]   the pace in a word or two
 */

/** Milliseconds of a frame for going on to the end, and units asked for at once. */
const SLICE = 8;
const AT_ONCE = 50;

/** Longest pause between two frames that is made up for, seconds. */
const LONGEST = 0.1;

export class Transport {
  /** @param {Room} room @param {HTMLElement} host @param {Course} course @param {HTMLElement[]} [hears]  elements on which its keys are heard, beside its own */
  constructor(room, host, course, hears = []) {
    this.room = room;
    this.course = course;
    this.isPlaying = false;
    this.isAsking = false;
    this.isFinishing = false;
    /** Units that are due, and when that was found. */
    this.due = 0;
    this.last = 0;
    const { name, label, steps } = course;
    this.word = make("span", { className: "word" }, "Play");
    this.play = make("button", { type: "button", id: `${name}-play`, className: "primary" }, icon("icon-play", "M5 3v14l12-7z"), icon("icon-pause", "M4.5 3h4v14h-4zm7 0h4v14h-4z"), this.word);
    this.steps = steps.map((count) => make("button", { type: "button", id: `${name}-step-${count}`, ariaLabel: `Step ${count}` }, String(count)));
    this.reset = make("button", { type: "button", id: `${name}-reset` }, "Reset");
    this.finish = make("button", { type: "button", id: `${name}-finish`, hidden: !course.canFinish }, "To the end");
    this.finish.addEventListener("click", () => {
      this.start();
      this.isFinishing = true;
    });
    this.speed = make("input", { type: "range", id: `${name}-speed`, min: "0", max: "100", step: "1", ariaLabel: "Speed" });
    this.told = make("output", {});
    const group = make("div", { className: "steps" }, ...this.steps);
    group.setAttribute("role", "group");
    group.setAttribute("aria-label", "Step");
    this.bar = make("div", { className: "transport", id: `${name}-transport` }, this.play, ...(steps.length > 0 ? [group] : []), this.finish, this.reset,
      make("label", { className: "speed", htmlFor: this.speed.id }, make("span", {}, "Speed"), this.speed, this.told));
    this.bar.setAttribute("role", "toolbar");
    this.bar.setAttribute("aria-label", label);
    host.append(this.bar);
    this.play.addEventListener("click", () => this.toggle());
    this.steps.forEach((button, i) => button.addEventListener("click", () => this.step(steps[i])));
    this.reset.addEventListener("click", () => this.restart());
    this.speed.addEventListener("input", () => this.tellSpeed());
    this.speed.value = String(Math.round(100 * this.partOf(course.pace)));
    this.tellSpeed();
    this.tell();
    const step = () => this.step(steps[0]);
    watchKeys([this.bar, ...hears], { " ": () => this.toggle(), r: () => this.restart(), ...(steps.length > 0 ? { ".": step } : {}) });
    room.onFrame((now) => this.move(now));
  }

  /** @param {number} pace */
  partOf(pace) { return Math.log(pace / this.course.slowest) / Math.log(this.course.fastest / this.course.slowest); }

  /** Units a second. */
  get pace() { return this.course.slowest * (this.course.fastest / this.course.slowest) ** (Number(this.speed.value) / 100); }

  tellSpeed() {
    const { pace, course: { unit, told } } = this;
    const text = told?.(pace) ?? `${pace < 10 ? pace.toFixed(1) : grouped(Math.round(pace))}/s`;
    this.told.textContent = text;
    this.speed.setAttribute("aria-valuetext", told ? text : `${text.replace("/s", "")} ${unit} a second`);
  }

  toggle() {
    if (this.play.disabled) return;
    if (this.isPlaying) this.pause();
    else this.start();
  }

  start() {
    this.isPlaying = true;
    this.due = 0;
    this.last = performance.now();
    this.tell();
    this.room.wake();
  }

  pause() {
    this.isPlaying = this.isFinishing = false;
    this.tell();
    this.room.wake();
  }

  /** @param {number} count */
  step(count) {
    if (this.steps[0]?.disabled) return;
    this.pause();
    this.ask(count);
  }

  restart() {
    this.pause();
    this.course.reset();
  }

  /** Is there anything to play? @param {boolean} isReady @param {boolean} [canStep] */
  enable(isReady, canStep = isReady) {
    this.play.disabled = !isReady;
    for (const button of [...this.steps, this.finish]) button.disabled = !canStep;
    if (!isReady && this.isPlaying) this.pause();
  }

  tell() {
    this.play.dataset.playing = String(this.isPlaying);
    this.word.textContent = this.isPlaying ? "Pause" : "Play";
  }

  /** @param {number} now */
  move(now) {
    if (!this.isPlaying) return false;
    if (this.isFinishing) {
      const until = performance.now() + SLICE;
      do this.ask(AT_ONCE); while (this.isFinishing && !this.isAsking && performance.now() < until);
      return this.isPlaying;
    }
    const { pace, course: { isWhole = true } } = this;
    this.due += pace * Math.min(LONGEST, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const count = isWhole ? Math.floor(this.due) : this.due;
    if (count > 0 && !this.isAsking) {
      this.due -= count;
      this.ask(count);
    }
    return this.isPlaying;
  }

  /** @param {number} count */
  ask(count) {
    if (this.isAsking) return;
    const answer = this.room.guard(() => this.course.advance(count)) ?? false;
    if (typeof answer === "boolean") {
      if (!answer && this.isPlaying) this.pause();
      return;
    }
    this.isAsking = true;
    void this.room.await(answer).then((goesOn) => {
      this.isAsking = false;
      if (!goesOn && this.isPlaying) this.pause();
    });
  }
}

/** @param {string} name @param {string} path */
function icon(name, path) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  element.setAttribute("class", name);
  element.setAttribute("viewBox", "0 0 20 20");
  element.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS("http://www.w3.org/2000/svg", "path");
  shape.setAttribute("d", path);
  shape.setAttribute("fill", "currentColor");
  element.append(shape);
  return element;
}
