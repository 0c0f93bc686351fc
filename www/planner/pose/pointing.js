/**
 * The element under the pointer, updated in each frame: a vertex in either pane, a curved edge, or a configuration of
 * the configuration space. Without a pointer, a vertex is chosen by its number. Loaded with the first pointer event.
 */
import { counted } from "../../app/dom.js";
import { Passages } from "../stage/passages.js";
import { gripOf, partAt } from "../stage/grip.js";
import { coordinatesOf } from "../../domain/coordinates.js";
import { lengthText, obstacleName, touchingSentence } from "../../domain/names.js";
import { num } from "../../widgets/format.js";
import { PAST } from "../run-log/columns.js";

/** @import { CSpace } from "../stage/cspace-pane.js" */
/** @import { Place } from "../stage/stage.js" */
/** @import { View } from "planarium/draw" */
/** @import { Hover, Lane } from "../stage/lane.js" */
/** @import { Grip } from "../stage/grip.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @import { Scenario } from "../../domain/types.js" */

/** Distance within which a pointer holds the robot, CSS pixels. */
const REACH = 18;
/** The same of an arm's end effector, which its link surrounds. */
const TIP = 12;

export class Pointing {
  constructor() {
    /** The hold of the robot. @type {Grip | null} */
    this.grip = null;
    /** The index of edges on the last pane, and its view. @type {Passages | null} */
    this.passages = null;
    /** @type {View | null} */
    this.laid = null;
    /** The position of the pointer, pixels of the pane. @type {{ place: Place, x: number, y: number } | null} */
    this.at = null;
    /** The vertex chosen by its number; -1: none. */
    this.chosen = -1;
  }

  /**
   * The configuration of the robot that the pointer holds.
   * @param {Place} place
   * @param {"down" | "move"} type
   * @param {number} x
   * @param {number} y
   * @returns {Float64Array | null}
   */
  hold(place, type, x, y) {
    const { lane, view } = place.pane;
    if (!lane || !view) return null;
    if (type === "down") this.grip = this.take(place, lane, x, y);
    const [px, py] = view.toPlane(x, y);
    return this.grip?.(px, py, false) ?? null;
  }

  /**
   * Takes hold of the robot; a disc comes to the pointer.
   * @param {Place} place
   * @param {Lane} lane
   * @param {number} x
   * @param {number} y
   * @returns {Grip | null}  null: the pointer is not on the robot
   */
  take({ pane, kind }, lane, x, y) {
    const { shown } = lane;
    const pose = poseOf(lane);
    if (kind === "cspace") return gripOf(shown, pose, null, /** @type {CSpace} */ (pane), pose);
    if (shown.scenario.robot === "disc") return gripOf(shown, pose, null, null, pose);
    const hit = (lane.pose ?? shown.start) ? partAt(pane, shown, pose, x, y, REACH, TIP) : null;
    return hit && gripOf(shown, pose, hit.part, null, /** @type {View} */ (pane.view).toPlane(x, y));
  }

  /** @param {Lane[]} lanes @param {Hover | null} before @returns {Hover | null} */
  find(lanes, before) {
    const { at } = this;
    const lane = lanes[at ? at.place.lane : 0];
    if (!lane || (at && at.place.pane.lane !== lane)) return null;
    const { run, scenario } = lane;
    const count = run ? run.past[PAST.vertices] : 0;
    const isThere = (/** @type {number} */ one) => run !== null && run.isThere(one);
    const vertex = at
      ? (at.place.pane.places?.nearest(at.x, at.y, count, isThere) ?? -1)
      : this.chosen < count && isThere(this.chosen)
        ? this.chosen
        : -1;
    const passing = at && vertex < 0 && run ? this.passing(run, at) : null;
    if (passing)
      return { lane, ...passing, check: scenario.check(passing.pose), motions: run?.motionsOf(passing.edge) };
    const pose =
      vertex >= 0 && run ? run.vertices.row(vertex).slice() : at?.place.kind === "cspace" ? this.pose(lane, at) : null;
    if (!pose) return null;
    const isSame =
      before?.lane === lane && before.pose.length === pose.length && before.pose.every((value, j) => value === pose[j]);
    const edge = run && vertex >= 0 ? run.edgeTo(vertex) : -1;
    return {
      lane,
      vertex,
      pose,
      check: isSame ? before.check : scenario.check(pose),
      edge,
      motions: run && edge >= 0 ? run.motionsOf(edge) : undefined,
    };
  }

