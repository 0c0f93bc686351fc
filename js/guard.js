/**
 * The classes and functions of the core, each wrapped once: arguments are copied before the core is entered, and
 * whatever is thrown is a `PlanariumError`.
 */
import { renamed } from "./catalogue.js";
import { Thrown, during, functionsOf, refuseDepth, refuseWaiting } from "./callback.js";
import { PlanariumError, isFromCore } from "./error.js";
import { growth } from "./growth.js";
import { branded, requireHandle } from "./handle.js";
import { plain } from "./plain.js";
import { asOwn, core, currentInstance, isSound, requireCore } from "./runtime.js";

/** @typedef {(this: unknown, ...given: any[]) => unknown} Callable */

/** Where objects come from whose classes have no public constructor. @type {Record<string, string | undefined>} */
const SOURCES = {
  Scenario: "Scenario.parse or Scenario.generate",
  Planner: "the methods planner and resume of a Scenario or a Problem, or planner and straightPlanner of a Navigation",
  Reach: "scenario.reach(options)",
  Trajectory: "scenario.time(result, limits) or scenario.trajectory(document)",
  ShortestPaths: "scenario.shortestPaths()",
  Subdivision: "scenario.certify(options)",
  Neighbours: "scenario.neighbours(options)",
  Drive: "scenario.drive(q)",
  Experiment: "Experiment.parse",
  Trial: "experiment.trial(number)",
  Fleet: "Fleet.parse or Fleet.generate",
  FleetPlanner: "fleet.planner(options)",
  Navigation: "Navigation.parse or Navigation.generate",
  Training: "navigation.training(options)",
  NavigationComparison: "navigation.comparison(policy, options)",
};

/**
 * The exports of the glue, guarded. Its classes are changed in place, so that objects that the core makes are guarded
 * too.
 * @template {object} G
 * @param {G} glue
 * @returns {G}
 */
export function guarded(glue) {
  const wrapped = Object.entries(glue)
    .filter(
      ([name, value]) =>
        typeof value === "function" && !name.startsWith("__") && name !== "initSync" && name !== "default",
    )
    .map(([name, value]) => [
      name,
      SOURCES[name] || value.prototype?.free ? guardedClass(value, name) : guardedFunction(value, { key: name }),
    ]);
  return Object.fromEntries(wrapped);
}

/** @param {Function} Class @param {string} name */
function guardedClass(Class, name) {
  const { prototype } = Class;
  // The glue is minified.
  Object.defineProperty(Class, "name", { value: name });
  // Options are in camelCase in JavaScript; documents are as they are everywhere.
  const spell = name === "Experiment" ? asItIs : inCamelCase;
  for (const [key, { value, get }] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
    if (key === "constructor" || key === "free" || key.startsWith("__")) continue;
    const guard = get
      ? {
          get() {
            return enter(get, this, [], { key, name });
          },
        }
      : { value: guardedFunction(value, { key, name, spell }), writable: true };
    Object.defineProperty(prototype, key, { ...guard, configurable: true });
  }
  for (const key of ["parse", "generate"]) {
    if (!(key in Class)) continue;
    const make = Reflect.get(Class, key);
    Reflect.set(Class, key, guardedFunction(key === "parse" ? asText(make) : make, { key, spell }));
  }
  // What the core makes passes here, but for the constructors below.
  const wrap = Reflect.get(Class, "__wrap");
  if (typeof wrap === "function")
    Reflect.set(Class, "__wrap", (/** @type {number} */ pointer) => branded(wrap.call(Class, pointer), name, core));
  const { free } = prototype;
  const release = /** @this {unknown} */ function () {
    requireHandle(this, name, "free", core);
    if (!this.__wbg_ptr) return;
    refuseWaiting(this, name);
    if (isSound() && this.__wbg_inst === currentInstance()) enter(free, this, [], { key: "free", name });
    this.__wbg_ptr = 0;
  };
  const stream = guardedFunction(/** @type {Callable} */ (growth), { key: "growth", name });
  const additions = {
    free: release,
    ...(Symbol.dispose ? { [Symbol.dispose]: release } : {}),
    [Symbol.for("nodejs.util.inspect.custom")]: inspected,
    // A proxy is no handle: Vue makes none of an object with this property.
    __v_skip: true,
    ...(name === "Planner" ? { growth: stream, [Symbol.asyncIterator]: stream } : {}),
  };
  for (const key of Reflect.ownKeys(additions)) {
    Object.defineProperty(prototype, key, { value: Reflect.get(additions, key), configurable: true, writable: true });
  }
  const guard = new Proxy(Class, {
    construct(target, given, made) {
      const source = SOURCES[name];
      if (source !== undefined)
        throw new PlanariumError("illegal-constructor", `A ${name} is made by ${source}, not by \`new\`.`);
      const functions = name === "Problem" ? functionsOf(given[0]) : undefined;
      const make = (/** @type {unknown[]} */ ...copies) => {
        // Not enumerable, so that it is no field of the description.
        if (functions !== undefined && typeof copies[0] === "object" && copies[0] !== null)
          Object.defineProperty(copies[0], "functions", { value: functions });
        return branded(Reflect.construct(target, copies, made), name, core);
      };
      return /** @type {object} */ (
        guardedFunction(make, { key: "constructor", functions: Object.keys(functions ?? {}) })(...given)
      );
    },
  });
  prototype.constructor = guard;
  return guard;
}

