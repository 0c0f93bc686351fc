/**
 * `npm run dev`: serves the pages on PORT (8081) and makes them again whenever a file of theirs changes, which open
 * pages show at once. Enter rebuilds the package first, for changes of Rust. Files are neither compressed nor kept for
 * use without a network; pictures of the gallery are made once.
 */
import { existsSync, rmSync, watch } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { buildPackage } from "./build.mjs";
import { assemblePageIn } from "./page.mjs";
import { Problem, root, script } from "./run.mjs";
import { requireFreePort, serve, wantedPort } from "./serve.mjs";

/** Milliseconds without a further change before pages are made. */
const QUIET = 30;

await script(async () => {
  const port = wantedPort(8081);
  await requireFreePort(port);
  if (!existsSync(join(root, "dist", "package", "planarium.js"))) await buildPackage();
  const out = join(root, "dist", "dev");
  rmSync(out, { recursive: true, force: true });
  console.log("Making the pages, and once the gallery's pictures ...");
  await assemblePageIn(out, true);
  const { url, reload } = await serve({ root: out, port, reloads: true });
  console.log(
    `\nPlanarium is at ${url} (Ctrl+C stops it). A change of www is shown at once; press Enter after a change of Rust.`,
  );

  let isBuilding = false;
  const due = { pages: false, package: false };
  /**
   * Makes the pages, after the package if that is wanted; what is wanted meanwhile is made afterwards.
   * @param {boolean} withPackage
   */
  const make = async (withPackage) => {
    due.pages = true;
    due.package ||= withPackage;
    if (isBuilding) return;
    isBuilding = true;
    while (due.pages) {
      const isPackageDue = due.package;
      due.pages = due.package = false;
      const begun = performance.now();
      try {
        if (isPackageDue) await buildPackage();
        await assemblePageIn(out, true);
        reload();
        console.log(`made in ${((performance.now() - begun) / 1000).toFixed(2)} s`);
      } catch (error) {
        console.error(error instanceof Problem || error instanceof Error ? error.message : error);
      }
    }
    isBuilding = false;
  };
  /** @type {NodeJS.Timeout | undefined} */
  let timer;
  watch(join(root, "www"), { recursive: true }, () => {
    clearTimeout(timer);
    timer = setTimeout(() => void make(false), QUIET);
  });
  createInterface({ input: process.stdin }).on("line", () => void make(true));
});
