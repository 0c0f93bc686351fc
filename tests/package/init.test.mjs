/**
 * Starting the package by its web entry: before, by every kind of input, twice, at once, after a failure and after a trap.
 * Each case runs in a fresh Node process, since a process starts the package once.
 */
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { spawn } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { root } from "../../scripts/run.mjs";
import { disc } from "./scenes.mjs";

const place = join(root, "dist", "package");
const web = pathToFileURL(join(place, "planarium.js")).href;
const wasm = join(place, "planarium_bg.wasm");

/** Serves the module well, as another type, not at all, and cut short. @type {import("node:http").Server} */
let server;
/** @type {string} */
let site;

before(async () => {
  const bytes = readFileSync(wasm);
  server = createServer((request, response) => {
    if (request.url === "/good") response.writeHead(200, { "content-type": "application/wasm" }).end(bytes);
    else if (request.url === "/untyped") response.writeHead(200, { "content-type": "application/octet-stream" }).end(bytes);
    else if (request.url === "/broken") response.writeHead(200, { "content-type": "application/wasm" }).end(bytes.subarray(0, 1000));
    else response.writeHead(404).end("no");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  site = `http://127.0.0.1:${/** @type {import("node:net").AddressInfo} */ (server.address()).port}`;
});
after(() => server.close());

/** Runs a program in a process of its own, and gives back what it prints. @param {string} program @returns {Promise<any>} */
async function printed(program) {
  const child = spawn(process.execPath, ["--input-type=module", "-e", program], { stdio: ["ignore", "pipe", "inherit"] });
  let output = "";
  child.stdout.setEncoding("utf8").on("data", (text) => { output += text; });
  const code = await new Promise((resolve) => child.on("close", resolve));
  assert.equal(code, 0);
  return JSON.parse(output);
}

/**
 * Runs a program that gives a value back.
 * @param {string} body  of an async function; has `planarium` (the web entry), `bytes`, `site`, `disc`, `caught`, `plan`
 */
const fresh = (body) => printed(`
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

for (const [what, input] of Object.entries({
  "a URL as text": "`${site}/good`",
  "a URL": "new URL(`${site}/good`)",
  "a Request": "new Request(`${site}/good`)",
  "a Response": "await fetch(`${site}/good`)",
  "a promise of a Response": "fetch(`${site}/good`)",
  "a Response of another type": "fetch(`${site}/untyped`)",
  "bytes": "bytes",
  "an ArrayBuffer": "bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength)",
  "a compiled module": "new WebAssembly.Module(bytes)",
  "an object with module_or_path": "{ module_or_path: fetch(`${site}/good`) }",
})) {
  test(`init takes ${what}`, async () => {
    assert.equal(await fresh(`const result = await init(${input}); if (result !== undefined) throw new Error("init gives nothing"); return plan();`), await expectedFingerprint());
  });
}

for (const [what, input] of Object.entries({ bytes: "bytes", "a compiled module": "new WebAssembly.Module(bytes)", "an object with module": "{ module: bytes }" })) {
  test(`initSync takes ${what}`, async () => {
    assert.equal(await fresh(`initSync(${input}); return plan();`), await expectedFingerprint());
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
  const { missing, broken, silly, nothing, foreign, late, fingerprint } = await fresh(`
    const missing = await caught(() => init(site + "/missing"));
    const broken = await caught(() => init(site + "/broken"));
    const silly = await caught(() => init(42));
    const nothing = await caught(() => initSync(undefined));
    const foreign = await caught(() => init(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])));
    const late = await caught(() => Scenario.parse(disc));
    await init(site + "/good");
    return { missing, broken, silly, nothing, foreign, late, fingerprint: plan() };`);
  for (const error of [missing, broken, silly, nothing, foreign]) assert.equal(error.code, "init-failed");
  assert.match(missing.message, /404/);
  assert.match(silly.message, /Number/);
  assert.match(foreign.message, /planarium_bg\.wasm/);
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
