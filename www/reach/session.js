/** The state of the page: the arm, the mode, the configurations A and B, and the target. */
import { Observable } from "../app/observable.js";
import { Arm } from "./arm.js";
import { Motion } from "./motion.js";
import { SCENES, documentOf } from "./scenes.js";

/** @import { App } from "../app/app.js" */
/** @import { Point, Query, ScenarioDocument } from "../domain/types.js" */
/** @import { IkRun } from "./ik-run.js" */
/** @import { Direction } from "./motion.js" */
/** @import { SceneEntry } from "./scenes.js" */
/** @typedef {"hand" | "between" | "solve"} Mode   dragging, the motion from A to B, inverse kinematics */

/**
 * The outcome of moving the tip to a point: the nearest point, its distance in metres, and whether another configuration would come nearer.
 * @typedef {{ wanted: Point, point: Point, distance: number, reached: boolean, isStuck: boolean }} TipGoal
 */

/** The arm itself; its configuration, by the user or by inverse kinematics; another mode; or anything else. @typedef {"arm" | "pose" | "iterate" | "mode" | "rest"} Change */

/** The part of its reach by which another configuration must come nearer for the arm to be stuck. */
const STUCK = 1e-3;

/** @extends {Observable<Change>} */
export class ArmSession extends Observable {
  /** @param {App} app */
  constructor(app) {
    super(app);
    const [entry] = SCENES;
    this.arm = new Arm(documentOf(entry), entry.q);
    /** The built-in scene, if it is one. @type {SceneEntry | null} */
    this.entry = entry;
    /** @type {Mode} */
    this.mode = "hand";
    this.a = Float64Array.from(entry.a);
    this.b = Float64Array.from(entry.b);
    /** The way round of each joint from A to B. @type {Direction[]} */
    this.directions = [];
    /** The part of the motion that is done, 0 to 1. */
    this.progress = 0;
    /** The orientation of the last link, radians; null: any. @type {number | null} */
    this.orientation = null;
    this.target = entry.target;
    /** @type {TipGoal | null} */
    this.tipGoal = null;
    /** The run of inverse kinematics, in that mode. @type {IkRun | null} */
    this.run = null;
    /** The index of the solution that the arm shows, or -1. */
    this.chosen = -1;
    /** The motion, and what it was computed for. @type {{ key: string, arm: Arm, motion: Motion } | null} */
    this.computed = null;
  }

  /** @param {SceneEntry} entry */
  openScene(entry) {
    const { q, a, b, target } = entry;
    this.begin(new Arm(documentOf(entry), q), { entry, a: Float64Array.from(a), b: Float64Array.from(b), target, orientation: null });
  }

  /** Opens the user's scenario; without queries A, B and the target are chosen for it. @param {ScenarioDocument | string} document @throws {Error} the core refuses it */
  openDocument(document) {
    const arm = new Arm(document, []);
    const { base, joints, scenario, reach } = arm;
    const middle = joints.map(({ low, high }) => (low + high) / 2);
    const [{ start = middle, goal, target: wanted } = { start: middle }] = /** @type {Partial<Query>[]} */ (arm.document.queries);
    arm.moveTo(start);
    const target = wanted?.point ?? (goal ? scenario.endEffector(goal) : [base[0] + 0.6 * reach, base[1] + 0.2 * reach]);
    const b = arm.fitted(goal ?? scenario.nearestReachable(target, wanted?.orientation).configuration);
    this.begin(arm, { entry: null, a: Float64Array.from(arm.q), b, target, orientation: wanted?.orientation ?? null });
  }

  /** Begins with an arm. @param {Arm} arm @param {Pick<ArmSession, "entry" | "a" | "b" | "target" | "orientation">} scene */
  begin(arm, scene) {
    this.replace(arm, { ...scene, directions: arm.joints.map(() => "short"), progress: 0 });
    if (this.mode === "between") this.setProgress(0);
  }

  /** Changes the arm within the same world. @param {ScenarioDocument} document @throws {Error} the core refuses it, and nothing changes */
  changeArm(document) {
    const { a, b, directions } = this;
    const arm = new Arm({ ...document, queries: [] }, this.arm.q);
    this.replace(arm, { a: arm.fitted(a), b: arm.fitted(b), directions: arm.joints.map((_, i) => directions[i] ?? "short") });
  }

  /** @param {Arm} arm @param {Partial<ArmSession>} changes */
  replace(arm, changes) {
    this.arm.free();
    Object.assign(this, { ...changes, arm, tipGoal: null });
    if (arm.dimension < 3) this.orientation = null;
    this.update("arm");
  }

  /** @param {ArrayLike<number>} q @param {Change} [change] @param {TipGoal | null} [tipGoal] */
  moveTo(q, change = "pose", tipGoal = null) {
    this.arm.moveTo(q);
    this.tipGoal = tipGoal;
    this.update(change);
  }

  /** @param {number} joint @param {number} angle */
  turnJoint(joint, angle) { this.moveTo(this.arm.q.with(joint, angle)); }

  /** Moves the tip to a point, or as near as it gets. @param {Point} wanted */
  moveTip(wanted) {
    const { arm } = this;
    const orientation = this.orientation ?? undefined;
    const { configuration, point, distance, reached } = arm.scenario.follow(arm.q, wanted, orientation);
    const nearest = reached ? null : arm.scenario.nearestReachable(wanted, orientation);
    const isStuck = nearest !== null && nearest.distance < distance - STUCK * arm.reach;
    this.moveTo(configuration, "pose", { wanted, reached, isStuck, ...(nearest && !isStuck ? { point: nearest.point, distance: nearest.distance } : { point, distance }) });
  }

  /** @param {Mode} mode */
  setMode(mode) {
    const change = mode === this.mode ? "rest" : "mode";
    this.mode = mode;
    this.tipGoal = null;
    if (mode === "between") this.setProgress(0);
    this.update(change);
  }

  /** The motion from A to B. @returns {Motion} */
  get motion() {
    const { arm, a, b, directions, computed } = this;
    const key = [...a, ...b, ...directions].join();
    if (computed?.key === key && computed.arm === arm) return computed.motion;
    const motion = new Motion(arm, a, b, directions);
    this.computed = { key, arm, motion };
    return motion;
  }

  /** @param {number} progress */
  setProgress(progress) {
    this.progress = Math.min(1, Math.max(0, progress));
    this.moveTo(this.motion.at(this.progress));
  }

  /** The query to reach the target from a configuration. @param {ArrayLike<number>} start @returns {Query} */
  targetQuery(start) {
    const { target: point, orientation } = this;
    return { name: "reach", start: Array.from(start), target: { point, ...(orientation === null ? {} : { orientation }) } };
  }

  /** The arm and its world with the queries A to B and the target. @returns {ScenarioDocument} */
  document() {
    const { arm, a, b } = this;
    return { ...arm.document, queries: [{ name: "a-to-b", start: [...a], goal: [...b] }, this.targetQuery(arm.q)] };
  }
}
