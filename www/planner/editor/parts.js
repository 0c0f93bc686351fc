/**
 * The parts by which an obstacle is edited, counted from 0: the vertices of a polygon and then those of its holes, the
 * points of a wall. Every change returns a new obstacle.
 */
import { contains, linesOf } from "../../domain/obstacles.js";
import { rounded } from "./units.js";

/** @import { Obstacle, Point } from "../../domain/types.js" */
/** @typedef {Extract<Obstacle, { type: "polygon" }>} Polygon */
/** @typedef {Extract<Obstacle, { type: "wall" }>} Wall */
/**
 * @typedef {object} Place   of a part
 * @property {Point[]} points   of its line
 * @property {boolean} isClosed
 * @property {number} line     0: the outline or the wall; i + 1: hole i
 * @property {number} at       index in the line
 */

/** The least number of points of a hole. */
const RING = 3;

/** All points of an obstacle by which it is edited; none of a disc. @param {Obstacle} obstacle @returns {Point[]} */
export function pointsOf(obstacle) {
  return linesOf(obstacle).flatMap(({ points }) => points);
}

/** @param {Obstacle} obstacle @param {number} part @returns {Place | null} */
export function placeOf(obstacle, part) {
  let at = part;
  for (const [line, { points, isClosed }] of linesOf(obstacle).entries()) {
    if (at < points.length) return { points, isClosed, line, at };
    at -= points.length;
  }
  return null;
}

/** The name of a part. @param {Obstacle} obstacle @param {number} part */
export function partText(obstacle, part) {
  const { line = 0, at = part } = placeOf(obstacle, part) ?? {};
  if (obstacle.type === "wall") return `point ${at}`;
  return line > 0 ? `hole ${line - 1}, vertex ${at}` : `vertex ${at}`;
}

/** Whether an edge begins at a part: at all but the last point of an open wall. @param {Place} place */
export function hasEdge({ points, isClosed, at }) {
  return isClosed || at < points.length - 1;
}

/** The middle of the edge after a part; after the last point of an open wall, as far beyond it. @param {Place} place @returns {Point} */
export function middle(place) {
  const { points, at } = place;
  const [x, y] = points[at];
  if (hasEdge(place)) {
    const [nx, ny] = points[(at + 1) % points.length];
    return [(x + nx) / 2, (y + ny) / 2];
  }
  const [bx, by] = points[at - 1] ?? points[at];
  return [x + (x - bx) / 2, y + (y - by) / 2];
}

/**
 * An obstacle with one point replaced, removed, or added before it.
 * @param {Obstacle} obstacle
 * @param {number} part
 * @param {Point | null} point  null: it is removed, with its hole if two points of that are left
 * @param {boolean} [isAdded]
 * @returns {Obstacle}
 */
export function withPoint(obstacle, part, point, isAdded = false) {
  // A point that is added after the last one of a line belongs to that line.
  const place = placeOf(obstacle, isAdded ? Math.max(0, part - 1) : part);
  if (!place) return obstacle;
  const points = [...place.points];
  points.splice(isAdded ? place.at + Math.min(1, part) : place.at, isAdded ? 0 : 1, ...(point ? [point] : []));
  return withLine(obstacle, place.line, place.line > 0 && points.length < RING ? null : points);
}

/** @param {Obstacle} obstacle @param {number} line @param {Point[] | null} points  null: the hole is filled @returns {Obstacle} */
function withLine(obstacle, line, points) {
  if (obstacle.type === "disc") return obstacle;
  if (obstacle.type === "wall") return { ...obstacle, points: points ?? [] };
  if (line === 0) return { ...obstacle, vertices: points ?? [] };
  const holes = [...(obstacle.holes ?? [])];
  holes.splice(line - 1, 1, ...(points ? [points] : []));
  return withHoles(obstacle, holes);
}

/** @param {Polygon} polygon @param {Point[][]} holes @returns {Polygon} */
function withHoles({ type, vertices }, holes) {
  return { type, vertices, ...(holes.length > 0 ? { holes } : {}) };
}

/** A polygon without the hole of a part. @param {Polygon} polygon @param {number} part */
export function filled(polygon, part) {
  const { line = 0 } = placeOf(polygon, part) ?? {};
  return line > 0 ? withHoles(polygon, (polygon.holes ?? []).toSpliced(line - 1, 1)) : polygon;
}

/**
 * Cuts a polygon out of the first obstacle in which its vertices lie. What lies in its own holes remains, as obstacles.
 * @param {Obstacle[]} obstacles
 * @param {number} index  of the polygon
 * @returns {{ obstacles: Obstacle[], index: number, part: number } | null}  the obstacle that has the hole now, and its
 *   first vertex; null: there is none to cut it out of
 */
export function cut(obstacles, index) {
  const inner = obstacles[index];
  if (inner?.type !== "polygon") return null;
  const host = obstacles.findIndex(
    (outer, i) =>
      i !== index && outer.type === "polygon" && inner.vertices.every(([x, y]) => contains(outer.vertices, x, y)),
  );
  const outer = obstacles[host];
  if (outer?.type !== "polygon") return null;
  const holes = [...(outer.holes ?? []), inner.vertices];
  const left = (inner.holes ?? []).map((vertices) => /** @type {Obstacle} */ ({ type: "polygon", vertices }));
  return {
    obstacles: [...obstacles.with(host, withHoles(outer, holes)).toSpliced(index, 1), ...left],
    index: host - Number(index < host),
    part: pointsOf(outer).length,
  };
}

/** @param {Obstacle} obstacle @param {number} dx @param {number} dy @param {number} unit @returns {Obstacle} */
export function moved(obstacle, dx, dy, unit) {
  const move = (/** @type {Point} */ [x, y]) => /** @type {Point} */ ([rounded(x + dx, unit), rounded(y + dy, unit)]);
  if (obstacle.type === "disc") return { ...obstacle, center: move(obstacle.center) };
  if (obstacle.type === "wall") return { ...obstacle, points: obstacle.points.map(move) };
  const { vertices, holes = [] } = obstacle;
  return withHoles(
    { ...obstacle, vertices: vertices.map(move) },
    holes.map((ring) => ring.map(move)),
  );
}

/** The point that moves with an obstacle: its centre, or its first point. @param {Obstacle} obstacle @returns {Point} */
export function anchorOf(obstacle) {
  return obstacle.type === "disc" ? obstacle.center : linesOf(obstacle)[0].points[0];
}
