/**
 * The band of a lesson, above the story: a question with choices, a button that runs the step, and then its answer.
 *
 * For tests: `#lesson` carries `data-step`, from 1, and `data-shown`, "question", "run" or "answer".
 */
import { byId, make } from "../app/dom.js";
import { button } from "./elements.js";

/** @typedef {{ question: string, choices: string[], answer: number }} Question   `answer`: an index of `choices` */
/** @typedef {"question" | "run" | "answer"} Shown */

export class LessonBand {
  /** @param {string} label @param {{ run: () => void, move: (by: 1 | -1) => void, leave: () => void }} actions */
  constructor(label, { run, move, leave }) {
    /** @type {Question} */
    this.step = { question: "", choices: [], answer: 0 };
    this.isLast = false;
    this.title = make("strong", {});
    this.count = make("span", { className: "hint" });
    this.legend = make("legend", {});
    this.choices = make("div", { className: "choices" });
    this.question = make("fieldset", {}, this.legend, this.choices);
    this.verdict = make("strong", {});
    this.text = make("span", {});
    this.outcome = make("p", { className: "outcome" }, this.verdict, " ", this.text);
    this.run = button("lesson-run", "Run", run);
    this.back = button("lesson-previous", "Previous", () => move(-1));
    this.next = button("lesson-next", "", () => {
      if (this.isLast) leave();
      else move(1);
    });
    const exit = button("lesson-leave", "Exit", leave, { className: "quiet" });
    const head = make("p", { className: "head" }, this.title, " ", this.count);
    this.element = make(
      "section",
      { id: "lesson", className: "lesson", ariaLabel: label, hidden: true },
      make("div", {}, head, this.question, make("div", { role: "status" }, this.outcome)),
      make("div", { className: "buttons" }, this.run, this.back, this.next, exit),
    );
    byId("story", HTMLElement).before(this.element);
  }

  /** Asks the question of a step. @param {string} title @param {Question} step @param {number} at @param {number} of */
  ask(title, step, at, of) {
    const { question, choices } = step;
    Object.assign(this, { step, isLast: at + 1 === of });
    this.title.textContent = title;
    this.count.textContent = `${at + 1} of ${of}`;
    this.legend.textContent = question;
    this.choices.replaceChildren(
      ...choices.map((choice, i) =>
        make("label", {}, make("input", { type: "radio", name: "lesson-choice", value: String(i) }), " ", choice),
      ),
    );
    this.back.disabled = at === 0;
    this.next.textContent = this.isLast ? "Finish" : "Next";
    this.element.dataset.step = String(at + 1);
    this.element.hidden = false;
    this.show("question");
  }

  /** Shows the question, or that it runs, or the answer. @param {Shown} shown @param {string} [text]  of the answer */
  show(shown, text = "") {
    const isAnswered = shown === "answer";
    const { choices, answer } = this.step;
    this.element.dataset.shown = shown;
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
    this.text.textContent = text;
    this.outcome.hidden = !isAnswered;
  }

  hide() {
    this.element.hidden = true;
  }
}
