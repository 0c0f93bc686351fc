/**
 * `planarium/shortest`: lengths that are known and those of `scenario.optimum()`, degrees and metres, holes, what is
 * refused and where, and a module that is loaded by itself.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { Scenario } from "planarium";
import { PlanariumError, initSync, prepare, shortestPath, ShortestPaths } from "planarium/shortest";
import { root } from "../../scripts/run.mjs";
import { seeded } from "../page/seeded.mjs";
import { node } from "./packed.mjs";
import { fails, revoked } from "./scenes.mjs";

const place = join(root, "dist", "package", "shortest");
const wasm = join(place, "shortest_bg.wasm");

/** @typedef {import("planarium/shortest").Geometry} Geometry */
/** @typedef {[number, number]} Pair */

const METRES = /** @type {const} */ ({ coordinates: "metres" });

/** @param {Geometry} geometry */
const feature = (geometry) => ({ type: /** @type {const} */ ("Feature"), properties: {}, geometry });
/** @param {Geometry[]} geometries */
const collection = (...geometries) => ({
  type: /** @type {const} */ ("FeatureCollection"),
  features: geometries.map(feature),
});
/** @param {...Pair[]} coordinates @returns {Geometry} */
const polygon = (...coordinates) => ({ type: "Polygon", coordinates });
/** @param {Pair} low @param {Pair} high @returns {Pair[]} */
const ring = ([x, y], [u, v]) => [
  [x, y],
  [u, y],
  [u, v],
  [x, v],
  [x, y],
];

/** Those of callers without types. @param {unknown[]} given */
const findAny = (...given) => Reflect.apply(shortestPath, undefined, given);
/** @param {unknown[]} given @returns {ShortestPaths} */
const prepareAny = (...given) => Reflect.apply(prepare, undefined, given);

/** @param {number} a @param {number} b @param {number} [relative] */
function close(a, b, relative = 1e-12) {
  assert.ok(Math.abs(a - b) <= relative * Math.abs(b), `${a} ${b}`);
}

/** @param {ReturnType<typeof shortestPath>} found */
const lengthOf = (found) => (found === null ? assert.fail("no path") : found.properties.length);

test("lengths that are known, around areas, lines and points", () => {
  const round = (/** @type {Geometry} */ obstacles, minDistance = 0) =>
    lengthOf(shortestPath([-5, 0], [5, 0], { obstacles, minDistance, ...METRES }));
  const tangents = 2 * 4 + 3 * (Math.PI - 2 * Math.acos(3 / 5));
  close(round({ type: "Point", coordinates: [0, 0, 100] }, 3), tangents);
  close(
    round(
      {
        type: "MultiPoint",
        coordinates: [
          [0, 0],
          [0, 1e3],
        ],
      },
      3,
    ),
    tangents,
  );
  close(round({ type: "Point", coordinates: [0, 0] }), 10);
  close(
    round({
      type: "LineString",
      coordinates: [
        [0, -4],
        [0, 12],
      ],
    }),
    2 * Math.hypot(5, 4),
  );
  close(
    round({
      type: "MultiLineString",
      coordinates: [
        [
          [0, -4],
          [0, 12],
        ],
        [
          [0, -4],
          [0, -3],
        ],
      ],
    }),
    2 * Math.hypot(5, 4),
  );
  close(round(polygon(ring([-2, -4], [2, 100]))), 14);
  // Not closed, in the other direction, and once more over itself.
  const open = ring([-2, -4], [2, 100]).slice(1).reverse();
  close(round({ type: "MultiPolygon", coordinates: [[open], [ring([-1, -4], [2, 50])]] }), 14);
  close(round({ type: "GeometryCollection", geometries: [polygon(ring([-2, -4], [2, 100]))] }), 14);
  close(round({ type: "GeometryCollection", geometries: [] }), 10);
  close(round({ type: "Polygon", coordinates: [] }, 7), 10);
});

