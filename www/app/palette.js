/**
 * The colours of the stage, from the custom properties of `style.css`. A hidden element resolves them, so that the style sheet decides
 * between light and dark.
 */
const NAMES = /** @type {const} */ ([
  "stage", "ink", "quiet", "line", "obstacle", "obstacleEdge", "robot", "robotEdge", "start", "goal",
  "growth", "newest", "halo", "path", "unproven", "rejected", "collision",
]);

/** @typedef {Record<typeof NAMES[number], string>} Palette */

/** @param {HTMLElement} root @returns {Palette} */
export function readPalette(root) {
  const probe = document.createElement("span");
  probe.hidden = true;
  // Forced colours would replace the colour of a text.
  probe.style.forcedColorAdjust = "none";
  root.append(probe);
  const colours = /** @type {Palette} */ ({});
  for (const name of NAMES) {
    probe.style.color = `var(--${name.replace("E", "-e")})`;
    colours[name] = getComputedStyle(probe).color;
  }
  probe.remove();
  return colours;
}
