/** What the editor does to documents: parts of obstacles, bounds, robots of every type, new scenes. No page is needed. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import { coreOf, encloses, middleOf, rectangleBetween } from "../../www/domain/obstacles.js";
import { gripAt, gripsOf, withEdges } from "../../www/planner/editor/bounds.js";
import { emptyScene } from "../../www/planner/editor/new-scene.js";
import { cut, filled, middle, moved, partText, placeOf, pointsOf, withPoint } from "../../www/planner/editor/parts.js";
import {
  TYPES,
  boxed,
  footprintOf,
  linked,
  sized,
  withArm,
  withMargin,
  withType,
} from "../../www/planner/editor/robots.js";
import { distanceToShape } from "../../www/planner/stage/grip.js";
import { near } from "./editing.mjs";

/** @typedef {import("../../www/domain/types.js").Obstacle} Obstacle */
/** @typedef {import("../../www/domain/types.js").Point} Point */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

/** @param {number} low @param {number} high */
const square = (low, high) => rectangleBetween([low, low], [high, high]).vertices;

/** @type {Extract<Obstacle, { type: "polygon" }>} */
const ROOM = { type: "polygon", vertices: square(0, 4), holes: [square(1, 2), square(2.5, 3.5)] };
/** @type {Extract<Obstacle, { type: "wall" }>} */
const WALL = {
  type: "wall",
  points: [
    [0, 0],
    [2, 0],
    [2, 2],
  ],
  width: 0.2,
};

test("a point in a hole or in a closed wall is outside, and distances count from every line", () => {
  for (const [x, y, inside, distance] of /** @type {[number, number, boolean, number][]} */ ([
    [0.5, 0.5, true, 0],
    [1.5, 1.4, false, 0.4],
    [3, 3.2, false, 0.3],
    [5, 2, false, 1],
    [2.25, 3, true, 0],
  ])) {
    assert.equal(encloses(ROOM, x, y), inside, `${x}, ${y}`);
    near(distanceToShape(ROOM, x, y), distance, 1e-12);
  }
  near(distanceToShape(WALL, 1, 0.5), 0.4, 1e-12);
  near(distanceToShape(WALL, 0.5, 1), 0.9, 1e-12);
  near(distanceToShape({ ...WALL, closed: true }, 0.5, 1), Math.SQRT1_2 / 2 - 0.1, 1e-12);
  near(distanceToShape(WALL, 2.05, 1), -0.05, 1e-12);
  assert.equal(coreOf({ ...WALL, closed: true }).segments.length, 3);
  assert.deepEqual(middleOf(WALL), [1, 0], "a wall has its name on it");
});

test("parts are the vertices of the outline, then those of the holes, or the points of a wall", () => {
  assert.equal(pointsOf(ROOM).length, 12);
  assert.deepEqual(
    [3, 4, 11].map((part) => partText(ROOM, part)),
    ["vertex 3", "hole 0, vertex 0", "hole 1, vertex 3"],
  );
  assert.equal(placeOf(ROOM, 12), null);
  assert.equal(partText(WALL, 1), "point 1");
  const dragged = withPoint(ROOM, 5, [2.2, 1]);
  assert.ok(dragged.type === "polygon");
  assert.deepEqual(dragged.holes?.[0][1], [2.2, 1]);
  assert.deepEqual([dragged.vertices, dragged.holes?.[1]], [ROOM.vertices, ROOM.holes?.[1]]);
  // After the last vertex of a line the new one belongs to that line.
  for (const [part, rings] of /** @type {[number, number[]][]} */ ([
    [4, [5, 4, 4]],
    [8, [4, 5, 4]],
    [12, [4, 4, 5]],
  ])) {
    const more = withPoint(ROOM, part, [9, 9], true);
    assert.ok(more.type === "polygon");
    assert.deepEqual(
      [more.vertices, ...(more.holes ?? [])].map(({ length }) => length),
      rings,
    );
    assert.deepEqual(pointsOf(more)[part], [9, 9]);
  }
  const first = withPoint(WALL, 0, [-1, 0], true);
  assert.ok(first.type === "wall");
  assert.deepEqual(first.points[0], [-1, 0]);
  assert.deepEqual(moved(ROOM, 1, 0, 0.1), {
    type: "polygon",
    vertices: ROOM.vertices.map(([x, y]) => [x + 1, y]),
    holes: ROOM.holes?.map((ring) => ring.map(([x, y]) => [x + 1, y])),
  });
});

