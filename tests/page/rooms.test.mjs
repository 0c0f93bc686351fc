/** The pages beside the planner's: their links, what they share, and what each does when something is missing. */
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pagePolicy, serve } from "../../scripts/serve.mjs";
import { flag, list, number, record, withDefaults } from "../../www/formats/rules.js";
import { decodeState, encodeState } from "../../www/app/link.js";
import { DESK, TRAP, onPage, pageRoot, pixelsOf, root, useBrowser } from "./browser.mjs";
import { onReach, poseOf, rest } from "./reach.mjs";

useBrowser();

test("a room whose core was lost says so, and goes on", () =>
  onReach(
    async (page) => {
      const before = await poseOf(page);
      await page.evaluate(() => {
        /** @type {any} */ (window).trap = "scenario_follow";
      });
      await page.focus("#stage");
      await page.keyboard.press("ArrowUp");
      await page.waitForSelector("#notice[data-code=internal]");
      await rest(page);
      assert.deepEqual(await poseOf(page), before);
      await page.keyboard.press("ArrowUp");
      await page.waitForFunction((q) => document.body.dataset.q !== q, before.join());
      assert.ok((await pixelsOf(page, "workspace", "top", "robot")) > 100);
    },
    DESK,
    { before: async (page) => void (await page.addInitScript(TRAP)) },
  ));

const rule = record({ values: list(number, 0, Infinity) });

test("a state in an address comes back as it was, and is checked", async () => {
  const state = { values: [0.1, -1 / 3, 1e-300] };
  assert.deepEqual(await decodeState(`#${await encodeState(state, rule)}`, rule), { state, fault: "" });
  await assert.rejects(encodeState({ other: 1 }, rule), /state.other is unknown/);
  const { fault } = await decodeState(await encodeState({ values: [1] }, rule), record({}));
  assert.match(fault ?? "", /state.values is unknown/);
});

test("a state leaves out what has its default, and gets it back", async () => {
  const described = withDefaults({ values: list(number, 0, 3), isOn: flag }, { values: [1, 2], isOn: false });
  const short = await encodeState({ values: [1, 2], isOn: false }, described);
  assert.equal(short, await encodeState({}, described));
  assert.deepEqual(await decodeState(short, described), { state: { values: [1, 2], isOn: false }, fault: "" });
  assert.deepEqual(
    (
      await decodeState(
        await encodeState({ values: [], isOn: true }, record({ values: list(number, 0, 3), isOn: flag })),
        described,
      )
    ).state,
    { values: [], isOn: true },
  );
});

test("a state in an address is 2 KB at most, and unpacks to no more than 16", async () => {
  const noise = Array.from({ length: 300 }, (_, i) => Math.sin(i + 1));
  await assert.rejects(encodeState({ values: noise }, rule), /too long/);
  await assert.rejects(encodeState({ values: Array.from({ length: 20_000 }, () => 0) }, rule), /too long/);
  const { fault } = await decodeState(`1${"A".repeat(3000)}`, rule);
  assert.match(fault ?? "", /too long/);
});

