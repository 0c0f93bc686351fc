/** `planarium/full` for Node: ready on import. */
export * from "./node.js";
export { default } from "./node.js";
export * from "./choices.js";
