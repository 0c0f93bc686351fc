/** What keys and buttons do to the selection. */
import { contained, coordinatesOf } from "../../domain/coordinates.js";
import { around, simple } from "./additions.js";
import { edgesOf, withEdges } from "./bounds.js";
import {
  boundsOf,
  numbersOf,
  poseOf,
  withNumbers,
  withObstacle,
  withObstacles,
  withPose,
  withTarget,
} from "./objects.js";
import { goalOf, holeOf } from "./offers.js";
import { cut, filled, middle, moved, placeOf, withPoint } from "./parts.js";
import { ANGLE, fine, rounded } from "./units.js";
import { fieldsOf, titleOf } from "./words.js";

/** @import { Point } from "../../domain/types.js" */
/** @import { Editor } from "./editor.js" */

/**
 * Moves the selection by a hundred units, or a joint or a heading by a degree.
 * @param {Editor} editor
 * @param {number} dx
 * @param {number} dy  one of both is 0
 * @param {boolean} goesOn  a key is held down
 */
export function nudge(editor, dx, dy, goesOn) {
  const { selected, part, obstacle, document, unit, tip } = editor;
  const step = 100 * unit;
  if (!selected) return;
  if (obstacle && part === null) {
    editor.change(withObstacle(document, selected.index, moved(obstacle, dx * step, dy * step, unit)), goesOn);
    return;
  }
  const bounds = boundsOf(document, selected);
  if (bounds) {
    const next = edgesOf(bounds).map((value, i) =>
      part === null || part === i ? rounded(value + [dx, dy][i % 2] * step, unit) : value,
    );
    editor.change(withEdges(document, next), goesOn);
    return;
  }
  const fields = fieldsOf(editor);
  const isPose = poseOf(document, selected) !== null && !tip;
  const isArm = document.robot.type === "arm" && isPose;
  const isHeading = isPose && fields.length > 2 && part !== null;
  const index = isArm ? (part ?? 0) : isHeading ? 2 : Number(dx === 0);
  const { value, unit: measure } = fields[index];
  const next =
    measure === "rad" ? rounded(value + ((dx + dy) * Math.PI) / 180, ANGLE) : rounded(value + (dx + dy) * step, unit);
  set(editor, index, next, goesOn);
}

/** Sets one coordinate of the selection. @param {Editor} editor @param {number} index @param {number} value @param {boolean} [goesOn] */
export function set(editor, index, value, goesOn) {
  const { selected, part, shown, document, tip } = editor;
  const pose = poseOf(document, selected);
  if (!selected) return;
  const numbers = Array.from(tip ?? numbersOf(document, selected, part ?? 0)).with(index, value);
  if (!pose) editor.change(withNumbers(document, selected, part ?? 0, numbers), goesOn);
  else if (tip)
    editor.change(
      withPose(document, selected, fine(shown.scenario.follow(pose, [numbers[0], numbers[1]]).configuration)),
      goesOn,
    );
  else editor.change(withPose(document, selected, contained(Float64Array.from(numbers), coordinatesOf(shown))), goesOn);
}

/** Adds a point after the selected one. @param {Editor} editor */
export function insert(editor) {
  const { selected, obstacle, document, unit } = editor;
  const part = editor.part ?? 0;
  const place = obstacle && placeOf(obstacle, part);
  if (!selected || !place) return;
  const [x, y] = middle(place).map((value) => rounded(value, unit));
  if (editor.change(withObstacle(document, selected.index, withPoint(obstacle, part + 1, [x, y], true))))
    editor.choose(selected, part + 1);
}

/** Deletes the selected point, obstacle or bounds, or the last point of a shape being drawn. @param {Editor} editor */
export function remove(editor) {
  const { selected, part, obstacle, document, hand } = editor;
  hand.loose = null;
  if (hand.draft.pop() || !selected) return;
  const title = titleOf(editor);
  if (selected.kind === "bounds") {
    if (!editor.change(withEdges(document, null))) return;
    editor.choose(null, null);
  } else if (obstacle) {
    const left = part !== null && editor.parts > 0 ? withPoint(obstacle, part, null) : null;
    if (!editor.change(withObstacle(document, selected.index, left))) return;
    editor.choose(left && selected, null);
  } else {
    editor.refuse("the start and the goal can be moved but not deleted", "not-deletable");
    return;
  }
  editor.announcement = `${title} deleted.`;
}

/** Turns a goal into a target, or a target into a goal: the first configuration that reaches it. @param {Editor} editor */
export function retarget(editor) {
  const { selected, document, target } = editor;
  const { scenario, goal, goals } = editor.shown;
  if (!selected || goalOf(editor) === "") return;
  const point = goal && scenario.endEffector(goal).map((value) => rounded(value, 1e-6));
  const next = point
    ? withTarget(document, selected, { point: /** @type {Point} */ (point) })
    : target &&
      withPose(
        document,
        selected,
        goals[0] ?? scenario.nearestReachable(target.point, target.orientation).configuration,
      );
  if (!next || !editor.change(next)) return;
  editor.choose(selected, null);
  editor.announcement = editor.target
    ? "The goal is any configuration that reaches this point."
    : "The goal is this one configuration.";
}

/** @param {Editor} editor */
export function duplicate(editor) {
  if (editor.obstacle) editor.add(around(editor.obstacle, editor.size, editor.unit));
}

/** Ends the polygon or wall being drawn, or adds an obstacle where there is room. @param {Editor} editor */
export function enter(editor) {
  const { hand, tool, size, unit } = editor;
  const { min, max } = editor.shown.scenario.extent();
  if (hand.draft.length > 0) hand.close();
  else if (tool !== "select") {
    const centred = simple(tool, [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2], size, unit);
    editor.add([centred, ...around(centred, size, unit)]);
  }
}

/** Cuts the selected polygon out of the one around it, or fills the selected hole. @param {Editor} editor */
export function cutOrFill(editor) {
  const { selected, part, obstacle, document } = editor;
  if (!selected || obstacle?.type !== "polygon") return;
  if (holeOf(editor) === "fill") {
    const whole = filled(obstacle, part ?? 0);
    if (!editor.change(withObstacle(document, selected.index, whole))) return;
    editor.choose(selected, null);
    editor.announcement = "The hole is filled.";
    return;
  }
  const made = cut(document.world.obstacles, selected.index);
  if (!made) {
    editor.refuse("a polygon becomes a hole where all its corners lie in another polygon", "no-polygon-around");
    return;
  }
  if (!editor.change(withObstacles(document, made.obstacles))) return;
  editor.choose({ kind: "obstacle", index: made.index }, made.part);
  editor.announcement = `${titleOf(editor)}: the hole is cut.`;
}

/** Joins the ends of the selected wall, or opens it. @param {Editor} editor @param {boolean} isClosed */
export function closeWall(editor, isClosed) {
  const { selected, obstacle, document } = editor;
  if (!selected || obstacle?.type !== "wall") return;
  const { closed: _, ...open } = obstacle;
  editor.change(withObstacle(document, selected.index, isClosed ? { ...open, closed: true } : open));
}
