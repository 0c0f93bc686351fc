/**
 * The worker of the planner's page: it steps planners and makes pictures that take longer than a frame, so that the
 * page waits for neither.
 */
import * as library from "planarium";
import { serve } from "../../app/worker-server.js";
import { Certifier } from "./certifier.js";
import { compete } from "./compete.js";
import { paintObstacles } from "./obstacles.js";
import { Stepper } from "./stepper.js";
import { drawThumbnail } from "../../draw/thumbnail.js";

/** @import { Look } from "../../app/app.js" */
/** @import { Plan, Scenario, ScenarioDocument, Source } from "../../domain/types.js" */
/** @import { CertifyOptions, OptimumOptions } from "planarium" */
/** @import { Painting } from "./obstacles.js" */
/** @import { Growth } from "./stepper.js" */

/**
 * @typedef {object} Advance   a block to be planned
 * @property {{ document: ScenarioDocument, plans: Plan[] } | null} fresh   new planners in place of those before
 * @property {number} column     the column of their history that is the clock, -1 for iterations
 * @property {number} wanted     the time to reach, as far as one block goes; below 0: none
 * @property {boolean} isResult  with the results, once it has reached that time
 */

/** Milliseconds of planning in a block. */
const BLOCK = 12;

/** @type {Scenario | null} */
let scenario = null;
/** @type {Stepper[]} */
let steppers = [];
/** @type {Certifier | null} */
let certifier = null;

/** @param {NonNullable<Advance["fresh"]>} fresh */
function begin({ document, plans }) {
  for (const stepper of steppers.splice(0)) stepper.free();
  scenario?.free();
  const opened = (scenario = library.Scenario.parse(document));
  steppers = plans.map(({ algorithm, settings }) => new Stepper(opened, algorithm, settings));
}

/** @template T @param {Source} source @param {(scenario: Scenario) => T} then @returns {T} */
function within(source, then) {
  const { Scenario } = library;
  const opened =
    "generate" in source
      ? Scenario.generate(source.generate.kind, source.generate.options)
      : Scenario.parse(/** @type {ScenarioDocument} */ (source.document));
  try {
    return then(opened);
  } finally {
    opened.free();
  }
}

const commands = {
  /** Plans one block. @param {Advance} advance @returns {Growth[]} */
  advance({ fresh, column, wanted, isResult }) {
    if (fresh) begin(fresh);
    const isThere = compete(steppers, column, wanted, performance.now() + BLOCK);
    return steppers.map((stepper) => stepper.growth(isResult && isThere));
  },
  /** Queries the roadmap of the first planner. @param {number[]} start @param {number[]} goal */
  ask: (start, goal) => steppers[0].ask(start, goal),
  /** The shortest path of a query. @param {ScenarioDocument} document @param {OptimumOptions} options */
  optimum: (document, options) => within({ document }, (opened) => opened.optimum(options)),
  /**
   * Begins a subdivision, in place of one before.
   * @param {ScenarioDocument} document
   * @param {CertifyOptions} options
   */
  certify: (document, options) => {
    certifier?.free();
    certifier = within({ document }, (opened) => new Certifier(opened, options));
  },
  /** Divides one block. @param {number} part   of as many cells as there are */
  divide: (part) => /** @type {Certifier} */ (certifier).advance(part, BLOCK),
  /**
   * Repairs the roadmap of the first planner in an edited scenario.
   * @param {ScenarioDocument} document
   * @returns {Growth}
   */
  repair: (document) => steppers[0].reopen(document),
  /** @param {Painting} painting @returns {ImageBitmap} */
  obstacles: (painting) => within({ document: painting.document }, (opened) => paintObstacles(opened, painting)),
  /** @param {Source} source @param {number} side @param {Look} look @returns {ImageBitmap} */
  thumbnail: (source, side, look) => within(source, (opened) => drawThumbnail(opened, side, look)),
};

/** @typedef {import("../../app/worker-client.js").Remote<typeof commands>} PlannerWorker */

// After a panic of the core all its objects are lost.
serve({
  planner: {
    commands,
    reset: () => {
      [scenario, steppers, certifier] = [null, [], null];
    },
  },
});
