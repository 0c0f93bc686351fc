/**
 * What every page beside the planner's begins with: colours, bad news, one loop of frames, and the word on whether all is at rest.
 *
 * A room is `www/NAME.html` (with `<!-- masthead -->` where the others have their header, `main#main`, `#notice`, `#announcer`, and
 * the policy of index.html), `www/NAME/main.js`, `www/NAME/style.css` (which imports `../room/room.css`), and `www/NAME/worker.js`
 * where it computes for longer than a few milliseconds. Its parts are here: `Sheet` draws figures, `Transport` plays, `Slider` and
 * `Options` are for settings, `Plot` for charts, `Link` for the address, `serve` and `Asker` are the two ends of a worker,
 * `pictureOf` and `drawingOf` give PNG and SVG.
 *
 * What tests may rely on: `body` carries `data-state` ("loading", "ready", "failed") and `data-settled` ("true" while nothing
 * moves, nothing is computed and all is drawn).
 */
import { Announcer } from "../app/announcer.js";
import { byId } from "../app/dom.js";
import { Notice } from "../app/notice.js";
import { watchTheme } from "../app/theme.js";
import { faultOf } from "../app/fault.js";
import { keepForLater } from "../app/keep-offline.js";
import { readPalette } from "../draw/palette.js";

/** @import { Look } from "../domain/types.js" */

/** Moves something a frame further. @typedef {(now: number) => boolean | void} Mover   milliseconds as of performance.now(); true: it goes on */

export class Room {
  constructor() {
    this.notice = new Notice();
    this.announcer = new Announcer();
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    /** @type {Mover[]} */
    this.movers = [];
    /** What draws, once all has moved. @type {(() => void)[]} */
    this.painters = [];
    /** @type {(() => void)[]} */
    this.dressers = [];
    /** What to do once the core was lost to a fault of its own. @type {(() => void) | null} */
    this.recover = null;
    this.frame = 0;
    /** Answers that are waited for. */
    this.waiting = 0;
    // Whatever an event brings down is said, like what a frame does.
    addEventListener("error", (event) => {
      // Without an error it is a remark of the browser's, such as on sizes that change while they are told.
      if (!event.error) return;
      event.preventDefault();
      this.fail(event.error);
    });
    addEventListener("unhandledrejection", (event) => {
      event.preventDefault();
      this.fail(event.reason);
    });
    watchTheme(() => this.dress());
    matchMedia("(forced-colors: active)").addEventListener("change", () => this.dress());
    this.watchRatio();
  }

  /**
   * Opens the page; that it could not be opened is said.
   * @param {() => Promise<void>} start
   */
  async open(start) {
    const { dataset } = document.body;
    dataset.state = "loading";
    dataset.settled = "false";
    try {
      await start();
      dataset.state = "ready";
      this.wake();
      keepForLater();
    } catch (error) {
      dataset.state = "failed";
      this.notice.show("This page could not start: it needs a browser with WebAssembly, and its own files beside it.", error);
    }
  }

  /** Calls in each frame for as long as it goes on, and in those that something else asks for. @param {Mover} then */
  onFrame(then) { this.movers.push(then); }

  /** Calls at the end of each frame. @param {() => void} then */
  onPaint(then) { this.painters.push(then); }

  /** Calls when colours or pixels are others. @param {() => void} then */
  onDress(then) { this.dressers.push(then); }

  /** Asks for a frame. */
  wake() {
    document.body.dataset.settled = "false";
    this.frame ||= requestAnimationFrame((now) => this.turn(now));
  }

  /** One frame. @param {number} now */
  turn(now) {
    this.frame = 0;
    let goesOn = false;
    this.guard(() => {
      for (const move of this.movers) goesOn = move(now) === true || goesOn;
      for (const paint of this.painters) paint();
    });
    if (goesOn) this.wake();
    else this.rest();
  }

  /** Says so where all is at rest. */
  rest() {
    if (this.frame === 0 && this.waiting === 0) document.body.dataset.settled = "true";
  }

  /**
   * Waits for an answer; until it is there the page is not at rest. That there is none is said.
   * @template T
   * @param {Promise<T>} answer
   * @returns {Promise<T | undefined>}
   */
  async await(answer) {
    this.waiting++;
    document.body.dataset.settled = "false";
    try {
      return await answer;
    } catch (error) {
      this.fail(error);
      return undefined;
    } finally {
      this.waiting--;
      this.wake();
    }
  }

  /**
   * Does something that may fail; what went wrong is said.
   * @template T
   * @param {() => T} act
   * @returns {T | undefined}
   */
  guard(act) {
    try {
      return act();
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  /** Something has gone wrong. @param {unknown} error @param {string} [title] */
  fail(error, title = "Something went wrong.") {
    this.notice.show(title, error);
    if (faultOf(error).code === "internal") this.recover?.();
  }

  /** Colours and pixels. @returns {Look} */
  get look() { return { palette: readPalette(byId("main", HTMLElement)), ratio: devicePixelRatio || 1, calm: this.calm, bold: 1 }; }

  dress() {
    for (const then of this.dressers) then();
    this.wake();
  }

  /** Asks to be told when the number of device pixels a CSS pixel changes. */
  watchRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
      this.dress();
      this.watchRatio();
    }, { once: true });
  }
}
