/** What an image has below its figures: what was run, what came of it, and the legend. */
import { makeSvg } from "../app/dom.js";
import { plainText } from "../formats/svg.js";
import { bytesOf } from "./mask.js";

/** @import { Palette } from "../app/palette.js" */

const FAMILY = "system-ui, sans-serif";
/** CSS pixels: the letters, a line, the room around, between entries, and between a sign and its words. */
const FONT = 13;
const LINE = 20;
const SPACE = 16;
const APART = 18;
const GAP = 6;

/**
 * @param {number} width  CSS pixels
 * @param {{ head: string, sentence: string, legend: Element, palette: Palette }} content
 * @returns {SVGSVGElement}
 */
export function footOf(width, { head, sentence, legend, palette }) {
  /** @type {SVGElement[]} */
  const elements = [];
  let x = SPACE;
  let line = 0;
  /** Where something as wide goes: after what is before it, or in the next line. @param {number} wide @param {number} apart */
  const place = (wide, apart) => {
    if (x > SPACE && x + wide > width - SPACE) nextLine();
    const left = x;
    x += wide + apart;
    return left;
  };
  const nextLine = () => {
    x = SPACE;
    line++;
  };
  const middle = () => LINE * (line + 0.5);
  /** @param {string} text @param {number} left @param {Record<string, string | number>} more */
  const write = (text, left, more) =>
    elements.push(makeSvg("text", { x: left, y: middle() + 0.35 * FONT, ...more }, plainText(text)));

  for (const [text, fill, weight] of /** @type {const} */ ([
    [head, palette.ink, 600],
    [sentence, palette.quiet, 400],
  ])) {
    for (const words of linesOf(text, width - 2 * SPACE, rulerOf(FONT, weight))) {
      write(words, SPACE, { fill, "font-weight": weight });
      nextLine();
    }
  }
  const ruler = rulerOf(FONT);
  const isShown = (/** @type {Node} */ node) => !(node instanceof Element) || node.checkVisibility();
  for (const entry of [...legend.children].filter(isShown)) {
    const signs = [...entry.getElementsByTagName("svg")].filter(isShown);
    const widths = signs.map(({ viewBox: { baseVal } }) => (baseVal.width / baseVal.height) * 16 + GAP);
    const parts = [...entry.childNodes].filter((node) => !(node instanceof SVGElement) && isShown(node));
    const text = parts
      .map(({ textContent }) => textContent)
      .join("")
      .trim();
    const wide = widths.reduce((sum, one) => sum + one, 0) + ruler.measureText(text).width;
    let left = place(wide, APART);
    for (const [i, sign] of signs.entries()) {
      elements.push(alone(sign, { x: left, y: middle() - 8, width: widths[i] - GAP, height: 16 }));
      left += widths[i];
    }
    write(text, left, { fill: palette.quiet });
  }
  return makeSvg(
    "svg",
    {
      width,
      height: LINE * (x > SPACE ? line + 1 : line) + SPACE,
      "font-size": FONT,
      "font-family": FAMILY,
    },
    ...elements,
  );
}

/** What measures texts. @param {number} size  CSS pixels @param {number} [weight] */
export function rulerOf(size, weight = 400) {
  const ruler = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(1, 1).getContext("2d"));
  ruler.font = `${weight} ${size}px ${FAMILY}`;
  return ruler;
}

/**
 * A text in lines of a width. Words of a line are one text, which can be marked and copied; one that is longer than a
 * line is broken.
 * @param {string} text
 * @param {number} width
 * @param {OffscreenCanvasRenderingContext2D} ruler
 */
export function linesOf(text, width, ruler) {
  const isLonger = (/** @type {string} */ words) => ruler.measureText(words).width > width;
  /** @type {string[]} */
  const lines = [];
  let line = "";
  for (const word of text.split(/\s+/).filter(Boolean)) {
    if (line && isLonger(`${line} ${word}`)) {
      lines.push(line);
      line = "";
    }
    line = line ? `${line} ${word}` : word;
    while (isLonger(line)) {
      let letters = [...line].length - 1;
      while (letters > 1 && isLonger([...line].slice(0, letters).join(""))) letters--;
      lines.push([...line].slice(0, letters).join(""));
      line = [...line].slice(letters).join("");
    }
  }
  return line ? [...lines, line] : lines;
}

/** A copy of a sign that has the colours of the page without its style. @param {SVGSVGElement} sign @param {Record<string, number>} box */
function alone(sign, box) {
  const copy = /** @type {SVGSVGElement} */ (sign.cloneNode(true));
  const copies = copy.querySelectorAll("*");
  for (const [i, element] of sign.querySelectorAll("*").entries()) {
    const style = getComputedStyle(element);
    for (const name of ["fill", "stroke", "stroke-width", "stroke-dasharray"]) {
      const value = style.getPropertyValue(name);
      // Mixed colours are known to browsers alone.
      copies[i].setAttribute(name, value.startsWith("ok") ? `rgb(${bytesOf(value).join(", ")})` : value);
    }
  }
  for (const [name, value] of Object.entries(box)) copy.setAttribute(name, String(value));
  copy.removeAttribute("aria-hidden");
  return copy;
}
