/**
 * Play, pause, step and speed for what a page plays, counted in its own units. With an axis it also shows the time and
 * seeks, and playing from the end starts again.
 *
 * For tests: the play button carries `data-playing`.
 */
import { grouped, make, makeSvg } from "../app/dom.js";
import { watchKeys } from "../app/keys.js";
import { button, labelled } from "./elements.js";
import { secondsText } from "./format.js";

/** @import { App } from "../app/app.js" */

/**
 * @typedef {object} Playback
 * @property {string} name       the ids of the buttons begin with it
 * @property {string} label
 * @property {string} unit       in the plural
 * @property {number[]} steps    units of each step button
 * @property {number} slowest    units a second
 * @property {number} fastest
 * @property {number} pace       at first
 * @property {(count: number) => boolean | Promise<boolean>} [advance]   moves on by a number of units; returns whether
 *   there is more. With an axis it seeks where absent
 * @property {() => void} [reset]   with an axis it seeks its start where absent
 * @property {Axis} [axis]
 * @property {boolean} [canFinish]   has it a button that runs to the end?
 * @property {boolean} [isWhole]   are the units counted whole? true where absent
 * @property {(pace: number) => string} [paceText]
 */

/**
 * The time axis.
 * @typedef {object} Axis
 * @property {string} id
 * @property {string} label
 * @property {() => number} end
 * @property {() => number} time
 * @property {(time: number) => void} seek
 * @property {number} [unit]   the part of the axis in a unit of the playback; 1 where absent
 * @property {string} [grain]   the step of the slider; any where absent
 * @property {(time: number, end: number) => string} [text]   for screen readers; in seconds where absent
 * @property {() => boolean} [isReady]   can it be played? true where absent
 */

/** Milliseconds of a frame spent on running to the end, and units of each call. */
const SLICE = 8;
const AT_ONCE = 50;
/** Seconds between two frames that count, at most. */
const LONGEST = 0.1;

export class Course {
  /**
   * @param {App} app
   * @param {HTMLElement} host
   * @param {Playback} playback
   * @param {HTMLElement[]} [keyTargets]  elements on which keys work, beside the bar
   */
  constructor(app, host, playback, keyTargets = []) {
    const { name, label, steps, axis, canFinish = false } = playback;
    this.app = app;
    this.playback = playback;
    this.isPlaying = false;
    this.isFinishing = false;
    /** Whether a promise of the playback is pending. */
    this.isBusy = false;
    /** Units due at the time of the last frame. */
    this.due = 0;
    this.last = 0;
    this.word = make("span", { className: "word" });
    this.play = button(`${name}-play`, "", () => this.toggle(), { className: "primary" });
    this.play.append(icon("icon-play", "M5 3v14l12-7z"), icon("icon-pause", "M4.5 3h4v14h-4zm7 0h4v14h-4z"), this.word);
    this.steps = steps.map((count) =>
      button(`${name}-step-${count}`, String(count), () => this.step(count), { ariaLabel: `Step ${count}` }),
    );
    this.finish = button(
      `${name}-finish`,
      "To the end",
      () => {
        this.setPlaying(true);
        this.isFinishing = true;
      },
      { hidden: !canFinish },
    );
    this.speed = make("input", {
      type: "range",
      id: `${name}-speed`,
      min: "0",
      max: "100",
      step: "1",
      ariaLabel: "Speed",
    });
    this.speed.value = String(
      Math.round((100 * Math.log(playback.pace / playback.slowest)) / Math.log(playback.fastest / playback.slowest)),
    );
    this.speed.addEventListener("input", () => this.showSpeed());
    this.speedText = make("output", {});
    this.bar = make(
      "div",
      { className: "transport", id: `${name}-transport` },
      this.play,
      labelled("group", "Step", make("div", { className: "steps" }, ...this.steps)),
      this.finish,
      button(`${name}-reset`, "Reset", () => this.restart()),
      make(
        "label",
        { className: "speed", htmlFor: this.speed.id },
        make("span", {}, "Speed"),
        this.speed,
        this.speedText,
      ),
    );
    this.slider = axis ? this.sliderOf(axis) : null;
    if (this.slider) this.bar.prepend(this.slider);
    host.append(labelled("toolbar", label, this.bar));
    this.showSpeed();
    this.setPlaying(false);
    watchKeys([this.bar, ...keyTargets], {
      " ": () => this.toggle(),
      r: () => this.restart(),
      ".": () => this.step(steps[0]),
    });
    app.onFrame((now) => this.move(now));
    app.onShow(() => this.show());
  }

