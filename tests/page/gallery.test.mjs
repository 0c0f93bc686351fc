/** The page of the gallery: it is searched, its entries open, and addresses show them. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { PHONE, addressOf, isDeep, onPage, textMatches, useBrowser, violations } from "./browser.mjs";
import { inTurn, reopen } from "./turns.mjs";
import { ofReports, entries, rows, addresses } from "./gallery.mjs";

/** @import { Entry } from "../../www/gallery/format.js" */
/** @import { Page } from "./browser.mjs" */

useBrowser();

/** The gallery. @param {(page: Page, url: string) => Promise<void>} act */
const onGallery = (act) =>
  onPage(
    {},
    async (page, url) => {
      await page.waitForSelector("body[data-state=ready]");
      await act(page, url);
    },
    { path: "gallery.html" },
  );

/** What is shown does not depend on the pictures. @param {Page} page */
const withoutPictures = (page) =>
  page.route("**/gallery/*.svg", (route) =>
    route.fulfill({
      contentType: "image/svg+xml",
      body: '<svg xmlns="http://www.w3.org/2000/svg" width="4" height="3"/>',
    }),
  );

/** The gallery as it opens. @param {Page} page */
async function putBack(page) {
  await withoutPictures(page);
  await reopen(page, "body[data-state=ready]");
}

test("the gallery is searched, and its entries open", (t) =>
  onGallery(
    inTurn(
      t,
      {
        "an entry opens by its address, leads to its neighbours and to its page, and closes": async (page, url) => {
          const [first, second] = entries;
          await page.waitForSelector("body[data-state=ready]");
          assert.equal(await page.locator(".entry").count(), entries.length);
          assert.equal(await page.locator("#rows tbody tr[id]").count(), rows.length);
          await page.evaluate(() =>
            Promise.all(Array.from(document.images, (image) => Object.assign(image, { loading: "eager" }).decode())),
          );
          await page.click(`${at(first)} h3 a`);
          await page.waitForSelector(`.entry:target .detail >> text=${first.see.slice(0, 30)}`);
          await page.keyboard.press("ArrowRight");
          await page.waitForFunction((id) => location.hash === `#${id}`, second.id);
          assert.ok(
            await page
              .locator(".entry:target img")
              .evaluate((image) =>
                /** @type {HTMLImageElement} */ (image).decode().then(() => image.getBoundingClientRect().width > 300),
              ),
          );
          await page.keyboard.press("Escape");
          await page.waitForFunction(() => document.querySelector(".entry:target") === null);
          await page.goBack();
          await page.waitForSelector(".entry:target");
          assert.equal(
            await page.locator(".entry:target .open").evaluate((link) => /** @type {HTMLAnchorElement} */ (link).href),
            new URL(addresses[second.id], url).href,
          );
        },

        "topic, search and filters leave the entries that fit, the address says which, and opens the same": async (
          page,
          url,
        ) => {
          await page.waitForSelector("body[data-state=ready]");
          assert.deepEqual(await shownIds(page), idsOf(entries));
          await page.click("#filters summary");
          await page.selectOption("#filter-holds", "no");
          await page.selectOption("#filter-robot", "arm");
          const wrong = entries.filter(({ holds, robot }) => holds === "no" && robot === "arm");
          assert.ok(wrong.length > 1 && wrong.length < entries.length);
          assert.deepEqual(await shownIds(page), idsOf(wrong));
          await textMatches(page, "#story", new RegExp(`^${wrong.length} of ${entries.length} entries`));
          await page.click(`#topics a[data-topic=neighbours]`);
          const near = wrong.filter(({ topic }) => topic === "neighbours");
          assert.ok(near.length > 1 && near.length < wrong.length);
          assert.deepEqual(await shownIds(page), idsOf(near));
          await page.keyboard.press("/");
          await page.keyboard.type("KD-tree wrap");
          const found = near.filter(
            (entry) => /kd-tree/i.test(JSON.stringify(entry)) && /wrap/i.test(JSON.stringify(entry)),
          );
          assert.ok(found.length > 0 && found.length < near.length);
          assert.deepEqual(await shownIds(page), idsOf(found));
          assert.equal(await page.evaluate(() => document.activeElement?.id), "search");
          await page.click(`${at(found[0])} h3 a`);
          await page.waitForSelector(".entry:target");
          const address = page.url();
          assert.equal(address, `${url}gallery.html?topic=neighbours&q=KD-tree+wrap&holds=no&robot=arm#${found[0].id}`);
          await page.goto("about:blank");
          await page.goto(address);
          await page.waitForSelector("body[data-state=ready]");
          assert.deepEqual(await shownIds(page), idsOf(found));
          assert.ok(await page.isVisible(".entry:target .open"));
          // What the search no longer finds is not open either.
          await page.fill("#search", "nothing has these words");
          assert.deepEqual(await shownIds(page), []);
          assert.equal(await page.evaluate(() => document.activeElement?.id), "search");
          await textMatches(page, "#story", new RegExp(`^0 of ${entries.length}`));
          assert.equal(new URL(page.url()).hash, "");
          await page.click("#all");
          assert.deepEqual(await shownIds(page), idsOf(entries));
          assert.equal(page.url(), `${url}gallery.html`);
        },

        "the view of the reports has their entries in order, their verdicts and all rows, in which arrows scroll":
          async (page, url) => {
            await page.waitForSelector("body[data-state=ready]");
            assert.ok(await page.isHidden("#rows"));
            await page.click(`${at(entries[0])} h3 a`);
            await page.waitForSelector(".entry:target");
            await page.click(".views [data-view=reports]");
            assert.deepEqual(await shownIds(page), idsOf(ofReports));
            assert.equal(page.url(), `${url}gallery.html?view=reports`);
            assert.ok(await page.isVisible(`${at(ofReports[0])} .tag .holds`));
            assert.equal(await page.locator("#rows tbody tr[id]:visible").count(), rows.length);
            await page.fill("#search", "bidirectional");
            const some = await page.locator("#rows tbody tr[id]:visible").count();
            assert.ok(some > 0 && some < rows.length);
            await page.fill("#search", "");
            // An entry that is open in one view is open in the other.
            await page.click(`${at(ofReports[1])} h3 a`);
            await page.waitForSelector(".entry:target");
            // With the table in focus arrows open no other entry.
            await page.focus("#rows .scroll");
            await page.keyboard.press("ArrowRight");
            assert.equal(await page.evaluate(() => location.hash), `#${ofReports[1].id}`);
            await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
            await page.keyboard.press("ArrowRight");
            await page.waitForFunction((id) => location.hash === `#${id}`, ofReports[2].id);
            assert.equal(page.url(), `${url}gallery.html?view=reports#${ofReports[2].id}`, "the view stays");
            await page.click(".views [data-view=topics]");
            assert.ok(await page.isVisible(`${at(ofReports[2])}:target .open`));
            assert.equal(page.url(), `${url}gallery.html#${ofReports[2].id}`);
            await page.click(".entry:target .detail a[href='#report-1']");
            await page.waitForFunction(() => document.body.dataset.view === "reports");
            assert.ok(await page.isVisible("#report-1"));
            await page.goBack();
            await page.waitForFunction(() => document.body.dataset.view === "topics");
            assert.ok(await page.isVisible(".entry:target .open"));
          },
      },
      putBack,
    ),
  ));

