/**
 * The settings: a ready fleet, a generator with its options, a planner with its options. The forms are built from the
 * core's tables.
 */
import { Fleet, fleetGenerators, fleetPlanners } from "planarium/full";
import { byId, make } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { withOptions } from "../domain/option-names.js";
import { withSeed } from "../widgets/field.js";
import { SIDE, makeGallery } from "../widgets/gallery.js";
import { formOf } from "../widgets/form.js";
import { fleetThumbnail } from "./floor.js";
import { SCENES } from "./scenes.js";

/** @import { FleetGeneratorId, FleetPlannerId, GenerateFleetOptions } from "planarium/full" */
/** @import { ParameterInfo, Settings } from "../domain/types.js" */
/** @import { Refusal } from "../app/room.js" */
/** @import { FleetSession, Source } from "./session.js" */
/** @import { Entry, Generated } from "./scenes.js" */

/** Options of a planner that are not folded away. */
const SHOWN = ["seed"];

/**
 * @param {FleetSession} session
 * @param {{ choose: (entry: Entry) => void, load: (source: Source, onRefused?: Refusal) => void, plan: (onRefused:
 *   Refusal) => void }} actions
 */
export function showPanel(session, actions) {
  const { app } = session;
  const generators = fleetGenerators();
  const planners = fleetPlanners();
  const [kind, planner] = ["kind", "planner"].map((id) => byId(id, HTMLSelectElement));
  kind.append(...generators.map(({ id, title }) => make("option", { value: id }, title)));
  planner.append(...planners.map(({ id, title }) => make("option", { value: id }, title)));
  const gallery = makeGallery(SCENES, actions.choose);
  const drawAll = () => {
    for (const entry of SCENES) gallery.draw(entry.id, thumbnailOf(entry));
  };
  /** The form of the generator, and the kind that it is for. @type {{ kind: string, options: ReturnType<typeof formOf> | null }} */
  let shown = { kind: "", options: null };
  app.onTheme(drawAll);
  drawAll();
  kind.addEventListener("change", () =>
    actions.load({ kind: /** @type {FleetGeneratorId} */ (kind.value), options: {} }),
  );
  planner.addEventListener("change", () => {
    session.algorithm = /** @type {FleetPlannerId} */ (planner.value);
    app.changed();
    actions.plan(() => false);
  });
  const differs = comparer();
  app.onShow(show);

  /** @param {Generated} generated */
  function thumbnailOf(generated) {
    const fleet = withOptions(generated.options, (/** @type {GenerateFleetOptions} */ named) =>
      Fleet.generate(generated.kind, named),
    );
    const document = fleet.toJSON();
    fleet.free();
    return fleetThumbnail(document, SIDE, app.look);
  }

  /** Shows where the fleet is from. The form that a change is from keeps its focus. */
  function showSource() {
    const { source } = session;
    const entry = SCENES.find(
      (one) => "kind" in source && one.kind === source.kind && sameOptions(one.options, source.options),
    );
    gallery.mark(entry?.id ?? null);
    app.write({ what: entry?.what ?? "" });
    byId("make", HTMLElement).hidden = !("kind" in source);
    if (!("kind" in source)) shown = { kind: "", options: null };
    else if (source.kind !== shown.kind || !shown.options || !sameOptions(shown.options.given, source.options))
      shown = { kind: source.kind, options: optionsOf(source) };
  }

  /** @param {Generated} source */
  function optionsOf(source) {
    kind.value = source.kind;
    const info = generators.find(({ id }) => id === source.kind) ?? generators[0];
    app.write({ "kind-summary": info.summary });
    const table = /** @type {ParameterInfo[]} */ (withSeed(info.options, "fleet"));
    return formOf("fleet", table, source.options, (options, onRefused) =>
      actions.load({ kind: source.kind, options }, onRefused),
    );
  }

  /** Shows the planner and its options. */
  function showPlanner() {
    const { algorithm, given } = session;
    planner.value = algorithm;
    const info = planners.find(({ id }) => id === algorithm) ?? planners[0];
    app.write({ "planner-summary": info.summary });
    const table = /** @type {ParameterInfo[]} */ (withSeed(info.parameters));
    const use = (/** @type {Settings} */ settings, /** @type {Refusal} */ onRefused) => {
      given[algorithm] = settings;
      actions.plan(onRefused);
    };
    formOf("plan", table, given[algorithm], use, SHOWN);
  }

  function show() {
    const { source, algorithm, canCompose, document } = session;
    if (!document) return;
    if (differs("source", source)) showSource();
    for (const option of planner.options) option.disabled = option.value === "composite" && !canCompose;
    byId("no-composite", HTMLElement).hidden = canCompose;
    if (differs("planner", algorithm, document)) showPlanner();
  }
}

/** @param {Settings} a @param {Settings} b */
function sameOptions(a, b) {
  const text = (/** @type {Settings} */ settings) => JSON.stringify(Object.entries(settings).sort());
  return text(a) === text(b);
}
