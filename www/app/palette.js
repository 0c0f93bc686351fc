/**
 * The colours of the stage, read from the custom properties of `style.css`. Each has one meaning.
 * A hidden element resolves them, so that the sheet decides between light and dark and the canvas gets a plain colour.
 */
const NAMES = /** @type {const} */ ([
  "stage", "ink", "quiet", "line", "obstacle", "obstacle-edge", "robot", "robot-edge", "start", "goal",
  "growth", "newest", "halo", "path", "unproven", "rejected", "collision",
]);

/** @typedef {Record<typeof NAMES[number], string>} Palette */

/** @param {HTMLElement} root @returns {Palette} */
export function readPalette(root) {
  const probe = document.createElement("span");
  probe.hidden = true;
  // Where colours are forced, an element's own text is; its meaning is not.
  probe.style.forcedColorAdjust = "none";
  root.append(probe);
  const colours = /** @type {Palette} */ ({});
  for (const name of NAMES) {
    probe.style.color = `var(--${name})`;
    colours[name] = getComputedStyle(probe).color;
  }
  probe.remove();
  return colours;
}
