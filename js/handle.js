/**
 * Handles: which objects the cores have made, and of which class. The package has two cores, and an object of one is
 * foreign to the other.
 */
import { PlanariumError } from "./error.js";

/**
 * What the core holds behind an object: a pointer, 0 once it is freed, and the number of its instance.
 * @typedef {{ __wbg_ptr: number, __wbg_inst: number }} Held
 */

/** The class of every handle, and its core. @type {WeakMap<object, { name: string, core: symbol }>} */
const classes = new WeakMap();

/**
 * Notes that a core has made an object. What it holds is copied by no `Object.assign`.
 * @template {object} H
 * @param {H} handle
 * @param {string} name  of its class
 * @param {symbol} core
 * @returns {H}
 */
export function branded(handle, name, core) {
  classes.set(handle, { name, core });
  return Object.defineProperty(handle, "__wbg_ptr", { enumerable: false });
}

/** The class of a handle; undefined for every other value. @param {unknown} value */
export function classOf(value) {
  return classes.get(/** @type {object} */ (value))?.name;
}

/**
 * Refuses a receiver that is no handle of the class, freed or not: a method that was taken from its object, or called
 * on another one.
 * @param {unknown} self
 * @param {string} name  of the class
 * @param {PropertyKey} key  of the method or the getter
 * @param {symbol} core
 * @returns {asserts self is Held}
 */
export function requireHandle(self, name, key, core) {
  const own = classes.get(/** @type {object} */ (self));
  if (own?.name === name && own.core === core) return;
  const given =
    own?.name === name
      ? `a ${name} of the other entry of the package`
      : own !== undefined
        ? `a ${own.name}`
        : self === undefined || self === null
          ? String(self)
          : `a value of type ${typeof self}`;
  const member = typeof key === "symbol" ? `[${key.description}]` : key;
  throw new PlanariumError("illegal-invocation", `${String(member)} belongs to a ${name}, and was called on ${given}.`);
}
