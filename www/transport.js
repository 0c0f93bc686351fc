/**
 * The transport: play and pause, steps, run to the end, reset, speed, and once solved, in its place, the way along the path.
 * It only tells what was asked; what it shows is set from outside.
 */
import { byId } from "./dom.js";

/** Iterations a second at the left end of the slider and one notch before its right end, which means as fast as it goes. */
const SLOWEST = 1;
const FASTEST = 10000;

/**
 * @typedef {object} Orders
 * @property {() => void} toggle
 * @property {(iterations: number) => void} step
 * @property {() => void} finish
 * @property {() => void} reset
 * @property {(part: number) => void} seek   0 to 1 along the path
 */

export class Transport {
  /** @param {Orders} orders */
  constructor(orders) {
    this.bar = byId("transport", HTMLElement);
    this.play = byId("play", HTMLButtonElement);
    this.playLabel = byId("play-label", HTMLElement);
    this.steps = [1, 10, 100].map((count) => {
      const button = byId(`step-${count}`, HTMLButtonElement);
      button.addEventListener("click", () => orders.step(count));
      return button;
    });
    this.finish = byId("finish", HTMLButtonElement);
    this.reset = byId("reset", HTMLButtonElement);
    this.speed = byId("speed", HTMLInputElement);
    this.speedValue = byId("speed-value", HTMLOutputElement);
    this.speedRow = byId("speed-row", HTMLElement);
    this.along = byId("along", HTMLInputElement);
    this.alongRow = byId("along-row", HTMLElement);
    this.play.addEventListener("click", orders.toggle);
    this.finish.addEventListener("click", orders.finish);
    this.reset.addEventListener("click", orders.reset);
    this.speed.addEventListener("input", () => this.tellSpeed());
    this.along.addEventListener("input", () => orders.seek(Number(this.along.value)));
    this.tellSpeed();
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
    const text = pace === Infinity ? "max" : `${pace < 10 ? pace.toFixed(1) : Math.round(pace).toLocaleString("en")}/s`;
    this.speedValue.textContent = text;
    this.speed.setAttribute("aria-valuetext", pace === Infinity ? "as fast as it goes" : `${text.replace("/s", "")} iterations a second`);
  }

  /**
   * @param {object} state
   * @param {boolean} state.ready      there is a run
   * @param {boolean} state.playing
   * @param {boolean} state.growing    the run is not finished
   * @param {boolean} state.travelling a path is there to be followed
   */
  show({ ready, playing, growing, travelling }) {
    this.play.disabled = !ready || (!growing && !travelling);
    this.play.dataset.playing = String(playing);
    this.playLabel.textContent = playing ? "Pause" : "Play";
    for (const button of [...this.steps, this.finish]) button.disabled = !ready || !growing;
    this.reset.disabled = !ready;
    this.speed.disabled = !ready;
    this.speedRow.hidden = travelling;
    this.alongRow.hidden = !travelling;
  }

  /** @param {number} part  0 to 1 along the path */
  showAlong(part) {
    if (document.activeElement !== this.along || !this.along.matches(":active")) this.along.value = String(part);
    this.along.setAttribute("aria-valuetext", `${Math.round(100 * part)} percent of the way`);
  }
}
