/** Films of this page: the accepted trajectories one after the other, and the particles along all of them. */
import { filmOf, rowOf } from "../draw/export.js";

/** @import { Figure } from "../draw/figure.js" */
/** @import { Subject } from "../widgets/films.js" */
/** @import { Experiment } from "./experiment.js" */
/** @import { Plane } from "./plane.js" */

/** Seconds in which the trajectories appear. */
const GROWTH = 6;
/** Seconds of the particles' film, at least. */
const SLOW = 3;
/** Width and height of the figure in a film, CSS pixels: the plane is a square. */
const SIDE = 480;

/** @param {Experiment} experiment @param {Figure<Plane>} figure @returns {Subject[]} */
export function filmsOf(experiment, figure) {
  const square = () => [
    /** @type {Figure<Plane>} */ (Object.create(figure, { width: { value: SIDE }, height: { value: SIDE } })),
  ];
  const lack = () => (experiment.accepted.length > 0 ? "" : "No trajectory has been accepted yet.");
  return [
    {
      id: "growth",
      title: "The trajectories",
      meaning: "The accepted trajectories up to here, one after the other.",
      lack,
      open: (width) => {
        const accepted = [...experiment.accepted];
        const then = copyOf(experiment);
        return filmOf(rowOf(square()), width, GROWTH, ([plane], part) => {
          then.accepted = accepted.slice(0, Math.round(part * accepted.length));
          Object.assign(plane, { experiment: then, isStill: true, moment: null });
        });
      },
    },
    {
      id: "particles",
      title: "The particles",
      meaning: "The particles along their trajectories.",
      lack,
      open: (width) => {
        const then = copyOf(experiment);
        const { round } = figure.drawing;
        return filmOf(rowOf(square()), width, Math.max(SLOW, round), ([plane], part) => {
          // Long after they were received, no trajectory glows.
          Object.assign(plane, { experiment: then, isStill: false, now: Infinity, moment: part * round });
        });
      },
    },
  ];
}

/**
 * What the experiment shows now, without the rejected trajectory: later ones do not change it.
 * @param {Experiment} experiment
 * @returns {Experiment}
 */
function copyOf(experiment) {
  return Object.assign(Object.create(experiment), {
    options: { ...experiment.options },
    accepted: [...experiment.accepted],
    rejected: null,
    isLastRejected: false,
  });
}
