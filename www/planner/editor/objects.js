/**
 * The editable objects of a scenario document: start and goal of a query, obstacles, and the bounds. Every change
 * returns a new document.
 */
import { edgesOf, withEdges } from "./bounds.js";
import { placeOf, withPoint } from "./parts.js";

/** @import { Box, Obstacle, Query, ScenarioDocument, Target } from "../../domain/types.js" */
/**
 * @typedef {{ kind: "start" | "goal" | "obstacle" | "bounds", index: number }} EditorObject   index of the query or the
 *   obstacle
 */

/**
 * All objects, in the order of the keyboard.
 * @param {ScenarioDocument} document
 * @param {string | undefined} query
 * @returns {EditorObject[]}
 */
export function objectsOf({ queries, world }, query) {
  const index = queries.findIndex(({ name }) => name === query);
  /** @type {EditorObject[]} */
  const ends = [
    { kind: "start", index },
    { kind: "goal", index },
  ];
  /** @type {EditorObject[]} */
  const bounds = [{ kind: "bounds", index: 0 }];
  return [
    ...(index < 0 ? [] : ends),
    ...world.obstacles.map((_, i) => /** @type {EditorObject} */ ({ kind: "obstacle", index: i })),
    ...(world.bounds ? bounds : []),
  ];
}

/** @param {EditorObject | null} a @param {EditorObject | null} b */
export function same(a, b) {
  return a?.kind === b?.kind && a?.index === b?.index;
}

/** @param {ScenarioDocument} document @param {EditorObject | null} object @returns {Obstacle | null} */
export function obstacleOf({ world }, object) {
  return object?.kind === "obstacle" ? (world.obstacles[object.index] ?? null) : null;
}

/** The bounds, where these are the object. @param {ScenarioDocument} document @param {EditorObject | null} object @returns {Box | null} */
export function boundsOf({ world }, object) {
  return object?.kind === "bounds" ? (world.bounds ?? null) : null;
}

/**
 * The configuration of a start or goal.
 * @param {ScenarioDocument} document
 * @param {EditorObject | null} object
 * @returns {number[] | null}
 */
export function poseOf({ queries }, object) {
  return object?.kind === "start" || object?.kind === "goal" ? (queries[object.index]?.[object.kind] ?? null) : null;
}

/**
 * The target that a query has in place of a goal.
 * @param {ScenarioDocument} document
 * @param {EditorObject | null} object
 * @returns {Target | null}
 */
export function targetOf({ queries }, object) {
  return object?.kind === "goal" ? (queries[object.index]?.target ?? null) : null;
}

/** Whether a document has an object. @param {ScenarioDocument} document @param {EditorObject | null} object */
export function hasObject(document, object) {
  return [obstacleOf, boundsOf, poseOf, targetOf].some((of) => of(document, object) !== null);
}

/**
 * The document with another obstacle at an index.
 * @param {ScenarioDocument} document
 * @param {number} index  past the last: it is added
 * @param {Obstacle | null} obstacle  null: it is removed
 * @returns {ScenarioDocument}
 */
export function withObstacle(document, index, obstacle) {
  const obstacles = [...document.world.obstacles];
  obstacles.splice(index, 1, ...(obstacle ? [obstacle] : []));
  return withObstacles(document, obstacles);
}

/** @param {ScenarioDocument} document @param {Obstacle[]} obstacles @returns {ScenarioDocument} */
export function withObstacles(document, obstacles) {
  return { ...document, world: { ...document.world, obstacles } };
}

/**
 * The document with another start, or with another goal in place of a target.
 * @param {ScenarioDocument} document
 * @param {EditorObject} object
 * @param {ArrayLike<number>} pose
 * @returns {ScenarioDocument}
 */
export function withPose(document, { kind, index }, pose) {
  const end = { [kind]: Array.from(pose), ...(kind === "goal" ? { target: undefined } : {}) };
  return withQuery(document, index, end);
}

/**
 * The document with another target in place of a goal.
 * @param {ScenarioDocument} document
 * @param {EditorObject} object
 * @param {Target} target
 * @returns {ScenarioDocument}
 */
export function withTarget(document, { index }, target) {
  return withQuery(document, index, { goal: undefined, target });
}

/**
 * @param {ScenarioDocument} document
 * @param {number} index
 * @param {object} change  undefined entries are removed
 * @returns {ScenarioDocument}
 */
function withQuery(document, index, change) {
  return { ...document, queries: document.queries.with(index, changed(document.queries[index], change)) };
}

/** A query with other entries. @param {Query} query @param {object} change  undefined entries are removed @returns {Query} */
export function changed(query, change) {
  const entries = Object.entries({ ...query, ...change }).filter(([, value]) => value !== undefined);
  return /** @type {Query} */ (/** @type {unknown} */ (Object.fromEntries(entries)));
}

/**
 * The coordinates of an object, or of one point of an obstacle; those of a disc end with its radius, those of a wall
 * with its width.
 * @param {ScenarioDocument} document
 * @param {EditorObject | null} object
 * @param {number} part
 * @returns {number[]}
 */
export function numbersOf(document, object, part) {
  const bounds = boundsOf(document, object);
  if (bounds) return edgesOf(bounds);
  const obstacle = obstacleOf(document, object);
  if (!obstacle) return poseOf(document, object) ?? targetOf(document, object)?.point ?? [];
  if (obstacle.type === "disc") return [...obstacle.center, obstacle.radius];
  const { points, at } = /** @type {import("./parts.js").Place} */ (placeOf(obstacle, part));
  return [...points[at], ...(obstacle.type === "wall" ? [obstacle.width] : [])];
}

/**
 * The document with other coordinates of a target, the bounds, a disc or a point.
 * @param {ScenarioDocument} document
 * @param {EditorObject} object
 * @param {number} part
 * @param {number[]} numbers
 * @returns {ScenarioDocument}
 */
export function withNumbers(document, object, part, numbers) {
  if (object.kind === "bounds") return withEdges(document, numbers);
  const [x, y, size] = numbers;
  const target = targetOf(document, object);
  if (target) return withTarget(document, object, { ...target, point: [x, y] });
  const obstacle = obstacleOf(document, object);
  if (!obstacle) return document;
  if (obstacle.type === "disc")
    return withObstacle(document, object.index, { ...obstacle, center: [x, y], radius: size });
  const resized = obstacle.type === "wall" ? { ...obstacle, width: size } : obstacle;
  return withObstacle(document, object.index, withPoint(resized, part, [x, y]));
}
