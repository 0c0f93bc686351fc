/** The planner's page with this arm and world, and the target as what is to be reached. */
import { encodeLink } from "../exchange/link.js";

/** @import { Bench } from "./bench.js" */

const ALGORITHM = "rrt-connect";

/** Address of the planner's page where an arm plans from a pose to the target. @param {Bench} bench @param {ArrayLike<number>} start @returns {Promise<string>} */
export async function planLink({ arm, target, lock }, start) {
  const goal = { point: target, ...(lock === null ? {} : { orientation: lock }) };
  const document = { ...arm.document, queries: [{ name: "reach", start: Array.from(start), target: goal }] };
  return `./#${await encodeLink({ version: 1, document, lanes: [{ algorithm: ALGORITHM, settings: {} }], iteration: 0, view: {} })}`;
}
