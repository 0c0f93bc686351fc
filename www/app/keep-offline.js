/** Stores the page's files for use without a network, where the browser allows it. */
export function keepForLater() {
  if (location.protocol.startsWith("http")) navigator.serviceWorker?.register("offline.js").catch(() => {});
}
