/**
 * Handles single keys while the focus is within some elements, but not keys that press a focused button.
 * @param {HTMLElement[]} elements
 * @param {Record<string, () => void>} keys   by `event.key`, lower case
 */
export function watchKeys(elements, keys) {
  for (const element of elements) {
    element.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
      const target = event.target;
      const pressesButton = target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter");
      const action = keys[event.key.toLowerCase()];
      if (!action || pressesButton) return;
      event.preventDefault();
      action();
    });
  }
}
