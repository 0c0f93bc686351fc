/**
 * Drawing on a 2D canvas: `import { View, drawWorld, drawEdges } from "planarium/draw"`. Importing it does not load the
 * core.
 *
 * Positions in a scenario are metres with y up, those on a canvas are units of its context (CSS pixels, unless it is
 * transformed) with y down; a `View` converts between them. Every function that draws takes colours as its last
 * argument; those left out have their default.
 */

/** @import { Box, Obstacle, Part, Planner, Point, ResultDocument, Scenario, ScenarioDocument, Wall } from "./core.js" */

/**
 * What is drawn on: a canvas element's context, or that of an offscreen canvas.
 * @typedef {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} Context
 */

/**
 * Colours, each a CSS colour: `stage` is the background, `growth` the edges of a planner.
 * @typedef {Record<"stage" | "obstacle" | "obstacleEdge" | "robot" | "robotEdge" | "growth" | "path", string>} Colours
 */

/**
 * Curves in the plane.
 * @typedef {object} Curves
 * @property {Float64Array} points  x and y in turn, metres
 * @property {Uint32Array} firsts  curve i has the points from `firsts[i]` up to `firsts[i + 1]`; one more than there
 *   are curves
 */

/** The default colours, for a light background. @type {Readonly<Colours>} */
export const defaultColours = {
  stage: "#fffefb",
  obstacle: "#dcdad2",
  obstacleEdge: "#7f8188",
  robot: "#28324a",
  robotEdge: "#fffefb",
  growth: "#4a5874",
  path: "#c25e00",
};

/**
 * All colours; those left out, or undefined, have their default.
 * @param {Partial<Colours>} [colours]
 * @returns {Colours}
 */
function coloursOf(colours) {
  return {
    ...defaultColours,
    ...Object.fromEntries(Object.entries(colours ?? {}).filter(([, colour]) => colour !== undefined)),
  };
}

/** A part thinner than this on the canvas is drawn as a line. */
const THIN = 1.6;
/** The index of "rewired" in `eventKinds`; this file imports no other, and a test compares. */
const REWIRED = 7;
/** Longest turn of one joint in one straight piece of a drawn curve, radians. */
const PIECE = 0.14;
/** Straight pieces of a drawn blend. */
const BLEND = 16;

/** A map between a box of the plane, in metres with y up, and a canvas, in its units with y down. */
export class View {
  /**
   * @param {Box} box  what is visible, for example `scenario.extent()`
   * @param {number} width   of the canvas, more than 0
   * @param {number} height
   * @param {{ left: number, right: number, top: number, bottom: number }} [margin]  around the box, 0 or more; 14 by
   *   default
   * @param {boolean} [stretched]  true: the box fills the canvas, each axis has its own scale; false (default): one
   *   scale, centred
   */
  constructor(box, width, height, margin = { left: 14, right: 14, top: 14, bottom: 14 }, stretched = false) {
    const innerWidth = Math.max(1, width - margin.left - margin.right);
    const innerHeight = Math.max(1, height - margin.top - margin.bottom);
    let scaleX = innerWidth / Math.max(box.max[0] - box.min[0], 1e-12);
    let scaleY = innerHeight / Math.max(box.max[1] - box.min[1], 1e-12);
    if (!stretched) scaleX = scaleY = Math.min(scaleX, scaleY);
    /** The visible box, metres. @type {Box} */
    this.box = box;
    /** The width of the canvas. @type {number} */
    this.width = width;
    /** The height of the canvas. @type {number} */
    this.height = height;
    /** Canvas units per metre, across. @type {number} */
    this.scaleX = scaleX;
    /** Canvas units per metre, up. @type {number} */
    this.scaleY = scaleY;
    /** The origin of the plane on the canvas, across. @type {number} */
    this.originX = margin.left + innerWidth / 2 - (scaleX * (box.min[0] + box.max[0])) / 2;
    /** The origin of the plane on the canvas, down. @type {number} */
    this.originY = margin.top + innerHeight / 2 + (scaleY * (box.min[1] + box.max[1])) / 2;
  }

