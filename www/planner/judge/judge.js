/**
 * Judges a path of another program in the scene: it is drawn on the stage, and a line below it says what is known. It
 * replaces neither the scene nor the run, is judged again when the scene is edited, and goes with another scene.
 *
 * For tests: `#judged` carries `data-state` ("busy" or "judged"), `data-valid`, `data-free`, and `data-edge`, the motion of
 * the first contact.
 */
import { byId, make, write } from "../../app/dom.js";
import { isAbort, latest } from "../../app/work.js";
import { coordinatesOf } from "../../domain/coordinates.js";
import { isPlaced } from "../../domain/names.js";
import { forgetScene, pathWorker, workerWith } from "../../paths/remote.js";
import { button } from "../../widgets/elements.js";
import { faultText } from "../../worlds/words.js";
import { JudgedDrawing } from "./drawing.js";
import { traceOf } from "./trace.js";
import { readText, verdictText } from "./words.js";

/** @import { App } from "../../app/app.js" */
/** @import { Content } from "../../app/read-files.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { Angles, DrawnPath } from "../../paths/judging.js" */
/** @import { Shown } from "../stage/lane.js" */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {{ hide: () => void, ask: (text: string, choices: [string, string][]) => Promise<string> }} notice
 * @property {{ shown: Shown | null, markDirty: () => void }} session
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: () => void) => void} onState
 */

/** In the place of a path that is being judged. */
const UNJUDGED = { drawUnder: () => {}, drawOver: () => {} };

/** @type {PathJudge | undefined} */
let made;

/** Judges a file. @param {Page} page @param {Content} file @throws {Error} it is no path, with a code */
export async function judgeFile(page, file) {
  made ??= new PathJudge(page);
  await made.take(file);
}

class PathJudge {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.name = "";
    /** @type {DrawnPath | null} */
    this.path = null;
    /** Whether the robot moves along arcs from waypoint to waypoint. */
    this.isArcs = false;
    /** The scene in which the path was judged last, and how. @type {unknown[]} */
    this.asked = [];
    this.text = make("span", { role: "status" });
    this.arcs = make("input", { type: "checkbox", id: "judged-arcs" });
    this.arcs.addEventListener("change", () => {
      this.isArcs = this.arcs.checked;
      this.update();
    });
    this.arcsRow = make("label", { htmlFor: this.arcs.id }, this.arcs, " Along arcs");
    const remove = button("judged-remove", "Remove", () => {
      this.remove();
      byId("stage", HTMLElement).focus();
    });
    this.line = make(
      "p",
      { id: "judged", className: "marked", hidden: true },
      this.text,
      make("span", { className: "buttons" }, this.arcsRow, remove),
    );
    byId("stage", HTMLElement).after(this.line);
    this.reading = latest((signal, /** @type {Content} */ file, /** @type {Angles | undefined} */ angles) => {
      const { document } = /** @type {Shown} */ (this.page.session.shown);
      return pathWorker().read(file, document, angles, signal);
    });
    this.judging = latest(
      (signal, /** @type {ScenarioDocument} */ document, /** @type {number} */ id, /** @type {boolean} */ isArcs) =>
        workerWith(document).judge(id, isArcs, signal),
    );
    // An edited scene keeps what is shown; another one has nothing yet.
    page.onOpen(() => {
      if (!page.session.shown?.judged) this.remove();
    });
    page.onState(() => this.update());
  }

  /** @param {Content} file */
  async take(file) {
    const { shown } = this.page.session;
    if (!shown) return;
    this.page.notice.hide();
    const path = await this.read(file);
    if (!path) return;
    const now = this.page.session.shown;
    if (!now || kindOf(now) !== kindOf(shown)) {
      const sentence = `${file.name} was read for another scene; open it again.`;
      throw Object.assign(new Error(sentence), { code: "scene-replaced" });
    }
    this.remove(path.id);
    Object.assign(this, { path, name: file.name, isArcs: false });
    now.judged = UNJUDGED;
    this.arcs.checked = false;
    this.arcsRow.hidden = !isPlaced(now.scenario.robot);
    this.update();
  }

  /** @param {Content} file @param {Angles} [angles] @returns {Promise<DrawnPath | null>} null: nothing was chosen */
  async read(file, angles) {
    const answer = await this.reading(file, angles);
    if (!("fault" in answer)) return answer;
    const { fault } = answer;
    if (fault.code === "invalid-option" && !angles) {
      const chosen = await this.page.notice.ask(`${file.name}: in what are its angles?`, [
        ["degrees", "Degrees"],
        ["radians", "Radians"],
      ]);
      return chosen ? this.read(file, /** @type {Angles} */ (chosen)) : null;
    }
    throw Object.assign(new Error(faultText(fault)), { code: fault.code });
  }

  /** Judges the path, where the scene or the kind of motion differs. */
  update() {
    const { path, page, isArcs } = this;
    const { shown } = page.session;
    if (!path || !shown || shown.rough) return;
    const asked = [path, shown.document, isArcs];
    if (asked.every((one, i) => one === this.asked[i])) return;
    if (this.asked.length > 0 && this.kind !== kindOf(shown)) {
      this.remove();
      return;
    }
    this.asked = asked;
    this.kind = kindOf(shown);
    void page.app.track(this.judge(path, shown, isArcs), `${this.name} could not be judged.`);
  }

  /** @param {DrawnPath} path @param {Shown} shown @param {boolean} isArcs */
  async judge(path, shown, isArcs) {
    const { page, line, text } = this;
    line.dataset.state = "busy";
    line.hidden = false;
    write(text, `${this.name} is being judged.`);
    try {
      const judgement = await this.judging(shown.document, path.id, isArcs);
      const { scenario, document } = shown;
      if (page.session.shown?.document !== document) return;
      const trace = traceOf(path, scenario.dimension, judgement.contact, isArcs);
      page.session.shown.judged = new JudgedDrawing({ path, judgement, trace, document });
      byId("legend-judged", HTMLElement).hidden = false;
      const verdict = verdictText(judgement, scenario.robot, coordinatesOf({ scenario, document }));
      write(text, [`${this.name}:`, lowered(verdict), readText(path)].filter(Boolean).join(" "));
      const { valid, free, contact } = judgement;
      Object.assign(line.dataset, { state: "judged", valid, free, edge: contact ? contact.edge : "" });
    } catch (error) {
      if (!isAbort(error)) {
        forgetScene();
        this.remove();
      }
      throw error;
    } finally {
      page.session.markDirty();
    }
  }

  /** Of the paths that the worker has read, it keeps one. @param {number | null} id */
  keep(id) {
    void this.page.app.track(pathWorker().keep(id));
  }

  /** Takes the path from the stage. @param {number | null} kept   the one that is shown in its place */
  remove(kept = null) {
    this.reading.cancel();
    this.judging.cancel();
    if (this.path || kept !== null) this.keep(kept);
    this.path = null;
    this.asked = [];
    this.line.hidden = true;
    byId("legend-judged", HTMLElement).hidden = true;
    const { shown } = this.page.session;
    if (shown) shown.judged = null;
    this.page.session.markDirty();
  }
}

/** What a path of a scene is made of: the robot, and the coordinates of the map. @param {Shown} shown */
const kindOf = ({ scenario: { robot, dimension }, document: { frame } }) => JSON.stringify([robot, dimension, frame]);

/** @param {string} text */
const lowered = (text) => text[0].toLowerCase() + text.slice(1);
