/**
 * What goes on: which scenario is on the stage, which planners grow on it, what time it is, whether the robot follows a path
 * or is in the reader's hand. One frame at a time: a bounded slice of planning, then a bounded slice of drawing.
 */
import { faultOf } from "../app/fault.js";
import { once } from "../app/once.js";
import { Stage } from "./stage/stage.js";
import { Clock } from "./timeline/clock.js";
import { Timeline } from "./timeline/playback.js";
import { coordinatesOf } from "../domain/coordinates.js";
import { thinned } from "./run-log/curve.js";
import { Lane } from "./lane.js";
import { axesOf } from "../domain/names.js";
import { report } from "./state.js";
import * as story from "./story.js";
import { PoseByHand } from "./pose/pose-by-hand.js";

/** @import { PlannerWorker } from "./worker/worker.js" */
/** @import { Painting } from "./worker/obstacles.js" */
/** @import { Curves, Library, Plan, Pointer, Programme, Scenario, ScenarioDocument, SceneFacts, Source, State, ViewOptions } from "../domain/types.js" */
/** @import { Driving } from "./driving/driving.js" */
/** @import { Editor } from "./editor/editor.js" */
/** @import { Placed } from "./stage/placed.js" */
/** @import { Shown } from "./lane.js" */

/** Milliseconds into a frame at which inking new growth stops. */
const FRAME = 6;
/** When inking stops where nothing plays and the reader waits for another time. */
const REDRAW = 24;
/** Milliseconds between two reports of the state while it plays. */
const REPORT = 50;
/** Measures kept in the browser's timeline before it is emptied. */
const MEASURES = 20000;

/** Fetched once. */
export const placed = once(() => import("./stage/placed.js"));

export class Session {
  /**
   * @param {Library} library
   * @param {PlannerWorker} planners   the worker
   * @param {() => void} renew   makes a fresh core after the last one was lost
   */
  constructor(library, planners, renew) {
    this.library = library;
    this.planners = planners;
    this.renew = renew;
    /** Hears what is to be told of each frame. @type {(state: State) => void} */
    this.tell = () => {};
    /** Hears that what was told at rest no longer holds. */
    this.onDirty = () => {};
    this.stage = new Stage((painting) => this.paint(painting), () => this.wake());
    this.clock = new Clock();
    this.timeline = new Timeline(this);
    this.byHand = new PoseByHand(this);
    /** @type {Shown | null} */
    this.shown = null;
    /** @type {Lane[]} */
    this.lanes = [];
    /** @type {string | undefined} */
    this.query = undefined;
    /** @type {ViewOptions} */
    this.view = { axes: [0, 1], refused: false, strobe: true, poses: 8, raw: false, slice: false };
    /** What the scene says of its own planner. */
    this.story = { algorithm: "", isProven: true, sentence: "" };
    /** Why the core would not plan, if so, and for which lane. @type {{ error: unknown, lane: number } | null} */
    this.refusal = null;
    /** All that was asked for is made and drawn. */
    this.settled = false;
    /** Something was asked for that no frame has shown yet. */
    this.isStale = false;
    /** When the state was last reported, on the clock of frames. */
    this.reported = -Infinity;
    /** Once it was asked for. @type {Editor | null} */
    this.editor = null;
    /** Once it was asked for. @type {Driving | null} */
    this.driving = null;
    this.last = 0;
    this.scheduled = false;
    this.measures = 0;
    /** How often there were new runs. */
    this.plannings = 0;
  }

  /** What bodies and cars need besides, fetched with the first of them. @param {Scenario} scenario @returns {Promise<Placed | null>} */
  async placedOf(scenario) {
    const { robot } = scenario.document();
    if (robot.type !== "rigid_body" && robot.type !== "car") return null;
    const { Placed } = await placed();
    return new Placed(robot);
  }

  /** Puts a scenario on the stage; the one before it is freed. @param {Scenario} scenario @param {Programme} programme @param {Placed | null} placed @returns {SceneFacts} */
  open(scenario, programme, placed) {
    if (Boolean(placed) !== Boolean(this.shown?.placed) || this.view.axes.some((axis) => axis >= scenario.dimension)) this.view.axes = axesOf(scenario.robot);
    this.clear();
    const document = scenario.document();
    this.shown = { scenario, document, query: undefined, start: null, goal: null, target: null, goals: [], hand: null, check: null, hover: null, view: this.view, rough: false, overlay: null, marked: null, placed, driven: null };
    this.story = programme.story;
    if (programme.pace !== undefined) this.clock.pace = programme.pace;
    this.query = document.queries.find(({ name }) => name === programme.query)?.name ?? document.queries[0]?.name;
    this.stage.invalidate();
    this.editor?.begin();
    this.plan(programme.plans, programme.play && !this.editor?.on);
    if (programme.iteration !== undefined && programme.iteration > 0) this.timeline.seek(programme.iteration);
    return this.facts();
  }

