/** Moving pictures: every frame that went in comes out of an independent reader. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { GifWriter, paletteOf } from "../../www/formats/gif.js";
import { readGif } from "./gif.mjs";
import { seeded } from "./seeded.mjs";

const BLACK = new Uint8Array(3);

/**
 * A frame from a colour for each pixel.
 * @param {number} width
 * @param {number} height
 * @param {(x: number, y: number) => ArrayLike<number>} colour
 */
function frameOf(width, height, colour) {
  const rgba = new Uint8ClampedArray(4 * width * height);
  for (let i = 0; i < width * height; i++)
    rgba.set([...Array.from(colour(i % width, Math.floor(i / width))), 255], 4 * i);
  return rgba;
}

/** The largest and the mean difference of a channel. @param {Uint8ClampedArray} rgba @param {Uint8Array} rgb */
function differenceOf(rgba, rgb) {
  let most = 0;
  let sum = 0;
  for (let i = 0; i < rgb.length; i++) {
    const difference = Math.abs(rgba[4 * Math.floor(i / 3) + (i % 3)] - rgb[i]);
    most = Math.max(most, difference);
    sum += difference;
  }
  return { most, mean: sum / rgb.length };
}

/**
 * Frames come back exactly.
 * @param {Uint8ClampedArray[]} frames
 * @param {{ rgb: Uint8Array }[]} out
 * @param {string} [what]
 */
function assertExact(frames, out, what = "") {
  frames.forEach((rgba, i) => assert.equal(differenceOf(rgba, out[i].rgb).most, 0, `${what} frame ${i}`));
}

/**
 * Writes frames and reads them again.
 * @param {number} width
 * @param {number} height
 * @param {Uint8ClampedArray[]} frames
 * @param {Uint8Array} [palette]
 */
function played(width, height, frames, palette = paletteOf(frames.slice(0, 1))) {
  const writer = new GifWriter(width, height, palette);
  for (const rgba of frames) writer.add(rgba, 50);
  const bytes = writer.finish();
  const gif = readGif(bytes);
  assert.deepEqual([gif.width, gif.height, gif.frames.length, gif.loops], [width, height, frames.length, 0]);
  assert.ok(
    gif.frames[0].drawn.every((drawn) => drawn === 1),
    "the first frame covers all",
  );
  return { ...gif, bytes };
}

test("frames of few colours come back exactly, whatever their size", () => {
  const random = seeded(6);
  for (const [width, height] of [
    [1, 1],
    [1, 7],
    [7, 1],
    [2, 2],
    [13, 5],
    [64, 64],
    [255, 3],
    [101, 67],
  ]) {
    for (const colours of [1, 2, 3, 4, 5, 16, 17, 255]) {
      const table = Array.from({ length: colours }, () => [random.below(256), random.below(256), random.below(256)]);
      // Later frames take from the first, which has all colours if it is large enough.
      const first = frameOf(width, height, (x, y) => table[(y * width + x) % colours]);
      const frames = [
        first,
        ...[0.02, 0.3, 1].map((share) =>
          frameOf(
            width,
            height,
            (x, y) =>
              table[
                (random.chance(share) ? random.below(Math.min(colours, width * height)) : y * width + x) %
                  Math.min(colours, width * height)
              ],
          ),
        ),
      ];
      const { frames: out } = played(width, height, frames);
      assertExact(frames, out, `${width} x ${height}, ${colours} colours,`);
    }
  }
});

test("noise fills the table of codes many times, and still comes back", () => {
  const random = seeded(7);
  for (const colours of [2, 4, 200, 255, 256]) {
    const palette = Uint8Array.from({ length: 3 * colours }, (_, i) =>
      i % 3 === 0 ? Math.floor(i / 3) : 255 - Math.floor(i / 3),
    );
    const frames = Array.from({ length: 3 }, () =>
      frameOf(160, 160, () => {
        const i = random.below(colours);
        return [i, 255 - i, 255 - i];
      }),
    );
    const { frames: out } = played(160, 160, frames, palette);
    assertExact(frames, out, `${colours} colours,`);
    assert.ok(out[0].clears > (colours > 4 ? 3 : 0), `${colours} colours: ${out[0].clears} tables`);
  }
});

test("codes of every width end well: strips of every length", () => {
  const random = seeded(8);
  for (const colours of [2, 5, 60, 250]) {
    const palette = Uint8Array.from({ length: 3 * colours }, (_, i) => Math.floor(i / 3));
    for (let width = 1; width <= 1200; width += width < 600 ? 1 : 41) {
      const rgba = frameOf(width, 1, () => Array(3).fill(random.below(colours)));
      assert.equal(
        differenceOf(rgba, played(width, 1, [rgba], palette).frames[0].rgb).most,
        0,
        `${colours} colours, ${width} wide`,
      );
    }
  }
});

