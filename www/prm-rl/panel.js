/**
 * The settings: the floor, the options of the training, of the plans and of the comparison, start and goal. The forms
 * are built from the core's tables.
 */
import { comparisonOptions, navigationGenerators, trainingOptions } from "planarium/full";
import { byId, make } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { button, press } from "../widgets/elements.js";
import { Field, withSeed } from "../widgets/field.js";
import { formOf } from "../widgets/form.js";
import { Slider } from "../widgets/slider.js";
import { optionsOf } from "./options.js";

/** @import { NavigationGeneratorId } from "planarium/full" */
/** @import { ParameterInfo, Settings } from "../domain/types.js" */
/** @import { Refusal } from "../app/room.js" */
/** @import { NavigationSession, Source } from "./session.js" */

/** Options that are not folded away. */
const FIRST = {
  floor: ["seed"],
  train: ["seed", "hidden", "pairs", "tasks", "generations"],
  "prm-rl": ["algorithm", "rollouts", "least_share", "reliability", "longest_edge", "seed"],
  straight: ["algorithm", "margin", "seed"],
  "straight-policy": ["algorithm", "margin", "seed"],
  compare: ["seed", "queries", "trials", "least_distance"],
};

/** @type {ParameterInfo} */
const TRIALS = {
  name: "trials",
  title: "Drives",
  kind: "integer",
  unit: "",
  min: 1,
  max: 200,
  default: 20,
  choices: null,
  robots: [],
  meaning: "Number of drives along the path, each with noise of its own.",
};

/**
 * @param {NavigationSession} session
 * @param {{ open: (source: Source, onRefused?: Refusal) => void, plan: (onRefused: Refusal) => void, train: (onRefused:
 *   Refusal) => void, compare: () => void }} actions
 * @returns {{ refuseComparison: Refusal }}
 */