  /** @param {Source} source */
  read(source) {
    const { Scenario } = this.library;
    return "generate" in source ? Scenario.generate(source.generate.kind, source.generate.options) : Scenario.parse(/** @type {ScenarioDocument} */ (source.document));
  }

  /** What there is to know of the scenario on the stage. @returns {SceneFacts} */
  facts() {
    const { scenario, document, start, goal } = /** @type {Shown} */ (this.shown);
    return {
      name: scenario.name, title: scenario.title || scenario.name, robot: scenario.robot, dimension: scenario.dimension,
      queries: document.queries.map(({ name }) => name), query: this.query, coordinates: coordinatesOf({ scenario, document }),
      start: start ? Array.from(start) : null, goal: goal ? Array.from(goal) : null, document,
    };
  }

  /**
   * Another world or query under the same plans, which wait at iteration 0.
   * @param {Scenario} scenario @param {ScenarioDocument} document @param {boolean} live  it is being changed by hand
   */
  replace(scenario, document, live) {
    const { shown, lanes } = this;
    if (!shown) return;
    for (const lane of lanes) lane.free();
    shown.scenario.free();
    this.shown = { ...shown, scenario, document, hover: null, rough: live, marked: null };
    this.plan(lanes.map(({ plan }) => plan), false);
    if (!live) this.stage.invalidate();
  }

  /**
   * Configurations of the reader's own, to be seen until the scene is another; none: those before are taken away.
   * @param {Float64Array | null} rows  of `dimension` finite numbers
   * @returns {number} how many of them are free
   */
  mark(rows) {
    const { shown } = this;
    if (!shown) return 0;
    const { scenario } = shown;
    const n = scenario.dimension;
    const free = rows && Uint8Array.from({ length: rows.length / n }, (_, i) => Number(scenario.check(rows.subarray(n * i, n * i + n)).free));
    shown.marked = rows && free && { rows, free };
    this.markDirty();
    this.stage.invalidate();
    return free ? free.reduce((sum, one) => sum + one, 0) : 0;
  }

  /** Another query of the scenario. @param {string} query @param {boolean} play */
  ask(query, play) {
    this.query = query;
    this.plan(this.lanes.map(({ plan }) => plan), play);
    this.stage.invalidate();
  }

  /** New runs from what is asked of each planner. @param {Plan[]} plans @param {boolean} play */
  plan(plans, play) {
    const { shown, clock } = this;
    if (!shown) return;
    const query = shown.document.queries.find(({ name }) => name === this.query);
    shown.query = query?.name;
    shown.start = query?.start ?? null;
    shown.goal = query?.goal ?? null;
    shown.target = query?.target ?? null;
    shown.goals = shown.goal ? [shown.goal] : [];
    this.plannings++;
    this.byHand.release();
    clock.reset();
    clock.isRace = plans.length > 1;
    this.refusal = null;
    this.markDirty();
    plans.forEach((plan, i) => {
      if (this.lanes[i]?.shown === shown) this.lanes[i].plan = plan;
      else (this.lanes[i] = new Lane(shown, plan));
    });
    for (const lane of this.lanes.splice(plans.length)) lane.free();
    for (const lane of this.lanes) lane.free();
    let at = 0;
    try {
      for (; at < this.lanes.length; at++) this.lanes[at].start(this.query, this.library);
      clock.playing = play;
    } catch (error) {
      for (const lane of this.lanes) lane.free();
      this.refusal = { error, lane: at };
      if (!this.editor?.on) this.byHand.showTouching();
    }
    const { run } = this.lanes[0] ?? {};
    if (shown.target) {
      // A seed of its own may find other poses that reach the target.
      shown.goals = run ? run.goals : [];
      this.stage.invalidate();
    }
    this.stage.restart(this.lanes);
    this.wake();
  }

  clear() {
    for (const lane of this.lanes.splice(0)) lane.free();
    this.shown?.scenario.free();
    this.shown = null;
  }

  /** What was told at rest no longer holds. */
  markDirty() {
    this.settled = false;
    this.isStale = true;
    this.onDirty();
    this.wake();
  }

  /** A pointer on a pane: the editor's while it is on. @param {Pointer} pointer */
  async pointer(pointer) {
    await this.byHand.ready();
    if (this.editor?.on) this.editor.hand.obey(pointer);
    else this.byHand.point(pointer);
    this.wake();
  }

  /** Does any planner go on? */
  get growing() { return this.lanes.some(({ run }) => run && run.status === "running"); }

  /** Is there a way to follow? */
  get travelling() { return !this.growing && this.playbacks.length > 0; }

  /** The ways that are known: those of a race are followed in step. */
  get playbacks() { return this.lanes.flatMap(({ playback }) => playback ?? []); }

  reset() {
    this.plan(this.lanes.map(({ plan }) => plan), false);
  }

  /** @param {number} pace  iterations a second */
  setPace(pace) { this.clock.pace = pace; }

  /** What is to be seen. @param {Partial<ViewOptions>} view */
  setView(view) {
    Object.assign(this.view, view);
    this.markDirty();
    // Poses and the path as found are on the top, which is drawn anew each frame.
    if ("axes" in view || "refused" in view) this.stage.invalidate();
  }

