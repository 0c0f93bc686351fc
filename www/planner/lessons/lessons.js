/**
 * Lessons: each step asks a question above the stage, and Run runs the planner. Once that pauses, the step shows the
 * answer. Every step has an address, `#lesson=ID.STEP`, counted from 1.
 *
 * For tests: `#lesson` carries `data-shown`, "question", "run" or "answer".
 */
import { LESSONS, beginningOf, stageAt } from "./script.js";
import { SCENES } from "../scenes/scenes.js";
import { byId, make } from "../../app/dom.js";
import { setAddress } from "../../app/link.js";
import { button } from "../../widgets/elements.js";

/** @import { Page } from "../page.js" */
/** @import { Lesson } from "./script.js" */
/** @import { State } from "../../domain/types.js" */

const ADDRESS = /^#?lesson=([\w-]+)(?:\.(\d{1,4}))?$/;

export class Lessons {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {Lesson | null} */
    this.lesson = null;
    this.at = 0;
    /** @type {"question" | "run" | "answer"} */
    this.shown = "question";
    this.title = make("strong", {});
    this.count = make("span", { className: "hint" });
    this.legend = make("legend", {});
    this.choices = make("div", { className: "choices" });
    this.question = make("fieldset", {}, this.legend, this.choices);
    this.verdict = make("strong", {});
    this.text = make("span", {});
    this.outcome = make("p", { className: "outcome" }, this.verdict, " ", this.text);
    this.run = button("lesson-run", "Run", () => void page.app.track(this.play(), "This step could not be run."));
    this.back = button("lesson-previous", "Previous", () => void this.put(this.at - 1));
    this.next = button("lesson-next", "", () => {
      if (this.isLast) this.leave();
      else void this.put(this.at + 1);
    });
    const leave = button("lesson-leave", "Exit", () => this.leave());
    leave.className = "quiet";
    const head = make("p", { className: "head" }, this.title, " ", this.count);
    const words = make("div", {}, head, this.question, make("div", { role: "status" }, this.outcome));
    this.band = make(
      "section",
      { id: "lesson", className: "lesson", ariaLabel: "Lesson", hidden: true },
      words,
      make("div", { className: "buttons" }, this.run, this.back, this.next, leave),
    );
    byId("story", HTMLElement).before(this.band);
    const list = make(
      "ul",
      {},
      ...LESSONS.map((lesson) =>
        make(
          "li",
          {},
          button(`lesson-${lesson.id}`, lesson.title, () => {
            void this.put(0, lesson);
            this.run.focus();
          }),
        ),
      ),
    );
    byId("lessons", HTMLElement).append(list);
    page.onState((state) => {
      if (this.shown === "run" && this.isOver(state)) this.show("answer");
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

  get isLast() {
    return this.at + 1 === this.lesson?.steps.length;
  }

  leave() {
    this.lesson = null;
    this.shown = "question";
    this.band.hidden = true;
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
    const { question, choices } = lesson.steps[step];
    this.title.textContent = lesson.title;
    this.count.textContent = `${step + 1} of ${lesson.steps.length}`;
    this.legend.textContent = question;
    this.choices.replaceChildren(
      ...choices.map((choice, i) =>
        make("label", {}, make("input", { type: "radio", name: "lesson-choice", value: String(i) }), " ", choice),
      ),
    );
    this.back.disabled = step === 0;
    this.next.textContent = this.isLast ? "Finish" : "Next";
    this.band.hidden = false;
    this.show("question");
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
    return (status !== "running" || clock.now >= (this.rest ?? Infinity)) && this.isThere;
  }

  /** Shows the question, or also the answer. @param {"question" | "run" | "answer"} shown */
  show(shown) {
    const { lesson } = this;
    if (!lesson) return;
    this.shown = this.band.dataset.shown = shown;
    const isAnswered = shown === "answer";
    const { choices, answer, text } = lesson.steps[this.at];
    this.question.disabled = shown !== "question";
    this.run.disabled = shown === "run";
    this.run.textContent = isAnswered ? "Run again" : "Run";
    this.run.className = isAnswered ? "" : "primary";
    this.next.className = isAnswered ? "primary" : "";
    const chosen = /** @type {HTMLInputElement | null} */ (this.choices.querySelector("input:checked"));
    this.verdict.textContent = !isAnswered
      ? ""
      : chosen?.value === String(answer)
        ? "Correct."
        : `Answer: ${choices[answer].toLowerCase()}.`;
    this.text.textContent = isAnswered ? text : "";
    this.outcome.hidden = !isAnswered;
  }

  /** Whether the page shows the scene of the step with its planner. */
  get isThere() {
    return this.page.has(this.stage);
  }
}
