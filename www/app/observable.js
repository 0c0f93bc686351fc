/** The state of a page: its listeners learn what changed. */

/** @import { App } from "./app.js" */

/** @template {string} C  the kinds of changes */
export class Observable {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {((change: C) => void)[]} */
    this.listeners = [];
  }

  /** @param {(change: C) => void} listener */
  onChange(listener) {
    this.listeners.push(listener);
  }

  /** @param {C} change */
  update(change) {
    for (const listener of this.listeners) listener(change);
    this.app.requestFrame();
  }
}