test("an open wall goes on beyond its end, a closed one has an edge there", () => {
  const end = placeOf(WALL, 2) ?? assert.fail();
  assert.deepEqual(middle(end), [2, 3]);
  const ring = placeOf({ ...WALL, closed: true }, 2) ?? assert.fail();
  assert.deepEqual(middle(ring), [1, 1]);
});

test("a hole is filled with its last vertices, or at once; the outline is left to the core", () => {
  const triangle = withPoint(ROOM, 4, null);
  const gone = withPoint(triangle, 4, null);
  assert.ok(gone.type === "polygon");
  assert.deepEqual(gone.holes, [ROOM.holes?.[1]]);
  assert.deepEqual(filled(filled(ROOM, 4), 4), { type: "polygon", vertices: ROOM.vertices });
  assert.equal(filled(ROOM, 0), ROOM);
});

test("a polygon is cut out of the one around it; what lies in its own holes remains", () => {
  /** @type {Obstacle} */
  const outer = { type: "polygon", vertices: square(-1, 5) };
  const disc = /** @type {Obstacle} */ ({ type: "disc", center: [9, 9], radius: 1 });
  const made = cut([ROOM, disc, outer], 0);
  assert.deepEqual(made, {
    obstacles: [
      disc,
      { type: "polygon", vertices: outer.vertices, holes: [ROOM.vertices] },
      ...(ROOM.holes ?? []).map((vertices) => ({ type: "polygon", vertices })),
    ],
    index: 1,
    part: 4,
  });
  assert.equal(cut([outer, disc, ROOM], 2)?.index, 0);
  assert.equal(cut([ROOM, outer], 1), null, "nothing is around it");
  assert.equal(cut([ROOM, disc], 1), null, "a disc is no hole");
});

test("edges of the bounds are dragged alone, or two at a corner", () => {
  const bounds = { min: /** @type {Point} */ ([0, 0]), max: /** @type {Point} */ ([4, 2]) };
  assert.deepEqual(gripAt(bounds, [4.05, 1], 0.1), { edges: [2], at: [4, 1] });
  assert.deepEqual(gripAt(bounds, [0.05, 1.95], 0.1), { edges: [0, 3], at: [0, 2] });
  assert.equal(gripAt(bounds, [2, 1], 0.1), null);
  assert.equal(gripAt(bounds, [4, 9], 0.1), null);
  assert.deepEqual(gripsOf(bounds)[5], { edges: [1, 2], at: [4, 0] });
  const { world } = withEdges(emptyScene("disc"), [-1, -2, 3, 4]);
  assert.deepEqual(world.bounds, { min: [-1, -2], max: [3, 4] });
  assert.equal("bounds" in withEdges(emptyScene("arm"), null).world, false);
});

/** Reads a document and does something with it. @template T @param {ScenarioDocument} document @param {(open: { document: ScenarioDocument, scenario: Scenario }) => T} act */
function withOpen(document, act) {
  const scenario = Scenario.parse(document);
  try {
    return act({ document: scenario.document(), scenario });
  } finally {
    scenario.free();
  }
}

