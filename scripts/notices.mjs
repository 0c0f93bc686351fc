/**
 * The licences of the crates that are compiled into the WebAssembly modules, and of the npm packages that are part of
 * the pages.
 */
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { Problem, ask, root } from "./run.mjs";

/** The platform of the modules. */
const TARGET = "wasm32-unknown-unknown";

/** Between two texts. */
const RULE = `\n${"-".repeat(80)}\n\n`;

/** The file with the notices. */
export const NOTICES = "THIRD-PARTY-NOTICES.txt";

/**
 * @typedef {{ name: string, version: string, source: string | null, license: string | null, authors: string[],
 *   repository: string | null, manifest_path: string }} Package
 */

/**
 * Writes one file with the licence text of every crate that is linked into a module.
 * @param {string} path
 */
export function writeNotices(path) {
  const metadata = ask("cargo", ["metadata", "--format-version", "1", "--locked", "--filter-platform", TARGET]);
  if (metadata === undefined) throw new Problem("`cargo metadata` failed.");
  /** @type {{ packages: Package[] }} */
  const { packages } = JSON.parse(metadata);
  const core = linkedCrates("planarium", packages);
  const beside = linkedCrates("planarium-formats", packages).filter(({ manifest_path }) =>
    core.every((crate) => crate.manifest_path !== manifest_path),
  );
  const texts = (/** @type {Package[]} */ crates) =>
    crates.map((crate) => ({ crate, text: licenceText(crate, dirname(crate.manifest_path)) }));
  const of = "the Rust standard library (MIT OR Apache-2.0) and the crates below.\n";
  const all = [
    joined(`planarium_bg.wasm, full_bg.wasm, import_bg.wasm and shortest_bg.wasm contain ${of}`, texts(core)),
    joined("import_bg.wasm also contains the crates below.\n", texts(beside)),
  ];
  writeFileSync(path, all.join(RULE));
}

/**
 * Adds the licence text of every npm package that is part of the pages, with the address of its source.
 * @param {string} path  of the notices of the module
 * @param {string} out
 * @param {string[]} inputs  files that were bundled, from the root on
 */
export function addPageNotices(path, out, inputs) {
  writeFileSync(out, readFileSync(path, "utf8") + RULE + packageNotices(inputs));
}

/** The licence texts of the npm packages among bundled files. @param {string[]} inputs  from the root on */
export function packageNotices(inputs) {
  return joined(
    "The pages contain the npm packages below.\n",
    bundledPackages(inputs).map((crate) => ({ crate, text: licenceText(crate, join(root, crate.folder)) })),
  );
}

/** The npm packages among bundled files, by name. @param {string[]} inputs  from the root on */
function bundledPackages(inputs) {
  const folders = new Set(inputs.flatMap((file) => /^node_modules\/(@[^/]+\/)?[^/]+/.exec(file)?.[0] ?? []));
  return [...folders].sort().map((folder) => {
    const { name, version, license, author, repository } = JSON.parse(
      readFileSync(join(root, folder, "package.json"), "utf8"),
    );
    const source = String(repository?.url ?? repository ?? "").replace(/^git\+|\.git$/g, "");
    return {
      name: String(name),
      version: String(version),
      license: String(license),
      authors: [author?.name ?? author ?? ""].filter(Boolean),
      repository: source,
      address: source,
      folder,
    };
  });
}

/**
 * The texts under the names of those that have them, so that equal texts appear once.
 * @param {string} opening
 * @param {{ crate: Pick<Package, "name" | "version" | "license"> & { address?: string }, text: string }[]} all
 */
function joined(opening, all) {
  /** @type {Map<string, string[]>} */
  const byText = new Map();
  for (const {
    crate: { name, version, license, address },
    text,
  } of all) {
    byText.set(text, [...(byText.get(text) ?? []), `${name} ${version} (${license})${address ? `, ${address}` : ""}`]);
  }
  const sections = [...byText].map(([text, names]) => `${names.join("\n")}\n\n${text}\n`);
  return [opening, ...sections].join(RULE);
}

/**
 * The crates in the module of a crate of this project by name, without those that only run at compile time.
 * @param {string} crate
 * @param {Package[]} packages  of the workspace
 * @returns {Package[]}
 */
function linkedCrates(crate, packages) {
  // `cargo metadata` resolves the whole workspace at once, and would add what the command line needs.
  const tree = ask("cargo", [
    "tree",
    "--locked",
    "-p",
    crate,
    "--target",
    TARGET,
    "--edges",
    "normal,no-proc-macro",
    "--prefix",
    "none",
    "--format",
    "{p}",
  ]);
  if (tree === undefined) throw new Problem("`cargo tree` failed.");
  const linked = new Set(tree.split("\n").map((line) => line.split(" ", 2).join(" ")));
  return packages
    .filter(({ name, version, source }) => source !== null && linked.has(`${name} v${version}`))
    .sort((a, b) => (a.name < b.name ? -1 : 1));
}

/**
 * The MIT text if there is one, otherwise all its licence files.
 * @param {Pick<Package, "license" | "authors" | "repository">} crate  or npm package @param {string} folder
 */
function licenceText(crate, folder) {
  const files = readdirSync(folder)
    .filter((name) => /^(licen[sc]e|copying|notice|unlicense)/i.test(name))
    .sort();
  const mit = files.filter((name) => /mit/i.test(name));
  const chosen = mit.length > 0 ? mit : files.filter((name) => files.length === 1 || !/apache/i.test(name));
  const texts = chosen.map((name) => readFileSync(join(folder, name), "utf8").replaceAll("\r\n", "\n").trim());
  if (texts.length > 0) return texts.join("\n\n");
  return `Licence: ${crate.license}. Authors: ${crate.authors.join(", ") || "see the repository"}. ${crate.repository ?? ""}`.trim();
}
