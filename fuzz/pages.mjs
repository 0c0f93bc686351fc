/**
 * Mutations of fixtures and links, given to the readers of the pages: `node fuzz/pages.mjs SECONDS [SEED]`. Each one is
 * read, or refused with an error of its own kind. `tests/page/exchange-*.test.mjs` try a few of them with every test.
 */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { deflateRawSync } from "node:zlib";
import { mutated, seeded } from "../tests/page/seeded.mjs";
import { NpyError } from "../www/formats/dtype.js";
import { readNpy, readNpyPolygons } from "../www/formats/npy.js";
import { decodeLink, encodeLink } from "../www/planner/link/codec.js";

const [seconds = 60, seed = Date.now() % 2 ** 31] = process.argv.slice(2).map(Number);
const random = seeded(seed);
const folder = new URL("../tests/page/fixtures/", import.meta.url);
const files = readdirSync(folder)
  .filter((name) => name.endsWith(".npy"))
  .map((name) => new Uint8Array(readFileSync(new URL(name, folder))));
const documents = ["stones", "corner"].map((id) => ({
  document: JSON.parse(readFileSync(new URL(`../www/scenes/${id}.json`, import.meta.url), "utf8")),
}));
const lane = { algorithm: "rrt-connect", settings: { step: 0.1, seed: 7 } };
const experiment = {
  scene: "stones",
  query: "through",
  iteration: 12,
  lanes: [lane, { algorithm: "prm" }],
  view: { axes: [0, 1], raw: true },
};

/** Several mutations, one upon the other. @param {Uint8Array} bytes */
function changed(bytes) {
  for (let n = 1 + random.below(3); n > 0 && bytes.length > 0; n--) bytes = mutated(bytes, random);
  return bytes;
}

/** @param {(bytes: Uint8Array) => unknown} read @param {Uint8Array} bytes */
function tryFile(read, bytes) {
  try {
    read(bytes);
    return 1;
  } catch (error) {
    assert.ok(
      error instanceof NpyError,
      `seed ${seed}: ${Buffer.from(bytes).toString("base64")}\n${error instanceof Error ? error.stack : error}`,
    );
    return 0;
  }
}

let [tried, readable] = [0, 0];
for (const end = performance.now() + 1000 * seconds; performance.now() < end; tried += 3) {
  readable += tryFile(readNpy, changed(random.pick(files))) + tryFile(readNpyPolygons, changed(random.pick(files)));
  const json = new TextEncoder().encode(
    JSON.stringify(random.pick([experiment, { ...experiment, ...random.pick(documents), scene: undefined }])),
  );
  const fragment = `1${deflateRawSync(random.chance(0.8) ? changed(json) : json).toString("base64url")}`;
  const { experiment: found, fault } = await decodeLink(fragment);
  assert.ok(found || /^This link does not work: [^\n]{3,900}\.$/.test(fault), `seed ${seed}: ${fragment} ${fault}`);
  if (found) await encodeLink(found);
  readable += Number(found !== null);
}
console.log(`seed ${seed}: ${tried} inputs, ${readable} of them readable`);
