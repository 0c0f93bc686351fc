/** Entries of the gallery, for their tests: a sample has one of each kind. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ENTRIES, REPORTS } from "../../www/gallery/reports.js";
import { byTopic } from "../../www/gallery/topics.js";
import { pageRoot } from "./browser.mjs";

export const ofReports = REPORTS.flatMap((report) => report.entries);

/** As the page has them. */
export const topics = byTopic(ENTRIES);

export const entries = topics.flatMap((topic) => topic.entries);

export const rows = REPORTS.flatMap((report) => report.rows);

/** The links that the build has made, by the ids of entries. @type {Record<string, string>} */
export const addresses = JSON.parse(readFileSync(join(pageRoot, "gallery", "reports.json"), "utf8")).addresses;
