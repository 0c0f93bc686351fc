/** Types of the JavaScript part. */

/**
 * What an iteration did: the phase it began in; `vertex` and `edge` if it added some; the kinds of its events
 * (`eventKinds`); and `done` if the run ended with it.
 */
export type PseudocodeMark = Phase | EventKind | "vertex" | "edge";

/** One option of a generator. */
export type OptionInfo = ParameterInfo;

/** A place in a file of `readWorld`: a line of text, from 1; a byte, from 0; or a part of the file by its name. */
export type FilePlace = { readonly line: number } | { readonly byte: number } | { readonly element: string };

/** Something with a URL that can be fetched: a `URL` or a `Request`. */
export type Fetchable = { readonly href: string } | { readonly url: string; readonly method: string };

/** A `Response`, as far as it matters here. */
export interface WasmResponse {
  /** Whether the server sent the file. */
  readonly ok: boolean;
  /** Reads the bytes. */
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** What `init` loads: a URL, a `Request`, a `Response`, the bytes, or a compiled `WebAssembly.Module`. */
export type InitInput = string | Fetchable | WasmResponse | InitSyncInput;

/**
 * What `initSync` loads: the bytes, or a compiled `WebAssembly.Module`, which is written as `object` here so that these
 * types serve programs without the DOM library, too.
 */
export type InitSyncInput = ArrayBuffer | ArrayBufferView | object;

/** The object that loaders of wasm-bindgen take; `init` takes it, too. */
export interface InitOptions {
  /** What to load. */
  module_or_path: InitInput | Promise<InitInput>;
}

/** The object that loaders of wasm-bindgen take; `initSync` takes it, too. */
export interface InitSyncOptions {
  /** What to load. */
  module: InitSyncInput;
}
