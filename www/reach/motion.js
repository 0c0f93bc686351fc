/**
 * The straight motion between two configurations, each angle the short or the long way round: the curve of the tip, and
 * where the robot first collides, which the core proves piece by piece.
 */
import { difference } from "planarium/draw";

/** @import { Check } from "../domain/types.js" */
/** @import { Robot } from "./robot.js" */
/**
 * The way of an angle. "faulty" is that of a course report, which may end elsewhere than at B.
 * @typedef {"short" | "long" | "faulty"} Direction
 */

const TURN = 2 * Math.PI;
/**
 * Longest turn of an angle in a piece of the proof, radians: below half a turn, so that each piece turns the short way
 * round.
 */
const PIECE = 2;
/** Points of the tip's curve. */
const POINTS = 160;
/** Difference of coordinates below which they count as equal. */
const EQUAL = 1e-9;
/** The step beyond the proven part at first, as a part of the motion, to find what is touched. */
const BEYOND = 1e-6;

export class Motion {
  /**
   * @param {Robot} robot
   * @param {ArrayLike<number>} a
   * @param {ArrayLike<number>} b
   * @param {Direction[]} directions  without effect on coordinates that do not wrap
   */
  constructor(robot, a, b, directions) {
    const { coordinates, scenario, dimension } = robot;
    this.a = Float64Array.from(a);
    /** How far each coordinate moves, radians or metres. */
    this.turns = coordinates.map(({ isCircle }, i) => turnOf(a[i], b[i], isCircle, directions[i]));
    /** The coordinates that end elsewhere than at B, by the faulty way. */
    this.missed = coordinates.flatMap(({ isCircle }, i) =>
      Math.abs(difference(a[i] + this.turns[i], b[i], isCircle)) > EQUAL ? [i] : [],
    );
    const rows = new Float64Array((POINTS + 1) * dimension);
    for (let i = 0; i <= POINTS; i++) rows.set(this.at(i / POINTS), i * dimension);
    /** The tip's curve, x and y in turn. */
    this.curve = scenario.endEffectors(rows);
    /** Which of its points are in collision. */
    this.collides = Array.from(
      { length: POINTS + 1 },
      (_, i) => !robot.isFree(rows.subarray(i * dimension, (i + 1) * dimension)),
    );
    /** The part of the motion, 0 to 1, that is proven free; null if all of it is. */
    this.hit = this.firstHit(robot);
    /** The first collision, if there is any. */
    this.touch = this.hit === null ? null : this.firstTouch(robot, this.hit);
  }

  /** The sum of the turns, radians or metres. */
  get length() {
    return this.turns.reduce((sum, turn) => sum + Math.abs(turn), 0);
  }

  /** The configuration at a part of the motion, 0 to 1; its angles may exceed half a turn. @param {number} t */
  at(t) {
    return Float64Array.from(this.a, (from, i) => from + t * this.turns[i]);
  }

  /** @param {Robot} robot @returns {number | null} */
  firstHit(robot) {
    const turns = this.turns.filter((_, i) => robot.coordinates[i].isCircle);
    const pieces = Math.max(1, Math.ceil(Math.max(0, ...turns.map(Math.abs)) / PIECE));
    for (let i = 0; i < pieces; i++) {
      const hit = robot.scenario.firstHit(robot.fitted(this.at(i / pieces)), robot.fitted(this.at((i + 1) / pieces)));
      if (hit !== null) return (i + hit) / pieces;
    }
    return null;
  }

  /**
   * Beyond the part that is proven free the robot may still be free, but too near for the proof.
   * @param {Robot} robot
   * @param {number} hit
   * @returns {Check | null}
   */
  firstTouch(robot, hit) {
    for (let step = 0; ; step = Math.max(BEYOND, 1.5 * step)) {
      const t = Math.min(1, hit + step);
      const check = robot.scenario.check(robot.fitted(this.at(t)));
      if (!check.free) return check;
      if (t === 1) return null;
    }
  }
}

/**
 * How far a coordinate moves from A to B. The faulty way: by the distance that wraps, in the direction of the sign of
 * the difference that does not, so that it ends elsewhere than at B where the two angles differ by more than half a
 * turn.
 * @param {number} from @param {number} to @param {boolean} isCircle @param {Direction} direction
 */
export function turnOf(from, to, isCircle, direction) {
  const short = difference(from, to, isCircle);
  if (!isCircle || direction === "short" || short === 0) return short;
  if (direction === "faulty") return Math.sign(to - from) * Math.abs(short);
  return short > 0 ? short - TURN : short + TURN;
}
