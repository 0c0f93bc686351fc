/** A film of this page: the robots from their starts to their goals. */
import { filmOf, rowOf } from "../draw/export.js";

/** @import { Figure } from "../draw/figure.js" */
/** @import { Subject } from "../widgets/films.js" */
/** @import { Floor } from "./floor.js" */
/** @import { FleetSession } from "./session.js" */

/** Seconds of a film, at least and at most. */
const SHORTEST = 3;
const LONGEST = 12;

/** @param {FleetSession} session @param {Figure<Floor>} figure @returns {Subject[]} */
export function filmsOf(session, figure) {
  return [
    {
      id: "robots",
      title: "The robots",
      meaning: "The robots from their starts to their goals.",
      lack: () =>
        session.end > 0 && (session.isStraight || session.run.status !== "running") ? "" : "No robot has a plan yet.",
      open: (width) => {
        const { end } = session;
        const then = Object.create(session, { selected: { value: null } });
        return filmOf(rowOf([figure]), width, Math.min(LONGEST, Math.max(SHORTEST, end)), ([floor], part) => {
          then.time = part * end;
          floor.session = then;
        });
      },
    },
  ];
}
