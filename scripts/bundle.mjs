/** Bundles of the pages' scripts and styles. */
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join } from "node:path";
import { root } from "./run.mjs";

export const dist = join(root, "dist");
/** The part of the package that needs no core: each script has what it uses of it. */
export const DRAW = { "planarium/draw": join(dist, "package", "draw.js") };

/**
 * Bundles an entry and all its imports into one file.
 * @param {string} entry
 * @param {string} out
 * @param {import("esbuild").BuildOptions} [more]
 * @returns {import("esbuild").Metafile}
 */
export function joinModules(entry, out, more = {}) {
  /** @type {typeof import("esbuild")} */
  const { buildSync } = createRequire(import.meta.url)("esbuild");
  const { metafile } = buildSync({
    entryPoints: [entry],
    outfile: out,
    bundle: true,
    minify: true,
    sourcemap: true,
    format: "esm",
    target: "es2022",
    logLevel: "warning",
    metafile: true,
    absWorkingDir: root,
    ...more,
  });
  return /** @type {import("esbuild").Metafile} */ (metafile);
}

/** The files of which something is in the output. @param {import("esbuild").Metafile} metafile @returns {string[]} */
export function includedIn({ outputs }) {
  return Object.values(outputs).flatMap(({ inputs }) =>
    Object.entries(inputs)
      .filter(([, { bytesInOutput }]) => bytesInOutput > 0)
      .map(([file]) => file),
  );
}

/** The names of the files of ready experiments, and the titles of their documents. */
export function readyExperiments() {
  const folder = join(root, "www", "experiments", "documents");
  return readdirSync(folder)
    .sort()
    .map((name) => ({
      id: basename(name, ".json"),
      title: JSON.parse(readFileSync(join(folder, name), "utf8")).title,
    }));
}
