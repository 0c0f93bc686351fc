/** The golden cases, by the package: the file that the crate's own tests hold too. Runs in Node and in browsers. */

/**
 * @typedef {object} Case
 * @property {string} [scene]  one of the page's scenes
 * @property {import("planarium").GeneratorId} [generate]
 * @property {Record<string, number>} [options]  of the generator
 * @property {string} planner
 * @property {number} seed
 * @property {Record<string, number | string | boolean>} parameters
 * @property {object} outcome
 */

/**
 * What each case comes to.
 * @param {Pick<typeof import("planarium"), "Scenario">} planarium
 * @param {Case[]} cases
 * @param {Record<string, string>} scenes  their texts by name
 */
export function outcomes({ Scenario }, cases, scenes) {
  return cases.map(({ scene = "", generate, options, planner: algorithm, seed, parameters }) => {
    const scenario = generate === undefined ? Scenario.parse(scenes[scene]) : Scenario.generate(generate, options);
    const planner = scenario.planner({ algorithm, seed, ...parameters });
    while (planner.step(1000) === "running");
    const { status, fingerprint, length, path, stats } = planner.result();
    planner.free();
    scenario.free();
    return { status, fingerprint, length, waypoints: path.length, clearance_evaluations: stats.clearance_evaluations };
  });
}

/**
 * @typedef {object} TrajectoryCase
 * @property {import("planarium").TrajectoryOptions} options
 * @property {number} seed
 * @property {import("planarium").TrajectoriesResult} outcome
 */

/**
 * The same of many trajectories.
 * @param {Pick<typeof import("planarium"), "Trajectories">} planarium
 * @param {TrajectoryCase[]} cases
 */
export function trajectoryOutcomes({ Trajectories }, cases) {
  return cases.map(({ options, seed }) => {
    const trajectories = new Trajectories({ ...options, seed });
    while (trajectories.step(100) === "running");
    const result = trajectories.result();
    trajectories.free();
    return result;
  });
}
