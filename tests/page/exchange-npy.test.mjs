/** NumPy's files, as NumPy 1.26 and 2 write them; broken and hostile ones are refused in words. */
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";
import { readNpy, readNpyPolygons, writeNpy } from "../../www/formats/npy.js";
import { FIXTURES, file, fixture, pickled } from "./npy.mjs";
import { mutated, seeded } from "./seeded.mjs";

const NAMES = readdirSync(FIXTURES)
  .filter((name) => name.endsWith(".npy"))
  .map((name) => name.slice(0, -4));

const TRIANGLE = [
  [0, 0],
  [1, 0],
  [0.5, 1.25],
];
const SQUARE = [
  [2, 2],
  [3, 2],
  [3, 3],
  [2, 3],
];
const OTHER = [
  [-1.5, 1e-3],
  [4, 0.1],
  [0.2, 7],
];
const EIGHTHS = Array.from({ length: 24 }, (_, i) => i / 8 - 1);

/** What reading says of a file that it does not read. @param {() => unknown} read @returns {string} */
function refusal(read) {
  try {
    read();
  } catch (error) {
    assert.ok(
      error instanceof Error && "code" in error && error.code === "invalid-npy",
      `not a coded error: ${error instanceof Error ? error.stack : error}`,
    );
    assert.match(error.message, /^[A-Z][^]{5,300}\.$/);
    return error.message;
  }
  return "";
}

/** @param {Uint8Array} bytes @param {RegExp} pattern */
function refuses(bytes, pattern) {
  assert.match(
    refusal(() => readNpyPolygons(bytes)),
    pattern,
  );
}

