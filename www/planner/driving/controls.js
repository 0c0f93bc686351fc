/**
 * Driving: keys of the stage, buttons beneath it, what the car does in numbers, its record, and where one control would lead.
 * It takes the place of the transport while the reader drives.
 */
import { json, save } from "../../app/files.js";
import { drivingOf } from "./driving.js";
import { Announcer } from "../../app/announcer.js";
import { byId, make, write } from "../../app/dom.js";

/** @import { DriveKey } from "planarium" */
/** @import { Page } from "../page.js" */
/** @import { DriveOrder, DriveReport } from "../../domain/types.js" */

/** @type {Record<string, DriveKey>} */
const KEYS = {
  ArrowUp: "faster", ArrowDown: "slower", ArrowLeft: "left", ArrowRight: "right",
  w: "faster", s: "slower", a: "left", d: "right", c: "keep",
};
/** @type {[DriveKey, string, string, string][]} */
const PAD = [
  ["faster", "Accelerate", "M10 3 4 12h12z", "ArrowUp"], ["left", "Steer left", "M4 10l9-6v12z", "ArrowLeft"],
  ["slower", "Brake or reverse", "M10 17 4 8h12z", "ArrowDown"], ["right", "Steer right", "M16 10 7 4v12z", "ArrowRight"],
];
const NUMBERS = /** @type {const} */ ([["v", "v"], ["phi", "\u03c6"], ["x", "x"], ["y", "y"], ["theta", "\u03b8"], ["time", "time"]]);
/** The name of a format of records. */
const FORMAT = "planarium-drive-1";
const LABEL = "Stage. The arrow keys or W, A, S and D drive; C holds the controls; P pauses; R restarts; Escape exits.";

