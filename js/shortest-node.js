/** `planarium/shortest` for Node: ready on import. */
import { readFileSync } from "node:fs";
import { loadSync } from "./runtime.js";

export * from "./shortest.js";
export { default } from "./shortest.js";

loadSync(readFileSync(new URL("./shortest_bg.wasm", import.meta.url)));
