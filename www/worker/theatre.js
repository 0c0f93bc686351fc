/**
 * What goes on: which scenario is on the stage, which planners grow on it, what time it is, whether the robot follows a path
 * or is in the reader's hand. One frame at a time: a bounded slice of planning, then a bounded slice of drawing.
 */
import { faultOf } from "../fault.js";
import { Stage } from "../stage/stage.js";
import { Clock } from "./clock.js";
import { contained, coordinatesOf } from "./coordinates.js";
import { Grip } from "./grip.js";
import { thinned } from "./curve.js";
import { compete } from "./compete.js";
import { Pointing } from "./pointing.js";
import { Lane } from "./lane.js";
import { report } from "./report.js";
import * as story from "./story.js";

/** @import { Curves, Library, Plan, Pointer, Programme, Scenario, ScenarioDocument, SceneFacts, Source, State, ViewOptions } from "../types.js" */
/** @import { Editor } from "./editor.js" */
/** @import { Shown } from "./lane.js" */
/** @import { CSpace } from "../stage/cspace.js" */

/** Milliseconds of planning in a frame at most, and when inking new growth stops. */
const PLANNING = 4.5;
const FRAME = 6;
/** When inking stops where nothing plays and the reader waits for another time. */
const REDRAW = 24;
/** Measures kept in the browser's timeline before it is emptied. */
const MEASURES = 20000;

export class Theatre {
  /**
   * @param {Library} library
   * @param {() => void} renew   makes a fresh core after the last one was lost
   * @param {(state: State) => void} tell   hears what is to be told of each frame
   */
  constructor(library, renew, tell) {
    this.library = library;
    this.renew = renew;
    this.tell = tell;
    this.phases = library.phases;
    this.stage = new Stage();
    this.clock = new Clock();
    this.grip = new Grip();
    this.pointing = new Pointing();
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
    /** How often the hand touched something, and whether it brought the robot to the goal. */
    this.game = { touches: 0, arrived: false };
    /** The number of the newest order obeyed. */
    this.heard = -1;
    /** Once it was asked for. @type {Editor | null} */
    this.editor = null;
    this.last = 0;
    this.scheduled = false;
    this.measures = 0;
    /** How often there were new runs. */
    this.plannings = 0;
  }

  /** Puts a scenario on the stage; the one before it is freed. @param {Source} source @param {Programme} programme @returns {SceneFacts} @throws {Error} it cannot be read */
  open(source, programme) {
    const scenario = this.read(source);
    this.clear();
    const document = scenario.document();
    this.shown = { scenario, document, start: null, goal: null, hand: null, check: null, hover: null, view: this.view, rough: false, overlay: null, marked: null };
    this.story = programme.story;
    if (programme.pace !== undefined) this.clock.pace = programme.pace;
    this.query = document.queries.find(({ name }) => name === programme.query)?.name ?? document.queries[0]?.name;
    this.stage.relay();
    this.editor?.begin();
    this.plan(programme.plans, programme.play && !this.editor?.on);
    if (programme.iteration !== undefined && programme.iteration > 0) this.seek(programme.iteration);
    return this.facts();
  }

  /** @param {Source} source */
  read(source) {
    const { Scenario } = this.library;
    return "generate" in source ? Scenario.generate(source.generate.kind, source.generate.options) : Scenario.parse(source.document);
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
    if (!live) this.stage.relay();
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
    this.stir();
    this.stage.relay();
    return free ? free.reduce((sum, one) => sum + one, 0) : 0;
  }

  /** Another query of the scenario. @param {string} query @param {boolean} play */
  ask(query, play) {
    this.query = query;
    this.plan(this.lanes.map(({ plan }) => plan), play);
    this.stage.relay();
  }

