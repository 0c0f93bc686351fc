/**
 * The page of the arm and of the body: it makes the session, the figures and the panels.
 *
 * For tests, beside what app.js says:
 * - `body` carries `data-scene` (an id that scenes.js opens, or "file"), `data-robot` ("arm" or "body"), `data-mode`,
 *   and `data-q`, the configuration;
 * - `#stage` carries `data-free`, `data-reached` ("false" while the tip cannot reach the wanted point),
 *   `data-singular`, and `data-cells` ("true" once the square shows its obstacles finely);
 * - `#between` carries `data-hit`, the part of the motion at which it first collides, or "none", and `data-missed`, how
 *   many coordinates do not end at B.
 */
import { json } from "../app/files.js";
import { byId } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { openRoom } from "../app/room.js";
import { coalesced } from "../app/work.js";
import { Figure } from "../draw/figure.js";
import { showDownloads } from "../widgets/downloads.js";
import { button, press } from "../widgets/elements.js";
import { num, tuple } from "../widgets/format.js";
import { makeSceneGallery } from "../widgets/scene-gallery.js";
import { showArmPanel } from "./arm-panel.js";
import { filmsOf } from "./films.js";
import { watchHandles } from "./handles.js";
import { IkPanel } from "./ik-panel.js";
import { isNearlySingular } from "./jacobian.js";
import { showMotionPanel } from "./motion-panel.js";
import { ParallelAxes } from "./parallel-axes.js";
import { BODIES, SCENES, sceneOf } from "./scenes.js";
import { ReachSession } from "./session.js";
import { Square } from "./square.js";
import { openState, stateOf, stateRule } from "./state.js";
import { collisionText, descriptionOf, robotText, sentenceOf } from "./words.js";
import { Workspace } from "./workspace.js";

/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands } from "./commands.js" */
/** @import { Robot } from "./robot.js" */
/** @import { Mode } from "./session.js" */
/** @import { State } from "./state.js" */

/** Cells a side of the configuration space: at once, and finely. */
const CELLS = { rough: 64, fine: 360 };

/** @type {[Mode, string][]} */
const MODES = [
  ["hand", "By hand"],
  ["between", "From A to B"],
  ["solve", "Inverse kinematics"],
];

