/**
 * The straight motion between two configurations, each joint the short or the long way round: the curve of the tip, and where the
 * arm first collides, which the core proves piece by piece.
 */
import { difference } from "planarium/draw";

/** @import { Arm } from "./arm.js" */
/** @typedef {"short" | "long"} Direction   of a joint */

const TURN = 2 * Math.PI;
/** Longest turn of a joint in a piece of the proof, radians: below half a turn, so that each piece turns the short way round. */
const PIECE = 2;
/** Points of the tip's curve. */
const POINTS = 160;

export class Motion {
  /** @param {Arm} arm @param {ArrayLike<number>} a @param {ArrayLike<number>} b @param {Direction[]} directions  without effect on joints with limits */
  constructor(arm, a, b, directions) {
    this.a = Float64Array.from(a);
    /** The turn of each joint, radians. */
    this.turns = arm.joints.map(({ isCircle }, i) => turnOf(a[i], b[i], isCircle, directions[i]));
    const rows = new Float64Array((POINTS + 1) * arm.dimension);
    for (let i = 0; i <= POINTS; i++) rows.set(this.at(i / POINTS), i * arm.dimension);
    /** The tip's curve, x and y in turn. */
    this.curve = arm.scenario.endEffectors(rows);
    /** Which of its points are in collision. */
    this.collides = Array.from({ length: POINTS + 1 }, (_, i) => !arm.isFree(rows.subarray(i * arm.dimension, (i + 1) * arm.dimension)));
    /** The part of the motion, 0 to 1, that is proven free; null if all of it is. */
    this.hit = this.firstHit(arm);
  }

  /** The sum of the turns of all joints, radians. */
  get length() { return this.turns.reduce((sum, turn) => sum + Math.abs(turn), 0); }

  /** The configuration at a part of the motion, 0 to 1; its angles may exceed half a turn. @param {number} t */
  at(t) { return Float64Array.from(this.a, (from, i) => from + t * this.turns[i]); }

  /** @param {Arm} arm @returns {number | null} */
  firstHit(arm) {
    const pieces = Math.max(1, Math.ceil(Math.max(...this.turns.map(Math.abs)) / PIECE));
    for (let i = 0; i < pieces; i++) {
      const hit = arm.scenario.firstHit(arm.fitted(this.at(i / pieces)), arm.fitted(this.at((i + 1) / pieces)));
      if (hit !== null) return (i + hit) / pieces;
    }
    return null;
  }
}

/** @param {number} from @param {number} to @param {boolean} isCircle @param {Direction} direction */
function turnOf(from, to, isCircle, direction) {
  const short = difference(from, to, isCircle);
  if (!isCircle || direction === "short" || short === 0) return short;
  return short > 0 ? short - TURN : short + TURN;
}
