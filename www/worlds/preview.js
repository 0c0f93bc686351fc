/**
 * The map in the panel: its cells and obstacles, and the robot at start and goal, which can be dragged. For the scale
 * of a picture two points are clicked.
 */
import { View, drawWorld, partPath } from "planarium/draw";
import { make } from "../app/dom.js";
import { drawGoal, drawStart } from "../draw/shapes.js";
import { drawCross } from "../draw/marks.js";
import { CellPicture } from "./picture.js";

/** @import { App } from "../app/app.js" */
/** @import { Box, Part, Point, ScenarioDocument } from "../domain/types.js" */
/** @import { Grid, Places } from "./types.js" */
/** @typedef {keyof Places} End */

/** Distance within which a pointer takes an end, CSS pixels. */
const REACH = 24;

/** The outline of a robot that is a disc or has a shape, at a place. @param {ScenarioDocument["robot"]} robot @param {number[]} pose @returns {Part} */
function partAt(robot, [x, y, theta = 0]) {
  if (robot.type === "disc") return { type: "disc", center: [x, y], radius: robot.radius };
  const [cosine, sine] = [Math.cos(theta), Math.sin(theta)];
  const corners = "shape" in robot ? robot.shape.vertices : [];
  return {
    type: "polygon",
    vertices: corners.map(([u, v]) => /** @type {Point} */ ([x + u * cosine - v * sine, y + u * sine + v * cosine])),
  };
}

export class Preview {
  /**
   * @param {App} app
   * @param {(places: Places) => void} onMove   of an end, while it is dragged
   * @param {(points: Point[]) => void} onPoint   on the picture
   */
  constructor(app, onMove, onPoint) {
    this.onMove = onMove;
    this.onPoint = onPoint;
    this.canvas = make("canvas", { id: "world-preview", role: "img", ariaLabel: "The world that was read" });
    /** @type {ScenarioDocument | null} */
    this.document = null;
    /** @type {CellPicture | null} */
    this.picture = null;
    /** What is shown of the plane. @type {Box} */
    this.box = { min: [0, 0], max: [1, 1] };
    /** @type {Places | null} */
    this.places = null;
    /** The ends in collision. @type {End[]} */
    this.bad = [];
    /** Clicked for the scale, while that is measured. @type {Point[] | null} */
    this.points = null;
    /** @type {End | null} */
    this.held = null;
    /** @type {View | null} */
    this.view = null;
    this.canvas.addEventListener("pointerdown", (event) => this.press(event));
    this.canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const name of /** @type {const} */ (["pointerup", "pointercancel"]))
      this.canvas.addEventListener(name, () => {
        this.held = null;
      });
    this.observer = new ResizeObserver(() => this.draw());
    this.observer.observe(this.canvas);
    this.look = app.look;
    app.onTheme(() => {
      this.look = app.look;
      this.draw();
    });
  }

  /** @param {ScenarioDocument} document @param {Grid | undefined} grid */
  show(document, grid) {
    const before = this.picture?.grid.resolution;
    // What was clicked stays on its pixels.
    if (this.points && before && grid)
      this.points = this.points.map(([x, y]) => [(x * grid.resolution) / before, (y * grid.resolution) / before]);
    this.document = document;
    this.picture = grid ? new CellPicture(grid, document.world.obstacles) : null;
    const bounds = document.world.bounds ?? this.box;
    this.box = this.picture?.window ?? bounds;
    const { min, max } = this.box;
    // As wide as the panel allows, and not much higher.
    const aspect = (max[0] - min[0]) / (max[1] - min[1]);
    this.canvas.style.aspectRatio = String(Math.min(2.2, Math.max(0.9, aspect)));
    this.draw();
  }

  /** Forgets the world. */
  clear() {
    this.document = this.picture = this.places = this.points = this.held = null;
    this.draw();
  }

  /** Begins or ends the measurement of a length. @param {boolean} isOn */
  measure(isOn) {
    this.points = isOn ? [] : null;
    this.canvas.classList.toggle("measuring", isOn);
    this.draw();
  }

  /** @param {PointerEvent} event @returns {Point} */
  pointOf({ offsetX, offsetY }) {
    return /** @type {View} */ (this.view).toPlane(offsetX, offsetY);
  }

  /** @param {PointerEvent} event */
  press(event) {
    const { view, places, points } = this;
    if (!view || event.button !== 0) return;
    if (points) {
      if (points.length === 2) points.length = 0;
      points.push(this.pointOf(event));
      this.onPoint([...points]);
      this.draw();
      return;
    }
    if (!places) return;
    const near = /** @type {const} */ (["start", "goal"]).map((end) => {
      const [x, y] = view.place(places[end]);
      return { end, distance: Math.hypot(event.offsetX - x, event.offsetY - y) };
    });
    const [first] = near.sort((a, b) => a.distance - b.distance);
    if (first.distance > REACH) return;
    this.held = first.end;
    this.canvas.setPointerCapture(event.pointerId);
    // A field that is left shows what is dragged.
    if (document.activeElement instanceof HTMLInputElement) document.activeElement.blur();
  }

  /** @param {PointerEvent} event */
  move(event) {
    const { held, places, document } = this;
    if (!held || !places || !document) return;
    const { min, max } = document.world.bounds ?? this.box;
    const at = this.pointOf(event).map((value, i) => Math.min(max[i], Math.max(min[i], value)));
    this.onMove({ ...places, [held]: [...at, ...places[held].slice(2)] });
  }

  draw() {
    const { canvas, document, picture, places, points } = this;
    const { palette, ratio } = this.look;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width < 1 || height < 1) return;
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    const context = canvas.getContext("2d");
    if (!context || !document) return;
    context.scale(ratio, ratio);
    const view = (this.view = new View(this.box, width, height));
    if (picture) picture.draw(context, view, document.world, palette);
    else drawWorld(context, view, document, palette);
    for (const [end, draw] of /** @type {[End, typeof drawStart][]} */ ([
      ["start", drawStart],
      ["goal", drawGoal],
    ])) {
      const pose = places?.[end];
      if (!pose || points) continue;
      partPath(context, view, partAt(document.robot, pose));
      context.strokeStyle = this.bad.includes(end) ? palette.collision : palette[end];
      context.lineWidth = 1.5;
      context.stroke();
      draw(context, view.x(pose[0]), view.y(pose[1]), palette);
    }
    if (!points) return;
    if (points.length === 2) {
      context.beginPath();
      for (const point of points) context.lineTo(...view.place(point));
      context.strokeStyle = palette.path;
      context.lineWidth = 2;
      context.stroke();
    }
    for (const point of points) drawCross(context, ...view.place(point), palette.path, palette, 6);
  }
}
