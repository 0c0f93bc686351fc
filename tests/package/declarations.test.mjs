/**
 * The declarations of each entry, one signature a line without comments, are the committed ones of `tests/api/`.
 * `PLANARIUM_BLESS=1` writes them anew. `planarium/full` has the declarations of `planarium` and what its file lists.
 */
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { root } from "../../scripts/run.mjs";

/** The statements of declarations; the members of a class follow it. @param {string} text */
function statements(text) {
  const code = text.replace(/\/\*[^]*?\*\/|^\/\/.*$/gm, "").replace(/\s+/g, " ");
  /** @type {string[]} */ const found = [];
  let [depth, from, owner] = [0, 0, ""];
  for (const { 0: mark, index } of code.matchAll(/"[^"]*"|=>|[{}()[\]<>;]/g)) {
    const [, kind, name] =
      /^ ?export (?:declare )?(class|interface) (\w+).*/.exec(
        mark === "{" && depth === 0 ? code.slice(from, index) : "",
      ) ?? [];
    if (kind === "class") found.push(`${code.slice(from, index).trim()} {}`);
    if (kind) owner = kind === "class" ? `${name}: ` : " ";
    if (kind === "class") from = index + 1;
    if ("{([<".includes(mark)) depth += 1;
    if ("})]>".includes(mark)) depth -= 1;
    const isOver = owner && mark === "}" && depth === 0;
    if (isOver || (mark === ";" && depth === (owner.length > 1 ? 1 : 0))) {
      const statement = code.slice(from, index + (isOver && owner === " " ? 1 : 0)).trim();
      if (statement && statement !== "#private") found.push((owner + statement).trim());
      from = index + 1;
      if (isOver) owner = "";
    }
  }
  return found;
}

/**
 * What a file exports, by name, and the members of classes with them.
 * @param {string} file
 * @returns {Map<string, string[]>}
 */
function exportsOf(file) {
  /** @type {Map<string, string[]>} */ const all = new Map();
  const add = (/** @type {string} */ name, /** @type {string[]} */ lines) =>
    all.set(name, [...(all.get(name) ?? []), ...lines]);
  for (const statement of statements(readFileSync(file, "utf8"))) {
    const [, names, source] = /^export (.*) from "(.*)\.js"$/.exec(statement) ?? [];
    if (source) {
      const others = exportsOf(join(dirname(file), `${source}.d.ts`));
      const wanted =
        names === "*"
          ? [...others.keys()].filter((name) => name !== "default")
          : names.replace(/[{} ]/g, "").split(",");
      for (const name of wanted) add(name, others.get(name) ?? assert.fail(`${name} of ${source}`));
      continue;
    }
    const [, own] = /^(\w+): /.exec(statement) ?? [];
    const [, name] =
      /^export (?:declare |abstract )*(?:type|interface|class|function|const|enum|(?=default)) ?(\w+)/.exec(
        statement,
      ) ?? [];
    if (own ?? name) add(own ?? name, [statement.replace(/^export (?:declare )?/, "")]);
  }
  return all;
}

/** @param {string} name */
const lines = (name) => [...exportsOf(join(root, "dist", "package", name)).values()].flat().sort();

test("the declarations of every entry are the committed ones", () => {
  const light = new Set(lines("planarium.d.ts"));
  const full = new Set(lines(join("full", "full.d.ts")));
  const beside = [...full].filter((line) => !light.has(line));
  const without = [...light].filter((line) => !full.has(line)).map((line) => `not: ${line}`);
  const entries = {
    planarium: [...light],
    full: [...beside, ...without],
    draw: lines("draw.d.ts"),
    worker: lines("worker.d.ts"),
    import: [...lines(join("import", "import.d.ts")), ...lines(join("import", "world.d.ts"))].sort(),
    shortest: lines(join("shortest", "shortest.d.ts")),
  };
  for (const [entry, found] of Object.entries(entries)) {
    const file = join(root, "tests", "api", `${entry}.txt`);
    const text = `${found.join("\n")}\n`;
    if (process.env.PLANARIUM_BLESS) writeFileSync(file, text);
    assert.ok(found.length > 5);
    assert.equal(
      readFileSync(file, "utf8"),
      text,
      `tests/api/${entry}.txt is out of date: PLANARIUM_BLESS=1 writes it anew`,
    );
  }
});
