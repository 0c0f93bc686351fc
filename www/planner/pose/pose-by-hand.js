/**
 * The reader's turn: the robot in the hand, what it touches on its way, and whether it was brought to the goal. A pointer that
 * holds nothing points at something.
 */
import { once } from "../../app/once.js";
import { contained, coordinatesOf } from "../../domain/coordinates.js";

/** @import { Pointer } from "../../domain/types.js" */
/** @import { Pointing } from "./pointing.js" */
/** @import { Shown } from "../lane.js" */
/** @import { Session } from "../session.js" */

export class PoseByHand {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** Once somebody has pointed at something. @type {Pointing | null} */
    this.pointing = null;
    /** What pointers need, fetched with the first of them. */
    this.ready = once(async () => (this.pointing = new (await import("./pointing.js")).Pointing()));
    /** How often the hand touched something, and whether it brought the robot to the goal. */
    this.game = { touches: 0, arrived: false };
  }

  /** The reader's turn, or the planner's again. */
  change() {
    const { session } = this;
    const { shown } = session;
    if (!shown) return;
    if (shown.hand) {
      this.release();
      session.timeline.play();
      session.wake();
      return;
    }
    this.hold(Float64Array.from(shown.start ?? coordinatesOf(shown).map(({ low, high }) => (low + high) / 2)));
  }

  /** The robot is held at a pose. @param {Float64Array} pose */
  hold(pose) {
    const { session } = this;
    const { shown } = session;
    if (!shown || pose.length !== shown.scenario.dimension) return;
    this.session.driving?.stop();
    if (!shown.hand) {
      this.game = { touches: 0, arrived: false };
      for (const { playback } of session.lanes) {
        if (!playback) continue;
        playback.drawn = 1;
        session.clock.halt();
      }
    }
    contained(pose, coordinatesOf(shown));
    const wasFree = shown.check?.free ?? true;
    shown.hand = pose;
    shown.check = shown.scenario.check(pose);
    if (wasFree && !shown.check.free) this.game.touches++;
    if (shown.check.free && isAtGoal(shown, pose)) this.game.arrived = true;
    session.wake();
  }

  /** A start or goal that touches something is shown as the robot in the hand. */
  showTouching() {
    const { shown } = this.session;
    if (!shown) return;
    for (const end of [shown.start, ...shown.goals]) {
      if (!end || end.length !== shown.scenario.dimension || shown.scenario.check(end).free) continue;
      this.hold(Float64Array.from(end));
      return;
    }
  }

  /** The robot is nobody's. */
  release() {
    const { shown } = this.session;
    if (!shown) return;
    this.session.driving?.stop();
    shown.hand = null;
    shown.check = null;
  }

  /** A pointer on a pane, pixels of the pane. @param {Pointer} pointer */
  point({ pane: id, type, x, y }) {
    const { session, pointing } = this;
    const place = session.stage.at(id);
    const { shown } = session;
    if (!place || !shown || !pointing || shown.driven) return;
    pointing.at = type === "hover" ? { place, x, y } : null;
    if (type !== "down" && type !== "move") return;
    const pose = pointing.hold(place, type, x, y);
    if (pose) this.hold(pose);
  }

  /** What is pointed at, unless the hand has something to do. @param {Shown} shown */
  hover(shown) {
    const { session } = this;
    shown.hover = shown.hand || session.editor?.on ? null : this.pointing?.find(session.lanes, shown.hover) ?? null;
  }
}

/** Is a pose at the goal, as nearly as a hand can put it there? @param {Shown} shown @param {Float64Array} pose */
function isAtGoal(shown, pose) {
  const { scenario, goal, target, placed } = shown;
  if (target) {
    const [x, y] = scenario.endEffector(pose);
    const { min, max } = scenario.extent();
    return Math.hypot(x - target.point[0], y - target.point[1]) <= 0.015 * Math.max(max[0] - min[0], max[1] - min[1]);
  }
  if (!goal) return false;
  if (placed) return placed.isNear(pose, goal, shown);
  const { min, max } = scenario.extent();
  const near = scenario.robot === "arm" ? 0.06 * scenario.dimension : 0.015 * Math.max(max[0] - min[0], max[1] - min[1]);
  return scenario.distance(pose, Float64Array.from(goal)) <= near;
}
