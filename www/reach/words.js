/** What the page says of the arm, in plain sentences. */
import { touchingSentence } from "../domain/names.js";
import { isNearlySingular } from "./jacobian.js";

/** @import { Bench } from "./bench.js" */

/** A number with a true minus. @param {number} value @param {number} [digits] */
export function num(value, digits = 2) {
  const text = value.toFixed(digits);
  return (/^-0(\.0*)?$/.test(text) ? text.slice(1) : text).replace("-", "\u2212");
}

/** @param {ArrayLike<number>} point */
export function pointText(point, digits = 2) { return `(${num(point[0], digits)}, ${num(point[1], digits)})`; }

/** What touches what, or nothing. @param {Bench} bench */
export function touchingText({ arm: { scenario, check } }) {
  return check.free ? "" : capital(`${touchingSentence(scenario, check)}.`);
}

/** The sentence over the stage. @param {Bench} bench @returns {{ text: string, isBad: boolean }} */
export function sentenceOf(bench) {
  const touching = touchingText(bench);
  if (bench.mode === "between") return betweenSentence(bench);
  const { pull, arm } = bench;
  if (pull?.isStuck) {
    return { text: `From this pose the tip comes no nearer to ${pointText(pull.wanted)} than ${num(pull.distance)} m; another pose would.`, isBad: touching !== "" };
  }
  if (pull && !pull.reached) {
    const where = `the nearest point that it reaches is ${pointText(pull.point)}, ${num(pull.distance)} m away`;
    return { text: `${pointText(pull.wanted)} is out of reach${bench.lock === null ? "" : " in this direction"}: ${where}.`, isBad: touching !== "" };
  }
  if (touching) return { text: touching, isBad: true };
  if (isNearlySingular(arm.ellipse)) return { text: singularText(bench), isBad: false };
  return { text: "Drag the ring at the tip and the arm follows; drag a link and its joint alone turns.", isBad: false };
}

/** @param {Bench} bench */
function singularText({ arm: { dimension, ellipse } }) {
  if (dimension === 1) return "One joint: the tip goes along a circle, and nowhere else.";
  return `Nearly singular: the links are almost in line, and across the flat ellipse the tip can hardly move (manipulability ${num(ellipse.manipulability, 3)} m\u00b2).`;
}

/** @param {Bench} bench */
function betweenSentence(bench) {
  const { way, arm } = bench;
  const touching = touchingText(bench);
  const long = way.turns.map((turn, i) => (Math.abs(turn) > Math.PI ? i : -1)).filter((i) => i >= 0);
  const how = long.length === 0 ? "Each joint turns the short way" : `${long.map((i) => arm.joints[i].name).join(" and ")} ${long.length > 1 ? "turn" : "turns"} the long way round`;
  const length = `${num(way.length)} rad in all`;
  if (way.hit === null) return { text: `${capital(how)}, ${length}: free along all of it, proven.`, isBad: false };
  if (way.hit === 0 && !arm.isFree(way.a)) return { text: `${capital(how)}, ${length}: A itself touches something. ${touching}`, isBad: true };
  return { text: `${capital(how)}, ${length}: ${way.hit < 0.005 ? "at once" : `after ${Math.round(100 * way.hit)} %`} it touches something. ${touching}`, isBad: touching !== "" };
}

/** @param {string} text */
export function capital(text) { return text && text[0].toUpperCase() + text.slice(1); }

/** The pose in words, for those who do not see it. @param {Bench} bench */
export function summaryOf(bench) {
  const { arm } = bench;
  const angles = [...arm.q].map((angle) => num(angle)).join(", ");
  const touching = touchingText(bench);
  return `${arm.dimension} ${arm.dimension === 1 ? "link" : "links"}, ${arm.document.world.obstacles.length} obstacles. Joints at ${angles} radians; the tip is at ${pointText(arm.tip)} metres. ${touching || "It touches nothing."}`;
}
