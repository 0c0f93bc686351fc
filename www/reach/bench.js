/**
 * What is on the bench: the arm, what the stage is for, the two poses to go between, the target. Whoever changes something says
 * so; whoever shows something listens. Nobody here knows of the document.
 */
import { Arm } from "./arm.js";
import { Way } from "./way.js";

/** @import { Room } from "../room/room.js" */
/** @import { Library } from "../domain/types.js" */
/** @import { Mode, Point, SceneEntry, ScenarioDocument } from "./types.js" */
/** @import { Round } from "./way.js" */

/**
 * What the last wish for the tip came to.
 * @typedef {object} Pull
 * @property {Point} wanted
 * @property {Point} point      the tip's place that is nearest to it, as far as the arm could find
 * @property {number} distance  between them, metres
 * @property {boolean} reached
 * @property {boolean} isStuck   another pose would come nearer
 */

/** What has changed: the arm itself, its pose, or anything else. @typedef {"arm" | "pose" | "rest"} Change */

export class Bench {
  /** @param {Room} room @param {Library} library */
  constructor(room, library) {
    this.room = room;
    this.library = library;
    /** @type {Arm | null} */
    this.now = null;
    /** The page's own scene, if it is one. @type {SceneEntry | null} */
    this.entry = null;
    /** @type {Mode} */
    this.mode = "hand";
    /** The poses to go between. @type {Float64Array} */
    this.a = new Float64Array();
    /** @type {Float64Array} */
    this.b = new Float64Array();
    /** Which way round each joint goes. @type {Round[]} */
    this.rounds = [];
    /** How much of the way is behind, 0 to 1. */
    this.along = 0;
    /** The direction that the last link keeps, radians; null: any. @type {number | null} */
    this.lock = null;
    /** Of inverse kinematics. @type {Point} */
    this.target = [0, 0];
    /** @type {Pull | null} */
    this.pull = null;
    /** @type {Way | null} */
    this.known = null;
    /** @type {((change: Change) => void)[]} */
    this.listeners = [];
  }

  /** The arm; there is one once the page is open. @returns {Arm} */
  get arm() {
    if (!this.now) throw new Error("There is no arm yet.");
    return this.now;
  }

  /** Calls back after each change. @param {(change: Change) => void} then */
  onChange(then) { this.listeners.push(then); }

  /** @param {Change} change */
  tell(change) {
    for (const then of this.listeners) then(change);
    this.room.wake();
  }

  /** One of the page's own scenes. @param {SceneEntry} entry */
  openEntry(entry) {
    this.put(documentOf(entry), entry.q, entry);
    Object.assign(this, { a: Float64Array.from(entry.a), b: Float64Array.from(entry.b), target: entry.target });
    this.renew();
    this.tell("arm");
  }

  /** A scenario of the reader's own, with an arm. @param {ScenarioDocument | string} document @throws {Error} the core refuses it */
  openDocument(document) {
    this.put(document, [], null);
    const { arm } = this;
    const middle = arm.joints.map(({ low, high }) => (low + high) / 2);
    const [{ start = middle, goal, target } = { start: middle }] = /** @type {Partial<import("planarium").Query>[]} */ (arm.document.queries);
    arm.turn(start);
    this.a = Float64Array.from(arm.q);
    this.target = target?.point ?? (goal ? arm.scenario.endEffector(goal) : [arm.base[0] + 0.6 * arm.reach, arm.base[1] + 0.2 * arm.reach]);
    this.b = arm.fitted(goal ?? arm.scenario.nearestReachable(this.target, target?.orientation).configuration);
    this.renew();
    if (arm.dimension > 2) this.lock = target?.orientation ?? null;
    this.tell("arm");
  }

  /** Another arm in the same world; the poses stay as far as it has the joints. @param {ScenarioDocument} document @throws {Error} the core refuses it: what was there stays */
  change(document) {
    const { arm, a, b } = this;
    this.put({ ...document, queries: [] }, arm.q, this.entry);
    this.a = this.arm.fitted(a);
    this.b = this.arm.fitted(b);
    this.rounds = this.arm.joints.map((_, i) => this.rounds[i] ?? "short");
    this.pull = null;
    this.tell("arm");
  }

  /** @param {ScenarioDocument | string} document @param {ArrayLike<number>} q @param {SceneEntry | null} entry */
  put(document, q, entry) {
    const arm = new Arm(this.library, document, q);
    this.now?.free();
    this.now = arm;
    this.entry = entry;
    if (arm.dimension < 3) this.lock = null;
  }

  /** What another scene begins with. */
  renew() {
    this.rounds = this.arm.joints.map(() => "short");
    this.along = 0;
    this.lock = null;
    this.pull = null;
  }

  /** The arm takes a pose. @param {ArrayLike<number>} q @param {Pull | null} [pull]  the wish that it comes from */
  pose(q, pull = null) {
    this.arm.turn(q);
    this.pull = pull;
    this.tell("pose");
  }

  /** @param {Mode} mode */
  turnTo(mode) {
    this.mode = mode;
    this.pull = null;
    if (mode === "between") this.goTo(0);
    this.tell("rest");
  }

  /** The way from A to B, as it is asked for now. @returns {Way} */
  get way() {
    const { arm, a, b, rounds, known } = this;
    const key = rounds.join();
    if (known?.version === arm.version && this.knownKey === key && same(known.a, a) && same(known.b, b)) return known;
    this.knownKey = key;
    this.known = new Way(arm, a, b, rounds);
    return this.known;
  }

  knownKey = "";

  /** Goes to a part of the way, 0 to 1. @param {number} along */
  goTo(along) {
    this.along = Math.min(1, Math.max(0, along));
    this.pose(this.way.at(this.along));
  }
}

/** @param {SceneEntry} entry @returns {ScenarioDocument} */
export function documentOf({ id, title, obstacles, robot, a, b }) {
  return { format: "planarium-scenario-1", name: id, title, world: { obstacles }, robot: { type: "arm", ...robot }, queries: [{ name: "a-to-b", start: a, goal: b }] };
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function same(a, b) { return a.length === b.length && Array.from(a).every((value, i) => value === b[i]); }