test("numbers of every type, order and version are read, in C order", () => {
  const expected = { shape: [2, 3, 4], data: Float64Array.from(EIGHTHS) };
  for (const name of ["c", "fortran", "single", "big-endian-fortran"])
    assert.deepEqual(readNpy(fixture(`numpy1-${name}`)), expected, name);
  assert.deepEqual(readNpy(fixture("numpy1-third")), { shape: [3, 4], data: Float64Array.from(EIGHTHS.slice(0, 12)) });
  assert.deepEqual(readNpy(fixture("numpy1-scalar")), { shape: [], data: Float64Array.of(2.5) });
  assert.deepEqual(readNpy(fixture("numpy1-empty")), { shape: [0, 3], data: new Float64Array() });
  assert.deepEqual(readNpy(fixture("numpy1-signed")), { shape: [2], data: Float64Array.of(-1, -(2 ** 31)) });
  for (const type of ["i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "b1"]) {
    assert.deepEqual(
      readNpy(fixture(`numpy1-whole-${type}`)),
      { shape: [2, 2], data: Float64Array.of(0, 1, 1, type === "b1" ? 1 : 100) },
      type,
    );
  }
  assert.deepEqual(
    [fixture("numpy1-c")[6], fixture("numpy1-big-endian-fortran")[6], fixture("numpy1-third")[6]],
    [1, 2, 3],
    "the versions are all there",
  );
});

test("a view into a larger buffer is read where it lies", () => {
  const bytes = fixture("numpy1-c");
  const wide = new Uint8Array(bytes.length + 10).fill(7);
  wide.set(bytes, 3);
  assert.deepEqual([...readNpy(wide.subarray(3, 3 + bytes.length)).data], EIGHTHS);
  const objects = fixture("numpy1-protocol5");
  const other = new Uint8Array(objects.length + 10).fill(7);
  other.set(objects, 5);
  assert.deepEqual(readNpyPolygons(other.subarray(5, 5 + objects.length)), [TRIANGLE, SQUARE, OTHER]);
});

test("polygons of both versions of NumPy are read, from numbers and from objects", () => {
  for (const version of ["numpy1", "numpy2"]) {
    assert.deepEqual(readNpyPolygons(fixture(`${version}-one`)), [TRIANGLE]);
    assert.deepEqual(readNpyPolygons(fixture(`${version}-equal`)), [TRIANGLE, OTHER]);
    assert.deepEqual(readNpyPolygons(fixture(`${version}-ragged`)), [TRIANGLE, SQUARE, OTHER]);
    assert.deepEqual(readNpyPolygons(fixture(`${version}-kinds`)), Array(7).fill(SQUARE));
    assert.deepEqual(readNpyPolygons(fixture(`${version}-objects`)), [TRIANGLE, OTHER]);
    assert.deepEqual(readNpyPolygons(fixture(`${version}-shared`)), Array(3).fill(TRIANGLE));
    for (const protocol of [2, 3, 4, 5])
      assert.deepEqual(
        readNpyPolygons(fixture(`${version}-protocol${protocol}`)),
        [TRIANGLE, SQUARE, OTHER],
        `protocol ${protocol}`,
      );
  }
});

test("what is not read is refused by its type", () => {
  assert.match(
    refusal(() => readNpy(fixture("numpy1-complex"))),
    /<c16/,
  );
  assert.match(
    refusal(() => readNpy(fixture("numpy1-half"))),
    /<f2/,
  );
  assert.match(
    refusal(() => readNpy(fixture("numpy1-record"))),
    /plain/,
  );
  assert.match(
    refusal(() => readNpy(fixture("numpy1-large"))),
    /too large/,
  );
  assert.match(
    refusal(() => readNpy(fixture("numpy1-ragged"))),
    /\|O/,
  );
  assert.match(
    refusal(() => readNpyPolygons(fixture("numpy1-c"))),
    /Vertex 0 of polygon 0 must be two finite numbers/,
  );
  assert.match(
    refusal(() => readNpyPolygons(writeNpy(Float64Array.of(0, 0, 1, 1, NaN, 2), [3, 2]))),
    /Vertex 2 of polygon 0/,
  );
  assert.match(
    refusal(() => readNpyPolygons(writeNpy(Float64Array.of(0, 0, 1, 1), [2, 2]))),
    /three vertices/,
  );
});

test("headers are read in any order of entries, and only whole ones", () => {
  const body = [...new Uint8Array(Float64Array.of(1, 2).buffer)];
  const good = [
    "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }\n",
    '{"shape":(2L,),"descr":"<f8","fortran_order":True}',
    "{'shape': (2, 1),'fortran_order':False,\n 'descr':'<f8'}",
  ];
  for (const literal of good) assert.deepEqual([...readNpy(file(literal, body)).data], [1, 2], literal);
  const bad = [
    "",
    "{}",
    "{'descr': '<f8', 'shape': (2,), }",
    "{'fortran_order': False, 'shape': (2,), }",
    "{'descr': '<f8', 'fortran_order': False}",
    "{'descr': '<f8', 'fortran_order': 0, 'shape': (2,)}",
    "{'descr': '<f8', 'fortran_order': False, 'shape': 2}",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (-2,)}",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (3,)}",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999999999, 0)}",
    `{'descr': '<f8', 'fortran_order': False, 'shape': (${"9".repeat(400)}, 0)}`,
    "{'descr': 'f8', 'fortran_order': False, 'shape': (2,)}",
    "{'descr': '=f8', 'fortran_order': False, 'shape': (2,)}",
    "{'descr': '|f8', 'fortran_order': False, 'shape': (2,)}",
    "{'descr': '<constructor', 'fortran_order': False, 'shape': (2,)}",
    "{'descr': '<f9', 'fortran_order': False, 'shape': (2,)}",
  ];
  for (const literal of bad) {
    assert.notEqual(
      refusal(() => readNpy(file(literal, body))),
      "",
      literal,
    );
  }
  const wrongVersion = fixture("numpy1-c");
  wrongVersion[6] = 4;
  assert.match(
    refusal(() => readNpy(wrongVersion)),
    /not a NumPy array/,
  );
  assert.match(
    refusal(() => readNpy(new TextEncoder().encode("PK\x03\x04 something else"))),
    /not a NumPy array/,
  );
});

test("files cut short at any length are refused", () => {
  for (const name of NAMES) {
    const bytes = fixture(name);
    for (let length = 0; length < bytes.length; length++) {
      const cut = bytes.slice(0, length);
      assert.notEqual(
        refusal(() => readNpy(cut)),
        "",
        `${name} at ${length}`,
      );
      assert.notEqual(
        refusal(() => readNpyPolygons(cut)),
        "",
        `${name} at ${length}`,
      );
    }
    if (!Buffer.from(bytes).includes("|O"))
      assert.notEqual(
        refusal(() => readNpy(Uint8Array.of(...bytes, 0))),
        "",
        `${name} and a byte`,
      );
  }
});

