/** From A to B: the two poses are kept, each joint goes the short or the long way round, and the way is played. */
import { byId, make } from "../app/dom.js";
import { Transport } from "../room/transport.js";

/** @import { Bench, Change } from "./bench.js" */
/** @import { Round } from "./way.js" */

/** Parts of the way in one step. */
const STEP = 0.01;

export class Between {
  /** @param {Bench} bench @param {HTMLElement} stage   where its keys are heard too */
  constructor(bench, stage) {
    this.bench = bench;
    this.host = byId("between", HTMLElement);
    this.slider = make("input", { type: "range", id: "along", className: "timeline", min: "0", max: "1", step: "0.001", value: "0", ariaLabel: "Along the way from A to B" });
    this.slider.addEventListener("input", () => {
      this.transport.pause();
      bench.goTo(Number(this.slider.value));
    });
    this.transport = new Transport(bench.room, this.host, {
      name: "between", label: "The way from A to B", unit: "hundredths of the way", steps: [1, 10], slowest: 4, fastest: 200, pace: 28, isWhole: false,
      advance: (count) => {
        bench.goTo(bench.along + count * STEP);
        return bench.along < 1;
      },
      reset: () => bench.goTo(0),
      told: (pace) => `${(1 / (pace * STEP)).toFixed(1)} s`,
    }, []);
    this.transport.bar.prepend(this.slider);
    // From the end it begins anew.
    this.transport.play.addEventListener("click", () => { if (this.transport.isPlaying && bench.along >= 1) bench.goTo(0); });
    stage.addEventListener("keydown", (event) => {
      if (bench.mode !== "between" || event.target !== stage || event.key !== " ") return;
      event.preventDefault();
      this.transport.play.click();
    });
    this.settings = byId("between-settings", HTMLElement);
    this.rounds = make("div", { id: "rounds" });
    this.settings.append(
      make("div", { className: "buttons" }, this.button("set-a", "A is here", () => { bench.a = Float64Array.from(bench.arm.q); bench.along = 0; }),
        this.button("set-b", "B is here", () => { bench.b = Float64Array.from(bench.arm.q); bench.along = 1; }),
        this.button("swap", "Swap", () => { [bench.a, bench.b] = [bench.b, bench.a]; bench.along = 0; })),
      make("div", { className: "buttons" }, this.button("all-short", "All the short way", () => this.all("short")), this.button("all-long", "All the long way", () => this.all("long"))),
      this.rounds,
    );
    bench.onChange((change) => this.show(change));
  }

  /** @param {string} id @param {string} word @param {() => void} act */
  button(id, word, act) {
    const button = make("button", { type: "button", id }, word);
    button.addEventListener("click", () => {
      this.transport.pause();
      act();
      const { bench } = this;
      if (bench.mode === "between") bench.goTo(bench.along);
      bench.tell("rest");
    });
    return button;
  }

  /** @param {Round} round */
  all(round) {
    const { bench } = this;
    bench.rounds = bench.arm.joints.map(({ isCircle }) => (isCircle ? round : "short"));
    bench.along = 0;
  }

  /** @param {Change} change */
  show(change) {
    const { bench } = this;
    const isOn = bench.mode === "between";
    this.host.hidden = !isOn;
    if (!isOn && this.transport.isPlaying) this.transport.pause();
    if (!this.slider.matches(":active")) this.slider.value = String(bench.along);
    this.slider.setAttribute("aria-valuetext", `${Math.round(100 * bench.along)} percent of the way`);
    if (change === "pose") return;
    const { arm } = bench;
    if (this.rounds.childElementCount !== arm.dimension || change === "arm") this.build();
    arm.joints.forEach(({ isCircle }, i) => {
      for (const button of this.rounds.children[i].querySelectorAll("button")) {
        button.setAttribute("aria-pressed", String((bench.rounds[i] === "long") === (button.dataset.round === "long")));
        button.disabled = !isCircle;
      }
    });
    for (const id of ["all-short", "all-long"]) byId(id, HTMLButtonElement).disabled = arm.hasLimits;
  }

  build() {
    const { bench } = this;
    this.rounds.replaceChildren(...bench.arm.joints.map(({ name, isCircle }, i) => {
      const choose = (/** @type {Round} */ round) => {
        const button = make("button", { type: "button" }, round);
        button.dataset.round = round;
        button.setAttribute("aria-label", `${name} goes the ${round} way`);
        button.addEventListener("click", () => {
          this.transport.pause();
          bench.rounds = bench.rounds.map((one, j) => (j === i ? round : one));
          if (bench.mode === "between") bench.goTo(bench.along);
          bench.tell("rest");
        });
        return button;
      };
      const segments = make("div", { className: "segments" }, choose("short"), choose("long"));
      return make("div", { className: "row" }, make("span", { className: "name" }, name), isCircle ? segments : make("span", { className: "hint" }, segments, "between its stops there is one way"));
    }));
  }
}
