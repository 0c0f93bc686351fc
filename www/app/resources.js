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

/** Documents that have been fetched. @type {Map<string, Promise<string>>} */
const documents = new Map();

/** The text of a scene's document. @param {string} id @returns {Promise<string>} */
export function loadScene(id) {
  return loadText(`scenes/${id}.json`);
}

/** The text of a document of the site. @param {string} path  from the page on @returns {Promise<string>} */
export function loadText(path) {
  const known = documents.get(path) ?? fetchText(path);
  documents.set(path, known);
  known.catch(() => documents.delete(path));
  return known;
}

/** @param {string} path @returns {Promise<string>} */
async function fetchText(path) {
  const text = inline(path);
  if (text !== null) return text;
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path}: ${response.status} ${response.statusText}`.trimEnd());
  return response.text();
}

/** The address of the planner's page: of its file beside this one, where each is a single file. */
export function plannerAddress() {
  return inline("core") === null ? "plan.html" : "planarium.html";
}

/** @param {string} packed @returns {Promise<ArrayBuffer>} */
async function unpacked(packed) {
  const bytes = Uint8Array.from(atob(packed.trim()), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
