/**
 * The page of nearest neighbours: wiring. It makes the desk, its figures and its controls, and lets them know of each other.
 *
 * What tests may rely on, beside what room.js says: `body` carries `data-robot` (an id of robots.js), `data-n`, `data-source`
 * ("drawn" or "file"), `data-q`, `data-k`, `data-index`, `data-metric`, and of the answer `data-found` (the neighbours' numbers, in
 * their order), `data-missed`, `data-visited`; `#neighbours` has a row for each, `#timing` says how far it is measured.
 */
import * as library from "planarium";
import { grouped, write } from "../planner/counters.js";
import { byId } from "../app/dom.js";
import { watchFiles } from "../app/drop.js";
import { Gallery, SIDE } from "../widgets/gallery.js";
import { loadCore } from "../app/resources.js";
import { Asker } from "../room/ask.js";
import { Link } from "../room/link.js";
import { Room } from "../room/room.js";
import { Sheet } from "../room/sheet.js";
import { drawThumbnail } from "../draw/thumbnail.js";
import { AnswerTable, configurationText, num, sentenceOf } from "./answer.js";
import { DRAWN, Desk } from "./desk.js";
import { Hand } from "./hand.js";
import { Panel } from "./panel.js";
import { ROBOTS } from "./robots.js";
import { Square } from "./square.js";
import { putState, stateOf, stateRule } from "./state.js";
import { showTake } from "./take.js";
import { Timing } from "./timing.js";
import { Workspace } from "./workspace.js";

/** @import { Change } from "./desk.js" */
/** @import { Commands } from "./worker.js" */

const room = new Room();
/** The sentence that was announced last. */
let said = "";

await room.open(async () => {
  const core = await loadCore();
  await library.default(core);
  const asker = /** @type {Asker<Commands>} */ (new Asker("neighbours/worker.js", (error) => room.fail(error)));
  void asker.start(core).catch((error) => room.fail(error));

  const indexes = library.neighbourIndexes();
  const desk = new Desk(room, library, asker, ROBOTS[0]);
  const stage = byId("stage", HTMLElement);
  const workspace = new Workspace(desk);
  const square = new Square(desk);
  const sheets = {
    workspace: new Sheet(room, stage, { id: "workspace", kind: "workspace", caption: "Workspace", note: "" }, workspace),
    square: new Sheet(room, stage, { id: "cspace", kind: "cspace", caption: "Configuration space", note: "each dot is a configuration; the borders meet" }, square),
  };
  const all = Object.values(sheets);
  const gallery = new Gallery(/** @type {any[]} */ (ROBOTS), ({ id }) => {
    const entry = ROBOTS.find((one) => one.id === id);
    if (entry) void desk.open(entry);
  });
  new Panel(desk, indexes);
  new AnswerTable(desk);
  const timing = new Timing(desk, indexes);
  showTake(desk, timing, all);
  const hand = new Hand(desk);
  hand.listen(sheets.workspace, hand.onWorkspace(workspace));
  hand.listen(sheets.square, hand.onSquare(square));
  hand.listenKeys(stage);
  watchFiles((name, bytes) => {
    room.notice.hide();
    void desk.read(name, bytes);
  }, (name, error) => room.fail(error, `${name} could not be read.`));
  const link = new Link(room, stateRule, () => stateOf(desk), async (state) => {
    if (state) await putState(desk, /** @type {any} */ (state), indexes.map(({ id }) => id));
    else if (desk.dimension === 0) await desk.open(ROBOTS[0]);
    room.notice.hide();
  }, "this robot, its drawn configurations, the target and the question; a list of your own is not in it");

  desk.onChange(show);
  room.recover = () => void library.default().then(() => desk.open(desk.entry, { q: [...desk.q], k: desk.k })).catch((error) => room.fail(error));
  room.onDress(() => {
    for (const sheet of all) sheet.redraw();
    thumbnails();
  });
  await link.obey();
  thumbnails();

  /** @param {Change} change */
  function show(change) {
    const { entry, count, q, k, index, given, found, missed, source } = desk;
    const isSquare = desk.isArm && desk.dimension === 2;
    const { dataset } = document.body;
    Object.assign(dataset, { robot: entry.id, n: String(count), source: typeof source === "string" ? "file" : "drawn", q: [...q].join(), k: String(k), index, metric: String(given.metric ?? "") });
    if (change === "answer") Object.assign(dataset, { found: [...found.indices].join(), missed: String(missed.length), visited: String(found.visited) });
    else delete dataset.found;
    sheets.square.show(isSquare);
    stage.classList.toggle("single", !isSquare);
    for (const sheet of all) {
      if (change === "robot" || change === "list") sheet.redraw();
      else sheet.refresh();
    }
    if (change === "robot") gallery.mark(entry.id);
    write(byId("where", HTMLElement), `${entry.title} \u00b7 ${grouped(count)} configurations`);
    write(byId("list-told", HTMLElement), typeof source === "string" ? `${source}: ${grouped(count)} configurations, in the order of the file.` : "Drawn uniformly, the same for the same seed.");
    sheets.workspace.note.textContent = count > DRAWN && entry.document.robot.type !== "disc" ? `the first ${DRAWN} of ${grouped(count)}; a dot for each ${desk.isArm ? "tip" : "middle"}` : "";
    if (change !== "answer") return;
    const text = sentenceOf(desk);
    const story = byId("story", HTMLElement);
    write(story, text);
    story.dataset.tone = missed.length > 0 ? "bad" : "";
    write(byId("fact-target", HTMLElement), configurationText(q));
    write(byId("fact-nearest", HTMLElement), found.distances.length > 0 ? num(found.distances[0]) : "\u2013");
    write(byId("fact-farthest", HTMLElement), found.distances.length > 0 ? num(found.distances[found.distances.length - 1]) : "\u2013");
    write(byId("fact-visited", HTMLElement), `${grouped(found.visited)} of ${grouped(count)}`);
    write(byId("fact-right", HTMLElement), `${found.indices.length - missed.length} of ${found.indices.length}`);
    for (const sheet of all) sheet.describe(`${sheet.caption.textContent}: the ${found.indices.length} configurations nearest to ${configurationText(q)}, of ${count}. ${text}`);
    if (said !== text) room.announcer.say(text);
    said = text;
  }

  /** Small pictures of the robots, each at its target. */
  function thumbnails() {
    const { look } = room;
    for (const { id, document, q } of ROBOTS) {
      const scenario = library.Scenario.parse({ ...document, queries: [{ name: "q", start: q, goal: q }] });
      gallery.draw(id, drawThumbnail(scenario, SIDE, look));
      scenario.free();
    }
  }
});
