/**
 * A link stores an experiment, everything that a run needs, in the fragment of an address.
 *
 * The fragment is a version digit and base64url of raw deflate (RFC 1951, RFC 4648) of JSON. It is checked entry by
 * entry, is never evaluated, and unpacks to 1 MB at most.
 */
import { decodeFragment, encodeFragment } from "../../formats/fragment.js";
import {
  flag,
  formed,
  json,
  list,
  must,
  name,
  number,
  oneOf,
  record,
  rule,
  settings,
  text,
  whole,
  withDefaults,
} from "../../formats/rules.js";
import { EULER_STEPS } from "../../domain/euler-steps.js";
import { KEY_TEXT } from "../../domain/key-text.js";

/** @import { Allowed, Rule } from "../../formats/rules.js" */
/** @import { Plan } from "../../domain/types.js" */
/** @typedef {import("../../domain/types.js").Settings} Settings */
/** @typedef {Omit<Allowed<typeof experimentRule>, "lanes"> & { lanes: Plan[] }} Experiment */
/** @typedef {Experiment["view"]} View   absent options are off, and the lens is the workspace */

const LIMITS = { characters: 65535, bytes: 1 << 20 };
/** Steps of a drive, and characters of its keys, at most. */
const DRIVE = { steps: 1_000_000, keys: 65_535 };

/** A limit of a trajectory, as the core allows it. @type {Rule<number>} */
const limit = rule((value) => typeof value === "number" && value >= 1e-6 && value <= 1e9);

/** How much longer ways over a route graph may be, as the core allows it. @type {Rule<number>} */
const detour = rule((value) => typeof value === "number" && value >= 1 && value <= 100);

const experimentRule = withDefaults(
  {
    version: /** @type {Rule<1>} */ (rule((value) => value === 1)),
    // A built-in scene, or a scenario from a file.
    scene: name,
    document: /** @type {Rule<Record<string, unknown>>} */ (record({}, json(16))),
    // Names of queries are free text in a scenario; they are only compared.
    query: text,
    lanes: list(record({ algorithm: name, settings }), 1, 4),
    iteration: whole(Number.MAX_SAFE_INTEGER),
    view: record({
      axes: list(whole(63), 2, 2),
      refused: flag,
      strobe: flag,
      poses: whole(99),
      raw: flag,
      slice: flag,
      optimum: flag,
      regions: flag,
      widest: flag,
      safest: flag,
      routes: flag,
      detour,
      projector: flag,
      lens: oneOf(/** @type {const} */ (["workspace", "cspace"])),
    }),
    // What generates the scene, and iterations a second where they differ from the built-in scene's.
    options: settings,
    pace: whole(1000, 1),
    // The configuration in hand. Or a car that is driven: from the start of the query unless another one is given, keys
    // as `keyText` writes them, and the steps made; then one control, v, phi and seconds, whose motion is shown. Beside
    // the exact arc Euler's path, with a step in seconds.
    pose: list(number, 1, 64),
    drive: record({ start: list(number, 3, 3), keys: formed(KEY_TEXT, DRIVE.keys), steps: whole(DRIVE.steps) }),
    roll: /** @type {Rule<[number, number, number]>} */ (list(number, 3, 3)),
    euler: oneOf(EULER_STEPS),
    // The limits by which paths are timed, where they are not those that the page chooses, and how fast the robot is
    // shown. Absent while nothing is timed.
    timing: record({
      speed: limit,
      acceleration: limit,
      turn_rate: limit,
      turn_acceleration: limit,
      lateral_acceleration: limit,
      // A disc turns on the spot and drives along its heading.
      differential: flag,
      pace: oneOf(/** @type {const} */ ([0.5, 2])),
    }),
  },
  { version: /** @type {const} */ (1), iteration: 0, view: {} },
);

/** Throws a fault unless a value is a part of an experiment. @param {unknown} value */
export function requirePart(value) {
  experimentRule(value, "experiment");
}

/** Throws a fault unless a value is an experiment; entries with defaults may be absent. @param {unknown} value */
export function requireExperiment(value) {
  requirePart(value);
  const { scene, document, lanes } = /** @type {Partial<Experiment>} */ (value);
  must((scene || document) && lanes?.every((lane) => lane.algorithm), "it lacks a scene or an algorithm");
}

/** The options that are on; undefined where none is. @param {object} view */
function viewOf(view) {
  const entries = Object.entries(view).filter(([, entry]) => entry && entry !== "workspace");
  return entries.length > 0 ? Object.fromEntries(entries) : undefined;
}

/**
 * @param {Experiment} experiment
 * @returns {Promise<string>}  the fragment, without `#`: characters of base64url only
 * @throws {Error} where `decodeLink` would refuse it, with the same sentence
 */
export async function encodeLink(experiment) {
  requireExperiment(experiment);
  const { version, iteration, view, ...rest } = experiment;
  return encodeFragment({ ...rest, iteration: iteration || undefined, view: viewOf(view) }, LIMITS);
}

/**
 * @param {string} fragment  with or without `#`
 * @returns {Promise<{ experiment: Experiment, fault: null } | { experiment: null, fault: string }>}  never rejects;
 *   `fault` is a sentence for people
 */
export async function decodeLink(fragment) {
  const { value, fault } = await decodeFragment(fragment, LIMITS, requireExperiment);
  return fault
    ? { experiment: null, fault }
    : { experiment: completed(/** @type {Experiment} */ (value)), fault: null };
}

/** With the entries that a link may leave out. @param {object} experiment @returns {Experiment} */
export function completed(experiment) {
  const all = { ...experimentRule.defaults, .../** @type {Experiment} */ (experiment) };
  return { ...all, lanes: all.lanes.map((lane) => ({ ...lane, settings: lane.settings ?? {} })) };
}
