/// <reference lib="esnext.disposable" preserve="true" />
/** A scenario: the world, the robot in it, and the queries to plan for. */
/** @import { RawScenario } from "./planarium_glue.js" */
import * as argument from "./arguments.js";
import { makeDrive, obstructed } from "./drive.js";
import { PlanariumError } from "./error.js";
import { Handle, key } from "./handle.js";
import { Neighbours, makeNeighbours } from "./neighbours.js";
import { Planner, makePlanner } from "./planner.js";
import { Reach, followedOf, makeReach, nearestOf } from "./reach.js";
import { callWith } from "./runtime.js";

/** @import { Drive } from "./drive.js" */
/** @import { Box, Check, Clearance, Configuration, CspaceOptions, Followed, GenerateOptions, GeneratorId, NearestPoint, NeighboursOptions, Part, PlannerOptions, Point, ReachOptions, Robot, Rollout, SampleOptions, ScenarioDocument, Touching } from "./types.js" */

/**
 * A parsed, checked scenario: it answers questions about configurations and motions, and makes planners.
 * Lengths are in metres, angles in radians, counter-clockwise, y points up.
 */
export class Scenario {
  /** @type {Handle<RawScenario>} */
  #handle;
  /** @type {number} */
  #dimension;

  /**
   * @param {symbol} secret
   * @param {RawScenario} raw
   * @private
   */
  constructor(secret, raw) {
    if (secret !== key) {
      throw new PlanariumError("illegal-constructor", "A Scenario comes from Scenario.parse or Scenario.generate.");
    }
    this.#handle = new Handle(raw, "Scenario");
    this.#dimension = raw.dimension();
  }

  /**
   * Reads a scenario document.
   * @param {string | object} input  JSON text, or the document as an object
   * @returns {Scenario}
   * @throws {PlanariumError} what is wrong, with a JSON pointer to it: `invalid-json`, `unknown-field`,
   *   `missing-field`, `wrong-type`, `out-of-range`, `degenerate-polygon`, `base-in-collision`, ...
   */
  static parse(input) {
    return callWith(() => [argument.documentText(input)], (core, text) => new Scenario(key, core.RawScenario.parse(text)));
  }

  /**
   * Makes a scenario from a seed; the same kind and options always make the same scenario. `generators()` tells all; in short:
   * - `forest`: an arm among triangles (`links`);
   * - `clutter`: a disc, an arm, a body or a car among convex polygons (`robot`, `links`, `radius`, `count`, `smallest`, `largest`, `gap`);
   * - `discs`: the same among discs, and `placement` says whether they stand `"apart"` or are `"overlapping"`;
   * - `maze`: a disc in a maze that always has a path (`difficulty`, `radius`, `thickness`);
   * - `gap`: a disc, an arm, a body or a car before a wall with one gap (`robot`, `links`, `radius`, `width`, `thickness`);
   * - `bug-trap`: a disc in a pocket whose mouth is turned inwards (`radius`, `mouth`, `start`, `turn`).
   * @param {GeneratorId} kind
   * @param {GenerateOptions} [options]
   * @returns {Scenario}
   * @throws {PlanariumError} `unknown-generator`, `unknown-field`, `out-of-range`, `wrong-type`, `unknown-type`, `not-finite`
   */
  static generate(kind, options) {
    return callWith(
      () => [argument.text(kind, "kind"), argument.options(options)],
      (core, name, text) => new Scenario(key, core.RawScenario.generate(name, text)),
    );
  }

  /** Name of the scenario. @returns {string} */
  get name() {
    return this.#handle.call((raw) => raw.name());
  }

  /** Title for people; the name where the document has none. @returns {string} */
  get title() {
    return this.#handle.call((raw) => raw.title());
  }

