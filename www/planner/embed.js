/**
 * The page in a frame: `?embed=1` shows only the stage and its transport, and the parent controls it by messages, which
 * docs/teaching.md lists. Once ready and with each change, the frame posts its state to the parent.
 */
import { errorInfo } from "../app/error-info.js";
import { watchEscape } from "../app/escape.js";
import { paced } from "../app/paced.js";
import { entryOf, laneOf } from "./experiment.js";

/** @import { Page } from "./page.js" */
/** @import { State } from "./state.js" */
/** @import { SceneEntry, Settings } from "../domain/types.js" */

/** Milliseconds between two states that are posted. */
const PAUSE = 100;

/**
 * @typedef {{ planarium: string, id?: unknown, scene?: string, document?: object, algorithm?: string, settings?:
 *   Settings, query?: string, iteration?: number, play?: boolean, count?: number }} Order
 */

/**
 * The fields of each order beside `planarium` and `id`, with their types.
 * @type {Record<string, Record<string, "string" | "object" | "boolean" | "whole">>}
 */
const ORDERS = {
  load: {
    scene: "string",
    document: "object",
    algorithm: "string",
    settings: "object",
    query: "string",
    iteration: "whole",
    play: "boolean",
  },
  play: {},
  pause: {},
  step: { count: "whole" },
  seek: { iteration: "whole" },
  state: {},
};

/** @param {State | null} state */
function numbersOf(state) {
  if (!state) return null;
  const { playing, settled, sentence, clock, lanes, refusal } = state;
  return { playing, settled, sentence, iteration: lanes[0].iteration, clock, lanes, refusal };
}

/** An error with a code and a pointer. @param {string} code @param {string} pointer @param {string} message */
const fault = (code, pointer, message) => Object.assign(new Error(message), { code, pointer });

/** Refuses an order that is unknown, or has a field that is unknown or of another type. @param {Order} order */
function check(order) {
  if (!Object.hasOwn(ORDERS, order.planarium))
    throw fault("unknown-order", "/planarium", `There is no order "${order.planarium}".`);
  const fields = ORDERS[order.planarium];
  for (const [name, value] of Object.entries(order)) {
    if (name === "planarium" || name === "id" || value === undefined) continue;
    if (!Object.hasOwn(fields, name))
      throw fault("unknown-field", `/${name}`, `The order "${order.planarium}" has no field "${name}".`);
    const type = fields[name];
    const [isRight, wanted] =
      type === "whole"
        ? [Number.isSafeInteger(value), "a whole number"]
        : type === "object"
          ? [typeof value === "object" && value !== null && !Array.isArray(value), "an object"]
          : [typeof value === type, `a ${type}`];
    if (!isRight) throw fault("wrong-type", `/${name}`, `"${name}" must be ${wanted}, not ${JSON.stringify(value)}.`);
  }
  if (typeof order.iteration === "number" && order.iteration < 0)
    throw fault("out-of-range", "/iteration", `"iteration" must be at least 0, not ${order.iteration}.`);
  if (order.planarium === "seek" && order.iteration === undefined)
    throw fault("missing-field", "/iteration", `The order "seek" needs an "iteration".`);
}

/** Answers the messages of the parent. @param {Page} page */
export function watchParent(page) {
  /** The patch of an order, checked as far as it can be before the open scene is left. @param {Order} order */
  function patchOf({ scene, document, algorithm, settings, query, iteration }) {
    if (scene !== undefined && document !== undefined)
      throw fault("duplicate-field", "/document", "An order loads a scene or a document, not both.");
    const entry = entryOf({ scene });
    if (!entry && document === undefined)
      throw fault("unknown-scene", "/scene", `There is no scene "${String(scene)}".`);
    return { scene, document, lanes: lanesOf(entry, algorithm, settings), query, iteration };
  }

  /**
   * The settings are those of the planner that is named, or change those of the scene.
   * @param {SceneEntry | null} entry
   * @param {string | undefined} algorithm
   * @param {Settings | undefined} settings
   */
  function lanesOf(entry, algorithm, settings) {
    const [first, ...rivals] = page.record.lanes;
    const own = entry && laneOf(entry);
    if (algorithm === undefined && settings === undefined) return own ? [own, ...rivals] : undefined;
    const chosen = algorithm ?? (own ?? first).algorithm;
    const known = page.planners.parametersOf(chosen).map(({ name }) => name);
    if (known.length === 0) throw fault("unknown-planner", "/algorithm", `There is no planner "${chosen}".`);
    const unknown = Object.keys(settings ?? {}).find((name) => !known.includes(name));
    if (unknown !== undefined)
      throw fault(
        "unknown-parameter",
        `/settings/${unknown}`,
        `The planner "${chosen}" has no setting "${unknown}"; it has ${known.join(", ")}.`,
      );
    return [{ algorithm: chosen, settings: { ...(algorithm === undefined ? own?.settings : {}), ...settings } }];
  }

  /** Loads a scene. @param {Order} order */
  async function load(order) {
    const { query } = order;
    const faults = await page.open(patchOf(order), {
      play: order.play,
      isAsGiven: order.algorithm !== undefined,
      check({ queries }) {
        if (query !== undefined && !queries.includes(query))
          throw fault("unknown-query", "/query", `There is no query "${query}"; there are ${queries.join(", ")}.`);
      },
    });
    const { request } = page;
    await page.arrived();
    if (!faults || page.request !== request) throw fault("superseded", "", "Another scene was loaded meanwhile.");
    return planned(Object.keys(order.settings ?? {}));
  }

  /**
   * The state once everything is shown.
   * @param {string[]} [settings]  the names of those that were loaded
   * @throws {Error} if the run was refused
   */
  async function planned(settings = []) {
    const state = await page.arrived();
    if (!state?.refusal) return numbersOf(state);
    const { code, pointer, message } = state.refusal;
    throw fault(code, settings.includes(pointer.split("/")[1]) ? `/settings${pointer}` : pointer, message);
  }

  /** @param {Order} order @returns {Promise<unknown>} */
  async function execute(order) {
    check(order);
    if (order.planarium === "load") return load(order);
    if (order.planarium === "state") return numbersOf(await page.arrived());
    if (order.planarium === "pause") return page.run(({ timeline }) => timeline.pause());
    // There is no run that could be shown.
    if (page.state?.refusal) await planned();
    return page.run(({ timeline }) => {
      if (order.planarium === "play") timeline.play();
      else if (order.planarium === "step") timeline.step(order.count ?? 1);
      else timeline.seek(/** @type {number} */ (order.iteration));
    });
  }

  addEventListener("message", async ({ source, origin, data }) => {
    if (source !== window.parent || typeof data !== "object" || data === null || typeof data.planarium !== "string")
      return;
    const target = origin === "null" ? "*" : origin;
    const { id } = /** @type {Order} */ (data);
    try {
      window.parent.postMessage({ planarium: "answer", id, value: (await execute(data)) ?? null }, target);
    } catch (error) {
      window.parent.postMessage({ planarium: "answer", id, fault: errorInfo(error) }, target);
      if (errorInfo(error).code === "internal") page.app.fail(error);
    }
  });

  page.onState(
    paced(PAUSE, () => window.parent.postMessage({ planarium: "state", state: numbersOf(page.state) }, "*")),
  );

  watchEscape();
}
