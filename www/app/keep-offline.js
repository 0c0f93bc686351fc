/** Has the page's files kept, so that it opens without a network too; a page that may not keep anything does without. */
export function keepForLater() {
  if (location.protocol.startsWith("http")) navigator.serviceWorker?.register("offline.js").catch(() => {});
}
