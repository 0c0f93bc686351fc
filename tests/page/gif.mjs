/** A reader of GIF files for tests, written apart from the writer: it plays all frames on a canvas of its own. */
import assert from "node:assert/strict";

/**
 * @typedef {object} Frame
 * @property {Uint8Array} rgb   of the whole picture after this frame, width * height * 3
 * @property {Uint8Array} drawn  1 where this or an earlier frame has drawn
 * @property {{ x: number, y: number, width: number, height: number }} box  that the frame covers
 * @property {number} delay     hundredths of a second
 * @property {number} clears    codes that began a new table
 */

/**
 * @param {Uint8Array} bytes
 * @returns {{ width: number, height: number, loops: number | null, colours: Uint8Array, frames: Frame[] }}
 */
export function readGif(bytes) {
  let at = 0;
  const byte = () => {
    assert.ok(at < bytes.length, "the file ends too soon");
    return bytes[at++];
  };
  const short = () => byte() + 256 * byte();
  const ascii = (/** @type {number} */ n) => Array.from({ length: n }, () => String.fromCharCode(byte())).join("");
  const blocks = () => {
    /** @type {number[]} */
    const data = [];
    for (let size = byte(); size > 0; size = byte()) for (let i = 0; i < size; i++) data.push(byte());
    return data;
  };

  assert.equal(ascii(6), "GIF89a");
  const width = short();
  const height = short();
  const flags = byte();
  assert.ok(flags & 0x80, "a table of colours for all frames");
  assert.equal(byte(), 0, "background");
  assert.equal(byte(), 0, "aspect");
  const colours = Uint8Array.from({ length: 3 << ((flags & 7) + 1) }, byte);
  const rgb = new Uint8Array(3 * width * height);
  const drawn = new Uint8Array(width * height);
  /** @type {Frame[]} */
  const frames = [];
  let loops = /** @type {number | null} */ (null);
  let control = { delay: 0, clear: -1 };
  for (;;) {
    const kind = byte();
    if (kind === 0x3b) break;
    if (kind === 0x21) {
      const label = byte();
      if (label === 0xff) {
        assert.equal(byte(), 11);
        assert.equal(ascii(11), "NETSCAPE2.0");
        const data = blocks();
        assert.deepEqual([data.length, data[0]], [3, 1]);
        loops = data[1] + 256 * data[2];
      } else {
        assert.equal(label, 0xf9);
        const [packed, low, high, index, ...rest] = blocks();
        assert.deepEqual(rest, []);
        assert.equal((packed >> 2) & 7, 1, "left in place");
        control = { delay: low + 256 * high, clear: packed & 1 ? index : -1 };
      }
      continue;
    }
    assert.equal(kind, 0x2c);
    const box = { x: short(), y: short(), width: short(), height: short() };
    assert.ok(
      box.width > 0 && box.height > 0 && box.x + box.width <= width && box.y + box.height <= height,
      JSON.stringify(box),
    );
    assert.equal(byte(), 0, "no table, not interlaced");
    const bits = byte();
    const { values, clears } = unpack(blocks(), bits);
    assert.equal(values.length, box.width * box.height);
    values.forEach((value, i) => {
      if (value === control.clear) return;
      assert.ok(3 * value + 2 < colours.length, `colour ${value}`);
      const pixel = (box.y + Math.floor(i / box.width)) * width + box.x + (i % box.width);
      rgb.set(colours.subarray(3 * value, 3 * value + 3), 3 * pixel);
      drawn[pixel] = 1;
    });
    frames.push({ rgb: rgb.slice(), drawn: drawn.slice(), box, delay: control.delay, clears });
  }
  assert.equal(at, bytes.length, "nothing after the end");
  return { width, height, loops, colours, frames };
}

/** @param {number[]} data @param {number} bits */
function unpack(data, bits) {
  assert.ok(bits >= 2 && bits <= 8);
  const clear = 2 ** bits;
  /** @type {number[]} */
  const values = [];
  /** @type {number[][]} */
  let table = [];
  let size = bits + 1;
  let clears = 0;
  /** @type {number[] | null} */
  let last = null;
  let bit = 0;
  const reset = () => {
    table = Array.from({ length: clear + 2 }, (_, i) => (i < clear ? [i] : []));
    size = bits + 1;
    last = null;
  };
  for (;;) {
    assert.ok(bit + size <= 8 * data.length, "the codes end too soon");
    let code = 0;
    for (let i = 0; i < size; i++, bit++) code |= ((data[bit >> 3] >> (bit & 7)) & 1) << i;
    if (code === clear) {
      reset();
      clears++;
      continue;
    }
    if (code === clear + 1) break;
    assert.ok(table.length > 0, "a clear code comes first");
    assert.ok(code < table.length || (code === table.length && last), `code ${code} of ${table.length}`);
    /** @type {number[]} */
    const entry =
      code < table.length ? table[code] : [.../** @type {number[]} */ (last), /** @type {number[]} */ (last)[0]];
    for (const value of entry) values.push(value);
    if (last && table.length < 4096) table.push([...last, entry[0]]);
    if (table.length === 2 ** size && size < 12) size++;
    last = entry;
  }
  assert.ok(8 * data.length - bit < 16, "nothing after the last code");
  return { values, clears };
}
