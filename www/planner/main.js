/**
 * The page's wiring: it loads the core, starts the worker, makes the controls and lets them know of each other. Nothing is put on `window`.
 *
 * What tests may rely on:
 * - `#counters` carries `data-status` ("loading", "failed", "none", "running", "solved", "exhausted"), `data-phase`,
 *   `data-iterations`, `data-vertices`, `data-edges` of what is shown, `data-settled` ("true" while nothing moves and all is
 *   drawn), and once the newest iteration is shown and its result known `data-fingerprint` and, once solved, `data-length`.
 * - `#play` carries `data-playing`; `body` carries `data-scene` (an id of scenes.js, or "file"), and `data-complete` once no scene
 *   needs the network any more.
 * - `#notice` is hidden, or carries `data-code` and `data-pointer` of the error it shows.
 * - `#readout` carries `data-vertex` of the vertex that is pointed at, "-1" of a mere pose, and `data-free`; neither while
 *   nothing is pointed at.
 * - `#touching` carries `data-free` and names what touches what.
 * - `#editor`, while it is open, carries `data-tool`, `data-kind` and `data-title` of what is selected, `data-undo`, `data-redo`, `data-changes`,
 *   `data-busy` ("true" during a gesture), `data-code` of the last refusal and `data-touching`, which names a start or goal in collision.
 * - `#story` carries `data-tone`, "bad" where a path that was found collides.
 * - In a race each row of `#standings tbody` carries `data-status` and, at rest at the newest iteration, `data-fingerprint`.
 * - The work of each frame in which something grew is a `performance.measure` called "planarium-frame".
 */
import { watchAnnouncements } from "./announce.js";
import * as library from "planarium";
import { Counters } from "./counters.js";
import { faultOf } from "../app/fault.js";
import { byId, write } from "../app/dom.js";
import { isArray, watchFiles } from "../app/drop.js";
import { Gallery, SIDE } from "../widgets/gallery.js";
import { watchKeys } from "../app/keys.js";
import { showLegend } from "./legend.js";
import { Notice } from "../app/notice.js";
import { Panel } from "./settings/panel.js";
import { Pose } from "./pose/controls.js";
import { Projector } from "../app/projector.js";
import { showPseudocode } from "./pseudocode.js";
import { watchTheme } from "../app/theme.js";
import { watchPrint } from "./print.js";
import { watchReadout } from "./pose/readout.js";
import { Transport } from "./timeline/transport.js";
import { keepForLater } from "../app/keep-offline.js";
import { Page } from "./page.js";
import { Part } from "../app/feature.js";
import { loadCore, makeWorker } from "../app/resources.js";
import { SCENES } from "./scenes/scenes.js";
import { Sheets } from "./sheets.js";
import { connect } from "../app/worker-client.js";
import { Session, placed } from "./session.js";

/** @import { PlannerWorker } from "./worker/worker.js" */
/** @import { SceneEntry } from "../domain/types.js" */

/** Milliseconds after which the thumbnails are drawn: the stage comes first. */
const THUMBNAILS = 250;
/** And after them what scenes need besides: the page has opened by then. */
const PROVISIONS = 3000;
/** How many seeds "New seed" chooses from: six digits can be said aloud. */
const SEEDS = 1_000_000;

const counters = new Counters();
const notice = new Notice();
document.documentElement.classList.toggle("embed", new URLSearchParams(location.search).get("embed") === "1");

try {
  await start();
  keepForLater();
} catch (error) {
  counters.none("failed");
  notice.show("Planarium could not start. It needs a browser with WebAssembly and the other files of this site.", error);
}