  /** The canvas coordinate, to the right, of a coordinate of the plane. @param {number} x  metres @returns {number} */
  x(x) {
    return this.originX + this.scaleX * x;
  }

  /** The canvas coordinate, down, of a coordinate of the plane. @param {number} y  metres @returns {number} */
  y(y) {
    return this.originY - this.scaleY * y;
  }

  /**
   * A point of the plane on the canvas.
   * @param {ArrayLike<number>} point  x, y in metres
   * @returns {[number, number]}
   */
  place(point) {
    return [this.x(point[0]), this.y(point[1])];
  }

  /** A point of the canvas in the plane, metres. @param {number} px @param {number} py @returns {[number, number]} */
  toPlane(px, py) {
    return [(px - this.originX) / this.scaleX, (this.originY - py) / this.scaleY];
  }
}

/**
 * Draws the bounds, if any, and the obstacles. Styles of the context change.
 * @param {Context} context
 * @param {View} view
 * @param {Pick<ScenarioDocument, "world">} document  `scenario.document()`
 * @param {Partial<Colours>} [colours]
 * @returns {void}
 */
export function drawWorld(context, view, { world: { bounds, obstacles } }, colours) {
  if (bounds) {
    const { min, max } = bounds;
    context.strokeStyle = coloursOf(colours).obstacleEdge;
    context.lineWidth = 1.5;
    context.strokeRect(
      view.x(min[0]),
      view.y(max[1]),
      (max[0] - min[0]) * view.scaleX,
      (max[1] - min[1]) * view.scaleY,
    );
  }
  drawObstacles(context, view, obstacles, colours);
}

/**
 * Draws obstacles, filled and outlined. Styles of the context change.
 * @param {Context} context
 * @param {View} view
 * @param {readonly Obstacle[]} obstacles
 * @param {Partial<Colours>} [colours]
 * @returns {void}
 */
export function drawObstacles(context, view, obstacles, colours) {
  const { obstacle: fill, obstacleEdge } = coloursOf(colours);
  context.fillStyle = fill;
  context.strokeStyle = obstacleEdge;
  context.lineWidth = 1;
  context.lineJoin = context.lineCap = "round";
  for (const obstacle of obstacles) {
    if (obstacle.type === "wall") {
      drawWall(context, view, obstacle, [fill, obstacleEdge]);
    } else {
      obstaclePath(context, view, obstacle);
      context.fill();
      context.stroke();
    }
  }
}

/**
 * Draws a wall as lines with round ends, the narrower one on the one of the edge; a thin wall is its edge alone.
 * @param {Context} context
 * @param {View} view
 * @param {Wall} wall
 * @param {[fill: string, edge: string]} colours
 * @returns {void}
 */
function drawWall(context, view, { points, width, closed }, [fill, edge]) {
  const across = width * view.scaleX;
  context.beginPath();
  for (const point of points) context.lineTo(...view.place(point));
  if (closed) context.closePath();
  context.strokeStyle = edge;
  context.lineWidth = Math.max(across + 1, THIN);
  context.stroke();
  if (across > THIN) {
    context.strokeStyle = fill;
    context.lineWidth = across - 1;
    context.stroke();
  }
  context.strokeStyle = edge;
  context.lineWidth = 1;
}

/**
 * Makes the outline of an obstacle the current path. Holes run against the outline, and the segments of a wall all in one
 * direction: filled by the rule "nonzero", which is the default, the path is the obstacle. A thin wall is drawn wider.
 * @param {Context} context
 * @param {View} view
 * @param {Obstacle} obstacle
 * @returns {void}
 */
export function obstaclePath(context, view, obstacle) {
  context.beginPath();
  if (obstacle.type === "disc") {
    context.arc(...view.place(obstacle.center), obstacle.radius * view.scaleX, 0, 2 * Math.PI);
  } else if (obstacle.type === "wall") {
    const { points, width, closed } = obstacle;
    const radius = Math.max(width * view.scaleX, THIN) / 2;
    const ends = closed ? [...points, points[0]] : points;
    for (let i = 1; i < ends.length; i += 1) capsulePath(context, view.place(ends[i - 1]), view.place(ends[i]), radius);
  } else {
    ringPath(context, view, obstacle.vertices);
    const isLeft = area(obstacle.vertices) > 0;
    for (const hole of obstacle.holes ?? []) {
      ringPath(context, view, area(hole) > 0 === isLeft ? hole.toReversed() : hole);
    }
  }
}

