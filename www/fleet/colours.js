/**
 * The colours of robots: as many hues as there are robots, equally light, so that a number in the colour of the stage
 * is legible on each. With forced colours all robots have the same one. A number is on every robot: no robot is
 * identified by its colour alone.
 */
import { bytesOf } from "../draw/mask.js";

/** @import { Palette } from "../app/palette.js" */

/** The hue of the first robot, in degrees. */
const FIRST = 250;
const CHROMA = 0.135;
/** Lightness on a light stage and on a dark one. */
const LIGHT = 0.53;
const DARK = 0.78;

/** @param {number} count @param {Palette} palette @returns {string[]} */
export function robotColours(count, palette) {
  if (matchMedia("(forced-colors: active)").matches) return Array.from({ length: count }, () => palette.robot);
  const isDark = bytesOf(palette.stage)[0] < 128;
  return Array.from({ length: count }, (_, i) => rgbOf(isDark ? DARK : LIGHT, CHROMA, FIRST + (360 * i) / count));
}

/**
 * A colour of OKLCH (Ottosson 2020) in sRGB, which every drawing program reads.
 * @param {number} lightness
 * @param {number} chroma
 * @param {number} hue  degrees
 */
function rgbOf(lightness, chroma, hue) {
  const [a, b] = [chroma * Math.cos((hue * Math.PI) / 180), chroma * Math.sin((hue * Math.PI) / 180)];
  const [l, m, s] = [
    [0.3963377774, 0.2158037573],
    [-0.1055613458, -0.0638541728],
    [-0.0894841775, -1.291485548],
  ].map(([ka, kb]) => (lightness + ka * a + kb * b) ** 3);
  const linear = [
    [4.0767416621, -3.3077115913, 0.2309699292],
    [-1.2684380046, 2.6097574011, -0.3413193965],
    [-0.0041960863, -0.7034186147, 1.707614701],
  ].map(([kl, km, ks]) => Math.min(1, Math.max(0, kl * l + km * m + ks * s)));
  return `rgb(${linear.map((part) => Math.round(255 * (part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055))).join(", ")})`;
}
