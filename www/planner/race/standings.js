/** The leaders of a race. Lanes have letters: A is the planner of the panel, B to D are its rivals. */

/**
 * @typedef {object} Standing   of one planner at the time shown
 * @property {boolean} isOver
 * @property {number | null} found   clearance evaluations until its first path
 * @property {number} cost           of its best path so far, Infinity without a path
 * @property {string} metric         of the cost
 * @property {boolean} isCost        whether obstacles add to lengths
 * @property {boolean} collides      whether its path, which is not proven, is known to touch an obstacle
 */

/** @param {number} lane */
export const letter = (lane) => "ABCD"[lane];

/** @param {number[]} lanes */
export function letters(lanes) {
  const names = lanes.map(letter);
  return names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names[names.length - 1]}`;
}

/**
 * The leaders. All planners get the same number of evaluations, so the first one at one time stays first. The shortest
 * path is one of at least two, in the same metric. A path that collides counts for neither.
 * @param {Standing[]} standings
 * @returns {{ first: number[], shortest: number[], isOver: boolean, isAlike: boolean }} lanes, several where they tie;
 *   `isAlike`: one metric
 */
export function leaders(standings) {
  const isAlike = new Set(standings.map(({ metric }) => metric)).size === 1;
  const finders = standings.filter(({ found, collides }) => found !== null && !collides);
  const least = Math.min(...finders.map(({ found }) => found ?? Infinity));
  const cost = isAlike && finders.length > 1 ? Math.min(...finders.map((one) => one.cost)) : NaN;
  return {
    first: standings.flatMap((one, i) => (finders.includes(one) && one.found === least ? [i] : [])),
    shortest: standings.flatMap((one, i) => (finders.includes(one) && one.cost === cost ? [i] : [])),
    isOver: standings.every((one) => one.isOver),
    isAlike,
  };
}
