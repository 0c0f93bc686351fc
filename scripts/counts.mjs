/** The numbers of passed and failed tests, parsed from the output of test programs. */

/** @typedef {{ passed: number, failed: number }} Counts */

/**
 * The sum over every `test result:` line; the harnesses of cargo and wasm-bindgen print one per test program.
 * @param {string} output
 * @returns {Counts | undefined} undefined if there is no such line
 */
export function countsOfHarness(output) {
  const results = [...output.matchAll(/^test result: \w+\. (\d+) passed; (\d+) failed;/gm)];
  if (results.length === 0) return undefined;
  return results.reduce(
    (sum, [, passed, failed]) => ({ passed: sum.passed + Number(passed), failed: sum.failed + Number(failed) }),
    { passed: 0, failed: 0 },
  );
}

/**
 * The totals at the end of a report in TAP, as Node's test runner writes it. Cancelled tests count as failed.
 * @param {string} tap
 * @returns {Counts | undefined} undefined if the totals are missing
 */
export function countsOfTap(tap) {
  const [passed, failed, cancelled] = ["pass", "fail", "cancelled"].map(
    (word) => tap.match(new RegExp(`^# ${word} (\\d+)$`, "m"))?.[1],
  );
  if (passed === undefined || failed === undefined || cancelled === undefined) return undefined;
  return { passed: Number(passed), failed: Number(failed) + Number(cancelled) };
}
