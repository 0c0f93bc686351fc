/** Declarations of the package: those of wasm-bindgen, and the types of options from the catalogue. */

/**
 * @typedef {{ name: string, option: string, kind: string, unit: string, min: number | null, max: number | null,
 *   default: unknown, default_meaning: string | null, choices: string[] | null, meaning: string }} Row
 * @typedef {{ id: string, parameters: Row[], options: Row[], presets?: { settings: Record<string, unknown> }[] }} Entry
 * @typedef {{ planners: Entry[], generators: Entry[], reach_methods: Entry[], indexes: Entry[], fleet_planners:
 *   Entry[], fleet_generators: Entry[], navigation_generators: Entry[], rollouts: Row[], training: Row[], comparison:
 *   Row[], trajectories: Row[], particle: Row[], errors: unknown, phases: string[], event_kinds: string[], history_columns: string[] }} Catalogue
 * @typedef {Omit<Catalogue, "errors" | "phases" | "event_kinds" | "history_columns">} Choices
 */

/** @param {string} name */
export function camelCase(name) {
  return name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
}

/**
 * The choices of the catalogue, with the settings of presets by their names in JavaScript.
 * @param {Catalogue} catalogue
 * @returns {Choices}
 */
export function forJavaScript({
  planners,
  errors: _errors,
  phases: _phases,
  event_kinds: _kinds,
  history_columns: _columns,
  ...others
}) {
  const renamed = (/** @type {Record<string, unknown>} */ settings) =>
    Object.fromEntries(Object.entries(settings).map(([name, value]) => [camelCase(name), value]));
  return {
    ...others,
    planners: planners.map((planner) => ({
      ...planner,
      presets: planner.presets?.map((preset) => ({ ...preset, settings: renamed(preset.settings) })),
    })),
  };
}

/**
 * What is chosen for scenarios and problems: the catalogue of the light core.
 * @param {Choices} choices
 * @returns {Pick<Choices, "planners" | "generators" | "indexes">}
 */
export function ofScenarios({ planners, generators, indexes }) {
  return { planners, generators, indexes };
}

/** All rows of options. @param {Partial<Choices>} choices */
export function rowsOf({
  planners = [],
  generators = [],
  reach_methods = [],
  indexes = [],
  fleet_planners = [],
  fleet_generators = [],
  navigation_generators = [],
  rollouts = [],
  training = [],
  comparison = [],
  trajectories = [],
}) {
  return [
    ...[
      ...planners,
      ...generators,
      ...reach_methods,
      ...indexes,
      ...fleet_planners,
      ...fleet_generators,
      ...navigation_generators,
    ].flatMap(({ parameters, options }) => parameters ?? options),
    ...rollouts,
    ...training,
    ...comparison,
    ...trajectories,
  ];
}

/** @param {readonly string[]} words */
const union = (words) => words.map((word) => JSON.stringify(word)).join(" | ");
/** @param {string} text */
const comment = (text) => `/** ${text.replaceAll("*/", "* /")} */`;
const SEED = {
  option: "seed",
  kind: "integer",
  meaning: "The seed; the same seed gives the same result, bit for bit.",
  unit: "",
  min: 0,
  max: 2 ** 53 - 1,
  default: 0,
  default_meaning: null,
  choices: null,
};

/** One member. @param {Omit<Row, "name">} row */
function member({ option, kind, unit, min, max, choices, meaning, default: value, default_meaning }) {
  const range = min === null || max === null ? "" : ` From ${min} to ${max}${unit ? ` ${unit}` : ""}.`;
  const preset = value === null ? default_meaning : String(value);
  const type = kind === "choice" ? union(choices ?? []) : kind === "boolean" ? "boolean" : "number";
  return `    ${comment(`${meaning}${range}${preset ? ` Default: ${preset}.` : ""}`)}\n    ${option}?: ${type};\n`;
}

/** The rows of several entries, each name once: a choice has the words of all. @param {Row[]} rows */
function merged(rows) {
  /** @type {Map<string, Row>} */
  const all = new Map();
  for (const row of rows) {
    const known = all.get(row.option);
    const choices = known?.choices && row.choices ? [...new Set([...known.choices, ...row.choices])] : row.choices;
    // Ranges and defaults of several entries differ: `meaning` is what they share.
    all.set(
      row.option,
      known && JSON.stringify(known) !== JSON.stringify(row)
        ? { ...known, choices, min: null, max: null, default: null, default_meaning: null }
        : row,
    );
  }
  return [...all.values()];
}

/**
 * The lists that give the numbers in rows their meaning, as a module and its declarations.
 * @param {Catalogue} catalogue
 */
