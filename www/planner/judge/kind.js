/** Whether a file that is opened over a scene is a path, by its name and its beginning. */

/** @import { Content } from "../../app/read-files.js" */

/** Bytes that tell what a text is. */
const HEAD = 8192;
/** Columns of which a path has some, at the end of their names. */
const COLUMNS =
  /(^|[_. ])(x|y|theta|yaw|heading|lon|lat|longitude|latitude|joint_?\d+|q_?\d+)([_ ]?(m|cm|mm|deg|rad)|\s*[[(].*)?$/i;

/**
 * @param {number} dimension   of the robot
 * @param {Content} file   no array of NumPy
 * @returns {"path" | "maybe" | "other"}   "maybe": a path, or part of a world
 */
export function pathKind(dimension, { name, bytes }) {
  const head = new TextDecoder().decode(bytes.subarray(0, HEAD)).replace(/^\ufeff/, "");
  if (/\.geojson$/i.test(name) || /"type"\s*:\s*"(Feature(Collection)?|GeometryCollection)"/.test(head))
    return /"(LineString|Point)"/.test(head) && !/Polygon"/.test(head) ? "maybe" : "other";
  if (/^\s*\[\s*\[/.test(head)) return "path";
  if (/^\s*[{[]/.test(head)) return isPoses(head) ? "path" : "other";
  if (/^(- )*(header|frame_id|poses|pose|position):/m.test(head)) return "path";
  return tableKind(dimension, head);
}

/** Whether JSON has poses, or a path of no scenario. @param {string} head */
function isPoses(head) {
  if (/"format"\s*:/.test(head)) return false;
  return /"(poses|pose|position|columns)"\s*:/.test(head) || (/"path"\s*:/.test(head) && !/"scenario"\s*:/.test(head));
}

/**
 * Numbers in rows, with the names of columns above them or without.
 * @param {number} dimension
 * @param {string} head
 */
function tableKind(dimension, head) {
  const lines = head
    .split(/\r?\n/)
    .map((line) => line.trim())
    .filter((line) => line !== "" && !line.startsWith("#"));
  const rows = lines.slice(0, 3).map((line) => line.split(/\s*[,;\t]\s*|\s+/));
  const isNumeric = (/** @type {string[]} */ row) => row.every((cell) => cell !== "" && Number.isFinite(Number(cell)));
  const [first, second] = rows;
  if (!first) return "other";
  if (!isNumeric(first)) {
    const parts = lines[0].split(/\s*[,;\t]\s*/);
    const names = parts.length > 1 ? parts : first;
    return names.some((one) => COLUMNS.test(one.replace(/^"|"$/g, ""))) && second !== undefined ? "path" : "other";
  }
  const isWidth = first.length === dimension || first.length === dimension + 1;
  // One row is more likely a case of parking, or the first line of a map.
  return second && isNumeric(second) && second.length === first.length && isWidth ? "maybe" : "other";
}
