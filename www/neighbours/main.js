/**
 * The page of nearest neighbours: it makes the session, the figures and the panels.
 *
 * For tests, beside what app.js says: `body` carries `data-robot` (an id of robots.js, of a scene, or "file"),
 * `data-n`, `data-source` ("drawn" or "file"), `data-q`, `data-k`, `data-index`, `data-metric`, `data-ask` (whether
 * target and neighbours are shown), `data-weights`, and of the result `data-found` (the indices of the neighbours, in
 * their order), `data-missed` and `data-visited`.
 */
import { neighbourIndexes } from "planarium";
import { byId, grouped } from "../app/dom.js";
import { isArray } from "../app/read-files.js";
import { comparer } from "../app/once.js";
import { openRoom } from "../app/room.js";
import { Figure } from "../draw/figure.js";
import { csvFile } from "../formats/csv.js";
import { sceneDocument } from "../planner/scenes/document.js";
import { SCENES } from "../planner/scenes/scenes.js";
import { showDownloads } from "../widgets/downloads.js";
import { num, tuple } from "../widgets/format.js";
import { makeSceneGallery } from "../widgets/scene-gallery.js";
import { watchHandles } from "./handles.js";
import { showPanel } from "./panel.js";
import { DIGITS, sentenceOf, showNeighbours } from "./result.js";
import { ROBOTS, entryOf } from "./robots.js";
import { DRAWN, NeighbourSession } from "./session.js";
import { Square } from "./square.js";
import { openState, stateOf, stateRule } from "./state.js";
import { watchTiming } from "./timing.js";
import { Workspace } from "./workspace.js";

/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands } from "./commands.js" */
/** @import { State } from "./state.js" */

/** Cells a side of the obstacles in configuration space. */
const CELLS = 192;

