/** The project's own scripts: the server, the count of tests, the guard over versions. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { judge } from "../../benches/peers/aims.mjs";
import { figures } from "../../benches/peers/report.mjs";
import { flat, rows } from "../../benches/peers/worlds.mjs";
import { countsOfHarness, countsOfTap } from "../../scripts/counts.mjs";
import { unlessMade } from "../../scripts/kept.mjs";
import { Problem, root } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { addFiles, emptyFolder } from "./packed.mjs";

test("the server sends each kind of file as what it is, and nothing from outside its folder", async () => {
  const folder = emptyFolder();
  addFiles(folder, {
    "secret.txt": "no",
    "page/index.html": "<p>hello",
    "page/a.js": "1",
    "page/b.json": "{}",
    "page/c.wasm": "x",
    "page/d.css": "",
    "page/e.svg": "<svg/>",
  });
  const { url, close } = await serve({ root: join(folder, "page"), port: 0 });
  try {
    const type = async (/** @type {string} */ path) =>
      (await fetch(url + path)).headers.get("content-type")?.split(";")[0];
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
    await assert.rejects(
      serve({ root, port }),
      (error) => error instanceof Problem && error.message.includes(`Port ${port} is in use`),
    );
    const { status, stdout, stderr } = spawnSync(process.execPath, [join(root, "scripts", "start.mjs")], {
      env: { ...process.env, PORT: String(port) },
      encoding: "utf8",
      timeout: 30_000,
    });
    assert.equal(status, 1);
    assert.match(stderr, new RegExp(`Port ${port} is in use`));
    assert.equal(stdout, "", "nothing is built first");
  } finally {
    squatter.close();
  }
});

test("a PORT that is none is refused", () => {
  for (const PORT of ["eighty", "-1", "65536", "80.5", ""]) {
    const { status, stderr } = spawnSync(process.execPath, [join(root, "scripts", "start.mjs")], {
      env: { ...process.env, PORT },
      encoding: "utf8",
      timeout: 30_000,
    });
    assert.equal(status, 1, PORT);
    assert.match(stderr, /PORT must be/);
  }
});

test("a step of the build is left out while its input is the same and its output is whole", async () => {
  const made = join("dist", "kept-test");
  const file = join(root, made, "part", "one.txt");
  let count = 0;
  const step = (/** @type {unknown} */ given, fail = false) =>
    unlessMade("kept-test", [made], given, async () => {
      count++;
      if (fail) throw new Problem("it fails");
      mkdirSync(dirname(file), { recursive: true });
      writeFileSync(file, "made");
    });
  try {
    for (const [expected, change] of /** @type {[number, () => unknown][]} */ ([
      [1, () => {}],
      [1, () => {}],
      [2, () => writeFileSync(file, "cut")],
      [3, () => rmSync(file)],
      [4, () => writeFileSync(`${file}.more`, "")],
    ])) {
      change();
      await step(1);
      assert.equal(count, expected);
    }
    await step(2);
    assert.equal(count, 5, "for something else it is made again");
    await assert.rejects(step(3, true));
    await step(2);
    assert.equal(count, 7, "after a failure, too");
  } finally {
    for (const one of [made, join("dist", "stamps", "kept-test")])
      rmSync(join(root, one), { recursive: true, force: true });
  }
});

test("counts are summed over test programs, and missing when there is none", () => {
  assert.deepEqual(
    countsOfHarness(
      "running 2 tests\ntest result: ok. 2 passed; 0 failed; 0 ignored; 0 measured\n...\ntest result: FAILED. 3 passed; 1 failed; 0 ignored\n",
    ),
    { passed: 5, failed: 1 },
  );
  assert.equal(countsOfHarness("no tests to run!\n"), undefined);
  assert.deepEqual(countsOfTap("ok 1 - x\n1..1\n# tests 4\n# pass 1\n# fail 2\n# cancelled 1\n# skipped 0\n"), {
    passed: 1,
    failed: 3,
  });
  assert.equal(countsOfTap("TAP version 13\n"), undefined);
});

test("the benchmark works without peers, and prints and writes what it measured", () => {
  const file = join(emptyFolder(), "figures.json");
  const chosen = ["RRT-Connect, clutter 4R", "First roadmap of a new process (4R, n = 1000)"];
  const args = [
    join(root, "benches", "bench.mjs"),
    "--quick",
    "--no-build",
    "--sides",
    "node",
    ...chosen.flatMap((row) => ["--rows", row]),
    "--json",
    file,
  ];
  const { status, stdout, stderr } = spawnSync(process.execPath, args, { encoding: "utf8", timeout: 120_000 });
  assert.equal(status, 0, stderr);
  assert.match(stdout, /\| RRT-Connect, clutter 4R \| Node \| \d/);
  assert.match(stdout, /\| first roadmap of a new process, ms \| <= 50 \| \d/);
  const { worlds, rows: measured, aims } = JSON.parse(readFileSync(file, "utf8"));
  assert.equal(worlds, 3);
  assert.deepEqual(
    measured.map((/** @type {{ row: string }} */ { row }) => row),
    chosen,
  );
  const [{ arm, solved, milliseconds }] = measured[0].arms;
  assert.ok(arm === "Node" && solved > 0 && milliseconds.median > 0);
  const judged = aims.flatMap((/** @type {{ results: { row: string, value: number }[] }} */ { results }) => results);
  assert.equal(judged.length, 1, "no other figure with an aim was measured");
  assert.ok(judged[0].row === chosen[1] && judged[0].value > 0);
});

