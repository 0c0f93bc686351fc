/** Tables: what a strict reader of RFC 4180 makes of them is what went in. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { toCsv } from "../../www/formats/csv.js";
import { seeded } from "./seeded.mjs";

/** Cells of a table, by the grammar of RFC 4180. @param {string} text */
function readCsv(text) {
  /** @type {string[][]} */
  const rows = [];
  let at = 0;
  while (at < text.length) {
    /** @type {string[]} */
    const row = [];
    for (;;) {
      const match = /(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r\n)/y;
      match.lastIndex = at;
      const [whole, quoted, plain, end] =
        match.exec(text) ?? assert.fail(`no cell at ${at}: ${text.slice(at, at + 40)}`);
      row.push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
      at += whole.length;
      if (end === "\r\n") break;
    }
    rows.push(row);
  }
  return rows;
}

test("a table is written by RFC 4180", () => {
  assert.equal(
    toCsv(
      ["a", "b"],
      [
        [1, "x"],
        [-0.5, null],
        [1e-7, 'say "hi"'],
        [NaN, "one, two"],
        [Infinity, "two\nlines"],
      ],
    ),
    'a,b\r\n1,x\r\n-0.5,\r\n1e-7,"say ""hi"""\r\n,"one, two"\r\n,"two\nlines"\r\n',
  );
  assert.equal(toCsv(["a"], []), "a\r\n");
  assert.throws(() => toCsv(["a", "b"], [[1, 2], [3]]), /A row has 1 cells, not 2/);
});

test("random tables come back", () => {
  const random = seeded(12);
  for (let i = 0; i < 200; i++) {
    const width = 1 + random.below(5);
    const cell = () =>
      random.pick([
        random.next(),
        random.below(1e9),
        -random.next() * 1e-12,
        null,
        "",
        " x ",
        '"',
        ",",
        "\r\n",
        "\n",
        "a;b",
        "ä\u2603",
        '","',
        "1,5",
      ]);
    const columns = Array.from({ length: width }, () => String(cell() ?? "c"));
    const rows = Array.from({ length: random.below(6) }, () => Array.from({ length: width }, cell));
    const read = readCsv(toCsv(columns, rows));
    assert.deepEqual(read, [columns, ...rows.map((row) => row.map((value) => String(value ?? "")))]);
    rows.flat().forEach((value, j) => {
      if (typeof value === "number") assert.equal(Number(read.slice(1).flat()[j]), value, "to the last digit");
    });
  }
});
