/**
 * Plain data as characters that an address may hold: base64url of raw deflate (RFC 1951, RFC 4648) of JSON.
 */
import { must } from "./rules.js";

/** @param {unknown} value  plain data @param {number} most  bytes of JSON @returns {Promise<string>} @throws {Error} in words, where it is more */
export async function packed(value, most) {
  const bytes = new TextEncoder().encode(JSON.stringify(value));
  must(bytes.length <= most, "it is too long");
  const deflated = await pump(bytes, new CompressionStream("deflate-raw"), Infinity);
  const binary = Array.from(deflated, (byte) => String.fromCharCode(byte)).join("");
  return btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

/** @param {string} text @param {number} most  bytes that it may unpack to @returns {Promise<unknown>} @throws {Error} where it is damaged or more */
export async function unpacked(text, most) {
  const binary = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
  const bytes = await pump(Uint8Array.from(binary, (c) => c.charCodeAt(0)), new DecompressionStream("deflate-raw"), most);
  return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
}

/**
 * Sends bytes through a transform, and stops reading beyond the limit.
 * @param {Uint8Array<ArrayBuffer>} bytes @param {CompressionStream | DecompressionStream} transform @param {number} most
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
