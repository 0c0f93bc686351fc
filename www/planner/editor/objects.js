/**
 * The editable objects of a scenario document: start and goal of a query, and obstacles. Every change returns a new
 * document.
 */

/** @import { EditTool, Obstacle, Point, Query, ScenarioDocument, Target } from "../../domain/types.js" */
/**
 * @typedef {{ kind: "start" | "goal" | "obstacle", index: number }} EditorObject   index of the query or the obstacle
 */

/** Distances at which a new obstacle is tried, as parts of the world, and directions, as eighths of a turn. */
const RINGS = [0.09, 0.18, 0.28, 0.38, 0.46];
const DIRECTIONS = [7, 1, 3, 5];

/**
 * All objects, in the order of the keyboard.
 * @param {ScenarioDocument} document
 * @param {string | undefined} query
 * @returns {EditorObject[]}
 */
export function objectsOf({ queries, world }, query) {
  const index = queries.findIndex(({ name }) => name === query);
  return [
    ...(index < 0
      ? []
      : [
          { kind: /** @type {const} */ ("start"), index },
          { kind: /** @type {const} */ ("goal"), index },
        ]),
    ...world.obstacles.map((_, i) => ({ kind: /** @type {const} */ ("obstacle"), index: i })),
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

/**
 * The configuration of a start or goal.
 * @param {ScenarioDocument} document
 * @param {EditorObject | null} object
 * @returns {number[] | null}
 */
export function poseOf({ queries }, object) {
  return !object || object.kind === "obstacle" ? null : (queries[object.index]?.[object.kind] ?? null);
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
  const entries = Object.entries({ ...document.queries[index], ...change }).filter(([, value]) => value !== undefined);
  return {
    ...document,
    queries: document.queries.with(index, /** @type {Query} */ (/** @type {unknown} */ (Object.fromEntries(entries)))),
  };
}

/** Rounds to whole units, without binary residue. @param {number} value @param {number} unit  a power of ten */
export function rounded(value, unit) {
  return Number((Math.round(value / unit) * unit).toFixed(Math.max(0, -Math.round(Math.log10(unit))))) + 0; // no -0, which JSON does not store
}

/**
 * Rounds the joints of an arm that follows its end effector: finely, so that the end effector stays in place.
 * @param {ArrayLike<number>} pose
 */
export function fine(pose) {
  return Array.from(pose, (angle) => rounded(angle, 1e-7));
}

/** @param {Obstacle} obstacle @param {number} dx @param {number} dy @param {number} unit @returns {Obstacle} */
export function moved(obstacle, dx, dy, unit) {
  const move = (/** @type {Point} */ [x, y]) => /** @type {Point} */ ([rounded(x + dx, unit), rounded(y + dy, unit)]);
  return obstacle.type === "disc"
    ? { ...obstacle, center: move(obstacle.center) }
    : { ...obstacle, vertices: obstacle.vertices.map(move) };
}

/** @param {Point} center @param {number} width @param {number} height @returns {Obstacle} */
export function rectangle([x, y], width, height) {
  const [a, b, c, d] = [x - width / 2, y - height / 2, x + width / 2, y + height / 2];
  return {
    type: "polygon",
    vertices: [
      [a, b],
      [c, b],
      [c, d],
      [a, d],
    ],
  };
}

/**
 * The coordinates of an object, or of one vertex of a polygon; those of a disc end with its radius.
 * @param {ScenarioDocument} document
 * @param {EditorObject | null} object
 * @param {number} vertex
 * @returns {number[]}
 */
export function numbersOf(document, object, vertex) {
  const obstacle = obstacleOf(document, object);
  if (!obstacle) return poseOf(document, object) ?? targetOf(document, object)?.point ?? [];
  return obstacle.type === "disc" ? [...obstacle.center, obstacle.radius] : obstacle.vertices[vertex];
}

/**
 * The document with other coordinates of a target, a disc or a vertex.
 * @param {ScenarioDocument} document
 * @param {EditorObject} object
 * @param {number} vertex
 * @param {number[]} numbers
 * @returns {ScenarioDocument}
 */
export function withNumbers(document, object, vertex, [x, y, radius]) {
  const target = targetOf(document, object);
  if (target) return withTarget(document, object, { ...target, point: [x, y] });
  const obstacle = obstacleOf(document, object);
  if (!obstacle) return document;
  return withObstacle(
    document,
    object.index,
    obstacle.type === "disc" ? { ...obstacle, center: [x, y], radius } : withVertex(obstacle, vertex, [x, y]),
  );
}

/** The middle of the edge after a vertex. @param {Point[]} vertices @param {number} index @returns {Point} */
export function middle(vertices, index) {
  const [x, y] = vertices[index];
  const [nx, ny] = vertices[(index + 1) % vertices.length];
  return [(x + nx) / 2, (y + ny) / 2];
}

/**
 * A polygon with one vertex replaced, inserted or removed.
 * @param {Extract<Obstacle, { type: "polygon" }>} polygon
 * @param {number} index
 * @param {Point | null} vertex
 * @param {boolean} [added]
 * @returns {Obstacle}
 */
export function withVertex(polygon, index, vertex, added = false) {
  const vertices = [...polygon.vertices];
  vertices.splice(index, added ? 0 : 1, ...(vertex ? [vertex] : []));
  return { ...polygon, vertices };
}

/**
 * Copies of an obstacle around it, from near to far.
 * @param {Obstacle} obstacle
 * @param {number} size  of the world
 * @param {number} unit
 */
export function around(obstacle, size, unit) {
  return RINGS.flatMap((part) =>
    DIRECTIONS.map((turn) => {
      const angle = (turn * Math.PI) / 4;
      return moved(obstacle, part * size * Math.cos(angle), part * size * Math.sin(angle), unit);
    }),
  );
}

/**
 * The obstacle that a tool adds without a drag.
 * @param {EditTool} tool
 * @param {Point} at
 * @param {number} size
 * @param {number} unit
 * @returns {Obstacle}
 */
export function simple(tool, [x, y], size, unit) {
  const side = rounded(size / 12, unit);
  const half = rounded(side / 2, unit);
  if (tool === "disc") return moved({ type: "disc", center: [0, 0], radius: half }, x, y, unit);
  return moved(
    tool === "rectangle"
      ? rectangle([0, 0], side, side)
      : {
          type: "polygon",
          vertices: [
            [-half, -half],
            [half, -half],
            [0, half],
          ],
        },
    x,
    y,
    unit,
  );
}
