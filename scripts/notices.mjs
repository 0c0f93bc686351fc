/** The licences of the crates that are compiled into the WebAssembly module. */
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { Problem, ask } from "./run.mjs";

/** @typedef {{ id: string, name: string, version: string, license: string | null, authors: string[], repository: string | null, manifest_path: string, targets: { kind: string[] }[] }} Package */
/** @typedef {{ id: string, deps: { pkg: string, dep_kinds: { kind: string | null }[] }[] }} Node */

/**
 * Writes one file with the licence text of every crate that is linked into the module.
 * @param {string} path
 */
export function writeNotices(path) {
  /** @type {Map<string, string[]>} the names of crates by licence text, so that equal texts appear once */
  const byText = new Map();
  for (const crate of linkedCrates()) {
    const text = licenceText(crate);
    byText.set(text, [...(byText.get(text) ?? []), `${crate.name} ${crate.version} (${crate.license})`]);
  }
  const sections = [...byText].map(([text, names]) => `${names.join("\n")}\n\n${text}\n`);
  const opening = "planarium_bg.wasm contains the Rust standard library (MIT OR Apache-2.0) and the crates below.\n";
  writeFileSync(path, [opening, ...sections].join(`\n${"-".repeat(80)}\n\n`));
}

/** @returns {Package[]} the crates in the module by name, without those that only run at compile time */
function linkedCrates() {
  const answer = ask("cargo", ["metadata", "--format-version", "1", "--locked", "--filter-platform", "wasm32-unknown-unknown"]);
  if (answer === undefined) throw new Problem("`cargo metadata` failed.");
  /** @type {{ packages: Package[], resolve: { root: string, nodes: Node[] } }} */
  const { packages, resolve } = JSON.parse(answer);
  const packageOf = new Map(packages.map((one) => [one.id, one]));
  const nodeOf = new Map(resolve.nodes.map((one) => [one.id, one]));
  const reached = new Set([resolve.root]);
  for (const id of reached) {
    for (const { pkg, dep_kinds } of nodeOf.get(id)?.deps ?? []) {
      const isLinked = dep_kinds.some(({ kind }) => kind === null);
      const isMacro = packageOf.get(pkg)?.targets.some(({ kind }) => kind.includes("proc-macro"));
      if (isLinked && !isMacro) reached.add(pkg);
    }
  }
  reached.delete(resolve.root);
  return [...reached].flatMap((id) => packageOf.get(id) ?? []).sort((a, b) => (a.name < b.name ? -1 : 1));
}

/**
 * The MIT text if the crate has one, otherwise all its licence files.
 * @param {Package} crate
 */
function licenceText(crate) {
  const folder = dirname(crate.manifest_path);
  const files = readdirSync(folder).filter((name) => /^(licen[sc]e|copying|notice|unlicense)/i.test(name)).sort();
  const mit = files.filter((name) => /mit/i.test(name));
  const chosen = mit.length > 0 ? mit : files.filter((name) => files.length === 1 || !/apache/i.test(name));
  const texts = chosen.map((name) => readFileSync(join(folder, name), "utf8").replaceAll("\r\n", "\n").trim());
  if (texts.length > 0) return texts.join("\n\n");
  return `Licence: ${crate.license}. Authors: ${crate.authors.join(", ") || "see the repository"}. ${crate.repository ?? ""}`.trim();
}
