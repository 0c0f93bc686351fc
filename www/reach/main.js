/**
 * The page of the arm: wiring. It makes the bench, its figures and its controls, and lets them know of each other.
 *
 * What tests may rely on, beside what room.js says:
 * - `body` carries `data-scene` (an id of scenes.js, or "file"), `data-mode`, and `data-q`, the pose;
 * - `#stage` carries `data-free`, `data-reached` ("false" while the tip is wanted where it cannot be), `data-singular`,
 *   and `data-cells` ("true" once the square shows its obstacles);
 * - `#between` carries `data-hit`: the part of the way at which it is first refused, or "none".
 */
import * as library from "planarium";
import { write } from "../planner/counters.js";
import { byId, make } from "../app/dom.js";
import { watchFiles } from "../app/drop.js";
import { Gallery, SIDE } from "../widgets/gallery.js";
import { loadCore } from "../app/resources.js";
import { Asker } from "../room/ask.js";
import { Link } from "../room/link.js";
import { Room } from "../room/room.js";
import { Sheet } from "../room/sheet.js";
import { drawThumbnail } from "../draw/thumbnail.js";
import { Axes } from "./axes.js";
import { Bench, documentOf } from "./bench.js";
import { Between } from "./between.js";
import { Hand } from "./hand.js";
import { isNearlySingular } from "./jacobian.js";
import { showLock } from "./lock.js";
import { ArmPanel } from "./panel.js";
import { SCENES } from "./scenes.js";
import { SolvingPicture } from "./solving-picture.js";
import { Solving } from "./solving.js";
import { Square } from "./square.js";
import { putState, stateOf, stateRule } from "./state.js";
import { showTake } from "./take.js";
import { num, pointText, sentenceOf, summaryOf, touchingText } from "./words.js";
import { Workspace } from "./workspace.js";

/** @import { Change } from "./bench.js" */
/** @import { Mode, Point } from "./types.js" */
/** @import { Commands } from "./worker.js" */

/** Cells a side of the picture of the configuration space: at once, and finely. */
const CELLS = { rough: 64, fine: 360 };

/** @type {[Mode, string][]} */
const MODES = [["hand", "By hand"], ["between", "From A to B"], ["solve", "Inverse kinematics"]];

/** By how much of its reach another pose must come nearer for this one to be called stuck. */
const STUCK = 1e-3;

const room = new Room();
/** The sentence that was announced last. */
let said = "";
/** Is the worker at a picture? */
let asking = false;