test("the core accepts every new scene, its start and goal are free, and every robot becomes every other", () => {
  for (const [from] of TYPES)
    withOpen(emptyScene(from), (open) => {
      const [{ start, goal = [] }] = open.document.queries;
      for (const pose of [start, goal]) assert.ok(open.scenario.check(pose).free, from);
      for (const [to] of TYPES) {
        if (to === from) continue;
        const { documents, text } = withType(open, to, 10, 0.001);
        withOpen(documents[0], ({ document, scenario }) => {
          assert.equal(scenario.robot, to);
          const [query] = document.queries;
          if (to === "arm") {
            assert.deepEqual(
              [query.start, query.goal],
              [
                [0, 0],
                [0, 0],
              ],
            );
            assert.match(text, /joints .* are 0/);
            return;
          }
          const place = from === "arm" ? [...open.scenario.endEffector(start)] : start;
          near(query.start[0], place[0], 0.001);
          near(query.start[1], place[1], 0.001);
          if (scenario.dimension === 3) assert.equal(query.start[2], 0);
          assert.match(text, from === "arm" ? /where the end effector was/ : /keep x and y/);
          if (to === "car") assert.ok(query.goal_tolerance, "planners by controls need it");
        });
      }
    });
});

test("a target becomes a goal, and a tolerance fits the robot", () => {
  const arm = emptyScene("arm");
  const [{ name, start }] = arm.queries;
  withOpen({ ...arm, queries: [{ name, start, target: { point: [1, 0.5] } }] }, (open) => {
    const [query] = withType(open, "rigid_body", 4, 0.001).documents[0].queries;
    assert.deepEqual([query.goal, "target" in query], [[1, 0.5, 0], false]);
  });
  withOpen(emptyScene("car"), (open) => {
    const [disc] = withType(open, "disc", 10, 0.001).documents[0].queries;
    assert.deepEqual(disc.goal_tolerance, { translation: 0.5 });
    const [body] = withType(open, "rigid_body", 10, 0.001).documents[0].queries;
    assert.deepEqual(body.goal_tolerance, { translation: 0.5, rotation: 0.3 });
  });
});

test("a shape is stretched to a length and a width, and made its box", () => {
  /** @type {{ type: "polygon", vertices: Point[] }} */
  const shape = {
    type: "polygon",
    vertices: [
      [-1, -1],
      [2, -1],
      [2, 0],
      [-1, 1],
    ],
  };
  assert.deepEqual(footprintOf(shape), { length: 3, width: 2 });
  assert.deepEqual(sized(shape, 6, 1, 0.001).vertices, [
    [-2, -0.5],
    [4, -0.5],
    [4, 0],
    [-2, 0.5],
  ]);
  assert.deepEqual(footprintOf(boxed(shape)), footprintOf(shape));
  const disc = emptyScene("disc").robot;
  assert.deepEqual(withMargin(withMargin(disc, 0.1), 0), disc);
});

test("an arm gets zeros for new links, and its configurations stay in the range of a joint", () => {
  withOpen(emptyScene("arm"), (open) => {
    const { robot } = open.document;
    assert.ok(robot.type === "arm");
    const grown = linked(robot, 4);
    const longer = withArm(open, grown.arm, grown.joints);
    assert.equal(
      withOpen(longer.document, ({ scenario }) => scenario.dimension),
      4,
    );
    assert.deepEqual(longer.document.queries[0].start, [...open.document.queries[0].start, 0, 0]);
    assert.match(longer.text, /New joints/);
    const narrow = withArm(open, robot, [{ type: "revolute", limits: [-1, 1] }, { type: "revolute" }]);
    assert.equal(narrow.document.queries[0].start[0], 1);
    assert.match(narrow.text, /moved into the range/);
    withOpen(narrow.document, ({ scenario }) => assert.deepEqual(scenario.circles(), [false, true]));
    const slides = withArm(open, robot, [{ type: "revolute" }, { type: "prismatic", range: [0, 0.5], angle: 0 }]);
    assert.equal(slides.document.queries[0].start[1], 0.5);
    withOpen(slides.document, ({ document }) => assert.equal(document.robot.type, "arm"));
  });
});