  // One frame at a time.

  wake() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => {
      this.scheduled = false;
      this.frame(now);
    });
  }

  /** @param {number} now */
  frame(now) {
    if (!this.shown) return;
    try {
      this.perform(now);
    } catch (error) {
      const { code } = faultOf(error);
      if (code === "") throw error;
      this.fail(error);
    }
  }

  /** The planner cannot go on, or the core was lost. @param {unknown} error */
  fail(error) {
    if (faultOf(error).code === "internal") {
      this.recover();
      return;
    }
    this.clock.halt();
    this.refusal = { error, lane: 0 };
    this.tell(report(this));
  }

  /**
   * The core has stopped on a fault of its own, and all that it held is lost: a fresh one begins the same runs again, and the
   * page says so.
   */
  recover() {
    const { shown } = this;
    if (!shown) return;
    const plans = this.lanes.map(({ plan }) => plan);
    this.renew();
    this.shown = { ...shown, scenario: this.library.Scenario.parse(shown.document), hand: null, check: null, hover: null };
    this.lanes = [];
    this.plan(plans, false);
    const error = Object.assign(new Error("Planarium's core stopped because of an internal error. It was restarted, and the run starts again."), { code: "internal" });
    this.refusal ??= { error, lane: 0 };
  }

  /** Has the worker paint obstacles. @param {Painting} painting @returns {Promise<ImageBitmap | null>} null: it could not */
  async paint(painting) {
    try {
      return await this.planners.obstacles(painting);
    } catch (error) {
      this.fail(error);
      return null;
    } finally {
      this.wake();
    }
  }

  /** @param {number} now */
  perform(now) {
    const { shown } = this;
    if (!shown) return;
    const began = performance.now();
    this.editor?.hand.pass();
    this.editor?.overlay();
    this.driving?.pass(performance.timeOrigin + now);
    const elapsed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const { stage, clock } = this;
    const moved = this.timeline.pass(elapsed);
    const working = moved || !stage.caughtUp;
    if (moved) this.settled = false;
    this.byHand.hover(shown);
    for (const { run } of this.lanes) run?.frontier.follow();
    for (const lane of this.lanes) lane.still = !clock.playing && !clock.owes && lane.run?.status === "running";
    stage.frame(this.lanes, now, began + (clock.playing ? FRAME : REDRAW), clock.playing);
    const resting = !clock.owes && !this.timeline.isAsking && (!clock.playing || !this.growing);
    if (resting) this.timeline.conclude();
    this.settled = !this.timeline.isAsking && resting && !this.driving?.moves && stage.caughtUp && (clock.playing || shown.hand !== null || stage.isRefined);
    if (working) this.measure(began);
    // Style, layout and paint of the document take longer than the drawing: while it plays, texts change less often than pictures.
    if (!clock.playing || this.isStale || this.settled || now - this.reported >= REPORT) {
      this.isStale = false;
      this.reported = now;
      this.tell(report(this));
    }
    if (clock.playing || clock.owes || stage.busy || this.driving?.moves) this.wake();
  }

  /** Differs where the curves do. */
  get curvesKey() { return `${this.plannings} ${this.clock.head} ${this.lanes.map(({ run }) => run?.ended)}`; }

  /** How each run went, in few points. @returns {Curves} */
  curves() {
    const { clock: { head, isRace, column }, curvesKey: key } = this;
    return { key, head, isRace, lanes: thinned(this.lanes.flatMap(({ run }) => run ?? []), column, head) };
  }

  /** Leaves the frame's own work in the browser's timeline. @param {number} began */
  measure(began) {
    if (++this.measures % MEASURES === 0) performance.clearMeasures("planarium-frame");
    performance.measure("planarium-frame", { start: began, end: performance.now() });
  }

  /** The sentence above the stage, and whether it is bad news. @returns {[string, boolean]} */
  get sentence() {
    const { shown, byHand: { game } } = this;
    if (!shown) return ["", false];
    const { editor, driving } = this;
    if (driving?.on) return [driving.sentence, driving.state?.blocked !== null];
    if (editor?.sentence && !shown.hand) return [editor.sentence, editor.isBad];
    if (shown.hand && shown.check) {
      if (!shown.check.free) return [story.poseSentence(shown.scenario, shown.check), false];
      return [game.arrived ? story.arrival(game.touches) : story.invitation(shown.scenario, this.panesOf("cspace") > 0), false];
    }
    const { run, playback } = this.lanes[0];
    if (!run) return [`${shown.scenario.title || shown.scenario.name}.`, false];
    if (this.clock.isRace) return [story.race(this.lanes), false];
    if (run.status === "running") return [story.going(run, this.story), false];
    return [story.ending(run, playback), Boolean(playback?.flaw)];
  }

  /** @param {string} kind */
  panesOf(kind) { return [...this.stage.places.values()].filter((place) => place.kind === kind).length; }
}
