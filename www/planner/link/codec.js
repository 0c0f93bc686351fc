/**
 * A link stores an experiment, everything that a run needs, in the fragment of an address.
 *
 * The fragment is a version digit and base64url of raw deflate (RFC 1951, RFC 4648) of JSON. It is checked entry by entry, is never
 * evaluated, and unpacks to 1 MB at most.
 *
 * @import { PaneKind, ViewOptions } from "../../domain/types.js"
 *
 * @typedef {import("../../domain/types.js").Settings} Settings
 * @typedef {Partial<ViewOptions> & { projector?: boolean, lens?: PaneKind }} View   absent options are off, and the lens is the workspace
 *
 * @typedef {object} Experiment
 * @property {1} version
 * @property {string} [scene]     a built-in scene; absent where there is a document
 * @property {Record<string, unknown>} [document]  a scenario from a file
 * @property {string} [query]
 * @property {{ algorithm: string, settings: Settings }[]} lanes  1 to 4
 * @property {number} iteration   a whole number from 0
 * @property {View} view
 * @property {Settings} [options]  of the scene
 */
import { decodeFragment, encodeFragment } from "../../formats/fragment.js";
import { flag, json, list, must, name, record, rule, settings, text, whole } from "../../formats/rules.js";

const LIMITS = { characters: 65535, bytes: 1 << 20 };

const experimentRule = record({
  version: rule((value) => value === 1),
  scene: name,
  document: record({}, json(16)),
  // Names of queries are free text in a scenario; they are only compared.
  query: text,
  lanes: list(record({ algorithm: name, settings }), 1, 4),
  iteration: whole(Number.MAX_SAFE_INTEGER),
  view: record({
    axes: list(whole(63), 2, 2), refused: flag, strobe: flag, poses: whole(99), raw: flag, slice: flag, projector: flag,
    lens: rule((value) => value === "workspace" || value === "cspace"),
  }),
  options: settings,
});

/** Throws a fault unless a value is an experiment; entries with defaults may be absent. @param {unknown} value @returns {asserts value is Partial<Experiment> & Pick<Experiment, "lanes">} */
function requireExperiment(value) {
  experimentRule(value, "experiment");
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
 * @returns {Promise<{ experiment: Experiment, fault: null } | { experiment: null, fault: string }>}  never rejects; `fault` is a sentence for people
 */
export async function decodeLink(fragment) {
  const { value, fault } = await decodeFragment(fragment, LIMITS, requireExperiment);
  if (fault) return { experiment: null, fault };
  const read = /** @type {Partial<Experiment> & Pick<Experiment, "lanes">} */ (value);
  const lanes = read.lanes.map((lane) => ({ ...lane, settings: lane.settings ?? {} }));
  return { experiment: { iteration: 0, view: {}, ...read, version: 1, lanes }, fault: null };
}
