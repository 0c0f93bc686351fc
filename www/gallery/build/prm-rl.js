/** Entries of PRM-RL: the floor with its roadmap, its path, and the drives along it. */
import { encodeState } from "../../app/link.js";
import { commands } from "../../prm-rl/commands.js";
import { Floor } from "../../prm-rl/floor.js";
import { FIRST, NavigationSession } from "../../prm-rl/session.js";
import { stateRule } from "../../prm-rl/state.js";
import { drawWhole } from "../../draw/sheet.js";
import { NO_APP } from "./sheet.js";

/** @import { Remote } from "../../app/worker-client.js" */
/** @import { Commands } from "../../prm-rl/commands.js" */
/** @import { Entry } from "../format.js" */
/** @import { Documents, Opened } from "./open.js" */

/** A floor is wider than high, pixels. */
const PANE = { width: 480, height: 372 };

/** @param {Extract<Entry, { page: "prm-rl" }>} entry @param {Documents} documents @returns {Promise<Opened>} */
export async function openLearned({ state }, documents) {
  const address = `prm-rl.html#${await encodeState(state, stateRule)}`;
  const session = new NavigationSession(
    NO_APP,
    /** @type {Remote<Commands>} */ (/** @type {unknown} */ (commands)),
    documents.policies(),
  );
  const { kind, options, way } = { ...FIRST, way: session.way, ...state };
  session.open({ kind, options });
  session.setWay(way);
  await session.drive(true);
  session.setTime(Infinity);
  const floor = new Floor(session);
  return {
    address,
    pane: PANE,
    panes: [(brush) => drawWhole(floor, brush)],
  };
}
