/** What holds for every page in every state: for axe, at any width, for fingers, in forced colours. */
import assert from "node:assert/strict";
import { DESK, coloursOf, frames, violations } from "./browser.mjs";

/** @import { Page } from "./browser.mjs" */

/** From the narrowest phone to a large desk, with the widths of a phone, a tablet and a small desk. */
const WIDTHS = [320, 390, 768, 1024, 1440];
/**
 * Colours do not depend on the width, nor names and roles on the colours: two looks hold all of both.
 * @type {["light" | "dark", number][]}
 */
const LOOKS = [
  ["light", 1440],
  ["dark", 320],
];

/** Waits until the page is at rest. @param {Page} page */
async function settled(page) {
  await frames(page);
  await page.waitForSelector("#counters[data-settled=true], body[data-settled=true]", { state: "attached" });
}

/**
 * Axe finds nothing, and nothing hangs over, in light and dark, on a desktop and on the narrowest phone; and, if there
 * are figures, at every width they are large enough.
 * @param {Page} page
 * @param {string} state  that the page is in
 * @param {number} [side]  of a figure, at least
 */
export async function assertFaultless(page, state, side = 0) {
  for (const width of WIDTHS) {
    const look = LOOKS.find(([, one]) => one === width);
    if (!look && side === 0) continue;
    await page.setViewportSize({ width, height: 900 });
    if (look) await page.emulateMedia({ colorScheme: look[0] });
    await settled(page);
    assert.equal(await overhang(page), 0, `${state}, ${width} px`);
    assert.deepEqual(await cutWords(page), [], `${state}, ${width} px`);
    if (look) assert.deepEqual(await violations(page), [], `${state}, ${look[0]}, ${width} px`);
    if (side > 0) await assertFigures(page, side, `${state}, ${width} px`);
  }
  await page.emulateMedia({ colorScheme: "light" });
  await page.setViewportSize(DESK.viewport);
  await settled(page);
}

/** There are figures, none smaller than it may be; below a desk's width no caption is cut. @param {Page} page @param {number} side @param {string} where */
async function assertFigures(page, side, where) {
  const sheets = await page
    .locator(".sheet")
    .evaluateAll((all) =>
      all.filter((sheet) => sheet.checkVisibility()).map((sheet) => sheet.getBoundingClientRect().toJSON()),
    );
  assert.ok(
    sheets.length > 0 && sheets.every((sheet) => sheet.width >= side && sheet.height >= side),
    `${where}: ${JSON.stringify(sheets)}`,
  );
  const cut = await page.locator(".pane figcaption, .scroll caption").evaluateAll((all) =>
    all
      .filter((one) => innerWidth < 1024 && one.checkVisibility())
      .filter((one) => one.scrollWidth > one.clientWidth || one.getBoundingClientRect().right > innerWidth)
      .map(({ textContent }) => textContent),
  );
  assert.deepEqual(cut, [], where);
}

/** Every control is at least 24 pixels high and wide. @param {Page} page */
export async function assertTargets(page) {
  const small = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, .rooms a, input:not([type=file], [name=scene]), summary")]
      .filter((element) => element.checkVisibility() && !element.closest(".visually-hidden, .card"))
      .map((element) => ({
        name: element.id || element.textContent || element.className,
        box: (element.closest("label") ?? element).getBoundingClientRect(),
      }))
      .filter(({ box }) => box.height < 24 || box.width < 24)
      .map(({ name, box }) => `${name} ${box.width}x${box.height}`),
  );
  assert.deepEqual(small, []);
}

/** The stage is drawn in the colours of the system. @param {Page} page  opened with forced colours */
export async function assertForced(page) {
  const [robot, stage, text, ground] = await coloursOf(page, ["var(--robot)", "var(--stage)", "CanvasText", "Canvas"]);
  assert.deepEqual([robot, stage], [text, ground]);
}

/**
 * Everything that can be used is reached by Tab, in its order, and shows that it has the focus.
 * @param {Page} page  just opened
 * @param {number} [most]  steps
 */
export async function assertKeys(page, most = 60) {
  const wanted = await page.evaluate(() => {
    const shown = /** @type {string[]} */ ([]);
    Object.assign(window, { focused: shown });
    const nameOf = (/** @type {HTMLElement} */ one) =>
      one.id || one.getAttribute("name") || one.textContent?.trim() || one.className;
    document.addEventListener("focusin", ({ target }) => {
      const element = /** @type {HTMLElement} */ (target);
      const outlined = element.matches(".card input") ? (element.parentElement ?? element) : element;
      shown.push(nameOf(element) + (getComputedStyle(outlined).outlineStyle === "none" ? " without a focus" : ""));
    });
    const groups = new Set();
    return /** @type {HTMLElement[]} */ ([
      ...document.querySelectorAll("a[href], button, select, input, summary, textarea, [tabindex='0']"),
    ])
      .filter((one) => one.tabIndex >= 0 && !one.matches(":disabled") && one.checkVisibility())
      .filter((one) => {
        // Of a group of radio buttons one is a stop.
        const group = one instanceof HTMLInputElement && one.type === "radio" ? one.name : "";
        if (group === "" || groups.has(group)) return group === "";
        return groups.add(group);
      })
      .map(nameOf);
  });
  const expected = wanted.slice(0, most);
  for (let i = 0; i < expected.length; i++) await page.keyboard.press("Tab");
  const reached = await page.evaluate(() => /** @type {{ focused?: string[] }} */ (window).focused);
  assert.deepEqual(reached, expected);
}

/** How many pixels hang over. @param {Page} page */
export const overhang = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

/** The words of charts that hang over their picture. @param {Page} page */
const cutWords = (page) =>
  page.locator("svg.chart").evaluateAll((all) =>
    all
      .filter((picture) => picture.checkVisibility())
      .flatMap((picture) => {
        const { left, right } = picture.getBoundingClientRect();
        return Array.from(picture.querySelectorAll("text"))
          .filter(
            (text) => text.getBoundingClientRect().left < left - 1 || text.getBoundingClientRect().right > right + 1,
          )
          .map(({ textContent }) => `${picture.ariaLabel}: ${textContent}`);
      }),
  );

/**
 * The figures take 60 % of the height and of the width at least, and all of them are in view.
 * @param {Page} page
 * @param {string} name
 */
export async function assertFills(page, name) {
  await settled(page);
  const { width, height, bottom } = await page.evaluate(() => {
    const boxes = [...document.querySelectorAll("#stage :is(.sheet, .plot)")].map((sheet) =>
      sheet.getBoundingClientRect(),
    );
    const side = (/** @type {number[]} */ from, /** @type {number[]} */ to) => Math.max(...to) - Math.min(...from);
    return {
      width:
        side(
          boxes.map(({ left }) => left),
          boxes.map(({ right }) => right),
        ) / innerWidth,
      height:
        side(
          boxes.map(({ top }) => top),
          boxes.map((box) => box.bottom),
        ) / innerHeight,
      bottom: Math.max(...boxes.map((box) => box.bottom)) / innerHeight,
    };
  });
  assert.ok(width >= 0.6 && height >= 0.6 && bottom <= 1, `${name}: ${JSON.stringify({ width, height, bottom })}`);
}
