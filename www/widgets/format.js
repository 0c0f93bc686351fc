/** Numbers as text. */
/** With a true minus, and no minus before zero. @param {number} value @param {number} [digits]  after the point */
export function num(value, digits = 2) {
  const text = value.toFixed(digits);
  return (/^-0(\.0*)?$/.test(text) ? text.slice(1) : text).replace("-", "\u2212");
}

/** A point or configuration. @param {ArrayLike<number>} values @param {number} [digits] */
export function tuple(values, digits = 2) {
  return `(${Array.from(values, (value) => num(value, digits)).join(", ")})`;
}

/** @param {string} text */
export function capital(text) {
  return text && text[0].toUpperCase() + text.slice(1);
}

/** A small number, in powers of ten where that is shorter. @param {number} value */
export function small(value) {
  if (value === 0 || value >= 0.001) return value === 0 ? "0" : num(value, 3);
  const [digits, exponent] = value.toExponential(1).split("e");
  return `${digits}\u00b710${superscript(Number(exponent))}`;
}

/** A time in words. @param {number} seconds */
export function duration(seconds) {
  return seconds < 1
    ? `${(1000 * seconds).toFixed(seconds < 0.01 ? 1 : 0)} ms`
    : `${seconds.toFixed(seconds < 10 ? 2 : 1)} s`;
}

/** A time of another one, for screen readers. @param {number} time @param {number} end  seconds */
export function secondsText(time, end) {
  return `${num(time, 1)} of ${num(end, 1)} seconds`;
}

/** The digits of an exponent. @param {number} exponent */
export function superscript(exponent) {
  return [...String(exponent)]
    .map((c) => (c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(c)]))
    .join("");
}

/** With six digits at most, and commas between thousands. @param {number} value */
export const numberText = (value) => value.toLocaleString("en", { maximumSignificantDigits: 6 });

/** A percentage: with one digit after the point below 10. @param {number} value */
export function percent(value) {
  return `${num(value, value < 10 ? 1 : 0)} %`;
}