test("a path is a feature of a line, from the start to the goal, whatever form they have", () => {
  const obstacles = collection(polygon(ring([4, 0], [6, 6])));
  const start = /** @type {const} */ ({ type: "Point", coordinates: [1, 2] });
  const found = shortestPath(
    start,
    { type: "Feature", geometry: { type: "Point", coordinates: [9, 2] } },
    { obstacles, ...METRES },
  );
  assert.deepEqual(found?.geometry, {
    type: "LineString",
    coordinates: [
      [1, 2],
      [4, 0],
      [6, 0],
      [9, 2],
    ].map(([x, y], i) => found?.geometry.coordinates[i] ?? [x, y]),
  });
  close(lengthOf(found), 2 + 2 * Math.hypot(3, 2));
  assert.deepEqual(found?.properties, { length: found?.properties.length, distortion: 0 });
  assert.equal(found?.type, "Feature");
  assert.deepEqual(found, JSON.parse(JSON.stringify(found)));
  const none = shortestPath([1, 1], [1, 1], METRES);
  assert.deepEqual(
    [none?.geometry.coordinates, lengthOf(none)],
    [
      [
        [1, 1],
        [1, 1],
      ],
      0,
    ],
  );
});

test("the inside of a hole is free, and no path leads out of it", () => {
  const obstacles = collection(polygon(ring([0, 0], [10, 10]), ring([2, 2], [8, 8])));
  const paths = prepare(obstacles, { minDistance: 0.5, ...METRES });
  close(lengthOf(paths.query([3, 3], [7, 7])), Math.hypot(4, 4));
  assert.equal(paths.query([3, 3], [12, 3]), null);
  fails(() => paths.query([1, 1], [3, 3]), "start-in-collision", "/start", /nearer to one than 0\.5 m/);
  fails(() => paths.query([3, 3], [7.6, 7]), "goal-in-collision", "/goal");
  paths.free();
});

test("lengths are those of scenario.optimum(), and queries return the same bits again", () => {
  const { next: random } = seeded(5);
  const number = (/** @type {number} */ low, /** @type {number} */ high) => low + (high - low) * random();
  for (let world = 0; world < 30; world += 1) {
    const minDistance = world % 3 === 0 ? 0 : number(0.05, 0.3);
    const rings = Array.from({ length: 12 }, () => {
      const [x, y] = [number(0, 9), number(0, 9)];
      return ring([x, y], [x + number(0.2, 2), y + number(0.2, 2)]);
    });
    const ends = /** @type {const} */ ([
      [-1, -1],
      [12, 12],
    ]);
    const scenario = Scenario.parse({
      format: "planarium-scenario-1",
      name: "blocks",
      world: {
        bounds: { min: [-2, -2], max: [13, 13] },
        obstacles: rings.map((vertices) => ({ type: "polygon", vertices })),
      },
      robot: { type: "disc", radius: minDistance },
      queries: [{ name: "across", start: [...ends[0]], goal: [...ends[1]] }],
    });
    const expected = scenario.optimum().length ?? assert.fail();
    const obstacles = collection(...rings.map((one) => polygon(one)));
    const paths = prepare(obstacles, { minDistance, bounds: [-2, -2, 13, 13], ...METRES });
    const found = paths.query(...ends);
    close(lengthOf(found), expected, 1e-9);
    close(lengthOf(shortestPath(...ends, { obstacles, minDistance, ...METRES })), expected, 1e-9);
    paths.query([-1, 12], [12, -1]);
    assert.deepEqual(paths.query(...ends), found);
    paths.free();
    scenario.free();
  }
});

test("ends far from all obstacles need no bounds", () => {
  const paths = prepare(
    {
      type: "LineString",
      coordinates: [
        [0, -1],
        [0, 1],
      ],
    },
    METRES,
  );
  const near = paths.query([-1, 0], [1, 0]);
  for (const far of [10, 1e3, 1e7, 20, 1e3]) close(lengthOf(paths.query([-far, 0], [far, 0])), 2 * Math.hypot(far, 1));
  assert.deepEqual(paths.query([-1, 0], [1, 0]), near);
  paths.free();
  const obstacles = collection({
    type: "LineString",
    coordinates: [
      [0, -1],
      [0, 1],
    ],
  });
  assert.equal(shortestPath([-4, 0], [4, 0], { obstacles, bounds: [-5, -1, 5, 1], ...METRES }), null);
  fails(
    () => shortestPath([-4, 0], [6, 0], { obstacles, bounds: [-5, -1, 5, 1], ...METRES }),
    "goal-in-collision",
    "/goal",
    /out of bounds/,
  );
});

