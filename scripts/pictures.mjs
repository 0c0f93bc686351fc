/**
 * The pictures of docs/proof.md, drawn with numbers of the core: `node scripts/pictures.mjs` writes them into
 * docs/images.
 */
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { Scenario } from "planarium";
import { coloursOf } from "./gallery.mjs";
import { isMain, root } from "./run.mjs";

/** An arm of two links that turns past a disc, and a motion of it. */
const scenario = Scenario.parse({
  format: "planarium-scenario-1",
  name: "past-a-disc",
  world: { obstacles: [{ type: "disc", center: [1.1, 0.95], radius: 0.3 }] },
  robot: { type: "arm", base: [0, 0], links: [1, 0.8] },
  queries: [],
});
const LINKS = [1, 0.8];
const [FROM, TO] = [
  [0.2, 0],
  [1.5, -2.4],
];

/**
 * @typedef {{ low: number, high: number, clearance: number, bound: number }} Interval  fractions of the motion, metres
 */

/** The configuration at a fraction of the motion. @param {number} t */
const at = (t) => scenario.interpolate(FROM, TO, t);

/**
 * The farthest that a point of the arm travels on a fraction of the motion: the sum over links of their length times
 * the turn of their absolute angle.
 * @param {number} part
 */
function travel(part) {
  let [angle, sum] = [0, 0];
  LINKS.forEach((length, i) => {
    angle += TO[i] - FROM[i];
    sum += length * Math.abs(angle) * part;
  });
  return sum;
}

/** The clearance of the arm at a fraction of the motion, from the core. @param {number} t */
const clearanceAt = (t) => scenario.clearance(at(t))?.distance ?? Infinity;

/**
 * Halves an interval until the clearance in its middle exceeds the travel to its ends.
 * @param {number} low
 * @param {number} high
 * @returns {Interval[]}
 */
function halve(low, high) {
  const [clearance, bound] = [clearanceAt((low + high) / 2), travel((high - low) / 2)];
  return clearance > bound
    ? [{ low, high, clearance, bound }]
    : [...halve(low, (low + high) / 2), ...halve((low + high) / 2, high)];
}

/** @param {number} value */
const short = (value) => Number(value.toFixed(2));
/** @param {number} width @param {number} height @param {string} title @param {string} inside */
const svg = (width, height, title, inside) =>
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" font-family="system-ui, sans-serif" font-size="13"><title>${title}</title><style>${coloursOf()}</style><rect width="${width}" height="${height}" rx="8" fill="var(--stage)"/>${inside}</svg>\n`;
/** @param {readonly (readonly number[])[]} points */
const pathOf = (points) => points.map(([x, y], i) => `${i ? "L" : "M"}${short(x)} ${short(y)}`).join("");
/** @param {number} x @param {number} y @param {string} text @param {string} [more] */
const label = (x, y, text, more = "") =>
  `<text x="${short(x)}" y="${short(y)}" fill="var(--quiet)" ${more}>${text}</text>`;

/** The clearance along the motion, and the intervals on which it exceeds the travel. */
function clearancePicture() {
  const [width, height, left, top, bottom] = [720, 320, 56, 56, 276];
  const intervals = halve(0, 1);
  const most = Math.max(clearanceAt(0), clearanceAt(1));
  const x = (/** @type {number} */ t) => left + t * (width - left - 20);
  const y = (/** @type {number} */ metres) => bottom - (metres / most) * (bottom - top);
  const curve = Array.from({ length: 401 }, (_, i) => [x(i / 400), y(clearanceAt(i / 400))]);
  const bars = intervals.map(({ low, high, clearance, bound }) => {
    const middle = x((low + high) / 2);
    return `<rect x="${short(x(low))}" y="${short(y(bound))}" width="${short(x(high) - x(low))}" height="${short(bottom - y(bound))}" fill="var(--start)" fill-opacity="0.16" stroke="var(--start)"/><circle cx="${short(middle)}" cy="${short(y(clearance))}" r="3.2" fill="var(--path)"/>`;
  });
  const ticks = [0, 0.2, 0.4]
    .filter((metres) => metres < most)
    .map((metres) => label(left - 8, y(metres) + 4, `${metres} m`, 'text-anchor="end"'));
  return svg(
    width,
    height,
    "Clearance along a motion, and the intervals into which it is halved",
    `${bars.join("")}<path d="${pathOf(curve)}" fill="none" stroke="var(--path)" stroke-width="2"/><path d="M${left} ${bottom}H${width - 20}" stroke="var(--control)"/>${ticks.join("")}${label(left, bottom + 20, "start of the motion")}${label(width - 20, bottom + 20, "its end", 'text-anchor="end"')}` +
      `${label(left, 26, `${intervals.length} intervals; line: clearance; boxes: how far the arm can travel on one half of an interval`)}`,
  );
}

