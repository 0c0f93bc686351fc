/** The project's own scripts: the server, the count of tests, the guard over versions. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createServer } from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { countsOfHarness, countsOfTap } from "../../scripts/counts.mjs";
import { Problem, root } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { addFiles, emptyFolder } from "./packed.mjs";

test("the server sends each kind of file as what it is, and nothing from outside its folder", async () => {
  const folder = emptyFolder();
  addFiles(folder, { "secret.txt": "no", "page/index.html": "<p>hello", "page/a.js": "1", "page/b.json": "{}", "page/c.wasm": "x", "page/d.css": "", "page/e.svg": "<svg/>" });
  const { url, close } = await serve({ root: join(folder, "page"), port: 0 });
  try {
    const type = async (/** @type {string} */ path) => (await fetch(url + path)).headers.get("content-type")?.split(";")[0];
    assert.equal(await (await fetch(url)).text(), "<p>hello");
    assert.equal(await type(""), "text/html");
    assert.equal(await type("a.js"), "text/javascript");
    assert.equal(await type("b.json"), "application/json");
    assert.equal(await type("c.wasm"), "application/wasm");
    assert.equal(await type("d.css"), "text/css");
    assert.equal(await type("e.svg"), "image/svg+xml");
    assert.equal((await fetch(`${url}missing.js`)).status, 404);
    assert.equal((await fetch(`${url}..%2fsecret.txt`)).status, 404);
  } finally {
    await close();
  }
});

test("a taken port is named at once, by serve and by npm start", async () => {
  const squatter = createServer();
  await new Promise((resolve) => squatter.listen(0, () => resolve(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (squatter.address());
  try {
    await assert.rejects(serve({ root, port }), (error) => error instanceof Problem && error.message.includes(`Port ${port} is taken`));
    const began = performance.now();
    const { status, stderr } = spawnSync(process.execPath, [join(root, "scripts", "start.mjs")], { env: { ...process.env, PORT: String(port) }, encoding: "utf8", timeout: 30_000 });
    assert.equal(status, 1);
    assert.match(stderr, new RegExp(`Port ${port} is taken`));
    assert.ok(performance.now() - began < 10_000);
  } finally {
    squatter.close();
  }
});

test("a PORT that is none is refused", () => {
  for (const PORT of ["eighty", "-1", "65536", "80.5", ""]) {
    const { status, stderr } = spawnSync(process.execPath, [join(root, "scripts", "start.mjs")], { env: { ...process.env, PORT }, encoding: "utf8", timeout: 30_000 });
    assert.equal(status, 1, PORT);
    assert.match(stderr, /PORT must be/);
  }
});

test("counts are summed over test programs, and missing when there is none", () => {
  assert.deepEqual(
    countsOfHarness("running 2 tests\ntest result: ok. 2 passed; 0 failed; 0 ignored; 0 measured\n...\ntest result: FAILED. 3 passed; 1 failed; 0 ignored\n"),
    { passed: 5, failed: 1 },
  );
  assert.equal(countsOfHarness("no tests to run!\n"), undefined);
  assert.deepEqual(countsOfTap("ok 1 - x\n1..1\n# tests 4\n# pass 1\n# fail 2\n# cancelled 1\n# skipped 0\n"), { passed: 1, failed: 3 });
  assert.equal(countsOfTap("TAP version 13\n"), undefined);
});
