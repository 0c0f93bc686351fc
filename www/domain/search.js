/**
 * The first index in a range at which a condition holds, found by bisection; `high` where it holds at none.
 * @param {number} low
 * @param {number} high  exclusive
 * @param {(index: number) => boolean} holds  once it holds, it holds at all higher indices
 */
export function firstIndex(low, high, holds) {
  while (low < high) {
    const middle = (low + high) >> 1;
    if (holds(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}
