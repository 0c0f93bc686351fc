/** Entries of Reach: the robot and, with two joints, its configuration space. */
import { encodeState } from "../../app/link.js";
import { reachMethods } from "planarium/full";
import { DEFAULTS, IkRun } from "../../reach/ik-run.js";
import { ReachSession } from "../../reach/session.js";
import { Square } from "../../reach/square.js";
import { openState, stateRule } from "../../reach/state.js";
import { Workspace } from "../../reach/workspace.js";
import { drawWhole } from "../../draw/sheet.js";
import { CELLS, NO_APP } from "./sheet.js";

/** @import { Settings } from "../../domain/types.js" */
/** @import { Brush } from "../../draw/figure.js" */
/** @import { IkPanel } from "../../reach/ik-panel.js" */
/** @import { State } from "../../reach/state.js" */
/** @import { Entry } from "../format.js" */
/** @import { Documents, Opened } from "./open.js" */

/** The session that opens a state. @param {State} state @returns {Promise<ReachSession>} */
async function sessionOf(state) {
  const session = new ReachSession(NO_APP);
  let method = reachMethods().find(({ id }) => id === "damped-least-squares");
  /** @type {Settings} */
  let settings = DEFAULTS;
  // The part of the panel that opening a state uses.
  const panel = {
    choose(/** @type {string} */ id, /** @type {Settings} */ given) {
      method = reachMethods().find((one) => one.id === id);
      settings = {
        ...Object.fromEntries(
          Object.entries(DEFAULTS).filter(([name]) => method?.parameters.some((one) => one.name === name)),
        ),
        ...given,
      };
    },
    advance(/** @type {number} */ steps) {
      if (!method) throw new Error("There is no such method of inverse kinematics.");
      const { robot, target, orientation } = session;
      const run = (session.run = new IkRun(robot, { target, orientation, start: robot.q, method, settings }));
      run.step(steps);
      const index =
        run.isRunning || run.solutions.length === 0
          ? -1
          : Math.max(
              0,
              run.solutions.findIndex(({ isFree }) => isFree),
            );
      session.chosen = index;
      session.moveTo(run.solutions[index]?.q ?? run.last.q);
    },
  };
  await openState(session, /** @type {IkPanel} */ (/** @type {unknown} */ (panel)), state);
  return session;
}

/** @param {Extract<Entry, { page: "reach" }>} entry @param {Documents} documents @returns {Promise<Opened>} */
export async function openReach({ state: given, world: name }, documents) {
  const { world, robot } = name ? documents.world(name) : { world: undefined, robot: given.robot };
  const state = { ...given, world, robot };
  const session = await sessionOf(/** @type {State} */ ({ ...stateRule.defaults, ...state, robot: robot ?? {} }));
  const panes = [
    new Workspace(session),
    ...(session.robot.isArm && session.robot.dimension === 2 ? [squareOf(session)] : []),
  ].map((pane) => (/** @type {Brush} */ brush) => drawWhole(pane, brush));
  return { address: `reach.html#${await encodeState(state, stateRule)}`, panes };
}

/** @param {ReachSession} session */
function squareOf(session) {
  const square = new Square(session);
  square.setCells(session.robot.scenario.cspace({ width: CELLS, height: CELLS }), CELLS);
  return square;
}
