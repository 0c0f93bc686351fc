/**
 * `planarium/import`: the worlds and errors of `tests/golden-worlds.json`, which the native tests write, with the same
 * bits; arguments that are none; bytes that were changed; a module that is loaded on demand, and renewed after a trap.
 */
import assert from "node:assert/strict";
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { Worker } from "node:worker_threads";
import { Scenario, solve } from "planarium";
import { PlanariumError, initSync, readWorld } from "planarium/import";
import { root } from "../../scripts/run.mjs";
import { mutated, seeded } from "../page/seeded.mjs";
import { addFiles, emptyFolder, node } from "./packed.mjs";

/**
 * @typedef {{ case: string, files: { name: string, hex: string }[], options: object, outcome: { scenario?: object,
 *   report?: object, cells?: number[] | null, error?: object } }} Case
 */

/** @type {Case[]} */
const cases = JSON.parse(readFileSync(new URL("../golden-worlds.json", import.meta.url), "utf8"));

/** @param {Case} given */
const filesOf = ({ files }) =>
  files.map(({ name, hex }) => ({ name, bytes: Uint8Array.from(Buffer.from(hex, "hex")) }));

/** The fields of the error that a promise rejects with. @param {Promise<unknown>} work */
async function refusal(work) {
  const error = await work.then(
    () => assert.fail("nothing was thrown"),
    (/** @type {unknown} */ thrown) => thrown,
  );
  assert.ok(error instanceof PlanariumError, String(error));
  const { code, message, pointer, file, place, wanted } = error;
  return { code, message, pointer, file, place, wanted };
}

/** What `readWorld` is given by callers without types. @param {unknown[]} given */
const readAny = (...given) => Reflect.apply(readWorld, undefined, given);

const place = join(root, "dist", "package", "import");
const wasm = join(place, "import_bg.wasm");

/** What a program prints in a process of its own. @param {string} program */
const printed = (program) => node(["--input-type=module", "-e", program]);

/** A program that imports the entry of browsers, with files that `fetch` reads from disk. */
const WEB = `
import { readFileSync } from "node:fs";
let fetched = [];
globalThis.fetch = async (url) => {
  fetched.push(String(url).split("/").at(-1));
  if (globalThis.isOffline) throw new TypeError("offline");
  return new Response(readFileSync(new URL(url)), { headers: { "content-type": "application/wasm" } });
};
const { default: init, initSync, readWorld } = await import(${JSON.stringify(pathToFileURL(join(place, "import.js")).href)});
const glue = await import(${JSON.stringify(pathToFileURL(join(place, "import_glue.js")).href)});
const bytes = readFileSync(${JSON.stringify(wasm)});
const files = [{ name: "grid.txt", bytes: new TextEncoder().encode("0 1\\n0 0\\n") }];
const read = () => readWorld(files).then(({ grid }) => [...grid.cells].join(""), ({ code }) => code);
`;

test("worlds and errors are those of the crate, bit for bit", async () => {
  assert.ok(cases.length >= 30);
  for (const given of cases) {
    const { scenario, report, cells, error } = given.outcome;
    const read = readWorld(filesOf(given), given.options);
    if (error !== undefined) {
      const { pointer, ...found } = await refusal(read);
      assert.deepEqual(JSON.parse(JSON.stringify(found)), error, given.case);
      assert.equal(pointer, "");
      continue;
    }
    const world = await read;
    assert.deepEqual(world.scenario, scenario, given.case);
    assert.deepEqual(world.report, report, given.case);
    Scenario.parse(world.scenario).free();
    const { grid } = world;
    assert.equal(grid === undefined, cells === null, given.case);
    if (!grid) continue;
    const rows = Array.from({ length: grid.height }, (_, i) => [
      ...grid.cells.subarray(i * grid.width, (i + 1) * grid.width),
    ]);
    assert.deepEqual(rows.reverse().flat(), cells, given.case);
    const [lowest] = world.report.bounds;
    if (grid.yaw === 0) assert.deepEqual(grid.origin, lowest, given.case);
    assert.equal(grid.resolution, world.report.grid?.resolution);
  }
});

test("a map is read and planned in", async () => {
  const bytes = new TextEncoder().encode("000\n010\n000\n");
  const options = { robot: { type: "disc", radius: 0.2 }, start: [0.5, 0.5], goal: [2.5, 2.5] };
  const { scenario } = await readWorld([{ name: "room.txt", bytes }], /** @type {any} */ (options));
  assert.equal(solve(scenario, { seed: 1 }).status, "solved");
});

