/**
 * The one WebAssembly instance behind the package: loaded once, and renewed after a trap. A trap leaves the core's
 * memory in an unknown state, so each later call fails with the code `internal` until `init` or `initSync` makes a
 * fresh instance; objects of the lost one are gone, and are never freed into it.
 */
import * as glue from "./planarium_glue.js";
import { PlanariumError, isFromCore, isOwn, reasonOf } from "./error.js";

/** A module of one function that returns a vector: valid where the engine has vector instructions. */
const VECTORS = Uint8Array.of(
  0,
  97,
  115,
  109,
  1,
  0,
  0,
  0,
  1,
  5,
  1,
  96,
  0,
  1,
  123,
  3,
  2,
  1,
  0,
  10,
  8,
  1,
  6,
  0,
  65,
  0,
  253,
  15,
  11,
);

/** What tells the modules of the entries apart: exports, and what the glue makes of them. */
const SIGNS = [
  ["scenario_parse", "Scenario"],
  ["fleet_parse", "Fleet"],
  ["readFiles", "readFiles"],
  ["shortestmap_query", "ShortestMap"],
];

/** Marks the objects of this core: the package has two, `planarium` and `planarium/full`. */
export const core = Symbol("core");

/**
 * Number of the instance in use, from 0 as the glue counts them; -1 before the first. Objects of the core hold theirs.
 */
let instance = -1;
/** What made the instance trap, or undefined while it is sound. @type {unknown} */
let fault;
/** The load under way, shared by callers that come meanwhile. @type {Promise<void> | undefined} */
let loading;

/** Number of the instance in use; objects of an earlier one are lost. */
export function currentInstance() {
  return instance;
}

/** Whether the instance in use can still be called. */
export function isSound() {
  return instance >= 0 && fault === undefined;
}

/** Refuses to call a core that is not there. */
export function requireCore() {
  if (instance < 0) {
    throw new PlanariumError(
      "not-initialised",
      "Planarium is not initialised: call `await init()` (or `initSync(module)`) first.",
    );
  }
  if (fault !== undefined) throw lost();
}

/**
 * What a call of the core has thrown, as an error of the package; after a trap the core is lost.
 * @param {unknown} error
 * @returns {PlanariumError}
 */
export function asOwn(error) {
  if (isOwn(error)) return error;
  if (isFromCore(error))
    return new PlanariumError(error.code, error.message, error.pointer, { nearest: error.nearest });
  if (isTrap(error)) {
    fault = error;
    glue.__planarium_lose();
    return lost();
  }
  return new PlanariumError("internal", `Planarium could not finish this call: ${reasonOf(error)}`, "", {
    cause: error,
  });
}

/**
 * Whether an error stopped the core in the middle of its work: a trap, or the end of the stack.
 * @param {unknown} error
 */
function isTrap(error) {
  if (error instanceof WebAssembly.RuntimeError) return true;
  if (!(error instanceof Error)) return false;
  endOfStack ??= errorAtEndOfStack();
  return error.name === endOfStack.name && error.message === endOfStack.message;
}

/** What this engine throws at the end of the stack: no class of errors is for that alone. @type {Error | undefined} */
let endOfStack;

/** @returns {Error} */
function errorAtEndOfStack() {
  const deeper = () => {
    deeper();
  };
  try {
    deeper();
  } catch (error) {
    return /** @type {Error} */ (error);
  }
  throw new Error("unreachable");
}

/** The error of every call after a trap. */
function lost() {
  const reason = reasonOf(fault);
  return new PlanariumError(
    "internal",
    `Planarium's core stopped on a fault of its own (${reason}). Call init() for a fresh one; earlier handles are lost.`,
    "",
    { cause: fault },
  );
}

/**
 * Loads the core once. Concurrent callers share the load; after a trap the next call makes a fresh instance from the
 * compiled module.
 * @param {unknown} source  see `InitInput` in the types
 * @returns {Promise<void>}
 * @throws {PlanariumError} `no-simd`, `init-failed`; a later call tries again
 */
export async function load(source) {
  if (instance >= 0) return renew();
  requireVectors();
  loading ??= compile(source)
    .then(start)
    .finally(() => {
      loading = undefined;
    });
  return loading;
}

/**
 * Loads the core from bytes or a compiled module.
 * @param {unknown} source
 * @throws {PlanariumError} `no-simd`, `init-failed`
 */
