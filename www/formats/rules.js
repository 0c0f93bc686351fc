/**
 * Rules for the state in the fragment of an address, which may come from anyone. Nothing is evaluated; an entry that breaks its rule
 * is refused by its place.
 */

/** @typedef {(value: unknown, at: string) => void} Rule  throws a fault that names `at` */

export class Fault extends Error {}

/** @param {unknown} holds @param {string} fault @returns {asserts holds} */
export function must(holds, fault) {
  if (!holds) throw new Fault(`This link does not work: ${fault}.`);
}

/** @param {(value: unknown) => unknown} holds @returns {Rule} */
export const rule = (holds) => (value, at) => must(holds(value), `${at} is wrong`);

/** @param {number} most @returns {Rule} */
export const whole = (most) => rule((value) => Number.isInteger(value) && Number(value) >= 0 && Number(value) <= most);

/** A name that no object inherits. */
export const name = rule((value) => typeof value === "string" && /^[\w-]{1,64}$/.test(value) && value !== "prototype" && !(value in Object.prototype));
export const text = rule((value) => typeof value === "string" && value.length <= 256);
export const flag = rule((value) => typeof value === "boolean");
export const number = rule(Number.isFinite);

/** @param {Rule} item @param {number} least @param {number} most @returns {Rule} */
export const list = (item, least, most) => (value, at) => {
  must(Array.isArray(value) && value.length >= least && value.length <= most, `${at} is wrong`);
  value.forEach((entry, i) => item(entry, `${at}.${i}`));
};

/** At most 64 entries; what is undefined is absent. @param {Record<string, Rule>} rules @param {Rule} [others]  of entries without a rule; else there are none @returns {Rule} */
export const record = (rules, others) => (value, at) => {
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

/** A record, and the values of the entries that it leaves out. @param {Record<string, Rule>} rules @param {Record<string, unknown>} defaults @returns {Rule & { defaults: Record<string, unknown> }} */
export const withDefaults = (rules, defaults) => Object.assign(record(rules), { defaults });

export const settings = record({}, (value, at) => (typeof value === "string" ? text : typeof value === "number" ? number : flag)(value, at));

/** Any JSON; the package checks its meaning. @param {number} depth  of nesting, at most @returns {Rule} */
export const json = (depth) => (value, at) => {
  must(depth, `${at} is wrong`);
  if (Array.isArray(value)) list(json(depth - 1), 0, Infinity)(value, at);
  else if (typeof value === "object" && value) record({}, json(depth - 1))(value, at);
  else if (typeof value === "number") number(value, at);
};