test("links that were made before states had defaults still open", async () => {
  /**
   * @param {string} name
   * @param {string} fragment
   * @param {string} ready
   * @param {(data: Record<string, string>, value: (id: string) => Promise<string>) => Promise<void>} check
   */
  const opened = (name, fragment, ready, check) =>
    onPage(
      { reducedMotion: "reduce" },
      async (page) => {
        await page.waitForSelector(ready);
        assert.equal(await page.isHidden("#notice"), true);
        await check(
          /** @type {Record<string, string>} */ (
            await page.evaluate(() => ({ ...document.body.dataset, ...document.getElementById("stage")?.dataset }))
          ),
          (id) => page.inputValue(`#${id}`),
        );
      },
      { path: `${name}.html#${fragment}` },
    );
  await opened(
    "reach",
    "1PY7BDoJADET_Zc6VIEo0_RXCAaQqcdnG3SIHwr-bqvEyaTqvM12RLxIFjDBOo2UQkvZq4BVhjI8MbsqiprI4uhzajXBNImBLsxCef7-qaVcWp7olTDp4Yi-2iEQQOqfoyznQg5uq-B24-jJovIGbfUvovvMnFNalm9inpyJ3s4aX-IOT2F0HMKIspl6UNcw2aszgMyFJti5ZBh_LbXsD",
    "body[data-state=ready][data-settled=true]",
    async ({ scene, mode, q }, value) => {
      assert.deepEqual([scene, mode, q], ["limits", "between", "0.5,0.25,-0.75"]);
      assert.deepEqual(
        [await value("along"), await value("link-0-number"), await value("method")],
        ["0.25", "0.500", "newton"],
      );
    },
  );
  await opened(
    "neighbours",
    "1FcxLCsIwFIbRvXzjq1SrCHcr4qA2fzVYU0ziA0r3Lh0fODN5uk4Vp96zhBFy98VnEt42jVGkgJ-MYXUfurFoMV74udkebbOz_cV44AcjpqAfzjBllYpxix-ldXuq5tjj6N2PMahLGDVLBW-X5Q8",
    "body[data-settled=true][data-found]",
    async ({ robot, n, q, k, index, metric }, value) => {
      assert.deepEqual([robot, n, q, k, index, metric], ["three", "300", "0.5,-1,2", "4", "forest", "euclidean"]);
      assert.equal(await value("option-trees"), "3");
    },
  );
  await opened(
    "trajectories",
    "1q1ZKzyxLzVOyqlYqTk1NUbIyN9dRys1PSc1RslIqLsgsSsxRqtVRKinKBEmaGOgo5eelKllFG-iZ6uga6pnqGMfWAgA",
    "body[data-settled=true] #stage[data-tried='40']",
    async (_, value) => {
      assert.deepEqual(
        [await value("option-seed"), await value("option-model"), await value("one-w-number")],
        ["77", "spiral", "-1.500"],
      );
    },
  );
});

/**
 * What each folder of the pages may import from others, values and types alike; a feature of the planner's page says
 * which of its neighbours it knows.
 */
const KIT = "app domain draw formats widgets";
const BELOW = {
  formats: "",
  domain: "",
  app: "formats",
  draw: "app domain formats",
  widgets: "app domain draw formats",
  worlds: KIT,
  paths: "app domain formats worlds",
  neighbours: `${KIT} planner/scenes`,
  trajectories: KIT,
  fleet: `${KIT} worlds`,
  "prm-rl": KIT,
  reach: `${KIT} planner/link planner/scenes`,
  start: KIT,
  class: "app",
  rooms: "app experiments fleet neighbours prm-rl reach trajectories",
  experiments: `${KIT} planner/link planner/scenes worlds`,
  gallery: `${KIT} experiments fleet neighbours planner/link planner/race planner/scenes planner/stage prm-rl reach trajectories`,
  planner: `${KIT} planner/certificate planner/driving planner/editor planner/export planner/judge planner/lessons planner/link planner/pose planner/race planner/room planner/run-log planner/scenes planner/settings planner/stage planner/timeline planner/timing planner/worker worlds`,
  "planner/worker": KIT,
  "planner/settings": KIT,
  "planner/scenes": KIT,
  "planner/run-log": `${KIT} planner/worker`,
  "planner/stage": `${KIT} planner/run-log planner/worker worlds`,
  "planner/pose": `${KIT} planner/run-log planner/stage`,
  "planner/race": `${KIT} planner/run-log planner/settings`,
  "planner/link": KIT,
  "planner/lessons": `${KIT} planner/scenes`,
  "planner/timeline": `${KIT} planner/run-log planner/stage planner/worker`,
  "planner/certificate": `${KIT} planner/stage planner/worker`,
  "planner/editor": `${KIT} planner/stage`,
  "planner/driving": `${KIT} planner/stage`,
  "planner/export": `${KIT} planner/link planner/race planner/run-log planner/stage planner/timeline planner/timing`,
  "planner/timing": `${KIT} paths planner/link planner/race planner/run-log planner/stage planner/timeline`,
  "planner/judge": `${KIT} paths planner/stage worlds`,
  "planner/room": `${KIT} paths planner/link planner/stage planner/timeline`,
};

/** The modules of the package without a core, which a page contains: the package itself is a file beside it. */
const SHARED = ["planner-host.js", "tables.js"].map((name) => join("..", "dist", "package", name));

const sources = readdirSync(join(root, "www"), { recursive: true, encoding: "utf8" }).filter((path) =>
  path.endsWith(".js"),
);
/** The files of the pages that a source names with a pattern, whose first group is the address. */
const namedIn = (/** @type {string} */ path, /** @type {RegExp} */ pattern) =>
  Array.from(readFileSync(join(root, "www", path), "utf8").matchAll(pattern), ([, other]) => join(path, "..", other));

