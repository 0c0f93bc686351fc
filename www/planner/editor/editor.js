/**
 * The editor: the selection, and a history of scenario documents. The core parses every change before it is shown; a
 * refused change is drawn with its reason, and the last valid document stays. Planning waits at iteration 0 until Play.
 */
import { errorInfo } from "../../app/error-info.js";
import { drawOverlay } from "./selection.js";
import { contained, coordinatesOf, sizeOf } from "../../domain/coordinates.js";
import { History } from "./history.js";
import { Hand } from "./drag.js";
import { ANGLE } from "./gestures.js";
import { capital } from "../../widgets/format.js";
import { touchingSentence } from "../../domain/names.js";
import { isTip } from "../stage/grip.js";
import {
  around,
  fine,
  middle,
  moved,
  numbersOf,
  objectsOf,
  obstacleOf,
  poseOf,
  rounded,
  same,
  simple,
  targetOf,
  withNumbers,
  withObstacle,
  withPose,
  withTarget,
  withVertex,
} from "./objects.js";

/** @import { ErrorInfo } from "../../app/error-info.js" */
/** @import { Coordinate, EditTool, Library, Obstacle, Point } from "../../domain/types.js" */
/** @import { Scenario, ScenarioDocument } from "../../domain/types.js" */
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
 * @property {(scenario: Scenario, document: ScenarioDocument, live: boolean) => void} replace
 */

/** How to use each tool. @type {Record<EditTool, string>} */
const HINTS = {
  select: "Drag the start, goal or any obstacle; press Play to plan again.",
  disc: "Drag from the centre of the disc outwards.",
  rectangle: "Drag from corner to corner; hold Shift for a square.",
  polygon: "Click the corners; click the first one again, double-click or press Enter to close the polygon.",
};

/** The coordinates of points and discs. @type {Coordinate[]} */
const PLACE = ["x", "y", "radius"].map((name) => ({
  name,
  unit: "m",
  low: -Infinity,
  high: Infinity,
  isCircle: false,
}));

/** @param {string} message */
function sentence(message) {
  return message && `${capital(message)}.`;
}

