/** QR codes as SVG: black on white in any theme, each module equally large, so that any of them can be read. */
import { encode } from "uqr";
import { makeSvg } from "./dom.js";

/** Modules of white around a code, as the standard asks. */
const BORDER = 4;
/** Millimetres of a module on paper: a phone reads it from a hand's length. */
const MODULE = 0.4;

/** @param {string} text @param {string} title @returns {SVGSVGElement} */
export function qrCode(text, title) {
  const { data, size } = encode(text, { ecc: "L", border: BORDER });
  const rows = data.flatMap((row, y) =>
    row.map((isBlack, x) => (isBlack && !row[x - 1] ? `M${x} ${y}h${runFrom(row, x)}v1H${x}z` : "")),
  );
  const side = `${(size * MODULE).toFixed(1)}mm`;
  return makeSvg(
    "svg",
    { viewBox: `0 0 ${size} ${size}`, width: side, height: side, role: "img", "aria-label": title },
    makeSvg("rect", { width: size, height: size, fill: "#fff" }),
    makeSvg("path", { d: rows.join(""), fill: "#000", "shape-rendering": "crispEdges" }),
  );
}

/** What paper says where a phone cannot open the codes of a page, or nothing. @param {URL | Location} page */
export function codeWarning({ protocol, hostname }) {
  const isHere = protocol === "file:" || /^(localhost|.+\.localhost|127\..+|\[::1\])$/.test(hostname);
  return isHere
    ? "This page was opened from this computer, so its codes do not work on a phone: print it from a web server."
    : "";
}

/** How many black modules follow one another. @param {boolean[]} row @param {number} from */
function runFrom(row, from) {
  const end = row.indexOf(false, from);
  return (end < 0 ? row.length : end) - from;
}
