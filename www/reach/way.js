/**
 * The straight way from one configuration to another, each joint the short or the long way round: where it goes, where its tip
 * goes, and where it first touches something, which the core proves piece by piece.
 */
import { way } from "../draw/trace.js";

/** @import { Arm } from "./arm.js" */
/** @typedef {"short" | "long"} Round */

const TURN = 2 * Math.PI;
/** Longest turn of a joint in a piece that is proven at once, radians: well below half a turn, so that the short way of each piece is the way that is meant. */
const PIECE = 2;
/** Points of the tip's curve. */
const POINTS = 160;

export class Way {
  /** @param {Arm} arm @param {ArrayLike<number>} a @param {ArrayLike<number>} b @param {Round[]} rounds  of each joint; one with stops has only the way between them */
  constructor(arm, a, b, rounds) {
    this.a = Float64Array.from(a);
    this.b = Float64Array.from(b);
    /** How far each joint turns, radians. */
    this.turns = arm.joints.map(({ isCircle }, i) => turnOf(this.a[i], this.b[i], isCircle, rounds[i] ?? "short"));
    this.version = arm.version;
    /** Of the tip, x and y in turn. */
    this.curve = new Float64Array(2 * (POINTS + 1));
    const rows = new Float64Array((POINTS + 1) * arm.dimension);
    for (let i = 0; i <= POINTS; i++) rows.set(this.at(i / POINTS), i * arm.dimension);
    this.curve = arm.scenario.endEffectors(rows);
    /** Which of its points are in collision. */
    this.touches = Array.from({ length: POINTS + 1 }, (_, i) => !arm.isFree(rows.subarray(i * arm.dimension, (i + 1) * arm.dimension)));
    /** Up to here it is proven free: a part from 0 to 1, or null where all of it is. @type {number | null} */
    this.hit = this.firstHit(arm);
  }

  /** The sum of its joints' turns, radians. */
  get length() { return this.turns.reduce((sum, turn) => sum + Math.abs(turn), 0); }

  /** The configuration at a part of the way, from 0 to 1; angles of circles go on past half a turn. @param {number} t */
  at(t) { return Float64Array.from(this.a, (from, i) => from + t * this.turns[i]); }

  /** @param {Arm} arm @returns {number | null} */
  firstHit(arm) {
    const most = this.turns.reduce((least, turn) => Math.max(least, Math.abs(turn)), 0);
    const pieces = Math.max(1, Math.ceil(most / PIECE));
    for (let i = 0; i < pieces; i++) {
      const hit = arm.scenario.firstHit(arm.fitted(this.at(i / pieces)), arm.fitted(this.at((i + 1) / pieces)));
      if (hit !== null) return (i + hit) / pieces;
    }
    return null;
  }
}

/** How far a joint turns. @param {number} from @param {number} to @param {boolean} isCircle @param {Round} round */
export function turnOf(from, to, isCircle, round) {
  const short = way(from, to, isCircle);
  if (!isCircle || round === "short" || short === 0) return short;
  return short > 0 ? short - TURN : short + TURN;
}
