/** The panel in which a world is opened: what was read, what must be asked, and the map. */
import { make, write } from "../app/dom.js";
import { button, select } from "../widgets/elements.js";
import { Ends } from "./ends.js";
import { Fields } from "./fields.js";
import { Preview } from "./preview.js";
import { faultText, formatName, linesOf } from "./words.js";

/** @import { App } from "../app/app.js" */
/** @import { Point } from "../domain/types.js" */
/** @import { Choices } from "./choices.js" */
/** @import { Fault, Places, ReadWorld } from "./types.js" */
/**
 * @typedef {object} Acts   what the panel's controls do
 * @property {(patch: Partial<Choices>) => void} choose
 * @property {(places: Places) => void} place
 * @property {(query: string) => void} ask
 * @property {(name: string) => void} remove   a file
 * @property {() => void} add   a file, by picking it
 * @property {() => void} use
 * @property {() => void} close
 */

export class Panel {
  /** @param {App} app @param {Acts} acts */
  constructor(app, acts) {
    this.acts = acts;
    this.notice = app.notice.element;
    /** Holds the place of the notice on the page. */
    this.home = document.createComment("notice");
    this.fields = new Fields(acts.choose, () => this.measure(this.preview.points === null));
    this.preview = new Preview(app, acts.place, (points) => this.measured(points));
    this.ends = new Ends(acts.place);
    this.title = make("h2", { id: "world-title" });
    this.files = make("ul", { id: "world-files", ariaLabel: "Files" });
    this.report = make("ul", { id: "world-report" });
    this.query = select("world-query", "Query of the file", []);
    this.query.addEventListener("change", () => acts.ask(this.query.value));
    this.hint = make("p", { className: "hint", id: "world-hint" });
    this.length = make("input", {
      type: "number",
      id: "world-distance",
      step: "any",
      min: "0",
      ariaLabel: "Metres between the two points",
    });
    this.length.addEventListener("input", () => this.rescale());
    this.lengthRow = make(
      "label",
      { className: "row", hidden: true },
      make("span", { className: "name" }, "Metres between the two points"),
      this.length,
    );
    this.fault = make("p", { className: "reason", id: "world-fault", role: "alert", hidden: true });
    this.use = button("world-use", "Use this world", acts.use, { className: "primary" });
    this.add = button("world-add", "Add a file\u2026", acts.add);
    const close = button("world-close", "Cancel", acts.close, { className: "quiet" });
    this.body = make(
      "div",
      { className: "world-body" },
      make(
        "div",
        { className: "world-map" },
        this.preview.canvas,
        this.hint,
        this.lengthRow,
        this.ends.element,
        this.query,
      ),
      make("div", { className: "world-side" }, this.report, this.fields.element),
    );
    this.dialog = make(
      "dialog",
      { id: "world", className: "world" },
      make("header", {}, this.title, this.files),
      this.body,
      this.fault,
      make("footer", {}, this.use, this.add, close),
    );
    this.dialog.setAttribute("aria-labelledby", "world-title");
    this.dialog.addEventListener("cancel", (event) => {
      event.preventDefault();
      acts.close();
    });
    document.body.append(this.dialog);
    /** The pixels between the two points that were clicked, and the metres of one when they were. */
    this.apart = 0;
    /** @type {ReadWorld | null} */
    this.world = null;
  }

  open() {
    if (this.dialog.open) return;
    // What is refused meanwhile is said in the panel: the page behind it is out of reach.
    this.notice.replaceWith(this.home);
    this.dialog.prepend(this.notice);
    this.preview.clear();
    this.world = null;
    this.body.hidden = true;
    this.dialog.showModal();
    this.use.disabled = true;
  }

  close() {
    this.measure(false);
    this.home.replaceWith(this.notice);
    this.dialog.close();
  }

  /** Shows that files are being read. @param {string[]} names */
  reading(names) {
    this.dialog.dataset.state = "reading";
    if (!this.world) write(this.title, "Reading\u2026");
    this.files.replaceChildren(
      ...names.map((name) =>
        make(
          "li",
          {},
          name,
          button("", "\u00d7", () => this.acts.remove(name), {
            className: "quiet",
            ariaLabel: `Remove ${name}`,
            hidden: names.length < 2,
          }),
        ),
      ),
    );
  }