test("a long plain picture is small, and so is a dot that moves over it", () => {
  const dot = (/** @type {number} */ at) =>
    frameOf(300, 200, (x, y) =>
      Math.hypot(x - at, y - 100) < 6 ? [200, 30, 30] : (x + y) % 40 === 0 ? [180, 180, 190] : [250, 250, 252],
    );
  const frames = Array.from({ length: 40 }, (_, i) => dot(20 + 6 * i));
  const { bytes, frames: out } = played(300, 200, frames);
  assertExact(frames, out);
  for (const { box } of out.slice(1)) assert.ok(box.width <= 18 && box.height <= 12, JSON.stringify(box));
  assert.ok(bytes.length < 12000, String(bytes.length));
});

test("a frame that changes nothing is a frame", () => {
  const rgba = frameOf(9, 9, (x) => [x, 0, 0]);
  const { frames } = played(9, 9, [rgba, rgba, rgba]);
  assert.deepEqual(
    frames.map(({ box }) => box.width * box.height),
    [81, 1, 1],
  );
  assert.equal(differenceOf(rgba, frames[2].rgb).most, 0);
});

test("a whole palette leaves no colour to be transparent, and needs none", () => {
  const palette = Uint8Array.from({ length: 768 }, (_, i) => Math.floor(i / 3));
  const frames = [0, 1, 2].map((shift) =>
    frameOf(32, 16, (x, y) => Array(3).fill((x + 32 * y * (shift ? 1 : 2) + shift) % 256)),
  );
  const { frames: out, colours } = played(32, 16, frames, palette);
  assert.deepEqual(colours, palette);
  assertExact(frames, out);
});

test("delays are rounded so that their sum stays right", () => {
  const rgba = frameOf(2, 2, () => [0, 0, 0]);
  const writer = new GifWriter(2, 2, BLACK);
  for (let i = 0; i < 300; i++) writer.add(rgba, 1000 / 30);
  writer.add(rgba, 2500);
  const delays = readGif(writer.finish()).frames.map(({ delay }) => delay);
  assert.ok(delays.slice(0, 300).every((delay) => delay === 3 || delay === 4));
  assert.ok(Math.abs(delays.reduce((sum, delay) => sum + delay, 0) - 1250) <= 1);
  const fast = new GifWriter(2, 2, BLACK);
  for (let i = 0; i < 5; i++) fast.add(rgba, 1);
  assert.deepEqual(
    readGif(fast.finish()).frames.map(({ delay }) => delay),
    [2, 2, 2, 2, 2],
    "shorter ones are not played as such",
  );
});

test("of many colours those that cover most are exact, the others near", () => {
  const random = seeded(9);
  // A drawing: plain grounds, and soft edges of some thousand colours.
  const grounds = [
    [250, 250, 252],
    [30, 60, 90],
    [200, 80, 20],
    [11, 13, 17],
  ];
  const drawing = frameOf(200, 200, (x, y) => {
    const ground = grounds[(x > 100 ? 1 : 0) + (y > 100 ? 2 : 0)];
    const edge = Math.min(Math.abs(x - 100), Math.abs(y - 100));
    return edge < 6 ? ground.map((v) => v * (edge / 6) + 128 * (1 - edge / 6) + random.below(20)) : ground;
  });
  const palette = paletteOf([drawing], 255);
  const entries = Array.from({ length: palette.length / 3 }, (_, i) => [...palette.slice(3 * i, 3 * i + 3)].join());
  for (const ground of grounds) assert.ok(entries.includes(ground.join()), `${ground} is exact`);
  assert.ok(entries.length <= 255);
  const { most, mean } = differenceOf(drawing, played(200, 200, [drawing]).frames[0].rgb);
  assert.ok(most <= 26 && mean < 1, `${most}, ${mean}`);
  // A smooth wash of all colours, the hardest case.
  const wash = frameOf(128, 128, (x, y) => [2 * x, 2 * y, 255 - x - y]);
  const washed = differenceOf(wash, played(128, 128, [wash]).frames[0].rgb);
  assert.ok(washed.mean < 6 && washed.most < 40, JSON.stringify(washed));
});

test("a palette is made from several frames, and is exact where they have few colours", () => {
  const frames = [frameOf(8, 8, (x) => [x, 0, 0]), frameOf(8, 8, (_, y) => [0, y, 200])];
  const palette = paletteOf(frames, 16);
  assert.equal(palette.length, 48);
  const { frames: out } = played(8, 8, frames, palette);
  assertExact(frames, out);
  for (const most of [2, 3, 7, 16, 256]) {
    const random = seeded(most);
    const noise = frameOf(50, 50, () => [random.below(256), random.below(256), random.below(256)]);
    assert.equal(paletteOf([noise], most).length, 3 * most);
  }
});

test("what cannot be is refused", () => {
  for (const [width, height] of [
    [0, 1],
    [1, 65536],
    [-1, 1],
    [NaN, 2],
  ])
    assert.throws(() => new GifWriter(width, height, BLACK), /A GIF cannot be/);
  assert.throws(() => new GifWriter(2, 2, BLACK).finish(), /needs a frame/);
  assert.throws(() => new GifWriter(2, 2, BLACK).add(new Uint8ClampedArray(15), 10), /2 x 2 pixels cannot be 15 bytes/);
});