test("arguments that are none are refused by name and place", async () => {
  const file = { name: "a", bytes: new Uint8Array(4) };
  /** @type {[unknown[], string, string, RegExp][]} */
  const wrong = [
    [[], "wrong-type", "/files", /an array/],
    [["a.pgm"], "wrong-type", "/files", /the text "a\.pgm"/],
    [[file], "wrong-type", "/files", /an Object/],
    [[[]], "out-of-range", "/files", /empty/],
    [[[null]], "wrong-type", "/files/0", /null/],
    [[[file, { bytes: file.bytes }]], "missing-field", "/files/1/name", /name/],
    [[[{ name: 7, bytes: file.bytes }]], "wrong-type", "/files/0/name", /the number 7/],
    [[[{ name: "a" }]], "missing-field", "/files/0/bytes", /"a"/],
    [[[{ name: "a", bytes: "P5" }]], "wrong-type", "/files/0/bytes", /the text "P5"/],
    [[[{ name: "a", bytes: new ArrayBuffer(4) }]], "wrong-type", "/files/0/bytes", /an ArrayBuffer/],
    [[[{ name: "a", bytes: new Uint16Array(4) }]], "wrong-type", "/files/0/bytes", /a Uint16Array/],
    [[[{ name: "a", bytes: new Proxy(file.bytes, {}) }]], "wrong-type", "/files/0/bytes", /Uint8Array/],
    [
      [
        [
          {
            get name() {
              throw new Error("mine");
            },
          },
        ],
      ],
      "wrong-type",
      "/files",
      /mine/,
    ],
    [[[file], 7], "wrong-type", "", /the number 7/],
    [[[file], []], "wrong-type", "", /an Array/],
    [[[file], { scale: () => 1 }], "wrong-type", "/scale", /function/],
    [[[file], { minIsland: 3 }], "unknown-field", "/minIsland", /"minIsland".* min_island$/],
    [[[file], { scales: 3 }], "unknown-field", "/scales", /nearest is scale$/],
    [[[file], { min_island: -1 }], "out-of-range", "/min_island", /-1/],
    [[[file], { scale: NaN }], "not-finite", "/scale", /NaN/],
    [[[file], { "a/b~": NaN }], "not-finite", "/a~1b~0", /NaN/],
    [[[file], { start: [0, Infinity], goal: [1, 1] }], "not-finite", "/start/1", /Infinity/],
    [[[file], { scale: null }], "wrong-type", "/scale", /null/],
    [[[file], { unknown: "maybe" }], "out-of-range", "/unknown", /occupied, free.*"maybe"/],
    [[[file], { robot: "disc" }], "wrong-type", "/robot", /"disc"/],
    [[[file], { robot: { radius: 1 } }], "missing-field", "/robot/type", /type/],
    [[[file], { robot: { type: "arm" } }], "unknown-type", "/robot/type", /point, disc, footprint, car.*"arm"/],
    [[[file], { robot: { type: "disc" } }], "missing-field", "/robot/radius", /radius/],
    [[[file], { robot: { type: "disc", radius: 1, length: 2 } }], "unknown-field", "/robot/length", /radius/],
  ];
  for (const [given, code, pointer, sentence] of wrong) {
    const { message, ...found } = await refusal(readAny(...given));
    assert.deepEqual({ code: found.code, pointer: found.pointer }, { code, pointer }, message);
    assert.match(message, sentence);
  }
});

test("the bytes are those of the call, whatever array they are in", async () => {
  const text = new TextEncoder().encode("type octile\nheight 1\nwidth 2\nmap\n.@\n");
  const shared = new Uint8Array(new SharedArrayBuffer(text.length));
  shared.set(text);
  const within = new Uint8Array(text.length + 8).subarray(3, 3 + text.length);
  within.set(text);
  const lying = Object.defineProperty(Uint8Array.from(text), "length", { value: 1e9 });
  for (const bytes of [shared, within, lying, Buffer.from(text)]) {
    const read = readWorld([{ name: "a.map", bytes }]);
    bytes.fill(0);
    assert.deepEqual([...((await read).grid?.cells ?? [])], [0, 1]);
  }
  const detached = Uint8Array.from(text);
  structuredClone(detached.buffer, { transfer: [detached.buffer] });
  const { code, message } = await refusal(readWorld([{ name: "a.map", bytes: detached }]));
  assert.equal(code, "wrong-type");
  assert.match(message, /detached/);
});