  /** @param {Axis} axis */
  sliderOf({ id, label, grain = "any" }) {
    const slider = make("input", { type: "range", id, className: "timeline", min: "0", step: grain, ariaLabel: label });
    slider.addEventListener("input", () => this.seek(Number(slider.value)));
    return slider;
  }

  /** Shows the time on the axis. */
  show() {
    const { slider } = this;
    const { axis } = this.playback;
    if (!axis || !slider) return;
    const { text = secondsText, isReady = () => true } = axis;
    const [time, end] = [axis.time(), axis.end()];
    const isEnabled = end > 0 && isReady();
    this.enable(isEnabled);
    Object.assign(slider, { disabled: !isEnabled, max: String(end || 1) });
    if (!slider.matches(":active")) slider.value = String(time);
    slider.setAttribute("aria-valuetext", text(time, end));
  }

  /** Pauses, and shows another time of the axis. @param {number} time */
  seek(time) {
    this.pause();
    this.playback.axis?.seek(time);
  }

  /** Units a second. */
  get pace() {
    return this.playback.slowest * (this.playback.fastest / this.playback.slowest) ** (Number(this.speed.value) / 100);
  }

  showSpeed() {
    const { pace } = this;
    const { unit, paceText } = this.playback;
    const number = pace < 10 ? pace.toFixed(1) : grouped(Math.round(pace));
    this.speedText.textContent = paceText?.(pace) ?? `${number}/s`;
    this.speed.setAttribute("aria-valuetext", paceText?.(pace) ?? `${number} ${unit} a second`);
  }

  /** Plays or pauses; from the end it starts again. */
  toggle() {
    if (this.play.disabled) return;
    const { axis } = this.playback;
    if (!this.isPlaying && axis && axis.time() >= axis.end()) axis.seek(0);
    this.setPlaying(!this.isPlaying);
  }

  pause() {
    this.setPlaying(false);
  }

  /** @param {boolean} isPlaying */
  setPlaying(isPlaying) {
    this.isPlaying = isPlaying;
    this.isFinishing = false;
    this.due = 0;
    this.last = performance.now();
    this.play.dataset.playing = String(isPlaying);
    this.word.textContent = isPlaying ? "Pause" : "Play";
    this.app.changed();
  }

  /** @param {number} count */
  step(count) {
    if (this.steps[0].disabled) return;
    this.pause();
    this.advance(count);
  }

  restart() {
    const { reset, axis } = this.playback;
    this.pause();
    if (reset) reset();
    else axis?.seek(0);
  }

  /** Enables or disables the controls. @param {boolean} isReady */
  enable(isReady) {
    for (const element of [this.play, ...this.steps, this.finish]) element.disabled = !isReady;
    if (!isReady && this.isPlaying) this.pause();
  }

  /** @param {number} now */
  move(now) {
    if (!this.isPlaying) return false;
    if (this.isFinishing) {
      const until = performance.now() + SLICE;
      do this.advance(AT_ONCE);
      while (this.isFinishing && !this.isBusy && performance.now() < until);
      return this.isPlaying;
    }
    this.due += this.pace * Math.min(LONGEST, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const count = this.playback.isWhole === false ? this.due : Math.floor(this.due);
    if (count > 0 && !this.isBusy) {
      this.due -= count;
      this.advance(count);
    }
    return this.isPlaying;
  }

  /** @param {number} count */
  advance(count) {
    if (this.isBusy) return;
    const goOn = (/** @type {boolean | undefined} */ isMore) => {
      this.isBusy = false;
      if (!isMore && this.isPlaying) this.pause();
    };
    const { advance = (/** @type {number} */ units) => this.moveAlong(units) } = this.playback;
    const result = this.app.guard(() => advance(count));
    this.isBusy = result instanceof Promise;
    if (result instanceof Promise) void this.app.track(result).then(goOn);
    else goOn(result);
  }

  /** Moves along the axis. @param {number} count */
  moveAlong(count) {
    const { axis } = this.playback;
    if (!axis) return false;
    axis.seek(axis.time() + count * (axis.unit ?? 1));
    return axis.time() < axis.end();
  }
}

/** @param {string} name @param {string} path */
function icon(name, path) {
  return makeSvg(
    "svg",
    { class: name, viewBox: "0 0 20 20", "aria-hidden": "true" },
    makeSvg("path", { d: path, fill: "currentColor" }),
  );
}