/** Adds a ring to the current path. @param {Context} context @param {View} view @param {readonly Point[]} ring */
function ringPath(context, view, ring) {
  for (const [i, vertex] of ring.entries()) {
    if (i === 0) context.moveTo(...view.place(vertex));
    else context.lineTo(...view.place(vertex));
  }
  context.closePath();
}

/** Twice the area of a ring, negative if it is clockwise. @param {readonly Point[]} ring @returns {number} */
function area(ring) {
  let sum = 0;
  for (const [i, [x, y]] of ring.entries()) {
    const [u, w] = ring[(i + 1) % ring.length];
    sum += x * w - u * y;
  }
  return sum;
}

/**
 * Adds the outline of all within a distance of a segment to the current path, in units of the canvas.
 * @param {Context} context
 * @param {[number, number]} from
 * @param {[number, number]} to
 * @param {number} radius
 * @returns {void}
 */
function capsulePath(context, [ax, ay], [bx, by], radius) {
  const angle = Math.atan2(by - ay, bx - ax);
  context.moveTo(ax + radius * Math.cos(angle + Math.PI / 2), ay + radius * Math.sin(angle + Math.PI / 2));
  context.arc(ax, ay, radius, angle + Math.PI / 2, angle - Math.PI / 2);
  context.arc(bx, by, radius, angle - Math.PI / 2, angle + Math.PI / 2);
  context.closePath();
}

/**
 * Whether a part is so thin on the canvas that it is drawn as a line.
 * @param {View} view
 * @param {Part} part
 * @returns {boolean}
 */
export function isThin(view, part) {
  return part.type !== "polygon" && part.radius * view.scaleX < THIN;
}

/**
 * Makes the outline of a part the current path; of a thin one its middle line.
 * @param {Context} context
 * @param {View} view
 * @param {Part} part
 * @returns {void}
 */
export function partPath(context, view, part) {
  if (part.type === "polygon") {
    obstaclePath(context, view, part);
    return;
  }
  const radius = part.radius * view.scaleX;
  context.beginPath();
  if (part.type === "disc") {
    context.arc(...view.place(part.center), Math.max(radius, 4), 0, 2 * Math.PI);
    return;
  }
  const [a, b] = [view.place(part.a), view.place(part.b)];
  if (isThin(view, part)) {
    context.moveTo(...a);
    context.lineTo(...b);
    return;
  }
  capsulePath(context, a, b, radius);
}

/**
 * Draws the robot at a configuration, and its margin, if there is one, as a halo.
 * @param {Context} context
 * @param {View} view
 * @param {readonly Part[]} parts  `scenario.footprint(q)`
 * @param {Partial<Colours>} [colours]
 * @param {number} [margin]  that of the scenario's robot, metres; 0 by default
 * @returns {void}
 */
export function drawRobot(context, view, parts, colours, margin = 0) {
  const { stage, robot, robotEdge } = coloursOf(colours);
  const isLine = parts[0]?.type === "capsule" && isThin(view, parts[0]);
  context.save();
  context.lineCap = context.lineJoin = "round";
  if (margin > 0) {
    const { globalAlpha } = context;
    context.globalAlpha = 0.2 * globalAlpha;
    context.strokeStyle = robot;
    context.lineWidth = 2 * margin * view.scaleX;
    for (const part of parts) {
      partPath(context, view, part);
      context.stroke();
    }
    context.globalAlpha = globalAlpha;
  }
  for (const [width, colour] of /** @type {[number, string][]} */ (
    isLine
      ? [
          [7, stage],
          [3.4, robot],
        ]
      : [[1.2, robotEdge]]
  )) {
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.fillStyle = robot;
    for (const part of parts) {
      partPath(context, view, part);
      if (!isLine) context.fill();
      context.stroke();
    }
  }
  context.fillStyle = isLine ? robot : robotEdge;
  for (const part of parts) {
    if (part.type !== "capsule") continue;
    const radius = isLine ? 3.6 : Math.max(1.6, 0.34 * part.radius * view.scaleX);
    for (const end of [part.a, part.b]) {
      context.beginPath();
      context.arc(...view.place(end), radius, 0, 2 * Math.PI);
      context.fill();
    }
  }
  context.restore();
}