test("2000 mutated files are read or refused", () => {
  const random = seeded(4);
  let read = 0;
  for (let i = 0; i < 2000; i++) {
    const name = NAMES[i % NAMES.length];
    const bytes = mutated(fixture(name), random);
    for (const reader of [readNpy, readNpyPolygons]) if (refusal(() => reader(bytes)) === "") read++;
  }
  assert.ok(read > 50 && read < 2000, `${read} were read`);
});

test("a hostile pickle is refused by the name of what it asks for", () => {
  const command = "X\x07\0\0\0echo hi\x85R.";
  refuses(pickled("\x80\x02cos\nsystem\n", command), /os\.system, which is refused/);
  refuses(pickled("\x80\x02cposix\nsystem\n", command), /posix\.system/);
  refuses(pickled("\x80\x02c__builtin__\neval\n", command), /__builtin__\.eval/);
  refuses(pickled("\x80\x04\x8c\x08builtins\x8c\x04exec\x93", command), /builtins\.exec/);
  refuses(pickled("\x80\x04\x8c\x05posix\x8c\x06system\x93", command), /posix\.system/);
  refuses(pickled("\x80\x02cnumpy.core.multiarray\nfromfile\n", command), /numpy\.core\.multiarray\.fromfile/);
  refuses(pickled("\x80\x02cnumpy.testing._private.utils\nrunstring\n", command), /runstring/);
  refuses(pickled("\x80\x02cconstructor\nconstructor\n", command), /constructor\.constructor/);
  refuses(pickled("\x80\x02c\n__proto__\n", command), /\.__proto__/);
  // The instructions that would look up or make things: INST, OBJ, NEWOBJ, NEWOBJ_EX, PERSID, BINPERSID, EXT1,
  // NEXT_BUFFER.
  refuses(pickled("\x80\x02(X\x02\0\0\0lsios\nsystem\n."), /instruction 105/);
  for (const op of "o\x81\x92PQ\x82\x97}ds0I")
    refuses(pickled(`\x80\x05NN${op}.`), new RegExp(`instruction ${op.charCodeAt(0)}, which is refused`));
});

test("no text or list of a pickle can be called, and no class stands for an array", () => {
  refuses(pickled("\x80\x02X\x09\0\0\0os.system)R."), /damaged/);
  refuses(pickled("\x80\x02])R."), /damaged/);
  refuses(pickled("\x80\x02cnumpy\nndarray\n)R."), /damaged/);
  refuses(pickled("\x80\x02cnumpy\nndarray\n."), /no list of polygons/);
  refuses(pickled("\x80\x02cnumpy\ndtype\nNR."), /damaged/);
  refuses(pickled("\x80\x02cnumpy\ndtype\n)R."), /no list of vertices/);
  refuses(pickled("\x80\x02c_codecs\nencode\n)R."), /damaged|refused/);
  refuses(pickled("\x80\x06N."), /damaged/);
  for (const broken of [
    "t.",
    "a.",
    "e.",
    "R.",
    "b.",
    "h\0.",
    "q\0.",
    "\x94.",
    "\x93.",
    "\x85.",
    "(.",
    ".",
    "",
    "]N(e",
    "K",
    "cos",
    "cos\n",
    "X\xff\xff\xff\xffa.",
    "\x96\0\0\0\0\0\0\0\x80.",
    "Nb.",
  ]) {
    refuses(pickled(`\x80\x02${broken}`), /./);
  }
});

