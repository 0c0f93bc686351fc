/**
 * The page as its features see it: the open scene, the state of the last frame, and events. Features register listeners
 * for scenes and states; none of them knows the others.
 */
import { nameAll } from "./race/names.js";
import { loadScene } from "../app/resources.js";
import { letter } from "./race/standings.js";
import { robotName } from "../domain/names.js";

/** @import { App } from "../app/app.js" */
/** @import { Panel } from "./settings/panel.js" */
/** @import { DriveControls } from "./driving/controls.js" */
/** @import { Race } from "./race/race.js" */
/** @import { Session } from "./session.js" */
/** @import { Plan, ScenarioDocument, SceneEntry, SceneFacts, Source, State, ViewOptions } from "../domain/types.js" */
/**
 * @typedef {{ entry?: SceneEntry, query?: string, plans?: Plan[], iteration?: number, play?: boolean }} Opening   how
 *   to open a scenario
 */

/** Iterations a second of a scenario from a file. */
const PACE = 60;

export class Page {
  /** @param {App} app @param {Session} session @param {Panel} panel */
  constructor(app, session, panel) {
    this.app = app;
    this.session = session;
    this.panel = panel;
    this.notice = app.notice;
    this.calm = app.reducedMotion;
    /** The state of the last frame. @type {State | null} */
    this.state = null;
    /** The open scenario. @type {SceneFacts | null} */
    this.facts = null;
    /** The origin of the open scenario. @type {Source | null} */
    this.source = null;
    /** The open scene, where it is a built-in one. @type {SceneEntry | null} */
    this.entry = null;
    this.name = "";
    /**
     * Iterations a second that the scene was opened with; undefined keeps the previous speed.
     * @type {number | undefined}
     */
    this.pace = undefined;
    /** The plans of the current runs: first the panel's, then its rivals'. @type {Plan[]} */
    this.current = [];
    /** Number of the latest request to open a scene; an older one that is still loading is dropped. */
    this.request = 0;
    /** Loaded on demand. @type {Race | null} */
    this.race = null;
    /** Loads the race. @type {() => Promise<unknown>} */
    this.loadRace = async () => {};
    /** Loads the driving controls. @type {() => Promise<DriveControls>} */
    this.loadDrive = () => Promise.reject(new Error("The driving controls are not loaded yet."));
    /** The scenario whose queries the panel names. @type {ScenarioDocument | undefined} */
    this.named = undefined;
    /** Whether the current refusal has been shown. */
    this.isRefusalShown = false;
    /** @type {((facts: SceneFacts, entry: SceneEntry | null) => void)[]} */
    this.openListeners = [];
    /** @type {((state: State) => void)[]} */
    this.stateListeners = [];
    /** Resolved with the next state. @type {((value: unknown) => void)[]} */
    this.waiting = [];
    session.onState = (state) => this.reflect(state);
  }

  /**
   * Runs with the open scenario, and whenever another one was opened.
   * @param {(facts: SceneFacts, entry: SceneEntry | null) => void} listener
   */
  onOpen(listener) {
    this.openListeners.push(listener);
    if (this.facts) listener(this.facts, this.entry);
  }

  /** Runs with the last state, and with the state of each frame. @param {(state: State) => void} listener */
  onState(listener) {
    this.stateListeners.push(listener);
    if (this.state) listener(this.state);
  }

  /** @param {SceneEntry} entry @returns {Promise<Source>} */
  async sourceOf(entry) {
    return entry.generate ? { generate: entry.generate } : { document: await loadScene(entry.id) };
  }

  /**
   * Loads and opens a built-in scene, unless a newer request comes meanwhile.
   * @param {SceneEntry} entry
   * @param {Opening} [opening]
   * @returns {Promise<boolean>} whether it was opened
   * @throws {Error} it cannot be loaded or read
   */
  async openScene(entry, opening) {
    const request = ++this.request;
    const source = await this.sourceOf(entry);
    if (request !== this.request) return false;
    await this.open(source, { ...opening, entry });
    return true;
  }

  /**
   * Opens a scenario, a built-in one with its own planner and parameters. One that cannot be read leaves the open one
   * in place.
   * @param {Source} source @param {Opening} [opening]
   * @throws {Error} with `code` and `pointer`
   */
  async open(source, { entry, query, plans, iteration, play = !this.calm } = {}) {
    const { panel, session } = this;
    const request = ++this.request;
    if (plans && plans.length > 1) await this.loadRace();
    // A scene that is opened again keeps the current speed.
    const pace = entry && entry === this.entry ? undefined : (entry?.pace ?? PACE);
    const given = plans?.[0] ?? entry;
    const scenario = session.read(source);
    const placed = await session.placedOf(scenario);
    if (request !== this.request) {
      scenario.free();
      return;
    }
    // Planners and parameters for other robots would be refused.
    panel.offer(scenario.robot);
    if (!given) panel.form.build();
    const plan = given
      ? panel.planFrom(given.algorithm, given.settings)
      : (panel.plan ?? { algorithm: panel.algorithm, settings: {} });
    const dropped = this.race?.offer() ?? [];
    // With their defaults, so that their names say what they differ in.
    const wanted =
      plans?.slice(1).map(({ algorithm, settings }) => panel.planFrom(algorithm, settings)) ??
      this.race?.beside(plan) ??
      this.current.slice(1);
    const isServed = (/** @type {Plan} */ { algorithm }) => panel.serves(algorithm);
    const removed = plans
      ? wanted.map((rival, i) => ({ ...rival, lane: i + 1 })).filter((rival) => !isServed(rival))
      : dropped;
    const current = [plan, ...wanted.filter(isServed)];
    const facts = this.run(() =>
      session.open(
        scenario,
        {
          plans: current,
          query,
          iteration,
          play,
          pace,
          story: {
            sentence: entry?.story ?? "",
            algorithm: entry?.algorithm ?? "",
            isProven: (entry?.settings.edge_check ?? "proven") === "proven",
          },
        },
        placed,
      ),
    );
    this.notice.hide();
    this.source = source;
    this.entry = entry ?? null;
    this.current = current;
    this.pace = pace;
    this.name = entry?.title ?? facts.title;
    this.isRefusalShown = false;
    if (plans) this.race?.adopt(current);
    if (given) panel.suggest(given.algorithm, given.settings, entry?.settings);
    this.show(facts);
    if (removed.length > 0) this.notice.show(removed.map((one) => this.removal(one)).join(" "), "");
  }

