/** In a frame that shows only the figure, Escape returns the focus to the parent, which gets `{ planarium: "escape" }`. */
export function watchEscape() {
  if (window.parent === window || !document.documentElement.classList.contains("embed")) return;
  addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    window.parent.focus();
    window.parent.postMessage({ planarium: "escape" }, "*");
  });
}
