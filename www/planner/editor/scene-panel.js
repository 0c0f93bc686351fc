/** The panel of the scene: a new one with a robot of choice, and its bounds. */
import { make } from "../../app/dom.js";
import { button, row, select } from "../../widgets/elements.js";
import { withEdges } from "./bounds.js";
import { emptyScene } from "./new-scene.js";
import { TYPES } from "./robots.js";
import { rounded } from "./units.js";

/** @import { Editor } from "./editor.js" */
/** @import { Robot } from "./robots.js" */

/** The bounds of an arm that has none reach this much farther than the arm. */
const BEYOND = 1.1;

export class ScenePanel {
  /** @param {Editor} editor @param {(action: (editor: Editor) => void) => void} act */
  constructor(editor, act) {
    this.editor = editor;
    this.act = act;
    this.type = select("new-robot", "Robot of the new scene", TYPES);
    this.bounds = button("edit-bounds", "", () => this.act(() => this.frame()));
    this.element = make(
      "details",
      { id: "scene-fold" },
      make("summary", {}, "New scene and bounds"),
      row("Robot", this.type),
      make(
        "div",
        { className: "parts" },
        button("edit-new", "New scene", () => this.create()),
        this.bounds,
      ),
      make("p", { className: "hint" }, "A new scene is empty; Undo restores the one before."),
    );
  }

  show() {
    const text = this.editor.document.world.bounds ? "Select the bounds" : "Add bounds";
    if (this.bounds.textContent !== text) this.bounds.textContent = text;
  }

  /** Begins a scene without obstacles. */
  create() {
    this.act((editor) => {
      if (!editor.change(emptyScene(/** @type {Robot["type"]} */ (this.type.value)))) return;
      editor.put({ kind: "start", index: 0 });
      editor.announcement = "The scene is empty, with a start and a goal.";
    });
  }

  /** Selects the bounds; an arm without any gets some around its reach. */
  frame() {
    const { editor } = this;
    const { document, unit, shown } = editor;
    if (!document.world.bounds) {
      const { min, max } = shown.scenario.extent();
      const edges = [min, max].flatMap((corner, end) =>
        corner.map((_, i) => {
          const half = (BEYOND * (max[i] - min[i])) / 2;
          return rounded((min[i] + max[i]) / 2 + (end === 0 ? -half : half), 100 * unit);
        }),
      );
      if (!editor.change(withEdges(document, edges))) return;
    }
    editor.put({ kind: "bounds", index: 0 });
  }
}
