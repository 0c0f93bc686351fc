/**
 * The page as its features see it: its state, the open scene, the state of the last frame, and events. Features change
 * the state by patches, and register listeners for scenes and frames; none of them knows the others.
 */
import {
  ELSEWHERE,
  EMPTY,
  entryOf,
  fitted,
  generationOf,
  laneOf,
  reconcile,
  same,
  sourceOf,
  viewOf,
} from "./experiment.js";
import { letter } from "./race/standings.js";
import { nameAll } from "./race/names.js";
import { requirePart } from "./link/codec.js";

/** @import { App } from "../app/app.js" */
/** @import { Panel } from "./settings/panel.js" */
/** @import { DriveControls } from "./driving/controls.js" */
/** @import { Facts, Patch } from "./experiment.js" */
/** @import { Experiment } from "./link/codec.js" */
/** @import { Planners } from "./settings/planners.js" */
/** @import { Race } from "./race/race.js" */
/** @import { Session } from "./session.js" */
/** @import { Placed } from "./stage/placed.js" */
/** @import { SceneFacts } from "./session.js" */
/** @import { State } from "./state.js" */
/** @import { TimingPanel } from "./timing/timing-panel.js" */
/** @import { Plan, Scenario, ScenarioDocument, SceneEntry } from "../domain/types.js" */
/** @typedef {Facts & { scenario: Scenario, document: ScenarioDocument, placed: Placed | null }} Opened   what was read */
/**
 * @typedef {object} How   a patch is applied
 * @property {boolean} [play]       whether new runs play at once
 * @property {boolean} [isAsGiven]  planners that do not serve the robot stay, and the core refuses them
 * @property {(facts: Facts) => void} [check]   throws, and the open scene stays
 */

/** Iterations a second of a scenario from a file. */
const PACE = 60;