  /** New runs from what is asked of each planner. @param {Plan[]} plans @param {boolean} play */
  plan(plans, play) {
    const { shown, clock } = this;
    if (!shown) return;
    const query = shown.document.queries.find(({ name }) => name === this.query);
    shown.start = query?.start ?? null;
    shown.goal = query?.goal ?? null;
    this.plannings++;
    this.release();
    clock.reset();
    clock.isRace = plans.length > 1;
    this.refusal = null;
    this.stir();
    plans.forEach((plan, i) => {
      if (this.lanes[i]?.shown === shown) this.lanes[i].plan = plan;
      else (this.lanes[i] = new Lane(shown, plan));
    });
    for (const lane of this.lanes.splice(plans.length)) lane.free();
    for (const lane of this.lanes) lane.free();
    let at = 0;
    try {
      for (; at < this.lanes.length; at++) this.lanes[at].start(this.query, this.phases);
      clock.playing = play;
    } catch (error) {
      for (const lane of this.lanes) lane.free();
      this.refusal = { error, lane: at };
      if (!this.editor?.on) this.showTouching();
    }
    this.stage.restart(this.lanes);
    this.wake();
  }

  /** A start or goal that touches something is shown as the robot in the hand. */
  showTouching() {
    const { shown } = this;
    if (!shown) return;
    for (const end of [shown.start, shown.goal]) {
      if (!end || end.length !== shown.scenario.dimension || shown.scenario.check(end).free) continue;
      this.hold(Float64Array.from(end));
      return;
    }
  }

  clear() {
    for (const lane of this.lanes.splice(0)) lane.free();
    this.shown?.scenario.free();
    this.shown = null;
  }

  /** What was told at rest no longer holds. */
  stir() { this.settled = false; }

  // The transport.

  /** Does any planner go on? */
  get growing() { return this.lanes.some(({ run }) => run && run.status === "running"); }

  /** Is there a way to follow? */
  get travelling() { return !this.growing && this.journeys.length > 0; }

  /** The ways that are known: those of a race are followed in step. */
  get journeys() { return this.lanes.flatMap(({ journey }) => journey ?? []); }

  toggle() {
    if (this.clock.playing) this.pause();
    else this.play();
  }

  play() {
    if (!this.growing && !this.travelling) {
      // At its end, and nothing drives: it is watched again from the beginning.
      if (this.clock.head === 0) return;
      this.showTime(0);
      this.clock.halt();
    }
    this.release();
    this.clock.playing = true;
    if (this.growing) this.stir();
    this.wake();
  }

  pause() {
    this.clock.halt();
    this.wake();
  }

  /** @param {number} steps  below 0: back */
  step(steps) {
    const { clock } = this;
    const from = clock.playing || clock.wanted === Infinity ? clock.now : clock.wanted;
    this.seek(from + steps * clock.unit);
  }

  /** Shows a time: what the log has at once, what it has not after planning. @param {number} time */
  seek(time) {
    if (!this.shown) return;
    this.release();
    const { clock } = this;
    clock.seek(time);
    if (clock.wanted < clock.now) this.showTime(clock.wanted);
    this.stir();
    this.wake();
  }

  /** Runs on as fast as it goes. */
  finish() {
    if (!this.growing) return;
    this.release();
    this.clock.rushing = true;
    this.clock.playing = true;
    this.stir();
    this.wake();
  }

  reset() {
    this.plan(this.lanes.map(({ plan }) => plan), false);
  }

  /** @param {number} pace  iterations a second */
  setPace(pace) { this.clock.pace = pace; }

  /** Puts the robot somewhere along its way. @param {number} part  0 to 1 */
  along(part) {
    if (!this.travelling) return;
    this.release();
    this.clock.playing = false;
    for (const journey of this.journeys) journey.seek(part);
    this.wake();
  }

  // The robot in the hand.

  /** The reader's turn, or the planner's again. */
  turn() {
    const { shown } = this;
    if (!shown) return;
    if (shown.hand) {
      this.release();
      this.play();
      this.wake();
      return;
    }
    this.hold(Float64Array.from(shown.start ?? coordinatesOf(shown).map(({ low, high }) => (low + high) / 2)));
  }

