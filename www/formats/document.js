/**
 * A scenario document as text that a person can read and change: one line for each row of numbers, such as the vertices
 * of a polygon.
 */

/** @param {unknown} value  plain JSON @returns {string} ends with a line break */
export function documentText(value) {
  return `${written(value, "")}\n`;
}

/** @param {unknown} value @param {string} indent @returns {string} */
function written(value, indent) {
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  const inner = `${indent}  `;
  const isList = Array.isArray(value);
  if (isList && value.flat().every((item) => typeof item === "number"))
    return JSON.stringify(value).replaceAll(",", ", ");
  const items = isList
    ? value.map((item) => written(item, inner))
    : Object.entries(value).map(([key, item]) => `${JSON.stringify(key)}: ${written(item, inner)}`);
  const [open, close] = isList ? "[]" : "{}";
  return `${open}\n${inner}${items.join(`,\n${inner}`)}\n${indent}${close}`;
}
