/** Files that are opened on the planner's page: scenarios, arrays, and worlds of other programs. */
import { isArray, kindOf, namesOf, readFiles } from "../app/read-files.js";
import { hasSite, requireFormats } from "../app/site.js";
import { pathKind } from "./judge/kind.js";

/** @import { Page } from "./page.js" */
/** @import { Content } from "../app/read-files.js" */

/** What a file may be. @type {["path" | "world", string][]} */
const CHOICES = [
  ["path", "Judge it as a path"],
  ["world", "Open it as a world"],
];

/**
 * Offers to zoom in large scenes, wherever they come from, and gives what opens files: those that are refused leave the
 * open scene in place.
 * @param {Page} page
 */
export async function opener(page) {
  if (hasSite()) await (await import("./zoom.js")).offerZoom(page);
  return (/** @type {File[]} */ files) => page.app.track(open(page, files), `${namesOf(files)} could not be opened.`);
}

/** @param {Page} page @param {File[]} files */
async function open(page, files) {
  const contents = await readFiles(files);
  const [first] = contents;
  if (contents.length === 1 && page.facts && !isArray(first.name, first.bytes)) {
    const kind = pathKind(page.facts.dimension, first);
    if (kind === "path" || (kind === "maybe" && hasSite())) {
      const choice = kind === "path" ? "path" : await page.notice.ask(`${first.name}: how is it opened?`, CHOICES);
      if (choice === "path") await judgePath(page, first);
      if (choice !== "world") return;
    }
  }
  const kind = contents.length === 1 ? kindOf(first) : "world";
  if (kind === "document") {
    await page.open({ document: new TextDecoder().decode(first.bytes) });
  } else if (kind === "array") {
    const { arrayKind, openArray } = await import("./export/arrays.js");
    const held = page.facts && arrayKind(page.facts, first.bytes);
    if (held === "path" && hasSite()) await judgePath(page, first);
    else if (held === "cells") await openWorld(page, contents);
    else await openArray(page, first.name, first.bytes, hasSite() ? () => judgePath(page, first) : null);
  } else await openWorld(page, contents);
}

/** @param {Page} page @param {Content} file */
async function judgePath(page, file) {
  requireFormats();
  await (await import("./judge/judge.js")).judgeFile(page, file);
}

/** @param {Page} page @param {Content[]} contents */
async function openWorld(page, contents) {
  requireFormats();
  const { doorOf } = await import("./world.js");
  await (await doorOf(page)).take(contents);
}
