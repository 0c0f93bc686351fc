/**
 * The form of a document: its worlds, its planners, what varies, seeds, budget and measures. Tables of the core say
 * what there is.
 */
import { generators, planners } from "planarium/full";
import { byId, make } from "../app/dom.js";
import { robotName } from "../domain/names.js";
import { SCENES } from "../planner/scenes/scenes.js";
import { button, row, select, toggle } from "../widgets/elements.js";
import { Options } from "../widgets/options.js";
import { capital } from "../widgets/format.js";
import { axisOf, axisText, seedCount, seedsOf, seedsText } from "./axis-text.js";
import { nameOf, plannerTitle } from "./factors.js";
import { isShare, measureInfo } from "./measures.js";
import { titleOf } from "./worlds.js";

/** @import { ExperimentSeeds, ExperimentWorld, Measure } from "planarium/full" */
/** @import { LinkedDocument, LinkedWorld, ParameterInfo, Settings } from "../domain/types.js" */
/** @import { ExperimentSession } from "./session.js" */

/** Rows for parameters that vary, at least. */
const VARIED = 2;
/** Seeds of an experiment in few worlds. */
const SEEDS = 100;

/** @param {ExperimentSession} session */
export function watchForm(session) {
  const host = byId("form", HTMLElement);
  const [kinds, makers] = [planners(), generators()];
  session.onChange((change) => {
    if (change === "document") build();
    if (change === "document" || change === "checked") offerPlanners();
  });

  function build() {
    const { activeElement: held } = document;
    const focused = held && host.contains(held) ? held.id : "";
    try {
      host.replaceChildren(
        section("Worlds", ...worldRows()),
        section("Planners", ...plannerRows()),
        section("What varies", ...variedRows()),
        section("Trials", ...trialRows()),
      );
    } catch {
      // What has not the shape of a document is refused by the core, which says why; it has no form.
      host.replaceChildren();
    }
    // The focus stays on the same control.
    if (focused) document.getElementById(focused)?.focus({ preventScroll: true });
  }

  /**
   * Changes the document; a change of its parts makes the form again.
   * @param {Partial<LinkedDocument>} changes
   * @param {boolean} [isForm]
   */
  function edit(changes, isForm = false) {
    session.edit({ ...session.document, ...changes }, isForm);
  }

  /**
   * @template {keyof LinkedDocument & ("worlds" | "planners")} K
   * @param {K} list
   * @param {number} at
   * @param {object} changes
   * @param {boolean} [isForm]
   */
  function editEntry(list, at, changes, isForm) {
    edit(
      { [list]: session.document[list].map((entry, i) => (i === at ? compact({ ...entry, ...changes }) : entry)) },
      isForm,
    );
  }

  /** @param {LinkedWorld[]} worlds */
  function editWorlds(worlds) {
    edit(enoughSeeds({ ...session.document, worlds }, session.document), true);
  }

  function worldRows() {
    const { worlds } = session.document;
    const rows = worlds.map((world, i) => {
      const maker = "generate" in world ? makers.find(({ id }) => id === world.generate) : undefined;
      const parts =
        maker && "generate" in world
          ? [
              seedsRow(`world-seeds-${i}`, "Seeds of worlds", world.seeds, (seeds) =>
                editEntry("worlds", i, { seeds }),
              ),
              settings(`world-${i}`, "Options", maker.options, world, (set) => editEntry("worlds", i, { set })),
            ]
          : [];
      return entry(
        maker ? `${capital(titleOf(world))} (generated)` : titleOf(world),
        parts,
        worlds.length > 1 && (() => editWorlds(worlds.filter((_, j) => j !== i))),
        `world-${i}-remove`,
      );
    });
    const choice = make(
      "select",
      { id: "new-world", ariaLabel: "World to add" },
      group(
        "Generated",
        makers.map(({ id, title }) => [`generate:${id}`, title]),
      ),
      group(
        "Scenes",
        SCENES.map(({ id, title }) => [`scene:${id}`, title]),
      ),
    );
    const add = () => {
      const [kind, id] = choice.value.split(":");
      const known = worlds.map((world) => nameOf("scene" in world ? { name: world.name ?? world.scene } : world));
      const name = fresh(id, known);
      const world = /** @type {LinkedWorld} */ ({
        [kind]: id,
        ...(name === id ? {} : { name }),
        ...(kind === "generate" ? { seeds: { from: 0, count: 10 } } : {}),
      });
      editWorlds([...worlds, world]);
    };
    return [...rows, make("div", { className: "row" }, choice, button("add-world", "Add", add))];
  }

  function plannerRows() {
    const { planners: list } = session.document;
    const rows = list.map((planner, i) => {
      const info = kinds.find(({ id }) => id === planner.algorithm);
      return entry(
        plannerTitle(planner),
        info
          ? [
              settings(`planner-${i}`, "Parameters", info.parameters, planner, (set) =>
                editEntry("planners", i, { set }),
              ),
            ]
          : [],
        list.length > 1 && (() => edit({ planners: list.filter((_, j) => j !== i) }, true)),
        `planner-${i}-remove`,
      );
    });
    const titles = kinds.map(({ id, title }) => /** @type {[string, string]} */ ([id, title]));
    const choice = select("new-planner", "Planner to add", titles);
    const add = () => {
      const { id, title } = kinds[choice.selectedIndex];
      const name = fresh(title, list.map(plannerTitle));
      edit({ planners: [...list, { algorithm: id, ...(name === title ? {} : { name }) }] }, true);
    };
    return [...rows, make("div", { className: "row" }, choice, button("add-planner", "Add", add))];
  }

  /** A planner that is not for the robots of all worlds would be refused. */
  function offerPlanners() {
    const choice = document.querySelector("#new-planner");
    if (!(choice instanceof HTMLSelectElement)) return;
    kinds.forEach(({ title, robots }, i) => {
      const isServed = session.robots.every((robot) => robots.includes(robot));
      Object.assign(choice.options[i], {
        disabled: !isServed,
        textContent: isServed ? title : `${title} (for ${robots.map((robot) => `${robotName(robot)}s`).join(", ")})`,
      });
    });
    if (choice.selectedOptions[0]?.disabled) choice.value = kinds.find((_, i) => !choice.options[i].disabled)?.id ?? "";
  }

  /**
   * Seeds of trials or worlds.
   * @param {string} id
   * @param {string} title
   * @param {ExperimentSeeds | undefined} seeds
   * @param {(seeds: ExperimentSeeds) => void} use
   */
  function seedsRow(id, title, seeds, use) {
    return textRow(
      id,
      title,
      seedsText(seeds ?? [0]),
      seedsOf,
      "Enter whole numbers such as 0, 2, 5, or 0 to 19 from the smallest to the largest.",
      use,
    );
  }

  /**
   * A line of text that stands for a value; what cannot be read says why.
   * @template T
   * @param {string} id
   * @param {string} title
   * @param {string} value
   * @param {(text: string) => T | null} read  null: it cannot be read
   * @param {string} advice @param {(value: T) => void} use
   */
  function textRow(id, title, value, read, advice, use) {
    const reason = make("p", { className: "reason", id: `${id}-reason`, hidden: true }, advice);
    const input = make("input", { type: "text", id, value, ariaLabel: title || "Work at most" });
    input.setAttribute("aria-describedby", reason.id);
    input.addEventListener("input", () => {
      reason.hidden = read(input.value) !== null;
      input.ariaInvalid = reason.hidden ? null : "true";
      session.update("phase");
    });
    input.addEventListener("change", () => {
      const given = read(input.value);
      if (given !== null) use(given);
    });
    return make("div", {}, row(title, input), reason);
  }

  /** What can vary, and what does. */
  function variedRows() {
    const { planners: list, worlds } = session.document;
    const all = [
      ...list.map((planner, i) => ({
        list: /** @type {const} */ ("planners"),
        i,
        entry: planner,
        title: plannerTitle(planner),
        table: kinds.find(({ id }) => id === planner.algorithm)?.parameters ?? [],
      })),
      ...worlds.flatMap((world, i) =>
        "generate" in world
          ? [
              {
                list: /** @type {const} */ ("worlds"),
                i,
                entry: /** @type {Extract<ExperimentWorld, { generate: string }>} */ (world),
                title: titleOf(world),
                table: makers.find(({ id }) => id === world.generate)?.options ?? [],
              },
            ]
          : [],
      ),
    ];
    const now = all.flatMap((owner) =>
      Object.entries(owner.entry.vary ?? {}).map(([name, axis]) => ({ owner, name, axis })),
    );
    const rows = [...now, ...Array.from({ length: Math.max(0, VARIED - now.length) }, () => null)].map(
      (varied, row) => {
        const choice = make(
          "select",
          { id: `vary-${row}`, ariaLabel: `Parameter ${row + 1} that varies` },
          make("option", { value: "" }, "nothing"),
          ...all.map((owner, at) =>
            group(
              owner.title,
              owner.table
                .filter(({ name }) => name !== "seed")
                .map(({ name, title }) => [`${at}:${name}`, title || name]),
            ),
          ),
        );
        choice.value = varied ? `${all.indexOf(varied.owner)}:${varied.name}` : "";
        const values = make("input", {
          type: "text",
          id: `vary-${row}-values`,
          value: varied ? axisText(varied.axis) : "",
          ariaLabel: `Values of parameter ${row + 1}`,
          placeholder: "1, 3, 5 or 1 to 30",
        });
        values.disabled = !varied;
        const set = (/** @type {string} */ place) => {
          const [at, name] = place.split(":");
          let lists = { planners: list, worlds };
          /** @param {typeof all[number]} owner @param {(entry: any) => object} change */
          const replace = (owner, change) => {
            lists = {
              ...lists,
              [owner.list]: lists[owner.list].map((one, i) => (i === owner.i ? compact(change(one)) : one)),
            };
          };
          if (varied) replace(varied.owner, (one) => ({ ...one, vary: without(one.vary, varied.name) }));
          if (place)
            replace(all[Number(at)], (one) => ({
              ...one,
              set: without(one.set, name),
              vary: { ...one.vary, [name]: suggestion(all[Number(at)].table, name, one.set) },
            }));
          edit(lists, true);
        };
        choice.addEventListener("change", () => set(choice.value));
        values.addEventListener("change", () => {
          if (varied)
            editEntry(
              varied.owner.list,
              varied.owner.i,
              { vary: { ...varied.owner.entry.vary, [varied.name]: axisOf(values.value) } },
              true,
            );
        });
        return make("div", { className: "varied" }, choice, values);
      },
    );
    return rows;
  }

  function trialRows() {
    const { seeds, budget, verify = false } = session.document;
    const kind = budget && "iterations" in budget ? "iterations" : budget ? "clearance_evaluations" : "";
    const limit = make(
      "select",
      { id: "budget" },
      ...[
        ["", "planners\u2019 limits"],
        ["iterations", "iterations"],
        ["clearance_evaluations", "clearance evaluations"],
      ].map(([value, title]) => make("option", { value }, title)),
    );
    limit.value = kind;
    limit.addEventListener("change", () =>
      edit({ budget: limit.value ? /** @type {any} */ ({ [limit.value]: 10_000 }) : undefined }, true),
    );
    const check = toggle("verify", (isOn) => edit({ verify: isOn || undefined }), verify);
    const boxes = make("div", { className: "checks" });
    const fold = make("details", {}, make("summary", {}, "Measures"), boxes);
    // The core has listed them by then.
    fold.addEventListener("toggle", () =>
      boxes.replaceChildren(
        ...session.measures
          .filter((id) => !isShare(id))
          .map((id) => {
            const box = make("input", {
              type: "checkbox",
              id: `measure-${id}`,
              checked: session.asked.includes(id),
              onchange: () =>
                edit({
                  measures: /** @type {Measure[]} */ (
                    box.checked ? [...session.asked, id] : session.asked.filter((other) => other !== id)
                  ),
                }),
            });
            return make("label", { className: "check" }, box, measureInfo(id, "").title);
          }),
      ),
    );
    return [
      seedsRow("seeds", "Seeds of planners", seeds, (value) => edit({ seeds: value })),
      row("Work at most", limit),
      ...(budget
        ? [
            textRow(
              "budget-value",
              "",
              String(Object.values(budget)[0]),
              (text) => (/^\d+$/.test(text.trim()) ? Number(text) : null),
              "Enter a whole number.",
              (value) => edit({ budget: /** @type {any} */ ({ [kind]: value }) }),
            ),
          ]
        : []),
      row("Verify every path", check),
      fold,
    ];
  }
}

