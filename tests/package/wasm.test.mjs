/**
 * The WebAssembly modules need nothing that a browser of March 2023 without special headers lacks, and hold no texts of
 * the catalogue.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../scripts/run.mjs";

for (const file of ["planarium_bg.wasm", "full/full_bg.wasm", "import/import_bg.wasm", "shortest/shortest_bg.wasm"]) {
  const path = join(root, "dist", "package", file);

  test(`${file} has vector instructions, and no other feature that a plain build lacks: no threads`, () => {
    const allowed = new Set([
      "mutable-globals",
      "nontrapping-float-to-int",
      "bulk-memory",
      "bulk-memory-opt",
      "sign-ext",
      "reference-types",
      "multivalue",
      "call-indirect-overlong",
    ]);
    const output = execFileSync(
      process.execPath,
      [join(root, "node_modules", "binaryen", "bin", "wasm-opt"), path, "--print-features"],
      {
        encoding: "utf8",
        stdio: ["ignore", "pipe", "ignore"],
      },
    );
    const features = output
      .trim()
      .split("\n")
      .map((line) => line.replace("--enable-", ""));
    assert.deepEqual(
      features.filter((feature) => !allowed.has(feature)),
      ["simd"],
    );
  });

  test(`the memory of ${file} is not shared`, () => {
    const module = new WebAssembly.Module(readFileSync(path));
    assert.deepEqual(
      WebAssembly.Module.imports(module).filter(({ kind }) => kind === "memory"),
      [],
    );
    assert.ok(WebAssembly.Module.exports(module).some(({ kind, name }) => kind === "memory" && name === "memory"));
  });

  test(`${file} holds no texts of the catalogue`, () => {
    const bytes = readFileSync(path);
    assert.equal(bytes.includes("visibility-prm"), !/^(?:import|shortest)/.test(file), "ids are in those that plan");
    const found = textsOf(JSON.parse(readFileSync(join(root, "schema", "catalogue.json"), "utf8"))).filter((text) =>
      bytes.includes(text),
    );
    assert.deepEqual(found, []);
  });
}

/**
 * Titles, summaries, meanings and lines of pseudo-code that are longer than any word that the core must know.
 * @param {unknown} value
 * @returns {string[]}
 */
function textsOf(value) {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([key, inner]) => {
    if (typeof inner !== "string") return textsOf(inner);
    return ["title", "summary", "guarantee", "meaning", "default_meaning", "text"].includes(key) &&
      inner.length >= 12 &&
      inner.includes(" ")
      ? [inner]
      : [];
  });
}
