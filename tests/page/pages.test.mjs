/**
 * One table over all pages of the list that the build reads: how each opens, what it refuses, and for whom it
 * is. What is particular about a page stands in its row in pages.mjs.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { PAGES } from "../../scripts/page.mjs";
import {
  DESK,
  addressOf,
  coloursOf,
  dropFile,
  finish,
  isDeep,
  onPage,
  unfold,
  useBrowser,
  violations,
} from "./browser.mjs";
import { assertFaultless, assertFills, assertForced, assertKeys, assertTargets, overhang } from "./looks.mjs";
import { ROWS, rest } from "./pages.mjs";
import { printedCode } from "./printed.mjs";
import { EMPTY } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/**
 * The pages that are looked at from every side in every run: the planner's, and one of the rooms, which print, embed and
 * refuse by the same code. Of the others a run has what differs, and a deep run has all.
 */
const SAMPLES = ["plan", "fleet"];

/** The pages that a run comes back to: the planner's, a room, and the one whose trials may begin again. */
const RETURNS = [...SAMPLES, "experiments"];

const CALM = /** @type {import("./browser.mjs").Options} */ ({ ...DESK, reducedMotion: "reduce" });
/** What a page says of how it comes to its state, rather than of the state. */
const PASSING = ["settled", "plans", "begun", "complete"];
const addressAt = (/** @type {string} */ name) => `${name}.html`;

/** Waits until a page is as it opens. @param {Page} page @param {string} [ready] */
const open = async (page, ready = "body") => {
  await page.waitForSelector(ready, { state: "attached" });
  await rest(page);
};

/** All that a reader has put into the page, and what it says of itself. @param {Page} page */
const stateOf = async (page) => {
  await rest(page);
  return page.evaluate(
    (passing) => ({
      data: ["body", "#stage", "#counters"].map((one) =>
        // In which order attributes came to be may differ.
        Object.entries({ .../** @type {HTMLElement | null} */ (document.querySelector(one))?.dataset })
          .filter(([key]) => !passing.includes(key))
          .sort(([a], [b]) => (a < b ? -1 : 1)),
      ),
      fields: Array.from(
        document.querySelectorAll(".panel :is(input:not([type=file]), select), #transport input"),
        (one) => {
          const { id, name, value, checked } = /** @type {HTMLInputElement} */ (one);
          return `${id || name}: ${value} ${checked ?? ""}`;
        },
      ),
    }),
    PASSING,
  );
};

/**
 * A page is as it was; it may have unfolded more.
 * @param {Awaited<ReturnType<typeof stateOf>>} now @param {Awaited<ReturnType<typeof stateOf>>} then
 */
const assertSame = (now, then) => {
  assert.deepEqual(now.data, then.data);
  assert.deepEqual(
    then.fields.filter((field) => !now.fields.includes(field)),
    [],
  );
};

/** The name of a field of a state. @param {string} field */
const nameOf = (field) => field.split(":", 1)[0];

/** The browser fills in no field by itself when the reader comes back. @param {Page} page */
const assertFieldsAreOurs = async (page) =>
  assert.deepEqual(
    await page
      .locator(":is(input:not([type=file]), select, textarea):not([autocomplete=off])")
      .evaluateAll((all) => all.map(({ id, outerHTML }) => id || outerHTML)),
    [],
  );

/** What a page says that it refuses. @param {Page} page */
const refusal = async (page) => {
  await page.waitForSelector("#notice:not([hidden])");
  return page.innerText("#notice");
};

/** The buttons that pages say to press. @type {Set<string>} */
const named = new Set();

/** A page that says which button to press has it. @param {Page} page @param {string} where */
async function assertNamedButtons(page, where) {
  for (const [, name] of (await page.innerText("#story")).matchAll(/\b[Pp]ress ([A-Z]\w+)(?=[.:,])/g)) {
    named.add(name);
    const buttons = page.getByRole("button", { name, exact: true }).filter({ visible: true });
    assert.ok((await buttons.count()) > 0, `${where}: there is no button ${name}`);
  }
}

test("every row is that of a page", () => {
  const names = PAGES.map(({ name }) => name);
  for (const name of Object.keys(ROWS)) assert.ok(names.includes(name), name);
});

