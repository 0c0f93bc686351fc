/** Entries of Trajectories: the plane with those accepted, or a single particle. */
import { View } from "planarium/draw";
import { encodeState } from "../../app/link.js";
import { setStroke } from "../../draw/marks.js";
import { commands } from "../../trajectories/commands.js";
import { Experiment, movingAverage } from "../../trajectories/experiment.js";
import { Particle, curvesOf } from "../../trajectories/particle.js";
import { Plane } from "../../trajectories/plane.js";
import { stateRule } from "../../trajectories/state.js";
import { drawWhole } from "../../draw/sheet.js";
import { drawDots, thinned } from "./sheet.js";

/** @import { TrajectoryOptions } from "planarium/full" */
/** @import { Remote } from "../../app/worker-client.js" */
/** @import { Commands } from "../../trajectories/commands.js" */
/** @import { Movement } from "../../trajectories/state.js" */
/** @import { Entry } from "../format.js" */
/** @import { Opened } from "./open.js" */
/** @import { Pane } from "./sheet.js" */

/** Trajectories drawn, at most. */
const MOST = 500;
const MARGIN = { left: 18, right: 18, top: 28, bottom: 28 };

/** @param {Extract<Entry, { page: "trajectories" }>} entry @returns {Promise<Opened>} */
export async function openTrajectories({ state }) {
  const { given = {}, tried = 0, one } = state;
  const address = `trajectories.html#${await encodeState(state, stateRule)}`;
  if (one) return { address, panes: [particlePane(one)] };
  const experiment = new Experiment(/** @type {Remote<Commands>} */ (/** @type {unknown} */ (commands)));
  await experiment.begin(/** @type {TrajectoryOptions} */ (given));
  await experiment.advance(tried, () => {});
  return { address, panes: [planePane(experiment), triesPane(experiment)] };
}

/** @param {Movement} movement @returns {Pane} */
function particlePane(movement) {
  const particle = Object.assign(Object.create(Particle.prototype), { movement, ...curvesOf(movement) });
  return (brush) => particle.draw(brush);
}

/** @param {Experiment} experiment @returns {Pane} */
function planePane(experiment) {
  const shown = Object.assign(Object.create(experiment), { accepted: thinned(experiment.accepted, MOST) });
  const plane = Object.assign(new Plane(shown), {
    drawDots: (
      /** @type {CanvasRenderingContext2D} */ context,
      /** @type {[number, number][]} */ lines,
      /** @type {string} */ colour,
      /** @type {number} */ radius,
    ) =>
      drawDots(
        context,
        lines.map((line) => plane.view.place(line)),
        colour,
        2 * radius,
        1,
      ),
  });
  const { ground, growth } = plane.layers;
  return (brush) => drawWhole({ layers: { ground, growth } }, brush);
}

/**
 * Tries for each accepted trajectory, as dots, and their moving average.
 * @param {Experiment} experiment
 * @returns {Pane}
 */
function triesPane({ accepted }) {
  const tries = accepted.map((one) => one.tries);
  const means = movingAverage(tries);
  const most = 2 * Math.max(1, ...means.map(([, mean]) => mean));
  return ({ context, palette, width, height }) => {
    const view = new View({ min: [0, 0], max: [tries.length, most] }, width, height, MARGIN, true);
    setStroke(context, palette.line, 1);
    context.strokeRect(view.x(0), view.y(most), tries.length * view.scaleX, most * view.scaleY);
    drawDots(
      context,
      tries.flatMap((count, i) => (count <= most ? [view.place([i + 1, count])] : [])),
      palette.growth,
      2,
      0.5,
    );
    setStroke(context, palette.path, 2.4);
    context.beginPath();
    for (const point of means) context.lineTo(...view.place(point));
    context.stroke();
    context.fillStyle = palette.quiet;
    context.font = "12px system-ui, sans-serif";
    context.textBaseline = "top";
    context.textAlign = "center";
    context.fillText("accepted trajectories", width / 2, view.y(0) + 8);
    context.textBaseline = "bottom";
    context.textAlign = "left";
    context.fillText("tries for each, and the mean of 20", view.x(0), view.y(most) - 4);
  };
}
