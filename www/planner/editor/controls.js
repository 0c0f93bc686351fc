/**
 * The editor's controls: tools, undo and redo, the coordinates of the selection, and keys. The editor is on while its
 * fold is open. Where the panel is below the stage, the tools are above the stage.
 */
import { Editor } from "./editor.js";
import { COMMANDS, HELP, commandOf } from "./keys.js";
import { kindOf } from "./offers.js";
import { RobotPanel } from "./robot-panel.js";
import { ScenePanel } from "./scene-panel.js";
import { SelectionPanel } from "./selection-panel.js";
import { titleOf } from "./words.js";
import { byId, make, reveal } from "../../app/dom.js";
import { json, save } from "../../app/files.js";
import { button, press } from "../../widgets/elements.js";

/** @import { App } from "../../app/app.js" */
/** @import { Session } from "./editor.js" */
/** @import { Command } from "./keys.js" */
/** @import { EditTool, Scenario, ScenarioDocument, Settings } from "../../domain/types.js" */
/** @import { Placed } from "../stage/placed.js" */
/** @typedef {{ scene?: string, options?: Settings, document?: object, pace?: number }} Scene   a part of the page's state */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {Session} session
 * @property {boolean} calm   with reduced motion
 * @property {Scene} record
 * @property {{ name: string, document: ScenarioDocument } | null} facts
 * @property {{ pace?: number } | null} entry   the built-in scene
 * @property {(patch: Scene) => void} change
 * @property {(patch: Scene, how: { play: boolean }, opened: Opened) => unknown} apply
 * @property {(action: () => void) => void} act
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: { isEditing: boolean }) => void) => void} onState
 */
/**
 * @typedef {object} Opened   a scenario to put on the stage
 * @property {Scenario} scenario
 * @property {ScenarioDocument} document
 * @property {Scenario["robot"]} robot
 * @property {number} dimension
 * @property {string[]} queries
 * @property {Placed | null} placed
 */

/** @type {[EditTool, string][]} */
const TOOLS = [
  ["select", "Select"],
  ["disc", "Disc"],
  ["rectangle", "Rectangle"],
  ["polygon", "Polygon"],
  ["wall", "Wall"],
];