export class DriveControls {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.stage = byId("stage", HTMLElement);
    this.theatre = /** @type {HTMLElement} */ (this.stage.parentElement);
    this.announcer = new Announcer();
    this.label = this.stage.getAttribute("aria-label") ?? "";
    this.told = "";
    this.on = false;
    const pad = make("div", { className: "pad" }, ...PAD.map(([key, name, path, shortcut]) => {
      const button = make("button", { type: "button", id: `drive-${key}`, ariaLabel: name });
      button.setAttribute("aria-keyshortcuts", shortcut);
      button.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="${path}" fill="currentColor"/></svg>`;
      button.addEventListener("click", (event) => this.press(key, event));
      return button;
    }));
    const keep = this.button("keep", "Hold controls", "C", (event) => this.press("keep", event));
    this.pause = this.button("pause", "Pause", "P", () => this.order("pause", moment()));
    const anew = this.button("anew", "Restart", "R", () => this.order("anew", moment()));
    this.replay = this.button("replay", "Replay", "", () => this.order("replay", null, 0, moment()));
    const leave = this.button("leave", "Exit", "Escape", () => this.leave());
    this.cells = Object.fromEntries(NUMBERS.map(([name]) => [name, make("dd", {})]));
    const numbers = make("dl", { className: "counters" }, ...NUMBERS.map(([name, title]) => make("div", {}, make("dt", {}, title), this.cells[name])));
    this.byKeys = make("input", { type: "checkbox", role: "switch", id: "drive-by-keys" });
    this.byKeys.addEventListener("change", () => this.order("setByKeys", this.byKeys.checked, moment()));
    this.rolled = make("p", { className: "hint", role: "status" });
    this.bar = make("div", { id: "drive", className: "drive", hidden: true, role: "group", ariaLabel: "Driving" }, pad,
      make("div", { className: "dash" }, numbers, make("div", { className: "buttons" }, keep, this.pause, anew, this.replay, leave)),
      make("details", { className: "more" }, make("summary", {}, "More"),
        make("label", { className: "row" }, make("span", { className: "name" }, "Advance time only when a key is pressed"), this.byKeys),
        this.makeRollout(), this.makeRecord()));
    this.stage.after(this.bar);
    // Before the page's own keys, of which some are the same.
    for (const element of [this.stage, this.bar]) element.addEventListener("keydown", (event) => this.key(event), true);
    page.onState(({ drive }) => this.show(drive));
  }

  /** @param {string} name @param {string} text @param {string} shortcut @param {(event: Event) => void} then */
  button(name, text, shortcut, then) {
    const button = make("button", { type: "button", id: `drive-${name}` }, text);
    if (shortcut) button.setAttribute("aria-keyshortcuts", shortcut);
    button.addEventListener("click", then);
    return button;
  }

  /** A form for one control: where would it lead? */
  makeRollout() {
    const field = (/** @type {string} */ id, /** @type {string} */ name, /** @type {string} */ unit, /** @type {string} */ value) => {
      const input = make("input", { type: "number", id: `roll-${id}`, step: "any", value, autocomplete: "off", inputMode: "decimal" });
      return { input, row: make("label", { className: "row" }, make("span", { className: "name" }, name, make("span", { className: "unit" }, ` ${unit}`)), input) };
    };
    const fields = [field("v", "v", "m/s", "0.3"), field("phi", "\u03c6", "rad", "0.4"), field("duration", "duration", "s", "3")];
    const form = make("form", { noValidate: true, className: "roll" }, ...fields.map(({ row }) => row), make("button", { type: "submit" }, "Show the motion"), this.rolled);
    form.setAttribute("aria-label", "Preview of one control");
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const [v, phi, duration] = fields.map(({ input }) => (input.value.trim() === "" ? NaN : Number(input.value)));
      for (const { input } of fields) input.removeAttribute("aria-invalid");
      try {
        this.page.run((session) => drivingOf(session).roll(v, phi, duration));
      } catch (error) {
        const { pointer = "", message } = /** @type {{ pointer?: string, message: string }} */ (error);
        fields[["/v", "/phi", "/duration"].indexOf(pointer)]?.input.setAttribute("aria-invalid", "true");
        this.rolled.textContent = message;
      }
    });
    return form;
  }

  /** To keep the record, and to drive one that was kept. */
  makeRecord() {
    const keep = make("button", { type: "button", id: "drive-save" }, "Save recording");
    keep.addEventListener("click", () => {
      const record = this.page.session.driving?.record();
      if (record) save(json(record), `${this.page.facts?.name ?? "car"}-drive.json`);
    });
    const file = make("input", { type: "file", id: "drive-file", accept: ".json,application/json", className: "visually-hidden", tabIndex: -1, ariaLabel: "Recording of a drive" });
    const open = make("button", { type: "button", id: "drive-open" }, "Open recording\u2026");
    open.addEventListener("click", () => file.click());
    file.addEventListener("change", async () => {
      const [picked] = file.files ?? [];
      if (picked) await this.open(picked);
      file.value = "";
    });
    return make("div", { className: "buttons" }, keep, open, file);
  }

  /** @param {File} file */
  async open(file) {
    const { page } = this;
    try {
      const record = JSON.parse(await file.text());
      const fault = record?.format !== FORMAT ? `This is not a recording of a drive: its format is not ${FORMAT}.`
        : record.scenario !== page.facts?.name ? `It was recorded in the scene "${record.scenario}".` : "";
      if (fault) throw new Error(fault);
      page.notice.hide();
      page.run((session) => drivingOf(session).replay(record.record, record.steps, moment()));
      this.stage.focus();
    } catch (error) {
      page.notice.show(`${file.name} cannot be replayed.`, error);
    }
  }

  /** @param {DriveOrder} order */
  order(...order) { this.page.act((session) => drivingOf(session).obey(order)); }

  /** @param {DriveKey} key @param {Event} event */
  press(key, event) { this.order("press", key, performance.timeOrigin + event.timeStamp); }

  /** In or out. */
  toggle() {
    if (this.on) this.leave();
    else this.begin();
  }

  begin() {
    const { page } = this;
    try {
      // The same orders as the fold of the editor: a car is not edited while it is driven.
      byId("editor-fold", HTMLDetailsElement).open = false;
      page.run((session) => drivingOf(session).turn(true, page.calm, moment()));
      this.stage.focus({ preventScroll: true });
      this.theatre.scrollIntoView({ block: "start", behavior: page.calm ? "auto" : "smooth" });
    } catch (error) {
      page.notice.show("This scene cannot be driven.", error);
    }
  }

  leave() {
    this.order("turn", false, false, moment());
    byId("your-turn", HTMLButtonElement).focus();
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (!this.on || event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const isOwn = event.target instanceof HTMLInputElement && event.target.type !== "checkbox";
    const drives = KEYS[key];
    if (isOwn && key !== "Escape") return;
    if (drives || key === "p" || key === "r" || key === "Escape") {
      event.preventDefault();
      // A key that is held down is one press.
      if (event.repeat) return;
      if (drives) this.press(drives, event);
      else if (key === "p") this.order("pause", moment());
      else if (key === "r") this.order("anew", moment());
      else this.leave();
    } else if (key === " " && event.target === this.stage) {
      event.preventDefault();
      if (!event.repeat) this.order("pause", moment());
    } else if (event.target === this.stage && /^[.,en]$/.test(key)) event.preventDefault();
  }

  /** @param {DriveReport | null} drive */
  show(drive) {
    const isNew = (drive !== null) !== this.on;
    if (isNew) {
      this.on = drive !== null;
      this.bar.hidden = !this.on;
      this.theatre.classList.toggle("driving", this.on);
      this.stage.setAttribute("aria-label", this.on ? LABEL : this.label);
      this.told = "";
    }
    if (!drive) return;
    const { pose: [x, y, theta], v, phi, seconds, steps, blocked, paused, byKeys, replaying, said, arrived, keyCount, rollout } = drive;
    Object.assign(this.bar.dataset, {
      v: String(v), phi: String(phi), x: String(x), y: String(y), theta: String(theta), steps: String(steps), keys: String(keyCount),
      blocked: blocked === null ? "" : String(blocked), paused: String(paused), replaying: String(replaying), arrived: String(arrived),
    });
    const degrees = (/** @type {number} */ angle, /** @type {number} */ digits) => `${number((angle * 180) / Math.PI, digits)}\u00b0`;
    const words = { v: `${number(v, 2)} m/s`, phi: degrees(phi, 0), x: `${number(x, 3)} m`, y: `${number(y, 3)} m`, theta: degrees(theta, 1), time: `${number(seconds, 2)} s` };
    for (const [name, word] of Object.entries(words)) write(this.cells[name], word);
    write(this.pause, paused ? "Resume" : "Pause");
    this.pause.disabled = byKeys;
    this.replay.disabled = keyCount === 0 && !replaying;
    if (this.byKeys !== document.activeElement || isNew) this.byKeys.checked = byKeys;
    if (rollout) write(this.rolled, said.startsWith("Free for") ? said : this.rolled.textContent ?? "");
    const telling = arrived ? "At the goal." : said;
    if (telling && telling !== this.told) {
      this.told = telling;
      this.announcer.say(telling);
    }
  }
}

/** Now, in milliseconds since the epoch that page and worker share. */
function moment() { return performance.timeOrigin + performance.now(); }

/** @param {number} value @param {number} digits */
function number(value, digits) { return (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits).replace("-", "\u2212"); }