async function start() {
  const loading = loadCore();
  const workers = /** @type {PlannerWorker} */ (connect(await makeWorker(), "planner", loading, (error) => notice.show("Something went wrong.", error)));
  const core = await loading;
  await library.default(core);
  const generators = library.generators();
  const session = new Session(library, workers, () => library.initSync(core));

  const story = byId("story", HTMLElement);
  const where = byId("where", HTMLElement);
  const turn = byId("your-turn", HTMLButtonElement);
  const stage = byId("stage", HTMLElement);
  const panel = new Panel(library.planners(), () => library.randomSeed() % SEEDS, () => page.plan(), () => page.ask());
  const page = new Page(session, panel, notice);
  const sheets = new Sheets(page);
  const pose = new Pose((at) => page.act(({ byHand }) => byHand.hold(Float64Array.from(at))));
  const gallery = new Gallery(SCENES, (entry) => void choose(entry));
  const transport = new Transport(page);
  watchKeys([stage, transport.bar], {
    " ": () => page.act(({ timeline }) => timeline.toggle()),
    ".": () => page.act(({ timeline }) => timeline.step(1)),
    ",": () => page.act(({ timeline }) => timeline.step(-1)),
    e: () => page.act(({ timeline }) => timeline.finish()),
    r: () => page.act(() => session.reset()),
    n: () => panel.reseed(),
  });
  watchFiles(openFile, (name, error) => notice.show(`${name} could not be read.`, error));
  watchTheme(() => page.setTheme());
  watchAnnouncements(page);
  showPseudocode(page);
  const options = new Part(notice, async () => (await import("./scenes/options.js")).showSceneOptions(page, generators)).inFold("make-fold");
  page.onOpen((_, entry) => { if (entry?.sliders) options.use(); });
  watchReadout(page);
  watchPrint(page);
  const projector = new Projector(() => page.setTheme());

  const race = new Part(notice, async () => new (await import("./race/race.js")).Race(page, sheets)).inFold("race-fold");
  page.needRace = () => race.get();
  new Part(notice, async () => (await import("./view.js")).watchView(page)).inFold("view-fold");
  new Part(notice, async () => (await import("./curves.js")).watchCurves(page)).inFold("curves-fold");
  new Part(notice, async () => new (await import("./editor/controls.js")).EditorControls(page)).inFold("editor-fold").byButton("edit", (editor) => editor.begin());
  const drive = new Part(notice, async () => new (await import("./driving/controls.js")).DriveControls(page));
  const lessons = new Part(notice, async () => new (await import("./lessons/lessons.js")).Lessons(page, SCENES)).inFold("lessons-fold");
  new Part(notice, async () => (await import("./export/export.js")).showTake(page)).inFold("take-fold");
  const link = new Part(notice, async () => new (await import("./link/link.js")).Link(page, SCENES, generators, projector)).byButton("link", (part) => part.copy());
  if (window.parent !== window) (await import("./embed.js")).watchParent(page);
  /** Puts on the stage what the address says, a step of a lesson or an experiment. */
  const obey = async () => (await (location.hash.startsWith("#lesson=") ? lessons : link).get()).obey(location.hash);
  addEventListener("hashchange", () => { if (location.hash) void obey(); });

  page.onOpen((facts, entry) => {
    if (!page.race?.arrange()) sheets.arrange(facts);
    pose.build(facts);
    gallery.mark(entry?.id ?? null);
  });
  page.onState((state) => {
    const lane = state.lanes[0];
    counters.show(lane, state.settled);
    showLegend(page, state);
    write(story, state.sentence);
    story.dataset.tone = state.isBad ? "bad" : "";
    turn.textContent = state.inHand ? "Watch again" : page.facts?.robot === "car" ? "Drive" : "Your turn";
    write(where, `${page.title} \u00b7 ${page.names.join(" against ")}`);
    stage.classList.toggle("in-hand", state.inHand);
    pose.reflect(state);
    sheets.look(state, page.facts);
    sheets.describe(state);
  });
  page.onOrder(() => counters.unsettle());
  page.onTheme(() => void drawThumbnails());
  turn.addEventListener("click", (event) => {
    if (page.facts?.robot === "car") {
      drive.use((controls) => controls.toggle());
      return;
    }
    if (event.detail === 0) pose.awaitFocus();
    page.act(({ byHand }) => byHand.change());
  });
  turn.disabled = false;

  page.setTheme();
  if (location.hash) await obey();
  else await page.openScene(SCENES[0]);
  setTimeout(() => void drawThumbnails(), THUMBNAILS);

  /** @param {SceneEntry} entry */
  async function choose(entry) {
    try {
      await page.openScene(entry);
    } catch (error) {
      notice.show(`The scene "${entry.title}" could not be loaded.`, error);
    }
  }

  /** A file of the reader's own. If it is refused, what is on the stage stays there. @param {string} name @param {Uint8Array<ArrayBuffer>} bytes */
  async function openFile(name, bytes) {
    try {
      if (isArray(name, bytes)) await (await import("./export/arrays.js")).openArray(page, name, bytes);
      else await page.open({ document: new TextDecoder().decode(bytes) });
    } catch (error) {
      notice.show(`${name} could not be opened.`, error);
    }
  }

  async function drawThumbnails() {
    try {
      for (const entry of SCENES) gallery.draw(entry.id, await workers.thumbnail(await page.sourceOf(entry), SIDE, page.look));
    } catch (error) {
      if (faultOf(error).code !== "internal") throw error;
      // The planners in the worker were lost with the core.
      session.fail(error);
    }
    setTimeout(() => void provide(), PROVISIONS);
  }

  /** Fetches what scenes may want once the network is gone. */
  async function provide() {
    try {
      await Promise.all([options.get(), placed()]);
      document.body.dataset.complete = "true";
    } catch {
      // there is no network already: whoever needs it asks again, and is told
    }
  }
}
