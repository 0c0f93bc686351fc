/**
 * Single keys, heard only while the focus is within one of some elements, and never taken from a control that has its own
 * use for them.
 * @param {HTMLElement[]} elements
 * @param {Record<string, () => void>} keys   by `event.key`, lower case
 */
export function watchKeys(elements, keys) {
  for (const element of elements) {
    element.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
      const target = event.target;
      const pressesButton = target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter");
      const order = keys[event.key.toLowerCase()];
      if (!order || pressesButton) return;
      event.preventDefault();
      order();
    });
  }
}
