/**
 * What goes on: which scenario is on the stage, which run grows, whether it plays, whether the robot follows the path or
 * is in the reader's hand. One frame at a time: a bounded slice of planning, then a bounded slice of drawing.
 */
import { journeyOf } from "./animate.js";
import { Run } from "./run.js";
import * as story from "./story.js";

/** @import { Journey } from "./animate.js" */
/** @import { Configuration, Scenario, Settings } from "./types.js" */
/** @import { Picture } from "./stage/picture.js" */
/** @import { Stage } from "./stage/stage.js" */
/** @import { Transport } from "./transport.js" */
/** @import { Counters } from "./counters.js" */
/** @import { Panel } from "./panel.js" */
/** @import { Pose } from "./pose.js" */
/** @import { Notice } from "./notice.js" */
/** @import { Announcer } from "./announce.js" */

/** Milliseconds of planning in a frame at most, and when inking new growth stops. */
const PLANNING = 4.5;
const FRAME = 6;
/** Measures kept in the browser's timeline before it is emptied. */
const MEASURES = 20000;

/**
 * @typedef {object} Crew   those who show what goes on
 * @property {Stage} stage
 * @property {Transport} transport
 * @property {Counters} counters
 * @property {Panel} panel
 * @property {Pose} pose
 * @property {Notice} notice
 * @property {Announcer} announcer
 * @property {(sentence: string, isBad?: boolean) => void} tell     the sentence above the stage
 * @property {(inHand: boolean) => void} turn      whose turn it is
 * @property {(run: Run, journey: Journey | null) => void} legend   what is to be seen
 *
 * @typedef {object} Programme   how a scenario is put on the stage
 * @property {string} algorithm
 * @property {Settings} settings
 * @property {number} pace
 * @property {string} story
 */

export class Theatre {
  /** @param {Crew} crew @param {boolean} calm  less motion is asked for */
  constructor(crew, calm) {
    this.crew = crew;
    this.calm = calm;
    /** @type {Picture | null} */
    this.picture = null;
    /** What the scene says of its own planner. */
    this.story = { algorithm: "", sentence: "" };
    /** The phase that the sentence above the stage is about. */
    this.phase = "";
    this.playing = false;
    /** Iterations asked for and not made yet. */
    this.owed = 0;
    /** As fast as it goes, whatever the slider says. */
    this.rushing = false;
    this.settled = false;
    this.touches = 0;
    this.arrived = false;
    this.last = 0;
    this.scheduled = false;
    this.measures = 0;
    this.described = 0;
    crew.stage.setGlow(!calm);
  }

  /** Puts a scenario on the stage; the one before it is freed. @param {Scenario} scenario @param {Programme} programme */
  open(scenario, programme) {
    const { stage, panel, pose, transport, notice } = this.crew;
    this.picture?.run?.free();
    this.picture?.scenario.free();
    notice.hide();
    const document = scenario.document();
    this.picture = { scenario, document, start: null, goal: null, run: null, journey: null, hand: null, check: null };
    this.story = { algorithm: programme.algorithm, sentence: programme.story };
    panel.offerQueries(document.queries.map(({ name }) => name));
    panel.suggest(programme.algorithm, programme.settings);
    transport.pace = programme.pace;
    this.ask();
    stage.show(this.picture);
    pose.build(this.picture);
    this.restart(!this.calm);
  }

  /** Takes start and goal from the query that is chosen. */
  ask() {
    const picture = this.picture;
    if (!picture) return;
    const query = picture.document.queries.find(({ name }) => name === this.crew.panel.query.value);
    picture.start = query?.start ?? null;
    picture.goal = query?.goal ?? null;
  }

  /** A setting was changed: a new run, unless a field holds a value that is refused. */
  changed() {
    const run = this.picture?.run;
    const query = this.crew.panel.query.value;
    if (!this.crew.panel.settings) return;
    const play = this.playing || (run !== null && run !== undefined && run.status !== "running" && !this.calm);
    const asked = this.picture?.start;
    this.ask();
    if (this.picture && asked !== this.picture.start && query !== "") this.crew.stage.relay();
    this.restart(play);
  }