/** The longest text that the core reads, in characters. */
const LONGEST_TEXT = 32 * 2 ** 20;

/**
 * The copy of a document as text, if text says the same: what is not finite is null in it, and some pages have a
 * `toJSON` for every array.
 * @param {unknown} document
 */
function textOf(document) {
  if (typeof document !== "object" || document instanceof Error || ArrayBuffer.isView(document)) return undefined;
  if ("toJSON" in Array.prototype) return undefined;
  try {
    const text = JSON.stringify(document);
    return text.length <= LONGEST_TEXT && !text.includes("null") ? text : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Hands documents over as text: an object costs a call for each of its values. If the text itself is refused, the object
 * is read, so that the error is about that.
 * @param {Callable} parse
 * @returns {Callable}
 */
function asText(parse) {
  return function (document) {
    const text = textOf(document);
    try {
      if (text !== undefined) return parse.call(this, text);
    } catch (error) {
      if (!isFromCore(error) || (error.code !== "invalid-json" && error.code !== "too-large")) throw error;
    }
    return parse.call(this, document);
  };
}

/**
 * What is entered.
 * @typedef {object} Entry
 * @property {string} key  its name
 * @property {string} [name]  of the class that it is called on a living object of
 * @property {typeof inCamelCase} [spell]  how errors name options
 * @property {string[]} [functions]  the fields of its arguments that are functions, and are called where they are
 */

/** @param {Callable} operation @param {Entry} entry @returns {Callable} */
function guardedFunction(operation, entry) {
  return function (...given) {
    refuseDepth();
    return enter(operation, this, given, entry);
  };
}

/**
 * Enters the core.
 * @param {Callable} operation
 * @param {unknown} self
 * @param {unknown[]} given  replaced by copies
 * @param {Entry} entry
 */
function enter(operation, self, given, { key, name, spell = inCamelCase, functions }) {
  refuse(self, key, name);
  for (let i = 0; i < given.length; i += 1) {
    if (typeof given[i] !== "object" || given[i] === null) continue;
    given[i] = plain(/** @type {object} */ (given[i]), functions);
    refuse(self, key, name);
  }
  try {
    const result = during(self, () => operation.apply(self, given));
    // A function that the core has called may have lost it, and gone on.
    requireCore();
    return result;
  } catch (error) {
    if (error instanceof Thrown) throw error.value;
    throw spell(asOwn(error), given);
  }
}

/**
 * Refuses a core that is not there, and an object that is of another class or gone.
 * @param {unknown} self
 * @param {string} key
 * @param {string | undefined} name
 */
function refuse(self, key, name) {
  requireCore();
  if (name === undefined) return;
  requireHandle(self, name, key, core);
  const { __wbg_ptr, __wbg_inst } = self;
  if (!__wbg_ptr) throw new PlanariumError("freed", `This ${name} has been freed.`);
  if (__wbg_inst !== currentInstance()) {
    throw new PlanariumError("freed", `This ${name} was lost when Planarium's core stopped; make a new one.`);
  }
  if (name === "Planner") refuseWaiting(self, name);
}

/** An error of the core as it is. @param {PlanariumError} error */
const asItIs = (error) => error;

/**
 * An error of the core with options by their names in JavaScript.
 * @param {PlanariumError} error
 * @param {unknown[]} given
 */
function inCamelCase(error, given) {
  const cause = given.find((copy) => copy instanceof Error)?.cause;
  if (!`${error.message}${error.pointer}`.includes("_") && cause === undefined) return error;
  const own = given.filter((copy) => typeof copy === "object" && copy !== null).flatMap(Object.keys);
  const names = new Map(
    [...renamed, ...own].map((name) => [name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`), name]),
  );
  const spelled = (/** @type {string} */ text) => text.replace(/[a-z]\w*_\w+/g, (word) => names.get(word) ?? word);
  return new PlanariumError(error.code, spelled(error.message), spelled(error.pointer), {
    cause: cause ?? error.cause,
    nearest: error.nearest,
  });
}

/**
 * What `console.log` shows in Node: the class and the values of its getters.
 * @this {object}
 * @param {number} _depth
 * @param {object} options
 * @param {(value: object, options: object) => string} inspect
 */
function inspected(_depth, options, inspect) {
  const prototype = Object.getPrototypeOf(this);
  const getters = Object.entries(Object.getOwnPropertyDescriptors(prototype)).filter(
    ([, { get }]) => get !== undefined,
  );
  const { name } = prototype.constructor;
  try {
    return `${name} ${inspect(Object.fromEntries(getters.map(([key, { get }]) => [key, get?.call(this)])), options)}`;
  } catch (error) {
    return `${name} (${asOwn(error).code})`;
  }
}
