/**
 * The state that a link stores. A policy is too long for one: that of a training is trained again, and one from a file
 * is left out.
 */
import { json, list, name, number, oneOf, record, settings, whole, withDefaults } from "../formats/rules.js";
import { FIRST, WAYS, noSettings } from "./session.js";

/** @import { NavigationDocument, NavigationGeneratorId } from "planarium/full" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { Lesson } from "./lesson.js" */
/** @import { NavigationSession, Origin, Part, Source } from "./session.js" */

export const stateRule = withDefaults(
  {
    part: oneOf(/** @type {Part[]} */ (["train", "plan", "compare"])),
    // A document, or a generator and its options.
    document: /** @type {Rule<NavigationDocument>} */ (record({}, json(16))),
    kind: /** @type {Rule<NavigationGeneratorId>} */ (name),
    options: settings,
    start: list(number, 3, 3),
    goal: list(number, 2, 2),
    // The options of the training, and the generations that were trained; whose policy is used.
    train: settings,
    generations: whole(100_000),
    policy: oneOf(/** @type {Origin[]} */ (["shipped", "trained", "file"])),
    // The way that is shown with its options, whether it was planned for, and how often it was driven.
    way: oneOf(WAYS),
    given: settings,
    planned: whole(1),
    trials: whole(200, 1),
    driven: whole(1),
    selected: whole(199),
    time: number,
    // The options of the comparison, and its executions.
    compare: settings,
    executions: whole(3_000_000),
    // A step of the lesson, from 1.
    step: whole(5),
  },
  {
    part: "plan",
    ...FIRST,
    train: {},
    generations: 0,
    policy: "shipped",
    way: "prm-rl",
    given: {},
    planned: 0,
    trials: 20,
    driven: 0,
    selected: 0,
    time: 0,
    compare: {},
    executions: 0,
    step: 0,
  },
);

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */

/** @param {NavigationSession} session @param {Lesson} lesson @returns {State} */
export function stateOf(
  { part, source, document, start, goal, training, origin, way, given, run, trials, selected, time, comparison },
  lesson,
) {
  return {
    .../** @type {any} */ (stateRule.defaults),
    part,
    ...("kind" in source ? { kind: source.kind, options: source.options } : { document: document ?? undefined }),
    start: [...start],
    goal: [...goal],
    train: training.given,
    generations: training.generation,
    policy: origin,
    way,
    given: way === "policy" ? {} : given[way],
    planned: Number(run.status !== "none"),
    trials,
    driven: Number(run.drives.length > 0),
    selected,
    time: Number(time.toFixed(3)),
    compare: comparison.given,
    executions: comparison.executions.length,
    step: lesson.step,
  };
}

/**
 * @param {NavigationSession} session
 * @param {Lesson} lesson
 * @param {State} state
 * @param {AbortSignal} [signal]   something else is opened meanwhile
 * @throws {Error} the core refuses it
 */
export async function openState(
  session,
  lesson,
  {
    part,
    document,
    kind,
    options,
    start,
    goal,
    train,
    generations,
    policy,
    way,
    given,
    planned,
    trials,
    driven,
    selected,
    time,
    compare,
    executions,
    step,
  },
  signal,
) {
  const { training, comparison } = session;
  const source = /** @type {Source} */ (document ? { document } : { kind, options });
  if (step > 0) lesson.leave();
  session.open(source, { start, goal });
  const { document: own } = session;
  // Something else may be opened while the link's training, plan or drives are made.
  const isLeft = () => signal?.aborted || session.document !== own;
  session.usePolicy(session.shipped, "shipped");
  session.setPart(part);
  session.given = noSettings();
  if (way !== "policy") session.given[way] = given;
  Object.assign(session, { trials });
  session.setWay(way);
  training.given = train;
  comparison.given = compare;
  training.clear();
  if (part === "train" || generations > 0) {
    await training.begin();
    if (isLeft()) return;
    await training.run(generations);
    if (isLeft()) return;
  }
  if (policy === "trained" && training.policy) session.usePolicy(training.policy, "trained");
  if (planned) await session.plan(true);
  if (isLeft()) return;
  if (driven) {
    await session.drive(true);
    if (isLeft()) return;
    session.setTime(time);
    session.select({ selected: Math.min(selected, trials - 1) });
  }
  if (executions > 0) await comparison.run(executions);
  if (step > 0 && !isLeft()) await lesson.put(step);
}
