/**
 * The session: the scenario on the stage, the planners that grow on it, the time that is shown, and the robot, which
 * follows a path or is posed by hand. A frame draws for a bounded time.
 */
import { withPageDefaults } from "../domain/page-defaults.js";
import { errorInfo } from "../app/error-info.js";
import { once } from "../app/once.js";
import { pacer } from "../app/paced.js";
import { loadRegions } from "./stage/pane.js";
import { Stage } from "./stage/stage.js";
import { Clock } from "./timeline/clock.js";
import { Timeline } from "./timeline/playback.js";
import { coordinatesOf } from "../domain/coordinates.js";
import { VIEW } from "../domain/page-defaults.js";
import { Lane } from "./stage/lane.js";
import { Optima } from "./optimum.js";
import { report } from "./state.js";
import { PoseByHand } from "./pose/pose-by-hand.js";
import { Team } from "./worker/team.js";

/** @import { App } from "../app/app.js" */
/** @import { PlannerWorker } from "./worker/worker.js" */
/** @import { State } from "./state.js" */
/** @import { Configuration, Library, Plan, Pointer, Scenario } from "../domain/types.js" */
/** @import { ScenarioDocument, Source, ViewOptions } from "../domain/types.js" */
/** @import { Driving } from "./driving/driving.js" */
/** @import { Certifying } from "./certificate/certifying.js" */
/** @import { Editor } from "./editor/editor.js" */
/** @import { Repair } from "./repair.js" */
/** @import { Placed } from "./stage/placed.js" */
/** @import { Shown } from "./stage/lane.js" */
/** @import { Story } from "./story.js" */

/** @typedef {ReturnType<Session["facts"]>} SceneFacts   the open scenario, as data */

/** Milliseconds into a frame at which drawing of growth stops: while a run plays, and otherwise. */
const DRAWING = { playing: 6, paused: 24 };
/** Milliseconds between two reports of the state while a run plays: a text that changes more often cannot be read. */
const REPORT = 80;
/** Measures stored in the browser's timeline before it is cleared. */
const MEASURES = 20000;

/** The module that draws bodies and cars, loaded once. */
export const placed = once(() => import("./stage/placed.js"));

export class Session {
  /** @param {App} app @param {Library} library @param {PlannerWorker} planners   the worker */
  constructor(app, library, planners) {
    this.app = app;
    this.library = library;
    this.team = new Team(planners, () => /** @type {PlannerWorker} */ (app.hire()));
    this.catalogue = { phases: library.phases, planners: withPageDefaults(library.planners()) };
    /** Called with the state of each frame. @type {(state: State) => void} */
    this.onState = () => {};
    /** Called when the state last reported is out of date. */
    this.onDirty = () => {};
    this.stage = new Stage(
      async (painting) => (await app.track(planners.obstacles(painting))) ?? null,
      () => this.wake(),
    );
    this.clock = new Clock();
    this.timeline = new Timeline(this);
    this.byHand = new PoseByHand(this);
    /** @type {Shown | null} */
    this.shown = null;
    /** @type {Lane[]} */
    this.lanes = [];
    /** @type {ViewOptions} */
    this.view = { ...VIEW, axes: [0, 1], strobe: true };
    this.optima = new Optima(app, () => this.markDirty());
    this.optima.viewers.push(() => this.view.optimum);
    /** The scene's sentence about its own planner. @type {Story} */
    this.story = { algorithm: "", isProven: true, sentence: "" };
    /** Why the core refused to plan, and the lane. @type {{ error: unknown, lane: number } | null} */
    this.refusal = null;
    /** Whether everything requested is planned and drawn. */
    this.settled = false;
    /** Whether something was requested that no frame has shown yet. */
    this.isStale = false;
    this.isReportDue = pacer(REPORT);
    /** Loaded on demand. @type {Editor | null} */
    this.editor = null;
    /** Loaded with the editor. @type {Repair | null} */
    this.repair = null;
    /** Loaded on demand. @type {Driving | null} */
    this.driving = null;
    /** @type {Certifying | null} */
    this.certifying = null;
    this.last = 0;
    this.measures = 0;
    /** How many times new runs have begun. */
    this.plannings = 0;
    app.onFrame((now) => this.frame(now));
    app.rebuild = () => this.restart();
  }

