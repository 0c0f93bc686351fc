/** The WebAssembly module needs nothing that a browser of March 2023 without special headers lacks. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../scripts/run.mjs";

const path = join(root, "dist", "package", "planarium_bg.wasm");

test("it has vector instructions, and no other feature that a plain build lacks: no threads", () => {
  const allowed = new Set([
    "mutable-globals", "nontrapping-float-to-int", "bulk-memory", "bulk-memory-opt", "sign-ext", "reference-types", "multivalue", "call-indirect-overlong",
  ]);
  const output = execFileSync(process.execPath, [join(root, "node_modules", "binaryen", "bin", "wasm-opt"), path, "--print-features"], {
    encoding: "utf8", stdio: ["ignore", "pipe", "ignore"],
  });
  const features = output.trim().split("\n").map((line) => line.replace("--enable-", ""));
  assert.deepEqual(features.filter((feature) => !allowed.has(feature)), ["simd"]);
});

test("its memory is not shared", () => {
  const module = new WebAssembly.Module(readFileSync(path));
  assert.deepEqual(WebAssembly.Module.imports(module).filter(({ kind }) => kind === "memory"), []);
  assert.ok(WebAssembly.Module.exports(module).some(({ kind, name }) => kind === "memory" && name === "memory"));
});
