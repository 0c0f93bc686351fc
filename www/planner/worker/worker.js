/**
 * The worker: planners are stepped here, and pictures are made that take longer than a frame, so that the page never waits for
 * either. It obeys messages `{ id, command, args }` and answers each with `{ id, value }` or `{ id, fault }`.
 */
import * as library from "planarium";
import { faultOf } from "../../app/fault.js";
import { compete } from "./compete.js";
import { paintObstacles } from "./obstacles.js";
import { Stepper, buffersOf } from "./stepper.js";
import { drawThumbnail } from "../../draw/thumbnail.js";

/** @import { Look, Plan, Scenario, ScenarioDocument, Source } from "../../domain/types.js" */
/** @import { Painting } from "./obstacles.js" */
/** @import { Growth } from "./stepper.js" */

/**
 * @typedef {object} Advance   what is to be planned
 * @property {{ document: ScenarioDocument, plans: Plan[] } | null} fresh   new planners in place of those before
 * @property {number} column     the column of their history that is the clock, -1 for iterations
 * @property {number} wanted     the time to come to, as far as one block goes; below 0: none
 * @property {boolean} isResult  once it has come there, with the results
 */

const port = /** @type {{ postMessage(message: unknown, transfer?: Transferable[]): void }} */ (/** @type {unknown} */ (self));

/** Milliseconds of planning before what has grown is handed over. */
const BLOCK = 12;

/** @type {Scenario | null} */
let scenario = null;
/** @type {Stepper[]} */
let steppers = [];

/** @param {NonNullable<Advance["fresh"]>} fresh */
function begin({ document, plans }) {
  for (const stepper of steppers.splice(0)) stepper.free();
  scenario?.free();
  const opened = scenario = library.Scenario.parse(document);
  steppers = plans.map(({ algorithm, settings }) => new Stepper(opened, algorithm, settings));
}

/** @template T @param {Source} source @param {(scenario: Scenario) => T} then @returns {T} */
function within(source, then) {
  const { Scenario } = library;
  const opened = "generate" in source ? Scenario.generate(source.generate.kind, source.generate.options) : Scenario.parse(source.document);
  try {
    return then(opened);
  } finally {
    opened.free();
  }
}

const commands = {
  /** Loads the package. @param {WebAssembly.Module} core */
  async start(core) { await library.default(core); },
  /** Plans one block. @param {Advance} advance @returns {Growth[]} */
  advance({ fresh, column, wanted, isResult }) {
    if (fresh) begin(fresh);
    const isThere = compete(steppers, column, wanted, performance.now() + BLOCK);
    return steppers.map((stepper) => stepper.growth(isResult && isThere));
  },
  /** @param {Painting} painting @returns {ImageBitmap} */
  obstacles: (painting) => within({ document: painting.document }, (opened) => paintObstacles(opened, painting)),
  /** @param {Source} source @param {number} side @param {Look} look @returns {ImageBitmap} */
  thumbnail: (source, side, look) => within(source, (opened) => drawThumbnail(opened, side, look)),
};

/** @typedef {typeof commands} Commands */

/** The memory that a reply need not keep. @param {unknown} value @returns {Transferable[]} */
function transferOf(value) {
  if (value instanceof ImageBitmap) return [value];
  return Array.isArray(value) ? value.flatMap(buffersOf) : [];
}

addEventListener("message", async ({ data: { id, command, args } }) => {
  try {
    const order = /** @type {(...args: unknown[]) => unknown} */ (commands[/** @type {keyof Commands} */ (command)]);
    const value = await order(...args);
    port.postMessage({ id, value }, transferOf(value));
  } catch (error) {
    const fault = faultOf(error);
    if (fault.code === "internal") {
      await library.default();
      [scenario, steppers] = [null, []];
    }
    port.postMessage({ id, fault });
  }
});
