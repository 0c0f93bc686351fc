/**
 * The commands of this page, which its workers run: a training, a roadmap that grows and what is driven along its path,
 * and a comparison. Only the newest of each counts.
 */
import { Navigation, eventKinds } from "planarium/full";
import { PlannerHost } from "../../dist/package/planner-host.js";
import { withOptions } from "../domain/option-names.js";

/**
 * @import { EdgeRollouts, Execution, ExecutionOptions, NavigationComparison, NavigationComparisonOptions,
 *   NavigationDocument, NavigationMethod, PolicyDocument, PolicyPlannerOptions, Training, TrainingOptions }
 *   from "planarium/full"
 */
/** @import { Settings } from "../domain/types.js" */

/**
 * How a goal is driven to, one start and goal at a time: a margin is an option there.
 * @typedef {Exclude<NavigationMethod, "straight-margin" | "straight-margin-policy">} Way
 */
/** Those with a roadmap. @typedef {Exclude<Way, "policy">} PlannedWay */

/** Milliseconds of a call, about. */
const SLICE = 24;

/** @type {Training | null} */
let training = null;
/**
 * @type {{ task: Navigation, host: PlannerHost, rollouts: ((path: number[][]) => EdgeRollouts[]) | null } | null}
 */
let plan = null;
/** @type {{ comparison: NavigationComparison, rows: number } | null} */
let compared = null;

/**
 * Calls with a task that lives no longer.
 * @template T
 * @param {NavigationDocument | string} document
 * @param {(task: Navigation) => T} use
 */
function withTask(document, use) {
  const task = Navigation.parse(document);
  try {
    return use(task);
  } finally {
    task.free();
  }
}

/** @returns {Training} */
function trained() {
  if (!training) throw new Error("No training has begun.");
  return training;
}

export const commands = {
  /**
   * Begins a training for the robot of a task.
   * @param {NavigationDocument} document
   * @param {Settings} settings
   * @throws {Error} they are refused, and nothing changes
   */
  beginTraining(document, settings) {
    const begun = withTask(document, (task) =>
      withOptions(settings, (/** @type {TrainingOptions} */ options) => task.training(options)),
    );
    training?.free();
    training = begun;
    return { candidates: begun.candidates, generations: begun.generations };
  },

  /**
   * The returns of some candidates, after generations that were ended elsewhere.
   * @param {number} first
   * @param {number} end
   * @param {Float64Array[]} ended  their returns
   */
  returnsOf(first, end, ended) {
    for (const returns of ended) trained().advance(returns);
    return trained().returnsOf(first, end);
  },

  /**
   * Ends generations with their returns.
   * @param {Float64Array[]} ended
   * @param {number} known  generations whose rows of history the caller has
   */
  advance(ended, known) {
    const run = trained();
    for (const returns of ended) run.advance(returns);
    const { generation, fingerprint } = run;
    return {
      generation,
      fingerprint,
      history: run.historySince(known),
      demonstrations: run.demonstrations(DEMONSTRATIONS),
      policy: run.policy(),
    };
  },

  /** Drives of the policy at the beginning, and the floors that they are on. */
  demonstrate() {
    const run = trained();
    const demonstrations = run.demonstrations(DEMONSTRATIONS);
    return { demonstrations, floors: demonstrations.map(({ floor }) => run.floor(floor)), policy: run.policy() };
  },

  /**
   * Begins a roadmap.
   * @param {NavigationDocument} document  with one query
   * @param {PolicyDocument} policy
   * @param {PlannedWay} way
   * @param {Settings} settings
   * @throws {Error} they are refused, and nothing changes
   */
  beginPlan(document, policy, way, settings) {
    const task = Navigation.parse(document);
    try {
      const planner = withOptions(settings, (/** @type {PolicyPlannerOptions} */ options) =>
        way === "prm-rl" ? task.planner(policy, options) : task.straightPlanner(options),
      );
      const rollouts =
        way !== "prm-rl"
          ? null
          : (/** @type {number[][]} */ path) =>
              withOptions(settings, (/** @type {PolicyPlannerOptions} */ options) =>
                task.edgeRollouts(policy, path.flat(), options),
              );
      plan?.host.free();
      plan?.task.free();
      plan = { task, host: new PlannerHost(planner), rollouts };
    } catch (error) {
      task.free();
      throw error;
    }
  },

  /** Lets the roadmap grow for a moment, or to its end. @param {boolean} isWhole */
  advancePlan(isWhole) {
    if (!plan) throw new Error("No plan has begun.");
    const { planner } = plan.host;
    if (isWhole) planner.step(Number.MAX_SAFE_INTEGER);
    else planner.stepFor(SLICE);
    const { status, iterations, vertices, edges, events, result } = plan.host.grown();
    return { status, iterations, vertices, edges, refused: refusedOf(events, planner.eventWidth), result };
  },

  /** All rollouts along a path of the roadmap. @param {number[][]} path */
  rollouts(path) {
    return path.length > 1 ? (plan?.rollouts?.(path) ?? null) : null;
  },

  /**
   * Drives along a path several times, each with noise of its own.
   * @param {NavigationDocument} document  with one query
   * @param {PolicyDocument | null} policy  null: by a controller that does not use its rays
   * @param {number[][]} path @param {number} seed @param {number} trials
   * @returns {Execution[]}
   */
  drive(document, policy, path, seed, trials) {
    return withTask(document, (task) =>
      Array.from({ length: trials }, (_, trial) => {
        const options = /** @type {ExecutionOptions} */ ({ seed, trial, ...(policy && { policy }) });
        return task.execute(path.flat(), options);
      }),
    );
  },

  /**
   * Begins a comparison of the methods.
   * @param {NavigationDocument} document
   * @param {PolicyDocument} policy
   * @param {Settings} settings
   * @throws {Error} they are refused, and nothing changes
   */
  beginComparison(document, policy, settings) {
    const comparison = withTask(document, (task) =>
      withOptions(settings, (/** @type {NavigationComparisonOptions} */ options) => task.comparison(policy, options)),
    );
    compared?.comparison.free();
    compared = { comparison, rows: 0 };
    return { count: comparison.count, queries: comparison.queries() };
  },

  /** Goes on with the comparison for a moment. */
  advanceComparison() {
    if (!compared) throw new Error("No comparison has begun.");
    const { comparison, rows } = compared;
    const status = comparison.stepFor(2 * SLICE);
    compared.rows = comparison.executionCount;
    return {
      status,
      iterations: comparison.iterations,
      executions: comparison.executionsSince(rows),
      summary: comparison.summary(),
    };
  },
};

/** The edges of a roadmap that were refused, two vertices each. @param {Float64Array} events @param {number} width */
function refusedOf(events, width) {
  const refused = eventKinds.indexOf("refused");
  return Array.from({ length: events.length / width }, (_, i) => events.subarray(i * width, i * width + 4)).flatMap(
    ([kind, , from, to]) => (kind === refused && to >= 0 ? [from, to] : []),
  );
}

/** Drives that show what a policy in training can do. */
const DEMONSTRATIONS = 12;

/** @typedef {typeof commands} Commands */
/** @typedef {ReturnType<Commands["advance"]>} Generation */

export function reset() {
  training = plan = compared = null;
}