await openRoom("reach", (room, /** @type {Remote<Commands>} */ worker) => {
  const { app } = room;
  const stage = byId("stage", HTMLElement);
  const session = new ReachSession(app);
  const ik = new IkPanel(session);
  const figures = {
    workspace: new Figure(app, stage, { id: "workspace", caption: "Workspace" }, new Workspace(session)),
    square: new Figure(app, stage, { id: "cspace", caption: "Configuration space" }, new Square(session)),
    axes: new Figure(app, stage, { id: "axes", caption: "Configuration" }, new ParallelAxes(session)),
  };
  const all = Object.values(figures);
  showArmPanel(session, () => {
    if (session.mode === "solve") ik.begin();
    else session.moveTip(session.robot.tip);
  });
  showMotionPanel(session, stage);
  watchHandles(session, stage, figures, (target) => {
    session.target = target;
    ik.begin();
  });
  byId("modes", HTMLElement).append(
    ...MODES.map(([mode, title]) => button(`mode-${mode}`, title, () => session.setMode(mode))),
  );
  const thumbnailOf = async (/** @type {string} */ id) => (await sceneOf(id)).document;
  const gallery = makeSceneGallery(
    app,
    [...SCENES, ...BODIES],
    ({ id }) => SCENES.find((own) => own.id === id)?.document ?? thumbnailOf(id),
    ({ id }) => void openScene(id),
  );
  showDownloads(
    app,
    all,
    {
      name: () => `${session.robot.document.name}-reach`,
      title: () => session.robot.document.title ?? session.robot.document.name,
    },
    [
      {
        id: "scenario",
        title: "Scenario",
        format: "JSON",
        meaning: "Robot and obstacles, with the query from A to B, and for an arm that of the target.",
        content: () => json(session.document()),
      },
    ],
    filmsOf(session, all),
  );
  session.openScene(SCENES[0]);
  const differs = comparer();
  /** Has the worker compute the obstacles; while an arm is being changed, only for its last state. */
  const showFinely = coalesced(async () => {
    const { robot } = session;
    if (robot.dimension !== 2) return;
    const cells = await app.track(worker.cspace(robot.document, CELLS.fine));
    if (session.robot !== robot || !cells) return;
    figures.square.drawing.setCells(cells, CELLS.fine);
    stage.dataset.cells = "true";
    app.requestFrame();
  });
  return {
    show,
    rebuild: () => session.changeArm(session.robot.document),
    rule: stateRule,
    link: {
      save: () => stateOf(session, ik),
      contents: "the robot, its configuration and the current mode",
      open: async (/** @type {State | null} */ state, signal) => {
        if (state) await openState(session, ik, state, signal);
      },
    },
    openFile: ({ text }) => session.open(text),
  };

  /** @param {string} id */
  function openScene(id) {
    return room.open(async (signal) => {
      const entry = await sceneOf(id);
      signal.throwIfAborted();
      session.openScene(entry);
    });
  }

  /** @param {Mode} mode */
  function showMode(mode) {
    for (const [one] of MODES) press(byId(`mode-${one}`, HTMLElement), one === mode);
    for (const element of document.querySelectorAll("main [data-mode]"))
      if (element instanceof HTMLElement) element.hidden = element.dataset.mode !== mode;
  }

  /** @param {Robot} robot */
  function showRobot(robot) {
    const [who, axis] = robot.isArm ? ["arm", "joint"] : ["body", "coordinate"];
    figures.workspace.note.textContent = `the ${who} and its obstacles`;
    figures.axes.note.textContent = `one axis per ${axis}`;
    figures.square.note.textContent = robot.slides ? "each point: two coordinates" : "each point: two joint angles";
    byId("mode-solve", HTMLElement).hidden = !robot.isArm;
    showRoughly(robot);
  }

  /** Shows the obstacles of the configuration space, roughly at once and finely later. @param {Robot} robot */
  function showRoughly(robot) {
    if (robot.dimension !== 2) return;
    stage.dataset.cells = "false";
    figures.square.drawing.setCells(robot.scenario.cspace({ width: CELLS.rough, height: CELLS.rough }), CELLS.rough);
    void showFinely();
  }

  function show() {
    const { robot, mode, entry, tipGoal } = session;
    const { major, minor, manipulability } = robot.ellipse;
    const isSquare = robot.dimension === 2;
    Object.assign(document.body.dataset, {
      scene: entry?.id ?? "file",
      robot: robot.isArm ? "arm" : "body",
      mode,
      q: [...robot.q].join(),
    });
    Object.assign(stage.dataset, {
      free: robot.check.free,
      reached: tipGoal?.reached ?? true,
      singular: isNearlySingular(robot.ellipse),
    });
    if (mode === "between")
      Object.assign(byId("between", HTMLElement).dataset, {
        hit: session.motion.hit ?? "none",
        missed: session.motion.missed.length,
      });
    figures.square.element.hidden = !isSquare;
    figures.axes.element.hidden = isSquare;
    if (differs("robot", robot)) showRobot(robot);
    if (differs("scene", entry)) gallery.mark(entry?.id ?? null);
    if (differs("mode", mode)) showMode(mode);
    for (const figure of all) figure.redraw();
    const collision = collisionText(session);
    app.write({
      where: `${robot.document.title ?? robot.document.name} \u00b7 ${robotText(robot)}`,
      "fact-tip": `${tuple(robot.tip)} m`,
      "fact-orientation": `${num(robot.orientation)} rad`,
      "fact-manipulability": `${num(manipulability, 3)} m\u00b2`,
      "fact-isotropy": num(major > 0 ? minor / major : 0),
      "fact-collision": collision || "none",
    });
    byId("fact-collision", HTMLElement).dataset.free = String(robot.check.free);
    const { text, isBad } = sentenceOf(session);
    app.say(text, { isBad, isSilent: ik.course.isPlaying });
    const description = descriptionOf(session);
    for (const figure of all) figure.describe(`${figure.caption.textContent}: ${description}`);
  }
});
