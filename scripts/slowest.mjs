/** A reporter of Node's test runner: where the time went, by files and by tests that have no subtests. */

const FILES = 12;
const TESTS = 20;

/** @param {AsyncIterable<import("node:test/reporters").TestEvent>} events */
export default async function* slowest(events) {
  /** @type {Map<string, { seconds: number, tests: number }>} */
  const files = new Map();
  /** @type {{ name: string, seconds: number }[]} */
  const tests = [];
  /** The nesting of the last test of each file: a test that has subtests ends after the last of them. */
  const nesting = new Map();
  for await (const { type, data } of events) {
    if (type !== "test:pass" && type !== "test:fail") continue;
    const seconds = data.details.duration_ms / 1000;
    const file = data.file?.split(/[\\/]/).at(-1) ?? "?";
    const hasParts = (nesting.get(file) ?? 0) > data.nesting;
    nesting.set(file, data.nesting);
    if (!hasParts) tests.push({ name: `${file}: ${data.name}`, seconds });
    if (data.nesting > 0) continue;
    const { seconds: sum, tests: count } = files.get(file) ?? { seconds: 0, tests: 0 };
    files.set(file, { seconds: sum + seconds, tests: count + 1 });
  }
  const sums = [...files].map(([file, { seconds, tests: count }]) => ({ name: `${file}, ${count} tests`, seconds }));
  const all = sums.reduce((sum, { seconds }) => sum + seconds, 0);
  yield `\n${row({ name: `in the tests of ${files.size} files`, seconds: all })}`;
  for (const [list, length] of /** @type {const} */ ([
    [sums, FILES],
    [tests, TESTS],
  ])) {
    const longest = list.sort((a, b) => b.seconds - a.seconds).slice(0, length);
    yield `\n${longest.map(row).join("")}`;
  }
}

/** @param {{ name: string, seconds: number }} one */
const row = ({ name, seconds }) => `${seconds.toFixed(1).padStart(7)} s  ${name}\n`;