export class Page {
  /** @param {App} app @param {Session} session @param {Panel} panel @param {Planners} planners */
  constructor(app, session, panel, planners) {
    this.app = app;
    this.session = session;
    this.panel = panel;
    this.planners = planners;
    this.notice = app.notice;
    this.calm = app.reducedMotion;
    /** The state of the page; the iteration and the configuration in hand are the session's. @type {Experiment} */
    this.record = EMPTY;
    /** What the lanes of the record run with. @type {Plan[]} */
    this.plans = [];
    /** The state of the last frame. @type {State | null} */
    this.state = null;
    /** The open scenario. @type {SceneFacts | null} */
    this.facts = null;
    /** What a link or the way back shows, until the run has come to it. @type {Experiment | null} */
    this.coming = null;
    /** The title of the scene as it was opened. */
    this.name = "";
    /** Number of the latest request to open a scene; an older one that is still loading is dropped. */
    this.request = 0;
    /** Whether planners that do not serve the robot stay. */
    this.isAsGiven = false;
    /** Loaded on demand. @type {Race | null} */
    this.race = null;
    /** Loaded on demand. @type {TimingPanel | null} */
    this.timing = null;
    /** Loads the race. @type {() => Promise<unknown>} */
    this.loadRace = async () => {};
    /** Loads the driving controls. @type {() => Promise<DriveControls>} */
    this.loadDrive = () => Promise.reject(new Error("The driving controls are not loaded yet."));
    /** Arranges the figures on the stage. */
    this.arrange = () => {};
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

  /** The open scene, where it is a built-in one. */
  get entry() {
    return entryOf(this.record);
  }

  /** What generated the open scene, if something did. */
  get generation() {
    return generationOf(this.record);
  }

  /** The name of the current query. */
  get query() {
    return this.record.query ?? this.session.shown?.document.queries[0]?.name;
  }

  /** The robot: planners and parameters for others are not offered. */
  get robot() {
    return this.session.shown?.scenario.robot ?? "arm";
  }

  /** The title of the scene, and whether it was edited. */
  get title() {
    return this.state?.isEdited ? `${this.name} (edited)` : this.name;
  }

  get names() {
    return nameAll(this.plans, (algorithm) => this.planners.titleOf(algorithm));
  }

  /** Whether the state has the entries of a patch. @param {Patch} patch */
  has({ lanes, options, ...patch }) {
    const { record, facts, planners, plans, robot, generation } = this;
    return (
      facts !== null &&
      same({ ...record, ...patch }, record) &&
      same(generationOf({ scene: record.scene, options }), generation) &&
      (!lanes || same(planners.plansOf(lanes, robot), plans))
    );
  }

  /**
   * Reads the scenario of an experiment.
   * @param {Patch} experiment
   * @returns {Promise<Opened>}
   * @throws {Error} it cannot be loaded or read, with `code` and `pointer`
   */
  async read(experiment) {
    const scenario = this.session.read(await sourceOf(experiment));
    const { robot, dimension } = scenario;
    const document = scenario.document();
    const queries = document.queries.map(({ name }) => name);
    return { scenario, document, robot, dimension, queries, placed: await this.session.placedOf(scenario) };
  }

  /**
   * Changes the state of the page and reads its scenario, unless a newer request comes meanwhile. A patch with a scene
   * or a document is another scene, with its first query. One that cannot be read leaves the open one in place.
   * @param {Patch} patch
   * @param {How} [how]
   * @returns {Promise<string[] | null>} sentences about what did not fit; null: a newer request came
   * @throws {Error} it cannot be loaded or read, with `code` and `pointer`
   */
  async open(patch, { play = !this.calm, check, isAsGiven } = {}) {
    const request = ++this.request;
    const whole = patch.scene || patch.document ? { ...ELSEWHERE, ...patch } : patch;
    if ((patch.lanes?.length ?? 0) > 1) await this.loadRace();
    if (request !== this.request) return null;
    const opened = await this.read({ ...this.record, ...whole });
    const { document } = opened;
    try {
      check?.(opened);
      if (request !== this.request) return null;
      return this.apply(whole.document ? { ...whole, document } : whole, { play, isAsGiven }, opened);
    } finally {
      if (this.session.shown?.scenario !== opened.scenario) opened.scenario.free();
    }
  }

  /** Changes the state of the page; an error is shown. @param {Patch} patch */
  change(patch) {
    this.app.guard(() => this.apply(patch));
  }

  /**
   * Changes the state of the page, and makes everything agree that depends on what differs.
   * @param {Patch} patch
   * @param {How} [how]
   * @param {Opened} [opened]   the scenario, where it is another one than that on the stage
   * @returns {string[]} sentences about what did not fit, which are shown
   */
  apply(patch, { play = this.autoplay, isAsGiven } = {}, opened = undefined) {
    const { record: before, session, planners, entry: left } = this;
    const { document: _, ...checked } = patch;
    requirePart(checked);
    const was = this.facts?.robot;
    const facts = opened ?? this.facts;
    if (!facts) return [];
    const next = /** @type {Experiment} */ ({ ...before, ...patch });
    // Other coordinates have other meanings.
    if ((was !== facts.robot || this.facts?.dimension !== facts.dimension) && !patch.view)
      next.view = { ...next.view, axes: undefined };
    this.isAsGiven = isAsGiven ?? (this.isAsGiven && !opened && !patch.lanes);
    const { experiment, faults } = fitted(next, facts, planners, {
      was: opened && patch.lanes ? undefined : was,
      isAsGiven: this.isAsGiven,
    });
    const { iteration, pose, drive: _drive, roll: _roll, euler: _euler, ...lasting } = experiment;
    this.record = { ...lasting, iteration: 0 };
    this.plans = planners.plansOf(lasting.lanes, facts.robot);
    reconcile(
      before,
      this.record,
      { ...patch, pose, opened },
      {
        scenario: () => opened && this.enter(opened, left, Boolean(patch.lanes)),
        settings: () => this.showSettings(),
        rivals: () => this.race?.agree(),
        view: () => session.setView(viewOf(lasting.view, facts.robot)),
        run: () => this.begin(play),
        figures: () => this.arrange(),
        news: () => this.announce(),
        time: () => this.seek(iteration),
        timing: () => this.timing?.follow(),
        hand: () => pose && session.byHand.hold(Float64Array.from(pose)),
      },
    );
    session.markDirty();
    if (faults.length > 0) this.notice.show(faults.join(" "), "");
    return faults;
  }

  /**
   * Puts a scenario on the stage.
   * @param {Opened} opened
   * @param {SceneEntry | null} left   the scene before
   * @param {boolean} isOwn   whether planners come with it
   */
  enter({ scenario, document, placed }, left, isOwn) {
    const { entry, record } = this;
    const isKept = !isOwn && entry && record.lanes[0].algorithm !== entry.algorithm;
    // A scene that is opened again keeps the current speed, and so does a planner.
    const pace = entry && (entry === left || isKept) ? undefined : (record.pace ?? entry?.pace ?? PACE);
    this.session.open(scenario, document, placed, pace);
    this.name = entry?.title ?? (scenario.title || scenario.name);
  }

  showSettings() {
    const { panel, planners, robot, record, entry } = this;
    panel.show(record.lanes[0], planners.for(robot), robot, entry?.settings);
    const own = entry && laneOf(entry);
    panel.offerOwn(
      own && !same(planners.plansOf([own], robot)[0], this.plans[0]) ? planners.titleOf(own.algorithm) : "",
    );
  }

  /** The first lane becomes the scene's own planner. */
  useOwn() {
    const { entry, record } = this;
    if (!entry) return;
    const { scene, options, query } = record;
    void this.app.track(this.open({ scene, options, query, lanes: record.lanes.with(0, laneOf(entry)) }));
  }

  /** Begins new runs. @param {boolean} play */
  begin(play) {
    const { session, plans, query = "" } = this;
    this.notice.hide();
    this.isRefusalShown = false;
    session.plan(plans, play && !session.editor?.on, query || undefined);
    this.facts = session.facts();
    this.panel.selectQuery(query);
  }

  /** Announces the open scenario to the listeners. */
  announce() {
    const { session, panel, entry } = this;
    const facts = session.facts();
    this.facts = facts;
    this.notice.hide();
    session.story = {
      sentence: entry?.story ?? "",
      algorithm: entry?.algorithm ?? "",
      isProven: (entry?.settings.edge_check ?? "proven") === "proven",
    };
    panel.offerQueries(facts.queries, facts.query);
    this.named = undefined;
    this.nameQueries();
    for (const listener of this.openListeners) listener(facts, entry);
  }

  /** Shows an iteration, or in a race a time. @param {number} time */
  seek(time) {
    const { clock, shown, refusal, timeline } = this.session;
    const isShown = clock.now === time && !clock.playing && !clock.owes && !shown?.hand;
    if (!refusal && !isShown) timeline.seek(time);
  }

  /** Names the queries in collision, which an edited scene may change. */
  nameQueries() {
    const { session } = this;
    if (session.shown?.document === this.named) return;
    this.named = session.shown?.document;
    this.panel.nameQueries(session.queryTexts);
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

  /** Points at a vertex by its number. @param {number} vertex  -1: none */
  async inspect(vertex) {
    const pointing = await this.session.byHand.ready();
    this.act(() => {
      pointing.chosen = vertex;
    });
  }

  /** Changes the view. @param {Experiment["view"]} view */
  setView(view) {
    this.change({ view: { ...this.record.view, ...view } });
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
      ? `${letter(lane)}, ${this.planners.titleOf(state.lanes[lane].algorithm)},`
      : "This";
    const text =
      lane > 0
        ? `${message.replace(/\.?$/, ".")} Change its settings or remove ${letter(lane)} to start the race.`
        : message;
    this.notice.show(`${subject} cannot be planned.`, Object.assign(new Error(text), { code, pointer }));
  }
}
