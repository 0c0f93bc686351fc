/**
 * `planarium/shortest` for browsers, workers and bundlers: shortest paths among the obstacles of a map, GeoJSON in and
 * out. It has a WebAssembly module of its own, `shortest_bg.wasm`, which `await init()` fetches from beside this file.
 */
import { ShortestMap } from "./shortest_glue.js";
import { PlanariumError } from "./error.js";
import { fieldsOf, kindOf, readable } from "./plain.js";
import { asOwn, currentInstance, isSound, load, loadSync, requireCore } from "./runtime.js";

export { PlanariumError } from "./error.js";

/** @import { InitInput, InitOptions, InitSyncInput, InitSyncOptions } from "./core.js" */

/**
 * A position: longitude and latitude in degrees, or x and y in metres; further numbers are left out.
 * @typedef {readonly number[]} Position
 */

/** @typedef {{ readonly type: "Point", readonly coordinates: Position }} Point */

/**
 * A geometry of GeoJSON (RFC 7946): areas, lines that are not crossed, and points.
 * @typedef {Point
 *   | { readonly type: "MultiPoint" | "LineString", readonly coordinates: readonly Position[] }
 *   | { readonly type: "MultiLineString" | "Polygon", readonly coordinates: readonly (readonly Position[])[] }
 *   | { readonly type: "MultiPolygon", readonly coordinates: readonly (readonly (readonly Position[])[])[] }
 *   | { readonly type: "GeometryCollection", readonly geometries: readonly Geometry[] }} Geometry
 */

/** @typedef {{ readonly type: "Feature", readonly geometry: Geometry | null }} Feature */

/**
 * What paths go around: a geometry, a feature or a collection of them.
 * @typedef {Geometry | Feature | { readonly type: "FeatureCollection", readonly features: readonly Feature[] }} Obstacles
 */

/**
 * A start or a goal: a position, a point, or a feature of a point.
 * @typedef {Position | Point | { readonly type: "Feature", readonly geometry: Point }} Place
 */

/**
 * How obstacles are prepared.
 * @typedef {object} PrepareOptions
 * @property {number} [minDistance]  what paths keep from all obstacles, in metres, from 0 to 1e6. Default: 0
 * @property {readonly [number, number, number, number]} [bounds]  the area that paths stay in, `minDistance` from its
 *   border too: west, south, east, north, as `bbox` of GeoJSON. Default: no limit
 * @property {"degrees" | "metres"} [coordinates]  whether positions are longitude and latitude (RFC 7946), or x and y of
 *   a plane, at most 1e8 m from its origin. Default: degrees
 */

/**
 * Options of `prepare` alone.
 * @typedef {object} ManyQueries
 * @property {boolean} [manyQueries]  whether all tangents between obstacles are found beforehand. Preparation then takes
 *   up to about twelve times as long; the longest queries take a fifth to a thirtieth of the time on large maps, short
 *   ones may take longer. A map that is too large and too open stays as it is; then `tangents` of what is prepared is
 *   null. Default: false
 */

/**
 * What a path goes around.
 * @typedef {object} WithObstacles
 * @property {Obstacles} [obstacles]  at most 1,000,000 positions. Default: none
 */

/** @typedef {PrepareOptions & WithObstacles} ShortestPathOptions */

/**
 * A shortest path as a feature of GeoJSON.
 * @typedef {object} ShortestPathFeature
 * @property {"Feature"} type  that of GeoJSON
 * @property {ShortestPathProperties} properties  its length, and how exact the plane is
 * @property {{ type: "LineString", coordinates: [number, number][] }} geometry  from the start to the goal; arcs around
 *   corners are chords of at most 0.05 radians
 */

/**
 * What is known of a path.
 * @typedef {object} ShortestPathProperties
 * @property {number} length  in metres; of degrees, that of the line on the ellipsoid WGS 84. Arcs count as arcs
 * @property {number} distortion  the most that the plane in which the path is the shortest distorts distances, as a part
 *   of them: 0.01 is a hundredth. 0 for coordinates in metres
 */

/** The kinds of parts, as the core numbers them. */
const POINTS = 0,
  LINE = 1,
  OUTLINE = 2,
  HOLE = 3;

/** The most positions that are read. */
const MOST = 1_000_000;

/** How deep collections may lie in each other. */
const DEEPEST = 32;

/** The options of `prepare`, and those of `shortestPath`. */
const OPTIONS = "minDistance, bounds, coordinates";
const OF_PREPARE = `${OPTIONS}, manyQueries`;
const OF_PATH = `obstacles, ${OPTIONS}`;

