/**
 * Planarium for Node: ready on import, so that `require("planarium")` works without anything to await.
 * `init` and `initSync` are there all the same, so that one program runs in both places.
 */
import { readFileSync } from "node:fs";
import { loadSync } from "./runtime.js";

export * from "./planarium.js";
export { default } from "./planarium.js";

loadSync(readFileSync(new URL("./planarium_bg.wasm", import.meta.url)));
