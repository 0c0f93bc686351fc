/**
 * The floor: the world, the roadmaps as they grow, and every robot's way below; on top the robots at the time shown,
 * each with its number and a tail, and what is special of some: it waits, finds no way, is in the way, or touches
 * another one.
 */
import { View, drawObstacles, partPath } from "planarium/draw";
import { NO_VIEW } from "../draw/figure.js";
import { drawGround } from "../draw/ground.js";
import { addLine, cross, disc, drawLine, ring, setStroke, strokeWithHalo } from "../draw/marks.js";
import { addDiamond, drawGhost, drawLabel, drawTouchingParts } from "../draw/shapes.js";
import { robotColours } from "./colours.js";
import { partsAt, poseOf, roomOf } from "./trajectory.js";

/** @import { FleetDocument } from "planarium/full" */
/** @import { Point, ScenarioDocument } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @import { Brush } from "../draw/figure.js" */
/** @import { FleetSession, Roadmap } from "./session.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** Seconds of a robot's tail. */
const TAIL = 1.6;
/** Edges of all roadmaps from which on they are fainter. */
const MANY_EDGES = 4000;
/** With this number of robots or more, routes and ends are fainter. */
const MANY_ROBOTS = 30;
/** The least radius of a robot with a number, CSS pixels. */
const READABLE = 5;

export class Floor {
  /** @param {FleetSession} session */
  constructor(session) {
    this.session = session;
    this.view = NO_VIEW;
    /** @type {string[]} */
    this.colours = [];
  }

