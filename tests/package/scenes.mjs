/** Small scenarios of the package's tests, and what they do with them. */
import assert from "node:assert/strict";
import { PlanariumError } from "planarium";

/** @typedef {import("planarium").ScenarioDocument} ScenarioDocument */

/** A thick arm of two joints between two obstacles; its query has a path. @type {ScenarioDocument} */
export const arm = {
  format: "planarium-scenario-1",
  name: "two-joints",
  world: {
    obstacles: [
      {
        type: "polygon",
        vertices: [
          [1.2, 0.5],
          [1.6, 0.5],
          [1.6, 0.9],
          [1.2, 0.9],
        ],
      },
      { type: "disc", center: [-1.0, 0.8], radius: 0.3 },
    ],
  },
  robot: { type: "arm", base: [0, 0], links: [1, 0.8], radius: 0.05 },
  queries: [{ name: "over", start: [0, 0], goal: [2, 0.5] }],
};

/** A disc that must go round a wall. @type {ScenarioDocument} */
export const disc = {
  format: "planarium-scenario-1",
  name: "round-the-wall",
  title: "Round the wall",
  world: {
    bounds: { min: [0, 0], max: [10, 10] },
    obstacles: [
      {
        type: "polygon",
        vertices: [
          [4.9, 0],
          [5.1, 0],
          [5.1, 8],
          [4.9, 8],
        ],
      },
    ],
  },
  robot: { type: "disc", radius: 0.4 },
  queries: [{ name: "across", start: [2, 2], goal: [8, 2] }],
};

/** A car on a road that ends at a wall. @type {ScenarioDocument} */
export const car = {
  format: "planarium-scenario-1",
  name: "dead-end",
  world: {
    bounds: { min: [0, 0], max: [2, 2] },
    obstacles: [
      { type: "disc", center: [0.2, 1.8], radius: 0.05 },
      {
        type: "polygon",
        vertices: [
          [1.5, 0],
          [1.6, 0],
          [1.6, 1.2],
          [1.5, 1.2],
        ],
      },
    ],
  },
  robot: {
    type: "car",
    shape: {
      type: "polygon",
      vertices: [
        [-0.1, -0.05],
        [0.1, -0.05],
        [0.1, 0.05],
        [-0.1, 0.05],
      ],
    },
    wheelbase: 0.2,
    speed: [-0.5, 0.5],
    steering: [-Math.PI / 4, Math.PI / 4],
  },
  queries: [
    { name: "home", start: [0.5, 0.5, 0], goal: [1.8, 0.5, 0], goal_tolerance: { translation: 0.1, rotation: 0.5 } },
  ],
};

/** An L that must turn to get through a gap. @type {ScenarioDocument} */
export const body = {
  format: "planarium-scenario-1",
  name: "through-the-gap",
  world: {
    bounds: { min: [0, 0], max: [2.4, 1.6] },
    obstacles: [
      {
        type: "polygon",
        vertices: [
          [1.17, 0],
          [1.23, 0],
          [1.23, 0.55],
          [1.17, 0.55],
        ],
      },
      { type: "disc", center: [1.2, 1.25], radius: 0.2 },
    ],
  },
  robot: {
    type: "rigid_body",
    shape: {
      type: "polygon",
      vertices: [
        [-0.06, -0.06],
        [0.34, -0.06],
        [0.34, 0.06],
        [0.06, 0.06],
        [0.06, 0.34],
        [-0.06, 0.34],
      ],
    },
  },
  queries: [{ name: "through", start: [0.4, 0.4, 0], goal: [2, 1.1, 3] }],
};

/** A robot's type, and a scene for it. @type {Record<import("planarium").Robot["type"], ScenarioDocument>} */
export const scenes = { arm, disc, rigid_body: body, car };

/** @import { PlannerOptions, ResumeOptions } from "planarium" */

/**
 * Options that are made at run time, which no type can describe.
 * @param {any} made
 * @returns {PlannerOptions & ResumeOptions}
 */
export const options = (made) => made;

/** Runs a planner to its end. @param {import("planarium").Planner} planner @param {number} [slice] */
export function finish(planner, slice = 1000) {
  while (planner.step(slice) === "running");
  return planner;
}

/** A proxy that throws at every touch. @param {object} [target] @returns {any} */
export function revoked(target = []) {
  const { proxy, revoke } = Proxy.revocable(target, {});
  revoke();
  return proxy;
}

/**
 * Checks that bad input is an error with a stable code and a pointer to it.
 * @param {() => unknown} work @param {string} code @param {string} [pointer] @param {RegExp} [message]
 */
export function fails(work, code, pointer, message = /.{11}/) {
  assert.throws(work, (error) => {
    assert.ok(error instanceof PlanariumError && error instanceof Error, String(error));
    assert.deepEqual(
      [error.name, error.code, pointer === undefined ? undefined : error.pointer],
      ["PlanariumError", code, pointer],
      error.message,
    );
    assert.match(error.message, message);
    return true;
  });
}
