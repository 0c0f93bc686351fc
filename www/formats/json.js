/** JSON from a file of a reader. */

/**
 * @param {string} text
 * @returns {any}
 * @throws {Error} with the code that the core gives
 */
export function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw Object.assign(new Error(/** @type {Error} */ (error).message), { code: "invalid-json" });
  }
}
