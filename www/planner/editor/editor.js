/**
 * The editor: the selection, and a history of scenario documents. The core parses every change before it is shown; a
 * refused change is drawn with its reason, and the last valid document stays. Planning waits at iteration 0 until Play.
 */
import { errorInfo } from "../../app/error-info.js";
import { sizeOf } from "../../domain/coordinates.js";
import { isTip } from "../stage/grip.js";
import { Placed } from "../stage/placed.js";
import { EDGES } from "./bounds.js";
import { Hand } from "./drag.js";
import { History } from "./history.js";
import { hasObject, objectsOf, obstacleOf, poseOf, same, targetOf, withObstacle } from "./objects.js";
import { best } from "./offers.js";
import { pointsOf } from "./parts.js";
import { shapedOf } from "./robots.js";
import { drawOverlay } from "./selection.js";
import { sentence, sentenceOf, titleOf, touchingOf, whereaboutsOf } from "./words.js";

/** @import { ErrorInfo } from "../../app/error-info.js" */
/** @import { EditTool, Library, Obstacle, Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { Stage } from "../stage/stage.js" */
/** @import { EditorObject } from "./objects.js" */
/**
 * @typedef {object} Session   what the editor takes of the page's session
 * @property {Library} library
 * @property {Shown | null} shown
 * @property {Editor | null} editor
 * @property {{ end: () => void } | null} certifying
 * @property {{ error: unknown } | null} refusal
 * @property {{ now: number, playing: boolean }} clock
 * @property {{ pause: () => void }} timeline
 * @property {Stage} stage
 * @property {{ pointing: { at: unknown } | null, release: () => void, showTouching: () => void }} byHand
 * @property {() => void} forget
 * @property {(scenario: Scenario, document: ScenarioDocument, placed: Placed | null, live: boolean) => void} replace
 */
/**
 * @typedef {(scenario: Scenario, document: ScenarioDocument, placed: Placed | null) => void} Reopen   puts a scenario
 *   on the stage whose robot has other coordinates
 */

export class Editor {
  /** @param {Session} session @param {Reopen} reopen */
  constructor(session, reopen) {
    this.session = session;
    this.reopen = reopen;
    this.on = false;
    this.changes = 0;
    this.history = new History(/** @type {ScenarioDocument} */ (session.shown?.document));
    this.hand = new Hand(this);
    /** @type {EditTool} */
    this.tool = "select";
    /** @type {EditorObject | null} */
    this.selected = null;
    /** Vertex or joint. @type {number | null} */
    this.part = null;
    /** @type {ErrorInfo | null} */
    this.refusal = null;
    /** @type {Obstacle | null} */
    this.refused = null;
    this.announcement = "";
    /** Whether the scenario that is being opened is an edit. */
    this.isReopening = false;
  }

  /** Begins with the scenario that was opened. */
  begin() {
    if (this.isReopening) return;
    this.history = new History(this.document);
    this.hand.release();
    this.tool = "select";
    this.selected = this.part = this.refusal = this.refused = null;
    this.announcement = "";
  }

  get shown() {
    return /** @type {Shown} */ (this.session.shown);
  }
  get document() {
    return this.shown.document;
  }
  /** The target, where that is selected. */
  get target() {
    return targetOf(this.document, this.selected);
  }
  get obstacle() {
    return obstacleOf(this.document, this.selected);
  }

  /** Whether the scenario differs from the one that was opened. */
  get isChanged() {
    return this.history.now !== this.history.first;
  }

  /** Whether the stage shows a document that is not in the history yet. */
  get isDifferent() {
    return this.document !== this.history.now;
  }

  /** The longer side of the world, metres. @returns {number} */
  get size() {
    return sizeOf(this.shown.scenario);
  }

  /** The unit that lengths are rounded to: a ten-thousandth of the world, or a little less. */
  get unit() {
    return 10 ** Math.floor(Math.log10(this.size * 1e-4));
  }

  /** @param {boolean} on */
  turn(on) {
    const { session } = this;
    this.use("select");
    this.selected = null;
    this.on = on;
    if (on) {
      session.forget();
      session.certifying?.end();
      if (session.byHand.pointing) session.byHand.pointing.at = null;
      session.byHand.release();
      session.timeline.pause();
    } else if (session.refusal) session.byHand.showTouching();
  }

  /** @param {EditTool} tool */
  use(tool) {
    this.abandon();
    this.tool = tool;
  }

  /** Cancels the gesture, the tool or the selection. */
  cancel() {
    if (this.hand.isBusy) this.abandon();
    else if (this.tool !== "select") this.tool = "select";
    else this.choose(this.part === null ? null : this.selected, null);
    this.refusal = null;
  }

  /** Selects the next or the previous object. @param {number} way */
  select(way) {
    const objects = objectsOf(this.document, this.shown.query);
    const at = objects.findIndex((object) => same(object, this.selected));
    this.choose(objects.at(at < 0 && way < 0 ? -1 : (at + way) % objects.length) ?? null, null);
  }

  /** Selects the next or the previous vertex, joint or edge. @param {number} way */
  pick(way) {
    const { parts, part } = this;
    if (parts > 0) this.choose(this.selected, part === null ? (way > 0 ? 0 : parts - 1) : (part + way + parts) % parts);
  }

  /** Undoes or redoes. @param {-1 | 1} way */
  go(way) {
    this.abandon();
    const { history } = this;
    if (!history.go(way)) return;
    this.settle();
    this.announcement = way < 0 ? `Undone, ${history.undoable} left.` : `Redone, ${history.redoable} left.`;
  }

