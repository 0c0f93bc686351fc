/** A question to the worker whose answer is kept as long as it is about the same things. */
import { errorInfo } from "../../app/error-info.js";
import { isAbort, latest } from "../../app/work.js";
import { forgetScene } from "../../paths/remote.js";

/** @import { App } from "../../app/app.js" */
/** @typedef {{ code: string, message: string }} Fault */

/** @template {unknown[]} A @template T */
export class Question {
  /**
   * @param {App} app
   * @param {(signal: AbortSignal, ...about: A) => Promise<T>} ask
   * @param {() => void} onChange
   */
  constructor(app, ask, onChange) {
    this.app = app;
    this.onChange = onChange;
    this.ask = latest(ask);
    /** What it is about; null: nothing is asked. @type {A | null} */
    this.about = null;
    /** @type {T | null} */
    this.answer = null;
    /** Why there is no answer. @type {Fault | null} */
    this.fault = null;
  }

  get isBusy() {
    return this.about !== null && this.answer === null && this.fault === null;
  }

  /** Asks about other things, or about nothing. @param {A | null} about */
  follow(about) {
    const before = this.about;
    if (about === before || (about && before && about.every((one, i) => one === before[i]))) return;
    this.ask.cancel();
    [this.about, this.answer, this.fault] = [about, null, null];
    if (about) void this.app.track(this.find(about));
    this.onChange();
  }

  /** @param {A} about */
  async find(about) {
    try {
      this.answer = await this.ask(...about);
    } catch (error) {
      if (isAbort(error)) throw error;
      this.fault = errorInfo(error);
      // The worker may have been lost, with its scene.
      if (["", "internal", "no-scene"].includes(this.fault.code)) forgetScene();
    }
    this.onChange();
  }
}