test("degrees are measured on the ellipsoid", () => {
  // From Flinders Peak to Buninyong, of Geoscience Australia: 54 972.271 m along the geodesic.
  const flinders = [144.42486789, -37.95103342];
  const buninyong = [143.92649553, -37.65282114];
  const found = shortestPath(flinders, buninyong);
  close(lengthOf(found), 54_972.271, 3e-6);
  assert.ok(found && found.properties.distortion > 0.001 && found.properties.distortion < 0.003);
  // A block of houses in Berlin, around two corners of it; 68 m east or 111 m north are a thousandth of a degree.
  const block = polygon(ring([13.4, 52.5], [13.41, 52.51]));
  const start = [13.395, 52.504];
  const goal = [13.415, 52.504];
  const [east, north] = [67_884 * 1.0001, 111_267];
  const around = 2 * Math.hypot(0.005 * east, 0.004 * north) + 0.01 * east;
  close(lengthOf(shortestPath(start, goal, { obstacles: block })), around, 1e-3);
  assert.ok(lengthOf(shortestPath(start, goal, { obstacles: block, minDistance: 10 })) > around);
});

test("tangents are found beforehand for many queries", () => {
  const blocks = collection(
    polygon(ring([4, 0], [6, 6])),
    polygon(ring([4, 7], [6, 9])),
    polygon(ring([7, 5], [8, 8])),
  );
  const few = prepare(blocks, { minDistance: 0.25, ...METRES });
  const many = prepare(blocks, { minDistance: 0.25, manyQueries: true, ...METRES });
  assert.equal(few.tangents, null);
  assert.ok(Number(many.tangents) > 0);
  for (const goal of [
    [9, 2],
    [9, 6.5],
    [6.5, 6.5],
    [5, -3],
  ])
    close(lengthOf(many.query([1, 2], goal)), lengthOf(few.query([1, 2], goal)));
  fails(() => prepareAny(blocks, { manyQueries: 1 }), "wrong-type", "/manyQueries");
  fails(() => findAny([1, 2], [9, 2], { manyQueries: true }), "unknown-field", "/manyQueries");
  many.free();
  fails(() => many.tangents, "freed", "");
  few.free();
});

test("what is no GeoJSON is refused where it stands", () => {
  const bow = /** @type {Pair[]} */ ([
    [0, 0],
    [1, 1],
    [1, 0],
    [0, 1],
    [0, 0],
  ]);
  const good = polygon(ring([0, 0], [1, 1]));
  const at = "/obstacles/features/1/geometry";
  for (const [obstacles, code, pointer] of /** @type {[unknown, string, string][]} */ ([
    [5, "wrong-type", "/obstacles"],
    [[], "wrong-type", "/obstacles"],
    [{}, "missing-field", "/obstacles/type"],
    [{ type: "Topology" }, "unknown-type", "/obstacles/type"],
    [{ type: 7 }, "wrong-type", "/obstacles/type"],
    [{ type: "FeatureCollection" }, "missing-field", "/obstacles/features"],
    [{ type: "FeatureCollection", features: [good] }, "unknown-type", "/obstacles/features/0/type"],
    [{ type: "Feature" }, "missing-field", "/obstacles/geometry"],
    [{ type: "Polygon" }, "missing-field", "/obstacles/coordinates"],
    [{ type: "Polygon", coordinates: [[[0, 0], [1]]] }, "wrong-dimension", "/obstacles/coordinates/0/1"],
    [
      {
        type: "Polygon",
        coordinates: [
          [0, 0],
          [1, 1],
        ],
      },
      "wrong-type",
      "/obstacles/coordinates/0/0",
    ],
    [
      {
        type: "LineString",
        coordinates: [
          [0, 0],
          ["1", 1],
        ],
      },
      "wrong-type",
      "/obstacles/coordinates/1/0",
    ],
    [{ type: "Point", coordinates: [0, NaN] }, "not-finite", "/obstacles/coordinates/1"],
    [{ type: "Point", coordinates: [0, 91] }, "out-of-range", "/obstacles/coordinates/1"],
    [
      {
        type: "MultiPoint",
        coordinates: [
          [0, 20],
          [0, 70],
        ],
      },
      "out-of-range",
      "/obstacles",
    ],
    [collection(good, polygon(bow)), "degenerate-polygon", `${at}/coordinates/0`],
    [
      collection(good, polygon(ring([0, 0], [4, 4]), ring([5, 5], [6, 6]))),
      "degenerate-polygon",
      `${at}/coordinates/1`,
    ],
    [
      collection(
        good,
        polygon([
          [0, 0],
          [1, 1],
          [0, 0],
        ]),
      ),
      "degenerate-polygon",
      `${at}/coordinates/0`,
    ],
    [
      collection(good, {
        type: "LineString",
        coordinates: [
          [2, 2],
          [2, 2],
        ],
      }),
      "degenerate-wall",
      `${at}/coordinates`,
    ],
    [collection(good, { type: "MultiLineString", coordinates: [[[2, 2]]] }), "degenerate-wall", `${at}/coordinates/0`],
    [revoked(), "wrong-type", "/obstacles"],
    [{ get type() { throw new Error("mine"); } }, "wrong-type", "/obstacles"], // prettier-ignore
  ])) {
    fails(() => prepareAny(obstacles), code, pointer);
    fails(() => findAny([0, 0], [1, 1], { obstacles }), code, pointer);
  }
  const nested = Array.from({ length: 50 }).reduce(
    (/** @type {unknown} */ inner) => ({ type: "GeometryCollection", geometries: [inner] }),
    good,
  );
  assert.throws(() => prepareAny(nested), { code: "out-of-range" });
  prepareAny({ type: "Feature", geometry: null }).free();
});

