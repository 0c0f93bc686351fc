/** The planner's page with this arm and world, and the target as what is to be reached. */
import { encodeLink } from "../planner/link/codec.js";

/** @import { PlannerInfo } from "planarium" */
/** @import { Bench } from "./bench.js" */

/** What is to be planned: from a pose to wherever the tip is at the target. @param {Bench} bench @param {ArrayLike<number>} start @returns {import("planarium").Query} */
export function targetQuery({ target: point, lock }, start) {
  return { name: "reach", start: Array.from(start), target: { point, ...(lock === null ? {} : { orientation: lock }) } };
}

/** Address of the planner's page where that is planned, by a planner that grows two trees. @param {Bench} bench @param {ArrayLike<number>} start @param {Pick<PlannerInfo, "id" | "grows">[]} planners @returns {Promise<string>} */
export async function planLink(bench, start, planners) {
  const { id } = planners.find(({ grows }) => grows === "trees") ?? planners[0];
  const document = { ...bench.arm.document, queries: [targetQuery(bench, start)] };
  return `./#${await encodeLink({ version: 1, document, lanes: [{ algorithm: id, settings: {} }], iteration: 0, view: {} })}`;
}
