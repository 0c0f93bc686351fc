/**
 * Tables as comma-separated values (RFC 4180): a dot for decimals, lines ended by CR LF, the names of the columns
 * first.
 */

/** @typedef {number | string | null} Cell  null, and a number that is not finite, is an empty cell */

/** @param {Cell} cell */
function written(cell) {
  const text = typeof cell === "string" || Number.isFinite(cell) ? String(cell) : "";
  return /[",\s]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

/**
 * @param {readonly string[]} columns
 * @param {readonly (readonly Cell[])[]} rows  as many cells in each as there are columns
 */
export function toCsv(columns, rows) {
  return [columns, ...rows]
    .map((row) => {
      if (row.length !== columns.length) throw new RangeError(`A row has ${row.length} cells, not ${columns.length}.`);
      return `${row.map(written).join(",")}\r\n`;
    })
    .join("");
}

/** A table as a file. @param {readonly string[]} columns @param {readonly (readonly Cell[])[]} rows */
export function csvFile(columns, rows) {
  return new Blob([toCsv(columns, rows)], { type: "text/csv" });
}