  /** The robot is held at a pose. @param {Float64Array} pose */
  hold(pose) {
    const { shown } = this;
    if (!shown || pose.length !== shown.scenario.dimension) return;
    if (!shown.hand) {
      this.game = { touches: 0, arrived: false };
      for (const { journey } of this.lanes) {
        if (!journey) continue;
        journey.drawn = 1;
        this.clock.halt();
      }
    }
    contained(pose, coordinatesOf(shown));
    const wasFree = shown.check?.free ?? true;
    shown.hand = pose;
    shown.check = shown.scenario.check(pose);
    if (wasFree && !shown.check.free) this.game.touches++;
    if (shown.check.free && shown.goal && this.isAt(shown.goal, pose)) this.game.arrived = true;
    this.wake();
  }

  /** Is a pose at the goal, as nearly as a hand can put it there? @param {ArrayLike<number>} goal @param {Float64Array} pose */
  isAt(goal, pose) {
    const { scenario } = /** @type {Shown} */ (this.shown);
    const { min, max } = scenario.extent();
    const near = scenario.robot === "arm" ? 0.06 * scenario.dimension : 0.015 * Math.max(max[0] - min[0], max[1] - min[1]);
    return scenario.distance(pose, Float64Array.from(goal)) <= near;
  }

  /** The robot is nobody's. */
  release() {
    if (!this.shown) return;
    this.shown.hand = null;
    this.shown.check = null;
  }

  /** A pointer on a pane, pixels of the pane. @param {Pointer} pointer @returns {boolean} whether it holds something */
  pointer(pointer) {
    if (this.editor?.on) return this.editor.pointer(pointer);
    const { pane: id, type, x, y } = pointer;
    const place = this.stage.at(id);
    if (!place || !this.shown) return false;
    const { pane, kind } = place;
    this.pointing.at = type === "hover" ? { place, x, y } : null;
    if (type !== "down" && type !== "move") return false;
    const pose = kind === "cspace"
      ? this.grip.square(/** @type {CSpace} */ (pane), x, y)
      : type === "down" ? this.grip.take(pane, x, y) : this.grip.drag(pane, x, y);
    if (pose) this.hold(pose);
    return pose !== null;
  }