/**
 * Worlds with a seed each, or none, are few: the planners get more seeds, unless it was so before.
 * @param {LinkedDocument} document
 * @param {LinkedDocument} [before]
 * @returns {LinkedDocument}
 */
export function enoughSeeds(document, before) {
  const areFew = (/** @type {LinkedDocument} */ { worlds }) =>
    worlds.every((world) => !("generate" in world) || (seedCount(world.seeds ?? [0]) === 1 && !world.vary));
  const isNew = areFew(document) && !(before && areFew(before));
  return isNew && seedCount(document.seeds) < SEEDS ? { ...document, seeds: { from: 0, count: SEEDS } } : document;
}

/** @param {string} title @param {...HTMLElement} parts */
function section(title, ...parts) {
  return make("section", {}, make("h2", {}, title), ...parts);
}

/**
 * An entry of a list, with a button that removes it.
 * @param {string} title
 * @param {HTMLElement[]} parts
 * @param {false | (() => void)} remove
 * @param {string} id
 */
function entry(title, parts, remove, id) {
  const head = make(
    "div",
    { className: "row" },
    make("span", { className: "name" }, title),
    remove ? button(id, "Remove", remove, { className: "quiet", ariaLabel: `Remove ${title}` }) : "",
  );
  return make("div", { className: "entry" }, head, ...parts);
}

