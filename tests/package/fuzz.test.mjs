/**
 * A hundred thousand random calls with hostile arguments: every one returns or throws a PlanariumError, and the core
 * survives.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Drive, Neighbours, PlanariumError, Planner, Scenario } from "planarium";
import { Scenario as Full } from "planarium/full";
import { seeded } from "../page/seeded.mjs";
import { arm, body, car, disc, finish, revoked } from "./scenes.mjs";

/** Calls for each seed. */
const CALLS = 35_000;

/** An array whose numbers are gone. */
function detached() {
  const array = new Uint8Array(8);
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
}

for (const seed of [1, 2, 3]) {
  test(`hostile calls, seed ${seed}`, () => {
    const { next: draw, below, pick } = seeded(seed);
    const number = () =>
      pick([
        0,
        -0,
        1,
        2,
        3,
        -1,
        0.5,
        1e-300,
        1e300,
        -1e300,
        NaN,
        Infinity,
        -Infinity,
        2 ** 31,
        2 ** 32,
        2 ** 53,
        2 ** 53 - 1,
        Number.MIN_VALUE,
        draw(),
        draw() * 6 - 3,
      ]);
    /** @type {(depth?: number) => any} */
    const anything = (depth = 0) => {
      switch (below(depth > 2 ? 8 : 14)) {
        case 0:
          return undefined;
        case 1:
          return null;
        case 2:
        case 3:
          return number();
        case 4:
          return pick([
            "",
            "prm",
            "rrt-connect",
            "over",
            "across",
            "forest",
            "clutter",
            "sum",
            "rrt-control",
            "sst",
            "dubins",
            "reeds-shepp",
            "euler",
            "through",
            "home",
            "\u0000",
            "\ud800",
            "x".repeat(below(2000)),
            "{}",
            "[[[[1]]]]",
            "faster",
            "left",
            "linear",
            "forest",
            "naive",
          ]);
        case 5:
          return pick([true, false, 10n, Symbol.iterator, () => 1]);
        case 6:
          return Float64Array.from({ length: below(5) }, number);
        case 7:
          return [number(), number()];
        case 8:
          return Array.from({ length: below(4) }, () => anything(depth + 1));
        case 9:
          return pick([
            revoked(),
            detached(),
            new Date(0),
            new Map([[1, 2]]),
            /x/,
            new Error("x"),
            new Uint8Array(below(9)),
            new ArrayBuffer(8),
            new DataView(new ArrayBuffer(8)),
          ]);
        case 10:
          return { length: number(), 0: 1, 1: 1 };
        case 11:
          return new Proxy([0, 0], {
            get() {
              throw pick([new Error("trap"), "text", undefined, Object.create(null), revoked()]);
            },
          });
        case 12:
          return Object.fromEntries(
            Array.from({ length: below(5) }, () => [
              pick([
                "algorithm",
                "query",
                "seed",
                "samples",
                "k",
                "step",
                "shortcut",
                "metric",
                "steering",
                "blossom",
                "durationSteps",
                "integration",
                "pruningRadius",
                "robot",
                "maxIterations",
                "max_iterations",
                "tolerance",
                "width",
                "height",
                "links",
                "format",
                "__proto__",
                "toJSON",
                "a",
                "index",
                "trees",
                "leaf",
                "candidates",
                "free",
                "n",
                "speed",
                "acceleration",
                "turnRate",
                "verify",
                "arcs",
                "driveTolerance",
              ]),
              anything(depth + 1),
            ]),
          );
        default:
          return mutated();
      }
    };
    /** A real document with one value replaced. */
    const mutated = () => {
      const document = structuredClone(pick([arm, disc, body, car, result, timed]));
      /** @type {any} */ let place = document;
      for (;;) {
        const key = pick(Object.keys(place));
        if (typeof place[key] !== "object" || Object.keys(place[key]).length === 0 || draw() < 0.2) {
          place[key] = draw() < 0.5 ? number() : anything(3);
          return draw() < 0.3
            ? JSON.stringify(document, (_, value) => (typeof value === "bigint" ? String(value) : value))
            : document;
        }
        place = place[key];
      }
    };

    const scenario = Scenario.parse(arm);
    const full = Full.parse(arm);
    const result = finish(scenario.planner({ shortcut: 20, blend: 0.5 })).result();
    const trajectory = full.time(result, { speed: 1, acceleration: 1 });
    const timed = trajectory.toJSON();
    /** @type {any[]} */
    const handles = [
      full,
      trajectory,
      scenario,
      Scenario.parse(disc),
      Scenario.parse(body),
      Scenario.parse(car),
      Scenario.parse(car).drive(),
      Scenario.parse(arm).neighbours(),
      Scenario.parse(body).neighbours({ index: "forest", trees: 2 }),
      Scenario.parse(disc).neighbours({ index: "linear" }),
      scenario.planner(),
      scenario.planner({ algorithm: "prm", samples: 20 }),
      Scenario.parse(body).planner(),
      Scenario.parse(car).planner(),
      Scenario.parse(car).planner({ algorithm: "sst", improveIterations: 100 }),
      Scenario.parse(car).planner({ algorithm: "prm", samples: 20, steering: "dubins" }),
    ];
    const standing = handles.length;
    /** @type {Map<string, number>} */
    const codes = new Map();
    let returned = 0;
    for (let call = 0; call < CALLS; call += 1) {
      const target = pick([Scenario, Scenario, ...handles]);
      const names =
        target === Scenario
          ? ["parse", "generate"]
          : target === full
            ? ["time", "trajectory", "verifyTrajectory", "judge", "verify"]
            : Object.getOwnPropertyNames(Object.getPrototypeOf(target)).filter(
                (name) => name !== "constructor" && !name.startsWith("__"),
              );
      const name = pick(names);
      // A handle that is gone teaches little more: few are freed, so that most calls reach the core.
      if (name === "free" && draw() < 0.99) continue;
      const args = Array.from({ length: below(4) }, () => anything());
      // A path and a trajectory that are right, so that more is read than their first field.
      if (/^(?:time|verify)/.test(name) && draw() < 0.6) args[0] = result;
      if (name === "time" && draw() < 0.5) args[1] = { speed: 1, acceleration: number() };
      if (name === "verifyTrajectory" && draw() < 0.3) args[1] = trajectory;
      // A run may not be made longer than the test can wait.
      if (name === "sampleConfigurations" && draw() < 0.9) args[0] = below(300);
      if (name === "sample") args[0] = draw() < 0.9 ? 0.05 + draw() : args[0];
      if (name === "tick" || name === "replay") args[Number(name === "replay")] = below(40);
      if (name === "step" || name === "stepFor")
        args[0] = draw() < 0.7 ? below(30) : Math.min(Number(typeof args[0] === "number" ? args[0] : NaN), 50);
      try {
        const descriptor = Object.getOwnPropertyDescriptor(
          target === Scenario ? Scenario : Object.getPrototypeOf(target),
          name,
        );
        const made = descriptor?.get ? descriptor.get.call(target) : target[name](...args);
        returned += 1;
        if (
          made instanceof Scenario ||
          made instanceof Planner ||
          made instanceof Drive ||
          made instanceof Neighbours
        ) {
          if (handles.length > standing + 8) handles.splice(standing + below(8), 1)[0].free();
          handles.push(made);
        }
      } catch (error) {
        assert.ok(
          error instanceof PlanariumError,
          `call ${call}, ${name}: ${error instanceof Error ? error.stack : String(error)}`,
        );
        assert.match(error.code, /^[a-z]+(-[a-z]+)*$/);
        assert.notEqual(error.code, "internal", `call ${call}, ${name}: ${error.message}`);
        assert.ok(error.pointer === "" || error.pointer.startsWith("/"), error.pointer);
        codes.set(error.code, (codes.get(error.code) ?? 0) + 1);
      }
    }
    assert.ok(returned > CALLS / 12, `${returned} calls returned`);
    for (const code of ["wrong-type", "not-finite", "out-of-range", "wrong-dimension", "freed", "invalid-json"])
      assert.ok(codes.has(code), `${code} never came up`);
    // The core is as sound as before.
    assert.equal(
      finish(Scenario.parse(disc).planner({ seed: 5 })).fingerprint(),
      finish(Scenario.parse(disc).planner({ seed: 5 })).fingerprint(),
    );
  });
}
