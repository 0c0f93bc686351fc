/**
 * The documents of the built-in scenes, by id: a file of `scenes/`, which need not be in the gallery, or a scene made
 * by a generator.
 */
import { Scenario } from "planarium";
import { loadScene } from "../../app/resources.js";
import { SCENES } from "./scenes.js";

/** @import { ScenarioDocument } from "../../domain/types.js" */

/** @param {string} id @returns {Promise<ScenarioDocument>} */
export async function sceneDocument(id) {
  const { generate, title } = SCENES.find((entry) => entry.id === id) ?? {};
  const scenario = generate ? Scenario.generate(generate.kind, generate.options) : Scenario.parse(await loadScene(id));
  try {
    const document = scenario.document();
    return { ...document, title: title ?? document.title };
  } finally {
    scenario.free();
  }
}
