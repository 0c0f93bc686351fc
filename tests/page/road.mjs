/** The road on which tests of the keyboard car drive. */
import { Scenario } from "planarium";
import { car } from "../package/scenes.mjs";

/** @import { ScenarioDocument } from "planarium" */

/** The package's car, on its road to a goal before the wall. @type {ScenarioDocument} */
export const ROAD = {
  ...car,
  queries: [
    { name: "home", start: [0.3, 0.5, 0], goal: [0.9, 0.5, 0], goal_tolerance: { translation: 0.1, rotation: 0.5 } },
  ],
};

export const scenario = Scenario.parse(ROAD);