  /** A new run from the settings. @param {boolean} play */
  restart(play) {
    const { panel, notice, stage, counters, transport } = this.crew;
    const picture = this.picture;
    const settings = panel.settings;
    if (!picture || !settings) return;
    picture.run?.free();
    picture.run = null;
    picture.journey = null;
    this.release();
    this.owed = 0;
    this.rushing = false;
    this.playing = false;
    notice.hide();
    this.stir();
    try {
      picture.run = new Run(picture.scenario, panel.algorithm, settings);
      this.playing = play;
      this.crew.legend(picture.run, null);
      counters.show(picture.run);
      this.tellStory();
    } catch (error) {
      counters.none("none");
      this.refused(error);
    }
    stage.restart();
    this.showTransport();
    transport.showAlong(0);
    this.describe();
    this.wake();
  }

  /** The core would not plan this: says why, and shows a start or goal that touches something. @param {unknown} error */
  refused(error) {
    const { panel, notice, tell } = this.crew;
    const picture = this.picture;
    const pointer = error instanceof Error && "pointer" in error ? String(error.pointer) : "";
    if (!panel.refuse(pointer, error instanceof Error ? error.message : String(error))) notice.show("This cannot be planned.", error);
    tell(picture ? `${picture.scenario.title || picture.scenario.name}.` : "");
    for (const end of [picture?.start, picture?.goal]) {
      if (!picture || !end || end.length !== picture.scenario.dimension) continue;
      if (picture.scenario.check(end).free) continue;
      this.hold(Float64Array.from(end));
      return;
    }
  }

  /** The run moves, or is about to: what was told of it at rest no longer holds. */
  stir() {
    if (this.settled) this.crew.counters.unsettle();
    this.settled = false;
  }

