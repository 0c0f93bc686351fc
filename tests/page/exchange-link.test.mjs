/** Links: an experiment goes into a fragment and comes back the same; nothing else comes in. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { KEY_TEXT, keyText, keysOf } from "../../www/domain/key-text.js";
import { EULER_STEPS } from "../../www/domain/euler-steps.js";
import { decodeLink, encodeLink } from "../../www/planner/link/codec.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { root } from "./browser.mjs";
import { mutated, seeded } from "./seeded.mjs";

/** @import { Experiment, Settings, View } from "../../www/planner/link/codec.js" */

const SENTENCE = /^This link does not work: [^\n]{3,900}\.$/;

/** @type {Experiment} */
const PLAIN = { version: 1, scene: "stones", lanes: [{ algorithm: "prm", settings: {} }], iteration: 0, view: {} };

/** @param {string} text */
const fragmentOf = (text) => `1${deflateRawSync(text).toString("base64url")}`;

/** @param {string} fragment */
async function refused(fragment) {
  const { experiment, fault } = await decodeLink(fragment);
  assert.equal(experiment, null);
  assert.match(fault ?? "", SENTENCE);
  return fault ?? "";
}

/** @param {ReturnType<typeof seeded>} random @returns {Settings} */
function randomSettings(random) {
  const values = [
    () => random.below(1000),
    () => -random.next() * 1e-9,
    () => random.next() * 1e300,
    () => random.chance(0.5),
    () => random.pick(["uniform", "", 'ä<"&\u2603', "obstacle-based"]),
  ];
  return Object.fromEntries(
    Array.from({ length: random.below(9) }, (_, i) => [
      `${random.pick(["k", "step", "Edge_Check", "x-"])}${i}`,
      random.pick(values)(),
    ]),
  );
}

/** @param {ReturnType<typeof seeded>} random @returns {import("planarium").KeyPress[]} */
function randomRecord(random) {
  let step = 0;
  return Array.from({ length: random.below(60) }, () => ({
    step: (step += random.below(300)),
    key: random.pick(/** @type {const} */ (["faster", "slower", "left", "right", "keep"])),
  }));
}

/** @param {ReturnType<typeof seeded>} random @returns {Experiment} */
function randomExperiment(random) {
  /** @type {View} */
  const view = {};
  if (random.chance(0.3)) view.axes = [random.below(8), random.below(8)];
  for (const flag of /** @type {const} */ (["refused", "strobe", "raw", "projector"]))
    if (random.chance(0.4)) view[flag] = random.chance(0.7);
  if (random.chance(0.4)) view.lens = random.pick(["workspace", "cspace"]);
  /** @type {Experiment} */
  const experiment = {
    version: 1,
    lanes: Array.from({ length: 1 + random.below(4) }, () => ({
      algorithm: random.pick(["prm", "rrt-connect", "rrt_star"]),
      settings: randomSettings(random),
    })),
    iteration: random.chance(0.5) ? 0 : random.below(2 ** 31),
    view,
  };
  if (random.chance(0.7)) experiment.scene = random.pick(["stones", "firs", "a", "B-2_c"]);
  if (experiment.scene === undefined || random.chance(0.3)) {
    experiment.document = {
      name: "eigene Szene \u{1f600}",
      world: {
        obstacles: [
          {
            vertices: [
              [random.next(), -1],
              [0, 1e-7],
              [3, null],
            ],
          },
          {},
          [],
        ],
      },
      free: random.chance(0.5),
    };
  }
  if (random.chance(0.3)) experiment.pace = 1 + random.below(1000);
  if (random.chance(0.5)) experiment.query = random.pick(["round", "to the left", "Größe"]);
  if (random.chance(0.4)) experiment.options = randomSettings(random);
  if (random.chance(0.3)) experiment.pose = Array.from({ length: 1 + random.below(8) }, () => random.next() * 7 - 3.5);
  else if (random.chance(0.3)) {
    experiment.drive = { keys: keyText(randomRecord(random)), steps: random.below(1e6) };
    if (random.chance(0.5)) experiment.drive.start = [random.next(), -random.next(), 7];
    if (random.chance(0.5)) experiment.roll = [random.next() - 0.5, random.next() - 0.5, 10 * random.next()];
    if (random.chance(0.5)) experiment.euler = random.pick(EULER_STEPS);
  }
  return experiment;
}

test("500 random experiments come back as they were, but for what is off by default", async () => {
  const random = seeded(1);
  for (let i = 0; i < 500; i++) {
    const experiment = randomExperiment(random);
    const fragment = await encodeLink(experiment);
    assert.match(fragment, /^1[\w-]+$/);
    const view = Object.fromEntries(
      Object.entries(experiment.view).filter(([, value]) => value !== false && value !== "workspace"),
    );
    const expected = { experiment: { ...experiment, view }, fault: null };
    assert.deepEqual(await decodeLink(fragment), expected);
    assert.deepEqual(await decodeLink(`#${fragment}`), expected);
  }
});

