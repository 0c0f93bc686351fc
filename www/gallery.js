/** The scenes to choose from, each with a small picture of itself. */
import { byId, make } from "./dom.js";
import { SCENES } from "./scenes.js";
import { readPalette } from "./stage/palette.js";
import { drawGhost, drawObstacles } from "./stage/shapes.js";
import { View } from "./stage/view.js";

/** @import { Scenario, SceneEntry } from "./types.js" */

/** Side of a thumbnail, CSS pixels. */
const SIDE = 84;

export class Gallery {
  /** @param {(entry: SceneEntry) => void} onChoose */
  constructor(onChoose) {
    this.element = byId("scenes", HTMLElement);
    /** @type {Map<string, { input: HTMLInputElement, canvas: HTMLCanvasElement }>} */
    this.cards = new Map();
    for (const entry of SCENES) {
      const input = make("input", { type: "radio", name: "scene", value: entry.id });
      input.addEventListener("change", () => onChoose(entry));
      const canvas = make("canvas", {});
      canvas.setAttribute("aria-hidden", "true");
      this.cards.set(entry.id, { input, canvas });
      this.element.append(make("label", { className: "card" }, input, canvas, make("span", {}, entry.title)));
    }
  }

  /** Marks the scene that is on the stage; none for a file of the reader's own. @param {string | null} id */
  mark(id) {
    for (const [name, { input }] of this.cards) input.checked = name === id;
  }

  /** Draws a scene's thumbnail. @param {string} id @param {Scenario} scenario */
  draw(id, scenario) {
    const canvas = this.cards.get(id)?.canvas;
    const context = canvas?.getContext("2d");
    if (!canvas || !context) return;
    const ratio = devicePixelRatio || 1;
    canvas.width = canvas.height = Math.round(SIDE * ratio);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const palette = readPalette(this.element);
    const view = new View(scenario.extent(), SIDE, SIDE, { left: 5, right: 5, top: 5, bottom: 5 }, false);
    const { world, queries } = scenario.document();
    drawObstacles(context, view, world.obstacles, { ...palette, "obstacle-edge": palette.obstacle });
    if (queries.length === 0) return;
    const style = { fill: 0.9, stroke: 1, dash: [], width: 1.6 };
    drawGhost(context, view, scenario.footprint(queries[0].goal), { ...style, colour: palette.goal });
    drawGhost(context, view, scenario.footprint(queries[0].start), { ...style, colour: palette.start });
  }
}
