/**
 * The codes of variable width in which a GIF stores an image (T. Welch, A Technique for High-Performance Data
 * Compression, 1984).
 */

/**
 * @param {Uint8Array} values  one or more, below 2 ** bits
 * @param {number} bits        2 to 8
 * @returns {number[]}         the image data of a frame: the bits, blocks of up to 255 bytes, an empty block
 */
export function packCodes(values, bits) {
  const clear = 1 << bits;
  /** Codes of strings, by the code of all but the last value, and that value; 0 where there is none. */
  const codes = new Uint16Array(4096 << bits);
  /** @type {number[]} */
  const bytes = [];
  let next = clear + 2;
  let size = bits + 1;
  let held = 0;
  let count = 0;

  /** @param {number} code */
  const emit = (code) => {
    held |= code << count;
    for (count += size; count > 7; count -= 8) {
      bytes.push(held & 255);
      held >>= 8;
    }
  };

  emit(clear);
  let prefix = values[0];
  for (let i = 1; i < values.length; i++) {
    const string = (prefix << bits) | values[i];
    if (codes[string]) {
      prefix = codes[string];
      continue;
    }
    emit(prefix);
    prefix = values[i];
    if (next < 4096) {
      if (next === 1 << size) size++;
      codes[string] = next++;
    } else {
      emit(clear);
      codes.fill(0);
      next = clear + 2;
      size = bits + 1;
    }
  }
  emit(prefix);
  // A reader may expect this code a bit wider; the bits that follow it are zeros, and at least one.
  emit(clear + 1);
  bytes.push(held);
  const out = [bits];
  for (let i = 0; i < bytes.length; i += 255) out.push(Math.min(255, bytes.length - i), ...bytes.slice(i, i + 255));
  return [...out, 0];
}
