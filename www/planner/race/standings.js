/** Who leads a race. Lanes are known by letters: A is the planner of the panel, B to D are its rivals. */

/**
 * @typedef {object} Standing   how one planner stands at the time that is shown
 * @property {boolean} isOver
 * @property {number | null} found   clearance evaluations until it first had a path
 * @property {number} cost           length of its best path so far, Infinity while it has none
 * @property {string} metric         in which that is measured
 */

/** @param {number} lane */
export const letter = (lane) => "ABCD"[lane];

/** @param {number[]} lanes */
export function letters(lanes) {
  const names = lanes.map(letter);
  return names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names[names.length - 1]}`;
}

/**
 * Since all get the same number of evaluations, whoever is first at one time stays first. The shortest path is only told of
 * at least two, and only where all are measured alike.
 * @param {Standing[]} standings
 * @returns {{ first: number[], shortest: number[], isOver: boolean, isAlike: boolean }} places of the leaders, several where they are level
 */
export function leaders(standings) {
  const isAlike = new Set(standings.map(({ metric }) => metric)).size === 1;
  const finders = standings.filter(({ found }) => found !== null);
  const least = Math.min(...finders.map(({ found }) => found ?? Infinity));
  const cost = isAlike && finders.length > 1 ? Math.min(...finders.map((one) => one.cost)) : NaN;
  return {
    first: standings.flatMap(({ found }, i) => (found === least ? [i] : [])),
    shortest: standings.flatMap((one, i) => (one.cost === cost ? [i] : [])),
    isOver: standings.every((one) => one.isOver),
    isAlike,
  };
}
