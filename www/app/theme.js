/** Light or dark: the system's choice until the reader makes one, which is remembered where storage may be used. */
import { byId } from "./dom.js";

const KEY = "planarium-theme";

/** @param {() => void} onChange  the colours are others now */
export function watchTheme(onChange) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;
  const kept = recall();
  if (kept) root.dataset.theme = kept;
  const button = byId("theme", HTMLButtonElement);
  const name = () => {
    const now = root.dataset.theme ?? (dark.matches ? "dark" : "light");
    button.setAttribute("aria-label", `Switch to ${now === "dark" ? "light" : "dark"} colours`);
    return now;
  };
  button.addEventListener("click", () => {
    root.dataset.theme = name() === "dark" ? "light" : "dark";
    remember(root.dataset.theme);
    name();
    onChange();
  });
  dark.addEventListener("change", () => {
    name();
    onChange();
  });
  name();
}

/** @returns {"light" | "dark" | null} */
function recall() {
  try {
    const kept = localStorage.getItem(KEY);
    return kept === "light" || kept === "dark" ? kept : null;
  } catch {
    return null; // storage is closed to this page: it forgets, nothing else
  }
}

/** @param {string} theme */
function remember(theme) {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // as above
  }
}
