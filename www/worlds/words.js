/** What was read, and why something was not, in sentences. */
import { counted, grouped } from "../app/dom.js";
import { capital } from "../widgets/format.js";

/** @import { Fault, Report } from "./types.js" */

/** The formats. @type {Record<import("./types.js").Report["format"], string>} */
const FORMATS = {
  "ros-map": "ROS map",
  "moving-ai": "MovingAI map",
  grid: "Grid",
  picture: "Picture",
  tpcap: "Parking case",
  "modern-robotics": "Obstacles of Modern Robotics",
  "ompl-grid": "Grid of OMPL",
  "ompl-circles": "Circles of OMPL",
  svg: "SVG drawing",
  dxf: "DXF drawing",
  geojson: "GeoJSON",
  wkt: "WKT",
  "rmf-building": "Building of Open-RMF",
};

/** The format of a world. @param {Pick<import("./types.js").Report, "format">} report */
export const formatName = ({ format }) => FORMATS[format];

/** With four digits at most. @param {number} value */
const short = (value) => String(Number(value.toPrecision(4)));

/** A size in metres. @param {number} width @param {number} height */
const size = (width, height) => `${short(width)} \u00d7 ${short(height)} m`;

/** What was read, a line each. @param {Report} report @returns {string[]} */
export function linesOf(report) {
  const { bounds, grid, obstacles, dropped, grown, offset, queries, notes } = report;
  const [[left, bottom], [right, top]] = bounds;
  const lines = [];
  if (grid) {
    lines.push(
      `${grouped(grid.width)} \u00d7 ${grouped(grid.height)} cells of ${short(grid.resolution)} m: ${size(right - left, top - bottom)}`,
      `${grouped(grid.free)} free, ${grouped(grid.occupied)} occupied, ${grouped(grid.unknown)} unknown cells`,
    );
  } else lines.push(size(right - left, top - bottom));
  const kinds = [
    obstacles.polygons > 0 || !obstacles.discs ? counted(obstacles.polygons, grid ? "rectangle" : "polygon") : "",
    obstacles.discs > 0 ? counted(obstacles.discs, "disc") : "",
    obstacles.walls ? counted(obstacles.walls, "wall") : "",
  ].filter(Boolean);
  lines.push(`Obstacles: ${kinds.join(", ")}`);
  for (const { what, count, cells } of dropped)
    lines.push(`Left out: ${grouped(count)} ${what}${cells ? ` of ${counted(cells, "cell")}` : ""}`);
  if (grown > 1e-5) lines.push(`Obstacles are larger than in the file, by at most ${short(grown)} m`);
  if (offset.some((value) => value !== 0))
    lines.push(`Moved: ${offset.map(short).join(", ")} is subtracted from the coordinates of the file`);
  if (queries.length > 0) lines.push(counted(queries.length, "query", "queries"));
  return [...lines, ...notes.map((note) => capital(note))];
}

/** Why files could not be read. @param {Fault} fault */
export function faultText({ message, file, place }) {
  const where = [file, placeText(place)].filter((part) => part && !message.includes(part)).join(", ");
  return `${capital(message).replace(/\.$/, "")}${where ? ` (${where})` : ""}.`;
}

/** @param {Fault["place"]} place */
function placeText(place) {
  if (!place) return "";
  const [[kind, value]] = Object.entries(place);
  return kind === "element" ? String(value) : `${kind} ${grouped(Number(value))}`;
}
