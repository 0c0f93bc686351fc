/** A feature of the page that is loaded on demand: with its fold, its button or an address. */
import { byId } from "./dom.js";
import { once } from "./once.js";

/** @import { Notice } from "./notice.js" */

/** @template T */
export class LazyFeature {
  /** @param {Notice} notice @param {() => Promise<T>} load */
  constructor(notice, load) {
    this.notice = notice;
    /** Loads the feature, once; after a failure the next call tries again. */
    this.get = once(load);
  }

  /** Uses the feature; a failure to load it is shown. @param {(part: T) => unknown} [then] */
  use(then = () => {}) {
    this.get()
      .then(then)
      .catch((error) => this.notice.show("This part of the page could not be loaded.", error));
  }

  /** Loads it when a fold is opened. @param {string} id @returns {this} */
  inFold(id) {
    const fold = byId(id, HTMLDetailsElement);
    fold.addEventListener("toggle", () => {
      if (fold.open) this.use();
    });
    if (fold.open) this.use();
    return this;
  }

  /** Uses it when a button is pressed. @param {string} id @param {(part: T) => unknown} then @returns {this} */
  byButton(id, then) {
    byId(id, HTMLButtonElement).addEventListener("click", () => this.use(then));
    return this;
  }
}
