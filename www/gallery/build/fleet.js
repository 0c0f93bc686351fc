/** Entries of Fleet: the floor with every robot's path, at a moment of the plan. */
import { encodeState } from "../../app/link.js";
import { drawWhole } from "../../draw/sheet.js";
import { commands } from "../../fleet/commands.js";
import { Floor } from "../../fleet/floor.js";
import { FleetSession } from "../../fleet/session.js";
import { openState, stateRule } from "../../fleet/state.js";
import { NO_APP } from "./sheet.js";

/** @import { Remote } from "../../app/worker-client.js" */
/** @import { Commands } from "../../fleet/commands.js" */
/** @import { State } from "../../fleet/state.js" */
/** @import { Entry } from "../format.js" */
/** @import { Opened } from "./open.js" */

/** Pixels. */
const PANE = { width: 480, height: 300 };

/** @param {Extract<Entry, { page: "fleet" }>} entry @returns {Promise<Opened>} */
export async function openFleet({ state }) {
  const address = `fleet.html#${await encodeState(state, stateRule)}`;
  const session = new FleetSession(NO_APP, /** @type {Remote<Commands>} */ (/** @type {unknown} */ (commands)));
  await openState(session, /** @type {State} */ ({ ...stateRule.defaults, ...state }));
  const floor = new Floor(session);
  floor.colours = coloursOf(session.robots.length);
  return {
    address,
    pane: PANE,
    panes: [(brush) => drawWhole(floor, brush)],
  };
}

/**
 * The page's colours of robots, equal in lightness, for both themes: a picture does not know which one it will be in.
 * @param {number} count
 */
export function coloursOf(count) {
  return Array.from({ length: count }, (_, i) => {
    const hue = Math.round(250 + (360 * i) / count) % 360;
    return `light-dark(oklch(0.53 0.135 ${hue}),oklch(0.78 0.135 ${hue}))`;
  });
}
