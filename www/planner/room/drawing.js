/**
 * The drawing of how much room there is, on a workspace: the route graph beneath the path of the run; above it the safest path,
 * the widest disc in its bottleneck, and the place of the path with the smallest clearance.
 */
import { drawLabels } from "../../draw/labels.js";
import { disc, drawLine, ring, setStroke } from "../../draw/marks.js";
import { tracePen } from "../../draw/pen.js";
import { num } from "../../widgets/format.js";
import { Workspace } from "../stage/workspace-pane.js";
import { clearanceText } from "./words.js";

/** @import { RouteGraph, Safest, Widest } from "planarium/full" */
/** @import { View } from "planarium/draw" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/** @import { Label } from "../../draw/labels.js" */
/** @import { Clearances } from "../../paths/clearance.js" */
/** @import { Lane } from "../stage/lane.js" */
/** @import { Pane } from "../stage/pane.js" */
/**
 * @typedef {object} Known
 * @property {ScenarioDocument} document   of the scene
 * @property {Widest | null} widest
 * @property {Safest | null} safest
 * @property {RouteGraph | null} routes
 * @property {Clearances["least"]} least   of the path on the stage
 */
/** @typedef {{ view: View | null, safest: Float64Array, nodes: Float64Array }} Drawn   in pixels of a pane */

/** The least radius of the widest disc as it is drawn, CSS pixels; a smaller one has a ring around it. */
const LEAST = 7;
/** The radius of that ring, and of the room around a mark that labels keep free. */
const RING = 13;
/** Half the length of the bar at either end of a gap. */
const BAR = 5;

export class RoomDrawing {
  /** @param {Known} known */
  constructor(known) {
    this.known = known;
    /** By pane, until it is laid out again. @type {WeakMap<Pane, Drawn>} */
    this.drawn = new WeakMap();
  }

  /** Beneath the path of the run. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
  drawUnder(pane, context, lane) {
    const { routes } = this.known;
    const { palette, fineness } = pane;
    if (!routes || !palette || !this.fits(pane, lane)) return;
    const { nodes } = this.on(pane);
    context.save();
    context.lineCap = "round";
    for (const [colour, width] of /** @type {[string, number][]} */ ([
      [palette.stage, 4.6 * pane.bold],
      [palette.start, 1.7 * pane.bold],
    ])) {
      setStroke(context, colour, width);
      context.beginPath();
      for (const {
        nodes: [a, b],
      } of routes.edges) {
        context.moveTo(nodes[2 * a], nodes[2 * a + 1]);
        context.lineTo(nodes[2 * b], nodes[2 * b + 1]);
      }
      context.stroke();
    }
    for (const [colour, half] of /** @type {[string, number][]} */ ([
      [palette.stage, 4.4 * fineness],
      [palette.start, 3.2 * fineness],
    ])) {
      context.fillStyle = colour;
      for (let i = 0; i < nodes.length; i += 2)
        context.fillRect(nodes[i] - half, nodes[i + 1] - half, 2 * half, 2 * half);
    }
    context.restore();
  }

  /** Above it. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
  drawOver(pane, context, lane) {
    const { widest, safest, least } = this.known;
    const { palette, view } = pane;
    if (!palette || !view || !this.fits(pane, lane)) return;
    /** @type {Label[]} */
    const labels = [];
    context.save();
    if (safest) this.drawSafest(pane, context, palette);
    if (widest?.bottleneck) labels.push(...drawBottleneck(context, view, widest, palette));
    if (least && lane.playback && lane.playback.drawn >= 1) labels.push(drawLeast(context, pane, least, palette));
    const { start, goals } = lane.shown;
    const ends = [start, ...goals].flatMap((end) => {
      const [x, y] = end ? pane.pixels(Float64Array.from(end)) : [];
      return end ? [/** @type {[number, number, number]} */ ([x, y, 9])] : [];
    });
    const places = labels.map(({ x, y }) => /** @type {[number, number, number]} */ ([x, y, RING]));
    drawLabels(context, labels, palette, pane, [...ends, ...places]);
    context.restore();
  }

  /** Whether it is of the scene on the pane. @param {Pane} pane @param {Lane} lane */
  fits(pane, lane) {
    return pane instanceof Workspace && lane.shown.document === this.known.document;
  }

  /** The lines in pixels of a pane. @param {Pane} pane @returns {Drawn} */
  on(pane) {
    const known = this.drawn.get(pane);
    if (known && known.view === pane.view) return known;
    const { safest, routes } = this.known;
    const view = /** @type {View} */ (pane.view);
    const pixels = (/** @type {[number, number][]} */ points) =>
      Float64Array.from(points.flatMap(([x, y]) => [view.x(x), view.y(y)]));
    const drawn = { view: pane.view, safest: pixels(safest?.path ?? []), nodes: pixels(routes?.nodes ?? []) };
    this.drawn.set(pane, drawn);
    return drawn;
  }

  /** @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Palette} palette */
  drawSafest(pane, context, palette) {
    const { safest } = this.on(pane);
    context.lineCap = context.lineJoin = "round";
    for (const [colour, width, dash] of /** @type {[string, number, number[]][]} */ ([
      [palette.stage, 6 * pane.bold, []],
      [palette.goal, 2.6 * pane.bold, [12, 5, 0.1, 5]],
    ])) {
      setStroke(context, colour, width, dash);
      context.beginPath();
      tracePen(context, safest, 0, safest.length / 2);
      context.stroke();
    }
    context.setLineDash([]);
  }
}

