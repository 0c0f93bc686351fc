/** Steps of the build that are left out while what they are made of is the same and what they made is whole. */
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { root } from "./run.mjs";

/** Folders that are made, or that no step reads: from the root of the project on, and by their names. */
const PLACES = new Set(["dist", join("docs", "api"), "fuzz", "tests"]);
const NAMES = new Set([".git", "node_modules", "target"]);

/**
 * Makes files, unless those that it made last time are there and all that it reads is as it was then: the project but
 * for its tests, the package that was built from it, and the version of Node.
 * @param {string} name   of the step
 * @param {string[]} made   the folders that it makes, from the root of the project on
 * @param {unknown} given   what else decides what it makes, as plain data
 * @param {() => Promise<void>} make
 */
export async function unlessMade(name, made, given, make) {
  const stamp = join(root, "dist", "stamps", name);
  const read = createHash("sha256").update(JSON.stringify([process.version, given]));
  for (const file of [...filesIn(""), ...["package", "types"].flatMap((one) => filesIn(join("dist", one)))])
    read.update(`\0${file}\0`).update(readFileSync(join(root, file)));
  const from = read.digest("hex");
  // Sizes are enough to see that a file is gone or was cut.
  const whole = () => {
    const sizes = made.flatMap(filesIn).map((file) => [file, statSync(join(root, file)).size]);
    return `${from} ${createHash("sha256").update(JSON.stringify(sizes)).digest("hex")}`;
  };
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === whole()) return;
  rmSync(stamp, { force: true });
  await make();
  mkdirSync(dirname(stamp), { recursive: true });
  writeFileSync(stamp, whole());
}

/** The files in a folder of the project, in an order that is always the same. @param {string} folder @returns {string[]} */
function filesIn(folder) {
  if (!existsSync(join(root, folder))) return [];
  return readdirSync(join(root, folder), { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => {
      const path = join(folder, entry.name);
      if (entry.isDirectory()) return NAMES.has(entry.name) || PLACES.has(path) ? [] : filesIn(path);
      return entry.isFile() ? [path] : [];
    });
}
