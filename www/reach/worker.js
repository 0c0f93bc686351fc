/** What takes longer than a frame: pictures of configuration spaces. */
import { Scenario } from "planarium";
import { handed, serve } from "../room/serve.js";

/** @import { ScenarioDocument } from "./types.js" */

const commands = {
  /** The obstacles in the configuration space of an arm of two joints. @param {ScenarioDocument} document @param {number} side  cells @returns {Uint8Array} */
  cspace(document, side) {
    const scenario = Scenario.parse(document);
    try {
      const cells = scenario.cspace({ width: side, height: side });
      return handed(cells, [cells.buffer]);
    } finally {
      scenario.free();
    }
  },
};

/** @typedef {typeof commands} Commands */

serve(commands);