export class Editor {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
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
  }

  /** Begins with the scenario that was opened. */
  begin() {
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

  /** Selects the next or the previous vertex or joint. @param {number} way */
  pick(way) {
    const { parts, part } = this;
    if (parts > 0) this.choose(this.selected, part === null ? (way > 0 ? 0 : parts - 1) : (part + way + parts) % parts);
  }

  /**
   * Moves the selection by a hundred units, or a joint or a heading by a degree.
   * @param {number} dx
   * @param {number} dy  one of both is 0
   * @param {boolean} goesOn  a key is held down
   */
  nudge(dx, dy, goesOn) {
    const { selected, part, obstacle, document, fields, unit, tip } = this;
    const step = 100 * unit;
    if (!selected) return;
    if (obstacle && part === null) {
      this.change(withObstacle(document, selected.index, moved(obstacle, dx * step, dy * step, unit)), goesOn);
      return;
    }
    const isHeading = fields.length > 2 && part !== null;
    const isArm = document.robot.type === "arm" && !tip && poseOf(document, selected) !== null;
    const index = isArm ? (part ?? 0) : isHeading ? 2 : Number(dx === 0);
    const { value, unit: measure } = fields[index];
    const next =
      measure === "rad" ? rounded(value + ((dx + dy) * Math.PI) / 180, ANGLE) : rounded(value + (dx + dy) * step, unit);
    this.set(index, next, goesOn);
  }

  /** Sets one coordinate of the selection. @param {number} index @param {number} value @param {boolean} [goesOn] */
  set(index, value, goesOn) {
    const { selected, part, shown, document, tip } = this;
    const pose = poseOf(document, selected);
    if (!selected) return;
    const numbers = Array.from(tip ?? numbersOf(document, selected, part ?? 0)).with(index, value);
    if (!pose) this.change(withNumbers(document, selected, part ?? 0, numbers), goesOn);
    else if (tip)
      this.change(
        withPose(document, selected, fine(shown.scenario.follow(pose, [numbers[0], numbers[1]]).configuration)),
        goesOn,
      );
    else this.change(withPose(document, selected, contained(Float64Array.from(numbers), coordinatesOf(shown))), goesOn);
  }

  /** Adds a vertex after the selected one. */
  insert() {
    const { selected, obstacle, document } = this;
    if (!selected || obstacle?.type !== "polygon") return;
    const part = this.part ?? 0;
    const [x, y] = middle(obstacle.vertices, part).map((value) => rounded(value, this.unit));
    if (this.change(withObstacle(document, selected.index, withVertex(obstacle, part + 1, [x, y], true))))
      this.choose(selected, part + 1);
  }

  /** Deletes the selected vertex or obstacle, or the last vertex of a polygon being drawn. */
  remove() {
    const { selected, part, obstacle, title } = this;
    this.hand.loose = null;
    if (this.hand.draft.pop() || !selected) return;
    if (!obstacle) {
      this.refusal = {
        message: "the start and the goal can be moved but not deleted",
        code: "not-deletable",
        pointer: "",
      };
      return;
    }
    const left = obstacle.type === "polygon" && part !== null ? withVertex(obstacle, part, null) : null;
    if (!this.change(withObstacle(this.document, selected.index, left))) return;
    this.choose(left && selected, null);
    this.announcement = `${title} deleted.`;
  }

  /** Turns a goal into a target, or a target into a goal: the first configuration that reaches it. */
  retarget() {
    const { selected, document, target } = this;
    const { scenario, goal, goals } = this.shown;
    if (!selected || this.goal === "") return;
    const point = goal && scenario.endEffector(goal).map((value) => rounded(value, 1e-6));
    const next = point
      ? withTarget(document, selected, { point: /** @type {Point} */ (point) })
      : target &&
        withPose(
          document,
          selected,
          goals[0] ?? scenario.nearestReachable(target.point, target.orientation).configuration,
        );
    if (!next || !this.change(next)) return;
    this.choose(selected, null);
    this.announcement = this.target
      ? "The goal is any configuration that reaches this point."
      : "The goal is this one configuration.";
  }

  duplicate() {
    if (this.obstacle) this.add(around(this.obstacle, this.size, this.unit));
  }

  /** Closes the polygon being drawn, or adds an obstacle where there is room. */
  enter() {
    const { hand, tool, size, unit } = this;
    const { min, max } = this.shown.scenario.extent();
    if (hand.draft.length > 0) hand.close();
    else if (tool !== "select") {
      const centred = simple(tool, [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2], size, unit);
      this.add([centred, ...around(centred, size, unit)]);
    }
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
    this.announcement = object ? `${this.title} selected.` : "Nothing is selected.";
  }

  /** Selects a new object with the selection tool. @param {EditorObject} object */
  put(object) {
    this.choose(object, null);
    this.tool = "select";
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
   * @param {EditorObject | null} [dragged]  the object of a gesture
   */
  attempt(document, dragged = null) {
    const scenario = this.read(document);
    this.refused = scenario ? null : obstacleOf(document, dragged);
    if (scenario) this.session.replace(scenario, document, dragged !== null);
    return scenario !== null;
  }

  /** Makes a change. @param {ScenarioDocument} document @param {boolean} [goesOn]  it continues the previous one */
  change(document, goesOn = false) {
    if (!this.attempt(document)) return false;
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
    const documents = offers.map((offer) => withObstacle(this.document, index, offer));
    /** @param {ScenarioDocument} document @returns {number} 0: refused, 1: start or goal in collision, 2: both free */
    const suits = (document) => {
      const scenario = this.read(document);
      const poses = objectsOf(document, this.shown.query).map((object) => poseOf(document, object));
      const free = scenario && poses.every((pose) => !pose || scenario.check(pose).free);
      scenario?.free();
      return scenario ? 1 + Number(free) : 0;
    };
    const document = documents.find((one) => suits(one) === 2) ?? documents.find(suits) ?? documents[0];
    if (!this.change(document)) return false;
    this.put({ kind: "obstacle", index });
    this.announcement = this.whereabouts;
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
    if (!this.obstacle && !this.target && !poseOf(this.document, this.selected)) this.selected = null;
    if ((this.part ?? 0) >= this.parts) this.part = null;
    this.end();
  }

  /** Ends a gesture: the document on the stage enters the history. @param {boolean} [goesOn] */
  end(goesOn = false) {
    const { session, history } = this;
    this.refused = null;
    if (this.isDifferent) {
      history.commit(this.document, goesOn);
      this.announcement = this.whereabouts;
    }
    this.changes++;
    this.shown.rough = false;
    session.stage.invalidate();
  }

  /**
   * The number of parts to pick: vertices of a polygon, joints and end effector of an arm, or the heading of a body.
   * @returns {number}
   */
  get parts() {
    const { obstacle } = this;
    if (obstacle) return obstacle.type === "polygon" ? obstacle.vertices.length : 0;
    const { scenario, placed } = this.shown;
    return this.selected && !this.target && scenario.robot !== "disc" ? (placed ? 1 : scenario.dimension + 1) : 0;
  }

  /** The selection, in words. @returns {string} */
  get title() {
    const { selected, part, obstacle } = this;
    if (!selected) return "";
    const name = obstacle
      ? `Obstacle ${selected.index}, a ${obstacle.type}`
      : selected.kind === "start"
        ? "Start"
        : this.target
          ? "Target"
          : "Goal";
    if (this.tip) return `${name}, end effector`;
    if (part === null || this.parts === 0) return name;
    return this.shown.placed && !obstacle
      ? `${name}, its heading`
      : `${name}, ${obstacle ? `vertex ${part}` : `joint ${part + 1}`}`;
  }

  /** The position of the end effector, where that is selected. */
  get tip() {
    const { document, selected, part } = this;
    const { scenario } = this.shown;
    const pose = poseOf(document, selected);
    return pose && isTip(scenario, part) ? scenario.endEffector(pose) : null;
  }

  /** The coordinates of the selection. */
  get fields() {
    const { document, selected, part, shown, tip, unit } = this;
    const numbers = tip?.map((value) => rounded(value, unit)) ?? numbersOf(document, selected, part ?? 0);
    const coordinates = poseOf(document, selected) && !tip ? coordinatesOf(shown) : PLACE;
    return numbers.map((value, i) => ({ ...coordinates[i], value }));
  }

  /** The selection and its coordinates. */
  get whereabouts() {
    return `${this.title}: ${this.fields.map(({ name, value }) => `${name} ${value}`).join(", ")}.`;
  }

  /** Draws the selection on the panes while the editor is on. */
  overlay() {
    this.shown.overlay = this.on ? this : null;
  }

  /** @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
  draw(pane, context, lane) {
    drawOverlay(pane, context, lane, this);
  }

  /** Start and goal in collision, once planning was refused. */
  get collisions() {
    const { session, shown } = this;
    if (!session.refusal) return [];
    return /** @type {const} */ (["start", "goal"]).flatMap((end) => {
      const pose = shown[end];
      const check = pose && shown.scenario.check(pose);
      return check && !check.free ? [{ end, pose, check }] : [];
    });
  }

  /** A start or goal in collision, or a target out of reach, in words. @returns {string} */
  get touching() {
    const { scenario, target } = this.shown;
    const { refusal } = this.session;
    if (target && refusal) return sentence(errorInfo(refusal.error).message);
    return this.collisions
      .map(({ end, check }) => `The ${end} is in collision: ${touchingSentence(scenario, check)}.`)
      .join(" ");
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
    const { touching } = this;
    const { clock } = this.session;
    if (!this.on) return "";
    if (this.reason) return this.reason;
    if (clock.now > 0 || clock.playing) return "";
    if (touching && this.shown.target) return touching;
    return touching ? `${touching} Move it out of collision to plan.` : HINTS[this.tool];
  }

  /** The kind of the selection; an "end" is a start or goal. */
  get kind() {
    return this.obstacle?.type ?? (this.selected ? "end" : "");
  }

  /** For the selected goal of an arm: one configuration, or any that reaches a point. */
  get goal() {
    return this.selected?.kind !== "goal" || this.shown.scenario.robot !== "arm" ? "" : this.target ? "target" : "pose";
  }
}