  /**
   * Loads the drawing of bodies and cars; null for other robots.
   * @param {Scenario} scenario
   * @returns {Promise<Placed | null>}
   */
  async placedOf(scenario) {
    const { robot } = scenario.document();
    if (robot.type !== "rigid_body" && robot.type !== "car") return null;
    const { Placed } = await placed();
    return new Placed(robot);
  }

  /**
   * Puts a scenario on the stage and frees the previous one.
   * @param {Scenario} scenario
   * @param {ScenarioDocument} document
   * @param {Placed | null} placed
   * @param {number} [pace]   iterations a second; the previous speed where absent
   */
  open(scenario, document, placed, pace) {
    for (const lane of this.lanes.splice(0)) lane.free();
    this.shown?.scenario.free();
    this.shown = {
      scenario,
      document,
      query: undefined,
      start: null,
      goal: null,
      target: null,
      goals: [],
      hand: null,
      check: null,
      hover: null,
      view: this.view,
      rough: false,
      overlay: null,
      marked: null,
      certifying: null,
      placed,
      driven: null,
      judged: null,
      room: null,
    };
    if (pace !== undefined) this.clock.pace = pace;
    this.stage.invalidate();
    this.editor?.begin();
  }

  /** @param {Source} source */
  read(source) {
    const { Scenario } = this.library;
    return "generate" in source
      ? Scenario.generate(source.generate.kind, source.generate.options)
      : Scenario.parse(/** @type {ScenarioDocument} */ (source.document));
  }

  /** The scenario on the stage, as data. */
  facts() {
    const { scenario, document, start, goal } = /** @type {Shown} */ (this.shown);
    return {
      name: scenario.name,
      title: scenario.title || scenario.name,
      robot: scenario.robot,
      dimension: scenario.dimension,
      queries: document.queries.map(({ name }) => name),
      query: this.shown?.query,
      coordinates: coordinatesOf({ scenario, document }),
      start: start ? Array.from(start) : null,
      goal: goal ? Array.from(goal) : null,
      document,
    };
  }

  /** The names of the queries, each with its ends that are in collision. @returns {string[]} */
  get queryTexts() {
    const { scenario, document } = /** @type {Shown} */ (this.shown);
    const hits = (/** @type {Configuration | undefined} */ pose) => pose !== undefined && !scenario.check(pose).free;
    return document.queries.map(({ name, start, goal }) => {
      const ends = [hits(start) ? ["start"] : [], hits(goal) ? ["goal"] : []].flat();
      return ends.length > 0 ? `${name} (${ends.join(" and ")} in collision)` : name;
    });
  }

  /**
   * Replaces the scenario by an edited one: a lazy roadmap that stands is repaired; else the same plans wait at
   * iteration 0.
   * @param {Scenario} scenario @param {ScenarioDocument} document @param {Placed | null} placed
   * @param {boolean} live  during a gesture
   */
  replace(scenario, document, placed, live) {
    const { shown, lanes, plans, repair } = this;
    if (!shown) return;
    const edited = { ...shown, scenario, document, placed, hover: null, rough: live, marked: null };
    const { robot, world } = shown.document;
    if (repair?.isPossible && document.robot === robot && document.world.bounds === world.bounds) {
      lanes[0].move(edited);
      this.shown = edited;
      this.setEnds(edited);
      repair.request(document);
      this.markDirty();
    } else {
      for (const lane of lanes) lane.free();
      shown.scenario.free();
      this.shown = edited;
      this.plan(plans, false);
    }
    if (!live) this.stage.invalidate();
  }

  /**
   * Marks configurations until another scene is opened; null removes the marks.
   * @param {Float64Array | null} rows  of `dimension` finite numbers
   * @returns {number} how many of them are free
   */
  mark(rows) {
    const { shown } = this;
    if (!shown) return 0;
    const { scenario } = shown;
    const n = scenario.dimension;
    const free =
      rows &&
      Uint8Array.from({ length: rows.length / n }, (_, i) =>
        Number(scenario.check(rows.subarray(n * i, n * i + n)).free),
      );
    shown.marked = rows && free && { rows, free };
    this.markDirty();
    this.stage.invalidate();
    return free ? free.reduce((sum, one) => sum + one, 0) : 0;
  }

