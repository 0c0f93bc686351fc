/**
 * Plain data as the fragment of an address: a version digit and base64url of raw deflate (RFC 1951, RFC 4648) of JSON.
 */
import { ErrorInfo, must } from "./rules.js";

/**
 * @typedef {{ characters: number, bytes: number }} Limits   the fragment's characters without `#`, and the bytes of its
 *   JSON
 */

/**
 * @param {unknown} value  plain data
 * @param {Limits} limits
 * @returns {Promise<string>}  without `#`
 * @throws {ErrorInfo} it is too long
 */
export async function encodeFragment(value, { characters, bytes }) {
  const json = new TextEncoder().encode(JSON.stringify(value));
  must(json.length <= bytes, "it is too long");
  const deflated = await pump(json, new CompressionStream("deflate-raw"), Infinity);
  const binary = Array.from(deflated, (byte) => String.fromCharCode(byte)).join("");
  const fragment = `1${btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
  must(fragment.length <= characters, "it is too long");
  return fragment;
}

/**
 * @param {string} fragment  with or without `#`
 * @param {Limits} limits
 * @param {(value: unknown) => void} check  throws a fault
 * @returns {Promise<{ value: unknown, fault: "" } | { value: null, fault: string }>}  never rejects; `fault` is a
 *   sentence
 */
export async function decodeFragment(fragment, { characters, bytes }, check) {
  try {
    must(String(fragment).length <= characters + 1, "it is too long");
    const [, content] = /^#?1([\w-]+)$/.exec(fragment) ?? [];
    must(content, "it is not one of version 1");
    const binary = atob(content.replace(/-/g, "+").replace(/_/g, "/"));
    const json = await pump(
      Uint8Array.from(binary, (c) => c.charCodeAt(0)),
      new DecompressionStream("deflate-raw"),
      bytes,
    );
    const value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(json));
    check(value);
    return { value, fault: "" };
  } catch (error) {
    return {
      value: null,
      fault: error instanceof ErrorInfo ? error.message : "This link does not work: it is damaged.",
    };
  }
}

/**
 * Sends bytes through a transform, and stops reading beyond the limit.
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionStream | DecompressionStream} transform
 * @param {number} most
 */
async function pump(bytes, transform, most) {
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    parts.push(value);
    size += value.length;
    if (size > most) await reader.cancel();
    must(size <= most, "it is too long");
  }
}