  /** @param {ReadWorld} world @param {Choices} choices */
  show(world, choices) {
    this.world = world;
    this.body.hidden = false;
    write(this.title, formatName(world.report));
    this.report.replaceChildren(...linesOf(world.report).map((line) => make("li", {}, line)));
    this.fields.show(world, choices);
    const { queries } = world.scenario;
    this.query.hidden = queries.length < 2;
    const lengths = new Map(world.report.queries.map(({ name, length }) => [name, length]));
    this.query.replaceChildren(
      ...queries.map(({ name }) => {
        const length = lengths.get(name);
        return make("option", { value: name }, length === undefined ? name : `${name}: ${length.toFixed(1)} m`);
      }),
    );
    this.preview.show(world.scenario, world.grid);
    const isNew = this.use.disabled;
    this.refuse("", "");
    if (isNew && !this.fields.element.contains(document.activeElement)) this.use.focus();
    write(this.add, "Add a file\u2026");
    this.dialog.dataset.state = "ready";
  }

  /** Shows why the files cannot be read; what was shown before stays. @param {Fault} fault */
  fail(fault) {
    const { code, wanted, file } = fault;
    const isMissing = code === "missing-file" && wanted !== "";
    if (isMissing || !this.world) {
      this.body.hidden = true;
      write(this.title, isMissing ? "One file more" : "This cannot be read");
    }
    const text = isMissing ? `${file || "The file"} needs ${wanted}: drop it here too, or add it.` : faultText(fault);
    this.refuse(text, code);
    // Nothing is wrong yet.
    this.fault.classList.toggle("reason", !isMissing);
    this.use.hidden = isMissing;
    write(this.add, isMissing ? `Add ${wanted.replace(/^.*[\\/]/, "")}\u2026` : "Add a file\u2026");
    this.dialog.dataset.state = "fault";
    if (isMissing) this.add.focus();
  }

  /** Why the world cannot be used, or empty. @param {string} text @param {string} code */
  refuse(text, code) {
    write(this.fault, text);
    this.fault.hidden = text === "";
    this.fault.classList.add("reason");
    this.dialog.dataset.code = code;
    this.use.disabled = text !== "";
    this.use.hidden = false;
  }

  /** @param {Places | null} places @param {("start" | "goal")[]} bad   ends in collision */
  place(places, bad) {
    const { preview } = this;
    preview.places = places;
    preview.bad = bad;
    preview.draw();
    this.ends.show(preview.points ? null : places, this.world?.scenario.world.bounds);
    this.hint.dataset.bad = String(bad.length > 0);
    if (!preview.points) write(this.hint, this.advice());
  }

  /** What to do about start and goal. */
  advice() {
    const { places, bad } = this.preview;
    if (!places) return "";
    if (bad.length === 0) return "Drag the start and the goal, or type where they are.";
    const [are, them] = bad.length > 1 ? ["are", "them"] : ["is", "it"];
    return `The ${bad.join(" and the ")} ${are} in collision: move ${them} to a free place.`;
  }

  /** Begins or ends the measurement of the scale. @param {boolean} isOn */
  measure(isOn) {
    this.fields.measure.ariaPressed = String(isOn);
    this.preview.measure(isOn);
    this.ends.show(isOn ? null : this.preview.places, this.world?.scenario.world.bounds);
    this.lengthRow.hidden = true;
    write(this.hint, isOn ? "Click two points whose distance you know." : this.advice());
  }

  /** @param {Point[]} points   clicked */
  measured(points) {
    const [a, b] = points;
    this.lengthRow.hidden = !b;
    if (!b || !this.world?.grid) return;
    this.apart = Math.hypot(b[0] - a[0], b[1] - a[1]) / this.world.grid.resolution;
    write(this.hint, `${this.apart.toFixed(1)} pixels.`);
    this.length.value = "";
    this.length.focus();
  }

  /** The scale by the length that was typed. */
  rescale() {
    const metres = Number(this.length.value);
    if (metres > 0 && this.apart > 0) this.acts.choose({ scale: Number((metres / this.apart).toPrecision(6)) });
  }
}
