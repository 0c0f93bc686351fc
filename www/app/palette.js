/**
 * The colours of the stage, from the custom properties of `style.css`. A hidden element resolves them, so that the
 * style sheet decides between light and dark.
 */
const NAMES = /** @type {const} */ ([
  "stage",
  "ink",
  "quiet",
  "line",
  "obstacle",
  "obstacleEdge",
  "robot",
  "robotEdge",
  "start",
  "goal",
  "growth",
  "newest",
  "halo",
  "path",
  "unproven",
  "rejected",
  "collision",
]);

/** @typedef {Record<typeof NAMES[number], string>} Palette */

/** The colours as custom properties, for files whose own style has their values. */
export const PROPERTIES = /** @type {Palette} */ (
  Object.fromEntries(NAMES.map((name) => [name, `var(--${name.replace("E", "-e")})`]))
);

/** The colours of the series of a chart, in their order. */
export const SERIES = /** @type {const} */ ([
  "start",
  "path",
  "goal",
  "unproven",
  "rejected",
  "growth",
  "newest",
  "collision",
]);

/** @param {HTMLElement} root @returns {Palette} */
export function readPalette(root) {
  const probes = NAMES.map((name) => {
    const probe = document.createElement("span");
    probe.style.color = PROPERTIES[name];
    // Forced colours replace the colour of text, but not what it means here.
    probe.style.forcedColorAdjust = "none";
    return probe;
  });
  const host = document.createElement("span");
  host.hidden = true;
  host.append(...probes);
  root.append(host);
  // Styles are computed once for all of them.
  const palette = /** @type {Palette} */ (
    Object.fromEntries(probes.map((probe, i) => [NAMES[i], getComputedStyle(probe).color]))
  );
  host.remove();
  return palette;
}
