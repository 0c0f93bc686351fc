/** The page's one place for bad news: what went wrong, where it stands, and under which code to look it up. */
import { faultOf } from "../fault.js";
import { byId, make } from "./dom.js";

export class Notice {
  constructor() {
    this.element = byId("notice", HTMLElement);
  }

  /**
   * @param {string} title
   * @param {unknown} error   with `code` and `pointer` where the package threw it
   */
  show(title, error) {
    const { message, code, pointer } = faultOf(error);
    this.element.dataset.code = code;
    this.element.dataset.pointer = pointer;
    const close = make("button", { type: "button", className: "quiet" }, "Dismiss");
    close.addEventListener("click", () => this.hide());
    const where = make("p", { className: "where" });
    if (code) where.append("code ", make("code", {}, code));
    if (pointer) where.append(" at ", make("code", {}, pointer));
    this.element.replaceChildren(make("div", {}, make("strong", {}, title), " ", make("span", {}, message), code || pointer ? where : ""), close);
    this.element.hidden = false;
  }

  hide() {
    this.element.hidden = true;
    this.element.replaceChildren();
    delete this.element.dataset.code;
    delete this.element.dataset.pointer;
  }
}
