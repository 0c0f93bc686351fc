/**
 * The resources of the page: files beside it, or in a single-file page `<script type="text/plain" id="inline-NAME">`
 * elements, of which the large ones are gzip in base64.
 */

/** @param {string} name */
function inline(name) {
  return document.getElementById(`inline-${name}`)?.textContent ?? null;
}

/** What makes workers. @param {string} script  their address, unless it is inline @returns {Promise<() => Worker>} */
export async function workerMaker(script) {
  const packed = inline("worker");
  if (packed === null) return () => new Worker(script, { type: "module" });
  const url = URL.createObjectURL(new Blob([await unpacked(packed)], { type: "text/javascript" }));
  return () => new Worker(url);
}

/** The WebAssembly, compiled. @returns {Promise<WebAssembly.Module>} */
export async function loadCore() {
  const packed = inline("core");
  if (packed !== null) return WebAssembly.compile(await unpacked(packed));
  // The page is fetching it: the planner's the light one, the others all of it.
  const { href } = /** @type {HTMLLinkElement} */ (document.querySelector("link[type='application/wasm']"));
  const response = await fetch(href);
  if (!response.ok) throw new Error(`${response.url} returned ${response.status} ${response.statusText}`.trimEnd());
  // Streaming needs the right content type.
  if (response.headers.get("content-type")?.startsWith("application/wasm"))
    return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Documents of scenes that have been fetched. @type {Map<string, Promise<string>>} */
const scenes = new Map();

/** The text of a scene's document. @param {string} id @returns {Promise<string>} */
export function loadScene(id) {
  const known = scenes.get(id) ?? fetchScene(id);
  scenes.set(id, known);
  known.catch(() => scenes.delete(id));
  return known;
}

/** @param {string} id @returns {Promise<string>} */
async function fetchScene(id) {
  const text = inline(`scene-${id}`);
  if (text !== null) return text;
  const response = await fetch(`scenes/${id}.json`);
  if (!response.ok) throw new Error(`scenes/${id}.json: ${response.status} ${response.statusText}`);
  return response.text();
}

/** @param {string} packed @returns {Promise<ArrayBuffer>} */
async function unpacked(packed) {
  const bytes = Uint8Array.from(atob(packed.trim()), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