  get layers() {
    const { document, run, shown, hasRoadmap, isStraight, isOrdered } = this.session;
    const { colours } = this;
    const isRunning = run.status === "running";
    const isMany = run.roadmaps.reduce((sum, { edges }) => sum + edges.length / 2, 0) > MANY_EDGES;
    const alphas = isRunning ? { edges: isMany ? 0.15 : 0.4, vertices: 0.8 } : { edges: 0.08, vertices: 0.25 };
    return {
      ground: { key: document, draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      roadmaps: {
        key: [run, colours, isRunning, isMany, isOrdered],
        logs:
          hasRoadmap && !isStraight
            ? run.roadmaps.flatMap((roadmap, i) => [
                { count: roadmap.edges.length / 2, append: this.drawEdges.bind(this, roadmap, i, alphas.edges) },
                {
                  count: roadmap.vertices.length / 3,
                  append: this.drawVertices.bind(this, roadmap, i, alphas.vertices),
                },
              ])
            : [],
      },
      // While the plan grows its routes are on top.
      ends: {
        key: [document, colours, isStraight || !isRunning ? shown : null],
        draw: (/** @type {Brush} */ { context, palette }) => {
          this.drawEnds(context, palette);
          if (isStraight || !isRunning) this.drawRoutes(context);
        },
      },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** Gives every robot its colour. @param {Palette} palette */
  recolour(palette) {
    this.colours = robotColours(this.session.robots.length, palette);
  }

  /** The parts of a robot at the time shown. @param {number} robot */
  partsOf(robot) {
    return partsAt(this.session.robots[robot].robot, this.session.poseAt(robot));
  }

  /** The radius of a robot's number, CSS pixels. @param {number} robot */
  roomOf(robot) {
    return roomOf(this.session.robots[robot].robot) * this.view.scaleX;
  }

  /** Whether a robot in which no number fits is long enough for one on top of it. @param {number} robot */
  isLong(robot) {
    return reachOf(this.session.robots[robot].robot) * this.view.scaleX >= 2 * READABLE;
  }

  /**
   * The robot at a place of the canvas, or null.
   * @param {number} x
   * @param {number} y
   * @param {number} near  CSS pixels
   */
  robotAt(x, y, near) {
    const distances = this.session.robots.map((_, i) => {
      const [px, py] = this.view.place(this.session.poseAt(i));
      return Math.hypot(px - x, py - y);
    });
    const least = Math.min(...distances);
    const robot = distances.indexOf(least);
    return robot >= 0 && least <= Math.max(near, this.roomOf(robot)) ? robot : null;
  }

  /** @param {Brush} brush */
  drawGround({ context, palette, width, height }) {
    const { document, robots } = this.session;
    if (!document) return;
    this.view = new View(boundsOf(document), width, height);
    drawGround(
      context,
      this.view,
      /** @type {ScenarioDocument} */ (/** @type {unknown} */ ({ ...document, robot: robots[0].robot })),
      palette,
    );
  }

  /** The colour of a robot's roadmap; of one for all robots, that of growth. @param {number} i @param {Palette} palette */
  roadmapColour(i, palette) {
    return this.session.isOrdered ? palette.growth : this.colours[i];
  }

  /**
   * @param {Roadmap} roadmap @param {number} i @param {number} alpha
   * @param {Brush} brush @param {number} from @param {number} to
   */
  drawVertices({ vertices }, i, alpha, { context, palette }, from, to) {
    context.fillStyle = this.roadmapColour(i, palette);
    context.globalAlpha = alpha;
    context.beginPath();
    for (let at = 3 * from; at < 3 * to; at += 3) {
      const [x, y] = this.view.place([vertices[at], vertices[at + 1]]);
      context.rect(x - 1, y - 1, 2, 2);
    }
    context.fill();
  }

  /**
   * @param {Roadmap} roadmap @param {number} i @param {number} alpha
   * @param {Brush} brush @param {number} from @param {number} to
   */
  drawEdges({ vertices, edges }, i, alpha, { context, palette }, from, to) {
    const { view } = this;
    setStroke(context, this.roadmapColour(i, palette), 1);
    context.globalAlpha = alpha;
    context.beginPath();
    for (let at = 2 * from; at < 2 * to; at += 2) {
      const [a, b] = [3 * edges[at], 3 * edges[at + 1]];
      addLine(context, view.x(vertices[a]), view.y(vertices[a + 1]), view.x(vertices[b]), view.y(vertices[b + 1]));
    }
    context.stroke();
  }

  /**
   * The start of every robot, a ring, and its goal, a diamond within its outline there.
   * @param {Context} context
   * @param {Palette} palette
   */
  drawEnds(context, palette) {
    const { view } = this;
    const { robots } = this.session;
    const isMany = robots.length > MANY_ROBOTS;
    robots.forEach(({ robot, start, goal }, i) => {
      const colour = this.colours[i];
      const size = Math.min(5, Math.max(2.4, 0.45 * this.roomOf(i)));
      const [gx, gy] = view.place(goal);
      drawGhost(context, view, partsAt(robot, poseOf(goal)), {
        colour,
        fill: isMany ? 0.06 : 0.12,
        stroke: isMany ? 0.35 : 0.7,
        dash: [3, 3],
        width: 1.2,
      });
      context.fillStyle = colour;
      addDiamond(context, gx, gy, 1.3 * size);
      context.fill();
      context.fillStyle = palette.stage;
      setStroke(context, colour, 1.6);
      disc(context, ...view.place(start), 0.8 * size);
      ring(context, ...view.place(start), 0.8 * size);
    });
  }

  /** Every robot's way from its start to its goal. @param {Context} context */
  drawRoutes(context) {
    const { shown } = this.session;
    context.save();
    context.lineJoin = "round";
    context.globalAlpha = shown.length > MANY_ROBOTS ? 0.3 : 0.55;
    shown.forEach((way, i) => {
      if (!way) return;
      setStroke(context, this.colours[i], 1.3);
      this.strokeLine(
        context,
        Array.from({ length: way.count }, (_, row) => way.pointOf(row)),
      );
    });
    context.restore();
  }

  /** @param {Context} context @param {Point[]} points */
  strokeLine(context, points) {
    context.beginPath();
    for (const point of points) context.lineTo(...this.view.place(point));
    context.stroke();
  }

  /** @param {Brush} brush */
  drawTop({ context, palette, hatch, bold }) {
    const { session } = this;
    const { robots, shown, run, time, selected, touching, isStraight } = session;
    if (!session.document) return;
    if (!isStraight && run.status === "running") this.drawRoutes(context);
    context.lineCap = context.lineJoin = "round";
    shown.forEach((way, i) => {
      if (!way || time === 0) return;
      const tail = way.between(Math.max(0, time - TAIL), time);
      context.globalAlpha = 0.5;
      setStroke(context, this.colours[i], Math.max(2, Math.min(6, 0.5 * this.roomOf(i))));
      this.strokeLine(context, tail);
    });
    context.globalAlpha = 1;
    const isBlocked = !isStraight && run.blocked.length > 0;
    const inTheWay = new Set(isBlocked ? run.blocked.slice(1) : []);
    const hit = new Set(touching.flatMap(({ robots: pair }) => pair));
    const lines = hatch(palette.stage);
    if (isBlocked) this.drawLinks(context, run.blocked, palette);
    if (selected !== null) this.drawAhead(context, selected);
    const order = robots.map((_, i) => i).filter((i) => i !== selected);
    for (const i of selected === null ? order : [...order, selected]) {
      if (hit.has(i)) drawTouchingParts(context, this.view, this.partsOf(i), palette, lines);
      else this.drawBody(context, i, palette, inTheWay.has(i));
      this.drawSigns(context, i, palette, hit.has(i), bold);
    }
    if (isBlocked) this.drawBlocked(context, run.blocked[0], palette, bold);
    if (selected !== null) this.drawSelected(context, selected, palette, bold);
  }

  /**
   * The robot in its colour, within a thick red outline if it is in the way of another one.
   * @param {Context} context
   * @param {number} i
   * @param {Palette} palette
   * @param {boolean} isInTheWay
   */
  drawBody(context, i, palette, isInTheWay) {
    context.fillStyle = this.colours[i];
    for (const part of this.partsOf(i)) {
      partPath(context, this.view, part);
      context.fill();
      if (isInTheWay) {
        setStroke(context, palette.stage, 7);
        context.stroke();
        setStroke(context, palette.collision, 3.4);
      } else setStroke(context, palette.robotEdge, 1.2);
      context.stroke();
    }
  }

  /**
   * The number of a robot, and bars while it waits.
   * @param {Context} context
   * @param {number} i
   * @param {Palette} palette
   * @param {boolean} isHit
   * @param {number} bold  scale of the words
   */
  drawSigns(context, i, palette, isHit, bold) {
    const { view } = this;
    const { shown, time, end, robots } = this.session;
    const room = this.roomOf(i);
    const [x, y] = view.place(this.session.poseAt(i));
    if (room >= READABLE) {
      const text = String(i + 1);
      context.font = `600 ${Math.min(15, (text.length > 2 ? 0.85 : 1.05) * room).toFixed(1)}px system-ui, sans-serif`;
      context.textAlign = "center";
      context.textBaseline = "middle";
      if (isHit) {
        setStroke(context, palette.stage, 3);
        context.strokeText(text, x, y);
        context.fillStyle = palette.ink;
      } else context.fillStyle = palette.stage;
      context.fillText(text, x, y);
    } else if (this.isLong(i)) drawLabel(context, String(i + 1), x, y, palette.ink, palette, bold);
    if (time < end && shown[i]?.isWaiting(time))
      drawWait(
        context,
        x + 0.75 * reachOf(robots[i].robot) * view.scaleX + 3,
        y - 0.75 * reachOf(robots[i].robot) * view.scaleX - 3,
        palette,
      );
  }

  /**
   * Lines from the robot that finds no way to those in its way.
   * @param {Context} context
   * @param {number[]} blocked
   * @param {Palette} palette
   */
  drawLinks(context, [robot, ...others], palette) {
    const [from, ...ends] = [robot, ...others].map((i) => this.view.place(this.session.poseAt(i)));
    setStroke(context, palette.collision, 1.4, [2, 4]);
    for (const end of ends) drawLine(context, ...from, ...end);
  }

  /** The chosen robot's way from now on. @param {Context} context @param {number} i */
  drawAhead(context, i) {
    const { shown, time } = this.session;
    const way = shown[i];
    if (!way) return;
    setStroke(context, this.colours[i], 2.6, [7, 5]);
    this.strokeLine(context, way.between(time, Math.max(time, way.arrival)));
  }

  /**
   * A ring with a cross around the robot that finds no way.
   * @param {Context} context
   * @param {number} robot
   * @param {Palette} palette
   * @param {number} bold  scale of the words
   */
  drawBlocked(context, robot, palette, bold) {
    const [x, y] = this.view.place(this.session.poseAt(robot));
    const radius = reachOf(this.session.robots[robot].robot) * this.view.scaleX + 5;
    strokeWithHalo(context, [6, 2.4], palette.collision, palette, () => context.arc(x, y, radius, 0, 2 * Math.PI));
    setStroke(context, palette.collision, 2.4);
    cross(context, x + 0.72 * radius, y + 0.72 * radius, 4);
    drawLabel(context, "no way", x, y + radius + 13 * bold, palette.collision, palette, bold);
  }

  /**
   * An outline around the chosen robot.
   * @param {Context} context @param {number} i @param {Palette} palette @param {number} bold  scale of the words
   */
  drawSelected(context, i, palette, bold) {
    const { view } = this;
    const { robots } = this.session;
    const [x, y] = view.place(this.session.poseAt(i));
    const radius = reachOf(robots[i].robot) * view.scaleX + 4;
    context.lineJoin = "round";
    for (const part of this.partsOf(i)) {
      if (part.type === "disc")
        strokeWithHalo(context, [5, 2.4], palette.ink, palette, () => context.arc(x, y, radius, 0, 2 * Math.PI));
      else {
        setStroke(context, palette.ink, 2.8);
        partPath(context, view, part);
        context.stroke();
      }
    }
    if (this.roomOf(i) < READABLE && !this.isLong(i))
      drawLabel(context, String(i + 1), x, y - radius - 9 * bold, this.colours[i], palette, bold);
  }
}

/**
 * The sign of a robot that waits: two bars.
 * @param {Context} context
 * @param {number} x
 * @param {number} y
 * @param {Palette} palette
 */
function drawWait(context, x, y, palette) {
  strokeWithHalo(context, [5, 2], palette.ink, palette, () => {
    for (const shift of [-2.2, 2.2]) addLine(context, x + shift, y - 3.2, x + shift, y + 3.2);
  });
}

/**
 * The distance of a robot's farthest point from its reference point, metres.
 * @param {FleetDocument["robots"][number]["robot"]} robot
 */
function reachOf(robot) {
  if (robot.type === "disc") return robot.radius;
  return robot.type === "rigid_body" ? Math.max(...robot.shape.vertices.map(([x, y]) => Math.hypot(x, y))) : 0;
}

/** @param {FleetDocument} document */
function boundsOf({ world: { bounds } }) {
  return bounds ?? { min: [0, 0], max: [1, 1] };
}

/**
 * A small picture of a fleet: obstacles, robots at their starts, outlines at their goals.
 * @param {FleetDocument} document
 * @param {number} side  CSS pixels
 * @param {{ palette: Palette, ratio: number }} look
 * @returns {ImageBitmap}
 */
export function fleetThumbnail(document, side, { palette, ratio }) {
  const canvas = new OffscreenCanvas(Math.round(side * ratio), Math.round(side * ratio));
  const context = /** @type {Context} */ (/** @type {unknown} */ (canvas.getContext("2d")));
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const view = new View(boundsOf(document), side, side, { left: 5, right: 5, top: 5, bottom: 5 });
  const { robots, world } = document;
  drawObstacles(context, view, world.obstacles, { ...palette, obstacleEdge: palette.obstacle });
  const colours = robotColours(robots.length, palette);
  robots.forEach(({ robot, start, goal }, i) => {
    drawGhost(context, view, partsAt(robot, poseOf(goal)), {
      colour: colours[i],
      fill: 0,
      stroke: 0.5,
      dash: [],
      width: 1,
    });
    drawGhost(context, view, partsAt(robot, poseOf(start)), {
      colour: colours[i],
      fill: 1,
      stroke: 1,
      dash: [],
      width: 0.5,
    });
  });
  return canvas.transferToImageBitmap();
}
