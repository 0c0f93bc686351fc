/**
 * Rules for the state in the fragment of an address, which may come from anyone. Nothing is evaluated; an entry that
 * breaks its rule is refused by its place.
 */

/**
 * @template [T=any]
 * @typedef {{ (value: unknown, at: string): void, type?: T }} Rule  throws a fault that names `at`; `type` exists only
 *   for the compiler
 */
/** The type of what a rule allows. @template {Rule} R @typedef {NonNullable<R["type"]>} Allowed */

export class ErrorInfo extends Error {}

/** @param {unknown} holds @param {string} fault @returns {asserts holds} */
export function must(holds, fault) {
  if (!holds) throw new ErrorInfo(`This link does not work: ${fault}.`);
}

/** @template [T=any] @param {(value: unknown) => unknown} holds @returns {Rule<T>} */
export const rule = (holds) => (value, at) => must(holds(value), `${at} is wrong`);

/** A whole number in a range. @param {number} most @param {number} [least] @returns {Rule<number>} */
export const whole = (most, least = 0) =>
  rule((value) => Number.isInteger(value) && Number(value) >= least && Number(value) <= most);

/** @template {string | number} T @param {readonly T[]} choices @returns {Rule<T>} */
export const oneOf = (choices) => rule((value) => choices.some((choice) => choice === value));

/** A name that no object inherits. @type {Rule<string>} */
export const name = rule(
  (value) =>
    typeof value === "string" && /^[\w-]{1,64}$/.test(value) && value !== "prototype" && !(value in Object.prototype),
);
/** @type {Rule<string>} */
export const text = rule((value) => typeof value === "string" && value.length <= 256);
/** A text of a form. @param {RegExp} form @param {number} most  characters @returns {Rule<string>} */
export const formed = (form, most) =>
  rule((value) => typeof value === "string" && value.length <= most && form.test(value));
/** @type {Rule<boolean>} */
export const flag = rule((value) => typeof value === "boolean");
/** @type {Rule<number>} */
export const number = rule(Number.isFinite);

/** @template T @param {Rule<T>} item @param {number} least @param {number} most @returns {Rule<T[]>} */
export const list = (item, least, most) => (value, at) => {
  must(Array.isArray(value) && value.length >= least && value.length <= most, `${at} is wrong`);
  value.forEach((entry, i) => item(entry, `${at}.${i}`));
};

/** A text on one line: line breaks and other characters that cannot be seen are written `\u{a}`. @param {string} key */
const printable = (key) =>
  key.replace(/[\p{C}\p{Zl}\p{Zp}]/gu, (unseen) => `\\u{${unseen.codePointAt(0)?.toString(16)}}`);

/**
 * A record of at most 64 entries; an undefined one is absent.
 * @template {Record<string, Rule>} R
 * @param {R} rules @param {Rule} [others]  of entries without a rule; else there are none
 * @returns {Rule<{ [K in keyof R]?: Allowed<R[K]> }>}
 */
export const record = (rules, others) => (value, at) => {
  must(typeof value === "object" && value && !Array.isArray(value), `${at} is wrong`);
  const entries = Object.entries(value).filter(([, entry]) => entry !== undefined);
  must(entries.length <= 64, `${at} is wrong`);
  for (const [key, entry] of entries) {
    const place = `${at}.${printable(key.slice(0, 64))}`;
    name(key, place);
    const each = rules[key] ?? others;
    must(each, `${place} is unknown`);
    each(entry, place);
  }
};

/**
 * A record, and the values of the entries that it leaves out.
 * @template {Record<string, Rule>} R @template {Record<string, unknown>} D
 * @param {R} rules @param {D} defaults
 * @returns {Rule<{ [K in keyof R]?: Allowed<R[K]> } & { [K in keyof D & keyof R]: Allowed<R[K]> }> & { defaults: D }}
 */
export const withDefaults = (rules, defaults) => Object.assign(/** @type {Rule} */ (record(rules)), { defaults });

/** @type {Rule<Record<string, number | string | boolean>>} */
export const settings = record({}, (value, at) =>
  (typeof value === "string" ? text : typeof value === "number" ? number : flag)(value, at),
);

/** Any JSON; the package checks its meaning. @param {number} depth  of nesting, at most @returns {Rule} */
export const json = (depth) => (value, at) => {
  must(depth, `${at} is wrong`);
  if (Array.isArray(value)) list(json(depth - 1), 0, Infinity)(value, at);
  else if (typeof value === "object" && value) record({}, json(depth - 1))(value, at);
  else if (typeof value === "number") number(value, at);
};
