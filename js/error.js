/** The one error type of the package. */

/**
 * What the package throws, always: a stable code, a sentence with the offending value, and where it stands.
 *
 * The codes are those of the crate (`invalid-json`, `unknown-field`, `start-in-collision`, ...), and five of the
 * package itself: `not-initialised` (call `init` first), `init-failed` (the WebAssembly file could not be loaded),
 * `freed` (the handle was used after `free`), `illegal-constructor` (handles come from `Scenario.parse`,
 * `Scenario.generate`, `scenario.planner`, `scenario.resume`, `scenario.reach`, `scenario.neighbours` and `scenario.drive`) and `internal` (a fault in Planarium: please report it).
 */
export class PlanariumError extends Error {
  /**
   * @param {string} code     stable, in kebab-case; programs may match on it
   * @param {string} message  a sentence for people
   * @param {string} [pointer]  JSON pointer (RFC 6901) of the offending value; empty where the whole is meant
   * @param {ErrorOptions} [options]  the `cause`, where there is one
   */
  constructor(code, message, pointer = "", options = undefined) {
    super(message, options);
    /** Always `"PlanariumError"`. @type {string} */
    this.name = "PlanariumError";
    /** Stable code in kebab-case, for programs. @type {string} */
    this.code = code;
    /** JSON pointer of the offending value in the document or the arguments; empty where the whole is meant. @type {string} */
    this.pointer = pointer;
  }
}

/**
 * Whether a value is an error of the package. Never runs the caller's own code into an error of its own: a revoked proxy can be
 * thrown too.
 * @param {unknown} value
 * @returns {value is PlanariumError}
 * @internal
 */
export function isOwn(value) {
  try {
    return value instanceof PlanariumError;
  } catch {
    return false;
  }
}

/**
 * What a thrown value says, of whatever kind it is: some have no string form.
 * @param {unknown} thrown
 * @returns {string}
 * @internal
 */
export function reasonOf(thrown) {
  try {
    return String(thrown instanceof Error ? thrown.message : thrown);
  } catch {
    return "a value without a string form was thrown";
  }
}

/**
 * Whether an error came from the core, which marks its own with a code and a pointer.
 * @param {unknown} error
 * @returns {error is { code: string, pointer: string, message: string }}
 * @internal
 */
export function isFromCore(error) {
  return error instanceof Error
    && "code" in error && typeof error.code === "string"
    && "pointer" in error && typeof error.pointer === "string";
}
