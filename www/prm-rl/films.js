/** Films of this page: the drives along the path. */
import { filmOf, rowOf } from "../draw/export.js";

/** @import { Figure } from "../draw/figure.js" */
/** @import { Subject } from "../widgets/films.js" */
/** @import { Floor } from "./floor.js" */
/** @import { NavigationSession } from "./session.js" */

/** Seconds of a drive in one of a film, and of a film at least and at most. */
const PACE = 4;
const LENGTH = [3, 15];

/** @param {NavigationSession} session @param {Figure<Floor>} figure @returns {Subject[]} */
export function filmsOf(session, figure) {
  return [
    {
      id: "drives",
      title: "Drives",
      meaning: "All drives along the path, with the rays of one.",
      isOffered: () => session.part === "plan",
      lack: () => (session.run.drives.length > 0 ? "" : "Drive first."),
      open: (width) => {
        const { end, runs } = session;
        return filmOf(
          rowOf([figure]),
          width,
          Math.min(LENGTH[1], Math.max(LENGTH[0], end / PACE)),
          (drawings, part) => {
            if (session.runs !== runs)
              throw Object.assign(new Error("The plan changed during the export."), { code: "run-replaced" });
            for (const drawing of drawings)
              drawing.session = Object.create(session, { time: { value: part * end }, edge: { value: null } });
          },
        );
      },
    },
  ];
}
