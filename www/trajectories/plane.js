/**
 * The plane with its trajectories. Accepted ones are drawn once, when they are received. On top the newest glow for a
 * moment, the last rejected one is dashed, with a cross where it meets the earlier one, and the particles move if the
 * animation is on.
 */
import { View } from "planarium/draw";
import { NO_VIEW } from "../draw/figure.js";
import { cross, setStroke } from "../draw/marks.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { Experiment } from "./experiment.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** Milliseconds for which a new trajectory glows. */
const GLOWING = 650;
/** Trajectories that glow at once, at most. */
const MOST_GLOWING = 48;
const MARGIN = { left: 14, right: 14, top: 14, bottom: 14 };
/** Seconds that the particles rest between two rounds. */
const REST = 0.6;

export class Plane {
  /** @param {Experiment} experiment */
  constructor(experiment) {
    this.experiment = experiment;
    /** Without glow: nothing changes by itself. */
    this.isStill = true;
    /** Seconds of the animation, or null. @type {number | null} */
    this.moment = null;
    this.now = 0;
    this.view = NO_VIEW;
  }

  get layers() {
    const { epoch } = this.experiment;
    const { length } = this.experiment.accepted;
    return {
      ground: { key: epoch, draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      growth: {
        key: epoch,
        logs: [{ count: length, append: this.drawAccepted.bind(this) }],
      },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** The square in which all start. @param {Brush} brush */
  drawGround({ context, palette, width, height }) {
    const {
      half_side: half = 3,
      fastest = 1,
      duration = 1,
    } = /** @type {Record<string, number>} */ (this.experiment.options);
    const reach = half + Math.min(0.6 * fastest * duration, 3 * half);
    const view = (this.view = new View({ min: [-reach, -reach], max: [reach, reach] }, width, height, MARGIN, false));
    setStroke(context, palette.line, 1);
    context.strokeRect(view.x(-half), view.y(half), 2 * half * view.scaleX, 2 * half * view.scaleY);
  }

  /** @param {Brush} brush @param {number} from @param {number} to */
  drawAccepted({ context, palette }, from, to) {
    const lines = this.experiment.accepted.slice(from, to).map(({ line }) => line);
    this.drawLines(context, lines, palette.growth, 1.25, 1);
    this.drawDots(context, lines, palette.start, 1.4);
  }

  /** Whether anything glows or moves. @param {number} now */
  isMoving(now) {
    const { accepted, rejected } = this.experiment;
    return (
      this.moment !== null ||
      (!this.isStill && Math.max(accepted.at(-1)?.born ?? -Infinity, rejected?.born ?? -Infinity) + GLOWING > now)
    );
  }

  /** The strength of the glow of what was received at a time. @param {number} time @param {boolean} isLast */
  glowOf(time, isLast) {
    return this.isStill ? Number(isLast) : Math.max(0, 1 - (this.now - time) / GLOWING);
  }

  /** @param {Brush} brush */
  drawTop({ context, palette }) {
    const { accepted, rejected, isLastRejected } = this.experiment;
    for (const one of accepted.slice(-MOST_GLOWING)) {
      const strength = this.glowOf(one.born, one === accepted.at(-1) && !isLastRejected);
      if (strength === 0) continue;
      this.drawLines(context, [one.line], palette.halo, 7, 0.35 * strength);
      this.drawLines(context, [one.line], palette.newest, 2.2, strength);
    }
    const strength = rejected ? this.glowOf(rejected.born, isLastRejected) : 0;
    if (rejected && strength > 0) {
      this.drawLines(context, [accepted[rejected.other].line], palette.collision, 2.2, 0.8 * strength);
      this.drawLines(context, [rejected.line], palette.rejected, 2, strength, [5, 4]);
      setStroke(context, palette.collision, 2.4);
      context.globalAlpha = strength;
      cross(context, this.view.x(rejected.place[0]), this.view.y(rejected.place[1]), 5);
    }
    context.globalAlpha = 1;
    if (this.moment !== null) this.drawParticles(context, palette.robot, this.moment);
  }

  /**
   * The particles at a moment of the animation.
   * @param {Context} context
   * @param {string} colour
   * @param {number} moment
   */
  drawParticles(context, colour, moment) {
    const part = Math.min(1, Math.max(0, (moment - REST / 2) / (this.round - REST)));
    this.drawDots(
      context,
      this.experiment.accepted.map(({ line }) => {
        const pieces = line.length / 2 - 1;
        const i = Math.min(pieces - 1, Math.floor(part * pieces));
        const rest = part * pieces - i;
        return [0, 1].map((axis) => (1 - rest) * line[2 * i + axis] + rest * line[2 * i + 2 + axis]);
      }),
      colour,
      2.1,
    );
  }

  /** Seconds of a round of the animation. */
  get round() {
    return (this.experiment.options.duration ?? 1) + REST;
  }

  /**
   * @param {Context} context
   * @param {Float32Array[]} lines
   * @param {string} colour
   * @param {number} width
   * @param {number} alpha
   * @param {number[]} [dash]
   */
  drawLines(context, lines, colour, width, alpha, dash) {
    context.globalAlpha = alpha;
    setStroke(context, colour, width, dash);
    context.lineCap = context.lineJoin = "round";
    context.beginPath();
    for (const line of lines) {
      for (let i = 0; i < line.length; i += 2)
        context[i === 0 ? "moveTo" : "lineTo"](this.view.x(line[i]), this.view.y(line[i + 1]));
    }
    context.stroke();
  }

  /**
   * Discs at the first points of lines.
   * @param {Context} context
   * @param {ArrayLike<number>[]} lines
   * @param {string} colour
   * @param {number} radius
   */
  drawDots(context, lines, colour, radius) {
    context.fillStyle = colour;
    context.beginPath();
    for (const line of lines) {
      const [x, y] = [this.view.x(line[0]), this.view.y(line[1])];
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fill();
  }
}