await openRoom("neighbours", (room, /** @type {Remote<Commands>} */ worker) => {
  const { app } = room;
  const stage = byId("stage", HTMLElement);
  const indexes = neighbourIndexes();
  const session = new NeighbourSession(app, worker, ROBOTS[0]);
  const figures = {
    workspace: new Figure(app, stage, { id: "workspace", caption: "Workspace" }, new Workspace(session)),
    square: new Figure(app, stage, { id: "cspace", caption: "Configuration space" }, new Square(session)),
  };
  const all = Object.values(figures);
  const robotOf = (/** @type {string} */ id) => ROBOTS.find((entry) => entry.id === id);
  const gallery = makeSceneGallery(app, [...ROBOTS, ...SCENES], thumbnailOf, ({ id }) => void openScene(id));
  showPanel(session, indexes);
  const timingsCsv = watchTiming(session, indexes);
  showDownloads(
    app,
    all,
    { name: () => `neighbours-${session.entry.id}-${session.count}-k${session.k}`, title: () => session.entry.title },
    [
      {
        id: "csv",
        title: "Neighbours",
        format: "CSV",
        meaning: "Rank, index, distance and configuration.",
        content: neighboursCsv,
      },
      {
        id: "timings",
        title: "Timings",
        format: "CSV",
        meaning: "All measurements.",
        content: timingsCsv,
        name: () => `timings-${session.entry.id}`,
      },
    ],
  );
  watchHandles(session, stage, figures);
  const differs = comparer();
  return {
    show,
    rebuild: () =>
      session.open(session.entry, { q: session.q, k: session.k, weights: session.ownWeights, list: session.ownList }),
    rule: stateRule,
    link: {
      save: () => stateOf(session),
      spare: "list",
      contents: (isWhole) => {
        if (session.file === null) return "the scenario, the sampling, the target and the query";
        return isWhole
          ? "the scenario, your list, the target and the query"
          : "the scenario, the target and the query. Your list is too long for a link and is not included";
      },
      open: async (/** @type {State | null} */ state, signal) => {
        if (state) await openState(session, state, signal);
        else if (session.count === 0 && !session.isLoading) await session.open(ROBOTS[0]);
      },
    },
    openFile: ({ name, bytes, text }) =>
      !isArray(name, bytes) && isScenario(text) ? session.open(entryOf(text, "file")) : session.read(name, bytes),
  };

  /** @param {{ id: string }} entry */
  function thumbnailOf({ id }) {
    const robot = robotOf(id);
    return robot ? { ...robot.document, queries: [{ name: "q", start: robot.q, goal: robot.q }] } : sceneDocument(id);
  }

  /** Opens a robot of this page or a scene of the planner's. @param {string} id */
  function openScene(id) {
    return room.open(async (signal) => {
      const entry = robotOf(id) ?? entryOf(await sceneDocument(id), id);
      signal.throwIfAborted();
      await session.open(entry);
    });
  }

  function show() {
    const { entry, coordinates, count, q, k, index, given, found } = session;
    const { missed, file, scenario, isPlanar, isAsking } = session;
    const { dataset } = document.body;
    Object.assign(dataset, {
      robot: entry.id,
      n: count,
      source: file === null ? "drawn" : "file",
      q: [...q].join(),
      k,
      index,
      metric: given.metric ?? "",
      ask: isAsking,
      weights: session.weights.join(),
    });
    if (session.isFound)
      Object.assign(dataset, { found: [...found.indices].join(), missed: missed.length, visited: found.visited });
    else delete dataset.found;
    figures.square.element.hidden = !isPlanar;
    stage.classList.toggle("single", !isPlanar);
    if (differs("robot", coordinates)) {
      gallery.mark(entry.id);
      if (isPlanar) figures.square.drawing.setCells(scenario.cspace({ width: CELLS, height: CELLS }), CELLS);
    }
    for (const figure of all) figure.redraw();
    if (differs("table", found)) showNeighbours(session);
    app.write({
      where: `${entry.title} \u00b7 ${grouped(count)} configurations`,
      "list-told":
        file === null
          ? "Sampled uniformly: the same seed gives the same list."
          : `${file}: ${grouped(count)} configurations, in the order of the file.`,
    });
    figures.workspace.note.textContent =
      count > DRAWN && entry.document.robot.type !== "disc" ? `the first ${DRAWN} of ${grouped(count)}, as dots` : "";
    figures.square.note.textContent = coordinates.every(({ isCircle }) => isCircle)
      ? "a dot each; borders wrap"
      : "a dot each";
    if (count === 0 && !session.isLoading) app.say(sentenceOf(session));
    if (!session.isFound) return;
    const { length } = found.indices;
    const distanceText = (/** @type {number | undefined} */ distance) =>
      distance === undefined ? "\u2013" : num(distance, DIGITS);
    const text = sentenceOf(session);
    app.say(text, { isBad: isAsking && missed.length > 0 });
    app.write({
      "fact-target": tuple(q, DIGITS),
      "fact-nearest": distanceText(found.distances[0]),
      "fact-farthest": distanceText(found.distances[length - 1]),
      "fact-visited": `${grouped(found.visited)} of ${grouped(count)}`,
      "fact-recall": `${length - missed.length} of ${length}`,
    });
    const asked = isAsking ? `the ${length} configurations nearest to ${tuple(q, DIGITS)}, of ${count}. ` : "";
    for (const figure of all) figure.describe(`${figure.caption.textContent}: ${asked}${text}`);
  }

  function neighboursCsv() {
    const { coordinates } = session;
    const { indices, distances } = session.found;
    return csvFile(
      ["rank", "number", "distance", ...coordinates.map(({ name }) => name)],
      Array.from(indices, (i, rank) => [rank + 1, i, distances[rank], ...session.row(i)]),
    );
  }
});

/** Whether a file is a scenario, and not a list of configurations. @param {string} text */
function isScenario(text) {
  return /^\s*\{[^]*"format"\s*:/.test(text);
}
