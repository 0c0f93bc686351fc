/**
 * The shell of a page: it loads the core and the worker, runs one loop of frames, and shows messages and errors.
 *
 * For tests: `body` carries `data-state` ("loading", "ready", "failed") and `data-settled` ("true" while nothing moves,
 * no reply of the worker is pending and everything is drawn).
 */
import * as library from "planarium";
import { byId, keepMore, write } from "./dom.js";
import { Notice } from "./notice.js";
import { watchTheme } from "./theme.js";
import { errorInfo } from "./error-info.js";
import { loadCore, workerMaker } from "./resources.js";
import { readPalette } from "./palette.js";
import { paced } from "./paced.js";
import { isProjected, Projector } from "./projector.js";
import { isAbort } from "./work.js";
import { connect } from "./worker-client.js";

/** @import { Remote } from "./worker-client.js" */

/** Milliseconds between two announcements, at least. */
const PAUSE = 1000;

/**
 * @typedef {(now: number) => boolean | void} Animation   milliseconds as of performance.now(); returns true until it
 *   ends
 */

/**
 * @typedef {App["look"]} Look   the colours, the pixel ratio, reduced motion, and a factor for lines, dots and words
 */

export class App {
  constructor() {
    this.notice = new Notice();
    /** For screen readers. */
    this.announcer = {
      say: paced(PAUSE, (/** @type {string} */ text) => {
        byId("announcer", HTMLElement).textContent = text;
      }),
    };
    this.reducedMotion = matchMedia("(prefers-reduced-motion: reduce)").matches;
    /** @type {Animation[]} */
    this.animations = [];
    /** @type {(() => void)[]} */
    this.shows = [];
    /** Whether the state has changed since it was shown. */
    this.isStale = false;
    /** @type {(() => void)[]} */
    this.drawings = [];
    /** @type {(() => void)[]} */
    this.themeListeners = [];
    /** The compiled WebAssembly. @type {WebAssembly.Module | undefined} */
    this.core = undefined;
    /**
     * Starts one more worker like that of the page; its commands reject if it could not be loaded.
     * @type {() => unknown}
     */
    this.hire = () => null;
    /** Rebuilds the objects of the core after a panic of the core. @type {() => void} */
    this.rebuild = () => {};
    this.frame = 0;
    /** Promises that are tracked and pending. */
    this.pending = 0;
    this.message = "";
    addEventListener("error", (event) => {
      // Browsers report loops of resize observers as events without an error.
      if (!event.error) return;
      event.preventDefault();
      this.fail(event.error);
    });
    addEventListener("unhandledrejection", (event) => {
      event.preventDefault();
      this.fail(event.reason);
    });
    // In a frame a page shows only its figure and its transport.
    document.documentElement.classList.toggle("embed", new URLSearchParams(location.search).get("embed") === "1");
    keepMore();
    this.projector = new Projector(() => this.setTheme());
    watchTheme(() => this.setTheme());
    matchMedia("(forced-colors: active)").addEventListener("change", () => this.setTheme());
    this.watchPixelRatio();
  }

  /**
   * Opens the page.
   * @template C
   * @param {string} room   whose commands the worker runs
   * @param {(worker: Remote<C>) => Promise<void>} start
   * @param {string} [script]   of the worker
   * @returns {Promise<boolean>} whether it could start
   */
  async open(room, start, script = "rooms/worker.js") {
    const { dataset } = document.body;
    dataset.state = "loading";
    dataset.settled = "false";
    try {
      const loading = loadCore();
      const make = await workerMaker(script);
      const worker = connect(make(), room, loading, (error) => {
        if (dataset.state !== "failed") this.fail(error);
      });
      this.hire = () => connect(make(), room, loading, () => {});
      this.core = await loading;
      await library.default(this.core);
      await start(/** @type {Remote<C>} */ (worker));
      this.show();
      dataset.state = "ready";
      this.requestFrame();
      // Stores the files of the pages for use without a network, where the browser allows it.
      if (location.protocol.startsWith("http")) navigator.serviceWorker?.register("offline.js").catch(() => {});
      return true;
    } catch (error) {
      dataset.state = "failed";
      this.notice.show(
        "Planarium could not start. It needs a browser with WebAssembly and the other files of this site.",
        error,
      );
      return false;
    }
  }