for (const { name, link: title } of PAGES) {
  const {
    ready,
    core = "full",
    side = 200,
    states = {},
    takesFiles = true,
    isPrinted = true,
    isEmbedded = true,
    controls = Infinity,
    search,
    broken,
  } = ROWS[name] ?? {};
  const path = addressAt(name);
  const isSample = isDeep || SAMPLES.includes(name);
  const isCoded = isEmbedded && isSample;

  test(`${title}: opens, is for everyone, refuses in words, and fits a frame`, (t) =>
    onPage(
      CALM,
      async (page, url) => {
        /** @type {string[]} */
        const requests = [];
        const note = (/** @type {import("playwright-core").Request} */ request) => void requests.push(request.url());
        page.on("request", note);
        /** The page as it opens. @type {Awaited<ReturnType<typeof stateOf>>} */
        let usual;
        /** The address in the code that embeds the page. */
        let embedded = "";
        const colours = () => coloursOf(page, ["var(--page)", "var(--ink)", "var(--stage)", "var(--robot)"]);
        /** In the theme that was chosen. @type {number[][] | undefined} */
        let dark;
        /** Where the page is next opened, it has the theme that was chosen, which is then forgotten. */
        const assertRemembered = async () => {
          if (!dark) return;
          assert.deepEqual(await colours(), dark, "the choice is remembered");
          dark = undefined;
          await page.evaluate(() => {
            localStorage.clear();
            delete document.documentElement.dataset.theme;
          });
        };
        await page.goto(addressOf(url, path));
        await t.test(
          "opens in silence, with few controls, computes nothing needless, and says which page it is",
          async () => {
            await open(page, ready);
            page.off("request", note);
            const modules = requests.filter((url) => url.endsWith(".wasm")).map((url) => new URL(url).pathname);
            assert.deepEqual([...new Set(modules)], core ? [`/planarium/${core}_bg.wasm`] : []);
            assert.ok(page.workers().length <= (core ? 1 : 0), `${page.workers().length} workers`);
            assert.equal(await page.innerText("[aria-current=page]"), title);
            assert.equal(await page.locator("h1").count(), 1);
            assert.equal(await page.isHidden("#notice"), true);
            // A slider with its field is one control.
            const all = page.locator(".panel :is(button, select, input[type=range], [role=switch])");
            const first = await all.evaluateAll((ones) =>
              ones.filter((one) => one.checkVisibility()).map(({ id }) => id),
            );
            assert.ok(first.length <= controls, first.join(" "));
            await assertFieldsAreOurs(page);
            if (!isCoded) usual = await stateOf(page);
          },
        );
        await t.test("is used by keys", () => assertKeys(page));
        await t.test("is light or dark as the reader chooses", async () => {
          const light = await colours();
          await page.emulateMedia({ colorScheme: "dark" });
          await rest(page);
          assert.notDeepEqual(await colours(), light, "that of the system");
          await page.emulateMedia({ colorScheme: "light" });
          await page.click("#theme");
          await rest(page);
          const chosen = (dark = await colours());
          assert.ok(
            light.every((colour, i) => String(colour) !== String(chosen[i])),
            JSON.stringify({ light, chosen }),
          );
          assert.equal(
            await page.evaluate(() => localStorage.getItem("vitepress-theme-appearance")),
            "dark",
            "it holds for all",
          );
          // What follows looks at the page in both.
          await page.evaluate(() => delete document.documentElement.dataset.theme);
        });
        if (side > 0)
          await t.test("its figures fill small screens and projectors", async () => {
            await page.setViewportSize({ width: 1024, height: 768 });
            await assertFills(page, "desk");
            await page.click("#projector");
            await assertFills(page, "projector");
            await page.setViewportSize({ width: 1280, height: 720 });
            await assertFills(page, "wide projector");
            await page.keyboard.press("Escape");
            await page.waitForSelector("#projector[aria-pressed=false]");
            await page.setViewportSize(DESK.viewport);
            await rest(page);
          });
        const all = Object.entries({ "as it opens": rest, ...states });
        for (const [state, enter] of isDeep ? all : all.slice(0, 2)) {
          await t.test(`${state}: axe finds nothing, all fits any width, and fingers hit the controls`, async () => {
            await enter(page);
            await assertNamedButtons(page, `${title}, ${state}`);
            if (search) await page.fill("#search", search);
            await assertFaultless(page, `${title}, ${state}`, side);
            await assertTargets(page);
            if (search) await page.fill("#search", "");
          });
        }
        if (isSample)
          await t.test("is drawn in forced colours", async () => {
            await page.emulateMedia({ forcedColors: "active" });
            await rest(page);
            await assertForced(page);
            assert.deepEqual(await violations(page), []);
            await page.emulateMedia({ forcedColors: "none" });
            await rest(page);
          });
        await t.test("refuses a file that it cannot read, and loses nothing", async () => {
          const before = await stateOf(page);
          await dropFile(page, "broken.json", "{");
          if (takesFiles) {
            assert.match(await refusal(page), /broken\.json/);
            assert.equal(await page.getAttribute("#notice", "data-code"), "invalid-json");
            assert.deepEqual(await violations(page), []);
          }
          assert.deepEqual(await stateOf(page), before);
        });
        // A deep run has states that no link stores, such as an open editor.
        if (!isDeep && RETURNS.includes(name))
          await t.test("is as it was left when the reader comes back to it", async () => {
            await assertFieldsAreOurs(page);
            const left = await stateOf(page);
            await page.goto(addressOf(url, "icon.svg"));
            await page.goBack();
            const [type] = await page.evaluate(() =>
              performance
                .getEntriesByType("navigation")
                .map((one) => /** @type {PerformanceNavigationTiming} */ (one).type),
            );
            assert.equal(type, "back_forward", "the browser has not kept it");
            await open(page);
            await assertRemembered();
            const now = await stateOf(page);
            const names = now.fields.map(nameOf);
            assertSame(now, { ...left, fields: left.fields.filter((field) => names.includes(nameOf(field))) });
            assert.equal(await page.isHidden("#notice"), true);
          });
        await t.test("fits a sheet of paper", async () => {
          await page.emulateMedia({ media: "print" });
          await page.setViewportSize({ width: 794, height: 1123 });
          await rest(page);
          assert.equal(await overhang(page), 0);
          if (isPrinted)
            assert.deepEqual(
              await page
                .locator("button, input, select, #notice")
                .evaluateAll((all) => all.filter((one) => one.checkVisibility()).map((one) => one.id)),
              [],
            );
          // To write the whole gallery as a PDF takes seconds, and it does nothing of its own for it.
          if (isPrinted) await page.pdf();
        });
        if (isCoded)
          await t.test("has on paper the address and a code that opens the same", async () => {
            await page.setViewportSize(DESK.viewport);
            await page.emulateMedia({ media: null });
            await page.goto(addressOf(url, `${path}?`));
            await open(page, ready);
            await assertRemembered();
            usual = await stateOf(page);
            await page.emulateMedia({ media: "print", colorScheme: "dark" });
            const address = await printedCode(page);
            assert.ok((await page.innerText("#printed-link")).includes(addressOf(url, path)));
            assert.ok(address.startsWith(`${addressOf(url, path)}?#1`), address);
            await page.emulateMedia({ media: "screen", colorScheme: "light" });
            assert.equal(await page.isVisible("#printed-link"), false);
            await unfold(page, "export");
            await page.locator("#embed-fold > summary").click();
            await page.waitForFunction(
              () => /** @type {HTMLTextAreaElement} */ (document.getElementById("embed-text")).value !== "",
            );
            [, embedded] = /^<iframe src="([^"]+)" /.exec(await page.inputValue("#embed-text")) ?? [];
            await page.goto("about:blank");
            await page.goto(address);
            await open(page, ready);
            assertSame(await stateOf(page), usual);
          });
        await t.test("a link that does not work is refused in a sentence, and it opens as ever", async () => {
          await page.emulateMedia({ media: null });
          await page.setViewportSize(DESK.viewport);
          const refused = ["1broken", "nothing", ...(broken ?? [])];
          // To open a page takes seconds, to change its address none: the one that is refused for what it says is opened.
          const opened = isDeep ? refused : refused.slice(-1);
          for (const fragment of opened) {
            await page.goto("about:blank");
            await page.goto(addressOf(url, `${path}#${fragment}`));
            if (core) assert.match(await refusal(page), /(This|The) link (does not work|cannot be opened)/, fragment);
            await open(page, ready);
            await assertRemembered();
            assert.deepEqual(await stateOf(page), usual, fragment);
          }
          if (!core) return;
          const there = await stateOf(page);
          for (const fragment of refused) {
            await page.click("#notice button");
            await page.evaluate((hash) => {
              location.hash = hash;
            }, fragment);
            await refusal(page);
            assert.deepEqual(await stateOf(page), there, `an open page stays as it is: ${fragment}`);
          }
        });
        if (isCoded)
          await t.test("in a frame it is its figure alone, and fits; the page has the code of the frame", async () => {
            await page.setViewportSize({ width: 640, height: 420 });
            assert.ok(embedded.startsWith(`${addressOf(url, path)}?embed=1#1`), embedded);
            await page.goto("about:blank");
            await page.goto(embedded);
            await open(page, ready);
            assertSame(await stateOf(page), usual);
            for (const hidden of [".masthead", ".panel"]) assert.equal(await page.isVisible(hidden), false, hidden);
            assert.equal(await page.isVisible("#stage"), true);
            assert.equal(await overhang(page), 0);
            for (const [width, height] of [
              [1280, 600],
              [960, 540],
              [640, 480],
            ]) {
              await page.setViewportSize({ width, height });
              if (side > 0) await assertFills(page, `frame of ${width}`);
              assert.equal(await overhang(page), 0);
              const legend = page.locator(".stage-column > .legend");
              if (await legend.count()) assert.equal(await legend.isVisible(), width > 640, "where there is room");
            }
            // The heading is the parent's to give.
            const found = await violations(page);
            assert.deepEqual(
              found.filter((one) => !one.startsWith("page-has-heading-one")),
              [],
            );
          });
      },
      { path: "icon.svg" },
    ));
}

