/** Figures: what is drawn on the stand-in of a canvas is well-formed SVG, and lies where a canvas would draw it. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { SvgContext } from "../../www/formats/svg.js";
import { seeded } from "./seeded.mjs";
import { allOf, readXml } from "./xml.mjs";

/**
 * What is drawn, read again.
 * @param {(context: SvgContext) => void} draw
 * @param {{ background?: string, title?: string }} [options]
 */
function drawn(draw, options) {
  const context = new SvgContext(200, 100);
  draw(context);
  const root = readXml(context.toString(options));
  assert.deepEqual(
    [root.name, root.attributes.xmlns, root.attributes.viewBox],
    ["svg", "http://www.w3.org/2000/svg", "0 0 200 100"],
  );
  return root;
}

/** @param {(context: SvgContext) => void} draw */
const paths = (draw) => allOf(drawn(draw), "path").map(({ attributes }) => attributes);

/** Draws a line. @param {SvgContext} context @param {[number, number]} from @param {[number, number]} to */
function stroke(context, from, to) {
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
}

/**
 * Points along a path, some in each piece; arcs by the formulas of SVG's own appendix (from ends to centre).
 * @param {string} d @returns {[number, number][]}
 */
function pointsOf(d) {
  /** @type {[number, number][]} */
  const points = [];
  let [x, y, startX, startY] = [0, 0, 0, 0];
  for (const [, command, list] of d.matchAll(/([MLAZ])([^MLAZ]*)/g)) {
    const n = list.trim() === "" ? [] : list.trim().split(/\s+/).map(Number);
    assert.ok(n.every(Number.isFinite) && n.length === { M: 2, L: 2, A: 7, Z: 0 }[command], `${command}${list}`);
    for (const value of n) assert.equal(Math.round(value * 100) / 100, value, "rounded to a hundredth");
    const [endX, endY] = command === "Z" ? [startX, startY] : n.slice(-2);
    if (command === "M") [startX, startY] = [endX, endY];
    else if (command !== "A")
      for (let i = 0; i <= 8; i++) points.push([x + ((endX - x) * i) / 8, y + ((endY - y) * i) / 8]);
    else {
      const [rx, ry, turn, large, sweep] = n;
      assert.deepEqual([rx - ry, turn, large], [0, 0, 0]);
      const [dx, dy] = [(x - endX) / 2, (y - endY) / 2];
      const half = Math.hypot(dx, dy);
      const r = Math.max(rx, half);
      if (half === 0) {
        points.push([x, y]);
        continue;
      }
      const away = (Math.sqrt(Math.max(0, r * r - half * half)) / half) * (sweep ? -1 : 1);
      const [cx, cy] = [(x + endX) / 2 - away * dy, (y + endY) / 2 + away * dx];
      const from = Math.atan2(y - cy, x - cx);
      let angle = Math.atan2(endY - cy, endX - cx) - from;
      if (sweep && angle < 0) angle += 2 * Math.PI;
      if (!sweep && angle > 0) angle -= 2 * Math.PI;
      for (let i = 0; i <= 8; i++)
        points.push([cx + r * Math.cos(from + (angle * i) / 8), cy + r * Math.sin(from + (angle * i) / 8)]);
    }
    [x, y] = [endX, endY];
  }
  return points;
}

/** @param {string} d @param {[number, number][]} wanted @param {number} [within] */
function passes(d, wanted, within = 0.05) {
  const points = pointsOf(d);
  for (const [x, y] of wanted) {
    const nearest = Math.min(...points.map(([px, py]) => Math.hypot(px - x, py - y)));
    assert.ok(nearest <= within, `${d} stays ${nearest} away from ${x}, ${y}`);
  }
}

test("lines, rectangles and closed paths lie where they were put", () => {
  const [line, box, fill] = paths((context) => {
    context.strokeStyle = "rgb(1, 2, 3)";
    context.lineTo(10, 20.004);
    context.lineTo(30, 40.126);
    context.lineTo(50, 60);
    context.closePath();
    context.stroke();
    context.lineWidth = 2.5;
    context.strokeRect(1, 2, 30, 40);
    context.fillStyle = "#abc";
    context.fillRect(5, 6, 7, 8);
  });
  assert.equal(line.d, "M10 20L30 40.13L50 60Z", "a line to is a move where no path is begun");
  assert.deepEqual([line.stroke, line.fill, line["stroke-width"]], ["rgb(1, 2, 3)", "none", undefined]);
  assert.deepEqual([box.d, box["stroke-width"]], ["M1 2L31 2L31 42L1 42Z", "2.5"]);
  assert.deepEqual([fill.d, fill.fill, fill.stroke], ["M5 6L12 6L12 14L5 14Z", "#abc", undefined]);
});