test("options and ends that are none are refused", () => {
  for (const [options, code, pointer] of /** @type {[unknown, string, string][]} */ ([
    [{ minDistance: -1 }, "out-of-range", "/minDistance"],
    [{ minDistance: 1e7 }, "out-of-range", "/minDistance"],
    [{ minDistance: "1" }, "wrong-type", "/minDistance"],
    [{ minDistance: NaN }, "not-finite", "/minDistance"],
    [{ minDistanse: 1 }, "unknown-field", "/minDistanse"],
    [{ bounds: [0, 0, 1] }, "wrong-dimension", "/bounds"],
    [{ bounds: [0, 0, 1, 0] }, "out-of-range", "/bounds"],
    [{ bounds: [0, 0, 1, NaN] }, "not-finite", "/bounds/3"],
    [{ coordinates: "feet" }, "out-of-range", "/coordinates"],
    [7, "wrong-type", ""],
  ]))
    fails(() => findAny([0, 0], [1, 1], options), code, pointer);
  for (const [start, code, pointer] of /** @type {[unknown, string, string][]} */ ([
    [undefined, "wrong-type", "/start"],
    [[1], "wrong-dimension", "/start"],
    [[1, Infinity], "not-finite", "/start/1"],
    [[181, 0], "out-of-range", "/start/0"],
    [{ type: "LineString", coordinates: [] }, "unknown-type", "/start/type"],
    [{ type: "Feature", geometry: null }, "wrong-type", "/start/geometry"],
    [{ type: "Point" }, "wrong-type", "/start/coordinates"],
    [[0, 60], "out-of-range", "/start"],
  ]))
    fails(() => findAny(start, [0, 0]), code, pointer);
  assert.deepEqual(findAny([0, 0], [1, 0], null), shortestPath([0, 0], [1, 0]));
});

test("handles are freed once, and belong to their class", () => {
  const paths = prepareAny(polygon(ring([0, 0], [1, 1])));
  fails(
    () =>
      Reflect.apply(paths.query, undefined, [
        [0, 0],
        [1, 1],
      ]),
    "illegal-invocation",
    "",
  );
  fails(() => Reflect.construct(ShortestPaths, []), "illegal-constructor", "");
  paths.free();
  paths.free();
  paths[Symbol.dispose]();
  fails(() => paths.query([2, 2], [3, 3]), "freed", "");
});

test("numbers at random never stop the module", () => {
  const { next: random } = seeded(9);
  const numbers = [0, -0, 1, -1, 1e-200, 1e-16, 0.1, 90, 180, 1e8, NaN, 5e-324];
  const any = () => numbers[Math.floor(random() * numbers.length)];
  const list = () => Array.from({ length: Math.floor(random() * 7) }, () => [any(), any()]);
  const counts = { found: 0, refused: 0 };
  for (let i = 0; i < 3000; i += 1) {
    const geometries = Array.from({ length: 1 + Math.floor(random() * 4) }, () => {
      const type = ["Polygon", "LineString", "MultiPoint"][Math.floor(random() * 3)];
      return { type, coordinates: type === "Polygon" ? [list()] : list() };
    });
    const options = { obstacles: { type: "GeometryCollection", geometries }, minDistance: [0, 0.1, 1, 1e6][i % 4] };
    try {
      findAny([any(), any()], [any(), any()], i % 2 ? { ...options, ...METRES } : options);
      counts.found += 1;
    } catch (error) {
      assert.ok(error instanceof PlanariumError && error.code !== "internal", `${error} ${JSON.stringify(options)}`);
      counts.refused += 1;
    }
  }
  assert.ok(counts.found > 50 && counts.refused > 50, JSON.stringify(counts));
});