  /** Runs in each frame, before drawing. @param {Animation} animate */
  onFrame(animate) {
    this.animations.push(animate);
  }

  /**
   * Runs once in a frame after changes of the state, before drawing. It writes only what differs.
   * @param {() => void} show
   */
  onShow(show) {
    this.shows.push(show);
  }

  /** Runs at the end of each frame. @param {() => void} draw */
  onDraw(draw) {
    this.drawings.push(draw);
  }

  /** Runs when colours or the pixel ratio change. @param {() => void} listener */
  onTheme(listener) {
    this.themeListeners.push(listener);
  }

  /** The state has changed: the next frame shows it. */
  changed() {
    this.isStale = true;
    this.requestFrame();
  }

  /** Shows the state if it has changed. */
  show() {
    if (!this.isStale) return;
    this.isStale = false;
    for (const show of this.shows) show();
  }

  requestFrame() {
    document.body.dataset.settled = "false";
    this.frame ||= requestAnimationFrame((now) => this.runFrame(now));
  }

  /** @param {number} now */
  runFrame(now) {
    this.frame = 0;
    let goesOn = false;
    this.guard(() => {
      for (const animate of this.animations) goesOn = animate(now) === true || goesOn;
      this.show();
      for (const draw of this.drawings) draw();
    });
    if (goesOn) this.requestFrame();
    else if (this.frame === 0 && this.pending === 0) document.body.dataset.settled = "true";
  }

  /**
   * Awaits a promise; the page is not settled until then. An error is shown and gives undefined, and so does work that
   * was aborted.
   * @template T
   * @param {Promise<T>} promise
   * @param {string} [title]   of the error
   */
  async track(promise, title) {
    this.pending++;
    document.body.dataset.settled = "false";
    try {
      return await promise;
    } catch (error) {
      this.fail(error, title);
      return undefined;
    } finally {
      this.pending--;
      this.requestFrame();
    }
  }

  /**
   * Calls a function; an error is shown and gives undefined.
   * @template T
   * @param {() => T} act
   * @param {string} [title]   of the error
   */
  guard(act, title) {
    try {
      return act();
    } catch (error) {
      this.fail(error, title);
      return undefined;
    }
  }

  /**
   * Shows an error, unless work was aborted; after a panic of the core, starts the core again.
   * @param {unknown} error
   * @param {string} [title]
   */
  fail(error, title = "Something went wrong.") {
    if (isAbort(error)) return;
    if (errorInfo(error).code !== "internal") {
      this.notice.show(title, error);
      return;
    }
    if (this.core) library.initSync(this.core);
    this.rebuild();
    const message =
      "Planarium\u2019s core stopped because of an internal error. It was restarted, and any run starts again.";
    this.notice.show(title, Object.assign(new Error(message), { code: "internal" }));
  }

  /**
   * Shows a sentence above the figures and announces it.
   * @param {string} text
   * @param {{ isBad?: boolean, isSilent?: boolean }} [options]
   */
  say(text, { isBad = false, isSilent = false } = {}) {
    const story = byId("story", HTMLElement);
    write(story, text);
    story.dataset.tone = isBad ? "bad" : "";
    if (text !== this.message && !isSilent) this.announcer.say(text);
    this.message = text;
  }

  /** Writes texts into elements by their ids. @param {Record<string, string>} texts */
  write(texts) {
    for (const [id, text] of Object.entries(texts)) write(byId(id, HTMLElement), text);
  }

  /** How to draw. */
  get look() {
    const palette = readPalette(byId("main", HTMLElement));
    return { palette, ratio: devicePixelRatio || 1, calm: this.reducedMotion, bold: isProjected() ? 1.7 : 1 };
  }

  setTheme() {
    for (const listener of this.themeListeners) listener();
    this.requestFrame();
  }

  watchPixelRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
      "change",
      () => {
        this.setTheme();
        this.watchPixelRatio();
      },
      { once: true },
    );
  }
}