test("arcs go round as on a canvas: whole circles, both directions, any angles", () => {
  const random = seeded(10);
  /** @type {[number, number, boolean][]} */
  const cases = [
    [0, 2 * Math.PI, false],
    [0, 2 * Math.PI, true],
    [2 * Math.PI, 0, true],
    [2 * Math.PI, 0, false],
    [1, 1 + 2 * Math.PI, false],
    [0, 40, false],
    [40, 0, true],
    [0, Math.PI, false],
    [0, Math.PI, true],
    [Math.PI / 2, -Math.PI / 2, false],
    [Math.PI / 2, -Math.PI / 2, true],
    [0, 0.01, false],
    [0, 0.01, true],
    [-9, 4, false],
    [4, -9, false],
    [3, 3, false],
    ...Array.from(
      { length: 60 },
      () =>
        /** @type {[number, number, boolean]} */ ([10 * random.next() - 5, 10 * random.next() - 5, random.chance(0.5)]),
    ),
  ];
  for (const [from, to, back] of cases) {
    // The angle swept, by the definition of the canvas: at most a turn, and in the direction asked for.
    const forward = back ? from - to : to - from;
    const swept =
      forward >= 2 * Math.PI
        ? 2 * Math.PI
        : ((forward % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI) || (forward === 0 ? 0 : 2 * Math.PI);
    const [{ d }] = paths((context) => {
      context.beginPath();
      context.arc(90, 50, 40, from, to, back);
      context.stroke();
    });
    const at = (/** @type {number} */ share) => from + (back ? -1 : 1) * swept * share;
    const wanted = Array.from(
      { length: 25 },
      (_, i) => /** @type {[number, number]} */ ([90 + 40 * Math.cos(at(i / 24)), 50 + 40 * Math.sin(at(i / 24))]),
    );
    passes(d, wanted);
    const points = pointsOf(d);
    for (const [x, y] of points)
      assert.ok(
        Math.abs(Math.hypot(x - 90, y - 50) - 40) < 0.05 || Math.hypot(x - wanted[0][0], y - wanted[0][1]) < 0.05,
        `${from} to ${to}`,
      );
    // It is no longer than it should be either.
    let length = 0;
    for (let i = 1; i < points.length; i++)
      length += Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
    assert.ok(Math.abs(length - 40 * swept) < 1.7, `${from} to ${to} ${back}: ${length} for ${40 * swept}`);
  }
});

test("an arc is connected to the path by a line, and a capsule is one outline", () => {
  const [{ d }] = paths((context) => {
    context.beginPath();
    context.arc(20, 50, 10, Math.PI / 2, -Math.PI / 2);
    context.arc(80, 50, 10, -Math.PI / 2, Math.PI / 2);
    context.closePath();
    context.fill();
  });
  passes(
    d,
    [
      [10, 50],
      [90, 50],
      [20, 40],
      [80, 40],
      [50, 40],
      [50, 60],
      [80, 60],
    ],
    4,
  );
  assert.equal(d.match(/M/g)?.length, 1);
});

test("transforms turn and shift; save and restore keep them and every style", () => {
  const [first, second] = paths((context) => {
    context.save();
    context.translate(100, 50);
    context.rotate(Math.PI / 2);
    context.translate(10, 0);
    context.lineWidth = 3;
    context.globalAlpha = 0.5;
    context.setLineDash([1, 2]);
    context.lineCap = "round";
    stroke(context, [0, 0], [5, 0]);
    context.restore();
    stroke(context, [0, 0], [5, 0]);
    context.restore();
  });
  assert.equal(first.d, "M100 60L100 65");
  assert.deepEqual(
    [first["stroke-width"], first["stroke-opacity"], first["stroke-dasharray"], first["stroke-linecap"]],
    ["3", "0.5", "1 2", "round"],
  );
  assert.deepEqual(
    [second.d, second["stroke-width"], second["stroke-opacity"], second["stroke-dasharray"], second["stroke-linecap"]],
    ["M0 0L5 0", undefined, undefined, undefined, undefined],
  );
});

test("strokes of one style become one element, unless something shows through", () => {
  const strokes = (/** @type {string} */ colour, /** @type {number} */ alpha) =>
    paths((context) => {
      context.strokeStyle = colour;
      context.globalAlpha = alpha;
      for (let i = 0; i < 5; i++) {
        stroke(context, [i, 0], [i, 9]);
      }
    });
  assert.deepEqual(
    strokes("#123456", 1).map(({ d }) => d),
    ["M0 0L0 9M1 0L1 9M2 0L2 9M3 0L3 9M4 0L4 9"],
  );
  assert.equal(strokes("rgb(1, 2, 3)", 1).length, 1);
  assert.equal(strokes("oklch(0.5 0.1 20)", 1).length, 1);
  assert.equal(strokes("#123456", 0.99).length, 5);
  for (const colour of ["rgba(1, 2, 3, 0.5)", "rgb(1 2 3 / 0.5)", "#12345680", "#1238", "hsla(9, 9%, 9%, 0.5)"])
    assert.equal(strokes(colour, 1).length, 5, colour);
  assert.deepEqual(
    [strokes("rgba(1, 2, 3, 0.5)", 0.5)[0].stroke, strokes("rgba(1, 2, 3, 0.5)", 0.5)[0]["stroke-opacity"]],
    ["rgb(1, 2, 3)", "0.25"],
  );
  assert.equal(strokes("#123456", 0)[0]["stroke-opacity"], "0", "what cannot be seen stays so");
  const mixed = paths((context) => {
    for (const colour of ["red", "blue", "red"]) {
      context.strokeStyle = colour;
      stroke(context, [0, 0], [9, 9]);
    }
  });
  assert.deepEqual(
    mixed.map(({ stroke }) => stroke),
    ["red", "blue", "red"],
    "order is kept",
  );
});

test("fills stay apart, so that none cuts a hole into another", () => {
  const fills = paths((context) => {
    for (const back of [false, true]) {
      context.beginPath();
      context.arc(50, 50, 20, 0, 2 * Math.PI, back);
      context.fill();
    }
  });
  assert.equal(fills.length, 2);
});

test("clips nest, end with restore, and hold for what is drawn within", () => {
  const context = new SvgContext(200, 100);
  const dot = (/** @type {number} */ x) => context.fillRect(x, 0, 1, 1);
  const within = (/** @type {number} */ x) => {
    context.beginPath();
    context.rect(x, 0, 50, 50);
    context.clip();
  };
  dot(1);
  context.save();
  within(10);
  dot(2);
  context.save();
  within(20);
  dot(3);
  context.restore();
  dot(4);
  context.restore();
  dot(5);
  context.save();
  within(10);
  dot(6);
  context.restore();
  const root = readXml(context.toString());
  const clips = root.children.filter((child) => typeof child !== "string").filter(({ name }) => name === "clipPath");
  assert.equal(clips.length, 2, "a clip that is made again is the same");
  const [outer, inner] = clips;
  assert.deepEqual(
    [outer.attributes["clip-path"], inner.attributes["clip-path"]],
    [undefined, `url(#${outer.attributes.id})`],
  );
  const [shape] = inner.children;
  assert.ok(typeof shape !== "string");
  assert.equal(shape.attributes.d, "M20 0L70 0L70 50L20 50Z");
  const used = allOf(root, "path").map(({ attributes }) => attributes["clip-path"]);
  assert.deepEqual(used, [
    undefined,
    `url(#${outer.attributes.id})`,
    `url(#${inner.attributes.id})`,
    `url(#${outer.attributes.id})`,
    undefined,
    `url(#${outer.attributes.id})`,
  ]);
});

test("a pattern is stripes, the same ones once", () => {
  const root = drawn((context) => {
    for (const colour of ["red", "blue", "red"]) {
      context.fillStyle = { colour };
      context.globalAlpha = 0.55;
      context.fillRect(0, 0, 9, 9);
    }
  });
  const patterns = root.children.filter((child) => typeof child !== "string").filter(({ name }) => name === "pattern");
  assert.deepEqual(
    patterns.map(({ attributes, children: [line] }) => [
      attributes.width,
      typeof line === "string" ? "" : line.attributes.stroke,
    ]),
    [
      ["5", "red"],
      ["5", "blue"],
    ],
  );
  const fills = allOf(root, "path").map(({ attributes }) => attributes);
  assert.deepEqual(
    fills.map(({ fill }) => fill),
    [0, 1, 0].map((i) => `url(#${patterns[i].attributes.id})`),
  );
  assert.equal(fills[0]["fill-opacity"], "0.55");
});

test("words are escaped, placed and turned", () => {
  const words = "a < b & \"c\" > 'd' \u{1f916} \u03c0 \0\x07\ufffe end";
  const root = drawn(
    (context) => {
      context.font = '600 13px "Some Font", sans-serif';
      context.textAlign = "center";
      context.textBaseline = "middle";
      context.fillStyle = 'url("x")<&';
      context.fillText(words, 10, 20);
      context.textAlign = "end";
      context.textBaseline = "top";
      context.lineWidth = 4;
      context.strokeText("<b>", 10, 20);
      context.translate(50, 60);
      context.rotate(-Math.PI / 2);
      context.textAlign = "left";
      context.textBaseline = "alphabetic";
      context.fillText("joint 1", 0, 5);
    },
    { title: '<title> & "more"', background: '"><script>' },
  );
  const [filled, stroked, turned] = allOf(root, "text");
  assert.deepEqual(filled.children, ["a < b & \"c\" > 'd' \u{1f916} \u03c0  end"]);
  assert.deepEqual(
    [filled.attributes.x, filled.attributes.y, filled.attributes["text-anchor"], filled.attributes.dy],
    ["10", "20", "middle", "0.28em"],
  );
  assert.equal(filled.attributes.style, 'font:600 13px "Some Font", sans-serif');
  assert.deepEqual(
    [
      stroked.children,
      stroked.attributes["text-anchor"],
      stroked.attributes.dy,
      stroked.attributes["stroke-width"],
      stroked.attributes.fill,
    ],
    [["<b>"], "end", "0.78em", "4", "none"],
  );
  const matrix = /^matrix\((.*)\)$/.exec(turned.attributes.transform)?.[1].split(" ").map(Number) ?? [];
  assert.deepEqual(
    matrix.map((value) => Math.round(value * 1e6) / 1e6 || 0),
    [0, -1, 1, 0, 55, 60],
  );
  assert.equal(turned.attributes.x, undefined);
  assert.equal(turned.attributes["text-anchor"], undefined, "start is the default");
  const [title, ground] = root.children.filter((child) => typeof child !== "string");
  assert.deepEqual([title.name, title.children, ground.attributes.fill], ["title", ['<title> & "more"'], '"><script>']);
});

test("images are held as data", () => {
  const image = { toDataURL: () => "data:image/png;base64,AAAA" };
  const [first, second] = allOf(
    drawn((context) => {
      context.drawImage(image, 1, 2, 30, 40);
      context.globalAlpha = 0.25;
      context.translate(5, 5);
      context.drawImage(image, 1, 2, 30, 40);
    }),
    "image",
  );
  assert.deepEqual(first.attributes, {
    x: "1",
    y: "2",
    width: "30",
    height: "40",
    preserveAspectRatio: "none",
    href: "data:image/png;base64,AAAA",
  });
  assert.deepEqual([second.attributes.x, second.attributes.y, second.attributes.opacity], ["6", "7", "0.25"]);
});

test("clearing takes all away", () => {
  const root = drawn((context) => {
    context.fillRect(0, 0, 9, 9);
    context.clearRect();
    context.fillRect(1, 1, 1, 1);
  });
  assert.equal(allOf(root, "path").length, 1);
});

for (const [what, draw, wanted] of /** @type {[string, (context: SvgContext) => void, string][]} */ ([
  [
    "rectangles beside the path leave the path as it is",
    (context) => {
      context.moveTo(1, 1);
      context.fillRect(50, 50, 5, 5);
      context.lineTo(2, 2);
    },
    "M1 1L2 2",
  ],
  [
    "a path keeps the transform of when it was made",
    (context) => {
      context.save();
      context.translate(10, 0);
      context.moveTo(1, 1);
      context.restore();
      context.lineTo(1, 1);
    },
    "M11 1L1 1",
  ],
  [
    "coordinates that are not finite are ignored, as on a canvas",
    (context) => {
      context.moveTo(NaN, 0);
      context.lineTo(1, 2);
      context.lineTo(Infinity, 2);
      context.arc(NaN, 2, 3, 0, 7);
      context.arc(1, 2, NaN, 0, 7);
      context.arc(1, 2, 3, NaN, 7);
      context.rect(0, 0, NaN, 9);
      context.lineTo(3, 4);
    },
    "M1 2L3 4",
  ],
])) {
  test(what, () => {
    const drawn = paths((context) => {
      context.beginPath();
      draw(context);
      context.stroke();
    });
    assert.equal(drawn[drawn.length - 1].d, wanted);
  });
}

test("ten thousand faint edges stay a figure of a reasonable size", () => {
  const random = seeded(11);
  const context = new SvgContext(800, 600);
  context.globalAlpha = 0.42;
  context.lineCap = "round";
  const point = () => /** @type {[number, number]} */ ([800 * random.next(), 600 * random.next()]);
  for (let i = 0; i < 10000; i++) stroke(context, point(), point());
  const text = context.toString({ background: "white" });
  assert.ok(text.length < 50 * 10000, String(text.length));
  assert.equal(allOf(readXml(text), "path").length, 10000);
});