  /** Why a rival was removed. @param {{ lane: number, algorithm: string }} rival */
  removal({ lane, algorithm }) {
    const info = this.panel.infos.find(({ id }) => id === algorithm);
    const robots = info?.robots.map((robot) => `${robot === "arm" ? "an" : "a"} ${robotName(robot)}`).join(" or ");
    return `${info ? `${info.title} needs ${robots}` : `There is no planner "${algorithm}"`}, so rival ${letter(lane)} was removed.`;
  }

  /** Names the queries in collision, which an edited scene may change. */
  nameQueries() {
    const { session } = this;
    if (session.shown?.document === this.named) return;
    this.named = session.shown?.document;
    this.panel.nameQueries(session.queryTexts);
  }

  /** Announces the open scenario to the listeners. @param {SceneFacts} facts */
  show(facts) {
    this.facts = facts;
    this.panel.offerQueries(facts.queries, facts.query);
    this.named = undefined;
    this.nameQueries();
    document.body.dataset.scene = this.entry?.id ?? "file";
    for (const listener of this.openListeners) listener(facts, this.entry);
  }

  /**
   * Changes the session; the state last shown is then out of date.
   * @template T @param {(session: Session) => T} action @returns {T}
   */
  run(action) {
    const value = action(this.session);
    this.session.markDirty();
    return value;
  }

  /** Changes the session; an error is shown. @param {(session: Session) => unknown} action */
  act(action) {
    this.app.guard(() => this.run(action));
  }

  /** Waits until everything requested is shown, or a run plays. @returns {Promise<State | null>} */
  async arrived() {
    for (;;) {
      const { state, session } = this;
      if (!state || (!session.isStale && (state.playing || state.settled))) return state;
      await new Promise((resolve) => this.waiting.push(resolve));
    }
  }

  /** The plans of the panel and the rivals, or null while a field holds an invalid value. @returns {Plan[] | null} */
  get plans() {
    const { plan } = this.panel;
    const rivals = plan && (this.race ? this.race.beside(plan) : []);
    return rivals && [plan, ...rivals];
  }

  /** The title of the scene, and whether it was edited. */
  get title() {
    return this.state?.isEdited ? `${this.name} (edited)` : this.name;
  }

  get names() {
    return nameAll(this.current, (algorithm) => this.panel.titleOf(algorithm));
  }

  /** Begins new runs with the current settings. */
  plan() {
    const { plans } = this;
    if (!plans) return;
    this.notice.hide();
    this.current = plans;
    this.isRefusalShown = false;
    this.act((session) => session.plan(plans, this.autoplay));
  }

  /** Points at a vertex by its number. @param {number} vertex  -1: none */
  async inspect(vertex) {
    const pointing = await this.session.byHand.ready();
    this.act(() => {
      pointing.chosen = vertex;
    });
  }

  /** Changes the view. @param {Partial<ViewOptions>} view */
  setView(view) {
    this.act((session) => session.setView(view));
  }

  /** Plans the query selected in the panel. */
  setQuery() {
    this.isRefusalShown = false;
    this.act((session) => session.setQuery(this.panel.query.value, this.autoplay));
  }

  /** Whether a new run plays at once: after a change to a run that plays or has ended. */
  get autoplay() {
    const { state, calm } = this;
    return (
      state !== null &&
      (state.playing || (!calm && !state.growing && state.lanes.some(({ status }) => status !== "none")))
    );
  }

  /** @param {State} state */
  reflect(state) {
    const before = this.state;
    this.state = state;
    if (state.lanes.length === 0) return;
    this.nameQueries();
    for (const listener of this.stateListeners) listener(state);
    for (const resolve of this.waiting.splice(0)) resolve(null);
    const { refusal, isEditing } = state;
    // Each refusal is shown once. The editor shows its own beside the object.
    if (!refusal || Boolean(before?.isEditing) !== isEditing) this.isRefusalShown = false;
    if (!refusal || this.isRefusalShown || (isEditing && this.session.editor?.touching)) return;
    this.isRefusalShown = true;
    const { lane, pointer, message, code } = refusal;
    if (lane > 0) this.race?.refuse(lane, pointer, message);
    else if (this.panel.form.refuse(pointer, message)) return;
    const subject = state.clock.isRace
      ? `${letter(lane)}, ${this.panel.titleOf(state.lanes[lane].algorithm)},`
      : "This";
    const text =
      lane > 0
        ? `${message.replace(/\.?$/, ".")} Change its settings or remove ${letter(lane)} to start the race.`
        : message;
    this.notice.show(`${subject} cannot be planned.`, Object.assign(new Error(text), { code, pointer }));
  }
}
