/** Random choices that a seed decides (mulberry32), for tests that try many things. */

/** @param {number} seed */
export function seeded(seed) {
  /** From 0 up to 1. */
  const next = () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
  /** A whole number from 0 below `n`. @param {number} n */
  const below = (n) => Math.floor(next() * n);
  /** @template T @param {readonly T[]} list @returns {T} */
  const pick = (list) => list[below(list.length)];
  return { next, below, pick, chance: (/** @type {number} */ p) => next() < p };
}

/**
 * Bytes with a few of them changed, left out, doubled or put in.
 * @param {Uint8Array} bytes @param {ReturnType<typeof seeded>} random @returns {Uint8Array}
 */
export function mutated(bytes, random) {
  const list = [...bytes];
  for (let n = 1 + random.below(4); n > 0; n--) {
    const at = random.below(list.length);
    const how = random.below(5);
    if (how === 0) list[at] = random.below(256);
    else if (how === 1) list[at] ^= 1 << random.below(8);
    else if (how === 2) list.splice(at, 1 + random.below(8));
    else if (how === 3) list.splice(at, 0, ...list.slice(at, at + random.below(16)));
    else list.splice(at, 0, random.below(256));
  }
  return Uint8Array.from(list);
}
