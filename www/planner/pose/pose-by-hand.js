/**
 * Posing the robot by hand: its configuration, its collisions, and whether it has reached the goal. Other pointers
 * point at elements.
 */
import { once } from "../../app/once.js";
import { contained, coordinatesOf, sizeOf } from "../../domain/coordinates.js";

/** @import { Pointer } from "../../domain/types.js" */
/** @import { Pointing } from "./pointing.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */
/** @import { Stage } from "../stage/stage.js" */
/**
 * @typedef {object} Session   what posing takes of the page's session
 * @property {Shown | null} shown
 * @property {Lane[]} lanes
 * @property {PathPlayback[]} playbacks
 * @property {Stage} stage
 * @property {{ halt: () => void }} clock
 * @property {{ play: () => void }} timeline
 * @property {{ on: boolean } | null} editor
 * @property {{ on: boolean, stop: () => void } | null} driving
 * @property {() => void} wake
 */

export class PoseByHand {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** Loaded on demand. @type {Pointing | null} */
    this.pointing = null;
    /** Loads the handling of pointers. */
    this.ready = once(async () => (this.pointing = new (await import("./pointing.js")).Pointing()));
    /** The number of collisions, and whether the goal was reached. */
    this.game = { touches: 0, arrived: false };
  }

  /** Begins to pose the robot by hand, or ends it and plays. */
  change() {
    const { session } = this;
    const { shown } = session;
    if (shown?.hand) {
      this.release();
      session.timeline.play();
    } else if (shown)
      this.hold(Float64Array.from(shown.start ?? coordinatesOf(shown).map(({ low, high }) => (low + high) / 2)));
  }

  /** Poses the robot. @param {Float64Array} pose */
  hold(pose) {
    const { session } = this;
    const { shown } = session;
    if (!shown || pose.length !== shown.scenario.dimension) return;
    session.driving?.stop();
    if (!shown.hand) {
      this.game = { touches: 0, arrived: false };
      for (const playback of session.playbacks) {
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

  /** Poses the robot at a start or goal in collision. */
  showTouching() {
    const { shown } = this.session;
    const end = shown && [shown.start, ...shown.goals].find((one) => one && !shown.scenario.check(one).free);
    if (end) this.hold(Float64Array.from(end));
  }

  /** Ends posing and driving. */
  release() {
    const { pointing } = this;
    const { shown } = this.session;
    if (pointing) pointing.grip = null;
    if (!shown) return;
    this.session.driving?.stop();
    shown.hand = null;
    shown.check = null;
  }

  /** Handles a pointer event. @param {Pointer} pointer */
  point({ pane: id, type, x, y }) {
    const { session, pointing } = this;
    const place = session.stage.at(id);
    if (!place || !pointing || session.driving?.on) return;
    pointing.at = type === "hover" ? { place, x, y } : null;
    if (type !== "down" && type !== "move") return;
    const pose = pointing.hold(place, type, x, y);
    if (pose) this.hold(pose);
  }

  /**
   * Updates the element under the pointer; there is none while the robot is posed or the scene edited.
   * @param {Shown} shown
   */
  hover(shown) {
    const { session } = this;
    shown.hover = shown.hand || session.editor?.on ? null : (this.pointing?.find(session.lanes, shown.hover) ?? null);
  }
}

/** Whether a configuration is near the goal. @param {Shown} shown @param {Float64Array} pose */
function isAtGoal(shown, pose) {
  const { scenario, goal, target, placed } = shown;
  const near = 0.015 * sizeOf(scenario);
  if (target) {
    const [x, y] = scenario.endEffector(pose);
    return Math.hypot(x - target.point[0], y - target.point[1]) <= near;
  }
  if (!goal) return false;
  if (placed) return placed.isNear(pose, goal, shown);
  return (
    scenario.distance(pose, Float64Array.from(goal)) <= (scenario.robot === "arm" ? 0.06 * scenario.dimension : near)
  );
}
