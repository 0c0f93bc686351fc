/**
 * Makes an SVG small: lines lose the points that hardly bend them, paths have relative coordinates with one decimal,
 * and a shape that is filled and then outlined is one element.
 */

/** How far a line may move, pixels. */
const TOLERANCE = 0.4;

/** @typedef {[x: number, y: number]} Point */

/** A group that fills one path, and another that outlines the same path. */
const TWICE =
  /<g( clip-path="[^"]*")?( fill="(?!none)[^>]*)><path d="([^"]*)"\/><\/g><g\1 fill="none"([^>]*)><path d="\3"\/><\/g>/g;

/** @param {string} svg  with the absolute commands M, L, A and Z @returns {string} */
export function slim(svg) {
  return svg
    .replace(/ d="([^"]*)"/g, (_, path) => ` d="${slimPath(path)}"`)
    .replaceAll(">\n<", "><")
    .replace(TWICE, (_, clip = "", fill, path, stroke) => `<g${clip}${fill}${stroke}><path d="${path}"/></g>`);
}

/** @param {string} path */
function slimPath(path) {
  let text = "";
  /** Where the pen is, and where it was last put down, in tenths of a pixel. @type {Point} */
  let pen = [0, 0];
  let begun = pen;
  /** The line so far, from the pen. @type {Point[]} */
  let line = [];
  const put = (/** @type {string} */ command, /** @type {Point} */ [x, y]) => {
    const at = /** @type {Point} */ ([tenths(x), tenths(y)]);
    const [dx, dy] = [short(at[0] - pen[0]), short(at[1] - pen[1])];
    text += command === "" ? joined(dx) + joined(dy) : command + dx + joined(dy);
    pen = at;
  };
  const flush = () => {
    const kept = simplified(line).slice(1);
    let command = "l";
    for (const point of kept) {
      // A line of one point is a dot.
      if (tenths(point[0]) === pen[0] && tenths(point[1]) === pen[1] && kept.length > 1) continue;
      put(command, point);
      command = "";
    }
  };
  for (const [, command, numbers] of path.matchAll(/([MLAZ])([^MLAZ]*)/g)) {
    const values = numbers.trim().split(/[ ,]+/).map(Number);
    const end = /** @type {Point} */ (values.slice(-2));
    if (command === "L") {
      line.push(end);
      continue;
    }
    flush();
    line = command === "Z" ? [] : [end];
    if (command === "Z") {
      text += "z";
      pen = begun;
    } else if (command === "M") {
      put("m", end);
      begun = pen;
    } else {
      put(`a${short(tenths(values[0]))} ${short(tenths(values[1]))} 0 0 ${values[4]} `, end);
    }
  }
  flush();
  return text;
}

/** @param {number} value */
const tenths = (value) => Math.round(10 * value);

/** A number of tenths without a needless zero. @param {number} value */
const short = (value) => String(value / 10).replace(/^(-?)0\./, "$1.");

/** A number after another one: a minus sign separates by itself. @param {string} text */
const joined = (text) => (text.startsWith("-") ? text : ` ${text}`);

/**
 * A line without the points that are hardly off it (Ramer 1972, Douglas and Peucker 1973).
 * @param {Point[]} line
 * @returns {Point[]}
 */
function simplified(line) {
  if (line.length < 3) return line;
  const [first, last] = [line[0], line[line.length - 1]];
  const [dx, dy] = [last[0] - first[0], last[1] - first[1]];
  const length = Math.hypot(dx, dy);
  const off = line.map(([x, y]) =>
    length > 0 ? Math.abs((x - first[0]) * dy - (y - first[1]) * dx) / length : Math.hypot(x - first[0], y - first[1]),
  );
  const most = Math.max(...off);
  if (most < TOLERANCE) return [first, last];
  const at = off.indexOf(most);
  return [...simplified(line.slice(0, at + 1)).slice(0, -1), ...simplified(line.slice(at))];
}
