/**
 * Writes the pictures, links and lists of the gallery, and returns its HTML. It needs the package in `dist/package`.
 */
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "./run.mjs";

const www = join(root, "www");

/** The documents that entries name. @type {import("../www/gallery/build/open.js").Documents} */
export const documents = {
  world: (name) => JSON.parse(readFileSync(join(www, "gallery", "worlds", `${name}.json`), "utf8")),
  scene: (name) => readFileSync(join(www, "scenes", `${name}.json`), "utf8"),
  policies: () => ({
    differential_drive: JSON.parse(readFileSync(join(www, "prm-rl", "policy.json"), "utf8")),
    cargo: JSON.parse(readFileSync(join(www, "prm-rl", "policy-cargo.json"), "utf8")),
  }),
  experiment: (name) => {
    const folder = join(www, "experiments", "documents");
    const document = JSON.parse(readFileSync(join(folder, `${name}.json`), "utf8"));
    // A file names its scenarios relative to itself; a link holds them.
    for (const world of document.worlds)
      if (typeof world.scenario === "string")
        world.scenario = JSON.parse(readFileSync(join(folder, world.scenario), "utf8"));
    return document;
  },
};

/** @param {string} out  a folder, which is made @returns {Promise<string>}  the HTML of topics, reports and rows */
export async function assembleGallery(out) {
  // The package may have been built a moment ago, so it is loaded only now.
  const [{ ENTRIES, REPORTS }, { MORE }, { openEntry }, { sheetOf }, { galleryHtml }, { csvFile }] = await Promise.all([
    import("../www/gallery/reports.js"),
    import("../www/gallery/more.js"),
    import("../www/gallery/build/open.js"),
    import("../www/gallery/build/sheet.js"),
    import("../www/gallery/build/page.js"),
    import("../www/formats/csv.js"),
  ]);
  mkdirSync(out, { recursive: true });
  cpSync(join(www, "gallery", "worlds"), join(out, "worlds"), { recursive: true });
  const style = coloursOf();
  /** @type {Map<string, import("../www/gallery/build/page.js").Shown>} */
  const shown = new Map();
  for (const entry of ENTRIES) {
    const { address, panes, pane } = await openEntry(entry, documents);
    const picture = sheetOf(panes, { title: entry.title, style }, pane);
    const [, width = 0, height = 0] = /<svg [^>]*width="(\d+)" height="(\d+)"/.exec(picture)?.map(Number) ?? [];
    writeFileSync(join(out, `${entry.id}.svg`), picture);
    shown.set(entry.id, { entry, address, width, height });
  }
  const addresses = Object.fromEntries([...shown].map(([id, { address }]) => [id, address]));
  writeFileSync(
    join(out, "reports.json"),
    JSON.stringify({ reports: REPORTS, more: ENTRIES.slice(-MORE.length), addresses }),
  );
  const rows = REPORTS.flatMap(({ number, rows: own }) =>
    own.map(({ row, kind, name, shows, verdict, where, entries, holds, why = "" }) => [
      row,
      number,
      kind,
      name,
      shows,
      verdict,
      where,
      entries.join(" "),
      holds,
      why,
    ]),
  );
  writeFileSync(
    join(out, "rows.csv"),
    await csvFile(["row", "report", "kind", "name", "shows", "here", "where", "entries", "holds", "why"], rows).text(),
  );
  return galleryHtml(REPORTS, shown);
}

/** The colours of the pages as the style of a file: an image follows the theme of the page that it is in. */
export function coloursOf() {
  const css = readFileSync(join(www, "style", "colours.css"), "utf8");
  const colours = [...css.matchAll(/(--[\w-]+): (light-dark\([^)]*\));/g)].map(([, name, value]) => `${name}:${value}`);
  return `:root{color-scheme:light dark;${colours.join(";")}}`;
}