export function tablesOf({ phases, event_kinds, history_columns }) {
  const tables = [
    {
      name: "phases",
      text: "The phases: a row of `planner.historySince` holds an index into this list.",
      words: phases,
    },
    {
      name: "eventKinds",
      text: "The kinds of events: a row of `planner.eventsSince` begins with an index into this list.",
      words: event_kinds,
    },
    {
      name: "historyColumns",
      text: "The columns of `planner.historySince`; `length` is that of the best path so far.",
      words: history_columns.map(camelCase),
    },
  ];
  const each = (/** @type {(name: string, list: string) => string} */ write) =>
    tables
      .map(
        ({ name, text, words }) =>
          `${comment(text)}\n${write(name, `[${words.map((word) => JSON.stringify(word)).join(", ")}]`)}\n`,
      )
      .join("");
  return {
    script: each((name, list) => `export const ${name} = /* @__PURE__ */ Object.freeze(${list});`),
    declarations: each((name, list) => `export declare const ${name}: readonly ${list};`),
  };
}

/** The type of an event's kind. @param {Catalogue} catalogue */
export function kindType({ event_kinds }) {
  return `${comment("The kind of an event: see `planner.eventsSince`.")}\nexport type EventKind = ${union(event_kinds)};\n`;
}

/** The types of options. @param {Choices} choices */
export function optionTypes({
  planners,
  generators,
  reach_methods,
  indexes,
  fleet_planners,
  fleet_generators,
  navigation_generators,
  rollouts,
  training,
  comparison,
  trajectories,
  particle,
}) {
  /** @param {string} name @param {string} text @param {string} first @param {Omit<Row, "name">[]} rows */
  const type = (name, text, first, rows, common = [SEED]) =>
    `${comment(text)}\nexport interface ${name} {\n${first}${[...common, ...rows].map(member).join("")}}\n`;
  /** @param {string} id */
  const nameOf = (id) =>
    `${id
      .split("-")
      .map((word) => word[0].toUpperCase() + word.slice(1))
      .join("")}Options`;
  const query = `    ${comment("The name of the query; the first by default.")}\n    query?: string;\n    ${comment("Whether events are recorded, `true` by default. Without them a run takes less memory and `eventsSince` returns nothing; graph, path and counts are the same, but `fingerprint` covers no events.")}\n    events?: boolean;\n`;
  /** @param {string} id @param {string} optional */
  const algorithm = (id, optional = "") =>
    `    ${comment("The id of the planner.")}\n    algorithm${optional}: ${JSON.stringify(id)};\n${query}`;
  const ids = (/** @type {Entry[]} */ entries) => union(entries.map(({ id }) => id));
  const roadmaps = planners.filter(({ id }) => /prm/.test(id));
  return [
    ...planners.map(({ id, parameters }) =>
      type(nameOf(id), `Options of the planner \`${id}\`.`, algorithm(id), parameters),
    ),
    `/** The id of a planner. */\nexport type PlannerId = ${ids(planners)};\n`,
    `/** The same options without the planner's id. */\nexport type Unnamed<O> = Omit<O, "algorithm"> & { algorithm?: undefined };\n`,
    `/** Options of \`scenario.planner\`: those of the planner that \`algorithm\` names; by default \`rrt-control\` for a car, \`rrt-connect\` for others. */`,
    `export type PlannerOptions = ${[...planners.map(({ id }) => nameOf(id)), "Unnamed<RrtConnectOptions>", "Unnamed<RrtControlOptions>"].join(" | ")};\n`,
    `/** Options of \`scenario.resume\` and \`problem.resume\`; \`algorithm\` is the planner that built the roadmap. */`,
    `export type ResumeOptions = ${roadmaps.flatMap(({ id }) => [nameOf(id), `Unnamed<${nameOf(id)}>`]).join(" | ")};\n`,
    `/** The id of a generator. */\nexport type GeneratorId = ${ids(generators)};\n`,
    type(
      "GenerateOptions",
      "Options of `Scenario.generate`; `generators()` lists which generator takes which.",
      "",
      merged(generators.flatMap(({ options }) => options)),
    ),
    `/** The id of an index. */\nexport type IndexId = ${ids(indexes)};\n`,
    type(
      "NeighboursOptions",
      "Options of `scenario.neighbours`.",
      `    ${comment("The kind of index; `kd-tree` by default.")}\n    index?: IndexId;\n`,
      merged(indexes.flatMap(({ parameters }) => parameters)).filter(({ option }) => option !== "seed"),
    ),
    `/** The id of a method of inverse kinematics. */\nexport type ReachMethodId = ${ids(reach_methods)};\n`,
    type(
      "ReachOptions",
      "Options of `scenario.reach`.",
      [
        ["The target of the tip, in metres.", "target: readonly [number, number]"],
        [
          "The wanted absolute angle of the last link, in radians, in any number of turns; any by default.",
          "orientation?: number",
        ],
        ["The id of the method; `damped-least-squares` by default.", "method?: ReachMethodId"],
        [
          "The first start; by default the start of the first query, or all joints at 0 as far as their limits allow.",
          "start?: readonly number[]",
        ],
      ]
        .map(([text, code]) => `    ${comment(text)}\n    ${code};\n`)
        .join(""),
      merged(reach_methods.flatMap(({ parameters }) => parameters)),
    ),
    `/** The id of a generator of fleets. */\nexport type FleetGeneratorId = ${ids(fleet_generators)};\n`,
    type(
      "GenerateFleetOptions",
      "Options of `Fleet.generate`; `fleetGenerators()` lists which generator takes which.",
      "",
      merged(fleet_generators.flatMap(({ options }) => options)),
    ),
    `/** The id of a planner of fleets. */\nexport type FleetPlannerId = ${ids(fleet_planners)};\n`,
    type(
      "FleetOptions",
      "Options of `fleet.planner`; `fleetPlanners()` lists which planner takes which.",
      [
        [
          "The id of the planner; by default `pbs`, or `prioritized` if there is an order.",
          "algorithm?: FleetPlannerId",
        ],
        [
          "The order of priorities, the highest first: the names of all robots. For `prioritized` only, which begins with that of the document by default.",
          "order?: readonly string[]",
        ],
      ]
        .map(([text, code]) => `    ${comment(text)}\n    ${code};\n`)
        .join(""),
      merged(fleet_planners.flatMap(({ parameters }) => parameters)),
    ),
    `/** The id of a generator of navigation tasks. */\nexport type NavigationGeneratorId = ${ids(navigation_generators)};\n`,
    type(
      "GenerateNavigationOptions",
      "Options of `Navigation.generate`; `navigationGenerators()` lists which generator takes which.",
      "",
      merged(navigation_generators.flatMap(({ options }) => options)),
    ),
    type("TrainingOptions", "Options of `navigation.training`.", "", training),
    type("RolloutCounts", "When a policy drives an edge reliably.", "", rollouts, []),
    `/** Options of \`navigation.planner\`: those of a planner without controls, \`lazy-prm\` by default (\`prm\` for \`navigation.straightPlanner\`), and when an edge is driven reliably. \`margin\` is for \`navigation.straightPlanner\`. */`,
    `export type PolicyPlannerOptions = RolloutCounts & { margin?: number } & (${planners
      .filter(({ id }) => id !== "rrt-control" && id !== "sst")
      .map(({ id }) => nameOf(id))
      .join(" | ")} | Unnamed<LazyPrmOptions>);\n`,
    type("NavigationComparisonOptions", "Options of `navigation.comparison`.", "", comparison),
    type("TrajectoryOptions", "Options of `new Trajectories`.", "", trajectories),
    type("ParticleMotion", "A particle with constant speed and turn rate.", "", particle, []),
  ].join("\n");
}

