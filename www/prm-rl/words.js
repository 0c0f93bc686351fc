/** The sentences of the page. */
import { counted, grouped } from "../app/dom.js";
import { capital } from "../widgets/format.js";
import { countsOf } from "./session.js";

/** @import { NavigationSession } from "./session.js" */
/** @import { NavigationMethod } from "planarium/full" */

/** The methods of driving. @type {Record<NavigationMethod, { title: string, does: string }>} */
export const WAY_WORDS = {
  policy: {
    title: "Policy alone",
    does: "The policy drives straight to the goal, without a plan. It sees only as far as its rays reach.",
  },
  straight: {
    title: "Straight edges",
    does: "A roadmap of straight edges, proven free for a disc around the robot. A simple controller follows them without using the sensor.",
  },
  "straight-margin": {
    title: "Straight + margin",
    does: "Straight edges that are proven for a larger disc, which leaves room for errors. A simple controller follows them without using the sensor.",
  },
  "straight-policy": {
    title: "Straight + policy",
    does: "A roadmap of straight edges, proven free for a disc around the robot. The policy drives from one vertex to the next.",
  },
  "straight-margin-policy": {
    title: "Straight + margin + policy",
    does: "Straight edges that are proven for a larger disc. The policy drives from one vertex to the next.",
  },
  "prm-rl": {
    title: "PRM-RL",
    does: "A roadmap of edges that the policy drives reliably. It drives along them, from one vertex to the next.",
  },
};

/** The methods of a comparison. */
export const COMPARED = /** @type {NavigationMethod[]} */ (Object.keys(WAY_WORDS));

/** @param {NavigationSession} session */
export function sentenceOf(session) {
  if (session.part === "train") return trainingSentence(session);
  if (session.part === "compare") return comparisonSentence(session);
  const { refusal, run, way } = session;
  if (refusal) return `The ${refusal.end} is in collision: move it away from obstacles.`;
  if (run.status === "none")
    return "PRM-RL plans long routes for a policy that has learned to drive short distances. Drag the ring to move the robot and the diamond to move its goal, then press Plan.";
  if (run.status === "running")
    return `The roadmap grows: ${counted(run.vertices.length / 2, "vertex", "vertices")}, ${counted(run.edges.length / 2, "edge")}.`;
  if (run.status === "exhausted")
    return `${capital(run.result?.explanation ?? "no path was found")}${run.result?.reason === "not-connected" ? ", by edges that are reliable enough" : ""}.`;
  if (run.drives.length > 0) return `${WAY_WORDS[way].title}: ${drivenText(session)}`;
  if (way === "policy") return "The policy alone has no plan: it drives towards the goal.";
  const least = leastOf(session);
  return least
    ? `A path of ${counted(run.path.length - 1, "edge")}. Its least reliable edge succeeded in ${least.count} of ${least.of} rollouts.`
    : `A path of ${counted(run.path.length - 1, "straight edge")}, each proven free.`;
}

/** @param {NavigationSession} session */
function drivenText({ run: { drives } }) {
  const { reached, collision, swing, timeout } = countsOf(drives);
  const others = [
    collision > 0 ? counted(collision, "collision") : "",
    swing > 0 ? `${grouped(swing)} with too much swing` : "",
    timeout > 0 ? `${grouped(timeout)} timed out` : "",
  ]
    .filter(Boolean)
    .join(", ");
  return `${grouped(reached)} of ${counted(drives.length, "drive")} reached the goal${others ? `; ${others}` : ""}.`;
}

/** The fewest successful rollouts of an edge of the path, in either direction. @param {NavigationSession} session */
export function leastOf({ run: { rollouts } }) {
  if (!rollouts || rollouts.length === 0) return null;
  return { count: Math.min(...rollouts.flatMap(({ forward, backward }) => [forward, backward])), of: rollouts[0].of };
}

/** @param {NavigationSession} session */
function trainingSentence({ training: { status, generation, generations, history } }) {
  if (status === "refused") return "These settings are not valid; see the message in the panel.";
  if (status === "beginning") return "The short tasks are generated.";
  const last = history.at(-1);
  if (!last)
    return "Each generation tries random changes to the policy on short tasks and keeps what drives better. Press Train.";
  const solved = `${Math.round(100 * last.reached)}\u00a0% of the tasks solved`;
  if (status === "over")
    return `Trained for ${counted(generation, "generation")}: ${solved}. Use this policy in Plan and Compare.`;
  return `Generation ${grouped(generation)} of ${grouped(generations)}: ${solved}.`;
}

/** @param {NavigationSession} session */
function comparisonSentence({ comparison: { status, executions, count, iterations, summary } }) {
  if (status === "none") return "Six methods drive to the same far goals, each several times with noise. Press Run.";
  if (executions.length === 0) return `Three roadmaps are built: ${counted(iterations, "iteration")}.`;
  if (status !== "over") return `${grouped(executions.length)} of ${counted(count, "drive")}.`;
  const shares = summary.map(({ method, reached }) => `${WAY_WORDS[method].title} ${percentText(reached.share)}`);
  return `Goals reached: ${shares.join(", ")}.`;
}

/** A share in percent. @param {number | null} share */
export function percentText(share) {
  return share === null ? "\u2013" : `${Math.round(100 * share)} %`;
}
