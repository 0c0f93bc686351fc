/**
 * Lessons: each step asks a question above the stage, and Run runs the planner. Once that pauses, the step shows the
 * answer. Every step has an address, `#lesson=ID.STEP`, counted from 1.
 */
import { LESSONS, beginningOf, stageAt } from "./script.js";
import { SCENES } from "../scenes/scenes.js";
import { byId, make } from "../../app/dom.js";
import { setAddress } from "../../app/link.js";
import { button } from "../../widgets/elements.js";
import { LessonBand } from "../../widgets/lesson.js";

/** @import { Shown } from "../../widgets/lesson.js" */
/** @import { App } from "../../app/app.js" */
/** @import { Lesson } from "./script.js" */
/** @import { Plan } from "../../domain/types.js" */
/** @typedef {{ clock: { now: number }, lanes: { status: string }[] }} State */
/** @typedef {{ play: () => void, seek: (time: number) => void }} Timeline */
/** @typedef {{ scene: string, lanes?: Plan[] }} Scene   a part of the page's state */
/**
 * @typedef {object} Page   what lessons take of the page
 * @property {App} app
 * @property {App["notice"]} notice
 * @property {boolean} calm   with reduced motion
 * @property {object | null} facts
 * @property {(patch: Scene, how?: { play: boolean }) => Promise<unknown>} open
 * @property {(patch: Scene) => boolean} has
 * @property {(patch: { iteration: number }) => void} change
 * @property {(action: (session: { timeline: Timeline }) => void) => void} act
 * @property {(listener: (state: State) => void) => void} onState
 */

const ADDRESS = /^#?lesson=([\w-]+)(?:\.(\d{1,4}))?$/;

export class Lessons {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {Lesson | null} */
    this.lesson = null;
    this.at = 0;
    /** @type {Shown} */
    this.shown = "question";
    this.band = new LessonBand("Lesson", {
      run: () => void page.app.track(this.play(), "This step could not be run."),
      move: (by) => void this.put(this.at + by),
      leave: () => this.leave(),
    });
    const list = make(
      "ul",
      {},
      ...LESSONS.map((lesson) =>
        make(
          "li",
          {},
          button(`lesson-${lesson.id}`, lesson.title, () => {
            void this.put(0, lesson);
            this.band.run.focus();
          }),
        ),
      ),
    );
    byId("lessons", HTMLElement).append(list);
    page.onState((state) => {
      if (this.shown !== "run") return;
      // Something else was opened while the step ran.
      if (!this.isThere) this.show("question");
      else if (this.isOver(state)) this.show("answer");
    });
  }

  /** Opens the step in an address. @param {string} fragment */
  async open(fragment) {
    const { page } = this;
    const [, id, step = "1"] = ADDRESS.exec(fragment) ?? [];
    const lesson = LESSONS.find((one) => one.id === id);
    if (lesson?.steps[Number(step) - 1]) {
      await this.put(Number(step) - 1, lesson);
      return;
    }
    if (!page.facts) await page.open({ scene: SCENES[0].id });
    page.notice.show(
      lesson
        ? `The lesson "${lesson.title}" has ${lesson.steps.length} steps; there is no step ${step}.`
        : `There is no lesson "${id ?? fragment.slice(0, 64)}".`,
      "",
    );
  }

  leave() {
    this.lesson = null;
    this.shown = "question";
    this.band.hide();
    setAddress("");
    byId("stage", HTMLElement).focus();
  }

  /**
   * Asks the question of a step, with its planner before the run.
   * @param {number} step
   * @param {Lesson | null} [lesson]
   */
  async put(step, lesson = this.lesson) {
    const { page } = this;
    if (!lesson) return;
    this.lesson = lesson;
    this.at = step;
    this.shown = "question";
    this.band.ask(lesson.title, lesson.steps[step], step, lesson.steps.length);
    setAddress(`#lesson=${lesson.id}.${step + 1}`);
    try {
      const isShown = await this.arrive();
      // Another step or scene may have been opened meanwhile.
      if (!isShown || this.lesson !== lesson || this.at !== step || !this.isThere) return;
      page.change({ iteration: beginningOf(lesson, step) });
    } catch (error) {
      if (!page.facts) await page.open({ scene: SCENES[0].id });
      page.app.fail(error, "This step could not be shown.");
    }
  }

  /** Runs the planner of the step until it pauses; with reduced motion, at once. */
  async play() {
    const { lesson, page, at } = this;
    if (!lesson) return;
    // Another scene may have been opened since the question.
    if (!(await this.arrive()) || this.lesson !== lesson || this.at !== at) return;
    this.show("run");
    const rest = this.rest ?? (page.calm ? Infinity : undefined);
    page.change({ iteration: beginningOf(lesson, at) });
    page.act(({ timeline }) => (rest === undefined ? timeline.play() : timeline.seek(rest)));
  }

  /** The iteration at which the run pauses; undefined for its end. */
  get rest() {
    return this.lesson?.steps[this.at].iteration;
  }

  /**
   * Opens the scene of the step with its planner, unless the page shows them.
   * @returns {Promise<boolean>} whether it does then
   */
  async arrive() {
    return this.isThere || (await this.page.open(this.stage, { play: false })) !== null;
  }

  /** The scene and the planner of the step, as a patch of the page's state. */
  get stage() {
    const { scene, ...lane } = stageAt(/** @type {Lesson} */ (this.lesson), this.at);
    return { scene, document: undefined, options: undefined, query: undefined, lanes: [lane] };
  }

  /** Whether the run has ended or paused. @param {State} state */
  isOver({ clock, lanes: [{ status }] }) {
    return status !== "running" || clock.now >= (this.rest ?? Infinity);
  }

  /** Shows the question, or also the answer. @param {Shown} shown */
  show(shown) {
    const { lesson } = this;
    if (!lesson) return;
    this.shown = shown;
    this.band.show(shown, shown === "answer" ? lesson.steps[this.at].text : "");
  }

  /** Whether the page shows the scene of the step with its planner. */
  get isThere() {
    return this.page.has(this.stage);
  }
}
