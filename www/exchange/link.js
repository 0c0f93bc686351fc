/**
 * A link is an experiment: everything that a run needs, held by the fragment of an address.
 *
 * The fragment is a version digit and base64url of raw deflate (RFC 1951, RFC 4648) of JSON. What comes in is checked entry by
 * entry, is never evaluated, and unpacks to 1 MB at most.
 *
 * @typedef {Record<string, number | string | boolean>} Settings
 *
 * @typedef {object} View   what is shown; what is absent is off, and the lens is on the workspace
 * @property {[number, number]} [axes]  the two coordinates of a configuration that are drawn
 * @property {boolean} [refused]    refused samples and edges
 * @property {boolean} [strobe]     poses along the path
 * @property {number} [poses]       how many, where they are not as many as usual
 * @property {boolean} [raw]        the path before it was improved
 * @property {boolean} [slice]      obstacles on the plane of those two coordinates
 * @property {boolean} [projector]  large type and strong lines
 * @property {"workspace" | "cspace"} [lens]
 *
 * @typedef {object} Experiment
 * @property {1} version
 * @property {string} [scene]     a built-in scene; where it is absent there is a document
 * @property {Record<string, unknown>} [document]  the reader's own scenario
 * @property {string} [query]
 * @property {{ algorithm: string, settings: Settings }[]} lanes  1 to 4
 * @property {number} iteration   a whole number from 0
 * @property {View} view
 * @property {Settings} [options]  of the scene
 */

const MOST_FRAGMENT = 65536;
const MOST_BYTES = 1 << 20;

/** @typedef {(value: unknown, at: string) => void} Rule  throws a fault that names `at` */

class Fault extends Error {}

/** @param {unknown} holds @param {string} fault @returns {asserts holds} */
function must(holds, fault) {
  if (!holds) throw new Fault(`This link does not work: ${fault}.`);
}

/** @param {(value: unknown) => unknown} holds @returns {Rule} */
const rule = (holds) => (value, at) => must(holds(value), `${at} is wrong`);

/** @param {number} most @returns {Rule} */
const whole = (most) => rule((value) => Number.isInteger(value) && Number(value) >= 0 && Number(value) <= most);

/** By such a name nothing is found that was not put there. */
const name = rule((value) => typeof value === "string" && /^[\w-]{1,64}$/.test(value) && value !== "prototype" && !(value in Object.prototype));
const text = rule((value) => typeof value === "string" && value.length <= 256);
const flag = rule((value) => typeof value === "boolean");
const number = rule(Number.isFinite);

/** @param {Rule} item @param {number} least @param {number} most @returns {Rule} */
const list = (item, least, most) => (value, at) => {
  must(Array.isArray(value) && value.length >= least && value.length <= most, `${at} is wrong`);
  value.forEach((entry, i) => item(entry, `${at}.${i}`));
};

/** At most 64 entries; what is undefined is absent. @param {Record<string, Rule>} rules @param {Rule} [others]  of entries without a rule; else there are none @returns {Rule} */
const record = (rules, others) => (value, at) => {
  must(typeof value === "object" && value && !Array.isArray(value), `${at} is wrong`);
  const entries = Object.entries(value).filter(([, entry]) => entry !== undefined);
  must(entries.length <= 64, `${at} is wrong`);
  for (const [key, entry] of entries) {
    const place = `${at}.${key.slice(0, 64)}`;
    name(key, place);
    const each = rules[key] ?? others;
    must(each, `${place} is unknown`);
    each(entry, place);
  }
};

const settings = record({}, (value, at) => (typeof value === "string" ? text : typeof value === "number" ? number : flag)(value, at));

/** Any JSON; what it means is for the package to judge. @param {number} depth  how deep it may be nested @returns {Rule} */
const json = (depth) => (value, at) => {
  must(depth, `${at} is wrong`);
  if (Array.isArray(value)) list(json(depth - 1), 0, Infinity)(value, at);
  else if (typeof value === "object" && value) record({}, json(depth - 1))(value, at);
  else if (typeof value === "number") number(value, at);
};

const experimentRule = record({
  version: rule((value) => value === 1),
  scene: name,
  document: record({}, json(16)),
  // Names of queries are free text in a scenario; they are only ever compared.
  query: text,
  lanes: list(record({ algorithm: name, settings }), 1, 4),
  iteration: whole(Number.MAX_SAFE_INTEGER),
  view: record({
    axes: list(whole(63), 2, 2), refused: flag, strobe: flag, poses: whole(99), raw: flag, slice: flag, projector: flag,
    lens: rule((value) => value === "workspace" || value === "cspace"),
  }),
  options: settings,
});

/** Throws a fault unless it is an experiment, with or without what is left out. @param {unknown} value @returns {asserts value is Partial<Experiment> & Pick<Experiment, "lanes">} */
function requireExperiment(value) {
  experimentRule(value, "experiment");
  const { scene, document, lanes } = /** @type {Partial<Experiment>} */ (value);
  must((scene || document) && lanes?.every((lane) => lane.algorithm), "it lacks a scene or an algorithm");
}

/** Without what is absent, off, or the workspace; nothing where nothing is left. @param {object} view */
function seen(view) {
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
  const bytes = new TextEncoder().encode(JSON.stringify({ ...rest, iteration: iteration || undefined, view: seen(view) }));
  const packed = await pump(bytes, new CompressionStream("deflate-raw"));
  const binary = Array.from(packed, (byte) => String.fromCharCode(byte)).join("");
  const fragment = `1${btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
  must(bytes.length <= MOST_BYTES && fragment.length < MOST_FRAGMENT, "it is too long");
  return fragment;
}

/**
 * @param {string} fragment  with or without `#`
 * @returns {Promise<{ experiment: Experiment, fault: null } | { experiment: null, fault: string }>}  never rejects; `fault` is a sentence for people
 */
export async function decodeLink(fragment) {
  try {
    must(String(fragment).length <= MOST_FRAGMENT, "it is too long");
    const [, packed] = /^#?1([\w-]+)$/.exec(fragment) ?? [];
    must(packed, "it is not one of version 1");
    const binary = atob(packed.replace(/-/g, "+").replace(/_/g, "/"));
    const bytes = await pump(Uint8Array.from(binary, (c) => c.charCodeAt(0)), new DecompressionStream("deflate-raw"));
    const value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
    requireExperiment(value);
    const lanes = value.lanes.map((lane) => ({ ...lane, settings: lane.settings ?? {} }));
    return { experiment: { iteration: 0, view: {}, ...value, version: 1, lanes }, fault: null };
  } catch (error) {
    return { experiment: null, fault: error instanceof Fault ? error.message : "This link does not work: it is damaged." };
  }
}

/**
 * Sends bytes through a transform, and stops reading beyond the limit.
 * @param {Uint8Array<ArrayBuffer>} bytes @param {CompressionStream | DecompressionStream} transform
 */
async function pump(bytes, transform) {
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    parts.push(value);
    size += value.length;
    if (size > MOST_BYTES) await reader.cancel();
    must(size <= MOST_BYTES, "it is too long");
  }
}
