/** The state of the page in a frame: numbers, texts and flags, with no handle of the core. */
import { errorInfo } from "../app/error-info.js";
import { unitOf } from "../domain/names.js";
import { EVENT, PAST } from "./run-log/columns.js";
import { NO_RUN } from "./run-log/lane-state.js";
import { gapOf } from "./optimum.js";
import { isInformed } from "./stage/informed.js";
import { poseSentence, sentenceOf, summary, turnsSentence } from "./story.js";

/** @import { Session } from "./session.js" */
/** @import { LaneState } from "./run-log/lane-state.js" */
/** @import { Lane } from "./stage/lane.js" */

/** @typedef {ReturnType<typeof report>} State */

/** @param {Session} session */
export function report(session) {
  const { clock, shown, lanes, settled, byHand, editor, refusal } = session;
  const [sentence, isBad] = sentenceOf(session);
  const [playback] = session.playbacks;
  const pose = shown?.hand ?? (playback && playback.drawn >= 1 ? playback.pose : null);
  return {
    /** `unit`: the time in a step; `wanted`: the time that will be shown. */
    clock: { now: clock.now, head: clock.head, isRace: clock.isRace, unit: clock.unit, wanted: clock.wanted },
    playing: clock.playing,
    growing: session.growing,
    travelling: session.travelling,
    along: playback ? playback.at : 0,
    /** Of a path that is timed: the time shown and that of the end, seconds. */
    timed: playback?.timed ? { time: playback.at * playback.timed.period, end: playback.timed.period } : null,
    settled,
    view: { ...session.view },
    sentence,
    isBad,
    inHand: shown?.hand !== null,
    pose: pose ? Array.from(pose) : null,
    touching:
      shown?.hand && shown.check
        ? { text: poseSentence(shown.scenario, shown.check), free: shown.check.free }
        : { text: "", free: true },
    turns: turnsSentence(session),
    arrived: shown?.hand !== null && byHand.game.arrived,
    /** The element under the pointer; vertex -1 is a mere configuration. */
    hover: shown?.hover
      ? { vertex: shown.hover.vertex, text: byHand.pointing?.text(shown.hover) ?? "", free: shown.hover.check.free }
      : null,
    lanes: lanes.map((lane) => laneState(lane)),
    summary: lanes.map((lane) => summary(lane.scenario.title || lane.scenario.name, lane.run)),
    isEditing: Boolean(editor?.on),
    isEdited: editor?.isChanged ?? false,
    canAsk: session.canAsk,
    canCertify: session.canCertify,
    /** The subdivision that is shown. */
    certificate: session.certifying?.on ? { verdict: session.certifying.verdict } : null,
    /**
     * The name of the query that a roadmap was asked, empty if it is none of the scenario's; null if it was not asked.
     */
    asked: lanes[0]?.asked?.query ?? null,
    refusal: refusal && { ...errorInfo(refusal.error), lane: refusal.lane },
  };
}

/** @param {Lane} lane */
function laneState(lane) {
  const { run, playback, scenario, standing, asked, keepsAway, optimum: truth } = lane;
  const { algorithm } = lane.plan;
  /** @type {LaneState["optimum"]} */
  const optimum = truth && (truth.isExact ? "shortest" : "reference");
  if (!run) return { ...NO_RUN, algorithm, standing, optimum };
  const { past, status, kind, isProven } = run;
  const isEnd = run.isNewest && run.hasResult;
  const stats = run.isNewest ? run.now.stats : null;
  const state = {
    ...NO_RUN,
    algorithm,
    standing,
    optimum,
    status,
    phase: run.phase,
    iteration: run.shown,
    made: run.made,
    vertices: past[PAST.vertices],
    edges: past[PAST.edges] - run.countOf(EVENT.rewired),
    checks: past[PAST.configurationChecks],
    motions: past[PAST.motionChecks],
    evaluations: past[PAST.clearanceEvaluations],
    cost: past[PAST.length],
    // A cost is not compared with a length.
    gap: keepsAway ? null : gapOf(past[PAST.length], truth),
    length:
      isEnd && status === "solved"
        ? (run.result.blended_length ?? run.result.length)
        : run.phase === "improving" && past[PAST.length] < Infinity && !keepsAway
          ? past[PAST.length]
          : null,
    unit: unitOf(scenario.document().robot),
    reason: isEnd ? (run.result.reason ?? null) : null,
    fingerprint: isEnd ? run.result.fingerprint : "",
    kind,
    isProven,
    isMiss: playback?.isMiss ?? false,
    hasGuards: run.has(EVENT.guard),
    isSearched: run.has(EVENT.expanded) && !asked,
    isApart: run.pieces !== null && !asked,
    isInformed: isInformed(lane),
    hasRejected: run.has(EVENT.rejected) || run.has(EVENT.discarded),
    hasRefused: run.has(EVENT.refused),
    waiting: run.frontier.count,
    raw: playback?.raw && !keepsAway ? run.rawLength : null,
    waypoints: status === "solved" ? run.result.path.length : null,
    visited: run.isTree ? null : run.visited,
    rejected: run.countOf(EVENT.rejected),
    stats: stats && {
      nearest: stats.nearest_queries,
      build: stats.build_seconds,
      search: stats.search_seconds,
      rate: run.made / (stats.build_seconds + stats.search_seconds),
    },
    marks: [...run.marks()],
  };
  if (!asked) return state;
  const { result, visited, seconds } = asked;
  const isSolved = result.status === "solved";
  return {
    ...state,
    status: result.status,
    reason: result.reason ?? null,
    length: isSolved ? result.length : null,
    waypoints: isSolved ? result.path.length : null,
    visited,
    stats: state.stats && { ...state.stats, search: seconds },
  };
}