test("every built-in scene has a link of less than 2 kB, with all lanes and options", async () => {
  for (const { id, algorithm, settings } of SCENES) {
    const lanes = Array.from({ length: 4 }, (_, i) => ({ algorithm, settings: { ...settings, seed: 4294967295 - i } }));
    const options = Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`option-${i}`, i + 0.125]));
    /** @type {Experiment} */
    const experiment = {
      version: 1,
      scene: id,
      query: "there and back",
      lanes,
      iteration: 100000,
      view: { axes: [0, 1], refused: true, strobe: true, raw: true, projector: true, lens: "cspace" },
      options,
    };
    const fragment = await encodeLink(experiment);
    assert.ok(fragment.length < 2000, `${id}: ${fragment.length}`);
    assert.deepEqual((await decodeLink(fragment)).experiment, experiment);
    assert.ok((await encodeLink({ ...PLAIN, scene: id, lanes: lanes.slice(0, 1) })).length < 200, id);
  }
});

test("a whole scenario fits a link, and comes back", async () => {
  const document = JSON.parse(readFileSync(join(root, "www", "scenes", "thicket.json"), "utf8"));
  const { scene, ...rest } = PLAIN;
  const fragment = await encodeLink({ ...rest, document });
  assert.ok(fragment.length < 8000, String(fragment.length));
  assert.deepEqual((await decodeLink(fragment)).experiment, { ...rest, document });
});

test("keys come back from their text, and a long drive fits a short link", async () => {
  const random = seeded(4);
  for (let i = 0; i < 100; i++) {
    const record = randomRecord(random);
    assert.match(keyText(record), KEY_TEXT);
    assert.deepEqual(keysOf(keyText(record)), record);
  }
  const long = Array.from({ length: 400 }, (_, i) => ({
    step: 40 * i + random.below(40),
    key: random.pick(/** @type {const} */ (["faster", "slower", "left", "right"])),
  }));
  const fragment = await encodeLink({ ...PLAIN, scene: "parking", drive: { keys: keyText(long), steps: 16_000 } });
  assert.ok(fragment.length < 1500, `${fragment.length} characters for 400 keys`);
});

test("what is off is left out", async () => {
  const link = await encodeLink(PLAIN);
  assert.equal(
    await encodeLink({
      ...PLAIN,
      query: undefined,
      view: { refused: false, strobe: false, lens: "workspace", axes: undefined },
    }),
    link,
  );
  assert.equal((await encodeLink({ ...PLAIN, view: { raw: true } })) === link, false);
  assert.deepEqual(
    (await decodeLink(fragmentOf('{"scene":"stones","lanes":[{"algorithm":"prm"}]}'))).experiment,
    PLAIN,
  );
});

