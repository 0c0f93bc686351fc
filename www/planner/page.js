/**
 * The page as its parts know it: what is open, the state of the last frame, and whom to tell. Parts register what they do when a
 * scene opens, when a state comes, when the colours change; none of them knows the others.
 */
import { byId } from "../app/dom.js";
import { isProjected } from "../app/projector.js";
import { nameAll } from "./race/names.js";
import { faultOf } from "../app/fault.js";
import { loadScene } from "../app/resources.js";
import { readPalette } from "../app/palette.js";
import { letter } from "./race/standings.js";

/** @import { Notice } from "../app/notice.js" */
/** @import { Panel } from "./settings/panel.js" */
/** @import { Race } from "./race/race.js" */
/** @import { Session } from "./session.js" */
/** @import { Look, Plan, SceneEntry, SceneFacts, Source, State, ViewOptions } from "../domain/types.js" */
/** @typedef {{ entry?: SceneEntry, query?: string, plans?: Plan[], iteration?: number, play?: boolean }} Opening   how a scenario is to be put on the stage */

/** Iterations a second at which a scenario of the reader's own is shown. */
const PACE = 60;

export class Page {
  /** @param {Session} session @param {Panel} panel @param {Notice} notice */
  constructor(session, panel, notice) {
    this.session = session;
    this.panel = panel;
    this.notice = notice;
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    /** How things stood at the last frame. @type {State | null} */
    this.state = null;
    /** The scenario on the stage. @type {SceneFacts | null} */
    this.facts = null;
    /** Where it comes from. @type {Source | null} */
    this.source = null;
    /** The page's own scene, if it is one. @type {SceneEntry | null} */
    this.entry = null;
    /** The title of an edited scenario; empty while nothing is edited. */
    this.editedTitle = "";
    /** Iterations a second that it was opened with, if it did not keep those of before. @type {number | undefined} */
    this.pace = undefined;
    /** PlannerWorker that race with the one of the panel. @type {Plan[]} */
    this.rivals = [];
    /** What the planners on the stage were asked. @type {Plan[]} */
    this.asked = [];
    /** Counts what was wished for: what is loaded for an older wish is dropped. */
    this.wish = 0;
    /** Where rivals are chosen, once it was asked for. @type {Race | null} */
    this.race = null;
    /** Asks for it. @type {() => Promise<unknown>} */
    this.needRace = async () => {};
    /** Was it told why the core would not plan this? */
    this.told = false;
    /** @type {((facts: SceneFacts, entry: SceneEntry | null) => void)[]} */
    this.openers = [];
    /** @type {((state: State, before: State | null) => void)[]} */
    this.watchers = [];
    /** Who waits for a state. @type {((value: unknown) => void)[]} */
    this.arrivals = [];
    /** @type {(() => void)[]} */
    this.themed = [];
    /** @type {(() => void)[]} */
    this.orderers = [];
    session.tell = (state) => this.reflect(state);
    session.onDirty = () => {
      for (const then of this.orderers) then();
    };
    this.watchRatio();
  }

  /** Calls back whenever a scenario was put on the stage. @param {(facts: SceneFacts, entry: SceneEntry | null) => void} then */
  onOpen(then) { this.openers.push(then); }

  /** Calls back with the state of each frame. @param {(state: State, before: State | null) => void} then */
  onState(then) { this.watchers.push(then); }

  /** Calls back when something was ordered that is not done yet. @param {() => void} then */
  onOrder(then) { this.orderers.push(then); }

  /** Calls back when colours or pixels are others. @param {() => void} then */
  onTheme(then) { this.themed.push(then); }

  /** @returns {Look} */
  get look() { return { palette: readPalette(byId("stage", HTMLElement)), ratio: devicePixelRatio || 1, calm: this.calm, bold: isProjected() ? 1.7 : 1 }; }

  /** Colours or pixels are others. */
  setTheme() {
    this.act((session) => session.stage.setTheme(this.look));
    for (const then of this.themed) then();
  }