/**
 * The declarations that wasm-bindgen has written, without those of its loaders, and with a comment for every member.
 * @param {string} text
 */
export function coreDeclarations(text) {
  return (
    text
      .replace(/^\/\* \w+ \*\/\n/gm, "")
      // Comments that have passed through a macro.
      .replace(/^( +\*) r"/gm, "$1")
      .replace(/^export function __\w+.*\n/gm, "")
      .replace(/^export type InitInput[^]*$/m, "")
      .replace(/\*\/\n\n/g, "*/\n")
      .replace(/^ +private constructor/gm, "    /** Not public. */\n    private constructor")
      .replace(
        /^ +free\(\): void;\n +\[Symbol.dispose\]\(\): void;\n/gm,
        `    /** Frees the memory. Any later use throws \`freed\`; a second call has no effect. */
    free(): void;
    /** The same as \`free\`, for \`using\`. */
    [Symbol.dispose](): void;
`,
      )
  );
}

/**
 * The declarations without those that nothing names: types of classes that this core has not. What other modules name
 * stays.
 * @param {string} text @param {string[]} others  the declarations that import these
 */
export function reachable(text, others) {
  const code = (/** @type {string} */ part) => part.replace(/\/\*[^]*?\*\//g, "");
  /** @type {{ name: string, text: string, isKept: boolean }[]} */
  const parts = [];
  const [head, body] = [/^(?:\/\/\/.*\n)*/.exec(text)?.[0] ?? "", text.replace(/^\/\/\/.*\n/gm, "")];
  let comment = "";
  for (const part of body.split(/^(?=\/\*\*|export )/m)) {
    const [, kind, name] = /^export (?:declare )?(type|interface|class|function|enum|const) (\w+)/.exec(part) ?? [];
    if (kind === undefined) {
      comment += part;
      continue;
    }
    parts.push({ name, text: comment + part, isKept: kind === "class" || kind === "function" });
    comment = "";
  }
  const named = new Set(
    [...others, ...parts.filter(({ isKept }) => isKept).map((part) => part.text)].flatMap(
      (part) => code(part).match(/\w+/g) ?? [],
    ),
  );
  for (let isGrowing = true; isGrowing;) {
    isGrowing = false;
    for (const part of parts) {
      if (part.isKept || !named.has(part.name)) continue;
      part.isKept = isGrowing = true;
      for (const word of code(part.text).match(/\w+/g) ?? []) named.add(word);
    }
  }
  return (
    head +
    parts
      .filter(({ isKept }) => isKept)
      .map((part) => part.text)
      .join("")
  );
}