  get plans() {
    return this.lanes.map(({ plan }) => plan);
  }

  /**
   * Begins new runs, one for each plan.
   * @param {Plan[]} plans
   * @param {boolean} play
   * @param {string} [query]   its name
   */
  plan(plans, play, query = this.shown?.query) {
    const { shown, clock } = this;
    if (!shown) return;
    if (query !== shown.query) this.stage.invalidate();
    shown.query = query;
    this.setEnds(shown);
    this.plannings++;
    if (this.repair) this.repair.waiting = null;
    this.byHand.release();
    clock.reset();
    clock.isRace = plans.length > 1;
    this.refusal = null;
    this.markDirty();
    plans.forEach((plan, i) => {
      if (this.lanes[i]?.shown === shown) this.lanes[i].plan = plan;
      else this.lanes[i] = new Lane(shown, plan);
    });
    for (const lane of this.lanes.splice(plans.length)) lane.free();
    let at = 0;
    try {
      for (; at < this.lanes.length; at++) this.lanes[at].start(this.catalogue);
      clock.playing = play;
    } catch (error) {
      for (const lane of this.lanes) lane.free();
      this.refusal = { error, lane: at };
      if (!this.editor?.on) this.byHand.showTouching();
    }
    const { run } = this.lanes[0] ?? {};
    if (shown.target) {
      // Another seed may find other configurations that reach the target.
      shown.goals = run ? run.goals : [];
      this.stage.invalidate();
    }
    this.stage.restart(this.lanes);
    if (!this.refusal) this.timeline.begin();
    this.wake();
  }

  /** Shows the start and the goal of the current query. @param {Shown} shown */
  setEnds(shown) {
    this.certifying?.end();
    const query = shown.document.queries.find(({ name }) => name === shown.query);
    shown.start = query?.start ?? null;
    shown.goal = query?.goal ?? null;
    shown.target = query?.target ?? null;
    shown.goals = shown.goal ? [shown.goal] : (this.lanes[0]?.run?.goals ?? []);
  }

  /** Shows the run as the time passes: what was shown in its place ends. */
  takeOver() {
    this.byHand.release();
    this.certifying?.end();
  }

  /** Whether it can be decided if a path exists: configurations have two coordinates, and the query one goal. */
  get canCertify() {
    const { shown, editor, refusal, lanes } = this;
    if (!shown || editor?.on || refusal || lanes[0]?.asked) return false;
    return shown.scenario.dimension === 2 && shown.goal !== null && shown.hand === null;
  }

  /** Whether a roadmap stands that can be asked for another path. */
  get canAsk() {
    const { lanes, editor } = this;
    return lanes.length === 1 && lanes[0].run?.kind === "roadmap" && lanes[0].run.status !== "running" && !editor?.on;
  }

  /**
   * Asks the roadmap that stands for the path between two configurations: nothing is planned again.
   * @param {Configuration} start
   * @param {Configuration} goal
   * @param {string} query   its name, empty if it is none of the scenario's
   * @throws {Error} with `code` and `pointer`: `start-in-collision`, `goal-in-collision`
   */
  async ask(start, goal, query) {
    const { plannings } = this;
    const [lane] = this.lanes;
    const answer = await this.team.ask([...start], [...goal]);
    const { shown } = this;
    if (plannings !== this.plannings || !shown || !this.canAsk) return;
    this.byHand.release();
    this.certifying?.end();
    lane.answer(answer, query);
    Object.assign(shown, { start, goal, goals: [goal], target: null });
    this.clock.playing = !this.app.reducedMotion && lane.playback !== null;
    if (lane.playback && !this.clock.playing) lane.playback.drawn = 1;
    this.stage.invalidate();
    this.markDirty();
  }

  /** Shows the run's own query again. */
  forget() {
    const { shown } = this;
    const [lane] = this.lanes;
    if (!shown || !lane?.asked) return;
    lane.asked = null;
    this.setEnds(shown);
    this.stage.invalidate();
    this.markDirty();
  }