await room.open(async () => {
  const core = await loadCore();
  await library.default(core);
  const asker = /** @type {Asker<Commands>} */ (new Asker("reach/worker.js", (error) => room.fail(error)));
  void asker.start(core).catch((error) => room.fail(error));

  const bench = new Bench(room, library);
  const stage = byId("stage", HTMLElement);
  const workspace = new Workspace(bench);
  const square = new Square(bench);
  const axes = new Axes(bench);
  const sheets = {
    workspace: new Sheet(room, stage, { id: "workspace", kind: "workspace", caption: "Workspace", note: "the arm\u2019s world" }, workspace),
    square: new Sheet(room, stage, { id: "cspace", kind: "cspace", caption: "Configuration space", note: "each point is a pose: its two angles" }, square),
    axes: new Sheet(room, stage, { id: "axes", kind: "axes", caption: "Configuration", note: "an axis for each joint" }, axes),
  };
  const all = Object.values(sheets);
  new ArmPanel(bench);
  new Between(bench, stage);
  const solving = new Solving(bench, library);
  const picture = new SolvingPicture(solving);
  workspace.overlay = picture;
  square.overlay = (brush, on) => picture.onSquare(brush, on);
  axes.overlay = (brush, on) => picture.onAxes(brush, on);
  showLock(bench, () => {
    if (bench.mode === "solve") solving.begin();
    else pull(bench.arm.tip);
  });
  const hand = new Hand(bench, { pull, aim: (target) => {
    bench.target = target;
    solving.begin();
  } });
  hand.listen(sheets.workspace, hand.onWorkspace(workspace));
  hand.listen(sheets.square, hand.onSquare(square));
  hand.listen(sheets.axes, hand.onAxes(axes));
  hand.listenKeys(stage);

  const modes = MODES.map(([mode, title]) => {
    const button = make("button", { type: "button", id: `mode-${mode}` }, title);
    button.addEventListener("click", () => bench.turnTo(mode));
    return { mode, button };
  });
  byId("modes", HTMLElement).append(...modes.map(({ button }) => button));
  const gallery = new Gallery(/** @type {any[]} */ (SCENES), ({ id }) => {
    const entry = SCENES.find((one) => one.id === id);
    if (!entry) return;
    room.notice.hide();
    bench.openEntry(entry);
    if (bench.mode === "between") bench.goTo(0);
  });
  watchFiles((name, bytes) => {
    try {
      bench.openDocument(new TextDecoder().decode(bytes));
      room.notice.hide();
      if (bench.mode === "between") bench.goTo(0);
    } catch (error) {
      room.fail(error, `${name} is not a scenario that can be shown.`);
    }
  }, (name, error) => room.fail(error, `${name} could not be read.`));
  showTake(room, bench, all);
  const link = new Link(room, stateRule, () => stateOf(bench, solving.told), (state) => {
    if (state) putState(bench, solving, state);
    else if (!bench.now) bench.openEntry(SCENES[0]);
    room.notice.hide();
  }, "this arm, its pose, and what is asked of it");

  bench.onChange(show);
  room.recover = () => void library.default().then(() => bench.change(bench.arm.document)).catch((error) => room.fail(error));
  room.onDress(() => {
    for (const sheet of all) sheet.redraw();
    thumbnails();
  });
  await link.obey();
  thumbnails();

  /** The tip follows a wish, as near as it gets; where that is not there, what is the nearest point at all? @param {Point} wanted */
  function pull(wanted) {
    const { arm, lock } = bench;
    const orientation = lock ?? undefined;
    const { configuration, point, distance, reached } = arm.scenario.follow(arm.q, wanted, orientation);
    const nearest = reached ? null : arm.scenario.nearestReachable(wanted, orientation);
    const isStuck = nearest !== null && nearest.distance < distance - STUCK * arm.reach;
    bench.pose(configuration, { wanted, point: isStuck ? point : nearest?.point ?? point, distance: isStuck ? distance : nearest?.distance ?? distance, reached, isStuck });
  }

  /** @param {Change} change */
  function show(change) {
    const { arm, mode, entry, pull } = bench;
    const { dataset } = document.body;
    const isSquare = arm.dimension === 2;
    Object.assign(dataset, { scene: entry?.id ?? "file", mode, q: [...arm.q].join() });
    sheets.square.show(isSquare);
    sheets.axes.show(!isSquare);
    for (const sheet of all) {
      if (change === "arm") sheet.redraw();
      else sheet.refresh();
    }
    if (change === "arm") {
      gallery.mark(entry?.id ?? null);
      if (isSquare) paintCells();
    }
    for (const { mode: own, button } of modes) button.setAttribute("aria-pressed", String(own === mode));
    for (const element of document.querySelectorAll("[data-mode]:not(body)")) if (element instanceof HTMLElement) element.hidden = element.dataset.mode !== mode;
    const { text, isBad } = mode === "solve" && solving.said ? solving.said : sentenceOf(bench);
    const story = byId("story", HTMLElement);
    write(story, text);
    story.dataset.tone = isBad ? "bad" : "";
    const { major, minor, manipulability } = arm.ellipse;
    const touching = touchingText(bench);
    write(byId("where", HTMLElement), `${arm.document.title ?? arm.document.name} \u00b7 ${arm.dimension} ${arm.dimension === 1 ? "link" : "links"}`);
    write(byId("fact-tip", HTMLElement), `${pointText(arm.tip)} m`);
    write(byId("fact-orientation", HTMLElement), `${num(arm.orientation)} rad`);
    write(byId("fact-manipulability", HTMLElement), `${num(manipulability, 3)} m\u00b2`);
    write(byId("fact-roundness", HTMLElement), num(major > 0 ? minor / major : 0));
    write(byId("fact-touching", HTMLElement), touching || "nothing");
    const touches = byId("fact-touching", HTMLElement).parentElement;
    if (touches) touches.dataset.free = String(arm.check.free);
    Object.assign(stage.dataset, { free: String(arm.check.free), reached: String(pull?.reached ?? true), singular: String(isNearlySingular(arm.ellipse)) });
    if (mode === "between") byId("between", HTMLElement).dataset.hit = String(bench.way.hit ?? "none");
    const summary = summaryOf(bench);
    for (const sheet of all) sheet.describe(`${sheet.caption.textContent}: ${summary}`);
    // What changes with each iterate is not read out.
    if (said !== text && !solving.transport.isPlaying) room.announcer.say(text);
    said = text;
  }

  /** The obstacles of the square: roughly at once, finely by the worker. */
  function paintCells() {
    const { arm } = bench;
    stage.dataset.cells = "false";
    square.take(arm.scenario.cspace({ width: CELLS.rough, height: CELLS.rough }), CELLS.rough);
    if (asking) return;
    asking = true;
    const { version } = arm;
    void room.await(asker.ask("cspace", arm.document, CELLS.fine)).then((cells) => {
      asking = false;
      if (bench.arm.dimension !== 2) return;
      if (bench.arm.version !== version) {
        // Another arm by now: what was asked for is of no use.
        paintCells();
        return;
      }
      if (!cells) return;
      square.take(cells, CELLS.fine);
      stage.dataset.cells = "true";
      sheets.square.redraw();
    });
  }

  /** Small pictures of the scenes, each with A and B. */
  function thumbnails() {
    const { look } = room;
    for (const entry of SCENES) {
      const scenario = library.Scenario.parse(documentOf(entry));
      gallery.draw(entry.id, drawThumbnail(scenario, SIDE, look));
      scenario.free();
    }
  }
});