/** What may make a `ShortestPaths`. */
const KEY = Symbol("prepare");

/**
 * Loads the module. Call it once before anything else; concurrent and later calls share the first load. In Node it is
 * loaded on import, and this resolves at once. After an error with the code `internal`, `init` makes a fresh one.
 * @param {InitInput | Promise<InitInput> | InitOptions} [input]  `shortest_bg.wasm`; by default the file beside this one
 * @returns {Promise<void>}
 * @throws {PlanariumError} rejects with the code `no-simd` or `init-failed`; the next call tries again
 */
export default async function init(input) {
  await load(input ?? new URL("./shortest_bg.wasm", import.meta.url));
}

/**
 * Loads the module synchronously, from bytes or a compiled module.
 * @param {InitSyncInput | InitSyncOptions} module
 * @returns {void}
 * @throws {PlanariumError} `no-simd`, `init-failed`
 */
export function initSync(module) {
  loadSync(module);
}

/**
 * The shortest path between two positions among obstacles. For several queries among the same ones, `prepare` them once.
 * @param {Place} start
 * @param {Place} goal
 * @param {ShortestPathOptions | null} [options]
 * @returns {ShortestPathFeature | null}  null if there is no path
 * @throws {PlanariumError} those of `prepare` and of `query`
 */
export function shortestPath(start, goal, options) {
  const { obstacles, ...others } = optionsOf(options, OF_PATH);
  const ends = endsOf(start, goal, isPlanar(others));
  const paths = prepared(obstacles ?? { type: "GeometryCollection", geometries: [] }, others);
  try {
    return paths.query(ends[0], ends[1]);
  } finally {
    paths.free();
  }
}

/**
 * Prepares obstacles for any number of queries: areas, lines that are not crossed, and points, of which paths keep
 * `minDistance`. The inside of a hole is free; areas may overlap. Features without a geometry and geometries without a
 * position are left out; rings that are not closed are closed.
 * @param {Obstacles} obstacles  at most 1,000,000 positions
 * @param {(PrepareOptions & ManyQueries) | null} [options]
 * @returns {ShortestPaths}  to be freed by `free()` or `using`
 * @throws {PlanariumError} `wrong-type`, `missing-field`, `unknown-type`, `wrong-dimension` for a position of fewer than
 *   two numbers, `not-finite`, `out-of-range`, `too-large`; `degenerate-polygon` for a ring that crosses itself or has no
 *   area and for a hole that is not in its outline, `degenerate-wall` for a line without two different positions, with
 *   the pointer of the ring or the line; `unknown-field` for an option; `not-initialised`
 */
export function prepare(obstacles, options) {
  return prepared(obstacles, optionsOf(options, OF_PREPARE));
}

/** Obstacles that are prepared for shortest paths; `prepare` makes it. */
export class ShortestPaths {
  /** @type {ShortestMap | undefined} */
  #map;
  #instance = currentInstance();
  #planar;

  /**
   * @param {symbol} key
   * @param {ShortestMap} map
   * @param {boolean} planar
   * @private
   */
  constructor(key, map, planar) {
    if (key !== KEY)
      throw new PlanariumError(
        "illegal-constructor",
        "A ShortestPaths is made by prepare(obstacles, options), not by `new`.",
      );
    this.#map = map;
    this.#planar = planar;
  }

  /**
   * The number of tangents that are known beforehand; null if each query looks for its own.
   * @returns {number | null}
   * @throws {PlanariumError} `freed`, `not-initialised`
   */
  get tangents() {
    requireOwn(this, "tangents");
    const map = this.#usable();
    return called(() => map.tangents) ?? null;
  }

