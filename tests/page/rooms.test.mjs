/** The pages beside the planner's: their links, what they share, and what each does when something is missing. */
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { list, number, record } from "../../www/exchange/rules.js";
import { decodeState, encodeState } from "../../www/room/link.js";
import { DESK, onPage, pageRoot, pixelsOf, root, start, stop } from "./browser.mjs";
import { onReach, poseOf, rest } from "./reach.mjs";

before(start);
after(stop);

describe("the pages", () => {
  test("link each other, and say which of them one is on", async () => {
    await onReach(async (page, url) => {
      assert.equal(await page.locator(".rooms [aria-current=page]").innerText(), "Reach");
      const addresses = await page.locator(".rooms a").evaluateAll((links) => links.map((link) => /** @type {HTMLAnchorElement} */ (link).href));
      for (const address of addresses) assert.equal((await page.request.get(address)).status(), 200, address);
      await page.click(".rooms a >> text=Plan");
      await page.waitForSelector("#counters[data-settled=true]", { state: "attached" });
      assert.equal(page.url(), url);
      assert.equal(await page.locator(".rooms [aria-current=page]").innerText(), "Plan");
      await page.click(".rooms a >> text=Reach");
      await page.waitForSelector("body[data-state=ready]");
    });
  });

  test("share their colours", async () => {
    await onReach(async (page, url) => {
      await page.click("#theme");
      assert.equal(await page.getAttribute("html", "data-theme"), "dark");
      await page.goto(url);
      await page.waitForSelector("html[data-theme=dark]");
    }, { ...DESK, colorScheme: "light" });
  });

  test("after its core was lost it says so, and goes on", async () => {
    await onReach(async (page) => {
      const before = await poseOf(page);
      await page.evaluate(() => { /** @type {any} */ (window).trap = "scenario_follow"; });
      await page.focus("#stage");
      await page.keyboard.press("ArrowUp");
      await page.waitForSelector("#notice[data-code=internal]");
      await rest(page);
      assert.deepEqual(await poseOf(page), before);
      await page.keyboard.press("ArrowUp");
      await page.waitForFunction((q) => document.body.dataset.q !== q, before.join());
      assert.ok(await pixelsOf(page, "workspace", "top", "robot") > 100);
    }, DESK, { before: async (page) => void await page.addInitScript(() => {
      const { Instance } = WebAssembly;
      WebAssembly.Instance = /** @type {any} */ (function (/** @type {WebAssembly.Module} */ module, /** @type {WebAssembly.Imports} */ imports) {
        const { exports } = new Instance(module, imports);
        return { exports: Object.fromEntries(Object.entries(exports).map(([name, one]) => [name, typeof one !== "function" ? one : (/** @type {unknown[]} */ ...args) => {
          if (name !== /** @type {any} */ (window).trap) return one(...args);
          /** @type {any} */ (window).trap = "";
          throw new WebAssembly.RuntimeError("unreachable");
        }])) };
      });
    }) });
  });

  test("without its WebAssembly it says so and stays a page", async () => {
    await onPage(DESK, async (page) => {
      await page.waitForSelector("body[data-state=failed]");
      assert.match(await page.innerText("#notice"), /WebAssembly/);
      assert.equal(await page.locator(".rooms a").count() > 1, true);
    }, { path: "reach.html", expectErrors: true, before: async (page) => { await page.route(/\.wasm$/, (route) => route.abort()); } });
  });
});

describe("what a room may hold in its address", () => {
  const rule = record({ values: list(number, 0, Infinity) });

  test("comes back as it was, and is checked", async () => {
    const state = { values: [0.1, -1 / 3, 1e-300] };
    assert.deepEqual(await decodeState(`#${await encodeState(state, rule)}`, rule), { state, fault: null });
    await assert.rejects(encodeState({ other: 1 }, rule), /state.other is unknown/);
    const { fault } = await decodeState(await encodeState({ values: [1] }, rule), record({}));
    assert.match(fault ?? "", /state.values is unknown/);
  });

  test("is 2 KB at most, and unpacks to no more than 16", async () => {
    const noise = Array.from({ length: 300 }, (_, i) => Math.sin(i + 1));
    await assert.rejects(encodeState({ values: noise }, rule), /too long/);
    await assert.rejects(encodeState({ values: Array.from({ length: 20_000 }, () => 0) }, rule), /too long/);
    const { fault } = await decodeState(`1${"A".repeat(3000)}`, rule);
    assert.match(fault ?? "", /too long/);
  });
});

test("every page has the same policy as the planner's, and its own entry, style and links", () => {
  const policy = (/** @type {string} */ html) => /<meta http-equiv="Content-Security-Policy"[^>]*>/.exec(html)?.[0];
  const index = readFileSync(join(pageRoot, "index.html"), "utf8");
  const pages = readdirSync(join(root, "www")).filter((name) => name.endsWith(".html"));
  assert.ok(pages.includes("reach.html"));
  for (const name of pages) {
    const html = readFileSync(join(pageRoot, name), "utf8");
    assert.equal(policy(html), policy(index), name);
    assert.doesNotMatch(html, /<!-- (rooms|masthead) -->|<style|\sstyle=|\son\w+="/, name);
    assert.equal(html.match(/aria-current="page"/g)?.length, 1, name);
    for (const [, address] of html.matchAll(/(?:src|href)="([^"#:]+)"/g)) assert.ok(existsSync(join(pageRoot, address)), `${name}: ${address}`);
  }
});