test("a folder imports only what is below it, types too", () => {
  const folderOf = (/** @type {string} */ path) => /^(planner\/[\w-]+(?=\/)|[\w-]+)/.exec(path)?.[0] ?? "";
  assert.deepEqual(new Set(sources.map(folderOf)), new Set(Object.keys(BELOW)));
  for (const path of sources) {
    const [own, allowed] = [folderOf(path), BELOW[/** @type {keyof typeof BELOW} */ (folderOf(path))].split(" ")];
    for (const other of namedIn(path, /\b(?:from|import)\s*\(?\s*"(\.[^"]+)"/g)) {
      if (SHARED.includes(other)) continue;
      const folder = folderOf(other);
      assert.ok(folder === own || allowed.includes(folder), `${path} imports ${other}`);
    }
  }
});

test("no file imports itself through others", () => {
  /** @type {Set<string>} */
  const seen = new Set();
  /** @param {string} path @param {string[]} way */
  const follow = (path, way) => {
    assert.ok(!way.includes(path), [...way, path].join(" > "));
    if (seen.has(path)) return;
    seen.add(path);
    for (const other of namedIn(path, /^(?:import|export) (?:[\w*{][^"=;(]*?\bfrom )?"(\.[^"]+)"/gm))
      if (!SHARED.includes(other)) follow(other, [...way, path]);
  };
  for (const path of sources) follow(path, []);
});

test("every page has the same policy as the planner's, and its own entry, style and links", () => {
  const policy = (/** @type {string} */ html) => /<meta http-equiv="Content-Security-Policy"[^>]*>/.exec(html)?.[0];
  const index = readFileSync(join(pageRoot, "index.html"), "utf8");
  const pages = readdirSync(join(root, "www")).filter((name) => name.endsWith(".html"));
  assert.ok(pages.includes("reach.html"));
  assert.match(policy(index) ?? "", /script-src 'self' 'wasm-unsafe-eval';/);
  assert.doesNotMatch(policy(index) ?? "", /'unsafe-|https?:|\*/);
  for (const name of pages) {
    const html = readFileSync(join(pageRoot, name), "utf8");
    assert.equal(policy(html), policy(index), name);
    assert.doesNotMatch(html, /<!-- (rooms|masthead) -->|<style|\sstyle=|\son\w+="/, name);
    // Slides have no links between pages.
    if (name !== "class.html") assert.equal(html.match(/aria-current="page"/g)?.length, 1, name);
    const cores = Array.from(html.matchAll(/href="planarium\/(\w+)_bg\.wasm"/g), ([, core]) => core);
    assert.deepEqual(
      cores,
      name === "plan.html"
        ? ["planarium"]
        : ["index.html", "gallery.html", "class.html"].includes(name)
          ? []
          : ["full"],
      name,
    );
    for (const [, address] of html.matchAll(/(?:src|href)="([^"#:]+)[^":]*"/g)) {
      // A page of the documentation is made from a text of the same name.
      const text = /^docs\/(.*?)(\.html)?$/.exec(address)?.[1];
      const file =
        text === undefined ? join(pageRoot, address) : join(root, "docs", text === "" ? "index.md" : `${text}.md`);
      assert.ok(existsSync(file), `${name}: ${address}`);
    }
  }
});

test("files are sent compressed to those who accept it, and are the same", async (t) => {
  const { url, close } = await serve({ root: pageRoot, port: 0, policy: pagePolicy() });
  t.after(close);
  for (const file of ["", "planarium/planarium_bg.wasm", "style.css"]) {
    const [plain, ...compressed] = await Promise.all(
      ["identity", "gzip", "br"].map(async (encoding) => {
        const response = await fetch(new URL(file, url), { headers: { "accept-encoding": encoding } });
        return {
          encoding: response.headers.get("content-encoding"),
          type: response.headers.get("content-type"),
          size: Number(response.headers.get("content-length")),
          bytes: Buffer.from(await response.arrayBuffer()),
        };
      }),
    );
    assert.deepEqual(
      [plain, ...compressed].map(({ encoding }) => encoding),
      [null, "gzip", "br"],
      file,
    );
    for (const { bytes, type, size } of compressed) {
      assert.ok(bytes.equals(plain.bytes) && type === plain.type, file);
      assert.ok(size < plain.size / 2, `${file}: ${size} of ${plain.size}`);
    }
  }
});
