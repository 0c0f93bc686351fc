/** The one error type of the package. */

/** @import { FilePlace } from "./core.js" */

/**
 * What the package throws: a stable code, a sentence with the offending value, and its JSON pointer. The codes are
 * those of the crate (`invalid-json`, `unknown-field`, `start-in-collision`, ...), and `not-initialised` (call `init`
 * first), `no-simd` (the engine has no vector instructions), `init-failed` (the WebAssembly file could not be loaded),
 * `freed` (use after `free`), `in-use` (a function that a planner calls uses that planner), `too-deep` (calls within
 * functions of problems are nested too deep), `illegal-constructor` (the class has no public constructor),
 * `illegal-invocation` (a method was called on something that is no object of its class), `module-failed` (the module
 * of a problem for a worker could not be loaded, or has no such export) and `internal` (a fault in Planarium: please
 * report it). `planarium/import` has codes of its own, which docs/worlds.md lists.
 */
export class PlanariumError extends Error {
  /**
   * @param {string} code     stable, in kebab-case; programs may match on it
   * @param {string} message  a sentence for people
   * @param {string} [pointer]  JSON pointer (RFC 6901) of the offending value; empty for the whole
   * @param {ErrorOptions & { nearest?: readonly number[], file?: string, place?: FilePlace, wanted?: string }} [options]
   *   the `cause`, the `nearest` free configuration, and of a file its name, the place in it and the file that it
   *   wants, if any
   */
  constructor(code, message, pointer = "", options = undefined) {
    super(message, options);
    /** Always `"PlanariumError"`. @type {string} */
    this.name = "PlanariumError";
    /** Stable code in kebab-case, for programs. @type {string} */
    this.code = code;
    /** JSON pointer of the offending value in the document or the arguments; empty for the whole. @type {string} */
    this.pointer = pointer;
    /**
     * Of a start or a goal in collision, the nearest free configuration that was found; else undefined.
     * @type {readonly number[] | undefined}
     */
    this.nearest = options?.nearest;
    /** Of `readWorld`, the name of the file that the error is about, as given. @type {string | undefined} */
    this.file = options?.file;
    /** Of `readWorld`, where in that file, if it is known. @type {FilePlace | undefined} */
    this.place = options?.place;
    /** Of `missing-file`, the name of that file as another one has it. @type {string | undefined} */
    this.wanted = options?.wanted;
  }
}

/**
 * Whether a value is an error of the package: anything can be thrown, also a revoked proxy.
 * @param {unknown} value
 * @returns {value is PlanariumError} @internal
 */
export function isOwn(value) {
  try {
    return value instanceof PlanariumError;
  } catch {
    return false;
  }
}

/** The message of a thrown value: some have no string form. @param {unknown} thrown @returns {string} @internal */
export function reasonOf(thrown) {
  try {
    return String(thrown instanceof Error ? thrown.message : thrown);
  } catch {
    return "a value without a string form was thrown";
  }
}

/**
 * Whether an error is one of the core, with code and pointer.
 * @param {unknown} error
 * @returns {error is { code: string, pointer: string, message: string, nearest?: number[] }} @internal
 */
export function isFromCore(error) {
  return (
    error instanceof Error &&
    "code" in error &&
    typeof error.code === "string" &&
    "pointer" in error &&
    typeof error.pointer === "string"
  );
}