  /** Restores the scene as opened, which can be undone. */
  revert() {
    this.abandon();
    if (!this.isChanged) return;
    this.history.commit(this.history.first);
    this.settle();
    this.announcement = "The scene is restored.";
  }

  /** @param {EditorObject | null} object @param {number | null} part */
  choose(object, part) {
    this.selected = object;
    this.part = part;
    this.announcement = object ? `${titleOf(this)} selected.` : "Nothing is selected.";
  }

  /** Selects a new object with the selection tool. @param {EditorObject} object */
  put(object) {
    this.choose(object, null);
    this.tool = "select";
  }

  /** Says why nothing is changed. @param {string} message @param {string} code */
  refuse(message, code) {
    this.refusal = { message, code, pointer: "" };
  }

  /** @param {ScenarioDocument} document @returns {Scenario | null} null: refused, and `refusal` says why */
  read(document) {
    try {
      const scenario = this.session.library.Scenario.parse(document);
      this.refusal = null;
      return scenario;
    } catch (error) {
      const fault = errorInfo(error);
      if (fault.code === "" || fault.code === "internal") throw error;
      this.refusal = fault;
      return null;
    }
  }

  /**
   * Shows a document if the core accepts it.
   * @param {ScenarioDocument} document
   * @param {boolean} [isLive]  during a gesture
   * @param {EditorObject | null} [dragged]  the object of the gesture
   */
  attempt(document, isLive = false, dragged = null) {
    const scenario = this.read(document);
    this.refused = scenario ? null : obstacleOf(document, dragged);
    if (scenario) this.show(scenario, document, isLive);
    return scenario !== null;
  }

  /** @param {Scenario} scenario @param {ScenarioDocument} document @param {boolean} isLive */
  show(scenario, document, isLive) {
    const { shown, session } = this;
    const { robot } = document;
    const shaped = shapedOf(robot);
    const placed = robot === shown.document.robot ? shown.placed : shaped && new Placed(shaped);
    if (scenario.robot === shown.scenario.robot && scenario.dimension === shown.scenario.dimension) {
      session.replace(scenario, document, placed, isLive);
      return;
    }
    this.isReopening = true;
    try {
      this.reopen(scenario, document, placed);
    } finally {
      this.isReopening = false;
    }
  }

  /** Makes a change. @param {ScenarioDocument} document @param {boolean} [goesOn]  it continues the previous one */
  change(document, goesOn = false) {
    if (!this.attempt(document)) return false;
    if (!hasObject(document, this.selected)) this.selected = this.part = null;
    this.end(goesOn);
    return true;
  }

  /**
   * Adds the first of some obstacles that leaves start and goal free, or else the first that the core accepts.
   * @param {Obstacle[]} offers
   * @returns {boolean} whether it accepts one
   */
  add(offers) {
    const index = this.document.world.obstacles.length;
    if (
      !this.change(
        best(
          this,
          offers.map((offer) => withObstacle(this.document, index, offer)),
        ),
      )
    )
      return false;
    this.put({ kind: "obstacle", index });
    this.announcement = whereaboutsOf(this);
    return true;
  }

  /** Cancels the gesture. */
  abandon() {
    this.refusal = this.refused = null;
    if (this.hand.release() && this.isDifferent) this.settle();
  }

  /** Shows the current document of the history again. */
  settle() {
    this.attempt(this.history.now);
    if (!hasObject(this.document, this.selected)) this.selected = null;
    if ((this.part ?? 0) >= this.parts) this.part = null;
    this.end();
  }

  /** Ends a gesture: the document on the stage enters the history. @param {boolean} [goesOn] */
  end(goesOn = false) {
    const { session, history } = this;
    this.refused = null;
    if (this.isDifferent) {
      history.commit(this.document, goesOn);
      this.announcement = whereaboutsOf(this);
    }
    this.changes++;
    this.shown.rough = false;
    session.stage.invalidate();
  }

  /**
   * The number of parts to pick: points of an obstacle, edges of the bounds, joints and end effector of an arm, or the
   * heading of a body.
   * @returns {number}
   */
  get parts() {
    const { obstacle, selected } = this;
    if (obstacle) return pointsOf(obstacle).length;
    if (selected?.kind === "bounds") return EDGES.length;
    const { scenario, placed } = this.shown;
    return selected && !this.target && scenario.robot !== "disc" ? (placed ? 1 : scenario.dimension + 1) : 0;
  }

  /** The position of the end effector, where that is selected. */
  get tip() {
    const { document, selected, part } = this;
    const { scenario } = this.shown;
    const pose = poseOf(document, selected);
    return pose && isTip(scenario, part) ? scenario.endEffector(pose) : null;
  }

  /** Draws the selection on the panes while the editor is on. */
  overlay() {
    this.shown.overlay = this.on ? this : null;
  }

  /** @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
  draw(pane, context, lane) {
    drawOverlay(pane, context, lane, this);
  }

  /** A start or goal in collision, or a target out of reach, in words. */
  get touching() {
    return touchingOf(this);
  }

  /** Why the last change was refused, or empty. @returns {string} */
  get reason() {
    return sentence(this.refusal?.message ?? "");
  }

  /** @returns {boolean} */
  get isBad() {
    return this.reason !== "" || this.touching !== "";
  }

  /** The sentence above the stage; empty during a run. */
  get sentence() {
    return sentenceOf(this);
  }
}