  /** Begins the same runs again, paused. */
  reset() {
    this.plan(this.plans, false);
  }

  /** Begins the same runs again after the core was lost with everything in it. */
  restart() {
    const { shown, plans } = this;
    if (!shown) return;
    this.shown = {
      ...shown,
      scenario: this.library.Scenario.parse(shown.document),
      hand: null,
      check: null,
      hover: null,
    };
    this.lanes = [];
    this.plan(plans, false);
  }

  /** Declares the state last reported out of date, and requests a frame. */
  markDirty() {
    this.settled = false;
    this.isStale = true;
    this.onDirty();
    this.wake();
  }

  /** Handles a pointer event on a pane, in the editor while that is open. @param {Pointer} pointer */
  async pointer(pointer) {
    await this.byHand.ready();
    if (this.editor?.on) this.editor.hand.handle(pointer);
    else this.byHand.point(pointer);
    this.wake();
  }

  get growing() {
    return this.lanes.some(({ run }) => run && run.status === "running");
  }

  /** Whether the robot can follow a path. */
  get travelling() {
    return !this.growing && this.playbacks.length > 0;
  }

  /** The paths found; in a race they are followed in step. */
  get playbacks() {
    return this.lanes.flatMap(({ playback }) => playback ?? []);
  }

  /** Changes the view. @param {ViewOptions} view */
  setView(view) {
    const { axes, refused } = this.view;
    // The top layer, with the configurations and the path before shortcutting, is redrawn in each frame.
    const isOther = String(view.axes) !== String(axes) || view.refused !== refused;
    Object.assign(this.view, view);
    this.markDirty();
    if (view.regions) void this.app.track(loadRegions().then(() => this.markDirty()));
    if (isOther) this.stage.invalidate();
  }

  wake() {
    this.app.requestFrame();
  }

  /** Draws a frame. @param {number} now @returns {boolean} whether another one is due */
  frame(now) {
    if (!this.shown) return false;
    try {
      return this.perform(now);
    } catch (error) {
      this.fail(error);
      return false;
    }
  }

  /** Stops the run and reports why; errors that are not the planner's are the app's. @param {unknown} error */
  fail(error) {
    const { code } = errorInfo(error);
    if (code === "" || code === "internal") {
      this.app.fail(error);
      return;
    }
    this.clock.halt();
    this.refusal = { error, lane: 0 };
    this.onState(report(this));
  }

  /** @param {number} now */
  perform(now) {
    const { stage, clock, lanes, editor, driving, timeline } = this;
    const began = performance.now();
    editor?.hand.pass();
    editor?.overlay();
    driving?.pass(performance.timeOrigin + now);
    const { shown } = this;
    if (!shown) return false;
    const elapsed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const moved = timeline.pass(elapsed);
    const isWorking = moved || !stage.caughtUp;
    if (moved) this.settled = false;
    this.byHand.hover(shown);
    for (const lane of lanes) {
      lane.run?.frontier.follow();
      lane.optimum = this.optima.of(lane);
      lane.still = !clock.playing && !clock.owes && lane.run?.status === "running";
    }
    stage.frame(lanes, now, began + (clock.playing ? DRAWING.playing : DRAWING.paused), clock.playing);
    const isAtRest = !clock.owes && !timeline.isAsking && !this.repair?.isBusy && (!clock.playing || !this.growing);
    if (isAtRest) timeline.conclude();
    this.settled =
      isAtRest &&
      !timeline.isAsking &&
      !driving?.moves &&
      stage.caughtUp &&
      (clock.playing || shown.hand !== null || stage.isRefined);
    if (isWorking) {
      if (++this.measures % MEASURES === 0) performance.clearMeasures("planarium-frame");
      performance.measure("planarium-frame", { start: began, end: performance.now() });
    }
    // Style, layout and paint of the document take longer than the drawing: while a run plays, texts change less often.
    if (this.isReportDue(!clock.playing || this.isStale || this.settled)) {
      this.isStale = false;
      this.onState(report(this));
    }
    return clock.playing || clock.owes || stage.busy || Boolean(driving?.moves);
  }
}