export function loadSync(source) {
  if (instance >= 0) return renew();
  requireVectors();
  const module = unwrap(source);
  const tag = tagOf(module);
  if (tag === "WebAssembly.Module") return start(/** @type {WebAssembly.Module} */ (module));
  if (!isBytes(module)) {
    throw new PlanariumError("init-failed", `initSync takes bytes or a WebAssembly.Module, not ${describe(module)}.`);
  }
  try {
    start(new WebAssembly.Module(module));
  } catch (error) {
    throw failed("these bytes do not compile as WebAssembly", error);
  }
}

/** Refuses an engine that cannot run the core. */
function requireVectors() {
  if (WebAssembly.validate(VECTORS)) return;
  const have = "Browsers have them since March 2023, Node since version 16.4.";
  throw new PlanariumError(
    "no-simd",
    `Planarium needs the vector instructions of WebAssembly (simd128), which this engine lacks. ${have}`,
  );
}

/** After a trap: a fresh instance. Otherwise nothing. */
function renew() {
  if (fault === undefined) return;
  // The glue counts an attempt that fails, too.
  instance += 1;
  try {
    glue.__wbg_reset_state();
  } catch (error) {
    throw failed("a fresh instance could not be made", error);
  }
  fault = undefined;
}

/** Makes the first instance, unless `initSync` has made it meanwhile. @param {WebAssembly.Module} module */
function start(module) {
  if (instance >= 0) return;
  const exported = new Set(WebAssembly.Module.exports(module).map(({ name }) => name));
  // The module of another entry lacks what this one needs, or has more than it can name.
  if (!exported.has("__wbindgen_start") || SIGNS.some(([name, key]) => exported.has(name) !== key in glue)) {
    throw new PlanariumError("init-failed", "This WebAssembly module is not planarium_bg.wasm.");
  }
  try {
    glue.initSync({ module });
  } catch (error) {
    throw failed("this planarium_bg.wasm does not belong to this version of the package", error);
  }
  instance = 0;
}

/** Compiles whatever the caller has. @param {unknown} source @returns {Promise<WebAssembly.Module>} */
async function compile(source) {
  try {
    const given = await unwrap(await source);
    switch (tagOf(given)) {
      case "WebAssembly.Module":
        return /** @type {WebAssembly.Module} */ (given);
      case "String":
      case "URL":
      case "Request":
        return await compileResponse(await fetch(/** @type {string | URL | Request} */ (given)));
      case "Response":
        return await compileResponse(/** @type {Response} */ (given));
      default:
        if (isBytes(given)) return await WebAssembly.compile(given);
    }
    throw new TypeError(
      `init takes a URL, a Request, a Response, bytes or a WebAssembly.Module, not ${describe(given)}`,
    );
  } catch (error) {
    throw failed("the WebAssembly module could not be loaded", error);
  }
}

/** @param {Response} response */
async function compileResponse(response) {
  if (!response.ok) throw new Error(`${response.url} answered ${response.status} ${response.statusText}`.trimEnd());
  // Streaming wants the right MIME type; a server that sends another still serves the right bytes.
  const type = response.headers.get("content-type") ?? "";
  if (type.startsWith("text/html")) {
    throw new Error(
      `${response.url} is an HTML page. A bundler may have moved the script away from the file (Vite before version 8 needs optimizeDeps: { exclude: ["planarium"] })`,
    );
  }
  if (type.startsWith("application/wasm") && typeof WebAssembly.compileStreaming === "function") {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * What is in `{ module_or_path }` or `{ module }`, the arguments of loaders of wasm-bindgen.
 * @param {unknown} source
 */
function unwrap(source) {
  if (tagOf(source) !== "Object") return source;
  const object = /** @type {{ module_or_path?: unknown, module?: unknown }} */ (source);
  return object.module_or_path ?? object.module ?? source;
}

/** The class of a value, across realms: `"Response"`, `"WebAssembly.Module"`, ... @param {unknown} value */
function tagOf(value) {
  return Object.prototype.toString.call(value).slice(8, -1);
}

/** @param {unknown} value @returns {value is BufferSource} */
function isBytes(value) {
  return ArrayBuffer.isView(value) || tagOf(value) === "ArrayBuffer";
}

/** @param {unknown} value */
function describe(value) {
  return value === undefined || value === null ? String(value) : `a value of type ${tagOf(value)}`;
}

/** @param {string} what @param {unknown} cause */
function failed(what, cause) {
  if (isOwn(cause)) return cause;
  const reason = reasonOf(cause);
  return new PlanariumError("init-failed", `Planarium did not start: ${what}: ${reason}`, "", { cause });
}
