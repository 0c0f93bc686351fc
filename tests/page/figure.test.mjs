/** A sheet draws each layer when it has to and not more: keys, logs, jumps, in Node on canvases that note what they do. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawLabels } from "../../www/draw/labels.js";
import { Sheet, drawWhole } from "../../www/draw/sheet.js";

/** @import { Brush, Drawing } from "../../www/draw/sheet.js" */
/** @import { Palette } from "../../www/app/palette.js" */

const LOOK = { palette: /** @type {Palette} */ ({}), ratio: 2, bold: 1 };
const SIZE = { width: 30, height: 20 };

/**
 * A sheet on canvases that note clearing and copying; `notes` are all of them, of all layers, in their order.
 * @param {Drawing} drawing
 * @param {boolean} [keeps]
 */
function noted(drawing, keeps = false) {
  /** @type {string[]} */
  const notes = [];
  const canvasOf = (/** @type {string} */ name) => {
    const canvas = { width: 0, height: 0, getContext: () => context };
    const nothing = () => {};
    const context = {
      canvas,
      save: nothing,
      restore: nothing,
      reset: nothing,
      setTransform: nothing,
      clearRect: () => notes.push(`${name} cleared`),
      drawImage: (/** @type {{ rows?: number }} */ image) => notes.push(`${name} pasted ${image.rows ?? ""}`.trim()),
      note: (/** @type {string} */ text) => notes.push(`${name} ${text}`),
    };
    return /** @type {OffscreenCanvas} */ (/** @type {unknown} */ (canvas));
  };
  const sheet = new Sheet(drawing, canvasOf, keeps);
  sheet.fit(SIZE, LOOK);
  /** Draws, and returns what it did. @param {Parameters<typeof sheet.draw>[0]} [share] */
  const draw = (share) => {
    notes.length = 0;
    sheet.draw(share);
    return notes.join(", ");
  };
  return { sheet, draw };
}

/** Notes on the canvas of a brush. @param {Brush} brush @param {string} text */
const note = ({ context }, text) => /** @type {any} */ (context).note(text);

test("a layer is drawn again when its key differs, one without a key when it is asked for", () => {
  const state = { scene: /** @type {unknown} */ ("one"), colour: "red" };
  const { sheet, draw } = noted({
    /** @returns {Drawing["layers"]} */
    get layers() {
      return {
        ground: { key: [state.scene, state.colour], draw: (brush) => note(brush, String(state.scene)) },
        top: { draw: (brush) => note(brush, `${brush.width}x${brush.height}`) },
      };
    },
  });
  assert.equal(sheet.caughtUp, false, "nothing is drawn yet");
  assert.equal(draw(), "ground one, top 30x20");
  assert.equal(sheet.caughtUp, true);
  assert.equal(draw(), "", "what has not changed is not drawn again");
  state.scene = "two";
  assert.equal(sheet.caughtUp, false);
  assert.equal(draw(), "ground cleared, ground two");
  state.colour = "blue";
  assert.equal(draw(), "ground cleared, ground two", "each item of a key counts");
  sheet.redraw();
  assert.equal(draw(), "top cleared, top 30x20", "a key is not overruled");
  sheet.fit({ width: 40, height: 20 }, LOOK);
  assert.match(draw(), /ground two.*top 40x20/, "in another size all is drawn");
});

test("a log is appended, cleared with another key, and drawn from 0 when it is shorter", () => {
  const state = { run: 1, edges: 3, vertices: 0, isHidden: false };
  const { sheet, draw } = noted({
    /** @returns {Drawing["layers"]} */
    get layers() {
      return {
        growth: {
          key: state.run,
          logs: state.isHidden
            ? []
            : [
                { count: state.edges, append: (brush, from, to) => note(brush, `edges ${from}-${to}`) },
                { count: state.vertices, append: (brush, from, to) => note(brush, `vertices ${from}-${to}`) },
              ],
        },
      };
    },
  });
  assert.equal(draw(), "growth edges 0-3");
  state.edges = 5;
  state.vertices = 2;
  assert.equal(sheet.caughtUp, false);
  assert.equal(draw(), "growth edges 3-5, growth vertices 0-2");
  assert.equal(sheet.rowsOf("growth"), 7);
  assert.equal(draw(), "");
  state.run = 2;
  assert.equal(draw(), "growth cleared, growth edges 0-5, growth vertices 0-2");
  state.edges = 4;
  assert.equal(draw(), "growth cleared, growth edges 0-4, growth vertices 0-2");
  state.isHidden = true;
  assert.equal(draw(), "growth cleared", "logs that are not there any more are not shown");
  state.isHidden = false;
  assert.equal(draw(), "growth edges 0-4, growth vertices 0-2");
  state.run = 3;
  state.edges = state.vertices = 0;
  assert.equal(draw(), "growth cleared");
  assert.equal(sheet.caughtUp, true);
});

