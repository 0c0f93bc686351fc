/** Errors of `planarium/import` as plain data, which a worker can send. */
import { errorInfo } from "../app/error-info.js";

/** @import { Fault } from "./types.js" */

/** @param {unknown} error @returns {Fault} */
export function faultOf(error) {
  const { file = "", place = null, wanted = "" } = /** @type {Partial<Fault>} */ (Object(error));
  return { ...errorInfo(error), file, place, wanted };
}
