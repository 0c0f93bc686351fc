/** Entries of Neighbours: the list, the target and its neighbours. */
import { encodeState } from "../../app/link.js";
import { drawWorkspace } from "../../draw/ground.js";
import { addLine, setStroke } from "../../draw/marks.js";
import { commands } from "../../neighbours/commands.js";
import { ROBOTS } from "../../neighbours/robots.js";
import { FEW, NeighbourSession } from "../../neighbours/session.js";
import { Square } from "../../neighbours/square.js";
import { openState, stateRule } from "../../neighbours/state.js";
import { Workspace } from "../../neighbours/workspace.js";
import { drawWhole } from "../../draw/sheet.js";
import { NO_APP, drawDots, thinned } from "./sheet.js";

/** @import { Remote } from "../../app/worker-client.js" */
/** @import { Brush } from "../../draw/figure.js" */
/** @import { Commands } from "../../neighbours/commands.js" */
/** @import { State } from "../../neighbours/state.js" */
/** @import { Entry } from "../format.js" */
/** @import { Documents, Opened } from "./open.js" */

/** Robots and dots of the list that are drawn, at most. */
const MOST = { robots: 120, dots: 1000 };

/** @param {Extract<Entry, { page: "neighbours" }>} entry @param {Documents} documents @returns {Promise<Opened>} */
export async function openNeighbours({ state: given, world }, documents) {
  const state = /** @type {State} */ ({ ...stateRule.defaults, ...given, document: world && documents.world(world) });
  const session = new NeighbourSession(
    NO_APP,
    /** @type {Remote<Commands>} */ (/** @type {unknown} */ (commands)),
    ROBOTS[0],
  );
  const square = new Square(session);
  await openState(session, state);
  const { scenario, document, footprints, isPlanar } = session;
  const { tips } = session.list;
  const rows = thinned(
    Array.from({ length: session.count }, (_, i) => i),
    MOST.dots,
  );
  const workspace = new Workspace(session);
  const drawSquare = (/** @type {Brush} */ brush) => {
    const { context, palette } = brush;
    square.drawSquare(brush, session.coordinates);
    drawDots(
      context,
      rows.map((i) => square.place(session.row(i))),
      palette.growth,
      2.2,
      0.6,
    );
    square.drawTop(brush);
  };
  const drawPlane = (/** @type {Brush} */ brush) => {
    const { context, palette } = brush;
    if (footprints.length <= FEW) return drawWhole(workspace, brush);
    const view = (workspace.view = drawWorkspace(brush, scenario, document));
    context.save();
    setStroke(context, palette.growth, 1);
    context.globalAlpha = footprints.length > 100 ? 0.12 : 0.3;
    context.beginPath();
    for (const part of thinned(footprints, MOST.robots).flat()) {
      if (part.type === "capsule") addLine(context, ...view.place(part.a), ...view.place(part.b));
      else if (part.type === "polygon") {
        for (const [i, vertex] of [...part.vertices, part.vertices[0]].entries())
          context[i === 0 ? "moveTo" : "lineTo"](...view.place(vertex));
      }
    }
    context.stroke();
    context.restore();
    drawDots(
      context,
      rows.map((i) => view.place(tips.subarray(2 * i))),
      palette.growth,
      2.2,
      0.6,
    );
    workspace.drawTop(brush);
  };
  return {
    address: `neighbours.html#${await encodeState(state, stateRule)}`,
    panes: isPlanar ? [drawPlane, drawSquare] : [drawPlane],
  };
}