export function showPanel(session, actions) {
  const { app, training, comparison } = session;
  const kind = byId("kind", HTMLSelectElement);
  const generators = navigationGenerators();
  kind.append(...generators.map(({ id, title }) => make("option", { value: id }, title)));
  kind.addEventListener("change", () => {
    const { source } = session;
    const shape = "kind" in source ? source.options.shape : undefined;
    actions.open({
      kind: /** @type {NavigationGeneratorId} */ (kind.value),
      options: shape === undefined ? {} : { shape },
    });
  });
  const robot = byId("robot", HTMLSelectElement);
  robot.append(
    ...(generators[0].options.find(({ name }) => name === "shape")?.choices ?? []).map((shape) =>
      make("option", { value: shape }, shape),
    ),
  );
  robot.addEventListener("change", () => {
    const { source } = session;
    if ("kind" in source) actions.open({ kind: source.kind, options: { ...source.options, shape: robot.value } });
  });
  const trials = new Field(
    TRIALS,
    session.trials,
    () => {
      session.trials = Number(trials.value);
    },
    "drives",
  );
  byId("trials", HTMLElement).append(trials.element);
  byId("moved", HTMLElement).append(
    .../** @type {const} */ (["goal", "start"]).map((end) =>
      button(`moved-${end}`, end, () => {
        session.moved = end;
        app.changed();
      }),
    ),
  );
  const coordinates = [
    { name: "start-x", title: "start x", end: "start", i: 0, unit: "m" },
    { name: "start-y", title: "start y", end: "start", i: 1, unit: "m" },
    { name: "start-theta", title: "heading", end: "start", i: 2, unit: "rad" },
    { name: "goal-x", title: "goal x", end: "goal", i: 0, unit: "m" },
    { name: "goal-y", title: "goal y", end: "goal", i: 1, unit: "m" },
  ].map(({ name, title, end, i, unit }) => {
    const key = /** @type {"start" | "goal"} */ (end);
    const slider = new Slider(
      { name, title, unit, min: unit === "rad" ? -Math.PI : 0, max: unit === "rad" ? Math.PI : 1 },
      0,
      (value) => session.setEnds({ [key]: session[key].with(i, value) }),
    );
    return { slider, key, i };
  });
  byId("ends", HTMLElement).append(...coordinates.map(({ slider }) => slider.element));
  /** The floor and the way whose forms are shown. */
  let shown = { floor: "", way: "", train: "", compare: "" };
  /** @type {ReturnType<typeof formOf> | null} */
  let compareForm = null;
  const differs = comparer();
  app.onShow(show);
  return { refuseComparison: (pointer, reason) => compareForm?.refuse(pointer, reason) ?? false };

  function show() {
    const { source, way, start, goal, document, moved } = session;
    if (!document) return;
    for (const end of ["goal", "start"]) press(byId(`moved-${end}`, HTMLElement), end === moved);
    const isOther = differs("floor", document);
    const { min, max } = document.world.bounds ?? { min: [0, 0], max: [1, 1] };
    for (const { slider, key, i } of coordinates) {
      if (i < 2 && isOther) slider.setLimits(min[i], max[i]);
      // The sensor of a carrier turns to the goal.
      if (i === 2) slider.element.hidden = session.hasLoad;
      const value = (key === "start" ? start : goal)[i];
      slider.show(i < 2 ? value : Math.atan2(Math.sin(value), Math.cos(value)));
    }
    if (trials.current !== session.trials) trials.set(session.trials);
    const floor = "kind" in source ? JSON.stringify([source.kind, Object.entries(source.options).sort()]) : "";
    if (floor !== shown.floor) buildFloor();
    const train = JSON.stringify(training.given);
    if (train !== shown.train) buildTraining();
    const compare = JSON.stringify(comparison.given);
    if (compare !== shown.compare) buildComparison();
    const plan = way === "policy" ? way : JSON.stringify([way, session.given[way]]);
    if (plan !== shown.way) buildPlan();
    shown = { floor, train, compare, way: plan };
  }

  function buildFloor() {
    const { source } = session;
    const info = generators.find(({ id }) => "kind" in source && id === source.kind);
    kind.value = info?.id ?? "";
    robot.disabled = !info;
    robot.value = "kind" in source ? String(source.options.shape ?? "disc") : "";
    byId("floor-fold", HTMLElement).hidden = !info;
    app.write({ "kind-summary": info?.summary ?? "From a file. Choose a generator for another floor." });
    if (!info || !("kind" in source)) return;
    // The robot is chosen above.
    const { shape, ...others } = source.options;
    const table = /** @type {ParameterInfo[]} */ (withSeed(info.options, "floor")).filter(
      ({ name }) => name !== "shape",
    );
    formOf("floor", table, others, (given, onRefused) => {
      const options = { ...given, ...(shape !== undefined && { shape }) };
      shown.floor = JSON.stringify([source.kind, Object.entries(options).sort()]);
      actions.open({ kind: source.kind, options }, onRefused);
    });
  }

  function buildPlan() {
    const { way } = session;
    if (way === "policy") {
      const nothing = make("p", { className: "hint" }, "Without a plan there is nothing to set.");
      byId("plan-settings", HTMLElement).replaceChildren(nothing);
      return;
    }
    const use = (/** @type {Settings} */ given, /** @type {Refusal} */ onRefused) => {
      session.given[way] = given;
      shown.way = JSON.stringify([way, given]);
      actions.plan(onRefused);
    };
    formOf("plan", optionsOf(way), session.given[way], use, FIRST[way]);
  }

  function buildTraining() {
    const table = /** @type {ParameterInfo[]} */ (withSeed(trainingOptions(), "training"));
    const use = (/** @type {Settings} */ given, /** @type {Refusal} */ onRefused) => {
      training.given = given;
      shown.train = JSON.stringify(given);
      actions.train(onRefused);
    };
    formOf("train", table, training.given, use, FIRST.train);
  }

  function buildComparison() {
    const table = /** @type {ParameterInfo[]} */ (withSeed(comparisonOptions(), "comparison"));
    const use = (/** @type {Settings} */ given) => {
      comparison.given = given;
      shown.compare = JSON.stringify(given);
      actions.compare();
    };
    compareForm = formOf("compare", table, comparison.given, use, FIRST.compare);
  }
}
