/**
 * A growing table of numbers: rows of one width, kept in one typed array that doubles when it is full.
 * Rows are only added, never changed, so whoever draws them needs no more than a cursor.
 * @template {Float64Array | Uint32Array | Uint8Array} A
 */
export class Rows {
  /**
   * @param {(length: number) => A} make  makes a typed array of that length
   * @param {number} width                numbers a row
   */
  constructor(make, width) {
    this.make = make;
    this.width = width;
    /** Rows held. */
    this.count = 0;
    /** @type {A} the rows, one after the other; only the first `count * width` numbers count */
    this.data = make(width * 256);
  }

  /** Adds a block of whole rows. @param {ArrayLike<number>} block */
  add(block) {
    const used = this.count * this.width;
    const wanted = used + block.length;
    if (wanted > this.data.length) {
      const bigger = this.make(Math.max(wanted, 2 * this.data.length));
      bigger.set(this.data.subarray(0, used));
      this.data = bigger;
    }
    this.data.set(block, used);
    this.count += block.length / this.width;
  }

  /** A view of one row, good until the next `add`. @param {number} index @returns {A} */
  row(index) {
    return /** @type {A} */ (this.data.subarray(index * this.width, (index + 1) * this.width));
  }

  /** A view of the rows from one on, good until the next `add`. @param {number} first @param {number} end @returns {A} */
  slice(first, end) {
    return /** @type {A} */ (this.data.subarray(first * this.width, end * this.width));
  }
}