/**
 * The widest disc where it just fits: in the middle of the gap, or at the start or the goal.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Widest} widest
 * @param {Palette} palette
 * @returns {Label[]}
 */
function drawBottleneck(context, view, { bottleneck, limit, radius }, palette) {
  if (!bottleneck || radius === null) return [];
  const [[ax, ay], [bx, by]] = bottleneck.map((point) => view.place(point));
  const [x, y] = limit === "gap" ? [(ax + bx) / 2, (ay + by) / 2] : [ax, ay];
  const r = radius * view.scaleX;
  context.fillStyle = palette.goal;
  context.globalAlpha = 0.2;
  disc(context, x, y, r);
  context.globalAlpha = 1;
  setStroke(context, palette.stage, 4.5);
  ring(context, x, y, r);
  setStroke(context, palette.goal, 2);
  ring(context, x, y, r);
  if (r < LEAST) {
    setStroke(context, palette.stage, 4.5);
    ring(context, x, y, RING);
    setStroke(context, palette.goal, 2, [4, 3]);
    ring(context, x, y, RING);
    context.setLineDash([]);
  }
  // The gap, with a bar at either end.
  const length = Math.hypot(bx - ax, by - ay) || 1;
  const [u, v] = [(BAR * (ay - by)) / length, (BAR * (bx - ax)) / length];
  for (const [colour, width] of /** @type {[string, number][]} */ ([
    [palette.stage, 4.5],
    [palette.ink, 1.8],
  ])) {
    setStroke(context, colour, width);
    drawLine(context, ax, ay, bx, by);
    for (const [px, py] of [
      [ax, ay],
      [bx, by],
    ])
      drawLine(context, px - u, py - v, px + u, py + v);
  }
  return [{ text: `radius ${num(radius, 3)} m`, x, y, colour: palette.ink }];
}

/**
 * The place with the smallest clearance.
 * @param {CanvasRenderingContext2D} context
 * @param {Pane} pane
 * @param {NonNullable<Clearances["least"]>} least
 * @param {Palette} palette
 * @returns {Label}
 */
function drawLeast(context, pane, { pose, distance }, palette) {
  const [x, y] = pane.pixels(Float64Array.from(pose));
  for (const [colour, width] of /** @type {[string, number][]} */ ([
    [palette.stage, 5],
    [palette.path, 2.2],
  ])) {
    setStroke(context, colour, width);
    ring(context, x, y, 7);
  }
  return { text: clearanceText(distance), x, y, colour: palette.path };
}
