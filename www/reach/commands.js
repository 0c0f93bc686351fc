/** The commands of this page, which its worker runs. */
import { Scenario } from "planarium/full";

/** @import { ScenarioDocument } from "planarium/full" */

export const commands = {
  /**
   * The obstacles in the configuration space of an arm of two joints.
   * @param {ScenarioDocument} document
   * @param {number} side  cells
   * @returns {Uint8Array}
   */
  cspace(document, side) {
    const scenario = Scenario.parse(document);
    try {
      return scenario.cspace({ width: side, height: side });
    } finally {
      scenario.free();
    }
  },
};

/** @typedef {typeof commands} Commands */
