/**
 * The controls of the keyboard car: keys, buttons, state, recordings and the preview of one control. They replace the
 * transport.
 */
import { json, save } from "../../app/files.js";
import { parsed } from "../../formats/json.js";
import { EULER_STEPS } from "../../domain/euler-steps.js";
import { keysOf } from "../../domain/key-text.js";
import { Driving, FORMAT } from "./driving.js";
import { byId, make, write } from "../../app/dom.js";
import { button, row, toggle } from "../../widgets/elements.js";
import { num } from "../../widgets/format.js";

/** @import { DriveKey } from "planarium" */
/** @import { App } from "../../app/app.js" */
/** @import { Session } from "./driving.js" */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {App["notice"]} notice
 * @property {Session} session
 * @property {boolean} calm   with reduced motion
 * @property {{ name: string } | null} facts
 * @property {(action: () => void) => void} run
 * @property {(action: () => void) => void} act
 * @property {(listener: () => void) => void} onState
 */

/** @type {Record<string, DriveKey>} */
const KEYS = {
  ArrowUp: "faster",
  ArrowDown: "slower",
  ArrowLeft: "left",
  ArrowRight: "right",
  w: "faster",
  s: "slower",
  a: "left",
  d: "right",
  c: "keep",
};
/** @type {[DriveKey, string, string, string][]} */
const PAD = [
  ["faster", "Accelerate", "M10 3 4 12h12z", "ArrowUp"],
  ["left", "Steer left", "M4 10l9-6v12z", "ArrowLeft"],
  ["slower", "Brake or reverse", "M10 17 4 8h12z", "ArrowDown"],
  ["right", "Steer right", "M16 10 7 4v12z", "ArrowRight"],
];
const NUMBERS = /** @type {const} */ ([
  ["v", "v"],
  ["phi", "\u03c6"],
  ["x", "x"],
  ["y", "y"],
  ["theta", "\u03b8"],
  ["time", "time"],
]);
const LABEL = "Stage. The arrow keys or W, A, S and D drive; C holds the controls; P pauses; R restarts; Escape exits.";