test("what is too long is refused", async () => {
  const { code, file } = await refusal(readWorld([{ name: "long", bytes: new Uint8Array(2 ** 26 + 1) }]));
  assert.deepEqual([code, file], ["world-too-large", "long"]);
});

test("changed bytes are read or refused", async () => {
  const random = seeded(1);
  const worlds = cases.filter(({ outcome }) => outcome.scenario).map((given) => ({ ...given, files: filesOf(given) }));
  const counts = { read: 0, refused: 0 };
  for (let i = 0; i < 2000; i++) {
    const { files, options } = random.pick(worlds);
    const changed = files.map(({ name, bytes }) => ({
      name,
      bytes: random.chance(0.7) ? mutated(bytes, random) : bytes,
    }));
    try {
      Scenario.parse((await readWorld(changed, options)).scenario).free();
      counts.read += 1;
    } catch (error) {
      assert.ok(error instanceof PlanariumError && error.code !== "internal", String(error));
      counts.refused += 1;
    }
  }
  assert.ok(counts.read > 0 && counts.refused > 0, JSON.stringify(counts));
});

test("the entry of browsers loads its module with the first world, once", () => {
  const found = printed(`${WEB}
    const before = fetched.length;
    globalThis.isOffline = true;
    const offline = await read();
    globalThis.isOffline = false;
    const cells = await Promise.all([read(), read()]);
    console.log(JSON.stringify({ before, offline, cells, later: await read(), fetched }));`);
  assert.deepEqual(found, {
    before: 0,
    offline: "init-failed",
    cells: ["0001", "0001"],
    later: "0001",
    fetched: ["import_bg.wasm", "import_bg.wasm"],
  });
});

test("init and initSync load it from elsewhere, and refuse the module of another entry", () => {
  const found = printed(`${WEB}
    const other = readFileSync(${JSON.stringify(join(root, "dist", "package", "planarium_bg.wasm"))});
    const refused = await init(other).catch(({ code, message }) => [code, /import_bg\\.wasm/.test(message)]);
    initSync(bytes);
    await init(new URL("nowhere", import.meta.url));
    console.log(JSON.stringify({ refused, cells: await read(), fetched }));`);
  assert.deepEqual(found, { refused: ["init-failed", true], cells: "0001", fetched: [] });
  initSync(readFileSync(wasm));
});

test("after a trap the next world is read by a fresh module", () => {
  const found = printed(`${WEB}
    await init(bytes);
    new Uint8Array(glue.initSync().memory.buffer).fill(0xff);
    const lost = await read();
    console.log(JSON.stringify([lost, await read(), await read()]));`);
  assert.deepEqual(found, ["internal", "0001", "0001"]);
});

test("memory is given back after each world", () => {
  const [small, large] = printed(`${WEB}
    await read();
    const small = glue.initSync().memory.buffer.byteLength;
    const picture = new Uint8Array(2 ** 24 + 30).fill(255);
    picture.set(new TextEncoder().encode("P5 4096 4096 255\\n"));
    await readWorld([{ name: "a.pgm", bytes: picture }]);
    console.log(JSON.stringify([small, glue.initSync().memory.buffer.byteLength]));`);
  assert.equal(large, small);
});

test("the example plans on a map, and finds the picture that it names", () => {
  const folder = emptyFolder();
  addFiles(folder, {
    "map.yaml":
      "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n",
    "map.pgm": "P2 3 3 255\n255 255 255\n255 0 255\n255 255 255\n",
  });
  const args = [join(root, "examples", "map.mjs"), join(folder, "map.yaml"), "0.2", "0.5,0.5", "2.5,2.5"];
  const { status, path } = node(args);
  assert.equal(status, "solved");
  assert.deepEqual(
    [path[0], path.at(-1)],
    [
      [0.5, 0.5],
      [2.5, 2.5],
    ],
  );
});

test("a worker reads worlds", async () => {
  const entry = pathToFileURL(join(place, "import-node.js")).href;
  const worker = new Worker(
    `const { parentPort } = require("node:worker_threads");
     import(${JSON.stringify(entry)})
       .then(({ readWorld }) => readWorld([{ name: "a.txt", bytes: new TextEncoder().encode("0 1\\n0 0\\n") }]))
       .then(({ scenario }) => parentPort.postMessage(scenario.world.obstacles.length));`,
    { eval: true },
  );
  const [count] = await once(worker, "message");
  assert.equal(count, 1);
});
