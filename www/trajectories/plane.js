/**
 * The plane with its trajectories. Accepted ones are drawn once, when they are received. On top the newest glow for a moment, the
 * last rejected one is dashed, with a cross where it meets the earlier one, and the particles move if the animation is on.
 */
import { cross } from "../draw/marks.js";
import { View } from "../draw/view.js";

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
    /** @type {View | null} */
    this.view = null;
    /** Trajectories drawn. */
    this.drawn = 0;
  }

  /** All accepted trajectories. @param {Brush} brush */
  ground(brush) {
    const { context, palette, width, height } = brush;
    const { half_side: half = 3, fastest = 1, duration = 1 } = /** @type {Record<string, number>} */ (this.experiment.options);
    const reach = half + Math.min(0.6 * fastest * duration, 3 * half);
    const view = this.view = new View({ min: [-reach, -reach], max: [reach, reach] }, width, height, MARGIN, false);
    context.strokeStyle = palette.line;
    context.lineWidth = 1;
    context.strokeRect(view.x(-half), view.y(half), 2 * half * view.scaleX, 2 * half * view.scaleY);
    this.drawn = 0;
    this.append(brush);
  }

  /** Those not drawn yet. @param {Pick<Brush, "context" | "palette">} brush */
  append({ context, palette }) {
    const { experiment: { lines }, view, drawn } = this;
    if (drawn === lines.length || !view) return;
    context.beginPath();
    for (const line of lines.slice(drawn)) this.trace(context, line);
    this.stroke(context, palette.growth, 1.25);
    context.fillStyle = palette.start;
    context.beginPath();
    for (const [x, y] of lines.slice(drawn)) this.dot(context, x, y, 1.4);
    context.fill();
    this.drawn = lines.length;
  }

  /** Does anything glow or move? @param {number} now */
  isMoving(now) {
    const { born, rejectedAt } = this.experiment;
    return this.moment !== null || (!this.isStill && Math.max(born[born.length - 1] ?? -Infinity, rejectedAt) + GLOWING > now);
  }

  /** The strength of the glow of what was received at a time. @param {number} time @param {boolean} isLast */
  glowOf(time, isLast) { return this.isStill ? Number(isLast) : Math.max(0, 1 - (this.now - time) / GLOWING); }

  /** @param {Brush} brush */
  top({ context, palette }) {
    const { lines, born, rejected, rejectedAt, isLastRejected } = this.experiment;
    if (!this.view) return;
    for (let i = Math.max(0, lines.length - MOST_GLOWING); i < lines.length; i++) {
      const strength = this.glowOf(born[i], i === lines.length - 1 && !isLastRejected);
      if (strength === 0) continue;
      this.drawLine(context, lines[i], palette.halo, 7, 0.35 * strength);
      this.drawLine(context, lines[i], palette.newest, 2.2, strength);
    }
    const strength = this.glowOf(rejectedAt, isLastRejected);
    if (rejected && strength > 0) {
      if (lines[rejected.other]) this.drawLine(context, lines[rejected.other], palette.collision, 2.2, 0.8 * strength);
      context.setLineDash([5, 4]);
      this.drawLine(context, rejected.line, palette.rejected, 2, strength);
      context.setLineDash([]);
      context.strokeStyle = palette.collision;
      context.lineWidth = 2.4;
      context.globalAlpha = strength;
      cross(context, this.view.x(rejected.place[0]), this.view.y(rejected.place[1]), 5);
    }
    context.globalAlpha = 1;
    if (this.moment !== null) this.drawParticles(context, palette.robot, this.moment);
  }

  /** The particles at a moment of the animation. @param {Context} context @param {string} colour @param {number} moment */
  drawParticles(context, colour, moment) {
    const part = Math.min(1, Math.max(0, (moment - REST / 2) / (this.round - REST)));
    context.fillStyle = colour;
    context.beginPath();
    for (const line of this.experiment.lines) {
      const pieces = line.length / 2 - 1;
      const i = Math.min(pieces - 1, Math.floor(part * pieces));
      const rest = part * pieces - i;
      this.dot(context, line[2 * i] + rest * (line[2 * i + 2] - line[2 * i]), line[2 * i + 1] + rest * (line[2 * i + 3] - line[2 * i + 1]), 2.1);
    }
    context.fill();
  }

  /** Seconds of a round of the animation. */
  get round() { return (this.experiment.options.duration ?? 1) + REST; }

  /** @param {Context} context @param {string} colour @param {number} width */
  stroke(context, colour, width) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineCap = "round";
    context.lineJoin = "round";
    context.stroke();
  }

  /** @param {Context} context @param {Float32Array} line @param {string} colour @param {number} width @param {number} alpha */
  drawLine(context, line, colour, width, alpha) {
    context.globalAlpha = alpha;
    context.beginPath();
    this.trace(context, line);
    this.stroke(context, colour, width);
  }

  /** @param {Context} context @param {Float32Array} line */
  trace(context, line) {
    const view = /** @type {View} */ (this.view);
    context.moveTo(view.x(line[0]), view.y(line[1]));
    for (let i = 2; i < line.length; i += 2) context.lineTo(view.x(line[i]), view.y(line[i + 1]));
  }

  /** @param {Context} context @param {number} x @param {number} y @param {number} radius */
  dot(context, x, y, radius) {
    const view = /** @type {View} */ (this.view);
    context.moveTo(view.x(x) + radius, view.y(y));
    context.arc(view.x(x), view.y(y), radius, 0, 2 * Math.PI);
  }
}
