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
 * Options by their names in JavaScript: the golden files have those of documents.
 * @template {object} O
 * @param {O} options
 * @returns {O}
 */
function inCamelCase(options) {
  return /** @type {O} */ (Object.fromEntries(Object.entries(options).map(([name, value]) => [name.replace(/_(.)/g, (_, letter) => letter.toUpperCase()), value])));
}

/**
 * What each case comes to.
 * @param {Pick<typeof import("planarium"), "Scenario">} planarium
 * @param {Case[]} cases
 * @param {Record<string, string>} scenes  their texts by name
 */
export function outcomes({ Scenario }, cases, scenes) {
  return cases.map(({ scene = "", generate, options, planner: algorithm, seed, parameters }) => {
    const scenario = generate === undefined ? Scenario.parse(scenes[scene]) : Scenario.generate(generate, options);
    const planner = scenario.planner(/** @type {import("planarium").PlannerOptions} */ ({ algorithm, seed, ...inCamelCase(parameters) }));
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
    const trajectories = new Trajectories({ ...inCamelCase(options), seed });
    while (trajectories.step(100) === "running");
    const result = trajectories.result();
    trajectories.free();
    return result;
  });
}

/** How many times the hand moves on its way to the target. */
const MOVES = 20;

/**
 * @typedef {object} ReachCase
 * @property {object} [scenario]  its document
 * @property {import("planarium").GeneratorId} [generate]
 * @property {Record<string, number | string>} [options]  of the generator
 * @property {import("planarium").ReachOptions} reach
 * @property {object} outcome
 */

/**
 * What each case of inverse kinematics comes to: the run, how near the arm can come, and where it is when it has followed a hand.
 * @param {Pick<typeof import("planarium"), "Scenario">} planarium
 * @param {ReachCase[]} cases
 */
export function reachOutcomes({ Scenario }, cases) {
  return cases.map(({ scenario: document, generate, options, reach }) => {
    const scenario = generate === undefined ? Scenario.parse(/** @type {import("planarium").ScenarioDocument} */ (document)) : Scenario.generate(generate, options);
    const { target: [x, y], orientation } = reach;
    const run = scenario.reach(inCamelCase(reach));
    let q = run.configuration();
    while (run.step(100) === "running");
    const { status, verdict: { verdict }, stats: { iterations }, solutions, rejected, fingerprint } = run.result();
    const nearest = scenario.nearestReachable([x, y], orientation);
    const from = scenario.endEffector(q);
    let distance = 0;
    for (let step = 1; step <= MOVES; step += 1) {
      const part = step / MOVES;
      const moved = scenario.follow(q, [from[0] + (x - from[0]) * part, from[1] + (y - from[1]) * part], orientation);
      q = moved.configuration;
      distance = moved.distance;
    }
    run.free();
    scenario.free();
    return {
      status, verdict, iterations, solutions: solutions.length, rejected: rejected.length, fingerprint,
      nearest: { configuration: [...nearest.configuration], distance: nearest.distance },
      followed: { configuration: [...q], distance },
    };
  });
}
