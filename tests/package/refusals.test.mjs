/** Refusals: the cases of `tests/refusals.json`, which the native tests read too, through the package. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Experiment, Fleet, Navigation, PlanariumError, Problem, Scenario, Trajectories } from "planarium/full";
import { finish } from "./scenes.mjs";

/**
 * @typedef {{ kind: string, document?: string, set?: Record<string, unknown>, remove?: string[], text?: string,
 *   generator?: string, options?: any, code: string, pointer: string, message?: string }} Case
 */

/** @type {{ documents: Record<string, any>, cases: Case[] }} */
const { documents, cases } = JSON.parse(readFileSync(new URL("../refusals.json", import.meta.url), "utf8"));

const camel = (/** @type {string} */ text) => text.replace(/_(.)/g, (_, letter) => letter.toUpperCase());

/** Options of JavaScript: names in camelCase, and numbers that JSON does not have. @param {any} value @returns {any} */
function given(value) {
  if (value === "NaN" || value === "Infinity") return Number(value);
  if (Array.isArray(value)) return value.map(given);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([name, field]) => [camel(name), given(field)]));
}

/** The document of a case as it is changed. @param {Case} one */
function changed({ document = "", set = {}, remove = [] }) {
  const tree = structuredClone(documents[document]);
  const at = (/** @type {string} */ pointer) => {
    const names = pointer
      .split("/")
      .slice(1)
      .map((name) => name.replaceAll("~1", "/").replaceAll("~0", "~"));
    const last = names.pop() ?? assert.fail();
    return { parent: names.reduce((parent, name) => parent[name], tree), last };
  };
  for (const pointer of remove) {
    const { parent, last } = at(pointer);
    assert.ok(delete parent[last]);
  }
  for (const [pointer, value] of Object.entries(set)) {
    const { parent, last } = at(pointer);
    parent[last] = value;
  }
  return tree;
}

/** @param {any} description */
function problem({ free, ...fields }) {
  return new Problem(
    free === "samples"
      ? {
          ...fields,
          isFree: (/** @type {any} */ _, /** @type {Uint8Array} */ out) => {
            out.fill(1);
          },
        }
      : {
          ...fields,
          clearance: (/** @type {any} */ _, /** @type {Float64Array} */ out) => {
            out.fill(Infinity);
          },
        },
  );
}

/**
 * What is asked for, of a document or its text, and with options.
 * @type {Record<string, (document: any, options: any, id: any) => unknown>}
 */
const KINDS = {
  scenario: (document) => Scenario.parse(document),
  fleet: (document) => Fleet.parse(document),
  navigation: (document) => Navigation.parse(document),
  policy: (document) => Navigation.parse(documents.navigation).planner(document),
  experiment: (document) => Experiment.parse(document),
  roadmap: (document) =>
    Scenario.parse(documents["arm-and-wall"]).resume(
      typeof document === "string" ? document : JSON.stringify(document),
    ),
  problem: (document) => problem(document),
  generate: (_, options, id) => Scenario.generate(id, options),
  "generate-fleet": (_, options, id) => Fleet.generate(id, options),
  "generate-navigation": (_, options, id) => Navigation.generate(id, options),
  plan: (document, options) => Scenario.parse(document).planner(options),
  "plan-problem": (document, options) => problem(document).planner(options),
  resume: (document, options) => {
    const scenario = Scenario.parse(document);
    return scenario.resume(
      finish(scenario.planner({ algorithm: "prm", seed: 1, samples: 40, k: 6 })).roadmap("binary"),
      options,
    );
  },
  "plan-fleet": (document, options) => Fleet.parse(document).planner(options),
  "plan-navigation": (document, options) => Navigation.parse(document).planner(documents.policy, options),
  train: (document, options) => Navigation.parse(document).training(options),
  compare: (document, options) => Navigation.parse(document).comparison(documents.policy, options),
  reach: (document, options) => Scenario.parse(document).reach(options),
  trajectories: (_, options) => new Trajectories(options),
  neighbours: (document, options) => Scenario.parse(document).neighbours(options),
  certify: (document, options) => Scenario.parse(document).certify(options),
  optimum: (document, options) => Scenario.parse(document).optimum(options),
};

test("every case has its code, its pointer and its sentence, whether a document is an object or a text", () => {
  const faults = cases.flatMap((one) => {
    const options = given(one.options);
    // Options have names in camelCase, and fields of a saved roadmap, which options repeat; other documents have their
    // own names.
    const pointer =
      one.kind === "roadmap" || Object.hasOwn(one.options ?? {}, one.pointer.slice(1))
        ? camel(one.pointer)
        : one.pointer;
    const document = one.text ?? (one.document && changed(one));
    const forms =
      one.text !== undefined || one.kind.includes("problem") ? [document] : [document, JSON.stringify(document)];
    return forms.flatMap((form) => {
      try {
        KINDS[one.kind](form, options, one.generator);
      } catch (error) {
        assert.ok(error instanceof PlanariumError, `${error}: ${JSON.stringify(one)}`);
        const isTold =
          one.message === undefined ||
          [one.message, camel(one.message)].some((message) => error.message.includes(message));
        return error.code === one.code && error.pointer === pointer && isTold
          ? []
          : [`${error.code} at ${error.pointer}, ${error.message}: ${JSON.stringify(one)}`];
      }
      return [`accepted: ${JSON.stringify(one)}`];
    });
  });
  assert.deepEqual(faults, []);
});
