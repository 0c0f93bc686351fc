/**
 * A kept roadmap for other programs: GraphML (Brandes, Eiglsperger, Lerner and Pich 2013, "Graph markup language"), which
 * networkx, igraph, Gephi and yEd read.
 */

/**
 * What a kept roadmap says in its JSON form, as far as it matters here.
 * @typedef {object} RoadmapDocument
 * @property {string} scenario
 * @property {string} planner
 * @property {string} metric
 * @property {boolean[]} circles
 * @property {number[][]} vertices
 * @property {[number, number][]} edges
 */

/** A full turn. */
const TURN = 2 * Math.PI;

/** How the metric of placements (x, y, theta) is named, with its two weights. */
const PLACEMENT = /^(\S+) translation \+ (\S+) rotation$/;

/** How the lengths of a steered car's curves are named. */
const CURVES = /^(dubins|reeds-shepp) of radius /;

/**
 * The roadmap as a graph, directed where its edges are, of nodes `n0`, `n1`, ... with their coordinates `q0`, `q1`, ..., and edges
 * whose `weight` is their length in the metric; of curves, which are not measured here, there is no weight.
 * @param {RoadmapDocument} roadmap
 * @returns {string}
 */
export function graphml(roadmap) {
  const { vertices, edges, circles, metric } = roadmap;
  const [, curves] = CURVES.exec(metric) ?? [];
  const key = (/** @type {string} */ name, /** @type {string} */ of, /** @type {string} */ kind) =>
    `<key id="${name}" for="${of}" attr.name="${name}" attr.type="${kind}"/>`;
  const words = /** @type {const} */ (["scenario", "planner", "metric"]);
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<graphml xmlns="http://graphml.graphdrawing.org/xmlns">',
    ...words.map((name) => key(name, "graph", "string")),
    ...circles.map((_, i) => key(`q${i}`, "node", "double")),
    ...(curves ? [] : [key("weight", "edge", "double")]),
    `<graph id="roadmap" edgedefault="${curves === "dubins" ? "directed" : "undirected"}">`,
    ...words.map((name) => `<data key="${name}">${escaped(roadmap[name])}</data>`),
    ...vertices.map((q, i) => `<node id="n${i}">${q.map((x, k) => `<data key="q${k}">${x}</data>`).join("")}</node>`),
    ...edges.map(([a, b], i) => {
      const weight = curves ? "" : `<data key="weight">${length(vertices[a], vertices[b], roadmap)}</data>`;
      return `<edge id="e${i}" source="n${a}" target="n${b}">${weight}</edge>`;
    }),
    "</graph>",
    "</graphml>\n",
  ].join("\n");
}

/**
 * The length of an edge in the metric, to the bit that of the core.
 * @param {number[]} a
 * @param {number[]} b
 * @param {RoadmapDocument} roadmap
 */
function length(a, b, { circles, metric }) {
  const gaps = circles.map((isCircle, i) => {
    const gap = Math.abs(a[i] - b[i]);
    return isCircle && gap > Math.PI ? TURN - gap : gap;
  });
  const [, translation, rotation] = PLACEMENT.exec(metric) ?? [];
  if (rotation !== undefined) return Number(translation) * Math.sqrt(gaps[0] * gaps[0] + gaps[1] * gaps[1]) + Number(rotation) * gaps[2];
  let sum = 0;
  for (const gap of gaps) sum += metric === "sum" ? gap : gap * gap;
  return metric === "sum" ? sum : Math.sqrt(sum);
}

/** Text as XML 1.0 may hold it: its marks escaped, characters that it cannot hold replaced. @param {string} text */
function escaped(text) {
  return text
    .replace(/[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]/g, "\ufffd")
    .replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;")
    // A reader would make a line feed of it.
    .replaceAll("\r", "&#13;");
}
