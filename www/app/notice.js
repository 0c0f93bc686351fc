/** The notice of the page: an error with its code and pointer, or a question. */
import { errorInfo } from "./error-info.js";
import { byId, make } from "./dom.js";

export class Notice {
  constructor() {
    this.element = byId("notice", HTMLElement);
    /** Closes the open question with a choice. @type {(choice: string) => void} */
    this.answer = () => {};
  }

  /**
   * Asks a question.
   * @template {string} C
   * @param {string} question
   * @param {[C, string][]} choices  each with the text of its button
   * @returns {Promise<C | "">}  empty: cancelled
   */
  ask(question, choices) {
    this.hide();
    return new Promise((resolve) => {
      const buttons = [...choices, /** @type {const} */ (["", "Cancel"])].map(([choice, word]) => {
        return make(
          "button",
          { type: "button", className: choice ? "" : "quiet", onclick: () => this.answer(choice), dataset: { choice } },
          word,
        );
      });
      this.element.replaceChildren(
        make("div", {}, make("strong", {}, question), make("div", { className: "choices" }, ...buttons)),
      );
      this.element.classList.add("question");
      this.element.hidden = false;
      this.element.onkeydown = ({ key }) => {
        if (key === "Escape") this.answer("");
      };
      this.answer = (choice) => {
        this.answer = () => {};
        this.hide();
        resolve(/** @type {C | ""} */ (choice));
      };
      buttons[0].focus();
    });
  }

  /** @param {string} title @param {unknown} error   with `code` and `pointer` where the package threw it */
  show(title, error) {
    this.hide();
    const { message, code, pointer } = errorInfo(error);
    this.element.dataset.code = code;
    this.element.dataset.pointer = pointer;
    const close = make("button", { type: "button", className: "quiet", onclick: () => this.hide() }, "Dismiss");
    const where = make("p", { className: "where" });
    if (code) where.append("code ", make("code", {}, code));
    if (pointer) where.append(" at ", make("code", {}, pointer));
    this.element.replaceChildren(
      make(
        "div",
        {},
        make("strong", {}, title),
        " ",
        make("span", {}, capitalized(message)),
        code || pointer ? where : "",
      ),
      close,
    );
    this.element.hidden = false;
  }

  /** Hides the notice, and cancels an open question. */
  hide() {
    this.answer("");
    this.element.classList.remove("question");
    this.element.hidden = true;
    this.element.replaceChildren();
    delete this.element.dataset.code;
    delete this.element.dataset.pointer;
  }
}

/** Capitalizes the first word, unless it is a name. @param {string} message */
function capitalized(message) {
  return message.replace(/^(?:this|the|there|an?|it|no) /, (word) => word[0].toUpperCase() + word.slice(1));
}
