/** The golden cases, by the package: the files that the crate's own tests check too. Runs in Node and in browsers. */

/** How many times the hand moves on its way to the target. */
const MOVES = 20;

/**
 * Options by their names in JavaScript, from their names in documents.
 * @param {Record<string, unknown>} options
 * @returns {any}
 */
function inCamelCase(options) {
  const renamed = Object.entries(options).map(([name, value]) => [
    name.replace(/_(.)/g, (_, letter) => letter.toUpperCase()),
    value,
  ]);
  return Object.fromEntries(renamed);
}

/**
 * The outcomes of all cases, in the order of the files.
 * @param {Pick<typeof import("planarium/full"), "Problem" | "Scenario" | "Trajectories">} planarium
 * @param {Record<"plans" | "neighbours" | "trajectories" | "reaches" | "certificates" | "customs" | "timings", any[]> & { scenes:
 *   Record<string, string> }} cases as stored in their files, and the scenes' texts by name
 */
export function outcomes(
  { Problem, Scenario, Trajectories },
  { plans, neighbours, trajectories, reaches, certificates, customs, timings, scenes },
) {
  /** @param {any} given */
  const opened = ({ scene, scenario = scenes[scene], generate, options }) =>
    generate ? Scenario.generate(generate, options) : Scenario.parse(scenario);
  return [
    plans.map((given) => planned(opened(given), given)),
    neighbours.map((given) => nearest(opened(given), given)),
    trajectories.map(({ options, seed }) => tried(new Trajectories({ ...inCamelCase(options), seed }))),
    reaches.map((given) => reached(opened(given), given)),
    certificates.map((given) => certified(opened(given), given)),
    customs.map((given) => custom(new Problem(twoDiscs(given.free)), given)),
    timings.map(({ outcome }) => timed(Scenario.parse(outcome.scenario), outcome)),
  ];
}

/** What was timed, and how. @param {any} scenario of the core that has all @param {any} given */
function timed(scenario, given) {
  const { type: _type, ...limits } = given.limits;
  const trajectory = scenario.time(given.result, inCamelCase(limits), { verify: false });
  const states = [0.3, 0.8].map((share) => trajectory.state(share * trajectory.duration));
  const plain = states.map(({ time, configuration, velocity, acceleration }) => ({
    time,
    configuration: [...configuration],
    velocity: [...velocity],
    acceleration: [...acceleration],
  }));
  const { duration } = trajectory;
  trajectory.free();
  scenario.free();
  return { ...given, duration, states: plain };
}

/** @param {import("planarium/full").Scenario} scenario @param {any} given */
function planned(scenario, { planner: algorithm, seed, parameters }) {
  const planner = scenario.planner({ algorithm, seed, ...inCamelCase(parameters) });
  while (planner.step(1000) === "running");
  const { status, fingerprint, length, blended_length, path, stats } = planner.result();
  planner.free();
  scenario.free();
  return {
    status,
    fingerprint,
    length,
    ...(blended_length !== undefined && { blended_length }),
    waypoints: path.length,
    clearance_evaluations: stats.clearance_evaluations,
  };
}

const RADIUS = 0.3;
const OBSTACLES = [
  [2, 2, 0.5],
  [1, 3.3, 0.2],
  [3.1, 0.9, 0.25],
];

/**
 * The clearance of two discs among round obstacles, and of each other.
 * @param {Float64Array} rows
 * @param {number} at
 */
function clearanceOfDiscs(rows, at) {
  const distance = (/** @type {number} */ x, /** @type {number} */ y) => Math.sqrt(x * x + y * y);
  let clearance = distance(rows[at] - rows[at + 2], rows[at + 1] - rows[at + 3]) - RADIUS - RADIUS;
  for (const [x, y, radius] of OBSTACLES) {
    for (const disc of [at, at + 2])
      clearance = Math.min(clearance, distance(rows[disc] - x, rows[disc + 1] - y) - radius - RADIUS);
  }
  return clearance;
}

/**
 * Two discs that change places: the problem of the crate's own tests.
 * @param {"clearance" | "samples"} free
 * @returns {import("planarium/full").ProblemDescription}
 */
export function twoDiscs(free) {
  const side = { kind: /** @type {const} */ ("interval"), low: RADIUS, high: 4 - RADIUS };
  const description = {
    space: { coordinates: [side, side, side, side] },
    start: [0.7, 2, 3.3, 2],
    goal: [3.3, 2, 0.7, 2],
  };
  if (free === "clearance") {
    return {
      ...description,
      reach: [1, 1, 1, 1],
      clearance(rows, clearances) {
        clearances.forEach((_, i) => {
          clearances[i] = clearanceOfDiscs(rows, 4 * i);
        });
      },
    };
  }
  return {
    ...description,
    resolution: 0.05,
    isFree(rows, out) {
      out.forEach((_, i) => {
        out[i] = Number(clearanceOfDiscs(rows, 4 * i) > 0);
      });
    },
  };
}

/** @param {import("planarium/full").Problem} problem @param {any} given */
function custom(problem, { planner: algorithm, seed, parameters }) {
  const planner = problem.planner({ algorithm, seed, ...inCamelCase(parameters) });
  while (planner.step(100) === "running");
  const { status, fingerprint, length, stats } = planner.result();
  planner.free();
  problem.free();
  return { status, fingerprint, length, clearance_evaluations: stats.clearance_evaluations };
}

/** @param {import("planarium/full").Scenario} scenario @param {any} given   `radius` in place of `k` */
function nearest(scenario, { index, parameters, samples, seed, free, target, k, radius }) {
  const held = scenario.neighbours({ index, ...parameters });
  held.add(scenario.sampleConfigurations(samples, { seed, free }));
  const { indices, distances, visited } = radius === undefined ? held.nearest(target, k) : held.within(target, radius);
  held.free();
  scenario.free();
  return { distances: [...distances], indices: [...indices], visited: index === "kd-tree" ? null : visited };
}

/** @param {import("planarium/full").Trajectories} trajectories */
function tried(trajectories) {
  while (trajectories.step(100) === "running");
  const result = trajectories.result();
  trajectories.free();
  return result;
}

/**
 * A run, the nearest reachable point, and an arm that follows a hand.
 * @param {import("planarium/full").Scenario} scenario
 * @param {any} given
 */
function reached(scenario, { reach }) {
  const {
    target: [x, y],
    orientation,
  } = reach;
  const run = scenario.reach(inCamelCase(reach));
  let q = run.configuration();
  while (run.step(100) === "running");
  const {
    status,
    verdict: { verdict },
    stats: { iterations },
    solutions,
    rejected,
    fingerprint,
  } = run.result();
  const { configuration, distance: away } = scenario.nearestReachable([x, y], orientation);
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
    status,
    verdict,
    iterations,
    solutions: solutions.length,
    rejected: rejected.length,
    fingerprint,
    nearest: { configuration: [...configuration], distance: away },
    followed: { configuration: [...q], distance },
  };
}

/** @param {import("planarium/full").Scenario} scenario @param {any} given */
function certified(scenario, { clearance }) {
  const subdivision = scenario.certify({ clearance, cells: 3000 });
  while (subdivision.step(10) === "running");
  const { verdict, clearance_at_most = null, cells, wall, channel } = subdivision.certificate();
  const kinds = subdivision.cellsSince(0).filter((_, i) => i % 5 === 4);
  subdivision.free();
  scenario.free();
  return {
    verdict,
    clearance_at_most,
    cells,
    blocked: kinds.filter((kind) => kind === 2).length,
    wall: wall.length,
    channel: channel.length,
  };
}