test("pages say to press buttons", () =>
  // To train is said in a state that a deep run enters.
  assert.deepEqual(
    [...named].filter((name) => /^(Run|Train)$/.test(name)).sort(),
    isDeep ? ["Run", "Train"] : ["Run"],
  ));

test("without their WebAssembly the pages say so, and stay pages", () =>
  onPage(
    CALM,
    async (page, url) => {
      for (const { name } of PAGES) {
        if (ROWS[name]?.core === "") continue;
        await page.goto(addressOf(url, addressAt(name)));
        await page.waitForSelector("#counters[data-status=failed], body[data-state=failed]", { state: "attached" });
        assert.match(await refusal(page), /WebAssembly/, name);
        assert.ok((await page.locator(".rooms a").count()) > 1, name);
      }
    },
    {
      path: "icon.svg",
      expectErrors: true,
      before: async (page) => {
        await page.route(/\.wasm$/, (route) => route.abort());
      },
    },
  ));

test("the pages link each other, and all addresses are there", () =>
  onPage(
    CALM,
    async (page, url) => {
      const links = await page
        .locator(".rooms a")
        .evaluateAll((all) => all.map((link) => /** @type {HTMLAnchorElement} */ (link).href));
      assert.deepEqual(
        new Set(links.filter((link) => !link.includes("/docs/"))),
        new Set([...PAGES.map(({ name }) => addressAt(name))].map((address) => addressOf(url, address))),
      );
      for (const link of links) assert.equal((await page.request.get(link)).status(), 200, link);
    },
    { path: addressAt(PAGES[1].name) },
  ));

