/**
 * The stage as a layout for images and films: panes of the same kinds and sizes, with light copies of the lanes. The
 * stage itself does not change.
 */
import { Frontier } from "../run-log/frontier.js";

/** @import { Caption, Layout } from "../../draw/export.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { Stage } from "../stage/stage.js" */
/**
 * @typedef {{ stage: Stage, shown: Shown | null, lanes: Lane[], plannings: number }} Session   what a picture takes of
 *   the page's session
 */
/** A lane that does not follow the stage. @typedef {Lane & { run: (RunLog & { shown: number }) | null }} Still */

/**
 * @param {Session} session
 * @param {boolean} [whole]   with the whole path and without a pose by hand
 * @returns {Layout}
 */
export function layoutOfStage(session, whole = false) {
  const { stage } = session;
  const { look } = stage;
  if (!session.shown || !look) throw new Error("Nothing is shown.");
  /** The state that the lanes share. @type {Shown} */
  const shown = {
    ...session.shown,
    view: { ...session.shown.view },
    hover: null,
    overlay: null,
    rough: false,
    ...(whole ? { hand: null, check: null, driven: null } : {}),
  };
  const lanes = session.lanes.map((lane) => stillOf(lane, shown, whole));
  const places = [...stage.places.values()];
  const host = /** @type {HTMLElement} */ (places[0].figure.element.parentElement).getBoundingClientRect();
  return {
    width: host.width,
    height: host.height,
    look,
    places: places.flatMap(({ kind, lane, figure: { box, element, caption, note, width, height } }) => {
      if (!lanes[lane]) return [];
      const drawing = stage.paneOf(kind);
      drawing.glow.enabled = false;
      drawing.lane = lanes[lane];
      const { left, top } = box.getBoundingClientRect();
      const above = /** @type {HTMLElement} */ (element.querySelector("figcaption"));
      return [
        {
          drawing,
          x: left - host.left,
          y: top - host.top,
          width,
          height,
          caption: captionOf(above, host, caption, note),
        },
      ];
    }),
  };
}

/**
 * @param {HTMLElement} element
 * @param {DOMRect} host
 * @param {HTMLElement} caption
 * @param {HTMLElement} note
 * @returns {Caption}
 */
function captionOf(element, host, caption, note) {
  const { left, top, width } = element.getBoundingClientRect();
  const padding = parseFloat(getComputedStyle(element).paddingLeft);
  return {
    x: left - host.left + padding,
    y: top - host.top,
    width: width - 2 * padding,
    name: caption.innerText,
    note: note.innerText,
  };
}

/** Shows the iterations at a time. @param {Pane[]} panes @param {number} column @param {number} time */
export function showTime(panes, column, time) {
  for (const { lane } of panes) {
    const { run } = /** @type {Still} */ (lane);
    if (!run) continue;
    run.shown = run.iterationAt(column, time);
    run.frontier.follow();
  }
}

/** Puts the robots on their paths. @param {Pane[]} panes @param {number} part  0 to 1 */
export function followPaths(panes, part) {
  for (const { lane } of panes) if (lane?.playback) lane.playback.at = part;
}

/**
 * A copy of a lane that does not follow the stage.
 * @param {Lane} lane
 * @param {Shown} shown
 * @param {boolean} whole
 * @returns {Lane}
 */
function stillOf(lane, shown, whole) {
  const { run, end, asked } = lane;
  const still = (/** @type {PathPlayback} */ playback) =>
    Object.create(playback, {
      drawn: { value: whole ? 1 : playback.drawn },
      at: { value: playback.at, writable: true },
    });
  /** @type {Still["run"]} */
  const its = run && Object.create(run, { shown: { value: run.shown, writable: true } });
  if (run && its) {
    Object.defineProperty(its, "frontier", { value: new Frontier(its, run.adjacency) });
    its.frontier.follow();
  }
  return Object.create(lane, {
    shown: { value: shown },
    run: { value: its },
    end: { value: end && still(end) },
    asked: { value: asked?.playback ? { ...asked, playback: still(asked.playback) } : asked },
  });
}

/**
 * What holds as long as no other run begins.
 * @param {Session} session
 * @returns {() => void} to be called after every pause
 * @throws {Error} `run-replaced`
 */
export function sameRun(session) {
  const { plannings } = session;
  return () => {
    if (session.plannings !== plannings)
      throw Object.assign(new Error("Another run started during the export."), { code: "run-replaced" });
  };
}
