/**
 * Films of the planner's page: the growth of a run, the robot along its path, a drive by keys, the motion of one
 * control.
 */
import { contextOf, even } from "../../draw/film.js";
import { requireSize } from "../../draw/export.js";
import { sameRun } from "./exporter.js";
import { layoutOfStage } from "./layout.js";
import { Picture } from "./picture.js";

/** @import { Film } from "../../draw/film.js" */
/** @import { Subject } from "../../widgets/films.js" */
/** @import { Driven } from "../lane.js" */
/** @import { Page } from "../page.js" */
/** @import { Session } from "../session.js" */
/**
 * @typedef {(picture: Picture, part: number) => number | void} Place   puts what is filmed at a part, 0 to 1; may
 *   return the time of the run
 */

/** Seconds of a film of a growth, and of a drive at most and at least. */
const GROWTH = 6;
const DRIVE = { least: 1, most: 12 };

/** @param {Page} page @returns {Subject[]} */
export function filmsOf(page) {
  const { session } = page;
  const isCar = () => page.facts?.robot === "car";
  return [
    {
      id: "growth",
      title: "The growth",
      meaning: "The run up to here, in equal steps.",
      isCounted: true,
      lack: () =>
        page.state?.lanes.some(({ status }) => status === "none")
          ? "No planner has run."
          : session.clock.now === 0
            ? "Nothing has happened yet."
            : "",
      open: (width, frames) => {
        const {
          clock: { now },
        } = session;
        return { ...filmOf(session, width, GROWTH, true, (_, part) => Math.round(now * part)), frames };
      },
    },
    {
      id: "path",
      title: "The robot",
      meaning: "The robot along its path.",
      lack: () => (session.travelling ? "" : "No path yet: it can be saved once the run has ended."),
      open: (width) =>
        filmOf(session, width, session.playbacks[0].duration, true, (picture, part) => picture.place(part)),
    },
    {
      id: "drive",
      title: "The drive",
      meaning: `The drive by keys so far. One of more than ${DRIVE.most} s is shown faster.`,
      isOffered: isCar,
      lack: () => (session.driving?.state?.steps ? "" : "Nothing has been driven."),
      open: (width) => {
        const again = session.driving?.again();
        if (!again) throw new Error("Nothing has been driven.");
        return {
          ...filmOf(session, width, lasting(again.seconds), false, (picture, part) => drive(picture, again.at(part))),
          close: again.free,
        };
      },
    },
    {
      id: "control",
      title: "One control",
      meaning: "The car along the motion of one control.",
      isOffered: isCar,
      lack: () => (session.driving?.rollout ? "" : "Show the motion of one control first."),
      open: (width) => {
        const { shown, driving } = session;
        const { rollout, rolled } = driving ?? {};
        if (!rollout || !rolled || !shown?.driven) throw new Error("No control is shown.");
        const { driven } = shown;
        const rows = rollout.poses.length / 3;
        return filmOf(session, width, lasting(rollout.seconds), false, (picture, part) => {
          const row = Math.round(part * (rows - 1));
          drive(picture, {
            pose: rollout.poses.slice(3 * row, 3 * row + 3),
            driven: { ...driven, steering: rolled[1] },
          });
        });
      },
    },
  ];
}

/** @param {number} seconds */
function lasting(seconds) {
  return Math.min(DRIVE.most, Math.max(DRIVE.least, seconds));
}

/** @param {Picture} picture @param {{ pose: Float64Array, driven: Driven }} moment */
function drive({ shown }, { pose, driven }) {
  Object.assign(shown, { hand: pose, driven, check: { free: true, touching: [] } });
}

/**
 * A film of the stage.
 * @param {Session} session
 * @param {number} width  pixels
 * @param {number} seconds
 * @param {boolean} whole  with whole paths and without the configuration in hand
 * @param {Place} place
 * @returns {Film}
 */
function filmOf(session, width, seconds, whole, place) {
  const layout = layoutOfStage();
  const ratio = width / layout.width;
  const height = even(layout.height * ratio);
  requireSize(layout.width, layout.height, ratio, "choose a smaller size");
  const requireSameRun = sameRun(session);
  const picture = new Picture(session, layout.sheets, ratio, () => contextOf(1, 1, true).canvas, whole);
  return {
    width,
    height,
    seconds,
    *draw(context, part) {
      requireSameRun();
      for (const _ of picture.draw(place(picture, part) ?? undefined)) {
        yield;
        requireSameRun();
      }
      picture.compose(context);
    },
  };
}