  /**
   * The shortest path between two positions.
   * @param {Place} start
   * @param {Place} goal
   * @returns {ShortestPathFeature | null}  null if there is no path
   * @throws {PlanariumError} `start-in-collision`, `goal-in-collision` for a position in an obstacle, nearer to one than
   *   `minDistance`, or out of bounds; `wrong-type`, `missing-field`, `unknown-type`, `wrong-dimension`, `not-finite`,
   *   `out-of-range` for what is no position, or lies where the plane of the map would distort distances by more than a
   *   tenth; `freed`
   */
  query(start, goal) {
    requireOwn(this, "query");
    const map = this.#usable();
    const [from, to] = endsOf(start, goal, this.#planar);
    const numbers = called(() => map.query(from[0], from[1], to[0], to[1]));
    if (numbers.length === 0) return null;
    /** @type {[number, number][]} */
    const coordinates = [];
    for (let i = 2; i < numbers.length; i += 2) coordinates.push([numbers[i], numbers[i + 1]]);
    const properties = { length: numbers[0], distortion: numbers[1] };
    return { type: "Feature", properties, geometry: { type: "LineString", coordinates } };
  }

  /** The map, if it has not been freed. @returns {ShortestMap} */
  #usable() {
    requireCore();
    const map = this.#map;
    if (map === undefined) throw new PlanariumError("freed", "This ShortestPaths has been freed.");
    if (this.#instance !== currentInstance())
      throw new PlanariumError(
        "freed",
        "This ShortestPaths was lost when the core stopped; prepare the obstacles again.",
      );
    return map;
  }

  /** Gives the memory back; later calls throw `freed`. @returns {void} */
  free() {
    requireOwn(this, "free");
    const map = this.#map;
    this.#map = undefined;
    if (map !== undefined && isSound() && this.#instance === currentInstance()) called(() => map.free());
  }

  /** The same, at the end of the block of a `using`. @returns {void} */
  [Symbol.dispose]() {
    this.free();
  }

  /** A proxy is no handle: Vue makes none of an object with this property. @returns {boolean} @internal */
  get __v_skip() {
    return true;
  }

  /** @param {ShortestMap} map @param {boolean} planar @returns {ShortestPaths} @internal */
  static of(map, planar) {
    return new ShortestPaths(KEY, map, planar);
  }

  /** @param {unknown} value @returns {boolean} @internal */
  static isOne(value) {
    return typeof value === "object" && value !== null && #map in value;
  }
}

/** Refuses a receiver that is no `ShortestPaths`. @param {unknown} self @param {string} method */
function requireOwn(self, method) {
  if (ShortestPaths.isOne(self)) return;
  const given = self === undefined || self === null ? String(self) : `a value of type ${typeof self}`;
  throw new PlanariumError("illegal-invocation", `${method} belongs to a ShortestPaths, and was called on ${given}.`);
}

/**
 * @param {unknown} obstacles
 * @param {Record<string, unknown>} options
 */
function prepared(obstacles, options) {
  requireCore();
  const planar = isPlanar(options);
  const { minDistance = 0, bounds, manyQueries = false } = options;
  requireNumber(minDistance, "minDistance", "/minDistance");
  if (typeof manyQueries !== "boolean")
    throw new PlanariumError(
      "wrong-type",
      `manyQueries must be true or false, not ${kindOf(manyQueries)}`,
      "/manyQueries",
    );
  const limits = bounds === undefined ? [] : boundsOf(bounds, planar);
  const parts = new Parts(planar);
  readable("obstacles", "/obstacles", () => parts.add(obstacles, "/obstacles", 0));
  const { coordinates, kinds, counts } = parts;
  const made = called(
    () =>
      new ShortestMap(
        Float64Array.from(coordinates),
        Uint8Array.from(kinds),
        Uint32Array.from(counts),
        minDistance,
        Float64Array.from(limits),
        planar,
        manyQueries,
      ),
    parts.pointers,
  );
  return ShortestPaths.of(made, planar);
}

/**
 * What a call of the core makes.
 * @template T
 * @param {() => T} call
 * @param {readonly string[]} [pointers]  of the parts
 * @returns {T}
 */
function called(call, pointers = []) {
  try {
    return call();
  } catch (error) {
    if (typeof error !== "string") throw asOwn(error);
    const [code, subject, part, message] = error.split("\n");
    const places = new Map([
      ["part", pointers[Number(part)]],
      ["map", "/obstacles"],
      ["distance", "/minDistance"],
    ]);
    throw new PlanariumError(code, message, places.get(subject) ?? `/${subject}`);
  }
}

/** The parts of obstacles, as the core reads them. */
class Parts {
  /** The numbers of all positions. @type {number[]} */
  coordinates = [];
  /** The kind of each part. @type {number[]} */
  kinds = [];
  /** How many positions each part has. @type {number[]} */
  counts = [];
  /** Where each part is. @type {string[]} */
  pointers = [];
  #planar;

  /** @param {boolean} planar */
  constructor(planar) {
    this.#planar = planar;
  }

  /**
   * Adds an object of GeoJSON.
   * @param {unknown} value
   * @param {string} pointer
   * @param {number} depth
   * @returns {void}
   */
  add(value, pointer, depth) {
    const object = objectOf(value, "GeoJSON", pointer);
    const type = object.type;
    if (depth > DEEPEST)
      throw new PlanariumError("out-of-range", `collections lie in each other more than ${DEEPEST} deep`, pointer);
    switch (type) {
      case "FeatureCollection":
        if (depth > 0) break;
        return this.#each(object.features, `${pointer}/features`, (feature, at) => {
          const { type } = objectOf(feature, "a feature", at);
          if (type !== "Feature") throw unknownType(type, "Feature", at);
          this.add(feature, at, 1);
        });
      case "Feature":
        if (depth > 1) break;
        if (object.geometry === undefined)
          throw new PlanariumError("missing-field", "a feature has a geometry, or null", `${pointer}/geometry`);
        return object.geometry === null ? undefined : this.add(object.geometry, `${pointer}/geometry`, 2);
      case "GeometryCollection":
        return this.#each(object.geometries, `${pointer}/geometries`, (part, at) =>
          this.add(part, at, Math.max(depth, 1) + 1),
        );
      case "Point":
      case "MultiPoint":
      case "LineString":
      case "MultiLineString":
      case "Polygon":
      case "MultiPolygon":
        return this.#geometry(type, object.coordinates, `${pointer}/coordinates`);
    }
    const known = "a geometry of GeoJSON";
    throw unknownType(type, depth === 0 ? `FeatureCollection, Feature or ${known}` : known, pointer);
  }

  /**
   * @param {string} type
   * @param {unknown} coordinates
   * @param {string} pointer
   */
  #geometry(type, coordinates, pointer) {
    const list = listOf(coordinates, pointer);
    if (list.length === 0) return;
    switch (type) {
      case "Point":
        return this.#part(POINTS, [list], pointer, pointer);
      case "MultiPoint":
        return this.#part(POINTS, list, pointer);
      case "LineString":
        return this.#part(LINE, list, pointer);
      case "MultiLineString":
        return this.#each(list, pointer, (line, at) => {
          const positions = listOf(line, at);
          if (positions.length > 0) this.#part(LINE, positions, at);
        });
      case "Polygon":
        return this.#polygon(list, pointer);
      default:
        return this.#each(list, pointer, (polygon, at) => this.#polygon(listOf(polygon, at), at));
    }
  }

  /** @param {readonly unknown[]} rings @param {string} pointer */
  #polygon(rings, pointer) {
    if (rings.length > 0 && listOf(rings[0], `${pointer}/0`).length === 0) return;
    this.#each(rings, pointer, (ring, at, i) => this.#part(i === 0 ? OUTLINE : HOLE, listOf(ring, at), at));
  }

  /**
   * @param {number} kind
   * @param {readonly unknown[]} positions
   * @param {string} pointer
   * @param {string} [only]  the pointer of the only position
   */
  #part(kind, positions, pointer, only) {
    const { length } = positions;
    if (this.coordinates.length / 2 + length > MOST)
      throw new PlanariumError("too-large", `with these, there are more than ${MOST} positions`, pointer);
    for (let i = 0; i < length; i += 1) {
      const position = positionOf(positions[i], this.#planar, () => only ?? `${pointer}/${i}`);
      this.coordinates.push(position[0], position[1]);
    }
    this.kinds.push(kind);
    this.counts.push(length);
    this.pointers.push(pointer);
  }

  /**
   * @param {unknown} list
   * @param {string} pointer
   * @param {(item: unknown, pointer: string, i: number) => void} visit
   */
  #each(list, pointer, visit) {
    listOf(list, pointer).forEach((item, i) => visit(item, `${pointer}/${i}`, i));
  }
}

