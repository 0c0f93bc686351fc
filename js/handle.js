/** What a handle holds: an object of the core, alive until it is freed or its instance is lost. */
import { PlanariumError } from "./error.js";
import { call, currentInstance, isSound } from "./runtime.js";

/** Only the package's own code has this, so only it can make handles. */
export const key = Symbol("planarium");

/**
 * @template {{ free(): void }} R
 */
export class Handle {
  /** @type {R | undefined} */
  #raw;
  #instance = currentInstance();
  /** @type {string} */
  #name;

  /**
   * @param {R} raw
   * @param {string} name  of the class, for messages
   */
  constructor(raw, name) {
    this.#raw = raw;
    this.#name = name;
  }

  /**
   * Calls the core with the object.
   * @template T
   * @param {(raw: R) => T} operation
   * @returns {T}
   */
  call(operation) {
    return call(() => operation(this.#alive()));
  }

  /**
   * Reads arguments, and then calls the core with the object. Reading may run the caller's own code (getters, proxies, `toJSON`),
   * which may free the object or stop the core: so the core is entered only afterwards.
   * @template {unknown[]} A
   * @template T
   * @param {() => [...A]} read
   * @param {(raw: R, ...given: A) => T} operation
   * @returns {T}
   */
  callWith(read, operation) {
    call(() => this.#alive());
    const given = read();
    return this.call((raw) => operation(raw, ...given));
  }

  #alive() {
    if (this.#raw === undefined) throw new PlanariumError("freed", `This ${this.#name} has been freed.`);
    if (this.#instance !== currentInstance()) {
      throw new PlanariumError("freed", `This ${this.#name} was lost when Planarium's core stopped; make a new one.`);
    }
    return this.#raw;
  }

  /** Frees the object. Freeing twice, or after its instance was lost, does nothing. */
  free() {
    const raw = this.#raw;
    this.#raw = undefined;
    if (raw !== undefined && this.#instance === currentInstance() && isSound()) call(() => raw.free());
  }
}
