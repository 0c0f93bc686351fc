/** The neighbours as a table, nearest first, and the result in a sentence. */
import { byId, grouped, make, write } from "../app/dom.js";
import { num, tuple } from "../widgets/format.js";
import { FEW } from "./session.js";

/** @import { NeighbourSession } from "./session.js" */

/** Rows of the table, at most. */
const MOST = 100;
/** Digits of coordinates and distances. */
export const DIGITS = 3;

/** Shows the neighbours in the table. @param {NeighbourSession} session */
export function showNeighbours(session) {
  const { indices, distances } = session.found;
  const shown = indices.slice(0, MOST);
  const {
    caption,
    tBodies: [body],
  } = byId("neighbours", HTMLTableElement);
  if (caption)
    write(
      caption,
      shown.length < indices.length ? `The ${MOST} nearest of ${indices.length}` : `The ${indices.length} nearest`,
    );
  body.replaceChildren(
    ...Array.from(shown, (i, rank) => {
      const isRight = session.exact.has(i);
      const cells = [
        grouped(i),
        tuple(session.row(i), DIGITS),
        `${num(distances[rank], DIGITS)}${isRight ? "" : " \u2717"}`,
      ];
      const dataset = { index: i, distance: distances[rank], right: isRight };
      return make(
        "tr",
        { dataset },
        make("th", { scope: "row" }, String(rank + 1)),
        ...cells.map((text) => make("td", {}, text)),
      );
    }),
  );
}

/** @param {NeighbourSession} session */
export function sentenceOf({ found, index, cut, isArm, count, missed, k, isAsking, sampling, file }) {
  if (count === 0) return "There are no configurations.";
  if (!isAsking) {
    const what = `${grouped(count)} ${sampling.free && file === null ? "collision-free " : ""}${count === 1 ? "configuration" : "configurations"}`;
    return `${what}${file === null ? `, sampled uniformly with seed ${sampling.seed}` : ` from ${file}`}${count <= FEW ? `; ${count === 1 ? "the" : "each"} ${isArm ? "tip" : "reference point"} is marked` : ""}.`;
  }
  const asked = Math.min(k, count);
  const wrong = missed.length;
  if (cut !== null) {
    const at = cut === 0 ? "0" : "\u03c0";
    const plain = `${cut === 0 ? "The naive metric" : "This kd-tree"} treats angles as plain numbers from ${cut === 0 ? "0 to 2\u03c0" : "\u2212\u03c0 to \u03c0"}, so it cuts each circle at ${at}.`;
    return wrong === 0
      ? `${plain} Here it happens to be right. Move ${isArm ? "a joint" : "the angle"} near ${at} to see it fail.`
      : `${plain} Of its ${asked} neighbours ${wrong} ${wrong === 1 ? "is" : "are"} wrong: it misses nearer ones beyond the cut.`;
  }
  const visited = `visited ${grouped(found.visited)} of ${grouped(count)} configurations`;
  if (index === "forest") {
    return wrong === 0
      ? `The forest ${visited} and found all ${asked} nearest. With more configurations or fewer candidates it misses some.`
      : `The forest ${visited} and missed ${wrong} of the ${asked} nearest (dashed).`;
  }
  if (index === "linear")
    return `The linear scan visited all ${grouped(count)} configurations to find the ${asked} nearest.`;
  return `The kd-tree ${visited} to find the ${asked} nearest.${isArm && index === "kd-tree" ? " Angles wrap, so a neighbour may lie across the border." : ""}`;
}