test("a fault says which entry is wrong", async () => {
  const lanes = '"lanes":[{"algorithm":"prm"}]';
  /** @type {[string, RegExp][]} */
  const cases = [
    [`{"scene":"stones",${lanes},"colour":1}`, /experiment\.colour is unknown/],
    [`{"scene":"stones",${lanes},"version":2}`, /experiment\.version is wrong/],
    [`{"scene":"stones","lanes":[]}`, /experiment\.lanes is wrong/],
    [
      `{"scene":"stones","lanes":[${'{"algorithm":"prm"},'.repeat(4)}{"algorithm":"prm"}]}`,
      /experiment\.lanes is wrong/,
    ],
    [`{"scene":"stones","lanes":{"0":{"algorithm":"prm"}}}`, /experiment\.lanes is wrong/],
    [`{"scene":"stones","lanes":[{"settings":{}}]}`, /lacks a scene or an algorithm/],
    [`{"scene":"stones"}`, /lacks a scene or an algorithm/],
    [`{${lanes}}`, /lacks a scene or an algorithm/],
    [
      `{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"k":null}}]}`,
      /experiment\.lanes\.0\.settings\.k is wrong/,
    ],
    [
      `{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"k":1e999}}]}`,
      /experiment\.lanes\.0\.settings\.k is wrong/,
    ],
    [`{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"k":[1]}}]}`, /settings\.k is wrong/],
    [`{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"k":"${"x".repeat(257)}"}}]}`, /settings\.k is wrong/],
    [
      `{"scene":"stones","lanes":[{"algorithm":"prm","settings":{${Array.from({ length: 65 }, (_, i) => `"k${i}":1`)}}}]}`,
      /settings is wrong/,
    ],
    [`{"scene":"stones","lanes":[{"algorithm":"../prm"}]}`, /lanes\.0\.algorithm is wrong/],
    [`{"scene":"${"s".repeat(65)}",${lanes}}`, /experiment\.scene is wrong/],
    [`{"scene":"stones\\n",${lanes}}`, /experiment\.scene is wrong/],
    [`{"scene":"constructor",${lanes}}`, /experiment\.scene is wrong/],
    [`{"scene":"stones",${lanes},"iteration":-1}`, /experiment\.iteration is wrong/],
    [`{"scene":"stones",${lanes},"iteration":0.5}`, /experiment\.iteration is wrong/],
    [`{"scene":"stones",${lanes},"iteration":1e300}`, /experiment\.iteration is wrong/],
    [`{"scene":"stones",${lanes},"iteration":"7"}`, /experiment\.iteration is wrong/],
    [`{"scene":"stones",${lanes},"view":{"axes":[0]}}`, /view\.axes is wrong/],
    [`{"scene":"stones",${lanes},"view":{"axes":[0,1.5]}}`, /view\.axes\.1 is wrong/],
    [`{"scene":"stones",${lanes},"view":{"strobe":1}}`, /view\.strobe is wrong/],
    [`{"scene":"stones",${lanes},"view":{"lens":"inside"}}`, /view\.lens is wrong/],
    [`{"scene":"stones",${lanes},"query":7}`, /experiment\.query is wrong/],
    [`{"scene":"stones",${lanes},"options":[]}`, /experiment\.options is wrong/],
    [`{"scene":"stones",${lanes},"document":null}`, /experiment\.document is wrong/],
    [`{"scene":"stones",${lanes},"document":[]}`, /experiment\.document is wrong/],
    [`{"scene":"stones",${lanes},"pose":[]}`, /experiment\.pose is wrong/],
    [`{"scene":"stones",${lanes},"pose":[0,"1"]}`, /experiment\.pose\.1 is wrong/],
    [`{"scene":"stones",${lanes},"drive":[]}`, /experiment\.drive is wrong/],
    [`{"scene":"stones",${lanes},"drive":{"record":[]}}`, /drive\.record is unknown/],
    [`{"scene":"stones",${lanes},"drive":{"keys":"5x"}}`, /drive\.keys is wrong/],
    [`{"scene":"stones",${lanes},"drive":{"keys":"w"}}`, /drive\.keys is wrong/],
    [`{"scene":"stones",${lanes},"drive":{"keys":"12345678w"}}`, /drive\.keys is wrong/],
    [`{"scene":"stones",${lanes},"drive":{"keys":"${"1w".repeat(40000)}"}}`, /drive\.keys is wrong/],
    [`{"scene":"stones",${lanes},"drive":{"steps":1000001}}`, /drive\.steps is wrong/],
    [`{"scene":"stones",${lanes},"drive":{"start":[0,0]}}`, /drive\.start is wrong/],
    [`{"scene":"stones",${lanes},"roll":[0.3,0.4]}`, /experiment\.roll is wrong/],
    [`{"scene":"stones",${lanes},"roll":[0.3,0.4,null]}`, /experiment\.roll\.2 is wrong/],
    [`{"scene":"stones",${lanes},"euler":0.2}`, /experiment\.euler is wrong/],
    [`{"document":{"x":[0,{"y":-1e999}]},${lanes}}`, /document\.x\.1\.y is wrong/],
    [`{"document":{"x":${"[".repeat(40)}${"]".repeat(40)}},${lanes}}`, /document\.x\.0\.0.* is wrong/],
    [`{"document":{"x":[{"__proto__":{"free":true}}]},${lanes}}`, /__proto__ is wrong/],
    [`{"scene":"stones",${lanes},"__proto__":{"query":"x"}}`, /__proto__ is wrong/],
    [`{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"__proto__":1}}]}`, /__proto__ is wrong/],
    [`{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"toString":1}}]}`, /toString is wrong/],
    [`{"scene":"stones","lanes":[{"algorithm":"prm","settings":{"prototype":1}}]}`, /prototype is wrong/],
    [`{"scene":"stones","l\\nes":[]}`, /experiment\.l\\u\{a\}es is wrong/],
    [`{"scene":"stones","a\u2028\u202e\\ud800b":[]}`, /experiment\.a\\u\{2028\}\\u\{202e\}\\u\{d800\}b is wrong/],
    ["null", /experiment is wrong/],
    ["7", /experiment is wrong/],
    ["[]", /experiment is wrong/],
    ['"text"', /experiment is wrong/],
    ["", /damaged/],
    ["{", /damaged/],
    ["{}{}", /damaged/],
    [`${"[".repeat(300000)}`, /damaged|wrong/],
    [`${"[".repeat(100000)}${"]".repeat(100000)}`, /wrong/],
  ];
  for (const [text, pattern] of cases) assert.match(await refused(fragmentOf(text)), pattern, text.slice(0, 200));
});

