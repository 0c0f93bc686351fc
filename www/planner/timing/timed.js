/**
 * A trajectory between its rows: cubics that have the configurations and the velocities of two rows. Where the
 * acceleration is constant that is the trajectory itself, and elsewhere it is far nearer to it than a pixel.
 */
import { wrap } from "planarium/draw";
import { setStroke } from "../../draw/marks.js";

/** @import { View } from "planarium/draw" */
/** @import { Part, Scenario } from "../../domain/types.js" */
/** @import { Timing } from "../../paths/timing.js" */

/**
 * The robot at a time: velocities and accelerations of its coordinates, a second.
 * @typedef {{ time: number, pose: Float64Array, velocity: Float64Array, acceleration: Float64Array }} State
 */

/** The least radius of a disc as it is drawn, CSS pixels. */
const LEAST = 4;
/** Speeds below this are rest, metres a second. */
const REST = 1e-9;

export class Timed {
  /**
   * @param {Scenario} scenario   that is not freed before
   * @param {Timing} timing
   * @param {number} wheelbase    of a car, metres
   */
  constructor(scenario, { duration, rests, step, rows, dimension }, wheelbase) {
    this.duration = duration;
    this.rests = rests;
    this.step = step;
    this.rows = rows;
    this.wheelbase = wheelbase;
    /** More than the scenario's where a disc has a heading. */
    this.dimension = dimension;
    this.circles = scenario.circles();
    this.width = 1 + 3 * this.dimension;
    this.count = rows.length / this.width;
    /** Of the slowest robot in a race, seconds. */
    this.period = duration;
    /** Seconds of the robot in one that passes. */
    this.pace = 1;
  }

  /** @param {number} row @param {0 | 1 | 2} derivative */
  values(row, derivative) {
    const first = row * this.width + 1 + derivative * this.dimension;
    return this.rows.subarray(first, first + this.dimension);
  }

  /** @param {number} time   before 0 as at 0, after the end as there @returns {State} angles are not wrapped */
  state(time) {
    const { count, width, step, rows } = this;
    const row = Math.min(Math.max(0, count - 2), Math.max(0, Math.floor(time / step)));
    const next = Math.min(count - 1, row + 1);
    const begin = rows[row * width];
    const lasting = rows[next * width] - begin;
    const part = lasting > 0 ? Math.min(1, Math.max(0, (time - begin) / lasting)) : 0;
    const [from, to] = [this.values(row, 0), this.values(next, 0)];
    const [leaves, arrives] = [this.values(row, 1), this.values(next, 1)];
    const rest = 1 - part;
    // Hermite's cubics.
    const weights = [
      rest * rest * (1 + 2 * part),
      part * part * (3 - 2 * part),
      lasting * part * rest * rest,
      -lasting * part * part * rest,
    ];
    const pose = from.map(
      (value, i) => weights[0] * value + weights[1] * to[i] + weights[2] * leaves[i] + weights[3] * arrives[i],
    );
    return {
      time: begin + part * lasting,
      pose,
      velocity: leaves.map((value, i) => value + part * (arrives[i] - value)),
      acceleration: this.values(part < 1 ? row : next, 2).slice(),
    };
  }

  /** The configuration at a part of the period. @param {number} part  0 to 1 */
  pose(part) {
    const pose = this.state(part * this.period).pose.subarray(0, this.circles.length);
    this.circles.forEach((isCircle, i) => {
      if (isCircle) pose[i] = wrap(pose[i]);
    });
    return pose;
  }

  /** The heading of a disc that has one, radians; null of others. @param {number} part  0 to 1, of the period */
  heading(part) {
    return this.dimension > this.circles.length ? this.state(part * this.period).pose[this.circles.length] : null;
  }

  /**
   * Draws the heading of a disc that has one: a line from its middle to its edge.
   * @param {number} part  0 to 1, of the period
   * @param {CanvasRenderingContext2D} context @param {View} view
   * @param {Part} shape   of the robot @param {string} colour
   */
  drawHeading(part, context, view, shape, colour) {
    const heading = this.heading(part);
    if (heading === null || shape.type !== "disc") return;
    const [x, y] = shape.center;
    const reach = Math.max(shape.radius, LEAST / view.scaleX);
    setStroke(context, colour, 2);
    context.beginPath();
    context.moveTo(...view.place([x, y]));
    context.lineTo(...view.place([x + reach * Math.cos(heading), y + reach * Math.sin(heading)]));
    context.stroke();
  }

  /** The steering angle of a car, radians. @param {number} part  0 to 1, of the period */
  steering(part) {
    if (this.wheelbase === 0) return 0;
    const { pose, velocity, acceleration } = this.state(part * this.period);
    // At rest the motion begins or ends along the same arc.
    const [vx, vy, turn] = Math.hypot(velocity[0], velocity[1]) > REST ? velocity : acceleration;
    const along = vx * Math.cos(pose[2]) + vy * Math.sin(pose[2]);
    return Math.abs(along) > REST ? Math.atan((this.wheelbase * turn) / along) : 0;
  }
}
