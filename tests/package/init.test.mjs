/**
 * Starting the package by its web entry: before, by every kind of input, twice, at once, after a failure and after a
 * trap. Each case runs in a fresh Node process, since a process starts the package once.
 */
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { execFile } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { promisify } from "node:util";
import { root } from "../../scripts/run.mjs";
import { disc } from "./scenes.mjs";

const place = join(root, "dist", "package");
const web = pathToFileURL(join(place, "planarium.js")).href;
const wasm = join(place, "planarium_bg.wasm");

/**
 * Serves the module well, as another type, not at all, cut short, and a page in its place.
 * @type {import("node:http").Server}
 */
let server;
/** @type {string} */
let site;

before(async () => {
  const bytes = readFileSync(wasm);
  server = createServer((request, response) => {
    if (request.url === "/good") response.writeHead(200, { "content-type": "application/wasm" }).end(bytes);
    else if (request.url === "/untyped")
      response.writeHead(200, { "content-type": "application/octet-stream" }).end(bytes);
    else if (request.url === "/broken")
      response.writeHead(200, { "content-type": "application/wasm" }).end(bytes.subarray(0, 1000));
    else if (request.url === "/page") response.writeHead(200, { "content-type": "text/html" }).end("<!doctype html>");
    else response.writeHead(404).end("no");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  site = `http://127.0.0.1:${/** @type {import("node:net").AddressInfo} */ (server.address()).port}`;
});
after(() => server.close());

/**
 * Runs a program in a process of its own, and returns what it prints.
 * @param {string} program
 * @returns {Promise<any>}
 */
async function printed(program) {
  const { stdout } = await promisify(execFile)(process.execPath, ["--expose-gc", "--input-type=module", "-e", program]);
  return JSON.parse(stdout);
}

/**
 * Runs a program that gives a value back.
 * @param {string} body  of an async function; has `planarium` (the web entry), `bytes`, `site`, `disc`, `caught`,
 *   `plan`
 */
const fresh = (body) =>
  printed(`
import { readFileSync } from "node:fs";
const planarium = await import(${JSON.stringify(web)});
const { default: init, initSync, Scenario, PlanariumError } = planarium;
const bytes = readFileSync(${JSON.stringify(wasm)});
const site = ${JSON.stringify(site)};
const disc = ${JSON.stringify(disc)};
const plan = () => { const p = Scenario.parse(disc).planner({ seed: 5 }); while (p.step(100) === "running"); return p.fingerprint(); };
const caught = async (work) => { try { await work(); } catch (error) {
  if (!(error instanceof PlanariumError)) throw error;
  return { code: error.code, pointer: error.pointer, message: error.message };
} return null; };
const answer = await (async () => { ${body} })();
console.log(JSON.stringify(answer));
`);

/** The fingerprint that every way of starting must lead to. @type {Promise<string>} */
let expected;
const expectedFingerprint = () => (expected ??= fresh("initSync(bytes); return plan();"));

test("importing the web entry does nothing: no global is added, nothing is fetched", async () => {
  const found = await printed(`
const before = Object.getOwnPropertyNames(globalThis).length;
let fetched = 0;
globalThis.fetch = () => { fetched += 1; };
await import(${JSON.stringify(web)});
console.log(JSON.stringify({ added: Object.getOwnPropertyNames(globalThis).length - before, fetched }));`);
  assert.deepEqual(found, { added: 0, fetched: 0 });
});

test("every call before init says that init is missing", async () => {
  const errors = await fresh(`return [
    await caught(() => Scenario.parse(disc)),
    await caught(() => Scenario.generate("forest")),
    await caught(() => planarium.planners()),
    await caught(() => planarium.randomSeed()),
  ];`);
  assert.equal(errors.length, 4);
  for (const error of errors) {
    assert.equal(error.code, "not-initialised");
    assert.match(error.message, /init\(\)/);
  }
});

for (const [what, call] of Object.entries({
  "init takes a URL as text": "init(`${site}/good`)",
  "init takes a URL": "init(new URL(`${site}/good`))",
  "init takes a Request": "init(new Request(`${site}/good`))",
  "init takes a Response": "init(await fetch(`${site}/good`))",
  "init takes a promise of a Response": "init(fetch(`${site}/good`))",
  "init takes a Response of another type": "init(fetch(`${site}/untyped`))",
  "init takes bytes": "init(bytes)",
  "init takes an ArrayBuffer": "init(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength))",
  "init takes a compiled module": "init(new WebAssembly.Module(bytes))",
  "init takes an object with module_or_path": "init({ module_or_path: fetch(`${site}/good`) })",
  "initSync takes bytes": "initSync(bytes)",
  "initSync takes a compiled module": "initSync(new WebAssembly.Module(bytes))",
  "initSync takes an object with module": "initSync({ module: bytes })",
})) {
  test(`${what}, and returns nothing`, async () => {
    const found = await fresh(`const result = await ${call}; return { result: String(result), fingerprint: plan() };`);
    assert.deepEqual(found, { result: "undefined", fingerprint: await expectedFingerprint() });
  });
}

test("init without an input loads the file beside the module", async () => {
  assert.equal(
    await fresh(`
      const urls = [];
      globalThis.fetch = async (url) => { urls.push(String(url)); return new Response(bytes, { headers: { "content-type": "application/wasm" } }); };
      await init();
      if (urls.length !== 1 || urls[0] !== ${JSON.stringify(pathToFileURL(wasm).href)}) throw new Error(urls.join());
      return plan();`),
    await expectedFingerprint(),
  );
});

test("an engine without vector instructions is refused", async () => {
  const errors = await fresh(`
    WebAssembly.validate = () => false;
    return [await caught(() => init(bytes)), await caught(() => initSync(bytes))];`);
  for (const error of errors) {
    assert.equal(error.code, "no-simd");
    assert.match(error.message, /vector instructions/);
  }
});

test("init called many times at once and again loads once", async () => {
  assert.deepEqual(
    await fresh(`
      let fetched = 0;
      const real = fetch;
      globalThis.fetch = (...args) => { fetched += 1; return real(...args); };
      await Promise.all([init(site + "/good"), init(site + "/good"), init(site + "/good")]);
      const scenario = Scenario.parse(disc);
      await init(site + "/good");
      initSync(bytes);
      return { fetched, name: scenario.name };`),
    { fetched: 1, name: disc.name },
  );
});

test("initSync while init still loads: the first instance stays, handles with it", async () => {
  assert.deepEqual(
    await fresh(`
      const loading = init(site + "/good");
      initSync(bytes);
      const scenario = Scenario.parse(disc);
      await loading;
      return { name: scenario.name, same: plan() };`),
    { name: disc.name, same: await expectedFingerprint() },
  );
});

test("an init that failed says why, and can be tried again", async () => {
  const { missing, broken, page, silly, nothing, foreign, other, late, fingerprint } = await fresh(`
    const missing = await caught(() => init(site + "/missing"));
    const broken = await caught(() => init(site + "/broken"));
    const page = await caught(() => init(site + "/page"));
    const silly = await caught(() => init(42));
    const nothing = await caught(() => initSync(undefined));
    const foreign = await caught(() => init(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])));
    const full = (await import("node:fs")).readFileSync(${JSON.stringify(join(place, "full", "full_bg.wasm"))});
    const other = await caught(() => init(full));
    const late = await caught(() => Scenario.parse(disc));
    await init(site + "/good");
    return { missing, broken, page, silly, nothing, foreign, other, late, fingerprint: plan() };`);
  for (const error of [missing, broken, page, silly, nothing, foreign, other]) assert.equal(error.code, "init-failed");
  assert.match(missing.message, /404/);
  assert.match(page.message, /page is an HTML page.*optimizeDeps/);
  assert.match(silly.message, /Number/);
  for (const error of [foreign, other]) assert.match(error.message, /planarium_bg\.wasm/);
  assert.equal(late.code, "not-initialised");
  assert.equal(fingerprint, await expectedFingerprint());
});

test("after a trap every call fails as internal, until init makes a fresh instance", async () => {
  const glue = pathToFileURL(join(place, "planarium_glue.js")).href;
  const { first, second, third, handle, freed, fingerprint } = await fresh(`
    await init(bytes);
    const [scenario, other] = [Scenario.parse(disc), Scenario.parse(disc)];
    // Overwriting the core's memory is the surest way to make it trap.
    const { memory } = (await import(${JSON.stringify(glue)})).initSync();
    new Uint8Array(memory.buffer).fill(0xff);
    const first = await caught(() => Scenario.parse(disc).planner());
    const second = await caught(() => planarium.planners());
    const third = await caught(() => other.free());
    await init();
    const handle = await caught(() => scenario.name);
    scenario.free();
    const freed = await caught(() => scenario.name);
    return { first, second, third, handle, freed, fingerprint: plan() };`);
  assert.equal(first.code, "internal");
  assert.match(first.message, /init\(\)/);
  assert.equal(second.code, "internal");
  assert.equal(third, null);
  assert.equal(handle.code, "freed");
  assert.match(handle.message, /lost/);
  assert.equal(freed.code, "freed");
  assert.equal(fingerprint, await expectedFingerprint());
});

test("handles that are collected after a trap are not freed into the lost core", async () => {
  const { before, after, code, fingerprint } = await printed(`
    import { readFileSync } from "node:fs";
    // Counts what the finalizers of the glue do, and the calls that free.
    let [finalized, freed] = [0, 0];
    const { FinalizationRegistry: Registry, WebAssembly: { Instance } } = globalThis;
    globalThis.FinalizationRegistry = class extends Registry { constructor(free) { super((held) => { free(held); finalized += 1; }); } };
    WebAssembly.Instance = function (module, imports) {
      const { exports } = new Instance(module, imports);
      const counted = Object.entries(exports).map(([name, value]) => [name, /^__wbg_.*_free$/.test(name) ? (...given) => { freed += 1; value(...given); } : value]);
      return { exports: Object.fromEntries(counted) };
    };
    const { default: init, initSync, Problem, Scenario } = await import(${JSON.stringify(web)});
    const { initSync: instance } = await import(${JSON.stringify(pathToFileURL(join(place, "planarium_glue.js")).href)});
    const bytes = readFileSync(${JSON.stringify(wasm)});
    const disc = ${JSON.stringify(disc)};
    initSync(bytes);
    const make = () => {
      const scenario = Scenario.parse(disc);
      return [scenario, scenario.planner(), new Problem({ space: { coordinates: [{ kind: "circle" }] }, start: [0], goal: [1], isFree() {} }), scenario.neighbours()];
    };
    const collect = async (count) => { while (finalized < count) { gc(); await new Promise((resolve) => setImmediate(resolve)); } };
    make();
    await collect(4);
    const before = freed;
    make();
    new Uint8Array(instance().memory.buffer).fill(0xff);
    let code;
    try { Scenario.parse(disc).planner(); } catch (error) { ({ code } = error); }
    await collect(8);
    const after = freed;
    await init();
    const planner = Scenario.parse(disc).planner({ seed: 5 });
    while (planner.step(100) === "running");
    console.log(JSON.stringify({ before, after, code, fingerprint: planner.fingerprint() }));`);
  assert.equal(code, "internal");
  assert.deepEqual([before, after], [4, 4], "freed before and after the trap");
  assert.equal(fingerprint, await expectedFingerprint());
});

test("a core that is lost within a function ends all calls under way, and is not replaced before", async () => {
  const glue = pathToFileURL(join(place, "planarium_glue.js")).href;
  const { codes, within, calls, fingerprint } = await fresh(`
    await init(bytes);
    const { initSync: instance } = await import(${JSON.stringify(glue)});
    const within = [];
    let calls = 0;
    const problem = new planarium.Problem({ space: { coordinates: [{ kind: "circle" }] }, start: [0], goal: [1], isFree(rows, free) {
      calls += 1;
      free.fill(1);
      new Uint8Array(instance().memory.buffer).fill(0xff);
      for (const call of [() => Scenario.parse(disc).planner(), () => initSync(bytes)]) try { call(); } catch (error) { within.push(error.code); }
    } });
    const codes = [(await caught(() => problem.planner())).code, (await caught(() => Scenario.parse(disc))).code];
    await init();
    return { codes, within, calls, fingerprint: plan() };`);
  assert.deepEqual([codes, calls], [["internal", "internal"], 1]);
  assert.deepEqual(within, ["internal", "in-use"]);
  assert.equal(fingerprint, await expectedFingerprint());
});
