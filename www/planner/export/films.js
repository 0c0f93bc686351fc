/**
 * Films of the planner's page: the growth of a run, the robot along its path, a drive by keys, the motion of one
 * control.
 */
import { filmOf } from "../../draw/export.js";
import { followPaths, layoutOfStage, sameRun, showTime } from "./picture.js";

/** @import { Subject } from "../../widgets/films.js" */
/** @import { Driven } from "../stage/lane.js" */
/** @import { Page } from "./export.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */
/** @import { Rollout } from "planarium" */

/**
 * @typedef {object} Drive   of a car, by keys
 * @property {{ steps: number } | null} state
 * @property {Rollout | null} rollout
 * @property {[number, number, number]} rolled
 * @property {() => Again | null} again
 */
/** @typedef {{ pose: Float64Array, driven: Driven }} Moment */
/** @typedef {{ seconds: number, at: (part: number) => Moment, free: () => void }} Again   a drive once more */
/**
 * @typedef {object} Drives   what films take of the page's session
 * @property {{ now: number, column: number }} clock
 * @property {boolean} travelling
 * @property {PathPlayback[]} playbacks
 * @property {Drive | null} driving
 */

/** Seconds of a film of a growth, and of a drive at most and at least. */
const GROWTH = 6;
const DRIVE = { least: 1, most: 12 };

/** @param {Page} page @returns {Subject[]} */
export function filmsOf(page) {
  const { session } = page;
  /**
   * A film of the stage.
   * @param {number} width  pixels
   * @param {number} seconds
   * @param {boolean} whole  with whole paths and without the configuration in hand
   * @param {(panes: Pane[], part: number) => void} place  puts what is filmed at a part, 0 to 1
   */
  const film = (width, seconds, whole, place) =>
    filmOf(layoutOfStage(session, whole), width, seconds, place, sameRun(session));
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
        const { now, column } = session.clock;
        const place = (/** @type {Pane[]} */ panes, /** @type {number} */ part) =>
          showTime(panes, column, Math.round(now * part));
        return { ...film(width, GROWTH, true, place), frames };
      },
    },
    {
      id: "path",
      title: "The robot",
      meaning: `The robot along its path. One that is timed, and takes more than ${DRIVE.most} s, is shown faster.`,
      lack: () => (session.travelling ? "" : "No path yet: it can be saved once the run has ended."),
      open: (width) => film(width, lasting(session.playbacks[0].seconds), true, followPaths),
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
          ...film(width, lasting(again.seconds), false, (panes, part) => drive(panes, again.at(part))),
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
        return film(width, lasting(rollout.seconds), false, (panes, part) => {
          const row = Math.round(part * (rows - 1));
          drive(panes, {
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

/** @param {Pane[]} panes @param {Moment} moment */
function drive(panes, { pose, driven }) {
  for (const { lane } of panes)
    Object.assign(lane?.shown ?? {}, { hand: pose, driven, check: { free: true, touching: [] } });
}