  // The transport.

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    const picture = this.picture;
    if (!picture?.run || (picture.run.status !== "running" && !picture.journey)) return;
    this.release();
    this.tellStory();
    this.playing = true;
    if (picture.run.status === "running") this.stir();
    this.showTransport();
    this.wake();
  }

  pause() {
    this.playing = false;
    this.rushing = false;
    this.owed = 0;
    this.showTransport();
    this.wake();
  }

  /** @param {number} iterations */
  step(iterations) {
    if (this.picture?.run?.status !== "running") return;
    if (this.playing) this.pause();
    this.owed = Math.floor(this.owed) + iterations;
    this.stir();
    this.wake();
  }

  finish() {
    if (this.picture?.run?.status !== "running") return;
    this.release();
    this.rushing = true;
    this.playing = true;
    this.stir();
    this.showTransport();
    this.wake();
  }

  reset() { this.restart(false); }

  /** @param {number} part  0 to 1 along the path */
  seek(part) {
    const journey = this.picture?.journey;
    if (!journey) return;
    this.release();
    this.playing = false;
    journey.seek(part);
    this.crew.pose.show(journey.configuration(part));
    this.showTransport();
    this.wake();
  }

  // The robot in the hand.

  /** The reader's turn, or the planner's again. @param {boolean} byKeyboard  then the focus goes to the first joint */
  takeTurn(byKeyboard) {
    const picture = this.picture;
    if (!picture) return;
    if (picture.hand) {
      this.release();
      this.tellStory();
      this.play();
      this.wake();
      return;
    }
    const { pose } = this.crew;
    const start = picture.start ?? pose.coordinates.map(({ low, high }) => (low + high) / 2);
    this.hold(Float64Array.from(start));
    if (byKeyboard) pose.focus();
  }

  /** The robot is held at a pose. @param {Float64Array} at */
  hold(at) {
    const picture = this.picture;
    if (!picture) return;
    const { stage, pose, tell, announcer, turn } = this.crew;
    if (!picture.hand) {
      this.touches = 0;
      this.arrived = false;
      turn(true);
      if (picture.journey) {
        picture.journey.drawn = 1;
        this.playing = false;
        this.showTransport();
      }
    }
    const wasFree = picture.check?.free ?? true;
    const check = picture.scenario.check(at);
    picture.hand = at;
    picture.check = check;
    pose.show(at);
    const sentence = story.poseSentence(picture.scenario, check);
    pose.tell(sentence, check.free);
    if (wasFree && !check.free) {
      this.touches++;
      announcer.say(sentence);
    }
    if (picture.goal && check.free && !this.arrived && this.isAt(picture.goal, at)) {
      this.arrived = true;
      announcer.say(story.arrival(this.touches));
    }
    if (!check.free) tell(sentence);
    else tell(this.arrived ? story.arrival(this.touches) : story.invitation(picture.scenario, stage.panes.length > 1));
    this.wake();
  }

  /** Is a pose at the goal, as nearly as a hand can put it there? @param {Configuration} goal @param {Float64Array} at */
  isAt(goal, at) {
    const { scenario } = /** @type {Picture} */ (this.picture);
    const { min, max } = scenario.extent();
    const near = scenario.robot === "arm" ? 0.06 * scenario.dimension : 0.015 * Math.max(max[0] - min[0], max[1] - min[1]);
    return scenario.distance(at, goal) <= near;
  }

  /** The robot is nobody's. */
  release() {
    const picture = this.picture;
    if (!picture) return;
    picture.hand = null;
    picture.check = null;
    this.crew.turn(false);
    this.crew.pose.tell("", true);
  }

  // One frame at a time.

  wake() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  /** @param {number} now */
  frame(now) {
    this.scheduled = false;
    const picture = this.picture;
    if (!picture) return;
    const began = performance.now();
    const elapsed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    const { stage, counters } = this.crew;
    const planned = this.plan(picture, elapsed, began + PLANNING);
    const working = planned || !stage.caughtUp;
    if (picture.journey && this.playing) this.travel(picture.journey, elapsed);
    stage.frame(now, began + FRAME);
    const run = picture.run;
    if (run) {
      run.fresh = new Float64Array(0);
      if (planned) {
        this.stir();
        counters.show(run);
      }
      const atRest = this.owed < 1 && (!this.playing || run.status !== "running");
      if (atRest && !this.settled && stage.caughtUp) {
        this.settled = true;
        counters.settle(run);
        this.describe();
      }
    }
    if (working) this.measure(began);
    if (now - this.described > 1000) {
      this.described = now;
      this.describe();
    }
    if (this.playing || this.owed >= 1 || stage.busy) this.wake();
  }

  /** A slice of planning. @param {Picture} picture @param {number} elapsed  seconds @param {number} until @returns {boolean} whether anything was planned */
  plan(picture, elapsed, until) {
    const run = picture.run;
    if (!run || run.status !== "running") return false;
    if (this.playing) {
      const pace = this.rushing ? Infinity : this.crew.transport.pace;
      this.owed = pace === Infinity ? Infinity : Math.min(this.owed === Infinity ? 0 : this.owed + pace * elapsed, pace / 4 + 1);
    }
    if (this.owed < 1 || !this.crew.stage.caughtUp) return false;
    try {
      const made = run.advance(Math.floor(this.owed), until);
      run.fetch();
      if (this.owed !== Infinity) this.owed -= made;
    } catch (error) {
      this.pause();
      this.crew.notice.show("The planner stopped.", error);
      return false;
    }
    if (run.status !== "running") this.ended(picture, run);
    else if (run.planner.phase !== this.phase) this.tellStory();
    return true;
  }

  /** The run has ended. @param {Picture} picture @param {Run} run */
  ended(picture, run) {
    this.owed = 0;
    this.rushing = false;
    picture.journey = journeyOf(picture.scenario, run);
    if (picture.journey) {
      if (this.calm) picture.journey.drawn = 1;
      if (this.calm || picture.hand) this.playing = false;
    } else {
      this.playing = false;
    }
    this.crew.legend(run, picture.journey);
    this.tellStory();
    this.crew.announcer.say(story.ending(run, picture.journey));
    this.showTransport();
  }

  /** The robot follows the path. @param {Journey} journey @param {number} elapsed  seconds */
  travel(journey, elapsed) {
    journey.advance(elapsed);
    this.crew.transport.showAlong(journey.at);
    if (journey.drawn >= 1) this.crew.pose.show(journey.configuration(journey.at));
  }

  /** Leaves the frame's own work in the browser's timeline. @param {number} began */
  measure(began) {
    if (++this.measures % MEASURES === 0) performance.clearMeasures("planarium-frame");
    performance.measure("planarium-frame", { start: began, end: performance.now() });
  }

  showTransport() {
    const run = this.picture?.run ?? null;
    this.crew.transport.show({
      ready: run !== null,
      playing: this.playing,
      growing: run?.status === "running",
      travelling: Boolean(this.picture?.journey),
    });
  }

  tellStory() {
    const picture = this.picture;
    if (!picture || picture.hand) return;
    const { run, journey } = picture;
    this.phase = run?.planner.phase ?? "";
    if (!run) this.crew.tell(this.story.sentence);
    else if (run.status === "running") this.crew.tell(story.going(run, this.story));
    else this.crew.tell(story.ending(run, journey), Boolean(journey?.flaw));
  }

  describe() {
    const picture = this.picture;
    if (picture) this.crew.stage.describe(story.summary(picture.scenario.title || picture.scenario.name, picture.run));
  }
}