/** @param {unknown} type @param {string} known @param {string} pointer */
function unknownType(type, known, pointer) {
  const code = type === undefined ? "missing-field" : typeof type === "string" ? "unknown-type" : "wrong-type";
  return new PlanariumError(code, `the type must be ${known}, not ${kindOf(type)}`, `${pointer}/type`);
}

/** @param {unknown} value @param {string} what @param {string} pointer @returns {Record<string, unknown>} */
function objectOf(value, what, pointer) {
  if (typeof value === "object" && value !== null && !Array.isArray(value))
    return /** @type {Record<string, unknown>} */ (value);
  throw new PlanariumError("wrong-type", `${what} must be an object with a type, not ${kindOf(value)}`, pointer);
}

/** @param {unknown} value @param {string} pointer @returns {readonly unknown[]} */
function listOf(value, pointer) {
  if (Array.isArray(value)) return value;
  const name = pointer.slice(pointer.lastIndexOf("/") + 1);
  if (value === undefined) throw new PlanariumError("missing-field", `${name} is missing`, pointer);
  throw new PlanariumError("wrong-type", `there must be an array, not ${kindOf(value)}`, pointer);
}

/**
 * @param {unknown} value
 * @param {boolean} planar
 * @param {() => string} pointer
 * @param {number} [first]  the index of its first number there
 * @returns {[number, number]}
 */