test("a frame draws its share: at least a batch of each log, and all at once where rows are gone", () => {
  const state = { count: 10, gone: 0 };
  const { sheet, draw } = noted({
    /** @returns {Drawing["layers"]} */
    get layers() {
      const log = (/** @type {string} */ name) => ({
        count: state.count,
        batch: 4,
        append: (/** @type {Brush} */ brush, /** @type {number} */ from, /** @type {number} */ to) =>
          note(brush, `${name} ${from}-${to}`),
      });
      return {
        edges: { key: 1, revision: state.gone, logs: [log("e")] },
        marks: { key: 1, logs: [log("m")] },
      };
    },
  });
  assert.equal(draw({ most: 0 }), "", "no share");
  assert.equal(draw({ most: 6 }), "edges e 0-4, edges e 4-8, marks m 0-4");
  assert.equal(draw({ until: -1 }), "edges e 8-10, marks m 4-8");
  assert.equal(sheet.caughtUp, false);
  assert.equal(draw({ until: -1 }), "marks m 8-10");
  assert.equal(sheet.caughtUp, true);
  state.gone = 1;
  assert.equal(sheet.caughtUp, false);
  assert.equal(draw({ until: -1 }), "edges cleared, edges e 0-4, edges e 4-8, edges e 8-10");
  assert.equal(sheet.caughtUp, true);
});

test("a whole drawing goes onto one canvas, logs within their clips", () => {
  /** @type {string[]} */
  const seen = [];
  const context = { save: () => seen.push("("), restore: () => seen.push(")") };
  drawWhole(
    {
      layers: {
        ground: { key: 1, draw: () => seen.push("ground") },
        growth: {
          clip: () => seen.push("clip"),
          logs: [
            { count: 3, append: (_, from, to) => seen.push(`${from}-${to}`) },
            { count: 0, append: () => seen.push("nothing") },
          ],
        },
        top: { draw: () => seen.push("top") },
      },
    },
    /** @type {Brush} */ (/** @type {unknown} */ ({ context })),
  );
  assert.equal(seen.join(" "), "( ground ) ( clip 0-3 ) ( top )");
});

test("labels of marks that lie close together are apart, within the figure and off what is kept free", () => {
  /** @type {{ text: string, x: number, y: number }[]} */
  const words = [];
  let lines = 0;
  const nothing = () => {};
  const context = /** @type {CanvasRenderingContext2D} */ (
    /** @type {unknown} */ ({
      ...{
        save: nothing,
        restore: nothing,
        setLineDash: nothing,
        strokeText: nothing,
        moveTo: nothing,
        lineTo: nothing,
      },
      beginPath: nothing,
      stroke: () => lines++,
      fillText: (/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y) =>
        words.push({ text, x, y }),
    })
  );
  const area = { width: 300, height: 200, bold: 1 };
  const labels = Array.from({ length: 12 }, (_, i) => ({
    text: String(i + 1),
    x: 20 + 4 * Math.cos(i),
    y: 100 + 4 * Math.sin(i),
    colour: "blue",
  }));
  drawLabels(context, labels, LOOK.palette, area, [[20, 100, 9]]);
  assert.deepEqual(
    words.map(({ text }) => text),
    labels.map(({ text }) => text),
  );
  for (const [i, one] of words.entries()) {
    assert.ok(one.x > 4 && one.x < area.width && one.y >= 8 && one.y <= area.height - 8, `${one.text} is inside`);
    assert.ok(Math.hypot(one.x - 20, one.y - 100) > 9, `${one.text} is off the mark`);
    for (const other of words.slice(0, i))
      assert.ok(Math.abs(one.x - other.x) >= 9 || Math.abs(one.y - other.y) >= 14, `${one.text} on ${other.text}`);
  }
  assert.ok(lines > 0, "the far ones have lines to their marks");
  words.length = lines = 0;
  const [name] = labels;
  drawLabels(
    context,
    [
      { ...name, isHere: true },
      { ...name, isHere: true },
    ],
    LOOK.palette,
    area,
  );
  assert.deepEqual([words[0].x, words[0].y], [name.x, name.y], "one stays where it is to be");
  assert.ok(Math.hypot(words[1].x - name.x, words[1].y - name.y) >= 9);
  assert.equal(lines, 0);
  words.length = 0;
  drawLabels(context, labels, LOOK.palette, { width: 600, height: 400, bold: 2 });
  for (const [i, one] of words.entries())
    for (const other of words.slice(0, i))
      assert.ok(
        Math.abs(one.x - other.x) >= 18 || Math.abs(one.y - other.y) >= 28,
        "twice as large, twice as far apart",
      );
});
