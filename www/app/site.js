/** What worlds need of the site: their style, and the module of formats, which a page in one file does not have. */
import { make } from "./dom.js";
import { once } from "./once.js";

/** Whether the page has the other files of the site beside it: it is not one file with everything in it. */
export const hasSite = () => document.getElementById("inline-core") === null;

/** @throws {Error} the page cannot read maps, pictures and drawings */
export function requireFormats() {
  if (hasSite()) return;
  const message =
    "A page in one file does not read maps, pictures, drawings and paths: open it on the site, or use planarium import and planarium verify.";
  throw Object.assign(new Error(message), { code: "unsupported" });
}

export const loadStyle = once(
  () =>
    new Promise((resolve, reject) => {
      const link = make("link", { rel: "stylesheet", href: "world.css", onload: resolve });
      link.onerror = () => reject(new Error("The style of this part could not be loaded."));
      document.head.append(link);
    }),
);
