/** Values of a parameter, and seeds, as a line of text: "1, 3, 5", "1 to 30 by 1", "0 to 19". */

/** @import { ExperimentAxis, ExperimentSeeds } from "planarium/full" */

const NUMBER = "(-?[\\d.]+(?:e-?\\d+)?)";
const SPAN = new RegExp(`^${NUMBER} to ${NUMBER}(?: by ${NUMBER})?$`);
const RANGE = /^(\d+) to (\d+)$/;

/** @param {ExperimentAxis} axis */
export function axisText(axis) {
  return Array.isArray(axis) ? axis.join(", ") : `${axis.from} to ${axis.to} by ${axis.step}`;
}

/** @param {string} text @returns {ExperimentAxis}  the core checks its values */
export function axisOf(text) {
  const [, from, to, step = 1] = SPAN.exec(text.trim()) ?? [];
  if (from !== undefined) return { from: Number(from), to: Number(to), step: Number(step) };
  return text
    .split(",")
    .map((part) => part.trim())
    .filter(Boolean)
    .map((part) => {
      if (part === "true" || part === "false") return part === "true";
      return Number.isFinite(Number(part)) ? Number(part) : part;
    });
}

/** How many seeds these are; a document that the core has not checked may have none. @param {ExperimentSeeds | undefined} seeds */
export function seedCount(seeds) {
  return Array.isArray(seeds) ? seeds.length : (seeds?.count ?? 0);
}

/** @param {ExperimentSeeds} seeds */
export function seedsText(seeds) {
  return Array.isArray(seeds) ? seeds.join(", ") : `${seeds.from} to ${seeds.from + seeds.count - 1}`;
}

/** @param {string} text @returns {ExperimentSeeds | null}  null: it cannot be read */
export function seedsOf(text) {
  const [, from, to] = RANGE.exec(text.trim()) ?? [];
  if (from !== undefined)
    return Number(to) < Number(from) ? null : { from: Number(from), count: Number(to) - Number(from) + 1 };
  const list = text
    .split(",")
    .map((part) => part.trim())
    .filter(Boolean)
    .map(Number);
  return list.length > 0 && list.every(Number.isInteger) ? list : null;
}