/** @param {string} label @param {string[][]} choices  value and title of each */
function group(label, choices) {
  return make("optgroup", { label }, ...choices.map(([value, title]) => make("option", { value }, title)));
}

/**
 * The options of an entry that do not vary, folded.
 * @param {string} prefix
 * @param {string} title
 * @param {readonly ParameterInfo[]} table
 * @param {{ set?: Settings, vary?: object }} of
 * @param {(set: Settings | undefined) => void} onChange
 */
function settings(prefix, title, table, { set = {}, vary = {} }, onChange) {
  const host = make("div", {});
  const fold = make(
    "details",
    {},
    make(
      "summary",
      {},
      Object.keys(set).length > 0
        ? `${title}: ${Object.entries(set)
            .map(([name, value]) => `${name} ${value}`)
            .join(", ")}`
        : title,
    ),
    host,
  );
  // Made when it is opened: there are many.
  fold.addEventListener("toggle", () => {
    if (host.childElementCount > 0) return;
    const fixed = table.filter(({ name }) => name !== "seed" && !(name in vary));
    /** @type {Options} */
    const options = new Options(host, fixed, set, () => onChange(options.given), { prefix });
  });
  return fold;
}

/**
 * Values to begin with: around the present one.
 * @param {readonly ParameterInfo[]} table
 * @param {string} name
 * @param {Settings | undefined} set
 */
