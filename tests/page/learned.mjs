/** What tests of the page of learned edges share: its states, and what the package plans, drives and trains. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Navigation } from "planarium/full";
import { FIRST } from "../../www/prm-rl/session.js";
import { onPage, root } from "./browser.mjs";
import { CALM, rest } from "./stage.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./browser.mjs").Options} Options */

/** What the page gives a planner, beside what is set. */
export const ROADMAP = { samples: 400, k: 15 };

/** @type {import("planarium/full").PolicyDocument} */
export const policy = JSON.parse(readFileSync(join(root, "www", "prm-rl", "policy.json"), "utf8"));

export const first = Navigation.generate(FIRST.kind, FIRST.options);

/**
 * The page, opened; with reduced motion it has planned and driven.
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {Options} [options]
 * @param {string} [fragment]
 */
export const onLearned = (act, options = CALM, fragment = "") =>
  onPage(
    options,
    async (page, url) => {
      if (options.reducedMotion === "reduce") await rest(page);
      await act(page, url);
    },
    { path: `prm-rl.html${fragment}` },
  );