test("what was open once opens without a network, every page of it, and plans the same", () =>
  onPage(
    { ...CALM, serviceWorkers: "allow" },
    async (page, url) => {
      await open(page, ROWS.plan.ready);
      await page.waitForFunction(async () => (await navigator.serviceWorker.ready).active?.state === "activated");
      const there = await finish(page);
      // Pictures of the gallery are stored once they are seen.
      await page.goto(addressOf(url, "gallery.html"));
      const picture = page.locator(".entry img").first();
      const { src, unseen } = await picture.evaluate(async (image) => {
        await /** @type {HTMLImageElement} */ (image).decode();
        return {
          src: /** @type {HTMLImageElement} */ (image).src,
          unseen: /** @type {HTMLImageElement} */ ([...document.images].at(-1)).src,
        };
      });
      await page.waitForFunction((address) => caches.match(address), src);
      assert.equal(await page.evaluate(async (address) => (await caches.match(address)) === undefined, unseen), true);
      // So are pages of the documentation.
      const worksheet = addressOf(url, "docs/worksheet.html");
      await page.goto(worksheet);
      await page.waitForFunction((address) => caches.match(address), worksheet);
      await page.context().setOffline(true);
      await page.goto("about:blank");
      await page.goto(worksheet);
      assert.equal(await page.locator("#answers").count(), 1);
      await page.goto("about:blank");
      await page.goto(addressOf(url));
      await open(page, ROWS.plan.ready);
      assert.equal((await finish(page)).fingerprint, there.fingerprint);
      for (const fold of ["editor", "lessons", "export", "curves"]) await unfold(page, fold);
      assert.equal(await page.isHidden("#notice"), true);
      for (const { name } of PAGES) {
        // Of learned edges there is no plan, which takes seconds.
        const [fragment, ready] =
          name === "prm-rl" ? [`#${EMPTY}`, "#stage[data-status=none]"] : ["", ROWS[name]?.ready];
        await page.goto(addressOf(url, addressAt(name) + fragment));
        await open(page, ready);
      }
      await page.goto(addressOf(url, "gallery.html"));
      await picture.evaluate((image) => /** @type {HTMLImageElement} */ (image).decode());
      await page.goto(url);
      await page.waitForSelector("#grow:enabled");
      for (const shown of await page.locator("main img").all())
        await shown.evaluate((image) => /** @type {HTMLImageElement} */ (image).decode());
      await page.click("#grow");
      await page.waitForSelector("#grown[data-state=running]");
    },
    { expectErrors: true },
  ));