test("what is no link at all is refused in words", async () => {
  assert.match(await refused(""), /version 1/);
  assert.match(await refused("#"), /version 1/);
  assert.match(await refused("#gallery"), /version 1/);
  assert.match(await refused(`2${(await encodeLink(PLAIN)).slice(1)}`), /version 1/);
  assert.match(await refused(`${await encodeLink(PLAIN)}=`), /version 1/);
  assert.match(await refused(`##${await encodeLink(PLAIN)}`), /version 1/);
  assert.match(await refused("1abcde"), /damaged/);
  assert.match(await refused(`1${"A".repeat(65537)}`), /too long/);
  assert.match(await refused(`1${Buffer.from([0xff, 0xfe, 0]).toString("base64url")}`), /damaged/);
  assert.match(
    await refused(`1${deflateRawSync(Buffer.from([0x22, 0xc3, 0x28, 0x22])).toString("base64url")}`),
    /damaged/,
    "not UTF-8",
  );
  await refused(/** @type {string} */ (/** @type {unknown} */ (undefined)));
});

test("a bomb is not unpacked beyond the limit", async () => {
  const bomb = fragmentOf(" ".repeat(45e6));
  assert.ok(bomb.length < 65536, String(bomb.length));
  assert.match(await refused(bomb), /too long/);
  // Just below the limit it is read, and refused for what it is.
  assert.match(await refused(fragmentOf(" ".repeat(1 << 20))), /damaged/);
  assert.match(await refused(fragmentOf(" ".repeat((1 << 20) + 1))), /too long/);
});

test("400 fuzzed fragments never throw, and what is let in is an experiment", async () => {
  const random = seeded(2);
  const names = Object.getOwnPropertyNames(Object.prototype).length;
  let accepted = 0;
  for (let i = 0; i < 400; i++) {
    const experiment = randomExperiment(random);
    const whole = await encodeLink(experiment);
    const json = new TextEncoder().encode(JSON.stringify({ ...experiment, version: undefined }));
    const kinds = [
      () => new TextDecoder("latin1").decode(mutated(new TextEncoder().encode(whole), random)),
      () => whole.slice(0, random.below(whole.length)),
      () => `1${Buffer.from(mutated(Buffer.from(whole.slice(1), "base64url"), random)).toString("base64url")}`,
      () => `1${deflateRawSync(mutated(json, random)).toString("base64url")}`,
      () => Array.from({ length: random.below(300) }, () => String.fromCharCode(random.below(300))).join(""),
      () => `1${Buffer.from(Array.from({ length: random.below(300) }, () => random.below(256))).toString("base64url")}`,
      () => fragmentOf(JSON.stringify(experiment).replace(/"(iteration|view|algorithm|k\d)"/, '"__proto__"')),
      () => fragmentOf(random.pick(["{", "[", '"', "0"]).repeat(random.below(2e6))),
    ];
    const result = await decodeLink(kinds[i % kinds.length]());
    if (result.experiment === null) assert.match(result.fault, SENTENCE);
    else {
      accepted++;
      assert.deepEqual(Object.getPrototypeOf(result.experiment), Object.prototype);
      await encodeLink(result.experiment);
    }
  }
  assert.ok(accepted > 0 && accepted < 200, `${accepted} were let in`);
  assert.equal(Object.getOwnPropertyNames(Object.prototype).length, names);
});

test("what would be refused is not encoded", async () => {
  const wrong = /** @type {unknown[]} */ ([
    { ...PLAIN, version: 2 },
    { ...PLAIN, scene: "a b" },
    { ...PLAIN, lanes: [] },
    { ...PLAIN, iteration: NaN },
    { ...PLAIN, iteration: -1 },
    { ...PLAIN, scene: undefined },
    { ...PLAIN, colour: "red" },
    { ...PLAIN, options: { k: Infinity } },
    { ...PLAIN, document: { x: [NaN] } },
    { ...PLAIN, view: { axes: [0, 1, 2] } },
  ]);
  for (const experiment of wrong)
    await assert.rejects(encodeLink(/** @type {Experiment} */ (experiment)), { message: SENTENCE });
  const random = seeded(3);
  const noise = { ...PLAIN, document: { x: Array.from({ length: 9000 }, random.next) } };
  await assert.rejects(encodeLink(noise), /too long/);
  await assert.rejects(encodeLink({ ...PLAIN, document: { x: " ".repeat(1 << 20) } }), /too long/);
});