  /** Asks to be told when the number of device pixels a CSS pixel changes. */
  watchRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
      this.setTheme();
      this.watchRatio();
    }, { once: true });
  }

  /** @param {SceneEntry} entry @returns {Promise<Source>} */
  async sourceOf(entry) {
    return entry.generate ? { generate: entry.generate } : { document: await loadScene(entry.id) };
  }

  /**
   * Loads one of the page's own scenes and puts it on the stage, unless something newer is wished for meanwhile.
   * @param {SceneEntry} entry
   * @param {Opening} [opening]
   * @returns {Promise<boolean>} whether it is there
   * @throws {Error} it cannot be loaded or read
   */
  async openScene(entry, opening) {
    const mine = ++this.wish;
    const source = await this.sourceOf(entry);
    if (mine !== this.wish) return false;
    await this.open(source, { ...opening, entry });
    return true;
  }

  /**
   * Puts a scenario on the stage, the page's own with the planner and parameters that show it well. What is there stays if it
   * cannot be read.
   * @param {Source} source @param {Opening} [opening]
   * @throws {Error} with `code` and `pointer`
   */
  async open(source, { entry, query, plans, iteration, play = !this.calm } = {}) {
    const { panel } = this;
    this.wish++;
    if (plans && plans.length > 1) await this.needRace();
    // A scene that is put on the stage anew keeps the speed that it is watched at.
    const pace = entry && entry === this.entry ? undefined : entry?.pace ?? PACE;
    const given = plans?.[0] ?? entry;
    const plan = given ? panel.reads(given.algorithm, given.settings) : panel.plan ?? { algorithm: panel.algorithm, settings: {} };
    const rivals = plans?.slice(1) ?? this.race?.beside(plan) ?? this.rivals;
    const mine = this.wish;
    const scenario = this.run((session) => session.read(source));
    const placed = await this.session.placedOf(scenario);
    if (mine !== this.wish) {
      scenario.free();
      return;
    }
    const facts = this.run((session) => session.open(scenario, {
      plans: [plan, ...rivals], query, iteration, play, pace,
      story: { sentence: entry?.story ?? "", algorithm: entry?.algorithm ?? "", isProven: entry?.settings.edge_check !== "sampled" },
    }, placed));
    this.notice.hide();
    this.source = source;
    this.entry = entry ?? null;
    this.editedTitle = "";
    this.rivals = rivals;
    this.asked = [plan, ...rivals];
    this.pace = pace;
    this.told = false;
    if (plans) this.race?.adopt(this.asked);
    const isOther = panel.offer(facts.robot);
    if (given) panel.suggest(given.algorithm, given.settings, entry?.settings);
    this.show(facts);
    // What was chosen for another robot would be refused.
    if (!given && isOther) this.plan(play);
  }

  /** The scenario on the stage is this now. @param {SceneFacts} facts */
  show(facts) {
    this.facts = facts;
    this.panel.offerQueries(facts.queries, facts.query);
    document.body.dataset.scene = this.entry?.id ?? "file";
    for (const then of this.openers) then(facts, this.entry);
  }

  /**
   * Does something with the session; what was shown at rest no longer holds.
   * @template T @param {(session: Session) => T} action @returns {T}
   * @throws {Error} what the action throws; a lost core is renewed first
   */
  run(action) {
    const { session } = this;
    try {
      return action(session);
    } catch (error) {
      if (faultOf(error).code === "internal") session.recover();
      throw error;
    } finally {
      session.markDirty();
    }
  }

  /** The same, where nobody waits for what it returns: that it did not work is said. @param {(session: Session) => unknown} action */
  act(action) {
    try {
      this.run(action);
    } catch (error) {
      this.notice.show("Something went wrong.", error);
    }
  }

  /** Waits until all that was asked for is shown, or at least under way. @returns {Promise<State | null>} */
  async arrived() {
    for (;;) {
      const { state, session } = this;
      if (!state || (!session.isStale && (state.playing || state.settled))) return state;
      await new Promise((resolve) => this.arrivals.push(resolve));
    }
  }

  /** What all planners are asked, or null while a field holds a value that is refused. @returns {Plan[] | null} */
  get plans() {
    const { plan } = this.panel;
    const rivals = plan && (this.race ? this.race.beside(plan) : []);
    return rivals && [plan, ...rivals];
  }

  /** The title of what is on the stage. */
  get title() { return this.editedTitle || (this.entry?.title ?? this.facts?.title ?? ""); }

  /** What the planners on the stage are called. */
  get names() { return nameAll(this.asked, (algorithm) => this.panel.titleOf(algorithm)); }

  /** New runs from the settings. @param {boolean} [play] */
  plan(play = this.goesOn) {
    const { plans } = this;
    if (!plans) return;
    this.notice.hide();
    this.rivals = plans.slice(1);
    this.asked = plans;
    this.told = false;
    this.act((session) => session.plan(plans, play));
  }

  /** Points at a vertex by its number. @param {number} vertex  -1: none */
  async inspect(vertex) {
    const pointing = await this.session.byHand.ready();
    this.act(() => pointing.choose(vertex));
  }

  /** Other things are to be seen. @param {Partial<ViewOptions>} view */
  see(view) { this.act((session) => session.setView(view)); }

  /** The query that is chosen. */
  ask() {
    this.told = false;
    this.act((session) => session.ask(this.panel.query.value, this.goesOn));
  }

  /** Whoever changes a setting of a run that moves or has ended wants to see the new one. */
  get goesOn() {
    const { state, calm } = this;
    return state !== null && (state.playing || (!calm && !state.growing && state.lanes.some(({ status }) => status !== "none")));
  }

  /** @param {State} state */
  reflect(state) {
    const before = this.state;
    this.state = state;
    if (state.lanes.length === 0) return;
    for (const then of this.watchers) then(state, before);
    for (const arrive of this.arrivals.splice(0)) arrive(null);
    const { refusal } = state;
    // Old news is not told, and each refusal once; what the editor is at, it says itself, where the hand is.
    if (!refusal || Boolean(before?.edit) !== Boolean(state.edit)) this.told = false;
    if (!refusal || this.told || state.edit?.touching) return;
    this.told = true;
    const { lane, pointer, message } = refusal;
    if (lane === 0 ? this.panel.refuse(pointer, message) : this.race?.refuse(lane, pointer, message)) return;
    const who = state.clock.isRace ? `${letter(lane)}, ${this.panel.titleOf(state.lanes[lane].algorithm)},` : "This";
    this.notice.show(`${who} cannot be planned.`, Object.assign(new Error(message), refusal));
  }
}
