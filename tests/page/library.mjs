/** The page's scenes and runs of them, for tests that need no browser. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Scenario } from "planarium";
import { root } from "../../scripts/run.mjs";
import { withOptions } from "../../www/domain/option-names.js";
import { SCENES, optionsAt } from "../../www/planner/scenes/scenes.js";

/** @typedef {import("../../www/domain/types.js").SceneEntry} SceneEntry */
/** @typedef {import("../../www/domain/types.js").Settings} Settings */

/** One of the page's scenes. @param {string} id @returns {SceneEntry} */
export const sceneOf = (id) => SCENES.find((scene) => scene.id === id) ?? assert.fail(`there is no scene ${id}`);

/**
 * The poses that a query names: the start, and the goal unless any will do that reaches a target.
 * @param {import("planarium").Query} query
 * @returns {number[][]}
 */
export function endsOf({ start, goal }) {
  return goal ? [start, goal] : [start];
}

/** The text of a scene that is drawn. @param {string} id */
export const textOf = (id) => readFileSync(join(root, "www", "scenes", `${id}.json`), "utf8");

/**
 * Its scenario, with sliders where they are put.
 * @param {SceneEntry} entry
 * @param {Record<string, number>} [positions]
 */
export function open(entry, positions) {
  if (entry.generate) return Scenario.generate(entry.generate.kind, optionsAt(entry, positions));
  return Scenario.parse(textOf(entry.id));
}

/** A scenario of the page as it opens. @param {string} id */
export const load = (id) => open(sceneOf(id));

/**
 * The planner of a scene as the page opens it, run to its end.
 * @param {string} id
 * @param {Record<string, number | string>} [more]
 */
export function planned(id, more) {
  const { algorithm, settings } = sceneOf(id);
  const scenario = load(id);
  const planner = scenario.planner({ algorithm: /** @type {"prm"} */ (algorithm), ...settings, ...more });
  while (planner.step(1000) === "running");
  return { scenario, planner };
}

/**
 * A run to its end, or for a number of iterations.
 * @param {Scenario} scenario
 * @param {string} algorithm
 * @param {Settings} settings
 * @param {number} [iterations]
 */
export function ran(scenario, algorithm, settings, iterations = Infinity) {
  const planner = withOptions({ ...settings, algorithm }, (options) => scenario.planner(options));
  while (planner.status === "running" && planner.iterations < iterations)
    planner.step(Math.min(500, iterations - planner.iterations));
  const rows = (/** @type {Float64Array | Uint32Array} */ all, /** @type {number} */ width) =>
    Array.from({ length: all.length / width }, (_, i) => [...all.subarray(i * width, (i + 1) * width)]);
  const { status, dimension } = planner;
  const run = {
    status,
    dimension,
    iterations: planner.iterations,
    result: planner.result(),
    vertices: rows(planner.verticesSince(0), dimension),
    edges: rows(planner.edgesSince(0), 2),
    path: rows(planner.path(), dimension),
    events: rows(planner.eventsSince(0), planner.eventWidth),
  };
  planner.free();
  return run;
}

/** Whether every step of a path is proven free. @param {Scenario} scenario @param {number[][]} path */
export function isFree(scenario, path) {
  return path.every((q, i) => scenario.check(q).free && (i === 0 || scenario.firstHit(path[i - 1], q) === null));
}

/** The obstacles that a path touches, a thousand looks a step. @param {Scenario} scenario @param {number[][]} path */
export function touchedBy(scenario, path) {
  const found = new Set();
  for (let i = 1; i < path.length; i++) {
    for (let t = 0; t <= 1; t += 0.001) {
      for (const { obstacle } of scenario.check(scenario.interpolate(path[i - 1], path[i], t)).touching)
        found.add(obstacle);
    }
  }
  return [...found];
}

/**
 * Whether every motion of a car's path is proven free again, one control after the other, and leads to the next
 * waypoint.
 * @param {Scenario} scenario
 * @param {import("planarium").ResultDocument} result
 */
export function isDriven(scenario, { path, motions = [] }) {
  return (
    motions.length === path.length - 1 &&
    motions.every(({ control: [v, phi], duration }, i) => {
      const { poses, blocked } = scenario.rollout(path[i], v, phi, duration);
      return blocked === null && scenario.distance(poses.slice(-3), path[i + 1]) < 1e-6;
    })
  );
}

/**
 * The number of the piece of the graph that each vertex is in.
 * @param {{ vertices: number[][], edges: number[][] }} run
 */
export function pieces({ vertices, edges }) {
  const piece = vertices.map((_, i) => i);
  const find = (/** @type {number} */ i) => {
    while (piece[i] !== i) i = piece[i] = piece[piece[i]];
    return i;
  };
  for (const [a, b] of edges) piece[find(a)] = find(b);
  return piece.map((_, i) => find(i));
}

/**
 * Scenes that differ from others in their world alone: all end in scenes.test.mjs, and on the page where all cases are
 * tried.
 */
export const ALIKE = ["open", "slot", "trap", "maze", "shelf", "tentacle", "corner", "turn", "lanes"];