/** The arm at both ends of each interval, and the boxes around the two links over all of it. */
function sweptPicture() {
  const [width, height] = [720, 380];
  const view = { scale: 190, x: 170, y: 330 };
  const place = (/** @type {readonly number[]} */ [x, y]) => [view.x + view.scale * x, view.y - view.scale * y];
  const jointsAt = (/** @type {number} */ t) => {
    const q = at(t);
    let [x, y, angle] = [0, 0, 0];
    return [
      [0, 0],
      ...LINKS.map((length, i) => {
        angle += q[i];
        x += length * Math.cos(angle);
        y += length * Math.sin(angle);
        return [x, y];
      }),
    ];
  };
  const arm = (/** @type {number} */ t, /** @type {string} */ style) =>
    `<path d="${pathOf(jointsAt(t).map(place))}" fill="none" stroke-linecap="round" stroke-linejoin="round" ${style}/>`;
  const sweep = Array.from({ length: 25 }, (_, i) =>
    arm(i / 24, 'stroke="var(--growth)" stroke-width="1" stroke-opacity="0.35"'),
  );
  const boxes = LINKS.map((_, link) => {
    const points = Array.from({ length: 401 }, (_, i) =>
      jointsAt(i / 400)
        .slice(link, link + 2)
        .map(place),
    ).flat();
    const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
    const [low, high] = [
      [Math.min(...xs), Math.min(...ys)],
      [Math.max(...xs), Math.max(...ys)],
    ];
    return `<rect x="${short(low[0])}" y="${short(low[1])}" width="${short(high[0] - low[0])}" height="${short(high[1] - low[1])}" fill="none" stroke="var(--${link ? "goal" : "start"})" stroke-dasharray="6 4" stroke-width="1.4"/>`;
  });
  const t = halve(0, 1).reduce((least, interval) => (interval.clearance < least.clearance ? interval : least));
  const nearest = scenario.clearance(at((t.low + t.high) / 2));
  const [[x0, y0], [x1, y1]] = (nearest?.points ?? []).map(place);
  const disc = place([1.1, 0.95]);
  return svg(
    width,
    height,
    "An arm that passes a disc, and the boxes around what each link sweeps",
    `<circle cx="${short(disc[0])}" cy="${short(disc[1])}" r="${short(0.3 * view.scale)}" fill="var(--obstacle)" stroke="var(--obstacle-edge)"/>${sweep.join("")}${boxes.join("")}` +
      `${arm(0, 'stroke="var(--start)" stroke-width="5"')}${arm(1, 'stroke="var(--goal)" stroke-width="5"')}${arm((t.low + t.high) / 2, 'stroke="var(--ink)" stroke-width="3"')}` +
      `<path d="M${short(x0)} ${short(y0)}L${short(x1)} ${short(y1)}" stroke="var(--collision)" stroke-width="3"/>${label(x0 - 60, (y0 + y1) / 2 + 14, `${((nearest?.distance ?? 0) * 100).toFixed(1)} cm`, 'font-weight="600"')}` +
      ``,
  );
}

/** The pictures by their names. */
export const drawings = () => ({ "proof-clearance.svg": clearancePicture(), "proof-sweep.svg": sweptPicture() });

if (isMain(import.meta.url))
  for (const [name, text] of Object.entries(drawings())) writeFileSync(join(root, "docs", "images", name), text);
