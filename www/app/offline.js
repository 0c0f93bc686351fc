/**
 * The service worker: it stores all files of the pages for use without a network, but the pictures of the gallery and the
 * documentation only when they are seen. With a network, files are fetched.
 */

/** The version of the build, and its files. */
const { VERSION, FILES } = /** @type {{ VERSION: string, FILES: string[] }} */ (/** @type {unknown} */ (globalThis));

/** @typedef {Event & { waitUntil(promise: Promise<unknown>): void }} ExtendableEvent */
/** @typedef {ExtendableEvent & { request: Request, respondWith(response: Promise<Response>): void }} FetchEvent */

const NAME = `planarium-${VERSION}`;
/** Pictures of the gallery, and the documentation. */
const SEEN = /\/gallery\/[^/]+\.svg$|\/docs\//;

addEventListener("install", (event) =>
  /** @type {ExtendableEvent} */ (event).waitUntil(caches.open(NAME).then((cache) => cache.addAll(FILES))),
);

addEventListener("activate", (event) =>
  /** @type {ExtendableEvent} */ (event).waitUntil(
    caches
      .keys()
      .then((names) =>
        Promise.all(
          names.filter((name) => name.startsWith("planarium-") && name !== NAME).map((name) => caches.delete(name)),
        ),
      ),
  ),
);

addEventListener("fetch", (event) => {
  const { request, respondWith } = /** @type {FetchEvent} */ (event);
  if (request.method !== "GET" || new URL(request.url).origin !== location.origin) return;
  const fetched = fetch(request).then((response) => {
    if (response.ok && SEEN.test(request.url)) {
      const copy = response.clone();
      // Where there is no room, it is shown all the same.
      /** @type {ExtendableEvent} */ (event).waitUntil(
        caches
          .open(NAME)
          .then((cache) => cache.put(request, copy))
          .catch(() => {}),
      );
    }
    return response;
  });
  respondWith.call(
    event,
    fetched.catch(async (error) => {
      const stored = await caches.match(request, { ignoreSearch: true });
      if (stored) return stored;
      throw error;
    }),
  );
});
