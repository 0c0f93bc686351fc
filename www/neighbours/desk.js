/**
 * What lies on the desk: a robot, a list of its configurations, a target, and the question that is asked. Whoever changes
 * something says so; whoever shows something listens. Lists and answers come from the worker; only the newest question counts.
 */
import { contained, coordinatesOf, wrap } from "../domain/coordinates.js";

/** @import { Asker } from "../room/ask.js" */
/** @import { Room } from "../room/room.js" */
/** @import { Coordinate, Library, Part, Scenario } from "../domain/types.js" */
/** @import { Draw, Found, IndexId, List, RobotEntry, Settings } from "./types.js" */
/** @import { Commands } from "./worker.js" */

/** What has changed: the robot, the list, the question, or the answer. @typedef {"robot" | "list" | "question" | "answer"} Change */

/** Robots drawn at most: more of them are one dark cloud. */
export const DRAWN = 400;

/** @type {Found} */
const NOTHING = { indices: new Uint32Array(), distances: new Float64Array(), visited: 0 };

export class Desk {
  /** @param {Room} room @param {Library} library @param {Asker<Commands>} asker @param {RobotEntry} entry */
  constructor(room, library, asker, entry) {
    this.room = room;
    this.library = library;
    this.asker = asker;
    this.entry = entry;
    /** @type {Scenario} */
    this.scenario = library.Scenario.parse(entry.document);
    /** @type {Coordinate[]} */
    this.coordinates = [];
    /** Where the list comes from: drawn, or a file by its name. @type {Draw | string} */
    this.source = { n: 500, seed: 0, free: true };
    /** What is drawn where there is no file. @type {Draw} */
    this.draw = this.source;
    /** @type {List} */
    this.list = { version: 0, rows: new Float64Array(), tips: new Float64Array() };
    /** The parts of the first robots of the list. @type {Part[][]} */
    this.poses = [];
    /** @type {Float64Array} */
    this.q = new Float64Array();
    this.k = entry.k;
    /** @type {IndexId} */
    this.index = "kd-tree";
    /** @type {Settings} */
    this.given = {};
    /** What the index has found, and what is nearest by the metric that is meant. */
    this.found = NOTHING;
    this.exact = NOTHING;
    this.isAsking = false;
    this.isStale = false;
    /** Lists asked for: only the newest is taken. */
    this.orders = 0;
    /** @type {((change: Change) => void)[]} */
    this.listeners = [];
  }

  get document() { return this.entry.document; }
  get dimension() { return this.coordinates.length; }
  get count() { return this.dimension === 0 ? 0 : this.list.rows.length / this.dimension; }
  get isArm() { return this.document.robot.type === "arm"; }
  get isNaive() { return this.given.metric === "naive"; }

  /** A configuration of the list. @param {number} i */
  row(i) { return this.list.rows.subarray(i * this.dimension, (i + 1) * this.dimension); }

  /** Those that belong to the answer, and were not found. @returns {number[]} */
  get missed() { return [...this.exact.indices].filter((i) => !this.found.indices.includes(i)); }

  /** @param {(change: Change) => void} then */
  onChange(then) { this.listeners.push(then); }

  /** @param {Change} change */
  tell(change) {
    for (const then of this.listeners) then(change);
    this.room.wake();
  }

  /** Another robot, with a list of its own. @param {RobotEntry} entry @param {{ q?: number[], k?: number }} [asked] @returns {Promise<void>} */
  open(entry, { q = entry.q, k = entry.k } = {}) {
    const scenario = this.library.Scenario.parse(entry.document);
    this.scenario.free();
    this.scenario = scenario;
    this.entry = entry;
    this.coordinates = coordinatesOf({ scenario, document: entry.document });
    this.list = { version: -1, rows: new Float64Array(), tips: new Float64Array() };
    this.poses = [];
    this.found = this.exact = NOTHING;
    this.k = k;
    if (!this.isArm) delete this.given.metric;
    this.place(q);
    this.tell("robot");
    return this.fill();
  }

  /** The list is drawn anew. @param {Partial<Draw>} [change] */
  fill(change = {}) {
    this.source = this.draw = { ...this.draw, ...change };
    return this.take(this.source, this.asker.ask("draw", this.document, this.source));
  }

  /** The list of a file. @param {string} name @param {Uint8Array} bytes */
  read(name, bytes) { return this.take(name, this.asker.ask("read", this.document, name, bytes), `${name} is no list of configurations of this robot.`); }

  /** @param {Draw | string} source @param {Promise<List>} coming @param {string} [title]  of what is said where it does not come */
  async take(source, coming, title) {
    this.orders += 1;
    const order = this.orders;
    const { entry } = this;
    const list = await this.room.await(title ? coming.catch((error) => { this.room.fail(error, title); return undefined; }) : coming);
    if (!list || order !== this.orders || entry !== this.entry) return;
    this.source = source;
    this.list = list;
    this.found = this.exact = NOTHING;
    this.poses = Array.from({ length: Math.min(DRAWN, this.count) }, (_, i) => this.scenario.footprint(this.row(i)));
    this.tell("list");
    await this.ask();
  }

  /** Where the target is. @param {ArrayLike<number>} q */
  place(q) { this.q = contained(Float64Array.from({ length: this.dimension }, (_, i) => q[i] ?? 0), this.coordinates); }

  /** The target goes elsewhere. @param {ArrayLike<number>} q */
  aim(q) {
    this.place(q);
    this.pose();
  }

  /** One of its numbers is another. @param {number} i @param {number} value */
  turn(i, value) {
    const q = Float64Array.from(this.q);
    q[i] = this.coordinates[i].isCircle ? wrap(value) : value;
    this.aim(q);
  }

  /** A question with another number, index or metric. @param {Partial<Pick<Desk, "k" | "index" | "given">>} change */
  question(change) {
    Object.assign(this, change);
    this.pose();
  }

  pose() {
    this.tell("question");
    void this.ask();
  }

  /** The parameters that are for the index: what only a forest takes is kept for when it comes back. @returns {Settings} */
  get parameters() {
    const { given, index } = this;
    if (index === "forest") return given;
    return given.metric === undefined ? {} : { metric: given.metric };
  }

  /** Asks for the neighbours. While an answer is on its way only the newest question waits. */
  async ask() {
    if (this.isAsking) {
      this.isStale = true;
      return;
    }
    if (this.list.version < 1) return;
    this.isAsking = true;
    const { list: { version }, q, k, index, parameters } = this;
    const reply = await this.room.await(this.asker.ask("ask", { version, q, k, index, given: parameters }));
    this.isAsking = false;
    if (reply && version === this.list.version) {
      ({ found: this.found, exact: this.exact } = reply);
      this.tell("answer");
    }
    if (!this.isStale) return;
    this.isStale = false;
    await this.ask();
  }
}
