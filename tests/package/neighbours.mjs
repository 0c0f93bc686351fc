/** The golden neighbours, by the package: the file that the crate's own tests hold too. Runs in Node and in browsers. */

/**
 * @typedef {object} Case
 * @property {string} scene  one of the page's scenes
 * @property {import("planarium").IndexInfo["id"]} index
 * @property {Record<string, number | string>} parameters
 * @property {number} samples
 * @property {number} seed
 * @property {boolean} free
 * @property {number[]} target
 * @property {number} [k]
 * @property {number} [radius]  in place of k
 * @property {object} outcome
 */

/**
 * What each case comes to.
 * @param {Pick<typeof import("planarium"), "Scenario">} planarium
 * @param {Case[]} cases
 * @param {Record<string, string>} scenes  their texts by name
 */
export function neighboursOf({ Scenario }, cases, scenes) {
  return cases.map(({ scene, index, parameters, samples, seed, free, target, k = 0, radius }) => {
    const scenario = Scenario.parse(scenes[scene]);
    const held = scenario.neighbours({ index, ...parameters });
    held.add(scenario.sampleConfigurations(samples, { seed, free }));
    const { indices, distances, visited } = radius === undefined ? held.nearest(target, k) : held.within(target, radius);
    held.free();
    scenario.free();
    return { distances: [...distances], indices: [...indices], visited: index === "kd-tree" ? null : visited };
  });
}
