/**
 * The service worker of the served page: it keeps all of the page's files, so that the page opens and works without a network.
 * Where there is one, files come from it, as they are there now.
 */

/** Names the files that were built together, and lists them. */
const { VERSION, FILES } = /** @type {{ VERSION: string, FILES: string[] }} */ (/** @type {unknown} */ (globalThis));

/** @typedef {Event & { waitUntil(promise: Promise<unknown>): void }} Lasting */
/** @typedef {Lasting & { request: Request, respondWith(response: Promise<Response>): void }} Asking */

const NAME = `planarium-${VERSION}`;

addEventListener("install", (event) => /** @type {Lasting} */ (event).waitUntil(caches.open(NAME).then((cache) => cache.addAll(FILES))));

addEventListener("activate", (event) => /** @type {Lasting} */ (event).waitUntil(
  caches.keys().then((names) => Promise.all(names.filter((name) => name.startsWith("planarium-") && name !== NAME).map((name) => caches.delete(name)))),
));

addEventListener("fetch", (event) => {
  const { request, respondWith } = /** @type {Asking} */ (event);
  if (request.method !== "GET" || new URL(request.url).origin !== location.origin) return;
  respondWith.call(event, fetch(request).catch(async (error) => {
    const kept = await caches.match(request, { ignoreSearch: true });
    if (kept) return kept;
    throw error;
  }));
});