test("what refers to itself or to much ends", () => {
  // A list that holds itself.
  refuses(pickled("\x80\x02]q\0h\0a."), /./);
  refuses(pickled("\x80\x02]q\0(h\0h\0h\0e."), /./);
  // Ten lists to the power of forty.
  const laughs = Array.from({ length: 40 }, (_, i) => [
    "]q",
    [i + 1],
    "(",
    Array.from({ length: 10 }, () => [0x68, i]).flat(),
    "e",
  ]).flat();
  refuses(pickled("\x80\x02]q\0", ...laughs, "."), /./);
  // The same as the type and the byte order of an array.
  refuses(pickled("\x80\x02]q\0", ...laughs, "q\xfe0"), /./);
  refuses(
    pickled(
      "\x80\x02]q\0",
      ...laughs,
      "q\xfecnumpy\ndtype\n(h\xfetRq\xfdcnumpy.core.multiarray\nscalar\n(h\xfdh\xfetR.",
    ),
    /./,
  );
  refuses(pickled("\x80\x02]q\0", ...laughs, "q\xfeh\xfe\x93."), /./);
  // Shapes beyond all measure.
  const array = (/** @type {string} */ shape) =>
    `\x80\x02cnumpy.core.multiarray\n_reconstruct\n(tR(K\x01${shape}cnumpy\ndtype\n(X\x02\0\0\0f8tR(K\x03X\x01\0\0\0<tb\x89C\0tb.`;
  const most = "\x8a\x06\xff\xff\xff\xff\xff\x7f";
  for (const shape of [
    `(${most}${most}t`,
    `(${most}K\0t`,
    `(K\0${most}t`,
    "(NNt",
    `(${most.repeat(33)}t`,
    "(J\xff\xff\xff\xfft",
    "(K\x02K\x02t",
    ")",
    "N",
  ])
    refuses(pickled(array(shape)), /./);
  assert.deepEqual(
    refusal(() => readNpyPolygons(pickled(array("(K\0K\x02t")))),
    "There is no list of polygons.",
  );
});

test("a pickle as long as files may be is refused", () => {
  const head = pickled("");
  for (const fill of ["N", "(", "\x94", "h\0"]) {
    const bytes = new Uint8Array(10 * 2 ** 20);
    bytes.set(head);
    bytes.set([0x80, 2, 0x5d, 0x71, 0], head.length);
    bytes.fill(fill.charCodeAt(0), head.length + 5);
    for (let i = head.length + 6; fill.length > 1 && i < bytes.length; i += 2) bytes[i] = fill.charCodeAt(1);
    refuses(bytes, /./);
  }
  refuses(new Uint8Array(10 * 2 ** 20 + 1), /10 MB/);
});

test("5000 vertices are read, 5001 are not, however they are spread", () => {
  const ring = (/** @type {number} */ n) =>
    Float64Array.from({ length: 2 * n }, (_, i) => (i % 2 ? Math.sin(i) : Math.cos(i)));
  assert.equal(readNpyPolygons(writeNpy(ring(5000), [5000, 2]))[0].length, 5000);
  assert.equal(readNpyPolygons(writeNpy(ring(5000), [1000, 5, 2])).length, 1000);
  refuses(writeNpy(ring(5001), [5001, 2]), /5000 vertices/);
  refuses(writeNpy(ring(5001), [1667, 3, 2]), /5000 vertices/);
  // One triangle, referred to 1667 times.
  const corner = "(K\x01K\x02t";
  const many = (/** @type {number} */ n) =>
    pickled("\x80\x02](](", corner.repeat(3), "eq\x01", "h\x01".repeat(n - 1), "e.");
  assert.equal(readNpyPolygons(many(1666)).length, 1666);
  refuses(many(1667), /5000 vertices/);
});

test("written files equal NumPy's, byte by byte, and come back", () => {
  assert.deepEqual(writeNpy(Float64Array.from(EIGHTHS), [2, 3, 4]), fixture("numpy1-c"));
  assert.deepEqual(writeNpy(Float64Array.of(2.5), []), fixture("numpy1-scalar"));
  assert.deepEqual(writeNpy(new Float64Array(), [0, 3]), fixture("numpy1-empty"));
  assert.deepEqual(writeNpy(Float64Array.from(TRIANGLE.flat()), [3, 2]), fixture("numpy2-one"));
  const random = seeded(5);
  for (let i = 0; i < 100; i++) {
    const shape = Array.from({ length: random.below(5) }, () => random.below(6));
    const data = Float64Array.from({ length: shape.reduce((n, m) => n * m, 1) }, () =>
      random.pick([random.next(), -0, NaN, Infinity, -1e-320, 1e300]),
    );
    const bytes = writeNpy(data, shape);
    assert.equal((bytes.length - 8 * data.length) % 64, 0);
    assert.deepEqual(readNpy(bytes), { shape, data });
  }
  assert.throws(() => writeNpy(new Float64Array(5), [2, 3]), /Shape \(2,3\) does not have 5 numbers/);
});
