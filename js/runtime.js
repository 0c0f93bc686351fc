/**
 * The one WebAssembly instance behind the package: loading it, reaching it, and noticing when it is lost.
 *
 * A trap leaves the core's memory in an unknown state. So the instance counts as lost from then on: each later call
 * fails with the code `internal` until `init` or `initSync` makes a fresh one, and handles of the lost one stay dead.
 */
import * as glue from "./planarium_glue.js";
import { PlanariumError, isFromCore, isOwn, reasonOf } from "./error.js";

/** Number of the instance in use, from 1; 0 before the first. Handles remember theirs. */
let instance = 0;
/** What made the instance trap, or undefined while it is sound. @type {unknown} */
let fault;
/** The load under way, shared by callers that come meanwhile. @type {Promise<void> | undefined} */
let loading;

/** Number of the instance in use; handles made by an earlier one are dead. */
export function currentInstance() {
  return instance;
}

/** Whether the instance in use can still be called. */
export function isSound() {
  return instance > 0 && fault === undefined;
}

/**
 * Calls the core. Everything thrown comes out as `PlanariumError`. Arguments are read before: nothing of the caller's own may run
 * in here.
 * @template T
 * @param {(core: typeof glue) => T} operation
 * @returns {T}
 */
export function call(operation) {
  if (instance === 0) {
    throw new PlanariumError("not-initialised", "Planarium is not initialised: call `await init()` (or `initSync(module)`) first.");
  }
  if (fault !== undefined) throw lost();
  try {
    return operation(glue);
  } catch (error) {
    if (isOwn(error)) throw error;
    if (isFromCore(error)) throw new PlanariumError(error.code, error.message, error.pointer);
    if (isTrap(error)) {
      fault = error;
      throw lost();
    }
    throw new PlanariumError("internal", `Planarium could not finish this call: ${reasonOf(error)}`, "", { cause: error });
  }
}

/**
 * Reads arguments, and then calls the core with them: reading may run the caller's own code, and nothing of that may happen while
 * the core works.
 * @template {unknown[]} A
 * @template T
 * @param {() => [...A]} read
 * @param {(core: typeof glue, ...given: A) => T} operation
 * @returns {T}
 */
export function callWith(read, operation) {
  call(() => {});
  const given = read();
  return call((core) => operation(core, ...given));
}

/**
 * Whether an error stopped the core in the middle of its work: a trap, or the end of the stack, which engines tell in different
 * words.
 * @param {unknown} error
 */
function isTrap(error) {
  return error instanceof WebAssembly.RuntimeError
    || (error instanceof Error && /call stack|too much recursion|stack overflow/i.test(error.message));
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
 * Loads the core once. Callers that come while it loads share the load; after a trap the next call makes a fresh
 * instance from the module that is already compiled.
 * @param {unknown} source  what to load: see `InitInput` in the types
 * @returns {Promise<void>}
 * @throws {PlanariumError} `init-failed`; a later call tries again
 */
export async function load(source) {
  if (instance > 0) return renew();
  loading ??= compile(source).then(start).finally(() => { loading = undefined; });
  return loading;
}

/**
 * Loads the core at once, from bytes or a compiled module.
 * @param {unknown} source
 * @throws {PlanariumError} `init-failed`
 */
export function loadSync(source) {
  if (instance > 0) return renew();
  const module = unwrap(source);
  const tag = tagOf(module);
  if (tag === "WebAssembly.Module") return start(/** @type {WebAssembly.Module} */ (module));
  if (!isBytes(module)) {
    throw new PlanariumError("init-failed", `initSync takes bytes or a WebAssembly.Module, not ${describe(module)}.`);
  }
  let compiled;
  try {
    compiled = new WebAssembly.Module(module);
  } catch (error) {
    throw failed("these bytes do not compile as WebAssembly", error);
  }
  start(compiled);
}

/** After a trap: a fresh instance. Otherwise nothing. */
function renew() {
  if (fault === undefined) return;
  try {
    glue.__wbg_reset_state();
  } catch (error) {
    throw failed("a fresh instance could not be made", error);
  }
  instance += 1;
  fault = undefined;
}

/**
 * Makes the first instance, unless `initSync` has made it meanwhile.
 * @param {WebAssembly.Module} module
 */
function start(module) {
  if (instance > 0) return;
  const exported = new Set(WebAssembly.Module.exports(module).map(({ name }) => name));
  if (!exported.has("__wbindgen_start") || !exported.has("rawscenario_parse")) {
    throw new PlanariumError("init-failed", "This WebAssembly module is not planarium_bg.wasm.");
  }
  try {
    glue.initSync({ module });
  } catch (error) {
    throw failed("this planarium_bg.wasm does not belong to this version of the package", error);
  }
  instance = 1;
}

/**
 * From whatever the caller has to a compiled module.
 * @param {unknown} source
 * @returns {Promise<WebAssembly.Module>}
 */
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
    throw new TypeError(`init takes a URL, a Request, a Response, bytes or a WebAssembly.Module, not ${describe(given)}`);
  } catch (error) {
    throw failed("the WebAssembly module could not be loaded", error);
  }
}

/** @param {Response} response */
async function compileResponse(response) {
  if (!response.ok) throw new Error(`${response.url} answered ${response.status} ${response.statusText}`.trimEnd());
  // Streaming wants the right MIME type; a server that sends another still serves the right bytes.
  const type = response.headers.get("content-type") ?? "";
  if (type.startsWith("application/wasm") && typeof WebAssembly.compileStreaming === "function") {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * Callers may wrap what they give in `{ module_or_path }` or `{ module }`, as wasm-bindgen's own glue asks for.
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