test("the benchmark refuses sides, rows and numbers of worlds that are none", () => {
  for (const args of [
    ["--sides", "native,magic"],
    ["--rows", "magic"],
    ["--worlds", "0"],
    ["--worlds", "many"],
    ["--first=-1"],
  ]) {
    const { status, stderr } = spawnSync(
      process.execPath,
      [join(root, "benches", "bench.mjs"), "--no-build", ...args],
      { encoding: "utf8", timeout: 30_000 },
    );
    assert.equal(status, 1, args.join(" "));
    assert.match(stderr, /magic|integer/);
  }
});

test("ratios are taken world by world, where both sides solved most of their runs, and are held against their aims", () => {
  const run = (/** @type {number} */ build, solved = true) => ({
    setup: 0,
    build,
    search: 0,
    solved,
    length: 1,
    motions: 1,
    vertices: 1,
    edges: 1,
  });
  const results = new Map([
    [
      "native",
      [
        [run(1), run(1), run(9)],
        [run(2), run(2), run(2)],
        [run(1, false), run(1, false), run(1)],
      ],
    ],
    [
      "OMPL, plain",
      [
        [run(6), run(6), run(6)],
        [run(20), run(20), run(20)],
        [run(1), run(1), run(1)],
      ],
    ],
  ]);
  const measured = figures(rows.find(({ planner }) => planner === "rrt-connect") ?? rows[0], results);
  const { figures: ratios, arms } = measured;
  const [{ name, value }] = ratios;
  assert.deepEqual([name, value.count, value.low, value.high], ["OMPL, plain / native", 2, 6, 10]);
  assert.equal(ratios.length, 1, "sides that are absent have no ratio");
  const verdict = (/** @type {number} */ median) =>
    judge([{ ...measured, figures: [{ name, value: { ...value, median } }] }]).flatMap(({ aim, results }) =>
      results.map((result) => [aim, result.verdict]),
    );
  assert.deepEqual(
    [5.9, 6, 9].flatMap(verdict),
    ["MISSED", "reached", "stretch"].map((each) => ["RRT-Connect, arms, native", each]),
  );
  assert.deepEqual(
    arms.map(({ solved }) => Math.round(100 * solved)),
    [78, 100],
  );
});

test("peers get polygons counter-clockwise, and none that they cannot read", () => {
  /** @param {number[][]} vertices @returns {import("planarium").ScenarioDocument} */
  const document = (vertices) => ({
    format: "planarium-scenario-1",
    name: "one",
    world: { obstacles: [{ type: "polygon", vertices: /** @type {[number, number][]} */ (vertices) }] },
    robot: { type: "arm", base: [0, 0], links: [1] },
    queries: [{ name: "q", start: [0], goal: [1] }],
  });
  assert.equal(
    flat(
      document([
        [2, 0],
        [2, 1],
        [3, 0],
      ]),
    ),
    "base 0 0\nradius 0\nlinks 1\nstart 0\ngoal 1\npolygon 3 0 2 1 2 0\n",
  );
  assert.throws(
    () =>
      flat(
        document([
          [2, 0],
          [4, 0],
          [3, 0.2],
          [3, 2],
        ]),
      ),
    /convex/,
  );
});

test("pages that reload have one more script, and hear when they are made again; nothing is kept for use without a network", async () => {
  const folder = emptyFolder();
  addFiles(folder, { "index.html": "<head></head>", "offline.js": "kept", "main.js": "1" });
  const { url, close, reload } = await serve({ root: folder, port: 0, reloads: true });
  try {
    const text = async (/** @type {string} */ path) => (await fetch(url + path)).text();
    assert.equal(await text(""), '<head><script type="module" src="/reload.js"></script></head>');
    assert.match(await text("reload.js"), /location\.reload\(\)/);
    assert.equal(await text("main.js"), "1");
    assert.equal((await fetch(`${url}offline.js`)).status, 404);
    const events = (await fetch(`${url}reload`)).body?.getReader() ?? assert.fail();
    const next = async () => new TextDecoder().decode((await events.read()).value);
    assert.equal(await next(), ":\n\n");
    reload();
    assert.equal(await next(), "data:\n\n");
    await events.cancel();
  } finally {
    await close();
  }
});

test("as long as there is no documentation, its address says how it is built", async () => {
  const [pages, docs] = [emptyFolder(), emptyFolder()];
  addFiles(pages, { "index.html": "<p>pages" });
  const { url, close } = await serve({ root: pages, port: 0, docs });
  try {
    const missing = await fetch(`${url}docs/`);
    assert.equal(missing.status, 404);
    assert.match(await missing.text(), /not built yet.*npm run site/);
    addFiles(docs, { "index.html": "<p>docs" });
    assert.equal(await (await fetch(`${url}docs/`)).text(), "<p>docs");
    assert.equal(await (await fetch(`${url}docs/no.html`)).text(), "Not found\n");
  } finally {
    await close();
  }
});
