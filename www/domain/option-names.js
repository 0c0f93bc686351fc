/** Names of options: snake_case on pages, in links and in documents, camelCase in the package. */

/** @import { Settings } from "./types.js" */

/** @param {string} name */
function inCamelCase(name) {
  return name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
}

/** @param {string} name */
function inSnakeCase(name) {
  return name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
}

/**
 * @template T
 * @param {Record<string, T>} fields
 * @param {(name: string) => string} rename
 * @returns {Record<string, T>}
 */
function renamed(fields, rename) {
  return Object.fromEntries(Object.entries(fields).map(([name, value]) => [rename(name), value]));
}

/** Settings of the package under the names of documents. @template T @param {Record<string, T>} options */
export function namesOfDocuments(options) {
  return renamed(options, inSnakeCase);
}

/**
 * Calls the package with settings under its names; the pointer of an error gets the page's name.
 * @template T
 * @param {object} settings
 * @param {(options: any) => T} use
 */
export function withOptions(settings, use) {
  try {
    return use(renamed(/** @type {Record<string, unknown>} */ (settings), inCamelCase));
  } catch (error) {
    const thrown = /** @type {{ pointer?: unknown }} */ (error);
    if (typeof thrown.pointer === "string") thrown.pointer = inSnakeCase(thrown.pointer);
    throw error;
  }
}

/**
 * The settings that differ from the usual ones, sorted by name so that equal experiments have equal links.
 * @param {Settings} settings
 * @param {(name: string) => unknown} usual
 * @returns {Settings}
 */
export function changed(settings, usual) {
  return Object.fromEntries(
    Object.entries(settings)
      .filter(([name, value]) => value !== usual(name))
      .sort(),
  );
}
