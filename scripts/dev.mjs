/**
 * `npm run dev`: serves the pages on PORT (8081) and makes them again whenever a file of theirs changes, which open pages show at once.
 * Enter rebuilds the package first, for changes of Rust. Files are neither compressed nor kept for use without a network; pictures of
 * the gallery are made once.
 */
import { existsSync, rmSync, watch } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { buildPackage } from "./build.mjs";
import { assemblePage } from "./page.mjs";
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
  await assemblePage({ out, isDraft: true });
  const { url, reload } = await serve({ root: out, port, reloads: true });
  console.log(`\nPlanarium is at ${url} (Ctrl+C stops it). A change of www is shown at once; press Enter after a change of Rust.`);

  let isBuilding = false;
  /** What is asked for while pages are made: pages again, after the package or not. @type {{ withPackage: boolean } | null} */
  let wanted = null;
  /** Makes the pages, after the package if that is wanted; again if something changed meanwhile. @param {boolean} withPackage */
  const make = async (withPackage) => {
    if (isBuilding) return void (wanted = { withPackage: withPackage || Boolean(wanted?.withPackage) });
    isBuilding = true;
    wanted = null;
    const begun = performance.now();
    try {
      if (withPackage) await buildPackage();
      await assemblePage({ out, isDraft: true });
      reload();
      console.log(`made in ${((performance.now() - begun) / 1000).toFixed(2)} s`);
    } catch (error) {
      console.error(error instanceof Problem || error instanceof Error ? error.message : error);
    }
    isBuilding = false;
    // A function of its own may have set it while it waited, which the checker of types cannot see.
    const next = /** @type {{ withPackage: boolean } | null} */ (wanted);
    if (next) await make(next.withPackage);
  };
  /** @type {NodeJS.Timeout | undefined} */
  let timer;
  watch(join(root, "www"), { recursive: true }, () => {
    clearTimeout(timer);
    timer = setTimeout(() => void make(false), QUIET);
  });
  createInterface({ input: process.stdin }).on("line", () => void make(true));
});
