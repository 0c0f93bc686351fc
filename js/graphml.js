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

/**
 * The roadmap as a graph, directed where its edges are, of nodes `n0`, `n1`, ... with their coordinates `q0`, `q1`, ..., and edges
 * whose `weight` is their length in the metric.
 * @param {RoadmapDocument} roadmap
 * @param {ArrayLike<number>} lengths  of the edges
 * @param {boolean} isDirected
 * @returns {string}
 */
export function graphml(roadmap, lengths, isDirected) {
  const { vertices, edges, circles } = roadmap;
  const key = (/** @type {string} */ name, /** @type {string} */ of, /** @type {string} */ kind) =>
    `<key id="${name}" for="${of}" attr.name="${name}" attr.type="${kind}"/>`;
  const words = /** @type {const} */ (["scenario", "planner", "metric"]);
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<graphml xmlns="http://graphml.graphdrawing.org/xmlns">',
    ...words.map((name) => key(name, "graph", "string")),
    ...circles.map((_, i) => key(`q${i}`, "node", "double")),
    key("weight", "edge", "double"),
    `<graph id="roadmap" edgedefault="${isDirected ? "directed" : "undirected"}">`,
    ...words.map((name) => `<data key="${name}">${escaped(roadmap[name])}</data>`),
    ...vertices.map((q, i) => `<node id="n${i}">${q.map((x, k) => `<data key="q${k}">${x}</data>`).join("")}</node>`),
    ...edges.map(([a, b], i) => `<edge id="e${i}" source="n${a}" target="n${b}"><data key="weight">${lengths[i]}</data></edge>`),
    "</graph>",
    "</graphml>\n",
  ].join("\n");
}

/** Text as XML 1.0 may hold it: its marks escaped, characters that it cannot hold replaced. @param {string} text */
function escaped(text) {
  return text
    .replace(/[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]/g, "\ufffd")
    .replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;")
    // A reader would make a line feed of it.
    .replaceAll("\r", "&#13;");
}