/**
 * Draws the edges of a planner from edge `first` on, as curves of the end effector. To draw only what is new, pass the
 * result as `first` in the next frame. From edge 0 on, an edge of a tree whose end got another parent is left out, as
 * the planner's events tell; so draw a tree that is rewired (RRT*) from 0 in each frame. Edges of vertices that were
 * removed (an event of `planner.eventsSince`) are drawn, too.
 * @param {Context} context @param {View} view @param {Scenario} scenario @param {Planner} planner
 * @param {number} [first]  0 (default) to `planner.edgeCount`
 * @param {Partial<Colours>} [colours]
 * @returns {number} the number of edges, `planner.edgeCount`
 */
export function drawEdges(context, view, scenario, planner, first = 0, colours) {
  const n = planner.dimension;
  const [vertices, edges, traces] = [planner.verticesSince(0), planner.edgesSince(first), planner.tracesSince(first)];
  /** @type {number[]} */
  const ends = [];
  const replaced = first === 0 ? replacedEdges(planner, edges) : new Set();
  const curved = new Set();
  for (let at = 0; at < traces.length; at += n + 1) {
    curved.add(traces[at]);
    if (traces[at + n + 1] === traces[at] && !replaced.has(traces[at]))
      ends.push(...traces.subarray(at + 1, at + 1 + n), ...traces.subarray(at + n + 2, at + 2 * n + 2));
  }
  for (let i = 0; i < edges.length; i += 2) {
    if (curved.has(first + i / 2) || replaced.has(i / 2)) continue;
    for (const vertex of edges.subarray(i, i + 2)) ends.push(...vertices.subarray(vertex * n, (vertex + 1) * n));
  }
  strokeMotions(context, view, scenario, ends, coloursOf(colours).growth, 1.2);
  return first + edges.length / 2;
}

/**
 * The edges of a tree to vertices that a later edge leads to.
 * @param {Planner} planner
 * @param {Uint32Array} edges  all
 * @returns {Set<number>}
 */
function replacedEdges(planner, edges) {
  const replaced = new Set();
  const events = planner.eventsSince(0);
  let isRewired = false;
  for (let at = 0; at < events.length && !isRewired; at += planner.eventWidth) isRewired = events[at] === REWIRED;
  if (!isRewired) return replaced;
  const last = new Map();
  for (let i = 0; i < edges.length; i += 2) {
    if (last.has(edges[i + 1])) replaced.add(last.get(edges[i + 1]));
    last.set(edges[i + 1], i / 2);
  }
  return replaced;
}

/**
 * A path with its corners rounded: in place of a waypoint that has a blend, 17 configurations along that; the other
 * waypoints as they are.
 * @param {Scenario} scenario
 * @param {Pick<ResultDocument, "path" | "blends">} result  `planner.result()`
 * @returns {number[][]} configurations, angles in (-pi, pi] on circles
 */
export function blendedPath(scenario, { path, blends }) {
  const circles = scenario.circles();
  return path.flatMap((q, i) => {
    const [before, after] = blends?.[i - 1] ?? [0, 0];
    if (before + after === 0) return [q];
    return Array.from({ length: BLEND + 1 }, (_, k) =>
      q.map((at, j) => {
        const [from, to] = [path[i - 1], path[i + 1]].map((end) => difference(at, end[j], circles[j]));
        const bent = at + before * (1 - k / BLEND) ** 2 * from + after * (k / BLEND) ** 2 * to;
        return circles[j] ? wrap(bent) : bent;
      }),
    );
  });
}

/**
 * Draws a path, its corners rounded as its blends say, as the curve of the end effector; nothing if it is empty.
 * @param {Context} context
 * @param {View} view
 * @param {Scenario} scenario
 * @param {Pick<ResultDocument, "path" | "motions" | "blends">} result  `planner.result()`
 * @param {Partial<Colours>} [colours]
 * @returns {void}
 */
