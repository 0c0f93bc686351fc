/**
 * A growing table of numbers: rows of one width in a typed array that doubles when it is full. Rows are added and never
 * changed, so a drawing needs only a cursor.
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
    this.count = 0;
    /** Only the first `count * width` numbers are rows. @type {A} */
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

  /** A view of one row, valid until the next `add`. @param {number} index @returns {A} */
  row(index) {
    return this.slice(index, index + 1);
  }

  /** A view of rows, valid until the next `add`. @param {number} first @param {number} end @returns {A} */
  slice(first, end) {
    return /** @type {A} */ (this.data.subarray(first * this.width, end * this.width));
  }
}