export class EditorControls {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.editor = page.session.editor = new Editor(page.session, (...opened) => this.reopen(...opened));
    this.fold = byId("editor-fold", HTMLDetailsElement);
    this.host = byId("editor", HTMLElement);
    this.stage = byId("stage", HTMLElement);
    this.narrow = matchMedia("(max-width: 63.99rem)");
    /** The scene as it was opened. @type {Scene} */
    this.original = {};
    /** Its iterations a second. @type {number | undefined} */
    this.pace = undefined;
    this.changes = 0;
    this.message = "";
    this.tools = TOOLS.map(([tool, text]) => this.button(text, (editor) => editor.use(tool)));
    this.undo = this.button("Undo", COMMANDS.undo, "Control+Z");
    this.redo = this.button("Redo", COMMANDS.redo, "Control+Shift+Z");
    this.duplicate = this.button("Duplicate", COMMANDS.duplicate, "D");
    this.remove = this.button("Delete", COMMANDS.remove, "Delete");
    this.bar = make(
      "div",
      { className: "tools-bar", id: "edit-tools", role: "toolbar", ariaLabel: "Editing" },
      make("div", { className: "segments" }, ...this.tools),
      this.undo,
      this.redo,
      this.duplicate,
      this.remove,
    );
    const act = (/** @type {Command} */ command) => this.act(command);
    this.selection = new SelectionPanel(this.editor, act, (...button) => this.button(...button));
    this.robot = new RobotPanel(this.editor, act);
    this.scene = new ScenePanel(this.editor, act);
    const saveButton = button("edit-save", "Save JSON", () => {
      const { facts } = page;
      if (facts) save(json(facts.document), `${facts.name}.json`);
    });
    this.revert = this.button("Revert", (editor) => editor.revert());
    this.revert.title = "Restores the scene as opened; Undo restores your edits.";
    const keys = make("details", {}, make("summary", {}, "Editing keys"), make("p", { className: "hint" }, HELP));
    this.host.append(
      this.bar,
      ...this.selection.elements,
      this.robot.element,
      this.scene.element,
      make("div", { className: "parts" }, saveButton, this.revert),
      keys,
    );
    this.fold.addEventListener("toggle", () => this.turn());
    this.narrow.addEventListener("change", () => this.place());
    // Posing the robot by hand takes the pointer.
    byId("your-turn", HTMLButtonElement).addEventListener("click", () => {
      this.fold.open = false;
    });
    for (const element of [this.stage, this.bar]) element.addEventListener("keydown", (event) => this.key(event));
    page.onOpen(() => {
      if (this.editor.isReopening) return;
      const { scene, options, document, pace } = page.record;
      this.original = { scene, options, document, pace };
      this.pace = pace ?? page.entry?.pace;
    });
    page.onState(({ isEditing }) => {
      if (isEditing) this.show(this.editor);
    });
    if (this.fold.open) this.turn();
  }

  /** Opens the editor and scrolls to it, or closes it. */
  toggle() {
    if (this.fold.open) {
      this.fold.open = false;
      return;
    }
    reveal(this.fold);
    this.place();
    (this.narrow.matches ? byId("story", HTMLElement) : this.fold).scrollIntoView({
      block: "start",
      behavior: this.page.calm ? "auto" : "smooth",
    });
  }

  /** @param {Command} command @param {KeyboardEvent} [event] */
  act(command, event) {
    this.page.act(() => command(this.editor, event));
  }

  /** @param {string} text @param {Command} command @param {string} [key] */
  button(text, command, key) {
    return make("button", { type: "button", ariaKeyShortcuts: key ?? null, onclick: () => this.act(command) }, text);
  }

  /** Switches the editor on or off with its fold. */
  turn() {
    const on = this.fold.open;
    this.act((editor) => editor.turn(on));
    this.stage.classList.toggle("editing", on);
    press(byId("edit", HTMLElement), on);
    this.place();
  }

  /** Moves the tools above the stage or into the panel. */
  place() {
    if (this.fold.open && this.narrow.matches) this.stage.before(this.bar);
    else this.host.prepend(this.bar);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const command = this.fold.open ? commandOf(event) : undefined;
    if (!command) return;
    event.preventDefault();
    this.act(command, event);
  }

  /** @param {Editor} editor */
  show(editor) {
    const { tool, announcement, reason, touching, obstacle, changes, refusal } = editor;
    const kind = kindOf(editor);
    const { undoable, redoable } = editor.history;
    const { isBusy } = editor.hand;
    Object.assign(this.host.dataset, {
      tool,
      kind,
      title: titleOf(editor),
      code: refusal?.code ?? "",
      touching,
      undo: undoable,
      redo: redoable,
      changes,
      busy: isBusy,
    });
    this.stage.dataset.tool = tool;
    this.tools.forEach((element, i) => press(element, TOOLS[i][0] === tool));
    this.undo.disabled = undoable === 0;
    this.redo.disabled = redoable === 0;
    this.duplicate.disabled = obstacle === null;
    this.remove.disabled = obstacle === null && kind !== "bounds" && !isBusy;
    this.revert.disabled = !editor.isChanged;
    this.selection.show(reason, touching);
    this.robot.show();
    this.scene.show();
    const message = reason || (touching ? `${announcement} ${touching}` : announcement);
    if (message !== this.message && !isBusy) {
      this.message = message;
      this.page.app.announcer.say(message);
    }
    if (changes !== this.changes) {
      this.changes = changes;
      this.adopt(editor.isChanged);
    }
  }

  /** Makes the edited scenario the page's, or restores the one that was opened. @param {boolean} isChanged */
  adopt(isChanged) {
    const { page, original, pace } = this;
    const { document } = this.editor;
    page.change(isChanged ? { scene: undefined, options: undefined, document: { ...document }, pace } : original);
    this.original = original;
  }

  /**
   * Puts an edited scenario on the stage whose robot has other coordinates: planners that do not serve it are replaced.
   * @param {Scenario} scenario
   * @param {ScenarioDocument} document
   * @param {Placed | null} placed
   */
  reopen(scenario, document, placed) {
    const { page, original, pace } = this;
    const isChanged = document !== this.editor.history.first;
    page.apply(
      isChanged ? { scene: undefined, options: undefined, document, pace } : original,
      { play: false },
      {
        scenario,
        document,
        robot: scenario.robot,
        dimension: scenario.dimension,
        queries: document.queries.map(({ name }) => name),
        placed,
      },
    );
  }

  /** Opens the editor with an empty scene. */
  create() {
    reveal(this.fold);
    reveal(this.scene.element);
    this.scene.element.open = true;
    this.place();
    this.scene.create();
    this.scene.element.scrollIntoView({ block: "center", behavior: this.page.calm ? "auto" : "smooth" });
  }
}
