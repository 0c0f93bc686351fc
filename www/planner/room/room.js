/**
 * How much room there is in the scene on the stage: its widest disc, its safest path and its route graph, as far as the view
 * shows them, and the clearance along the paths on the stage. What is known never outlives its scene, query or path.
 */
import { byId } from "../../app/dom.js";
import { workerWith } from "../../paths/remote.js";
import { RoomDrawing } from "./drawing.js";
import { Question } from "./question.js";

/** @import { App } from "../../app/app.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */
/**
 * @typedef {object} Session   what is taken of the page's session
 * @property {Shown | null} shown
 * @property {Lane[]} lanes
 * @property {() => void} markDirty
 */

/** Into how many parts a path is divided for the chart of its clearance, about. */
const PARTS = 400;

/**
 * A path with more points along its straight pieces.
 * @param {[number, number][]} path @returns {[number, number][]}
 */
function divided(path) {
  const lengthOf = (/** @type {number} */ i) => Math.hypot(path[i + 1][0] - path[i][0], path[i + 1][1] - path[i][1]);
  let whole = 0;
  for (let i = 0; i + 1 < path.length; i++) whole += lengthOf(i);
  return path.flatMap(([x, y], i) => {
    if (i + 1 === path.length || whole === 0) return [/** @type {[number, number]} */ ([x, y])];
    const [u, v] = path[i + 1];
    const parts = Math.max(1, Math.ceil((PARTS * lengthOf(i)) / whole));
    return Array.from(
      { length: parts },
      (_, k) => /** @type {[number, number]} */ ([x + (k / parts) * (u - x), y + (k / parts) * (v - y)]),
    );
  });
}

export class Room {
  /** @param {{ app: App, session: Session }} page @param {() => void} onChange */
  constructor({ app, session }, onChange) {
    this.session = session;
    const change = () => {
      this.draw();
      onChange();
    };
    /** Whether the clearance along paths is wanted. */
    this.isMeasuring = false;
    this.widest = new Question(
      app,
      (signal, /** @type {ScenarioDocument} */ document, /** @type {string | undefined} */ query) =>
        workerWith(document).widest(query, signal),
      change,
    );
    this.safest = new Question(
      app,
      async (signal, /** @type {ScenarioDocument} */ document, /** @type {string | undefined} */ query) => {
        const found = await workerWith(document).safest(query, signal);
        return { ...found, path: divided(found.path) };
      },
      change,
    );
    this.routes = new Question(
      app,
      (signal, /** @type {ScenarioDocument} */ document, /** @type {number} */ detour) =>
        workerWith(document).routes(detour, signal),
      change,
    );
    this.along = new Question(
      app,
      (signal, /** @type {ScenarioDocument} */ document, /** @type {PathPlayback} */ { samples }) =>
        workerWith(document).clearances(samples.rows, signal),
      change,
    );
    /** The clearance along the safest path, to compare. */
    this.alongSafest = new Question(
      app,
      (signal, /** @type {ScenarioDocument} */ document, /** @type {[number, number][]} */ path) =>
        workerWith(document).clearances(Float64Array.from(path.flat()), signal),
      change,
    );
  }

  /** What can be asked of the scene. */
  get serves() {
    const robot = this.session.shown?.scenario.robot;
    return { discs: robot === "disc", routes: robot === "disc" || robot === "rigid_body" };
  }

  /** The path whose clearance is measured. @returns {PathPlayback | null} */
  get playback() {
    const playback = this.session.lanes[0]?.playback ?? null;
    return playback && !playback.isMiss ? playback : null;
  }

  /** Asks what is shown and not known. */
  update() {
    const { shown, lanes } = this.session;
    // During a gesture the scene is another one in each frame.
    if (!shown || shown.rough) return this.stop();
    const { document, query, view } = shown;
    const { serves, playback } = this;
    const isOwn = serves.discs && shown.goal !== null && !lanes[0]?.asked;
    this.widest.follow(isOwn && view.widest ? [document, query] : null);
    this.safest.follow(isOwn && view.safest ? [document, query] : null);
    this.routes.follow(serves.routes && view.routes ? [document, view.detour] : null);
    this.along.follow(this.isMeasuring && playback ? [document, playback] : null);
    const { path = [] } = this.safest.answer ?? {};
    this.alongSafest.follow(this.isMeasuring && playback && path.length > 0 ? [document, path] : null);
  }

  stop() {
    for (const question of [this.widest, this.safest, this.routes, this.along, this.alongSafest]) question.follow(null);
  }

  /** Gives the stage what is known. */
  draw() {
    const { shown } = this.session;
    if (!shown) return;
    const { answer: widest } = this.widest;
    const { answer: safest } = this.safest;
    const { answer: routes } = this.routes;
    const { along, playback } = this;
    const least = along.answer?.least && along.about?.[1] === playback ? along.answer.least : null;
    const isSome = widest || safest || routes || least;
    // The growth of the run is faint beneath what is drawn here.
    byId("stage", HTMLElement).classList.toggle("measured", Boolean(widest || safest || routes));
    shown.room = isSome ? new RoomDrawing({ document: shown.document, widest, safest, routes, least }) : null;
    this.session.markDirty();
  }
}
