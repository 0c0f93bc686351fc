/** `planarium/full` for browsers, workers and bundlers: all of Planarium, with a core of its own, `full_bg.wasm`. */
export * from "./planarium.js";
export { default } from "./planarium.js";
export * from "./choices.js";
