/**
 * The public interface of the library in Rust, as its sources declare it, is the committed one of `tests/api/rust.txt`:
 * what is `pub` and has a path without `#[doc(hidden)]`, one signature a line. `PLANARIUM_BLESS=1` writes it anew. What
 * derives and macros implement is not in it.
 */
import assert from "node:assert/strict";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../scripts/run.mjs";

/**
 * @typedef {{ attributes: string, head: string, body: string }} Item   an item: what stands before its braces, and in
 *   them
 */

const DECLARED = /^pub (?:const |async |unsafe )*(?:fn|struct|enum|trait|type|const|static|mod) (\w+)/;
const HIDDEN = /doc\(hidden\)|wasm32|cfg\(doctest\)/;

/** Code without comments and without what strings and characters contain. @param {string} text */
const plain = (text) =>
  text
    .replace(/\/\/.*$/gm, "")
    .replace(/'(?:\\.|[^'\\])'/g, "'_'")
    .replace(/r#"[^]*?"#|"(?:\\[^]|[^"\\])*"/g, '"_"')
    .replace(/\s+/g, " ");

/**
 * What is separated by `end`, or closed by braces, outside all others; what macros declare stands in their place.
 * @param {string} code
 * @param {string} [end]
 * @returns {Item[]}
 */
function split(code, end = ";") {
  /** @type {Item[]} */ const items = [];
  let [depth, from, open] = [0, 0, -1];
  for (const { 0: mark, index } of `${code}${end}`.matchAll(/->|=>|[{}()[\]<>;,]/g)) {
    if (mark === "{" && depth === 0 && open < 0 && end === ";" && !/\buse /.test(code.slice(from, index))) open = index;
    if ("{([".includes(mark) || (end === "," && mark === "<")) depth += 1;
    if ("})]".includes(mark) || (end === "," && mark === ">")) depth -= 1;
    if (depth !== 0 || (mark !== end && !(mark === "}" && open >= 0))) continue;
    const [, attributes, head] =
      /^((?:#!?\[(?:[^[\]]|\[[^\]]*\])*\] ?)*)(.*)$/.exec(code.slice(from, open < 0 ? index : open).trim()) ??
      assert.fail();
    const body = open < 0 ? "" : code.slice(open + 1, index).trim();
    if (head.trim().endsWith("!")) items.push(...split(body));
    else if (head) items.push({ attributes, head: head.trim().replace(/\( /g, "(").replace(/, \)/g, ")"), body });
    [from, open] = [index + 1, -1];
  }
  return items;
}

/**
 * The paths of `a::{b, c as d}`, each with its name.
 * @param {string} tree
 * @param {string} [before]
 * @returns {[string, string][]}
 */
function paths(tree, before = "") {
  const [, head, inner] = /^([^{]*)\{(.*)\}$/.exec(tree) ?? [];
  if (inner !== undefined) return split(inner, ",").flatMap(({ head: one }) => paths(one, before + head));
  const [path, alias] = tree.split(" as ");
  return [[`${before}${path}`.replace("::self", ""), alias ?? path.split("::").at(-1) ?? ""]];
}

/** The items of each module. @type {Map<string, Item[]>} */
const modules = new Map(
  readdirSync(join(root, "src"), { recursive: true, encoding: "utf8" })
    .filter((file) => file.endsWith(".rs"))
    .map((file) => {
      const module = file.replace(/(?:^|\/)(?:mod|lib)\.rs$|\.rs$/, "").replaceAll("/", "::");
      return [`crate${module && "::"}${module}`, split(plain(readFileSync(join(root, "src", file), "utf8")))];
    }),
);

/** Where an item is declared in full: elsewhere it is named only. @type {Map<Item, string>} */
const declared = new Map();

/**
 * Adds the lines of what a path names, or of all that a module shows, at a public path.
 * @param {string} module
 * @param {string} wanted
 * @param {string} at
 * @param {Map<string, string>} shown
 */
function show(module, wanted, at, shown) {
  if (wanted && modules.has(`${module}::${wanted}`)) return show(`${module}::${wanted}`, "", `${at}::${wanted}`, shown);
  const items = modules.get(module) ?? [];
  for (const [i, { attributes, head, body }] of items.entries()) {
    if (HIDDEN.test(attributes) || module.startsWith("crate::bindings")) continue;
    const [, tree] = /^(?:pub(?:\(.*?\))? )?use (.*)$/.exec(head) ?? [];
    for (const [path, name] of tree && (wanted || head.startsWith("pub ")) ? paths(tree) : []) {
      if (wanted && name !== wanted) continue;
      const [first, ...rest] = path.split("::");
      const last = rest.pop() ?? first;
      const place =
        { crate: "crate", self: module, super: module.replace(/::\w+$/, "") }[first] ??
        (path.includes("::") ? `${module}::${first}` : module);
      if (place !== module || last !== wanted) show([place, ...rest].join("::"), last, at, shown);
    }
    const [, own] = DECLARED.exec(head) ?? [];
    if (!own || (wanted && own !== wanted)) continue;
    if (head.startsWith("pub mod ")) show(`${module}::${own}`, "", `${at}::${own}`, shown);
    else if (!shown.has(`${at}::${own}`)) {
      const first = declared.get(items[i]) ?? at;
      declared.set(items[i], first);
      shown.set(
        `${at}::${own}`,
        `${at}: ${first === at ? head + members(head, body, items.slice(i + 1)) : `pub use ${first}::${own}`}`,
      );
    }
  }
}

/**
 * What an item shows within, in its line: fields, variants, functions of a trait, options.
 * @param {string} head
 * @param {string} body
 * @param {Item[]} rest
 */
function members(head, body, rest) {
  const own = head.includes(" fn ")
    ? []
    : split(body, head.includes(" trait ") ? ";" : ",")
        .filter((one) => !HIDDEN.test(one.attributes))
        .map((one) => one.head);
  const end = rest.findIndex((one) => !/^\w+: /.test(one.head));
  const options = / struct \w+ for /.test(head)
    ? rest.slice(0, end < 0 ? rest.length : end).map((one) => one.head.replace(/(^[^<,]*(?:<[^>]*>)?).*/, "$1"))
    : [];
  const all = [...own.filter((one) => one.startsWith("pub ") || !head.includes(" struct ")), ...options];
  return all.length > 0 ? ` { ${all.join("; ")} }` : "";
}

test("the public interface in Rust is the committed one", () => {
  /** @type {Map<string, string>} */ const shown = new Map();
  show("crate", "", "planarium", shown);
  const all = new Set(shown.values());
  const names = new Set([...shown.keys()].map((path) => path.split("::").at(-1)));
  for (const { head, body, attributes } of [...modules.values()].flat()) {
    const [, trait, own] = /^impl(?:<.*?>)? (?:(.*) for )?(?:\w+::)*(\w+)/.exec(head) ?? [];
    if (!names.has(own) || HIDDEN.test(attributes)) continue;
    if (trait) all.add(head.replace(/ where .*/, ""));
    else
      for (const one of split(body))
        if (DECLARED.test(one.head) && !HIDDEN.test(one.attributes)) all.add(`${own}: ${one.head}`);
  }
  const [file, text] = [join(root, "tests", "api", "rust.txt"), `${[...all].sort().join("\n")}\n`];
  if (process.env.PLANARIUM_BLESS) writeFileSync(file, text);
  assert.ok(all.size > 500);
  assert.equal(readFileSync(file, "utf8"), text, "tests/api/rust.txt is out of date: PLANARIUM_BLESS=1 writes it anew");
});