export class DriveControls {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.driving = page.session.driving = new Driving(page.session);
    this.stage = byId("stage", HTMLElement);
    this.column = /** @type {HTMLElement} */ (this.stage.parentElement);
    this.label = this.stage.getAttribute("aria-label") ?? "";
    this.message = "";
    this.on = false;
    const pad = make(
      "div",
      { className: "pad" },
      ...PAD.map(([key, name, path, shortcut]) => {
        const arrow = this.button(key, "", shortcut, (event) => this.press(key, event));
        arrow.ariaLabel = name;
        arrow.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="${path}" fill="currentColor"/></svg>`;
        return arrow;
      }),
    );
    /** By key. */
    this.actions = {
      p: () => this.act((driving) => driving.pause(moment())),
      r: () => this.act((driving) => driving.restart(moment())),
      Escape: () => this.leave(),
    };
    const keep = this.button("keep", "Hold controls", "C", (event) => this.press("keep", event));
    this.pause = this.button("pause", "Pause", "P", this.actions.p);
    const restart = this.button("restart", "Restart", "R", this.actions.r);
    this.replay = this.button("replay", "Replay", "", () => this.act((driving) => driving.replay(moment())));
    const leave = this.button("leave", "Exit", "Escape", this.actions.Escape);
    this.cells = Object.fromEntries(NUMBERS.map(([name]) => [name, make("dd", {})]));
    this.apart = make("dd", {});
    this.gap = make("div", { hidden: true }, make("dt", {}, "gap to Euler"), this.apart);
    const cells = NUMBERS.map(([name, title]) => make("div", {}, make("dt", {}, title), this.cells[name]));
    const numbers = make("dl", { className: "counters" }, ...cells, this.gap);
    this.byKeys = toggle("drive-by-keys", (isOn) => this.act((driving) => driving.setByKeys(isOn, moment())));
    const setEuler = () => this.act((driving) => driving.setEuler(this.euler.checked ? Number(this.dt.value) : 0));
    this.euler = toggle("drive-euler", setEuler);
    const steps = EULER_STEPS.map((dt) => make("option", { value: String(dt) }, `${dt} s`));
    this.dt = make("select", { id: "drive-dt" }, ...steps);
    this.dt.value = "0.1";
    this.dt.onchange = setEuler;
    this.rolled = make("p", { className: "hint", role: "status" });
    /** The fields of one control: v, phi and the duration. @type {HTMLInputElement[]} */
    this.fields = [];
    this.more = make(
      "details",
      { className: "more" },
      make("summary", {}, "More"),
      row("Advance time only when a key is pressed", this.byKeys),
      row("Euler steps beside the arc", this.euler),
      row("Euler\u2019s step", this.dt),
      this.makeRollout(),
      this.makeRecord(),
    );
    this.bar = make(
      "div",
      { id: "drive", className: "drive", hidden: true, role: "group", ariaLabel: "Driving" },
      pad,
      make(
        "div",
        { className: "dash" },
        numbers,
        make("div", { className: "buttons" }, keep, this.pause, restart, this.replay, leave),
      ),
      this.more,
    );
    this.stage.after(this.bar);
    // Before the page's own keys, some of which are the same.
    for (const element of [this.stage, this.bar]) element.addEventListener("keydown", (event) => this.key(event), true);
    page.onState(() => this.show(this.driving));
  }

  /** @param {string} name @param {string} text @param {string} shortcut @param {(event: Event) => void} then */
  button(name, text, shortcut, then) {
    return Object.assign(button(`drive-${name}`, text, then), { ariaKeyShortcuts: shortcut || null });
  }

  makeRollout() {
    const field = (
      /** @type {string} */ id,
      /** @type {string} */ name,
      /** @type {string} */ unit,
      /** @type {string} */ value,
    ) => {
      const input = make("input", {
        type: "number",
        id: `roll-${id}`,
        step: "any",
        value,
        inputMode: "decimal",
      });
      return {
        input,
        row: make(
          "label",
          { className: "row" },
          make("span", { className: "name" }, name, make("span", { className: "unit" }, ` ${unit}`)),
          input,
        ),
      };
    };
    const fields = [
      field("v", "v", "m/s", "0.3"),
      field("phi", "\u03c6", "rad", "0.4"),
      field("duration", "duration", "s", "3"),
    ];
    this.fields = fields.map(({ input }) => input);
    const form = make(
      "form",
      { noValidate: true, className: "roll", ariaLabel: "Preview of one control" },
      ...fields.map(({ row }) => row),
      make("button", { type: "submit" }, "Show the motion"),
      this.rolled,
    );
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const [v, phi, duration] = this.fields.map((input) => input.valueAsNumber);
      for (const input of this.fields) input.ariaInvalid = null;
      try {
        this.page.run(() => this.driving.roll(v, phi, duration));
      } catch (error) {
        const { pointer = "", message } = /** @type {{ pointer?: string, message: string }} */ (error);
        this.fields[["/v", "/phi", "/duration"].indexOf(pointer)]?.setAttribute("aria-invalid", "true");
        this.rolled.textContent = message;
      }
    });
    return form;
  }

  makeRecord() {
    const keep = button("drive-save", "Save recording", () => {
      const record = this.driving.record();
      if (record) save(json(record), `${this.page.facts?.name ?? "car"}-drive.json`);
    });
    const file = make("input", {
      type: "file",
      id: "drive-file",
      accept: ".json,application/json",
      className: "visually-hidden",
      tabIndex: -1,
      ariaLabel: "Recording of a drive",
    });
    const open = button("drive-open", "Open recording\u2026", () => file.click());
    file.addEventListener("change", async () => {
      const [picked] = file.files ?? [];
      if (picked) await this.page.app.track(this.open(picked), `${picked.name} cannot be replayed.`);
      file.value = "";
    });
    return make("div", { className: "buttons" }, keep, open, file);
  }

  /** @param {File} file */
  async open(file) {
    const { page } = this;
    const record = parsed(await file.text());
    const fault =
      record?.format !== FORMAT
        ? `This is not a recording of a drive: its format is not ${FORMAT}.`
        : record.scenario !== page.facts?.name
          ? `It was recorded in the scene "${record.scenario}".`
          : "";
    if (fault) throw new Error(fault);
    page.notice.hide();
    page.run(() => this.driving.replay(moment(), record));
    this.stage.focus();
  }

  /** @param {(driving: Driving) => void} action */
  act(action) {
    this.page.act(() => action(this.driving));
  }

  /** @param {DriveKey} key @param {Event} event */
  press(key, event) {
    this.act((driving) => driving.press(key, performance.timeOrigin + event.timeStamp));
  }

  /** Begins to drive. @param {number[]} [from]  a configuration, by default the start @throws {Error} it collides */
  start(from) {
    const { page } = this;
    // A car is not edited while it is driven.
    byId("editor-fold", HTMLDetailsElement).open = false;
    page.run(() => this.driving.start(page.calm, moment(), from));
  }

  /**
   * Drives as a link says: a recording is replayed; with a control, the motion of that control from the recording's
   * end is shown.
   * @param {{ start?: number[], keys?: string, steps?: number }} drive
   * @param {[number, number, number]} [roll]   v, phi and seconds
   * @param {number} [euler]   seconds in a step
   * @throws {Error} with `code` and `pointer`
   */
  restore({ start, keys = "", steps = 0 }, roll, euler) {
    const { driving } = this;
    const recording = { record: keysOf(keys), steps };
    this.start(start);
    this.euler.checked = euler !== undefined;
    if (euler) this.dt.value = String(euler);
    this.page.run(() => {
      driving.setEuler(euler ?? 0);
      if (roll) {
        driving.begin(recording.record, steps, moment());
        driving.paused = true;
        this.fields.forEach((input, i) => {
          input.value = String(roll[i]);
        });
        // On a phone the form would cover the stage.
        this.more.open = matchMedia("(min-width: 44rem)").matches;
        driving.roll(...roll);
      } else if (steps > 0) driving.replay(moment(), recording);
    });
  }

  /** Begins or ends driving. */
  toggle() {
    const { page } = this;
    if (this.on) this.leave();
    else
      page.app.guard(() => {
        this.start();
        this.stage.focus({ preventScroll: true });
        this.column.scrollIntoView({ block: "start", behavior: page.calm ? "auto" : "smooth" });
      }, "This scene cannot be driven.");
  }

  leave() {
    this.act((driving) => driving.stop());
    byId("your-turn", HTMLButtonElement).focus();
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (!this.on || event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const isTyped = event.target instanceof HTMLInputElement && event.target.type !== "checkbox";
    if (isTyped && key !== "Escape") return;
    const isOnStage = event.target === this.stage;
    const drives = KEYS[key];
    /** @type {Partial<Record<string, () => void>>} */
    const actions = this.actions;
    const action = drives ? () => this.press(drives, event) : actions[isOnStage && key === " " ? "p" : key];
    if (action || (isOnStage && /^[.,en]$/.test(key))) event.preventDefault();
    // A key held down counts once.
    if (!event.repeat) action?.();
  }

  /** @param {Driving} driving */
  show({ on, state, paused, byKeys, tape, announcement, arrived, rollout, dt, beside }) {
    const isNew = on !== this.on;
    if (isNew) {
      this.on = on;
      this.bar.hidden = !on;
      this.column.classList.toggle("driving", on);
      this.stage.setAttribute("aria-label", on ? LABEL : this.label);
      this.message = "";
    }
    if (!state) return;
    const { v, phi, seconds, steps, blocked, keyCount } = state;
    const [x, y, theta] = state.pose;
    const replaying = tape !== null;
    Object.assign(this.bar.dataset, {
      v,
      phi,
      x,
      y,
      theta,
      steps,
      keys: keyCount,
      blocked: blocked ?? "",
      paused,
      replaying,
      arrived,
    });
    const degrees = (/** @type {number} */ angle, /** @type {number} */ digits) =>
      `${num((angle * 180) / Math.PI, digits)}\u00b0`;
    const words = {
      v: `${num(v)} m/s`,
      phi: degrees(phi, 0),
      x: `${num(x, 3)} m`,
      y: `${num(y, 3)} m`,
      theta: degrees(theta, 1),
      time: `${num(seconds)} s`,
    };
    for (const [name, word] of Object.entries(words)) write(this.cells[name], word);
    this.gap.hidden = dt === 0;
    write(this.apart, beside ? (beside.apart === null ? "blocked" : `${num(beside.apart, 3)} m`) : "\u2013");
    write(this.pause, paused ? "Resume" : "Pause");
    this.pause.disabled = byKeys;
    this.replay.disabled = keyCount === 0 && !replaying;
    if (this.byKeys !== document.activeElement || isNew) this.byKeys.checked = byKeys;
    if (rollout && announcement.startsWith("Free for")) write(this.rolled, announcement);
    const message = arrived ? "At the goal." : announcement;
    if (message && message !== this.message) {
      this.message = message;
      this.page.app.announcer.say(message);
    }
  }
}

/** The time now, in milliseconds since the epoch. */
function moment() {
  return performance.timeOrigin + performance.now();
}