function suggestion(table, name, set = {}) {
  const info = table.find((one) => one.name === name);
  if (info?.kind === "choice") return [...(info.choices ?? [])];
  if (info?.kind === "boolean") return [false, true];
  const least = Math.max(info?.min ?? 0, 0);
  const middle = Number(set[name] ?? info?.default ?? (info?.kind === "integer" ? 4 : 1)) || 1;
  const values = [0.5, 1, 2].map((factor) => Math.min(info?.max ?? Infinity, Math.max(least, factor * middle)));
  return [
    ...new Set(values.map((value) => (info?.kind === "integer" ? Math.round(value) : Number(value.toPrecision(6))))),
  ];
}

/** A record without an entry. @param {Record<string, unknown> | undefined} fields @param {string} name */
function without(fields = {}, name) {
  return Object.fromEntries(Object.entries(fields).filter(([other]) => other !== name));
}

/** An entry without records that are empty. @param {object} fields @returns {any} */
function compact(fields) {
  return Object.fromEntries(
    Object.entries(fields).filter(
      ([name, value]) => !["set", "vary"].includes(name) || Object.keys(value ?? {}).length > 0,
    ),
  );
}

/** A name that is not in use. @param {string} name @param {string[]} used */
function fresh(name, used) {
  let i = 2;
  if (!used.includes(name)) return name;
  while (used.includes(`${name} ${i}`)) i++;
  return `${name} ${i}`;
}
