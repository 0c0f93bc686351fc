/**
 * The theme, light or dark: that of the system unless the reader chooses one, which is stored where the browser allows
 * it.
 */
import { byId } from "./dom.js";

/** The entry in which VitePress stores the theme, "auto", "dark" or "light": pages and documentation share it. */
const KEY = "vitepress-theme-appearance";

const DARK = "(prefers-color-scheme: dark)";

/** The theme that a document is shown in. @param {Document} shown */
export function themeOf({ documentElement, defaultView }) {
  return documentElement.dataset.theme ?? (defaultView?.matchMedia(DARK).matches ? "dark" : "light");
}

/**
 * Gives a page in a frame a theme. While it is being loaded it may not have an element yet: it is dressed once it has
 * loaded.
 * @param {Document} inside @param {string} theme
 */
export function dress(inside, theme) {
  if (inside.documentElement && themeOf(inside) !== theme) inside.getElementById("theme")?.click();
}

/** @param {() => void} onChange */
export function watchTheme(onChange) {
  const root = document.documentElement;
  const stored = storage();
  if (stored === "light" || stored === "dark") root.dataset.theme = stored;
  const button = byId("theme", HTMLButtonElement);
  const other = () => (themeOf(document) === "dark" ? "light" : "dark");
  const name = () => {
    button.ariaLabel = `Switch to ${other()} colours`;
  };
  const update = () => {
    name();
    onChange();
  };
  // A page that is dressed by the one around it stores nothing: that is not the reader's choice.
  button.addEventListener("click", ({ isTrusted }) => {
    root.dataset.theme = other();
    if (isTrusted) storage(root.dataset.theme);
    update();
  });
  matchMedia(DARK).addEventListener("change", update);
  name();
}

/** Stores a theme, or reads the stored one. @param {string} [theme] @returns {string | null} */
function storage(theme) {
  try {
    if (theme) localStorage.setItem(KEY, theme);
    return localStorage.getItem(KEY);
  } catch {
    return null; // without access to the storage
  }
}