test("a large map is prepared once, and each query takes milliseconds", () => {
  const { next: random } = seeded(3);
  const rings = Array.from({ length: 3000 }, () => {
    const [x, y] = [random() * 1000, random() * 1000];
    return polygon(ring([x, y], [x + 2 + random() * 10, y + 2 + random() * 10]));
  });
  const paths = prepare(collection(...rings), { minDistance: 0.5, ...METRES });
  paths.query([-5, -5], [1020, 1020]);
  const began = performance.now();
  const found = paths.query([-5, -5], [1020, 1020]);
  const took = performance.now() - began;
  paths.free();
  assert.ok(lengthOf(found) > Math.hypot(1025, 1025));
  // Some 3 ms here; a machine that does much else takes longer.
  assert.ok(took < 150, `${took} ms`);
});

/** A program that imports the entry of browsers, with files that `fetch` reads from disk. */
const WEB = `
import { readFileSync } from "node:fs";
let fetched = [];
globalThis.fetch = async (url) => {
  fetched.push(String(url).split("/").at(-1));
  return new Response(readFileSync(new URL(url)), { headers: { "content-type": "application/wasm" } });
};
const { default: init, initSync, prepare, shortestPath } = await import(${JSON.stringify(pathToFileURL(join(place, "shortest.js")).href)});
const glue = await import(${JSON.stringify(pathToFileURL(join(place, "shortest_glue.js")).href)});
const bytes = readFileSync(${JSON.stringify(wasm)});
const code = (work) => { try { work(); return null; } catch (error) { return error.code; } };
`;

/** What a program prints in a process of its own. @param {string} program */
const printed = (program) => node(["--input-type=module", "-e", WEB + program]);

test("the entry of browsers fetches its own module and no other, once", () => {
  const found = printed(`
    const before = code(() => shortestPath([0, 0], [1, 0]));
    await Promise.all([init(), init()]);
    await init();
    console.log(JSON.stringify({ before, after: code(() => shortestPath([0, 0], [1, 0])), fetched }));`);
  assert.deepEqual(found, { before: "not-initialised", after: null, fetched: ["shortest_bg.wasm"] });
});

/** @param {string} code */
const withoutComments = (code) => code.replace(/\/\*[^]*?\*\//g, "");

test("no file of another core belongs to the entry", () => {
  const reached = new Set([join(place, "shortest-node.js"), join(place, "shortest.js")]);
  for (const file of reached)
    for (const [, name] of withoutComments(readFileSync(file, "utf8")).matchAll(/(?:from|import)\s*\(?"(\.[^"]+)"/g))
      reached.add(join(file, "..", name));
  const names = [...reached].map((file) => file.slice(join(root, "dist", "package").length + 1)).sort();
  assert.deepEqual(names, [
    "error.js",
    "handle.js",
    "plain.js",
    "shortest/runtime.js",
    "shortest/shortest-node.js",
    "shortest/shortest.js",
    "shortest/shortest_glue.js",
  ]);
  const zipped = gzipSync(readFileSync(wasm), { level: 9 }).length;
  assert.ok(zipped <= 150_000, `${zipped} bytes`);
});

test("init and initSync take bytes, and refuse the module of another entry", () => {
  const found = printed(`
    const other = readFileSync(${JSON.stringify(join(root, "dist", "package", "planarium_bg.wasm"))});
    const refused = await init(other).catch(({ code, message }) => [code, /shortest_bg\\.wasm/.test(message)]);
    initSync(bytes);
    await init(new URL("nowhere", import.meta.url));
    console.log(JSON.stringify({ refused, code: code(() => shortestPath([0, 0], [1, 0])), fetched }));`);
  assert.deepEqual(found, { refused: ["init-failed", true], code: null, fetched: [] });
  initSync(readFileSync(wasm));
});

test("after a trap handles are lost, and init makes a fresh module", () => {
  const found = printed(`
    await init(bytes);
    const obstacles = { type: "LineString", coordinates: [[0, -1], [0, 1]] };
    const paths = prepare(obstacles);
    new Uint8Array(glue.initSync().memory.buffer).fill(0xff);
    const lost = [code(() => prepare(obstacles)), code(() => paths.query([1, 0], [2, 0]))];
    paths.free();
    await init();
    console.log(JSON.stringify([...lost, code(() => shortestPath([-1, 0], [1, 0], { obstacles })), code(() => prepare(obstacles).free())]));`);
  assert.deepEqual(found, ["internal", "internal", null, null]);
});
