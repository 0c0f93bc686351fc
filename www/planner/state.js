/** What the page is told of a frame: numbers, words and switches, no handles. */
import { faultOf } from "../app/fault.js";
import { unitOf } from "../domain/names.js";
import { EVENT, PAST } from "./run-log/run-log.js";
import { poseSentence, summary } from "./story.js";

/** @import { Session } from "./session.js" */
/** @import { Lane } from "./lane.js" */
/** @import { LaneState, State } from "../domain/types.js" */

/** @param {Session} session @returns {State} */
export function report(session) {
  const { clock, shown, lanes, settled } = session;
  const [sentence, isBad] = session.sentence;
  const [playback] = session.playbacks;
  const pose = shown?.hand ?? (playback && playback.drawn >= 1 ? playback.configuration(playback.at) : null);
  return {
    clock: { now: clock.now, head: clock.head, isRace: clock.isRace, unit: clock.unit, wanted: clock.wanted },
    playing: clock.playing,
    growing: session.growing,
    travelling: session.travelling,
    along: playback ? playback.at : 0,
    settled,
    view: { ...session.view },
    sentence, isBad,
    inHand: shown?.hand !== null,
    pose: pose ? Array.from(pose) : null,
    touching: shown?.hand && shown.check ? { text: poseSentence(shown.scenario, shown.check), free: shown.check.free } : { text: "", free: true },
    arrived: shown?.hand !== null && session.byHand.game.arrived,
    hover: shown?.hover ? { vertex: shown.hover.vertex, text: session.byHand.pointing?.text(shown.hover) ?? "", free: shown.hover.check.free } : null,
    lanes: lanes.map((lane) => laneState(lane)),
    summary: lanes.map((lane) => summary(lane.scenario.title || lane.scenario.name, lane.run)),
    curves: session.curvesKey,
    edit: session.editor?.state ?? null,
    isEdited: session.editor?.isChanged ?? false,
    drive: session.driving?.report ?? null,
    refusal: session.refusal && { ...faultOf(session.refusal.error), lane: session.refusal.lane },
  };
}

/** @param {Lane} lane @returns {LaneState} */
function laneState({ plan, run, playback, scenario, standing }) {
  if (!run) {
    return {
      algorithm: plan.algorithm, status: "none", phase: "", iteration: 0, made: 0, vertices: 0, edges: 0, checks: 0, motions: 0, evaluations: 0,
      cost: Infinity, length: null, unit: "", fingerprint: "", kind: "roadmap", isProven: true, isMiss: false, hasGuards: false, isSearched: false, isApart: false, marks: [], standing,
      hasRejected: false, hasRefused: false, waiting: 0, raw: null, segments: null, stats: null,
    };
  }
  const { past, status } = run;
  const isEnd = run.isNewest && run.hasResult;
  const stats = run.isNewest ? run.now.stats : null;
  return {
    algorithm: plan.algorithm, status, phase: run.phase, iteration: run.shown, made: run.made,
    vertices: past[PAST.vertices], edges: past[PAST.edges], checks: past[PAST.checks], motions: past[PAST.motions], evaluations: past[PAST.evaluations],
    cost: past[PAST.cost],
    length: isEnd && status === "solved" ? run.result.length : null,
    unit: unitOf(scenario.robot),
    fingerprint: isEnd ? run.result.fingerprint : "",
    kind: run.kind, isProven: run.isProven, isMiss: playback?.isMiss ?? false, hasGuards: run.has(EVENT.guard), isSearched: run.has(EVENT.expanded), isApart: run.pieces !== null,
    hasRejected: run.has(EVENT.rejected) || run.has(EVENT.discarded), hasRefused: run.has(EVENT.refused),
    waiting: run.frontier.count,
    raw: playback?.raw ? run.rawLength : null,
    segments: status === "solved" ? run.result.path.length - 1 : null,
    stats: stats && { nearest: stats.nearest_queries, seconds: stats.build_seconds + stats.search_seconds },
    marks: [...run.marks()], standing,
  };
}