function positionOf(value, planar, pointer, first = 0) {
  if (!Array.isArray(value) && !(ArrayBuffer.isView(value) && !(value instanceof DataView)))
    throw new PlanariumError("wrong-type", `a position must be an array of numbers, not ${kindOf(value)}`, pointer());
  const list = /** @type {readonly unknown[]} */ (value);
  if (list.length < 2)
    throw new PlanariumError("wrong-dimension", `a position has at least two numbers, not ${list.length}`, pointer());
  const [x, y] = [list[0], list[1]];
  requireNumber(x, "a coordinate", () => `${pointer()}/${first}`);
  requireNumber(y, "a coordinate", () => `${pointer()}/${first + 1}`);
  const most = planar ? [1e8, 1e8] : [180, 90];
  for (const [i, number] of [x, y].entries()) {
    if (Math.abs(number) <= most[i]) continue;
    const what = planar ? "a coordinate in metres" : i === 0 ? "a longitude" : "a latitude";
    throw new PlanariumError(
      "out-of-range",
      `${what} must be from ${-most[i]} to ${most[i]}, not ${number}`,
      `${pointer()}/${first + i}`,
    );
  }
  return [x, y];
}

/**
 * @param {unknown} value
 * @param {string} name
 * @param {string | (() => string)} pointer
 * @returns {asserts value is number}
 */
function requireNumber(value, name, pointer) {
  if (typeof value === "number" && Number.isFinite(value)) return;
  const at = typeof pointer === "string" ? pointer : pointer();
  if (typeof value !== "number")
    throw new PlanariumError("wrong-type", `${name} must be a number, not ${kindOf(value)}`, at);
  throw new PlanariumError("not-finite", `${name} must be finite, not ${value}`, at);
}

/** @param {unknown} start @param {unknown} goal @param {boolean} planar */
function endsOf(start, goal, planar) {
  return [placeOf(start, "/start", planar), placeOf(goal, "/goal", planar)];
}

/**
 * The position of a start or a goal.
 * @param {unknown} place
 * @param {string} pointer
 * @param {boolean} planar
 */
function placeOf(place, pointer, planar) {
  return readable(pointer.slice(1), pointer, () => {
    if (typeof place !== "object" || place === null || Array.isArray(place) || ArrayBuffer.isView(place))
      return positionOf(place, planar, () => pointer);
    let [object, at] = [objectOf(place, "a place", pointer), pointer];
    if (object.type === "Feature") {
      at = `${pointer}/geometry`;
      object = objectOf(object.geometry, "the geometry of a place", at);
    }
    if (object.type !== "Point") throw unknownType(object.type, "Point", at);
    return positionOf(object.coordinates, planar, () => `${at}/coordinates`);
  });
}

/** @param {unknown} bounds @param {boolean} planar @returns {number[]} */
function boundsOf(bounds, planar) {
  return readable("bounds", "/bounds", () => {
    const list = listOf(bounds, "/bounds");
    if (list.length !== 4)
      throw new PlanariumError(
        "wrong-dimension",
        `bounds are four numbers, west, south, east and north, not ${list.length}`,
        "/bounds",
      );
    return [0, 2].flatMap((i) => positionOf([list[i], list[i + 1]], planar, () => "/bounds", i));
  });
}

/** The options of a call. @param {unknown} options @param {string} known */
function optionsOf(options, known) {
  return readable("options", "", () => ({ ...fieldsOf(options, "options", known) }));
}

/** Whether positions are x and y. @param {Record<string, unknown>} options */
function isPlanar({ coordinates = "degrees" }) {
  if (coordinates === "metres" || coordinates === "degrees") return coordinates === "metres";
  throw new PlanariumError(
    typeof coordinates === "string" ? "out-of-range" : "wrong-type",
    `coordinates must be "degrees" or "metres", not ${kindOf(coordinates)}`,
    "/coordinates",
  );
}
