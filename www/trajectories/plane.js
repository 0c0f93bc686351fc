/**
 * The plane with its trajectories. Those accepted are drawn once, when they come; on top of them the newest glow and settle, the
 * one refused last is dashed, with a cross where it meets the earlier one, and the particles move where that is asked for.
 */

/** @import { Brush } from "../room/sheet.js" */
/** @import { Growth } from "./growth.js" */

/** Milliseconds for which what is new is seen to be new. */
export const SETTLING = 650;
/** So many glow at once. */
const MOST_GLOWING = 48;
/** Room about the picture, pixels. */
const MARGIN = 14;
/** Seconds that the particles rest between two rounds. */
const REST = 0.6;

export class Plane {
  /** @param {Growth} growth */
  constructor(growth) {
    this.growth = growth;
    /** Metres from the middle to the border. */
    this.reach = 3;
    /** Half the side of the square of starts. */
    this.half = 3;
    /** Does everything stay as it is, that is: is nothing to settle by itself? */
    this.isStill = true;
    /** Seconds into the motion of the particles, or null. @type {number | null} */
    this.moment = null;
    this.now = 0;
    /** As it was drawn last. */
    this.scale = 1;
    this.middle = [0, 0];
    this.drawn = 0;
  }

  /** Fits the picture to the options. */
  fit() {
    const { half_side: half = 3, fastest = 1, duration = 1 } = /** @type {Record<string, number>} */ (this.growth.options);
    this.half = half;
    this.reach = half + Math.min(0.6 * fastest * duration, 3 * half);
  }

  /** All that is accepted. @param {Brush} brush */
  ground(brush) {
    const { context, palette, width, height } = brush;
    this.scale = Math.max(1, Math.min(width, height) / 2 - MARGIN) / this.reach;
    this.middle = [width / 2, height / 2];
    const corner = this.at(-this.half, this.half);
    const side = 2 * this.half * this.scale;
    context.strokeStyle = palette.line;
    context.lineWidth = 1;
    context.strokeRect(corner[0], corner[1], side, side);
    this.drawn = 0;
    this.append(brush);
  }

  /** Those that were not drawn yet. @param {Pick<Brush, "context" | "palette">} brush */
  append({ context, palette }) {
    const { growth: { lines } } = this;
    if (this.drawn === lines.length) return;
    this.pen(context, palette.growth, 1.25);
    context.beginPath();
    for (let i = this.drawn; i < lines.length; i++) this.trace(context, lines[i]);
    context.stroke();
    context.fillStyle = palette.start;
    context.beginPath();
    for (let i = this.drawn; i < lines.length; i++) this.dot(context, lines[i][0], lines[i][1], 1.4);
    context.fill();
    this.drawn = lines.length;
  }

  /** Is something yet to settle? @param {number} now */
  isMoving(now) {
    const { born, refusedAt } = this.growth;
    return this.moment !== null || (!this.isStill && Math.max(born[born.length - 1] ?? -Infinity, refusedAt) + SETTLING > now);
  }

  /** @param {Brush} brush */
  top({ context, palette }) {
    const { growth, now, isStill } = this;
    const { lines, born, refused, refusedAt, isLastRefused } = growth;
    context.lineCap = "round";
    context.lineJoin = "round";
    for (let i = Math.max(0, lines.length - MOST_GLOWING); i < lines.length; i++) {
      const isLast = i === lines.length - 1 && isStill && !isLastRefused;
      const light = isLast ? 1 : isStill ? 0 : Math.max(0, 1 - (now - born[i]) / SETTLING);
      if (light === 0) continue;
      this.glow(context, lines[i], palette.halo, 0.35 * light, 7);
      this.glow(context, lines[i], palette.newest, light, 2.2);
    }
    const light = isStill ? Number(isLastRefused) : Math.max(0, 1 - (now - refusedAt) / SETTLING);
    if (refused && light > 0) {
      context.globalAlpha = light;
      if (lines[refused.other]) this.glow(context, lines[refused.other], palette.collision, 0.8 * light, 2.2);
      context.globalAlpha = light;
      context.setLineDash([5, 4]);
      this.pen(context, palette.rejected, 2);
      context.beginPath();
      this.trace(context, refused.line);
      context.stroke();
      context.setLineDash([]);
      const [x, y] = this.at(...refused.place);
      this.pen(context, palette.collision, 2.4);
      context.beginPath();
      for (const [dx, dy] of [[5, 5], [5, -5]]) {
        context.moveTo(x - dx, y - dy);
        context.lineTo(x + dx, y + dy);
      }
      context.stroke();
    }
    context.globalAlpha = 1;
    if (this.moment !== null) this.particles(context, palette.robot);
  }

  /** The particles where they are now. @param {CanvasRenderingContext2D} context @param {string} colour */
  particles(context, colour) {
    const { duration = 1 } = this.growth.options;
    const part = Math.min(1, Math.max(0, (this.moment ?? 0) - REST / 2) / duration);
    context.fillStyle = colour;
    context.beginPath();
    for (const line of this.growth.lines) {
      const pieces = line.length / 2 - 1;
      const i = Math.min(pieces - 1, Math.floor(part * pieces));
      const rest = part * pieces - i;
      this.dot(context, line[2 * i] + rest * (line[2 * i + 2] - line[2 * i]), line[2 * i + 1] + rest * (line[2 * i + 3] - line[2 * i + 1]), 2.1);
    }
    context.fill();
  }

  /** How long a round of the particles takes, with its rests, seconds. */
  get round() { return (this.growth.options.duration ?? 1) + REST; }

  /** @param {number} x @param {number} y @returns {[number, number]} */
  at(x, y) { return [this.middle[0] + x * this.scale, this.middle[1] - y * this.scale]; }

  /** @param {CanvasRenderingContext2D} context @param {string} colour @param {number} width */
  pen(context, colour, width) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineCap = "round";
    context.lineJoin = "round";
  }

  /** @param {CanvasRenderingContext2D} context @param {Float32Array} line @param {string} colour @param {number} light @param {number} width */
  glow(context, line, colour, light, width) {
    context.globalAlpha = light;
    this.pen(context, colour, width);
    context.beginPath();
    this.trace(context, line);
    context.stroke();
  }

  /** @param {CanvasRenderingContext2D} context @param {Float32Array} line */
  trace(context, line) {
    const { scale, middle: [left, top] } = this;
    context.moveTo(left + line[0] * scale, top - line[1] * scale);
    for (let i = 2; i < line.length; i += 2) context.lineTo(left + line[i] * scale, top - line[i + 1] * scale);
  }

  /** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius */
  dot(context, x, y, radius) {
    const [left, top] = this.at(x, y);
    context.moveTo(left + radius, top);
    context.arc(left, top, radius, 0, 2 * Math.PI);
  }
}
