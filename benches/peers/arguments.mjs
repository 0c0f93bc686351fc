/** Options of the benchmarks, and the tables that they write. */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Problem, root } from "../../scripts/run.mjs";

/** The integer value of an option. @param {string} name @param {string} text @param {number} least */
export function integer(name, text, least) {
  const value = Number(text);
  if (!Number.isInteger(value) || value < least)
    throw new Problem(`--${name} must be an integer of at least ${least}, not ${text}.`);
  return value;
}

/** Writes tables between two marks of a page in docs. @param {string} mark @param {string} tables @param {string} [page] */
export function update(mark, tables, page = "benchmarks.md") {
  const file = join(root, "docs", page);
  const text = readFileSync(file, "utf8");
  const [start, end] = [`<!-- ${mark} -->\n`, `<!-- /${mark} -->`];
  const [from, to] = [text.indexOf(start), text.indexOf(end)];
  if (from < 0 || to < from) throw new Problem(`docs/${page} has no marks ${start.trim()} and ${end}.`);
  writeFileSync(file, `${text.slice(0, from + start.length)}${tables}${text.slice(to)}`);
}