  /** What moves. @returns {Robot["type"]} */
  get robot() {
    return /** @type {Robot["type"]} */ (this.#handle.call((raw) => raw.robot()));
  }

  /** Degrees of freedom: the length of a configuration. @returns {number} */
  get dimension() {
    return this.#handle.call((raw) => raw.dimension());
  }

  /**
   * The document, complete with its defaults.
   * @returns {ScenarioDocument}
   */
  document() {
    return this.#handle.call((raw) => raw.document());
  }

  /**
   * The same as `document()`, so that `JSON.stringify(scenario)` writes the document.
   * @returns {ScenarioDocument}
   */
  toJSON() {
    return this.document();
  }

  /**
   * The box worth drawing: the bounds, or what the arm can reach and the obstacles.
   * @returns {Box}
   */
  extent() {
    const [left, low, right, high] = this.#handle.call((raw) => raw.extent());
    return { min: [left, low], max: [right, high] };
  }

  /**
   * Whether a configuration is free, and every pair that touches where it is not.
   * @param {Configuration} q
   * @returns {Check}
   */
  check(q) {
    const pairs = this.#handle.callWith(() => [this.#configuration(q, "q")], (raw, at) => raw.check(at));
    /** @type {Touching[]} */
    const touching = [];
    for (let i = 0; i < pairs.length; i += 2) touching.push({ part: pairs[i], obstacle: pairs[i + 1] < 0 ? "bounds" : pairs[i + 1] });
    return { free: touching.length === 0, touching };
  }

  /**
   * How near the robot is to the nearest obstacle, for viewers. The bounds do not count.
   * @param {Configuration} q
   * @returns {Clearance | null} null if the robot touches something, or if there are no obstacles
   */
  clearance(q) {
    const numbers = this.#handle.call((raw) => raw.clearance(this.#configuration(q, "q")));
    if (numbers.length === 0) return null;
    const [distance, part, obstacle, ax, ay, bx, by] = numbers;
    return { distance, part, obstacle, points: [[ax, ay], [bx, by]] };
  }

  /**
   * The robot's parts in the world at a configuration, to draw.
   * @param {Configuration} q
   * @returns {Part[]}
   */
  footprint(q) {
    const numbers = this.#handle.callWith(() => [this.#configuration(q, "q")], (raw, at) => raw.footprint(at));
    if (this.robot === "disc") return [{ type: "disc", center: [numbers[0], numbers[1]], radius: numbers[2] }];
    if (this.robot !== "arm") {
      const vertices = Array.from({ length: numbers.length / 2 }, (_, i) => /** @type {[number, number]} */ ([numbers[2 * i], numbers[2 * i + 1]]));
      return [{ type: "polygon", vertices }];
    }
    /** @type {Part[]} */
    const parts = [];
    for (let i = 0; i < numbers.length; i += 5) {
      const [ax, ay, bx, by, radius] = numbers.subarray(i, i + 5);
      parts.push({ type: "capsule", a: [ax, ay], b: [bx, by], radius });
    }
    return parts;
  }

  /**
   * The point that a picture of the workspace plots for a configuration: an arm's tip, a disc's centre, (x, y) of a body or a car.
   * @param {Configuration} q
   * @returns {[number, number]}
   */
  endEffector(q) {
    const [x, y] = this.#handle.callWith(() => [this.#configuration(q, "q")], (raw, at) => raw.end_effector(at));
    return [x, y];
  }

  /**
   * `endEffector` for many configurations in one call.
   * @param {Float64Array | readonly number[]} vertices  rows of `dimension` numbers
   * @returns {Float64Array} rows of two numbers, x and y
   */
  endEffectors(vertices) {
    const dimension = this.#dimension;
    return this.#handle.callWith(() => [argument.rows(vertices, dimension, "vertices")], (raw, given) => {
      const points = new Float64Array((given.length / dimension) * 2);
      argument.blocks(given, dimension, (block, row) => points.set(raw.end_effectors(block), row * 2));
      return points;
    });
  }

  /**
   * The configuration at the fraction `t` of the straight motion from `a` to `b`; circles go the short way round.
   * @param {Configuration} a
   * @param {Configuration} b
   * @param {number} t  from 0 to 1
   * @returns {Float64Array}
   */
  interpolate(a, b, t) {
    return this.#handle.callWith(
      () => [this.#configuration(a, "a"), this.#configuration(b, "b"), argument.finite(t, "/t")],
      (raw, from, to, along) => raw.interpolate(from, to, along));
  }

  /**
   * Distance between two configurations in the scenario's own metric.
   * @param {Configuration} a
   * @param {Configuration} b
   * @returns {number}
   */
  distance(a, b) {
    return this.#handle.callWith(() => this.#ends(a, b), (raw, from, to) => raw.distance(from, to));
  }

  /**
   * Where the straight motion from `a` to `b` is first refused: the fraction at which the first stretch begins that could not
   * be proven free. All before it is proven. `null` means the whole motion is proven free. A car's own ways are asked by `rollout`.
   * @param {Configuration} a
   * @param {Configuration} b
   * @returns {number | null}
   */
  firstHit(a, b) {
    return this.#handle.callWith(() => this.#ends(a, b), (raw, from, to) => raw.first_hit(from, to)) ?? null;
  }

  /**
   * Picture of the configuration space of an arm of two joints: one byte a cell, row by row from the lowest angles,
   * taken at cell centres; 1 is collision.
   * @param {CspaceOptions} size
   * @returns {Uint8Array}
   * @throws {PlanariumError} `unsupported` for any other robot
   */
  cspace(size) {
    /** @returns {[number, number]} */
    const read = () => {
      const { width, height } = argument.options(size);
      return [argument.count(width, "width"), argument.count(height, "height")];
    };
    return this.#handle.callWith(read, (raw, width, height) => raw.cspace(width, height));
  }

  /**
   * The angles that the picture of `cspace` spans: -pi to pi for a circle, the limits for a joint that has them.
   * @returns {[[number, number], [number, number]]}
   * @throws {PlanariumError} `unsupported` for any robot but an arm of two joints
   */
  cspaceRange() {
    const [low1, high1, low2, high2] = this.#handle.call((raw) => raw.cspace_range());
    return [[low1, high1], [low2, high2]];
  }

  /**
   * For each coordinate of a configuration, whether it is a circle (an angle that wraps).
   * @returns {boolean[]}
   */
  circles() {
    return Array.from(this.#handle.call((raw) => raw.circles()), (wraps) => wraps === 1);
  }

  /**
   * Starts a planner on one of the scenario's queries. The planner lives on when the scenario is freed.
   * @param {PlannerOptions} [options]
   * @returns {Planner}
   * @throws {PlanariumError} `unknown-planner`, `unknown-query`, `unknown-parameter`, `out-of-range`,
   *   `start-in-collision`, `goal-in-collision` (the message names what touches what); `unsupported` where the planner is not for
   *   the robot, or the car cannot follow the curves of `steering`; `missing-field` where a car by controls has no `goal_tolerance`
   */
  planner(options) {
    return this.#handle.callWith(() => [argument.options(options)], (raw, text) => makePlanner(raw.planner(text)));
  }

  /**
   * Goes on with a roadmap that `planner.roadmap("json")` or `planner.roadmap("binary")` has kept, of this world and robot:
   * all of it is proven again, start and goal of the query are joined to it, and it is searched. Nothing grows any more.
   * Options are those of the search and of the path; how the roadmap was built is what it says itself.
   * @param {string | Uint8Array} roadmap
   * @param {PlannerOptions} [options]  `algorithm` is the planner that built it, and may be left out
   * @returns {Planner}
   * @throws {PlanariumError} `other-scenario` where it belongs to another world or robot; `invalid-roadmap` where it is
   *   damaged or not free; `out-of-range` and `unsupported` for options that contradict it; and what `planner` throws
   */
  resume(roadmap, options) {
    return this.#handle.callWith(
      () => [argument.textOrBytes(roadmap, "roadmap"), argument.options(options)],
      (raw, kept, text) => makePlanner(raw.resume(kept, text)));
  }

  /**
   * Makes an empty index of configurations of the scenario's robot, which finds the nearest of many. It lives on when the
   * scenario is freed.
   * @param {NeighboursOptions} [options]  `index` is `"linear"`, `"kd-tree"` (default) or `"forest"`; `metric` of an arm is `"sum"`
   *   (default), `"euclidean"` or `"naive"`; of a forest `trees`, `leaf`, `candidates` and `seed`: `neighbourIndexes()` tells all
   * @returns {Neighbours}
   * @throws {PlanariumError} `out-of-range`, `unknown-parameter`, `wrong-type`, `not-finite`
   */
  neighbours(options) {
    return this.#handle.callWith(() => [argument.options(options)], (raw, text) => makeNeighbours(raw.neighbours(text), this.#dimension));
  }

  /**
   * Configurations drawn uniformly; the same that a planner of this seed draws with its uniform sampler.
   * @param {number} n  at most 1,000,000
   * @param {SampleOptions} [options]  `seed`: integer from 0 (default) to 2^53 - 1; `free`: whether only free ones are kept (default false)
   * @returns {Float64Array} rows of `dimension` numbers
   * @throws {PlanariumError} `out-of-range`, `not-finite`, `wrong-type`; `unsupported` where 100,000 draws in a row are in collision
   */
  sampleConfigurations(n, options) {
    /** @returns {[number, number, boolean]} */
    const read = () => {
      const { seed = 0, free = false } = argument.options(options);
      return [argument.count(n, "n"), argument.count(seed, "seed"), argument.truth(free, "free")];
    };
    return this.#handle.callWith(read, (raw, count, seed, isFree) => raw.sample_configurations(count, seed, isFree));
  }

  /**
   * Puts the scenario's car under a driver's hand. The drive lives on when the scenario is freed.
   * @param {Configuration} [q]  where it starts; the start of the first query where absent
   * @returns {Drive}
   * @throws {PlanariumError} `unsupported` for any robot but a car, `start-in-collision`, `unknown-query` where there is neither
   */
  drive(q) {
    return this.#handle.callWith(
      () => [q === undefined ? new Float64Array(0) : this.#configuration(q, "q")],
      (raw, start) => makeDrive(raw.drive(start)),
    );
  }

  /**
   * Where the car comes from `q` when one control is held: the pose after each step of 0.01 s (`integration_step`) as long as
   * it is proven free.
   * @param {Configuration} q
   * @param {number} v         speed, metres a second, within the car's limits, or 0
   * @param {number} phi       angle of the front wheels, radians, within the car's limits; to the left where positive
   * @param {number} duration  seconds, of a million steps at most
   * @returns {Rollout}
   * @throws {PlanariumError} `unsupported` for any robot but a car, `out-of-range`
   */
  rollout(q, v, phi, duration) {
    const numbers = this.#handle.callWith(
      () => [this.#configuration(q, "q"), argument.finite(v, "/v"), argument.finite(phi, "/phi"), argument.finite(duration, "/duration")],
      (raw, from, speed, steering, seconds) => raw.rollout(from, speed, steering, seconds));
    return { poses: numbers.slice(2), seconds: numbers[1], blocked: obstructed(numbers[0]) };
  }

  /**
   * Starts a search for joint angles that bring the arm's tip to a target. The run lives on when the scenario is freed.
   * @param {ReachOptions} options
   * @returns {Reach}
   * @throws {PlanariumError} `unsupported` for any robot but an arm, for an orientation of an arm of one link, and where there is no
   *   closed form; `missing-field` without a `target`; `out-of-range` for an unknown `method` and a `start` outside the limits;
   *   `unknown-parameter`, `wrong-dimension`, `wrong-type`, `not-finite`
   */
  reach(options) {
    return this.#handle.callWith(() => [argument.options(options)], (raw, text) => makeReach(raw.reach(text)));
  }

  /**
   * Where the arm goes from `q` when its tip follows a point: smoothly, within its limits, as near as it gets from there. For
   * dragging: call it with the last configuration whenever the hand moves.
   * @param {Configuration} q
   * @param {Point} target
   * @param {number} [orientation]  wanted absolute angle of the last link, in radians
   * @returns {Followed}
   * @throws {PlanariumError} `unsupported` for any robot but an arm, `out-of-range` for a `q` outside the limits
   */
  follow(q, target, orientation) {
    return followedOf(this.#handle.callWith(
      () => [this.#configuration(q, "q"), argument.point(target, "target"), angle(orientation)],
      (raw, from, to, wanted) => raw.follow(from, to, wanted)));
  }

  /**
   * The point nearest to the target that the arm's tip can reach, and a configuration that does: exactly, within the limits.
   * With an orientation, the nearest in that orientation.
   * @param {Point} target
   * @param {number} [orientation]  wanted absolute angle of the last link, in radians
   * @returns {NearestPoint}
   * @throws {PlanariumError} `unsupported` for any robot but an arm
   */
  nearestReachable(target, orientation) {
    return nearestOf(this.#handle.callWith(
      () => [argument.point(target, "target"), angle(orientation)],
      (raw, to, wanted) => raw.nearest_reachable(to, wanted)));
  }

  /** Gives the memory back. Any use afterwards throws `freed`; freeing twice does nothing. @returns {void} */
  free() {
    this.#handle.free();
  }

  /** The same as `free`, for `using`. @returns {void} */
  [Symbol.dispose]() {
    this.#handle.free();
  }

  /** @param {unknown} a @param {unknown} b @returns {[Float64Array, Float64Array]} */
  #ends(a, b) {
    return [this.#configuration(a, "a"), this.#configuration(b, "b")];
  }

  /**
   * @param {unknown} value
   * @param {string} name
   */
  #configuration(value, name) {
    return argument.configuration(value, this.#dimension, name);
  }
}

/** An orientation where one is given. @param {unknown} value */
function angle(value) {
  return value === undefined ? undefined : argument.finite(value, "/orientation");
}
