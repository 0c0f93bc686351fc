/**
 * A reader of WebM files for tests, written apart from the writer: the tree of EBML elements, and the frames in its
 * clusters.
 */
import assert from "node:assert/strict";

/** Elements with elements in them. */
const MASTERS = new Set(["1a45dfa3", "18538067", "1549a966", "1654ae6b", "ae", "e0", "1f43b675", "a0"]);

/** @param {Uint8Array} bytes */
export function readWebm(bytes) {
  /** @type {Map<string, Uint8Array[]>} contents by id, in the order of the file */
  const found = new Map();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);

  /** A number of variable length. @param {number} at @param {boolean} isId   ids keep their marker */
  const number = (at, isId) => {
    const length = Math.clz32(bytes[at]) - 23;
    assert.ok(length >= 1 && length <= 8, `a number at ${at}`);
    let value = isId ? bytes[at] : bytes[at] & ((1 << (8 - length)) - 1);
    for (let i = 1; i < length; i++) value = 256 * value + bytes[at + i];
    return { value, next: at + length, isUnknown: !isId && value === 2 ** (7 * length) - 1 };
  };
  /** @param {number} from @param {number} to */
  const read = (from, to) => {
    for (let at = from; at < to;) {
      const id = number(at, true);
      const size = number(id.next, false);
      assert.ok(!size.isUnknown, "every size is known");
      const end = size.next + size.value;
      assert.ok(end <= to, `element ${id.value.toString(16)} at ${at} ends after what it is in`);
      const name = id.value.toString(16);
      found.set(name, [...(found.get(name) ?? []), bytes.subarray(size.next, end)]);
      if (MASTERS.has(name)) read(size.next, end);
      at = end;
    }
  };
  read(0, bytes.length);

  /** The only element with an id. @param {string} id */
  const one = (id) => {
    const all = found.get(id) ?? [];
    assert.equal(all.length, 1, `one element ${id}`);
    return all[0];
  };
  const whole = (/** @type {string} */ id) => one(id).reduce((value, byte) => 256 * value + byte, 0);
  const text = (/** @type {string} */ id) => new TextDecoder().decode(one(id));
  const length = one("4489");
  const at = length.byteOffset - bytes.byteOffset;
  const duration = length.length === 4 ? view.getFloat32(at) : view.getFloat64(at);
  return {
    kind: text("4282"),
    codec: text("86"),
    width: whole("b0"),
    height: whole("ba"),
    tracks: found.get("ae")?.length ?? 0,
    /** Seconds. */
    duration: (duration * whole("2ad7b1")) / 1e9,
    frames: (found.get("a3")?.length ?? 0) + (found.get("a1")?.length ?? 0),
  };
}