  /** The curved edge under the pointer. @param {RunLog} run @param {{ place: Place, x: number, y: number }} at */
  passing(run, { place: { pane }, x, y }) {
    if (run.traces.count === 0 || !pane.view) return null;
    // A new layout or a new run needs a new index.
    if (this.passages?.run !== run || this.laid !== pane.view)
      [this.passages, this.laid] = [new Passages(pane, run), pane.view];
    const found = this.passages.find(x, y, run.past[PAST.edges], (edge) => run.isEdgeThere(edge));
    return found && { vertex: -1, ...found };
  }

  /**
   * The configuration at a point: of two coordinates, or with the other ones of the slice.
   * @param {Lane} lane
   * @param {{ place: Place, x: number, y: number }} at
   */
  pose(lane, { place, x, y }) {
    const { scenario, shown } = lane;
    const { view } = place.pane;
    if (!view || (scenario.dimension > 2 && !shown.view.slice)) return null;
    const { min, max } = view.box;
    const at = view.toPlane(x, y);
    const isInside = at.every((value, i) => value >= min[i] && value <= max[i]);
    return isInside
      ? gripOf(shown, poseOf(lane), null, /** @type {CSpace} */ (place.pane), at)(at[0], at[1], false)
      : null;
  }

  /** The element under the pointer, in words. @param {Hover} hover */
  text({
    lane: {
      run,
      scenario,
      shown,
      shown: { placed },
    },
    vertex,
    pose,
    check,
    edge = -1,
    motions = new Float64Array(0),
  }) {
    const units = coordinatesOf(shown).map(({ unit }) => unit);
    const numbers = `${[...pose].map((value) => num(value)).join(", ")}${units.some((unit) => unit !== units[0]) ? ` (${units.join(", ")})` : ` ${units[0]}`}`;
    const control = placed && motions.length > 0 ? ` ${placed.motionsText(motions)}` : "";
    if (vertex < 0 && edge >= 0 && run) {
      const [from, to] = run.edges.row(edge);
      return `Edge ${edge}, from vertex ${from} to ${to}.${control}`;
    }
    if (vertex < 0 || !run)
      return `Configuration ${numbers}: ${check.free ? freeText(scenario, pose) : touchingSentence(scenario, check)}.`;
    const { adjacency, past } = run;
    const edges = past[PAST.edges];
    adjacency.follow();
    const name = `Vertex ${vertex}${vertex < run.roots ? (vertex === 0 ? ", the start," : run.roots > 2 ? ", a goal," : ", the goal,") : ""} at ${numbers}`;
    if (!run.isTree) {
      let degree = 0;
      adjacency.neighbours(vertex, edges, () => degree++);
      return `${name}: ${counted(degree, "edge")}.`;
    }
    const parent = adjacency.parent(vertex, edges);
    if (parent < 0)
      return `${name}: ${vertex === 0 || run.kind === "trees" ? "the root of its tree" : "not connected yet"}.`;
    const length = run.lengthOf(adjacency.edgeTo(vertex, edges));
    return `${name}. Parent ${parent}, ${lengthText(length, scenario)} away; ${lengthText(adjacency.cost(vertex, edges), scenario)} from the root.${control}`;
  }
}

/** The robot's configuration, or the middle of the ranges. @param {Lane} lane */
function poseOf({ pose, shown }) {
  return pose ?? shown.start ?? coordinatesOf(shown).map(({ low, high }) => (low + high) / 2);
}

/**
 * The distance of a free configuration from the nearest obstacle, in words.
 * @param {Scenario} scenario
 * @param {Hover["pose"]} pose
 */
function freeText(scenario, pose) {
  const near = scenario.clearance(pose);
  return near ? `free, ${near.distance.toFixed(3)} m from ${obstacleName(near.obstacle)}` : "free";
}
