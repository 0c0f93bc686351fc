/**
 * The worker: it alone holds the WebAssembly, and draws what it plans, so that the page itself never waits for either.
 * It obeys messages `{ id, command, args }`, answers each with `{ id, value }` or `{ id, fault }`, and tells of each frame
 * with `{ state }`.
 */
import * as library from "planarium";
import { faultOf } from "../fault.js";
import { once } from "../once.js";
import { drawThumbnail } from "./thumbnail.js";
import { isPlaced } from "./names.js";
import { Theatre } from "./theatre.js";

/** @import { LayerName } from "../stage/layer.js" */
/** @import { Placed } from "../stage/placed.js" */
/** @import { DriveOrder, EditOrder, Look, PaneKind, Plan, Pointer, Programme, Scenario, Source, State, TakeRequest, ViewOptions } from "../types.js" */

const port = /** @type {{ postMessage(message: unknown, transfer?: Transferable[]): void }} */ (/** @type {unknown} */ (self));

/** Tells of a frame once its pictures have been handed over: what it says is drawn can be seen. @param {State} state */
function tellAfterFrame(state) { setTimeout(() => port.postMessage({ state })); }

/** @type {Theatre | undefined} */
let theatre;
function house() {
  if (!theatre) throw new Error("The worker has not started.");
  return theatre;
}

/** What is taken away is made here. */
const desk = once(async () => new (await import("./take.js")).Desk(house()));
const editor = once(() => import("./editor.js"));
const driving = once(() => import("./driving.js"));
const placed = once(() => import("../stage/placed.js"));

/** While something is being fetched that the stage cannot do without, all else waits its turn. @type {Promise<unknown> | undefined} */
let gate;

/** What bodies and cars need besides, fetched with the first of them. @param {Scenario} scenario @returns {Promise<Placed | null>} */
async function placedOf(scenario) {
  const { robot } = scenario.document();
  if (robot.type !== "rigid_body" && robot.type !== "car") return null;
  const { Placed } = await placed();
  return new Placed(robot);
}

const commands = {
  /** Loads the package. @param {WebAssembly.Module | ArrayBuffer} core  the WebAssembly, compiled or as bytes */
  async start(core) {
    await library.default(core);
    theatre = new Theatre(library, () => library.initSync(core), tellAfterFrame);
    return { planners: library.planners(), generators: library.generators(), version: library.version };
  },
  /** @param {Source} source @param {Programme} programme */
  async open(source, programme) {
    const scenario = house().read(source);
    const fetching = isPlaced(scenario.robot) ? placedOf(scenario) : null;
    if (!fetching) return house().open(scenario, programme, null);
    gate = fetching.catch(() => {});
    try {
      return house().open(scenario, programme, await fetching);
    } finally {
      gate = undefined;
    }
  },
  /** @param {Plan[]} plans @param {boolean} play */
  plan: (plans, play) => house().plan(plans, play),
  /** @param {string} query @param {boolean} play */
  ask: (query, play) => house().ask(query, play),
  toggle: () => house().conductor.toggle(),
  play: () => house().conductor.play(),
  pause: () => house().conductor.pause(),
  /** @param {number} steps */
  step: (steps) => house().conductor.step(steps),
  /** @param {number} time */
  seek: (time) => house().conductor.seek(time),
  finish: () => house().conductor.finish(),
  reset: () => house().reset(),
  /** @param {number} pace */
  pace: (pace) => house().setPace(pace),
  /** @param {number} part */
  along: (part) => house().conductor.along(part),
  curves: () => house().curves(),
  turn: () => house().turn.change(),
  /** @param {number[]} pose */
  hold: (pose) => house().turn.hold(Float64Array.from(pose)),
  /** @param {EditOrder} order */
  async edit(order) {
    const { editorOf } = await editor();
    return editorOf(house()).obey(order);
  },
  /** @param {DriveOrder} order */
  async drive(order) {
    const { drivingOf } = await driving();
    return drivingOf(house()).obey(order);
  },
  facts: () => house().facts(),
  /** @param {Pointer} pointer */
  async pointer(pointer) {
    await house().turn.ready();
    return house().pointer(pointer);
  },
  /** @param {number} vertex  -1: none */
  inspect: async (vertex) => (await house().turn.ready()).choose(vertex),
  /** @param {Partial<ViewOptions>} view */
  view: (view) => house().setView(view),
  /** @param {Look} look */
  dress: (look) => house().stage.dress(look),
  /** @param {string} id @param {PaneKind} kind @param {number} lane @param {Record<LayerName, OffscreenCanvas>} canvases */
  pane: (id, kind, lane, canvases) => house().stage.add(id, kind, lane, canvases),
  /** @param {string} id @param {number} width @param {number} height */
  resize: (id, width, height) => house().stage.resize(id, width, height),
  /** @param {string} id */
  unpane: (id) => house().stage.remove(id),
  /** @param {Float64Array | null} rows */
  mark: (rows) => house().mark(rows),
  /** @param {TakeRequest} request */
  take: async (request) => (await desk()).begin(request),
  takeStep: async () => (await desk()).step(),
  takeEnd: async () => (await desk()).end(),
  takeDrop: async () => (await desk()).drop(),
  /** @param {number} lane */
  log: async (lane) => (await desk()).log(lane),
  randomSeed: () => library.randomSeed(),
  /** Fetches what bodies and cars need, for when the network is gone. */
  async provide() { await placed(); },
  /** @param {Source} source @param {number} side @param {Look} look @returns {ImageBitmap} */
  thumbnail(source, side, look) {
    const scenario = house().read(source);
    try {
      return drawThumbnail(scenario, side, look);
    } finally {
      scenario.free();
    }
  },
};

/** @typedef {typeof commands} Commands */

addEventListener("message", async ({ data: { id, command, args } }) => {
  try {
    if (gate) await gate;
    const order = /** @type {(...args: unknown[]) => unknown} */ (commands[/** @type {keyof Commands} */ (command)]);
    const value = await order(...args);
    if (theatre) {
      // One that had to wait does not take back what was obeyed meanwhile.
      theatre.heard = Math.max(theatre.heard, id);
      theatre.wake();
    }
    port.postMessage({ id, value }, value instanceof ImageBitmap ? [value] : []);
  } catch (error) {
    const fault = faultOf(error);
    if (theatre) {
      theatre.heard = Math.max(theatre.heard, id);
      if (fault.code === "internal") theatre.recover();
      theatre.wake();
    }
    port.postMessage({ id, fault });
  }
});
