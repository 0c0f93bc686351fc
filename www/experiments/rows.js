/**
 * The rows of an experiment, by the number of the trial: a typed array for each column, reserved at once, so that
 * memory does not grow with the trials that end. Columns of few values, such as words and parameters, are places in a
 * list.
 */

/** A cell of a row. @typedef {number | string | boolean | null} Cell */

/** The columns of times, which no seed decides. */
const TIMES = ["build_seconds", "search_seconds"];
/** The most trials of the page: about 250 bytes each. */
export const MOST = 1_000_000;

/** Columns of numbers among those of what a trial is made of. */
const SEEDS = ["world_seed", "seed"];

/** The measures among the columns of rows, and times. @param {string[]} columns */
export function measuresOf(columns) {
  return [
    ...columns
      .slice(columns.indexOf("status") + 1)
      .filter((column) => !["valid", "reason", "fingerprint"].includes(column)),
    ...TIMES,
  ];
}

export class Rows {
  /**
   * @param {string[]} columns  of the core's rows
   * @param {number} count  of trials
   * @param {string} [fingerprint]  of the experiment
   */
  constructor(columns, count, fingerprint = "") {
    this.columns = columns;
    this.count = count;
    this.fingerprint = fingerprint;
    /** How many trials have ended. */
    this.done = 0;
    this.isKnown = new Uint8Array(count);
    this.runs = new BigUint64Array(count);
    /** Numbers, NaN where there is none. @type {Map<string, Float64Array>} */
    this.numbers = new Map();
    /** Numbers of values. @type {Map<string, Uint32Array>} */
    this.codes = new Map();
    /** The values of a column in the order of their first rows. @type {Map<string, Cell[]>} */
    this.values = new Map();
    /** The numbers of these values. @type {Map<string, Map<Cell, number>>} */
    this.places = new Map();
    const ofNumbers = new Set([...SEEDS, ...measuresOf(columns)]);
    for (const column of [...columns, ...TIMES]) {
      if (ofNumbers.has(column)) this.numbers.set(column, new Float64Array(count));
      else if (!["experiment", "trial", "fingerprint"].includes(column)) {
        this.codes.set(column, new Uint32Array(count));
        this.values.set(column, []);
        this.places.set(column, new Map());
      }
    }
  }

  /**
   * @param {number} trial
   * @param {Cell[]} cells  in the order of the columns
   * @param {ArrayLike<number>} seconds  of building and searching
   */
  set(trial, cells, seconds) {
    if (!this.isKnown[trial]) this.done++;
    this.isKnown[trial] = 1;
    this.columns.forEach((column, i) => {
      if (column === "fingerprint") this.runs[trial] = BigInt(`0x${cells[i]}`);
      const numbers = this.numbers.get(column);
      if (numbers) numbers[trial] = cells[i] === null ? NaN : Number(cells[i]);
      const codes = this.codes.get(column);
      if (codes) codes[trial] = this.code(column, cells[i]);
    });
    TIMES.forEach((column, i) => {
      this.of(column)[trial] = seconds[i];
    });
  }

  /** The number of a value. @param {string} column @param {Cell} value */
  code(column, value) {
    const [values, places] = [this.values.get(column) ?? [], this.places.get(column)];
    const known = places?.get(value);
    if (known !== undefined) return known;
    places?.set(value, values.length);
    return values.push(value) - 1;
  }

  /** A column of numbers. @param {string} column */
  of(column) {
    const numbers = this.numbers.get(column);
    if (!numbers) throw new Error(`There is no column of numbers "${column}".`);
    return numbers;
  }

  /** @param {number} trial  that has ended @param {string} column @returns {Cell} */
  cell(trial, column) {
    if (column === "experiment") return this.fingerprint;
    if (column === "trial") return trial;
    if (column === "fingerprint") return this.runs[trial].toString(16).padStart(16, "0");
    const number = this.numbers.get(column)?.[trial];
    if (number !== undefined) return Number.isNaN(number) ? null : number;
    return this.values.get(column)?.[this.codes.get(column)?.[trial] ?? -1] ?? null;
  }

  /** The trials that have ended, in their order. @returns {Generator<number>} */
  *ended() {
    for (let trial = 0; trial < this.count; trial++) if (this.isKnown[trial]) yield trial;
  }

  /** The rows as records with their times. @returns {Record<string, Cell>[]} */
  records() {
    return Array.from(this.ended(), (trial) =>
      Object.fromEntries([...this.columns, ...TIMES].map((column) => [column, this.cell(trial, column)])),
    );
  }

  /** The rows as the file that `planarium sweep` writes. */
  csv() {
    return this.file(this.columns);
  }

  /** Their times, as the second file of `planarium sweep`. */
  timesCsv() {
    return this.file(["trial", ...TIMES]);
  }

  /** @param {string[]} columns */
  file(columns) {
    const parts = [`${columns.join(",")}\n`];
    for (const trial of this.ended())
      parts.push(`${columns.map((column) => written(this.cell(trial, column))).join(",")}\n`);
    return new Blob(parts, { type: "text/csv" });
  }
}

/** @param {Cell} cell */
function written(cell) {
  const text = cell === null ? "" : String(cell);
  return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}