/** The ids of the entries that are shown, in their order. @param {Page} page */
function shownIds(page) {
  return page.locator(".entry:visible").evaluateAll((all) => all.map(({ id }) => id));
}

/** @param {Entry[]} wanted */
function idsOf(wanted) {
  return wanted.map(({ id }) => id);
}

test("addresses of reports, rows, topics and entries show them, whatever is selected", () =>
  onPage(
    {},
    async (page, url) => {
      await withoutPictures(page);
      const other = ofReports.find(({ robot }) => robot === "particle") ?? assert.fail();
      const all = [
        ["#row-120", "reports", "#row-120"],
        [`?topic=cars#${other.id}`, "topics", `${at(other)}:target .open`],
        ["#100%", "topics", at(entries[0])],
        ["#reports", "reports", "#reports"],
        ["#report-3", "reports", "#report-3"],
        ["?q=arm#rows", "reports", "#rows"],
        ["?view=reports#cars", "topics", "#cars"],
        ["?view=reports#fleets-ring", "topics", "#fleets-ring:target .open"],
        ["?topic=nothing&robot=none&q=", "topics", at(entries[0])],
      ];
      for (const [address, view, seen] of isDeep ? all : all.slice(0, 3)) {
        await page.goto("about:blank");
        await page.goto(addressOf(url, `gallery.html${address}`));
        await page.waitForSelector("body[data-state=ready]");
        assert.equal(await page.getAttribute("body", "data-view"), view, address);
        assert.ok(await page.isVisible(seen), address);
        assert.ok(
          await page.locator(seen).evaluate((element) => element.getBoundingClientRect().top < innerHeight),
          `${address} is in view`,
        );
      }
    },
    { path: "icon.svg" },
  ));

test("axe finds nothing in the gallery, nothing hangs over on a phone, and it can be read without a script", async () => {
  await onPage(
    { ...PHONE, colorScheme: "dark" },
    async (page) => {
      await page.waitForSelector("body[data-state=ready]");
      assert.ok(await page.isVisible("#search"));
      for (const view of ["topics", "reports"]) {
        await page.click(`.views [data-view=${view}]`);
        // What holds for some entries holds for all, but takes axe less time.
        await page.fill("#search", "edge_check");
        assert.deepEqual(await violations(page), [], view);
        await page.fill("#search", "");
        for (const width of [320, 390, 820, 1024]) {
          await page.setViewportSize({ width, height: 844 });
          assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, `${width} px`);
          // Its panel is below the entries, which have all of the width.
          const [column, panel] = await Promise.all(
            [".stage-column", ".panel"].map((part) => page.locator(part).boundingBox()),
          );
          assert.ok(column && panel && panel.y >= column.y + column.height, `${width} px`);
        }
      }
      await page.setViewportSize(PHONE.viewport);
      await page.click("#filters summary");
      for (const control of ["#search", "#filter-report", "#filters summary", "#topics a", ".views a"])
        assert.ok(((await page.locator(control).first().boundingBox())?.height ?? 0) >= 43.5, control);
    },
    { path: `gallery.html#${ofReports[ofReports.length - 1].id}` },
  );
  await onPage(
    { javaScriptEnabled: false },
    async (page) => {
      assert.ok(await page.isVisible(`.entry:target .open`));
      await page.click(".views [data-view=reports]");
      assert.ok(await page.isVisible("#reports h2"));
      assert.equal(await page.locator("#rows tbody tr[id]:visible").count(), rows.length);
      assert.deepEqual(await shownIds(page), idsOf(entries));
    },
    { path: `gallery.html#${entries[0].id}` },
  );
});

/** A selector of an entry, whose id may begin with a digit. @param {Entry} entry */
function at({ id }) {
  return `[id="${id}"]`;
}
