/**
 * A part of the page that is loaded when it is first asked for: by its fold, its button, an address. What it needs comes with it,
 * so that the page itself opens with little.
 */
import { byId } from "./dom.js";
import { once } from "./once.js";

/** @import { Notice } from "./notice.js" */

/** @template T */
export class Part {
  /** @param {Notice} notice @param {() => Promise<T>} load */
  constructor(notice, load) {
    this.notice = notice;
    /** The part, loaded once; where it could not be, the next who asks tries again. */
    this.get = once(load);
  }

  /** Does something with the part; that it could not be loaded is said. @param {(part: T) => unknown} [then] */
  use(then = () => {}) {
    this.get().then(then).catch((error) => this.notice.show("This part of the page could not be loaded.", error));
  }

  /** Opening a fold asks for it. @param {string} id @returns {this} */
  inFold(id) {
    const fold = byId(id, HTMLDetailsElement);
    fold.addEventListener("toggle", () => { if (fold.open) this.use(); });
    if (fold.open) this.use();
    return this;
  }

  /** A button asks for it, and for something of it. @param {string} id @param {(part: T) => unknown} then @returns {this} */
  byButton(id, then) {
    byId(id, HTMLButtonElement).addEventListener("click", () => this.use(then));
    return this;
  }
}
