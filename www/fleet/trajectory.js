/** Where a robot is at every time, and when it waits; in rows as of the core. */
import { difference } from "planarium/draw";

/** @import { FleetRobotDocument } from "planarium/full" */
/** @import { Part, Point } from "../domain/types.js" */

/** x, y, theta; theta of a disc is 0. @typedef {[number, number, number]} Pose */
/**
 * An interval of time in which a robot moves or stands.
 * @typedef {{ from: number, to: number, isWait: boolean }} Span
 */

/** Numbers in a row: t, x, y, theta. */
const WIDTH = 4;

export class Trajectory {
  /**
   * @param {ArrayLike<number>} rows  linear between rows, angles the short way round; the robot stands at the last for
   *   ever
   */
  constructor(rows) {
    this.rows = rows;
    this.count = rows.length / WIDTH;
    /** Where it moves and waits until it arrives, in order. @type {Span[]} */
    this.spans = [];
    for (let i = 1; i < this.count; i++) {
      const [from, to] = [this.timeOf(i - 1), this.timeOf(i)];
      const isWait = [1, 2, 3].every((j) => rows[i * WIDTH + j] === rows[(i - 1) * WIDTH + j]);
      const last = this.spans.at(-1);
      if (last?.isWait === isWait) last.to = to;
      else this.spans.push({ from, to, isWait });
    }
    if (this.spans.at(-1)?.isWait) this.spans.pop();
    /** When it arrives, seconds. */
    this.arrival = this.spans.at(-1)?.to ?? 0;
    /** How long it waits before it arrives, seconds. */
    this.waits = this.spans.reduce((sum, { from, to, isWait }) => sum + (isWait ? to - from : 0), 0);
  }

  /** @param {number} row */
  timeOf(row) {
    return this.rows[row * WIDTH];
  }

  /** @param {number} row @returns {Point} */
  pointOf(row) {
    return [this.rows[row * WIDTH + 1], this.rows[row * WIDTH + 2]];
  }

  /** The last row that is not later than a time. @param {number} time */
  rowAt(time) {
    let [low, high] = [0, this.count - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.timeOf(middle) <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** @param {number} time @returns {Pose} */
  at(time) {
    const row = this.rowAt(time);
    const [t, x, y, theta] = Array.from({ length: WIDTH }, (_, j) => this.rows[row * WIDTH + j]);
    if (row === this.count - 1 || time <= t) return [x, y, theta];
    const next = (row + 1) * WIDTH;
    const part = (time - t) / (this.rows[next] - t);
    return [
      x + part * (this.rows[next + 1] - x),
      y + part * (this.rows[next + 2] - y),
      theta + part * difference(theta, this.rows[next + 3], true),
    ];
  }

  /** @param {number} time */
  isWaiting(time) {
    return this.spans.some(({ from, to, isWait }) => isWait && from <= time && time < to);
  }

  /** The points between two times. @param {number} from @param {number} to @returns {Point[]} */
  between(from, to) {
    const [[x0, y0], [x1, y1]] = [this.at(from), this.at(to)];
    /** @type {Point[]} */
    const points = [[x0, y0]];
    for (let row = this.rowAt(from) + 1; row < this.count && this.timeOf(row) < to; row++)
      points.push(this.pointOf(row));
    return [...points, [x1, y1]];
  }
}

/** A configuration as a pose. @param {ArrayLike<number>} q @returns {Pose} */
export function poseOf(q) {
  return [q[0], q[1], q[2] ?? 0];
}

/** Straight to the goal, at the speed of the robot, whatever is in the way. @param {FleetRobotDocument} member */
export function straightOf({ robot, start, goal, speed = 1 }) {
  const [[x0, y0, from], [x1, y1, to]] = [poseOf(start), poseOf(goal)];
  const reach = robot.type === "rigid_body" ? Math.max(...robot.shape.vertices.map(([x, y]) => Math.hypot(x, y))) : 0;
  const travel = Math.hypot(x1 - x0, y1 - y0) + reach * Math.abs(difference(from, to, true));
  return new Trajectory([0, x0, y0, from, travel / speed, x1, y1, to]);
}

/** A robot at a pose, to draw. @param {FleetRobotDocument["robot"]} robot @param {Pose} pose @returns {Part[]} */
export function partsAt(robot, [x, y, theta]) {
  if (robot.type === "disc") return [{ type: "disc", center: [x, y], radius: robot.radius }];
  if (robot.type !== "rigid_body") return [];
  const [cos, sin] = [Math.cos(theta), Math.sin(theta)];
  return [
    {
      type: "polygon",
      vertices: robot.shape.vertices.map(
        ([a, b]) => /** @type {Point} */ ([x + cos * a - sin * b, y + sin * a + cos * b]),
      ),
    },
  ];
}

/** The radius of a circle in a robot, in which its number fits, metres. @param {FleetRobotDocument["robot"]} robot */
export function roomOf(robot) {
  if (robot.type === "disc") return robot.radius;
  if (robot.type !== "rigid_body") return 0;
  const { vertices } = robot.shape;
  return Math.min(
    ...vertices.map(([ax, ay], i) => {
      const [bx, by] = vertices[(i + 1) % vertices.length];
      return Math.abs(ax * by - ay * bx) / Math.hypot(bx - ax, by - ay);
    }),
  );
}
