/** Opens experiments: ready ones, files, and those of links. Short ones run at once. */
import { byId, make } from "../app/dom.js";
import { parsed } from "../formats/json.js";
import { enoughSeeds } from "./form.js";
import { READY, loadReady, readyOf } from "./ready.js";

/** @import { LinkedDocument } from "../domain/types.js" */
/** @import { ExperimentState } from "./link.js" */
/** @import { OpenedWorld } from "../worlds/door.js" */
/** @import { ExperimentSession } from "./session.js" */

/**
 * Trials that run as they are opened, at most: of an experiment that the reader chose here or in a file, and of a link,
 * which may come from anyone.
 */
const AT_ONCE = { here: 5000, link: 400 };

/** As many queries of a world are problems enough for one seed, and as many are taken. */
const MANY = { least: 20, most: 100 };

export class Opener {
  /**
   * @param {ExperimentSession} session
   * @param {(id: string) => void} choose   a ready experiment
   * @param {() => void} start   runs the trials
   */
  constructor(session, choose, start) {
    this.session = session;
    this.start = start;
    /** Trials that run without a click, at most. */
    this.most = AT_ONCE.here;
    /** The document that was opened last: another one is an edited one. @type {LinkedDocument | null} */
    this.opened = null;
    this.select = byId("ready", HTMLSelectElement);
    this.select.append(
      make("option", { value: "", disabled: true }, "custom"),
      ...READY.map(({ id, title }) => make("option", { value: id }, title)),
    );
    this.select.addEventListener("change", () => choose(this.select.value));
    session.onChange(() => {
      if (session.document !== this.opened) this.select.value = "";
    });
  }

  /** Whether the experiment is from a link, of which fewer trials run by themselves. */
  get isFromLink() {
    return this.most === AT_ONCE.link;
  }

  /**
   * Opens an experiment, and runs it if it is short. One that asks to run does so with reduced motion, too.
   * @param {ExperimentState} state
   * @param {string} id  of a ready one, or empty
   * @param {number} [most]  trials that run without a click
   */
  async open(state, id, most = AT_ONCE.here) {
    const { session, select } = this;
    session.app.notice.hide();
    select.value = id;
    this.opened = state.document;
    this.most = most;
    const isAccepted = await session.open(state);
    const isAsked = state.run ?? !session.app.reducedMotion;
    if (isAccepted && isAsked && (session.info?.trialCount ?? Infinity) <= most) this.start();
  }

  /** @param {string} id @param {AbortSignal} signal   something else is opened meanwhile */
  async openReady(id, signal) {
    const state = await loadReady(id);
    signal.throwIfAborted();
    await this.open(state, id);
  }

  /**
   * Opens the experiment of a link; without one the first ready experiment, unless one is open.
   * @param {ExperimentState | null} state
   * @param {AbortSignal} signal   something else is opened meanwhile
   * @param {boolean} isLeft   it was open here before, and the reader comes back to it
   */
  async openLinked(state, signal, isLeft) {
    if (!state) {
      if (!this.session.info) await this.openReady(READY[0].id, signal);
      return;
    }
    const { id, isKnown } = await readyOf(state.document);
    signal.throwIfAborted();
    await this.open(state, id, isKnown || isLeft ? AT_ONCE.here : AT_ONCE.link);
  }

  /**
   * Opens an experiment; a scenario becomes the world of the one that is open.
   * @param {string} name
   * @param {string} text
   */
  async openFile(name, text) {
    // The core says what is wrong with anything that is not an experiment.
    const read = parsed(text);
    const { document } = this.session;
    const title = name.replace(/\.json$/, "");
    const isScenario = read?.format === "planarium-scenario-1";
    const opened = isScenario ? enoughSeeds({ ...document, title, worlds: [{ scenario: read }] }) : read;
    await this.open({ document: opened, view: {} }, "");
  }

  /**
   * Makes a world of another program the world of the experiment that is open: each of its queries is a problem, and
   * where there are many of them, one seed a query.
   * @param {OpenedWorld} opened
   */
  async openWorld({ document: scenario }) {
    const { document } = this.session;
    const names = scenario.queries.map(({ name }) => name);
    const isMany = names.length >= MANY.least;
    // Evenly over the file, whose queries often become harder.
    const step = Math.max(1, names.length / MANY.most);
    const queries = Array.from({ length: Math.min(names.length, MANY.most) }, (_, i) => names[Math.floor(i * step)]);
    const fresh = { ...document, title: scenario.title || scenario.name, worlds: [{ scenario, queries }] };
    await this.open(
      { document: isMany ? { ...fresh, seeds: { from: 0, count: 1 } } : enoughSeeds(fresh), view: {} },
      "",
    );
  }
}