export function drawPath(context, view, scenario, { path, motions, blends }, colours) {
  const rows = blendedPath(scenario, { path, blends }).flatMap((q, i) => {
    const motion = motions?.[i];
    if (!motion) return [q];
    const { poses } = scenario.rollout(q, ...motion.control, motion.duration);
    return Array.from({ length: poses.length / 3 }, (_, k) => [...poses.subarray(3 * k, 3 * k + 3)]);
  });
  strokeMotions(
    context,
    view,
    scenario,
    rows.slice(1).flatMap((q, i) => [...rows[i], ...q]),
    coloursOf(colours).path,
    3.4,
  );
}

/**
 * Strokes motions as curves.
 * @param {Context} context
 * @param {View} view
 * @param {Scenario} scenario
 * @param {number[]} ends
 * @param {string} colour
 * @param {number} width
 */
function strokeMotions(context, view, scenario, ends, colour, width) {
  const { points, firsts } = motionCurves(scenario, Float64Array.from(ends));
  context.save();
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineCap = context.lineJoin = "round";
  context.beginPath();
  for (let m = 0; m + 1 < firsts.length; m++) {
    context.moveTo(view.x(points[2 * firsts[m]]), view.y(points[2 * firsts[m] + 1]));
    for (let i = firsts[m] + 1; i < firsts[m + 1]; i++)
      context.lineTo(view.x(points[2 * i]), view.y(points[2 * i + 1]));
  }
  context.stroke();
  context.restore();
}

/**
 * The curves of the end effector along straight motions between configurations. Those of an arm have a point at least
 * every 0.14 rad of each joint, at most 49 points; those of other robots are straight lines.
 * @param {Scenario} scenario
 * @param {Float64Array} ends  rows of 2 * dimension numbers: from, to
 * @param {readonly boolean[]} [circles]  coordinates that turn the short way round; by default `scenario.circles()`
 * @returns {Curves}
 */
export function motionCurves(scenario, ends, circles = scenario.circles()) {
  const isStraight = scenario.robot !== "arm";
  const n = circles.length;
  const motions = ends.length / (2 * n);
  const firsts = new Uint32Array(motions + 1);
  for (let m = 0; m < motions; m++) firsts[m + 1] = firsts[m] + 1 + (isStraight ? 1 : pieces(ends, 2 * n * m, circles));
  const rows = new Float64Array(firsts[motions] * n);
  for (let m = 0; m < motions; m++) {
    const from = 2 * n * m;
    const count = firsts[m + 1] - firsts[m] - 1;
    for (let j = 0; j < n; j++) {
      const begin = ends[from + j];
      const turn = difference(begin, ends[from + n + j], circles[j]);
      for (let p = 0; p <= count; p++) rows[(firsts[m] + p) * n + j] = begin + (turn * p) / count;
    }
  }
  return { points: scenario.endEffectors(rows), firsts };
}

/**
 * The number of straight pieces of a curve.
 * @param {Float64Array} ends
 * @param {number} from
 * @param {readonly boolean[]} circles
 */
function pieces(ends, from, circles) {
  const n = circles.length;
  let most = 0;
  for (let j = 0; j < n; j++)
    most = Math.max(most, Math.abs(difference(ends[from + j], ends[from + n + j], circles[j])));
  return Math.max(1, Math.min(48, Math.ceil(most / PIECE)));
}

/**
 * The signed difference of two coordinates; of angles on a circle the short way round, radians.
 * @param {number} from
 * @param {number} to
 * @param {boolean} isCircle
 * @returns {number}
 */
export function difference(from, to, isCircle) {
  return isCircle ? wrap(to - from) : to - from;
}

/** Wraps an angle to the interval from -pi (exclusive) to pi. @param {number} angle  radians @returns {number} */
export function wrap(angle) {
  const turn = angle % (2 * Math.PI);
  if (turn > Math.PI) return turn - 2 * Math.PI;
  return turn <= -Math.PI ? turn + 2 * Math.PI : turn;
}