  /** What is to be seen. @param {Partial<ViewOptions>} view */
  setView(view) {
    Object.assign(this.view, view);
    this.stir();
    // Poses and the path as found are on the top, which is drawn anew each frame.
    if ("axes" in view || "refused" in view) this.stage.relay();
    this.wake();
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
      if (code === "internal") this.recover();
      else this.stop(error);
    }
  }

  /** The planner cannot go on. @param {unknown} error */
  stop(error) {
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
    const error = Object.assign(new Error("Planarium's core stopped on a fault of its own. A fresh one has taken its place, and the run begins again."), { code: "internal" });
    this.refusal ??= { error, lane: 0 };
  }

  /** @param {number} now */
  perform(now) {
    const { shown } = this;
    if (!shown) return;
    const began = performance.now();
    this.editor?.hand.pass();
    this.editor?.overlay();
    const elapsed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const { stage, clock } = this;
    const moved = this.pass(elapsed, began + PLANNING);
    const working = moved || !stage.caughtUp;
    if (moved) this.stir();
    if (clock.playing && !this.growing) this.travel(elapsed);
    shown.hover = shown.hand || this.editor?.on ? null : this.pointing.find(this.lanes, this.grip, shown.hover);
    for (const { run } of this.lanes) run?.frontier.follow();
    for (const lane of this.lanes) lane.still = !clock.playing && !clock.owes && lane.run?.status === "running";
    stage.frame(this.lanes, now, began + (clock.playing ? FRAME : REDRAW));
    const resting = !clock.owes && (!clock.playing || !this.growing);
    this.settled = resting && stage.caughtUp && (clock.playing || shown.hand !== null || stage.isTended);
    if (working) this.measure(began);
    this.tell(report(this));
    if (clock.playing || clock.owes || stage.busy) this.wake();
  }

  /** Time goes on: what the log has is replayed, what it has not is planned. @param {number} elapsed  seconds @param {number} until @returns {boolean} whether anything changed */
  pass(elapsed, until) {
    const { clock, lanes } = this;
    if (this.growing) clock.pass(elapsed);
    if (!clock.owes) return false;
    // What is not inked yet is inked first.
    if (!this.stage.caughtUp) return false;
    if (!this.growing) {
      clock.wanted = clock.now;
      clock.rushing = false;
      return false;
    }
    const before = clock.now;
    const wanted = Math.floor(clock.wanted);
    const runs = lanes.flatMap(({ run }) => run ?? []);
    const there = clock.isRace ? compete(runs, clock.column, wanted, until) : runs[0].advance(clock.column, wanted, until);
    this.showTime(there ? wanted : Math.min(wanted, this.reached()));
    if (!this.growing) {
      clock.wanted = clock.now;
      clock.rushing = false;
    }
    return clock.now !== before;
  }

  /** The time that all planners have come to: those that have ended hold nobody up. */
  reached() {
    return Math.min(...this.lanes.map(({ run }) => run?.reached(this.clock.column) ?? Infinity));
  }

  /** The latest time at which it is known how all stand. */
  get limit() {
    const reached = this.reached();
    return reached < Infinity ? reached : Math.max(0, ...this.lanes.map(({ run }) => run?.clock(this.clock.column) ?? 0));
  }

  /** Differs where the curves do. */
  get curvesKey() { return `${this.plannings} ${this.clock.head} ${this.lanes.map(({ run }) => run?.ended)}`; }

  /** How each run went, in few points. @returns {Curves} */
  curves() {
    const { clock: { head, isRace, column }, curvesKey: key } = this;
    return { key, head, isRace, lanes: thinned(this.lanes.flatMap(({ run }) => run ?? []), column, head) };
  }

  /** The robots drive on, all at the same part of their ways. @param {number} elapsed  seconds */
  travel(elapsed) {
    const [lead, ...others] = this.journeys;
    lead?.advance(elapsed);
    for (const journey of others) Object.assign(journey, { drawn: lead.drawn, at: lead.at });
  }

  /** @param {number} time */
  showTime(time) {
    const { clock, lanes } = this;
    clock.now = Math.min(time, this.limit);
    clock.head = Math.max(clock.head, clock.now);
    for (const lane of lanes) {
      if (!lane.run) continue;
      lane.run.shown = lane.run.iterationAt(clock.column, clock.now);
      // A path draws itself only before someone who watches it grow, and wants to see it move.
      if (lane.arrive() && lane.end && (this.stage.look?.calm || !clock.playing || lanes.length > 1)) lane.end.drawn = 1;
    }
    if (!this.growing && (this.stage.look?.calm || !this.travelling)) clock.playing = false;
  }

  /** Leaves the frame's own work in the browser's timeline. @param {number} began */
  measure(began) {
    if (++this.measures % MEASURES === 0) performance.clearMeasures("planarium-frame");
    performance.measure("planarium-frame", { start: began, end: performance.now() });
  }

  /** The sentence above the stage, and whether it is bad news. @returns {[string, boolean]} */
  get sentence() {
    const { shown, game } = this;
    if (!shown) return ["", false];
    const { editor } = this;
    if (editor?.sentence && !shown.hand) return [editor.sentence, editor.isBad];
    if (shown.hand && shown.check) {
      if (!shown.check.free) return [story.poseSentence(shown.scenario, shown.check), false];
      return [game.arrived ? story.arrival(game.touches) : story.invitation(shown.scenario, this.panesOf("cspace") > 0), false];
    }
    const { run, journey } = this.lanes[0];
    if (!run) return [`${shown.scenario.title || shown.scenario.name}.`, false];
    if (this.clock.isRace) return [story.race(this.lanes), false];
    if (run.status === "running") return [story.going(run, this.story), false];
    return [story.ending(run, journey), Boolean(journey?.flaw)];
  }

  /** @param {string} kind */
  panesOf(kind) { return [...this.stage.places.values()].filter((place) => place.kind === kind).length; }
}
